/* What the files of contact in a run share. */
#ifndef TINKER_CORE_CONTACT_RUN_PRIVATE_H
#define TINKER_CORE_CONTACT_RUN_PRIVATE_H

#include "numerics/roots/step-roots.h"
#include "physics/contact/contact-neighbours.h"
#include "physics/event/contact-run.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* What ends a phase of a contact when it falls below zero. */
typedef enum {
    TINKER_TRIGGER_NONE,      /* nothing of the contacts: they are asked at a start and at a break, */
    TINKER_TRIGGER_BLOW,      /* and after a blow that a block gave */
    TINKER_TRIGGER_GAP,       /* an open contact: the gap, over the plate, */
    TINKER_TRIGGER_LEAVING,   /* or of one that has just opened: the acceleration that parts it */
    TINKER_TRIGGER_NORMAL,    /* a closed one: the normal force */
    TINKER_TRIGGER_FORWARD,   /* one that sticks: mu N - T, */
    TINKER_TRIGGER_BACKWARD,  /* and mu N + T */
    TINKER_TRIGGER_SPEED,     /* one that slips: its speed along the top, */
    TINKER_TRIGGER_STARTING,  /* or of one that has just begun to, its acceleration, */
    TINKER_TRIGGER_END,       /* what is left of the top towards +x, */
    TINKER_TRIGGER_BEGINNING, /* and towards -x */
} TinkerTriggerKind;

typedef struct {
    TinkerTriggerKind kind;
    int32_t body, plate;
    int32_t closed; /* the number of a closed contact; else -1 */
    int32_t row;    /* a constraint row that holds in one direction only, in place of a plate; else -1 */
    double level;   /* what falls below it has passed 0; rounding is above it */
} TinkerTrigger;

typedef struct {
    int32_t body, plate;
    int32_t row; /* -1: a plate */
} TinkerContactPair;

/* Flights of an island that is solved exactly (contact-flight.c). */
typedef struct {
    gboolean exact;  /* it is solved so while nothing is closed */
    double ahead;    /* s: the blow that is passed falls so much later than its instant */
    double approach; /* m/s: with this speed along the normal; NAN where no such blow is passed */
    double *rebound; /* m/s: by plate, the speed along its normal that a body alone left it with, as far as that lasts;
                        else NAN. NULL where it never does */
} TinkerContactFlight;

/* What was evaluated where a step begins. */
typedef struct {
    TinkerEvaluated at; /* its time is NAN where that was not done */
    double *force, power[TINKER_BOOK_COUNT];
    double *loads;  /* by closed contact: N, normal and friction */
    gint64 changes; /* of the run, up to then */
} TinkerStepStart;

struct _TinkerContactRun {
    TinkerIslandRun *run;
    TinkerContacts *contacts;
    TinkerModel *model;
    gboolean in_plane; /* the island is stepped in the plane: contacts may be closed */
    TinkerContactFlight flight;
    gint64 changes, looks;
    double *orientation;               /* by body */
    double last_impact, passed_impact; /* s */
    gboolean warned;                   /* that the outcome depends on the law of impact; */
    gboolean warned_pins;              /* that a blow passed a pin with friction; */
    gboolean warned_share;             /* that the motion depends on how a load is shared */
    const double *given; /* by coordinate: what a blow that blocks give, and is passed now, gave; or NULL */

    /* the step in progress */
    TinkerState from;                       /* where it began; the books included */
    double projection_work, position_error; /* of the system, there */
    double hint;                            /* an event is known to come then; INFINITY */
    TinkerTrigger hint_trigger;
    double hint_slope;
    double limit;     /* of the step, but for that */
    gboolean expects; /* the hint is when a contact should close, and the step goes there for the first time */
    gboolean passed;  /* an event, since the last step */
    gboolean carried; /* the state is behind where the method's step, and dense output with it, ends */
    double size;      /* m: of what is stepped, as it starts */
    double usual;     /* s: the length of the last step that ended where its method had it end */
    /* m/s: up to here nothing can come near anything in this step, whose start was not kept; 0: it was */
    double speed_bound;
    gboolean pending; /* the state stands on it */
    TinkerTrigger pending_trigger;
    GArray *alike; /* of TinkerTrigger: contacts that reach the limit of sticking with the one that is passed */
    GArray *asked; /* of TinkerTrigger: what was passed at this instant, one behind the other */

    /* an endless sequence of events */
    double crowd_began;
    int crowd, slow_crowds; /* events since then; so many before them, one after the other, that led nowhere */

    /* the search */
    /* it is solved exactly now: its steps resolve nothing, and are limited to what its motion swings by */
    gboolean exact;
    double fastest, strongest; /* of those: m/s and m/s^2, the largest speed and acceleration so far */
    /* The method remembers its steps: one that is made again, from a start without memory, is many small ones of low
     * order, whose end is off by other errors each time. */
    gboolean remembers;
    gboolean starts_low; /* the method's first steps are of order 1 */
    int32_t degree;
    double nodes[TINKER_MOST_DEGREE + 1];
    double *plate_speed; /* by point of a support: m/s, the largest so far */
    double *end_values;  /* of triggers, at the end of the last step that had no event */
    double end_time;
    gint64 end_changes;
    GArray *near; /* of TinkerContactPair: those that a step comes close to */
    /* Of TinkerContactPair: those that opened with no speed and are not clear of each other yet. Their gap grows with
     * the second or third power of time, less than the error of a method of low order, or than rounding: what tells
     * whether they part is the acceleration. */
    GArray *leaving;
    GArray *struck;    /* of int32_t: sides of lines that corners were thrown back from, not clear of them yet */
    GArray *turns;     /* of contacts that change by turns (contact-turns.c) */
    double closed_gap; /* m: that of the step that is searched; NAN: not asked for yet */
    GArray *triggers;  /* of TinkerTrigger: those of the step */
    GArray *falling;   /* of guint: those of places that may fall to 0 in the step */
    double *values;    /* of triggers, node by node */
    gsize values_room;
    double *node_x, *node_u;         /* in the system's coordinates */
    double *node_q, *node_v;         /* of the bodies */
    double *force;                   /* accelerations, for work ... */
    double power[TINKER_BOOK_COUNT]; /* ... and powers of the books, of a look that was asked for them */
    double looked_time;              /* of the look that the forces of contacts are from ... */
    gint64 looked_evaluation;        /* ... as long as they have not been worked out again since then */
    double *force_scale;             /* by closed contact: N, the largest of the step */
    TinkerStepStart start;           /* of the step in progress */
    gsize closed_room;
    TinkerContactNeighbours neighbours;
    double pair_margin; /* m: of pairs when they were asked for last */
    int32_t *together;  /* by body: the first of those whose contacts are decided together at the event passed last */
    gboolean many;      /* so many may meet that these are told by what is near */
    double changed;     /* s: when something changed last */
    double jammed;      /* s: when forces grew beyond all bounds last; NAN: never */
    gboolean jams;      /* they do so now */
    guint at_once;      /* changes before, at the same instant */
    double *quiet_x;    /* coordinates of the system, where ... */
    double quiet;       /* ... no plate was nearer to any body than this; 0 where one moves */
};

/* Changes at one instant: so many do not end by themselves. */
#define TINKER_MANY_AT_ONCE 8

/* Whether so many changes came at this instant. */
static inline gboolean tinker_contact_run_repeats(const TinkerContactRun *contact_run)
{
    return contact_run->at_once >= TINKER_MANY_AT_ONCE;
}

/* Notes which shapes overlap at the start, in the state that the model stands at: these pass until they have parted. */
void tinker_contact_run_note_overlaps(TinkerContactRun *contact_run);
/* Notes those that have come to overlap without touching, from below or past an end of a top, and those that have
 * parted. TINKER_FAILED, told by the model: two bodies overlap, and that they met was missed. */
TinkerStatus tinker_contact_run_watch_overlaps(TinkerContactRun *contact_run);

/* Lists the pairs whose gap may close on the way of the bodies from q_from to q_to, which leads no farther than
 * `travel` (m) away from either. */
void tinker_contact_run_find_near(TinkerContactRun *contact_run, const double *q_from, const double *q_to,
                                  double travel);
/* Notes which bodies are decided upon together, by what is closed or near: contacts of others answer to none of theirs.
 */
void tinker_contact_run_find_together(TinkerContactRun *contact_run);
/* Whether nothing can come near a plate within `travel` (m) of the state x (in the system's coordinates). */
gboolean tinker_contact_run_is_quiet(const TinkerContactRun *contact_run, const double *x, double travel);
/* Notes the state as one that is quiet, as far as it is. */
void tinker_contact_run_note_quiet(TinkerContactRun *contact_run, const double *x, const double *q);

/* The bodies at time t within the last step; borrowed until the next call. */
TinkerStatus tinker_contact_run_state_at(TinkerContactRun *contact_run, double t, double **q, double **v);

/* Brings the points to a time within the last step; *v gets the velocities of the bodies then, borrowed until the next
 * call. No force is worked out. */
TinkerStatus tinker_contact_run_place_at(TinkerContactRun *contact_run, double t, double **v);
/* Brings the model to a state, and works out what triggers ask for: forces of closed contacts, accelerations; and the
 * powers of the books, unless that is NULL. */
TinkerStatus tinker_contact_run_look_at(TinkerContactRun *contact_run, double t, const double *q, const double *v,
                                        double *power);
/* Whether the last look was at this time, and what it found still stands: forces of contacts, accelerations, and powers
 * if they were asked for. */
gboolean tinker_contact_run_has_looked(const TinkerContactRun *contact_run, double t);
/* Takes the present state for the start of the step. What was evaluated there stands if nothing has changed since. */
void tinker_contact_run_keep_start(TinkerContactRun *contact_run);
/* Evaluates the start of the step, as a look at it, and keeps what it finds; forgets that; and hands it to the method,
 * if it is kept: to the next evaluation. */
TinkerStatus tinker_contact_run_evaluate_start(TinkerContactRun *contact_run);
void tinker_contact_run_forget_start(TinkerContactRun *contact_run);
void tinker_contact_run_hand_start_on(TinkerContactRun *contact_run);
/* Puts what triggers ask for back as if the start had been looked at last, but for the state of the model. FALSE where
 * this is not the time of a start that is kept. */
gboolean tinker_contact_run_recall_start(TinkerContactRun *contact_run, double t);
/* The first of these triggers (of TinkerTrigger) that is of this contact, or NULL. (transfer none) */
const TinkerTrigger *tinker_trigger_of_contact(const GArray *triggers, int32_t body, int32_t plate);
/* All triggers of a step with these near pairs. */
TinkerStatus tinker_contact_run_list_triggers(TinkerContactRun *contact_run);
/* Their values, for the state looked at last; and the level below which one has passed 0, once forces were noted at all
 * nodes (speed, m/s: the largest). */
double tinker_trigger_value(const TinkerContactRun *contact_run, const TinkerTrigger *trigger);
double tinker_trigger_level(const TinkerContactRun *contact_run, const TinkerTrigger *trigger, double speed);
double tinker_trigger_place_rounding(const TinkerContactRun *contact_run, const TinkerTrigger *trigger);
void tinker_contact_run_note_force_scales(TinkerContactRun *contact_run);

/* How fast a plate swings (rad/s) between two times, as far as it shows at a few: its accelerations then beside its
 * largest speed so far. */
double tinker_contact_run_swing(TinkerContactRun *contact_run, int32_t point, const TinkerPlate *top, double from,
                                double to);
/* How fast (rad/s) bodies turn whose corners may touch: at the ends of the step. */
double tinker_contact_run_fastest_turn(const TinkerContactRun *contact_run);

/* The end (s) of the longest step that may be made from the state of the run, `limit` at most. */
double tinker_contact_run_step_limit(TinkerContactRun *contact_run, double limit);

/* The first fall of any trigger in the last step; its kind is NONE where there is none. *place gets its time and *slope
 * how fast it falls (per second). */
TinkerStatus tinker_contact_run_search(TinkerContactRun *contact_run, double from, double to, TinkerTrigger *found,
                                       double *time, double *slope);

/* The value of a trigger for a state of the bodies, by a look at it. */
TinkerStatus tinker_contact_run_value(TinkerContactRun *contact_run, double t, const double *q, const double *v,
                                      const TinkerTrigger *trigger, double *value, double *power);

/* Room for what is watched while these contacts are closed, so that steps allot nothing. No memory for it is the
 * model's failure. */
TinkerStatus tinker_contact_run_make_room(TinkerContactRun *contact_run);

/* Within this (m) of 0 a gap is closed: rounding, or another body at the same instant. */
double tinker_contact_run_closed_gap(const TinkerContactRun *contact_run);
/* How far (m) shapes may overlap that touch: what overlaps by more passes, or was missed. */
double tinker_contact_run_touching(const TinkerContactRun *contact_run);
/* Whether a gap of this value (m) is open, or closed, as tinker_contact_run_closed_gap has it: what is farther behind,
 * where the step begins, came from there. */
gboolean tinker_contact_run_is_before(const TinkerContactRun *contact_run, const TinkerTrigger *gap, double value,
                                      double closed);

/* Places (m) are no more exact than this over the first steps of a method that remembers its steps; 0 of others. */
double tinker_contact_run_place_noise(const TinkerContactRun *contact_run);

/* Speeds along a top up to this share of the largest are what dense output and errors make of 0; and up to this (m/s)
 * they do not tell which way a contact slips. */
double tinker_contact_run_speed_noise(const TinkerContactRun *contact_run);
double tinker_contact_run_unclear_speed(const TinkerContactRun *contact_run);

/* Whether the pair has just opened. */
gboolean tinker_contact_run_leaves(const TinkerContactRun *contact_run, const TinkerContactPair *pair);

/* Whether it is the side of a line that a corner cannot come to, since it touches the other side or has just left that:
 * its place alone, on the line but for rounding, does not tell. */
gboolean tinker_contact_run_is_across(const TinkerContactRun *contact_run, int32_t body, int32_t plate);

/* Contacts that change by turns: (transfer full) none at first; notes a change by a force, an acceleration or a speed;
 * whether one has done so more often than a motion does. */
GArray *tinker_contact_turns_new(void);
void tinker_contact_run_note_turn(TinkerContactRun *contact_run, const TinkerTrigger *trigger);
gboolean tinker_contact_run_goes_by_turns(const TinkerContactRun *contact_run, const TinkerTrigger *trigger);
/* How many times more than a few the contact of the trigger has come to an end of one kind within no time, so that
 * nothing followed from it. That is where a force jumps: dense output, which found the place, misses it by a little, so
 * that the force is not there yet in the state that is asked. */
int tinker_contact_run_stays_at_edge(const TinkerContactRun *contact_run, const TinkerTrigger *trigger);
/* Whether the contact of the trigger had opened at its last turn, and closed at once. */
gboolean tinker_contact_run_came_back(const TinkerContactRun *contact_run, const TinkerTrigger *trigger);
/* Whether what is met strikes so often within no time that the blows have no end: a body between two that close on it.
 */
gboolean tinker_contact_run_strikes_by_turns(const TinkerContactRun *contact_run, const TinkerTrigger *trigger);

void tinker_contact_flight_init(TinkerContactFlight *flight, const TinkerContactRun *contact_run, gboolean exact);
void tinker_contact_flight_clear(TinkerContactFlight *flight);
/* Whether the island, which is in the plane, flies from its present state on as its linear form does. */
gboolean tinker_contact_flight_is_free(TinkerContactRun *contact_run);
/* Before and after a blow in flight is passed, in the plane: takes the state on to the blow itself, and back to its
 * instant. */
TinkerStatus tinker_contact_flight_meet(TinkerContactRun *contact_run, const TinkerTrigger *trigger);
TinkerStatus tinker_contact_flight_part(TinkerContactRun *contact_run, const TinkerTrigger *trigger);

/* Before a step: where a contact is to close in a small part of a usual step, the hint is just behind that. */
void tinker_contact_run_expect(TinkerContactRun *contact_run);
/* Behind an event, which was passed and stands in *next: whether another one is at its very instant, as what bears a
 * load with others reaches its limit with them; it is in *next then, which else means nothing any more. A full step
 * would find the same, and be cut to nothing. */
gboolean tinker_contact_run_next_at_once(TinkerContactRun *contact_run, TinkerTrigger *next);
/* That contact, in a step that went there and found nothing, where it comes no more than a little behind its end; else
 * *found is left as it is. */
void tinker_contact_run_take_expected(TinkerContactRun *contact_run, TinkerTrigger *found, double *time, double *slope);
/* Whether the step has ended so near to a time that it need not be made again to come there; and takes its state there
 * (to where a gap is 0, to rounding). *there is FALSE where that is too far: then the state is to be made again. */
gboolean tinker_contact_run_ends_near(const TinkerContactRun *contact_run, double time);
TinkerStatus tinker_contact_run_carry_to(TinkerContactRun *contact_run, const TinkerTrigger *trigger, double time,
                                         TinkerStepReport *report, gboolean *there);

/* Ends the last step at the fall of a trigger that is expected at `time` (s), where it falls by `slope` a second: then
 * its event is pending. A method that makes several steps of the way stands between them, with a hint. */
TinkerStatus tinker_contact_run_end_at(TinkerContactRun *contact_run, const TinkerTrigger *trigger, double time,
                                       double slope, TinkerStepReport *report);

/* Passes an event at the state of the run: impacts, and what is closed from here on. `tolerance` (m): within it a gap
 * is closed. */
gboolean tinker_contact_run_change(TinkerContactRun *contact_run, const TinkerTrigger *trigger, double tolerance,
                                   double slow, GError **error);
/* Passes an event at an instant that a sample may be of, a start or a blow, and then the impacts that its impacts bring
 * about, 32 at most, so that the state is that behind them. */
gboolean tinker_contact_run_change_until_parting(TinkerContactRun *contact_run, const TinkerTrigger *trigger,
                                                 double tolerance, double slow, GError **error);

#endif

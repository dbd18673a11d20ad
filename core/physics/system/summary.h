/* What a run tells of itself. */
#ifndef TINKER_CORE_SUMMARY_H
#define TINKER_CORE_SUMMARY_H

#include "physics/model/model.h"

/* How a body goes on behind an impact, by one of the laws of impact. */
typedef struct {
    const char *law;
    TinkerBlockId block;
    double vx, vy; /* m/s */
    double rate;   /* rad/s; NAN: it does not turn */
} TinkerAlternative;

typedef struct {
    double time;
    TinkerBlockId island; /* the first body of the part of the scene that it happened in */
    char *kind;           /* "break", "bifurcation", "start impulse", ... */
    char *blocks;         /* names, joined by ", " */
    GArray *alternatives; /* of TinkerAlternative, law by law, where the laws of impact differ; else NULL */
    gboolean stays;       /* what has come to an end or has lifted off touches the other elsewhere from there on */
    gboolean turns;       /* it is of friction that resists turning, as rolling resistance is, not of sliding */
} TinkerEvent;

/* How one island was stepped. */
typedef struct {
    GArray *bodies; /* of TinkerBlockId */
    const char *method;
    gboolean adaptive; /* which of step and tolerance counts */
    double step, tolerance;
} TinkerIslandSummary;

/* A run that was to hold an accuracy: how it was stepped, what it cost, and what its estimate was. */
typedef struct {
    const char *method; /* as in TinkerSummary, and so are the others */
    gboolean adaptive;
    double step, tolerance;
    gint64 evaluations;
    double wall_s; /* with its companion */
    double error_estimate;
} TinkerTry;

typedef struct {
    const char *method; /* the one that was used; "auto" where islands differ */
    gboolean adaptive;  /* which of step and tolerance counts, where they do not differ */
    double step, tolerance;
    gint64 steps, rejected_steps, evaluations;
    gint64 contact_changes; /* events at which contacts closed, opened, stuck or slipped; 0 with `impulses` */
    double simulated_s, wall_s;
    double constraint_position_error, constraint_velocity_error; /* largest at any step's end, relative to lengths and
                                                                    speed scale */
    double kinetic_start, kinetic_end, potential_start, potential_end; /* J */
    double books[TINKER_BOOK_COUNT];                                   /* J given to the system, negative where taken */
    double energy_balance_error; /* largest, relative to the largest energy exchanged */
    double start_impulse;        /* N s: root of the sum of squares of the impulses, one a body, that brought the start
                                        velocities onto the constraints */
    double error_estimate;       /* of the state: the largest so far, over the island's extent and largest speed;
                                    NAN without an estimate */
    double missed;               /* no unit: the share of the speed that the largest impulse of a typed law would make
                                    which fixed steps passed over; no companion sees it, and error_estimate is no less */
    double predictable_until;    /* s: where that passed a tenth; INFINITY where it did not */
    double accuracy;             /* that was asked for; 0: none */
    GArray *tries;               /* of TinkerTry, this run the last, where an accuracy was to be held; else empty */
    double determined_until; /* s: where a line's direction was lost: what follows is one motion of many; INFINITY */
    double valid_until;      /* s: as far as the record is to be believed; simulated_s where all of it is */
    GPtrArray *islands;      /* of TinkerIslandSummary * */
    GPtrArray *events;       /* of TinkerEvent * */
    GPtrArray *warnings;     /* of TinkerWarning * */
} TinkerSummary;

/* Adds a warning that another method or step may spare (transfer full). */
void tinker_summary_warn_of_method(TinkerSummary *summary, char *text);

/* Adds a warning that is about the scene itself (transfer full): no other method would spare it. */
void tinker_summary_warn_of_scene(TinkerSummary *summary, char *text);

/* Adds the warning that the outcome depends on the law of impact, from the time `t` (s) on. */
void tinker_summary_warn_of_laws(TinkerSummary *summary, double t);

/* Samples that are so far `apart` (s) do not show how the block of this name moves; an interval (s) that does. */
void tinker_summary_warn_of_samples(TinkerSummary *summary, const char *name, double apart, double interval);
#endif

/* The run of one island: its state, its method, its books. */
#ifndef TINKER_CORE_ISLAND_RUN_H
#define TINKER_CORE_ISLAND_RUN_H

#include "physics/island/stability-watch.h"
#include "physics/model/breaks.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/record/sample-times.h"
#include "physics/system/books.h"
#include "physics/system/method-call.h"
#include "physics/system/summary.h"
#include "physics/system/system.h"

/* Energies that balance to within this share of the largest exchanged are believed. */
#define TINKER_BALANCED 0.01

struct _TinkerContactRun;
struct _TinkerDirectionWatch;
struct _TinkerIdleLines;
struct _TinkerLawWatch;

typedef struct {
    const TinkerIsland *island;
    TinkerModel *model; /* the island's */
    TinkerChoice choice;
    void *stepper;
    /* Of an island that is solved exactly in its flights, once something has touched: the method of the flights while
     * contacts are closed, that of contacts in flight. Else NULL. */
    struct {
        const TinkerIntegrator *method;
        void *stepper;
    } aside;
    TinkerModelSystem system;
    TinkerState state; /* in the coordinates of the system */
    double *q, *v; /* of the model's bodies: see tinker_island_run_place. The state's own where it is in the plane, */
    double *line_q, *line_v; /* else these are, along the line; NULL where the island is not straight */
    double *sample_x, *sample_u;
    double *room; /* which all these and the books lie in */
    TinkerTimeGrid step_grid;
    gint64 next_step; /* on the step grid, of a method that is not adaptive */
    gboolean is_companion;
    double half; /* s: where the second half of a step ends that a companion makes in two; not behind t: none */
    double
        latest; /* s: of an adaptive method no step goes beyond it, unless it is behind; INFINITY but in a companion */
    double piece_from;      /* the current piece begins here, with a break; -INFINITY: with none */
    double piece_end;       /* it ends here: */
    gboolean ends_on_break; /* with a break, or only because nobody looked further */
    gboolean abandoned; /* of a companion: what it follows is not determined any more, and nobody asks where it is */
    TinkerBreakCrowd crowd; /* of pieces that are too short */
    double pole;            /* s: no step goes beyond it; INFINITY */
    TinkerBlockId pole_block;
    TinkerBooks books;
    GArray *jolts;                            /* see TinkerRunOptions; NULL in a companion */
    struct _TinkerContactRun *contacts;       /* NULL where nothing can touch anything */
    struct _TinkerDirectionWatch *directions; /* NULL where no line has a force at length 0 */
    struct _TinkerIdleLines *idle;            /* NULL where no line is without force over a range of lengths */
    struct _TinkerLawWatch *laws;             /* NULL where no typed law may be large in a narrow band alone */
    TinkerStabilityWatch *stability;
    gint64 looked_at;   /* steps at the last look into the books */
    int singular_steps; /* in a row */
    int tiny_steps;     /* likewise: of which the rest of the run would take too many; ... */
    double tiny;        /* s: ... the first of them, of which none was twice as long; 0: none */
    int steps_off;      /* at whose ends the energy was off by more than was exchanged, since it balanced at all */
    double spectral_radius;
    TinkerSummary summary; /* of this island; events and warnings are those of the whole run, borrowed */
} TinkerIslandRun;

/* Opening and clearing, in parts: the state at the start; the method's stepper; what the summary says of the method.
 * Contacts and directions belong to whoever drives the run (event/), which clears them first. */
void tinker_island_run_open_state(TinkerIslandRun *run);
gboolean tinker_island_run_open_stepper(TinkerIslandRun *run, GError **error);
void tinker_island_run_name_method(TinkerIslandRun *run);
void tinker_island_run_clear(TinkerIslandRun *run);

/* A step of the run's method, no farther than `limit`. What a plugin's method does against its contract is a failure,
 * told in the model's words: else a run would go on with times that are not those of its states. */
TinkerStatus tinker_island_run_make_step(TinkerIslandRun *run, double limit, TinkerStepReport *report);

/* Back to a state that the run was in, with what its projections had given and missed until then; `from` may be the
 * run's own arrays, where dense output has brought them there. The method starts anew. */
void tinker_island_run_go_back(TinkerIslandRun *run, const TinkerState *from, double projection_work,
                               double position_error);

/* Bodies meet plates: from the present state on the run is stepped in the plane, by a method that takes constraints. */
gboolean tinker_island_run_enter_plane(TinkerIslandRun *run, GError **error);

/* Out of the plane, where an island that is solved exactly flies again: nothing is closed, and its state is one of its
 * linear form. */
void tinker_island_run_leave_plane(TinkerIslandRun *run);

/* The state in the system's coordinates at time t, within the last step; `books` may be NULL. What dense output
 * evaluates is not counted: how often a run is looked at would show. */
TinkerStatus tinker_island_run_interpolate(TinkerIslandRun *run, double t, double *x, double *u, double *books);

/* Brings a state of the model's bodies at time t onto contacts that are closed and onto the constraints, unless the
 * coordinates of the system, as those along a line, meet them as they are. */
TinkerStatus tinker_island_run_meet(TinkerIslandRun *run, double t, double *q, double *v);

/* The state of the model's bodies (relative to its origin) at time t, within the last step, on the constraints. */
TinkerStatus tinker_island_run_state_at(TinkerIslandRun *run, double t, double *q, double *v);

/* The state of the model's bodies at time t as the method interpolates it, wherever the constraints are. */
TinkerStatus tinker_island_run_unprojected_at(TinkerIslandRun *run, double t, double *q, double *v);

/* Speeds (m/s) up to here are rounding of places from step to step: what is at rest has them. */
double tinker_island_run_speed_noise(const TinkerIslandRun *run, double extent);

/* Brings q and v to the state. */
void tinker_island_run_place(TinkerIslandRun *run);

/* Notes an event at the state's time. `blocks` are names, joined by ", ". */
void tinker_island_run_add_event(TinkerIslandRun *run, const char *kind, const char *blocks);

/* Looks into the books at the state: where they balance, the run is valid up to it. */
TinkerStatus tinker_island_run_mark_valid(TinkerIslandRun *run);

/* The error of a run that failed, and why (NULL or "" where nobody said). Answers FALSE. */
gboolean tinker_island_run_fail(TinkerIslandRun *run, const char *why, GError **error);
/* The same of a sample, which lies before the state. */
gboolean tinker_island_run_fail_at(TinkerIslandRun *run, double t, const char *why, GError **error);
/* Fails the run where the state is still that of the last good step: how far it is valid is not lost. */
gboolean tinker_island_run_fail_step(TinkerIslandRun *run, const char *why, GError **error);

#endif

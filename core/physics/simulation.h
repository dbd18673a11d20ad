/* A run: steps a model from t = 0 to its end and hands out samples.
 *
 * Samples come from dense output, projected onto the constraints, so how often and where one looks never changes a step.
 */
#ifndef TINKER_CORE_SIMULATION_H
#define TINKER_CORE_SIMULATION_H

#include "physics/columns.h"
#include "physics/model.h"

typedef struct {
    double duration;    /* s */
    double interval;    /* s between samples; ignored where `at` is given */
    const double *at;   /* times of the samples, any order; or NULL. Borrowed until the simulation is freed */
    gsize at_count;     /* the run lasts to the greatest of them */
    const char *method; /* "auto", or an integrator's id */
    double step;        /* s, of fixed-step methods */
    double tolerance;   /* of adaptive methods */
    double accuracy; /* wanted error estimate of the run: the plan chooses step and tolerance for it, and both are left
                           out of account; 0: they count. Held by tinker_accurate_run */
    double spectral_radius;
    gboolean impulses;                 /* contact as impulses, in steps of `step`, whatever `method` */
    gboolean estimate;                 /* run a companion for the error estimate */
    gboolean bands;                    /* and evaluate the columns on it too */
    gboolean (*cancelled)(void *data); /* asked now and then; TRUE stops the run. May be NULL */
    void (*progress)(double t, double duration, void *data); /* called now and then. May be NULL */
    void *data;                                              /* of the two */
} TinkerRunOptions;

/* The scene's own settings. Strings are borrowed from it. */
TinkerRunOptions tinker_run_options_of(TinkerScene *scene);

/* What is wrong with a method of this name, "there is no method ...", or NULL: for TinkerCatalogueOptions. (transfer full) */
char *tinker_method_fault(TinkerCatalogue *catalogue, const char *id);

/* What the energy books tell apart. */
typedef enum {
    TINKER_BOOK_DAMPERS,
    TINKER_BOOK_FRICTION,
    TINKER_BOOK_CONTACTS,
    TINKER_BOOK_MOTORS,
    TINKER_BOOK_FIELDS,
    TINKER_BOOK_SUPPORT_MOTION,
    TINKER_BOOK_PROJECTION, /* what bringing the state back onto the constraints gave */
    TINKER_BOOK_COUNT,
} TinkerBook;

typedef struct {
    double time;
    char *kind;   /* "break", "bifurcation", "start impulse", ... */
    char *blocks; /* names, joined by ", " */
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
    double constraint_position_error,
        constraint_velocity_error; /* largest at any step's end, relative to lengths and speed
                                                                    scale */
    double kinetic_start, kinetic_end, potential_start, potential_end; /* J */
    double books[TINKER_BOOK_COUNT];                                   /* J given to the system, negative where taken */
    double energy_balance_error; /* largest, relative to the largest energy exchanged */
    double start_impulse;        /* N s: root of the sum of squares of the impulses, one a body, that brought the start
                                        velocities onto the constraints */
    double error_estimate;       /* of the state: the largest so far, over the island's extent and largest speed;
                                    NAN without an estimate */
    double predictable_until;    /* s: where that passed a tenth; INFINITY where it did not */
    double accuracy;             /* that was asked for; 0: none */
    GArray *tries;               /* of TinkerTry, this run the last, where an accuracy was to be held; else empty */
    double determined_until; /* s: where a line's direction was lost: what follows is one motion of many; INFINITY */
    double valid_until;      /* s: as far as the record is to be believed; simulated_s where all of it is */
    GPtrArray *islands;      /* of TinkerIslandSummary * */
    GPtrArray *events;       /* of TinkerEvent * */
    GPtrArray *warnings;     /* of char * */
    GPtrArray *of_scene; /* those of the warnings that are about the scene itself, which no other method would spare;
                                borrowed from them */
} TinkerSummary;

typedef struct _TinkerSimulation TinkerSimulation;

/* Prepares a run. The model is borrowed, outlives the simulation and serves one at a time. Errors:
 * TINKER_MODEL_ERROR_METHOD. (transfer full) */
TinkerSimulation *tinker_simulation_new(TinkerModel *model, const TinkerRunOptions *options, GError **error);
void tinker_simulation_free(TinkerSimulation *simulation);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerSimulation, tinker_simulation_free)

/* One sample: time, and the value of each column. Answering FALSE with `error` set stops the run. */
typedef gboolean (*TinkerSampleFunc)(TinkerSimulation *simulation, double time, const double *values, void *data,
                                     GError **error);

/* Runs to the end. `columns` (of TinkerColumn, may be NULL) are evaluated at every sample. On failure (TINKER_MODEL_ERROR_RUN)
 * the message names the block, and the samples up to then have been handed out; summary->valid_until says how far they
 * are to be believed. */
gboolean tinker_simulation_run(TinkerSimulation *simulation, const GArray *columns, TinkerSampleFunc sample, void *data,
                               GError **error);

/* Inside a sample function: puts bodies and supports of the frame where they are at this sample. */
gboolean tinker_simulation_place(TinkerSimulation *simulation, TinkerFrame *frame, GError **error);

/* A body that can move, at a sample. */
typedef struct {
    double x, y;        /* m, in the world */
    double vx, vy;      /* m/s */
    double orientation; /* rad; NAN where nothing has turned it since the start */
} TinkerBodySample;

/* Inside a sample function: a body's state at this sample. FALSE for a block that is no body that can move. */
gboolean tinker_simulation_body(const TinkerSimulation *simulation, TinkerBlockId block, TinkerBodySample *sample);

/* Inside a sample function: how far each column may be off at this sample (the running maximum of its estimate), in the
 * column's unit; NAN from where the companion has stopped on. NULL at all samples of a run where `bands` was not asked for or
 * there is no companion. Borrowed. */
const double *tinker_simulation_bands(TinkerSimulation *simulation);

/* What has happened so far, added up at every call and at the end of a run. Borrowed. */
const TinkerSummary *tinker_simulation_summary(TinkerSimulation *simulation);

/* One step of the island that is farthest behind, without samples, for benchmarks and single stepping. */
gboolean tinker_simulation_step(TinkerSimulation *simulation, GError **error);

/* The time that all islands have reached. */
double tinker_simulation_time(const TinkerSimulation *simulation);

/* Where a body that can move is now, in the world; FALSE for any other block. */
gboolean tinker_simulation_state(TinkerSimulation *simulation, TinkerBlockId block, double position[2],
                                 double velocity[2]);

#endif

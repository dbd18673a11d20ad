/* What a compiled model consists of. Constant after compiling, but for the parts under "working state", which belong to the
 * one evaluation in progress.
 *
 * Symbols: q, v positions and velocities of the bodies that can move, two entries a body, relative to `origin`; f forces;
 * J rows of the constraints; lambda their multipliers; S = J M^-1 J^T.
 *
 * Points: everything that something attaches to. The first `bodies` points are the bodies' centres; the others lie on
 * supports. Forces are added up by point, so the force on a support is known as well.
 */
#ifndef TINKER_CORE_MODEL_PRIVATE_H
#define TINKER_CORE_MODEL_PRIVATE_H

#include <stdatomic.h>

#include "numerics/sharing.h"
#include "numerics/sparse-ldl.h"
#include "physics/jacobian.h"
#include "physics/linear-form.h"
#include "physics/model.h"
#include "physics/simulation.h"
#include "scene/batch.h"
#include "scene/motions.h"

/* Instances that one call of a plugin works on: their arrays stay in the L1 cache. */
#define TINKER_CHUNK 256

/* A point that is fixed to a support. */
typedef struct {
    TinkerBlockId support;
    double x, y; /* with the support at its place, relative to the origin */
    gboolean moving;
} TinkerSupportPoint;

/* Linear laws between the same two points, merged:
 * T = tension + stiffness * (L - length) + damping * rate. Columns, so that kernels load them four at a time. */
typedef struct {
    int32_t count;
    int32_t *a, *b;
    double *stiffness, *length, *damping, *tension;
    gboolean any_damping;
    double watched_square; /* m^2: shorter ones are noted, see TinkerModel.watched_length */
    atomic_int *came_near; /* there */
} TinkerMergedLines;

typedef struct _TinkerLineParts TinkerLineParts;

/* Blocks of one class whose plugin is asked at every evaluation. */
typedef struct {
    TinkerBlockBatch *batch;
    const int32_t *end_points; /* of the batch's ends, row by row */
    gboolean stores_energy;
} TinkerAskedBatch;

/* A force that does not depend on the state: value of a waveform * direction at one point. */
typedef struct {
    int32_t point;
    double direction[2];
    const double *value; /* the waveform's column, this block's entry */
    const TinkerBlockBatch *batch;
    int32_t row;
} TinkerDrivenForce;

/* One class of constraints: its rows and entries lie behind one another in the model's arrays. */
typedef struct {
    TinkerBlockBatch *batch;
    const TinkerConstraint *constraint;
    const int32_t *end_points;
    int32_t first_row, row_count;
    int32_t first_entry; /* an entry is one end of one row */
    double *distances;   /* of rows that keep a constant distance, which the host works out: one each; else NULL */
    TinkerBatch view;    /* of the whole batch */
} TinkerConstraintBatch;

typedef struct _TinkerRowChains TinkerRowChains;

/* One product that is added up in S: inverse mass * J of one entry . J of another, on the same body. */
typedef struct {
    int32_t slot, first_entry, second_entry;
    double inverse_mass;
} TinkerProduct;

/* Whether there is a factor of S, and of which Jacobian: see TinkerConstraints. */
typedef struct {
    gboolean factored, keeps_factored, shifted;
} TinkerFactorState;

typedef struct {
    int32_t rows, entries;
    GArray *batches;        /* of TinkerConstraintBatch */
    GArray *straight;       /* of TinkerStraightRow (straight-bars.h): rows that no block has, ... */
    int32_t first_straight; /* ... from this one on, behind all others */
    int32_t fitted; /* rods of bars that depend on the others there, however nearly their rows say that they do not */
    int32_t *row_starts;                 /* rows + 1: the entries of each row */
    int32_t *points;                     /* of each entry */
    int32_t *row_of;                     /* of each entry */
    int32_t *body_starts, *body_entries; /* bodies + 1: the entries on each body */
    gboolean two_entries;                /* every row has two */
    double *scales;                      /* of each row: the length its error is measured against */
    double *inverse_scales;
    TinkerBlockId *blocks; /* of each row */
    /* Of rows that hold in one direction only, g <= 0; NULL where there are none. Slack rows do not act: their entries in the
     * arrays below are 0, and what they would be is kept as their own. */
    gboolean *unilateral, *slack; /* by row */
    int32_t *diagonal;            /* by row: its slot in S */
    double *own_g, *own_drift, *own_rate, *own_jacobian;
    TinkerProduct *products;
    gsize product_count;
    TinkerSparseLdl *ldl;
    TinkerRowChains *chains; /* of rows that hang together in chains alone; else NULL */
    double work;             /* J: what the last projection of positions gave, by the applied forces evaluated last */
    gboolean gave_way;       /* a projection stopped short at a singular place; whoever reports it clears it */
    int32_t redundant;       /* rows that depend on others at the start: every solve is proximal */

    /* working state */
    TinkerPoint *ends; /* gathered, of the largest batch */
    double *jacobian;  /* 2 per entry */
    double *g, *drift, *rate;
    double miss; /* the largest |g| relative to its row's length */
    double *lambda, *residual, *correction;
    double *asked;           /* of each row: the change of speed that a projection asks for */
    double *by_point;        /* 2 per point */
    double *turned;          /* RATTLE: the Jacobian at the start of the step */
    double *displacement;    /* of a Newton step: 2 per body */
    gboolean shifted;        /* the factor is of S + eps I: solve by proximal iteration */
    gboolean prescribed;     /* some row's dg/dt of what is prescribed is not 0 */
    gboolean factored;       /* there is a factor, ... */
    gboolean keeps_factored; /* ... of `jacobian` itself; else of this one, which else is room for the next: */
    double *factored_jacobian;
    gboolean looked; /* at a sample since the last step, which goes on with these: */
    TinkerFactorState kept;
    double *kept_jacobian, *kept_factored_jacobian;
} TinkerConstraints;

typedef struct _TinkerContacts TinkerContacts;

struct _TinkerModel {
    TinkerScene *scene;
    gboolean part;         /* of the scene: other bodies of it are in other models */
    GPtrArray *batches;    /* of TinkerBlockBatch */
    GPtrArray *end_points; /* of int32_t *: of each batch, by batch; NULL for one without ends */
    GPtrArray *warnings;
    double origin[2];

    /* bodies and points */
    int32_t bodies;
    TinkerBlockId *body_blocks;
    double *mass;            /* of each body */
    double *coordinate_mass; /* of each coordinate */
    double *inverse_mass;    /* of each body */
    double *q_start, *v_start;
    double start_impulse; /* N s that brought v_start onto the constraints */
    int32_t points;
    GArray *support_points; /* of TinkerSupportPoint: points `bodies`, `bodies` + 1, ... */
    int32_t *centre_point;  /* by block id: the point of a block's centre, or -1 */
    gboolean *point_used;   /* whether a connector or a constraint attaches to the point */
    TinkerMotions *motions;
    int32_t moving_supports;

    /* forces */
    TinkerMergedLines lines;
    TinkerLineParts *line_parts; /* where the lines are many: the parts that threads share; else NULL */
    double merged_energy;        /* J that merging took out of the lines' own energies, a constant */
    GArray *asked_lines;         /* of TinkerAskedBatch */
    GArray *asked_forces;
    GArray *asked_fields;
    GArray *driven;           /* of TinkerDrivenForce */
    gboolean more_than_lines; /* there are forces or books beside those of merged lines and constant accelerations */
    double *constant_acceleration; /* 2 per body: of fields and constant forces */
    double field_acceleration[2];  /* of linear fields: conservative */
    double field_force[2], field_drag;
    double *constant_force; /* 2 per body, or NULL: of force elements */
    TinkerConstraints constraints;
    TinkerContacts *contacts;    /* NULL where nothing can touch anything */
    GPtrArray *waveform_batches; /* of TinkerBlockBatch: those with waveforms that are not motions */
    gboolean has_book[TINKER_BOOK_COUNT];

    /* working state */
    TinkerPoint *point;
    double *point_acceleration;  /* 2 per point; of supports kept up to date, of bodies by whoever needs it */
    double *force;               /* 2 per point, and behind them 2 per slot of the line parts */
    double *chunk;               /* six columns of TINKER_CHUNK and ends of a chunk */
    const double **column_views; /* room for the columns of any class */
    double *velocity_kept;       /* 2 a body, while differences change it (products.c) */
    int feels_velocity;          /* whether what is differenced depends on it: 1, -1: no, 0: nobody has tried */
    int32_t *chunk_offsets;      /* of the ends of a chunk, where blocks differ in their number */
    double time;                 /* that waveforms and supports were evaluated at */
    double book_power[TINKER_BOOK_COUNT];
    gint64 evaluations;
    double watched_length; /* m: whoever evaluates a line shorter than this sets ... */
    atomic_int came_near;  /* ... this, which nothing is ordered by; 0: none is watched (direction-watch.h) */
    char failure[512];
    gboolean lacks_memory; /* so that it cannot be compiled, or go on */
};

/* Compiling: each adds its part to the model. */
gboolean tinker_model_compile_bodies(TinkerModel *model, GError **error);
gboolean tinker_model_compile_forces(TinkerModel *model, GError **error);
gboolean tinker_model_compile_constraints(TinkerModel *model, GError **error);
gboolean tinker_model_check_start(TinkerModel *model, GError **error);

/* Where a point is at the start, relative to the origin; of supports where they are unmoved. */
void tinker_model_start_place(const TinkerModel *model, int32_t point, double place[2]);

/* The points of a batch's ends, or NULL. */
const int32_t *tinker_model_end_points(const TinkerModel *model, const TinkerBlockBatch *batch);

/* A view of `count` rows of a batch from `first` on, for a call of its plugin. `columns` has room for the class's columns. */
TinkerBatch tinker_model_view(const TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                              const double **columns);

/* Records that a plugin failed in its callback `what`. Answers TINKER_FAILED. */
TinkerStatus tinker_model_fail(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what,
                               const char *why);

/* Looks whether a plugin wrote beyond the memory that it was given (plugin/guarded.h). TINKER_FAILED and its name where one
 * did. */
TinkerStatus tinker_model_check_guards(TinkerModel *model);

/* Records that `what` of a block is not a finite number. Answers TINKER_RETRY_SMALLER: a trial that reached too far may be
 * cut; a method that cannot do so stops with what was recorded. */
TinkerStatus tinker_model_not_finite(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what);

/* The place of a book among those that are integrated; -1 where it is none. */
int32_t tinker_model_book_index(const TinkerModel *model, TinkerBook book);

/* Dynamics. All q and v are relative to the origin. */

/* Brings waveforms, moving supports and their points to time t; does nothing where they are there already. */
static inline TinkerStatus tinker_model_set_time(TinkerModel *model, double t);
/* The same where the time is another one. */
TinkerStatus tinker_model_change_time(TinkerModel *model, double t);

/* Packs q and v into the points. */
static inline void tinker_model_set_state(TinkerModel *model, const double *q, const double *v);
/* The same, shared among threads. */
void tinker_model_share_state(TinkerModel *model, const double *q, const double *v);

/* Asking plugins for forces, for the state in the points. What is answered lies in the model's chunk until the next call. A
 * force that is not finite is a failure, which is recorded. */

/* Of lines: lengths (m), their rates (m/s), tensions (N), and unit vectors from the first ends to the second, 0 at length
 * 0; with room for one more column. */
typedef struct {
    double *length, *rate, *tension, *still, *x, *y;
} TinkerLineChunk;

/* Of the lines of a view, at most TINKER_CHUNK of them; `points` are those of their ends. */
TinkerStatus tinker_model_ask_lines(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                    TinkerBatch *view, TinkerLineChunk *chunk);
/* Of `count` force elements from `first` on, at most TINKER_CHUNK: the force (N) on each of their ends, which lie on
 * `points`. */
TinkerStatus tinker_model_ask_element(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                      int32_t first, int32_t count, const double **force);
/* Of `count` fields from `first` on: the force (N) of all of them on each body. */
TinkerStatus tinker_model_ask_field(TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                                    const double **force);
/* Records why a plugin gave no `what`, where `status` is a failure; answers the status to go on with. */
TinkerStatus tinker_model_refuse_forces(TinkerModel *model, const TinkerBlockBatch *batch, const TinkerBatch *view,
                                        TinkerStatus status, const char *what);

/* Adds up all applied forces by point, for the state in the points; a = M^-1 f. With `books` also the power that each book
 * gives, into model->book_power. */
TinkerStatus tinker_model_applied(TinkerModel *model, double *a, gboolean books);

/* Energies (J), for the state in the points. */
typedef struct {
    double kinetic;
    double potential;        /* of all blocks, relative to the origin */
    double stored_in_forces; /* part of it: of force elements that are asked */
    double stored_in_fields; /* and of fields that are asked */
} TinkerEnergy;
TinkerStatus tinker_model_energy(TinkerModel *model, TinkerEnergy *energy);

/* What a change of velocities gives (J); 2 entries a body each. */
double tinker_model_kinetic_change(const TinkerModel *model, const double *before, const double *after);

/* The next time after t, not after the horizon, at which a derivative of anything jumps; INFINITY for none. */
double tinker_model_next_break(TinkerModel *model, double t, double horizon);
/* Enters the piece of all waveforms that contains `inside`. */
void tinker_model_enter_piece(TinkerModel *model, double inside);

/* out = d(M^-1 f)/dv dv and d(M^-1 f)/dq dq of the line laws and fields, for the state in the points. */
TinkerStatus tinker_model_damping_product(TinkerModel *model, const double *dv, double *out);
TinkerStatus tinker_model_stiffness_product(TinkerModel *model, const double *dq, double *out);

/* Lines shorter than this (m; 0: none) are noted from now on. */
static inline void tinker_model_watch_lines(TinkerModel *model, double length)
{
    model->watched_length = length;
    model->lines.watched_square = length * length;
    model->lines.came_near = &model->came_near;
}

/* The largest |x|. */
double tinker_greatest(const double *x, int32_t n);

/* Constraints. */

/* The greatest length (m) that a constraint with one end declares, else 0: it holds a body about a place where no point is. */
double tinker_constraints_reach(const TinkerModel *model);
/* Rows at the state in the points: g, Jacobian, drift. */
TinkerStatus tinker_constraints_evaluate(TinkerModel *model);
/* Adds the constraint accelerations to a (2 per body), for the rows evaluated last; leaves lambda. Answers the largest
 * acceleration (m/s^2) that could not be met: see tinker_constraints_solve. */
double tinker_constraints_accelerate(TinkerModel *model, double *a);
/* Between two steps, before a sample is worked out: a factor that is at hand serves a first Newton step too, so that samples would
 * depend on those before them, and the next step on all of them. From here on there is none; the step's is put back by the
 * second of these, which does nothing where nobody has looked. */
void tinker_constraints_begin_look(TinkerModel *model);
void tinker_constraints_end_look(TinkerModel *model);
/* Solves S x = b, both of one entry a row; in place. Answers the largest residual: 0 where the rows are independent,
 * rounding where dependent rows agree, more where they contradict each other. Rows that no body feels get 0. */
double tinker_constraints_solve(TinkerModel *model, double *b);
/* A Newton step back to the constraints, S x = -g: leaves x in lambda and M^-1 J^T x in displacement. `roughly`: with the
 * factor at hand. */
void tinker_constraints_newton_step(TinkerModel *model, gboolean roughly);
/* Solves S x = asked, of one entry a row: leaves x in lambda and adds M^-1 J^T x to v. */
void tinker_constraints_change_speeds(TinkerModel *model, const double *asked, double *v);
/* target += M^-1 J^T x. */
void tinker_constraints_add_impulse(TinkerModel *model, const double *x, double *target);
TinkerStatus tinker_constraints_project_positions(TinkerModel *model, double t, double *q, const double *v,
                                                  gboolean *moved);
/* The same for velocities, with the rows evaluated last. Answers the kinetic energy (J) that this gave. */
double tinker_constraints_correct_velocities(TinkerModel *model, double *v, gboolean homogeneous, gboolean *moved);
TinkerStatus tinker_constraints_project_velocities(TinkerModel *model, double t, const double *q, double *v,
                                                   gboolean homogeneous, gboolean *moved);
/* RATTLE's position stage, see TinkerSystem.constrain_step. */
TinkerStatus tinker_constraints_rattle(TinkerModel *model, double t_from, const double *q_from, double t, double h,
                                       double *q, double *v);
/* J v + dg/dt of the rows evaluated last, for the velocities in the points; J u for a vector u by point. */
void tinker_constraints_rates(const TinkerModel *model, double *out);
void tinker_constraints_rows_times(const TinkerConstraints *constraints, const double *by_point, double *out);
/* Largest |g| relative to the rows' lengths, and largest |J v + dg/dt| (m/s), at a state. */
TinkerStatus tinker_constraints_errors(TinkerModel *model, double t, const double *q, const double *v, double *position,
                                       double *velocity);
/* The largest |g| relative to its row's length, of the rows evaluated last. */
double tinker_constraints_worst_miss(const TinkerModel *model);
/* And the row. */
int32_t tinker_constraints_worst_row(const TinkerModel *model);
/* Of rows that hold in one direction only: whether one acts from the next evaluation on. */
void tinker_constraints_set_slack(TinkerModel *model, int32_t row, gboolean slack);
/* Whether it acts or not, for the rows evaluated last: dg/dt with the velocities in the points; J x of bodies alone (2 per
 * body); and what d2g/dt2 is beside J a of the bodies. */
double tinker_constraints_own_rate(const TinkerModel *model, int32_t row);
double tinker_constraints_own_row_times(const TinkerModel *model, int32_t row, const double *by_body);
double tinker_constraints_own_drift(const TinkerModel *model, int32_t row);
/* Keeps what the rows are as their own, and takes the slack ones out. Called by tinker_constraints_evaluate. */
void tinker_constraints_hide_slack(TinkerConstraints *constraints);

/* How many rows depend on others, at the rows evaluated last. */
int32_t tinker_constraints_count_dependent(TinkerModel *model);
/* Adds the power that moving supports and prescribed rows give through the constraints to model->book_power, with the
 * lambda solved last. */
void tinker_constraints_add_power(TinkerModel *model);
void tinker_constraints_clear(TinkerConstraints *constraints);

/* The system that integrators see, with the reach of the states that were kept so far. Its coordinates are those of the
 * linear form where that is straight, else those of the model. */
typedef struct {
    TinkerModel *model;
    TinkerLinearForm *form; /* NULL where the model is not linear */
    TinkerSystem system;
    int32_t book_of[TINKER_BOOK_COUNT];    /* books that are integrated, in order */
    double box[4];                         /* m: least x, least y, greatest x, greatest y */
    double reach;                          /* m: of constraints with one end */
    double speed;                          /* m/s */
    double projection_work;                /* J that projections after steps have given so far */
    double impact_work[TINKER_BOOK_COUNT]; /* J that impacts have given so far, by book */
    double position_error;                 /* largest |g| relative to its length after any projection */
    double *constrained;                   /* accelerations, where only the power is asked for */
    gboolean holds_energy;                 /* `project` brings the state onto `energy` (J), too */
    double energy;
    TinkerJacobian *jacobian; /* NULL: not offered */
} TinkerModelSystem;

/* `form` is the model's own, or NULL; borrowed. */
void tinker_model_system_init(TinkerModelSystem *system, TinkerModel *model, TinkerLinearForm *form);
/* Puts the functions of straight motion in place of those of the plane. */
void tinker_straight_system_init(TinkerModelSystem *system);
void tinker_straight_system_offer_jacobian(TinkerModelSystem *system);
/* Notes the reach along the line. */
void tinker_straight_system_keep(TinkerModelSystem *system, const double *x, const double *u);
/* Whether a line is shorter in the state x than those that are watched, with supports where the model has them. */
gboolean tinker_straight_system_is_near(const TinkerModelSystem *system, const double *x);
/* The reach along the line as a box in the plane, and back. */
void tinker_straight_system_widen_box(TinkerModelSystem *system);
void tinker_straight_system_narrow_box(TinkerModelSystem *system);
/* From here on bodies may rest on plates: the system is that of the plane, and has constraints to a method that is created
 * then. What was reached and given so far stays. */
void tinker_model_system_enter_plane(TinkerModelSystem *system);
/* And back: from here on it is again that of the form, with which it began. */
void tinker_model_system_leave_plane(TinkerModelSystem *system, TinkerLinearForm *form);
/* Gives the system its pattern and jacobian, for a method that asks for them: before its stepper is created. */
void tinker_model_system_offer_jacobian(TinkerModelSystem *system);
/* Notes how far and how fast an accepted state reaches: what errors are measured against from then on. */
void tinker_model_system_keep(TinkerModelSystem *system, const double *q, const double *v);
void tinker_model_system_clear(TinkerModelSystem *system);

/* Kernels over merged lines: forces added up by point, and the power that dampers take (NULL: not asked). */
void tinker_lines_add_forces(const TinkerMergedLines *lines, const TinkerPoint *points, double *force, double *taken);
/* The lines from first to end - 1, with the forces on their second ends added up at `slots` in place of the points b;
 * answers the power that dampers take. */
double tinker_lines_add_range(const TinkerMergedLines *lines, const int32_t *slots, int32_t first, int32_t end,
                              const TinkerPoint *points, double *force);

/* Called several times an evaluation, so without a call. */
static inline TinkerStatus tinker_model_set_time(TinkerModel *model, double t)
{
    return t == model->time ? TINKER_OK : tinker_model_change_time(model, t);
}

static inline void tinker_model_set_state(TinkerModel *model, const double *q, const double *v)
{
    TinkerPoint *point = model->point;
    if (G_UNLIKELY(model->bodies >= TINKER_SHARE_LEAST)) {
        tinker_model_share_state(model, q, v);
        return;
    }
    for (int32_t i = 0; i < model->bodies; i++)
        point[i] = (TinkerPoint){q[2 * i], q[2 * i + 1], v[2 * i], v[2 * i + 1]};
}

#endif

/* What a compiled model consists of. Constant after compiling, but for the parts under "working state", which belong to
 * the one evaluation in progress.
 *
 * Symbols: q, v positions and velocities of the bodies that can move, two entries a body, relative to `origin`; f
 * forces; J rows of the constraints; lambda their multipliers; S = J M^-1 J^T.
 *
 * Points: everything that something attaches to. The first `bodies` points are the bodies' centres; the others are
 * attachments, last those to supports. Forces are added up by point, so the force on a support is known as well.
 */
#ifndef TINKER_CORE_MODEL_DATA_H
#define TINKER_CORE_MODEL_DATA_H

#include <stdatomic.h>

#include "numerics/sharing/sharing.h"
#include "numerics/solve/sparse-ldl.h"
#include "physics/model/model.h"
#include "scene/frame/batch.h"
#include "scene/frame/block-index.h"
#include "scene/frame/motions.h"

/* Instances that one call of a plugin works on: their arrays stay in the L1 cache. */
#define TINKER_CHUNK 256

/* A point that is fixed to something, and not at the centre of a body. */
typedef struct {
    TinkerBlockId block; /* that it is fixed to */
    int32_t body;        /* which of the bodies that is; -1: a support */
    double x, y;         /* of a support: with the support at its place, relative to the origin */
    gboolean moving;     /* of a support: whether it moves */
} TinkerAttachment;

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
    /* Of rows that hold in one direction only, g <= 0; NULL where there are none. Slack rows do not act: their entries
     * in the arrays below are 0, and what they would be is kept as their own. */
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
    int32_t coordinates; /* of all bodies: entries of q, v, a */
    TinkerBlockId *body_blocks;
    double *of_bodies;       /* what the next ones and constant_acceleration lie in */
    double *mass;            /* of each body */
    double *coordinate_mass; /* of each coordinate */
    double *inverse_mass;    /* of each body */
    double *q_start, *v_start;
    double start_impulse; /* N s that brought v_start onto the constraints */
    int32_t points;
    int32_t first_attachment, first_support; /* points: centres of bodies, attachments to bodies, those to supports */
    GArray *attachments;                     /* of TinkerAttachment: from point `first_attachment` on */
    TinkerBlockIndex *numbers;               /* of the batches' blocks */
    int32_t *centre_point;                   /* by number: the point of a block's centre, or -1 */
    gboolean *point_used;                    /* whether a connector or a constraint attaches to the point */
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
    double *point_acceleration; /* 2 per point; of supports kept up to date, of bodies by whoever needs it */
    double *force;              /* 2 per point, and behind them 2 per slot of the line parts */
    int32_t chunk_rows;         /* at most TINKER_CHUNK: no batch has more rows, or they are asked in several goes */
    double *chunk; /* seven columns of chunk_rows and ends of a chunk; NULL in a part that asks no plugin */
    const double **column_views; /* room for the columns of any class */
    double *velocity_kept;       /* 2 a body, while differences change it (products.c) */
    int feels_velocity;          /* whether what is differenced depends on it: 1, -1: no, 0: nobody has tried */
    int32_t *chunk_offsets;      /* of the ends of a chunk, where blocks differ in their number */
    double time;                 /* that waveforms and supports were evaluated at */
    double book_power[TINKER_BOOK_COUNT];
    gint64 evaluations;
    double watched_length; /* m: whoever evaluates a line shorter than this sets ... */
    atomic_int came_near;  /* ... this, which nothing is ordered by; 0: none is watched (direction-watch.h) */
    const char *failure;   /* "", or the last one as tinker_model_tell_failure has it */
    char *failure_text;
    gboolean lacks_memory; /* so that it cannot be compiled, or go on */
};

/* Where a point is at the start, relative to the origin; of supports where they are unmoved. */
void tinker_model_start_place(const TinkerModel *model, int32_t point, double place[2]);

/* An attachment: a point from `first_attachment` on. */
static inline TinkerAttachment *tinker_model_attachment(const TinkerModel *model, int32_t point)
{
    return &g_array_index(model->attachments, TinkerAttachment, (guint)(point - model->first_attachment));
}

/* The body that a point is fixed to; -1: a support. */
static inline int32_t tinker_model_body_of(const TinkerModel *model, int32_t point)
{
    return point < model->bodies ? point : tinker_model_attachment(model, point)->body;
}

/* The block that a point is fixed to. */
static inline TinkerBlockId tinker_model_block_of(const TinkerModel *model, int32_t point)
{
    return point < model->bodies ? model->body_blocks[point] : tinker_model_attachment(model, point)->block;
}

/* The point of a block's centre; -1 where it has none, or is not of the model. */
static inline int32_t tinker_model_centre(const TinkerModel *model, TinkerBlockId block)
{
    const int32_t number = tinker_block_index_find(model->numbers, block);
    return number < 0 ? -1 : model->centre_point[number];
}

/* The points of a batch's ends, or NULL. */
const int32_t *tinker_model_end_points(const TinkerModel *model, const TinkerBlockBatch *batch);

/* A view of `count` rows of a batch from `first` on, for a call of its plugin. `columns` has room for the class's
 * columns. */
TinkerBatch tinker_model_view(const TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                              const double **columns);

/* Writes a failure down, in place of the last one. */
void tinker_model_tell_failure(TinkerModel *model, const char *format, ...) G_GNUC_PRINTF(2, 3);

/* Records that a plugin failed in its callback `what`. Answers TINKER_FAILED. */
TinkerStatus tinker_model_fail(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what,
                               const char *why);

/* Looks whether a plugin wrote beyond the memory that it was given (plugin/guarded.h). TINKER_FAILED and its name where
 * one did. */
TinkerStatus tinker_model_check_guards(TinkerModel *model);

/* Records that `what` of a block is not a finite number. Answers TINKER_RETRY_SMALLER: a trial that reached too far may
 * be cut; a method that cannot do so stops with what was recorded. */
TinkerStatus tinker_model_not_finite(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what);

/* The place of a book among those that are integrated; -1 where it is none. */
int32_t tinker_model_book_index(const TinkerModel *model, TinkerBook book);

/* Dynamics. All q and v are relative to the origin. */

/* Brings waveforms, moving supports and their points to time t; does nothing where they are there already. */
static inline TinkerStatus tinker_model_set_time(TinkerModel *model, double t);
/* Brings the model to a time that is another one than the present. */
TinkerStatus tinker_model_change_time(TinkerModel *model, double t);

/* Packs q and v into the points. */
static inline void tinker_model_set_state(TinkerModel *model, const double *q, const double *v);
/* Packs q and v into the points, shared among threads. */
void tinker_model_share_state(TinkerModel *model, const double *q, const double *v);

/* Lines shorter than this (m; 0: none) are noted from now on. */
static inline void tinker_model_watch_lines(TinkerModel *model, double length)
{
    model->watched_length = length;
    model->lines.watched_square = length * length;
    model->lines.came_near = &model->came_near;
}

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

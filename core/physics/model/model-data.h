/* What a compiled model consists of. Constant after compiling, but for the parts under "working state", which belong to
 * the one evaluation in progress.
 *
 * Symbols: q, v positions and velocities of the bodies that can move, by coordinate, relative to `origin`; f forces.
 *
 * Coordinates: x and y of body i are 2 i and 2 i + 1; those of all bodies come first. Behind them each body that turns
 * has a third one, k * angle with k = (inertia / mass)^1/2, its radius of gyration: a length, which the body's mass
 * moves along as it does along x and y.
 *
 * Points: everything that something attaches to. The first `bodies` points are the bodies' centres; the last ones are
 * attachments: places of bodies that turn, off their centres, then those of supports. Between both stand points that
 * nothing attaches to, one for two bodies that turn, so that any vector by point (two entries a point: accelerations,
 * forces) begins with the coordinates: what belongs to coordinate c is its entry c.
 */
#ifndef TINKER_CORE_MODEL_DATA_H
#define TINKER_CORE_MODEL_DATA_H

#include <stdatomic.h>

#include "physics/model/constraint-data.h"
#include "physics/model/model.h"
#include "scene/frame/block-index.h"
#include "scene/frame/motions.h"

/* Instances that one call of a plugin works on: their arrays stay in the L1 cache. */
#define TINKER_CHUNK 256

/* A point that is fixed to a body off its centre, or to a support. Blocks that speak of angles have a turn beside each
 * end: a point that is no place, whose x is the angle (rad) of what the end is on, vx its rate, the x of its
 * acceleration the angular one, and what acts along it a torque. So whoever goes from points to coordinates has turns
 * as well. */
typedef struct {
    TinkerBlockId block; /* that it is fixed to */
    int32_t body;        /* which of the bodies that is; -1: a support */
    double x, y;         /* of a body: from its centre, in its own axes; of a support: with the support at its place */
    gboolean turn;       /* it is a turn; of a support x is how that is turned unmoved */
    gboolean moving;     /* of a support: whether it moves */
    double arm[2];       /* from the centre: of a body, now; of a support, unmoved */
    double force[2];     /* what the applied forces were there that were evaluated last */
} TinkerAttachment;

/* A body that turns. Its coordinate is 2 * bodies + its number among those that do. */
typedef struct {
    int32_t body;
    double gyration;     /* m */
    double by_gyration;  /* 1/m: its reciprocal */
    double speed;        /* m/s: along its coordinate, now */
    double rate;         /* rad/s: speed / gyration */
    double place;        /* m: along its coordinate, now; not a number as long as nobody has set it */
    double angle;        /* rad, counting turns: now */
    double cosine, sine; /* of it */
    double x, y;         /* where the body's centre was when its attachments were last put where they are */
    int32_t first_attachment, end_attachment; /* the points of what is attached to the body */
} TinkerTurn;

/* Linear laws between the same two points, merged:
 * T = tension + stiffness * (L - length) + damping * rate. Columns, so that kernels load them four at a time. */
typedef struct {
    int32_t count;
    int32_t *a, *b;
    double *stiffness, *length, *damping, *tension; /* the first is what all of them lie in */
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
    TinkerAngles *angles; /* of a force element that speaks of them; else NULL. Borrowed. */
} TinkerAskedBatch;

/* A force that does not depend on the state: value of a waveform * direction at one point. */
typedef struct {
    int32_t point;
    double direction[2];
    const double *value; /* the waveform's column, this block's entry */
    const TinkerBlockBatch *batch;
    int32_t row;
} TinkerDrivenForce;

typedef struct _TinkerContacts TinkerContacts;

struct _TinkerModel {
    TinkerScene *scene;
    gboolean part;         /* of the scene: other bodies of it are in other models */
    GPtrArray *batches;    /* of TinkerBlockBatch */
    int32_t **end_points;  /* of each batch, by batch; NULL for one without ends. In one piece of memory. */
    TinkerAngles **angles; /* of each batch, by batch; NULL for one that knows none. NULL where all know none */
    GPtrArray *warnings;   /* of TinkerWarning * */
    double origin[2];

    /* bodies and points */
    int32_t bodies;
    int32_t turning;     /* bodies that turn */
    int32_t coordinates; /* 2 * bodies + turning */
    TinkerTurn *turns;
    int32_t *turn_of; /* of each body: its number among those that turn, or -1; NULL where none does */
    TinkerBlockId *body_blocks;
    double *of_bodies;       /* what the next ones and constant_acceleration lie in */
    double *mass;            /* of each body */
    double *coordinate_mass; /* of each coordinate */
    double *inverse_mass;    /* of each body */
    double *q_start, *v_start;
    double start_impulse;   /* N s that brought v_start onto the constraints */
    gboolean start_changed; /* by more than TINKER_START_MISS of the fastest: it is told */
    int32_t points;
    int32_t first_attachment, first_support;
    GArray
        *attachments; /* of TinkerAttachment: from point `first_attachment` on; of supports from `first_support` on */
    TinkerBlockIndex *numbers; /* of the batches' blocks */
    int32_t *centre_point;     /* by number: the point of a block's centre, or -1 */
    gboolean *point_used;      /* whether a connector or a constraint attaches to the point */
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
    gboolean turned;            /* some body, since the constraints were evaluated */
    TinkerPoint *point;         /* with point_acceleration and point_used behind it */
    double *point_acceleration; /* 2 per point; of supports kept up to date, of bodies by whoever needs it */
    double *force;              /* 2 per point, and behind them 2 per slot of the line parts */
    int32_t chunk_rows;         /* at most TINKER_CHUNK: no batch has more rows, or they are asked in several goes */
    double *chunk; /* seven columns of chunk_rows and ends of a chunk; NULL in a part that asks no plugin */
    const double **column_views; /* room for the columns of any class */
    double *velocity_kept;       /* by coordinate, while differences change it (products.c); and room for as much */
    int feels_velocity;          /* whether what is differenced depends on it: 1, -1: no, 0: nobody has tried */
    int32_t *chunk_offsets;      /* of the ends of a chunk, where blocks differ in their number */
    double time;                 /* that waveforms and supports were evaluated at */
    double book_power[TINKER_BOOK_COUNT];
    gint64 evaluations;
    gint64 corrections;    /* Newton steps by which positions came back onto constraint rows */
    double watched_length; /* m: whoever evaluates a line shorter than this sets ... */
    atomic_int came_near;  /* ... this, which nothing is ordered by; 0: none is watched (direction-watch.h) */
    const char *failure;   /* "", or the last one as tinker_model_tell_failure has it */
    char *failure_text;
    gboolean lacks_memory; /* so that it cannot be compiled, or go on */
};

/* The points of a batch's ends, or NULL. */
const int32_t *tinker_model_end_points(const TinkerModel *model, const TinkerBlockBatch *batch);

/* A view of `count` rows of a batch from `first` on, for a call of its plugin. `columns` has room for the class's
 * columns. */
TinkerBatch tinker_model_view(const TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                              const double **columns);

/* The place of a book among those that are integrated; -1 where it is none. */
int32_t tinker_model_book_index(const TinkerModel *model, TinkerBook book);

/* Lines shorter than this (m; 0: none) are noted from now on. */
static inline void tinker_model_watch_lines(TinkerModel *model, double length)
{
    model->watched_length = length;
    model->lines.watched_square = length * length;
    model->lines.came_near = &model->came_near;
}

#endif

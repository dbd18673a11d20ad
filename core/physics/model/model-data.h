/* What a compiled model consists of. Constant after compiling, but for the parts under "working state", which belong to
 * the one evaluation in progress.
 *
 * Symbols: q, v positions and velocities of the bodies that can move, by coordinate, relative to `origin`; f forces; J
 * rows of the constraints; lambda their multipliers; S = J M^-1 J^T.
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

#include "numerics/sharing/sharing.h"
#include "numerics/solve/sparse-ldl.h"
#include "physics/model/model.h"
#include "scene/frame/batch.h"
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

/* One entry of a row or a column over coordinates. */
typedef struct {
    int32_t coordinate;
    double value;
} TinkerCoordinateEntry;

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

/* What a batch that speaks of angles has of its ends beside their points (angles.h). */
typedef struct _TinkerAngles TinkerAngles;

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

/* One class of constraints: its rows and entries lie behind one another in the model's arrays. */
typedef struct {
    TinkerBlockBatch *batch;
    const TinkerConstraint *constraint;
    const int32_t *end_points;
    int32_t first_row, row_count;
    int32_t first_entry;  /* an entry is one end of one row, or its turn: those of a row stand behind its ends */
    TinkerAngles *angles; /* of rows that depend on them; else NULL. Borrowed. */
    double *distances;    /* of rows that keep a constant distance, which the host works out: one each; else NULL */
    gboolean coincident;  /* their ends coincide, which the host works out */
    TinkerBatch view;     /* of the whole batch */
} TinkerConstraintBatch;

typedef struct _TinkerRowChains TinkerRowChains;
typedef struct _TinkerPinChains TinkerPinChains;

/* An entry on a body that turns: what the row has beside it in the column of that body's turn. */
typedef struct {
    int32_t entry, row;
    int32_t attachment; /* where on the body */
    int32_t turn;       /* the body's number among those that turn */
    int32_t coordinate; /* its turn's */
} TinkerTurnEntry;

/* One product that is added up in S: inverse mass * J of one entry . J of another, on the same body. */
typedef struct {
    int32_t slot, first_entry, second_entry;
    double inverse_mass;
} TinkerProduct;

/* A row that holds nothing, and its slot on the diagonal of S. */
typedef struct {
    int32_t row, slot;
} TinkerIdleRow;

/* A row that repeats `first`, which stands before it, sign times (repeated-rows.h). */
typedef struct {
    int32_t row, first;
    int32_t copies; /* rows that say so, with the first */
    double sign;
    int32_t slot, first_slot; /* of both on the diagonal of S */
} TinkerRepeatedRow;

/* What a row has on a hub, a body that S leaves out: by its number in a Jacobian, in the column of one of the unknowns
 * behind the rows. */
typedef struct {
    int32_t row, unknown, entry, slot;
} TinkerHubEntry;

typedef struct {
    int32_t slot; /* of such an unknown on the diagonal */
    double mass;  /* kg: of its body */
} TinkerHubMass;

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
    int32_t *points;                     /* of each entry: the centre of its body, or the point of a support */
    int32_t *ends_at;                    /* of each entry: the point itself; the array above where none turns */
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
    TinkerIdleRow *idle; /* room for every row */
    int32_t idle_count;
    TinkerRepeatedRow *repeated; /* in the order of `first`, then of `row` */
    int32_t repeated_count;
    gboolean *repeats; /* by row; NULL where none does */
    int32_t *hubs;     /* of each body: the first unknown of its own, behind the rows; 0: it has none. NULL: no body */
    int32_t border;    /* unknowns of hubs */
    TinkerHubEntry *hub_entries;
    int32_t hub_entry_count;
    TinkerHubMass *hub_masses; /* of each of these unknowns */
    double *bordered;          /* working state: a right-hand side with them */
    TinkerProduct *products;
    gsize product_count;
    TinkerTurnEntry *turns; /* in the order of the rows */
    int32_t turn_count;
    int32_t *turn_starts;         /* rows + 1: where those of each row begin; NULL where nothing turns */
    TinkerProduct *turn_products; /* of two turns' entries, by their numbers in a Jacobian */
    gsize turn_product_count;
    gsize jacobian_size; /* numbers in a Jacobian: two an entry, then one for each of `turns` */
    TinkerSparseLdl *ldl;
    TinkerRowChains *chains;     /* of rows that hang together in chains alone; else NULL */
    TinkerPinChains *pin_chains; /* of blocks whose ends coincide that do; else NULL */
    double work;       /* J: what the last projection of positions gave, by the applied forces evaluated last */
    gboolean gave_way; /* a projection stopped short at a singular place; whoever reports it clears it */
    int32_t redundant; /* rows that depend on others at the start, with those that repeat one: told to users */
    int32_t dependent; /* without those */
    double shift;      /* of it: a share of the diagonal of S */
    int32_t rounds;    /* that a proximal solve takes, by one for any motion at the start; 0: none is */

    /* working state */
    TinkerPoint *ends; /* gathered, of the largest batch */
    double *jacobian;
    double *g, *drift, *rate;
    double miss; /* the largest |g| relative to its row's length */
    double *lambda, *residual, *correction;
    double *asked;           /* of each row: the change of speed that a projection asks for */
    double *by_point;        /* 2 per point */
    double *turned;          /* RATTLE: the Jacobian at the start of the step */
    double *displacement;    /* of a Newton step: 2 per body */
    int32_t rounds_taken;    /* by the last proximal solve */
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
    gboolean part;          /* of the scene: other bodies of it are in other models */
    GPtrArray *batches;     /* of TinkerBlockBatch */
    int32_t **end_points;   /* of each batch, by batch; NULL for one without ends. In one piece of memory. */
    TinkerAngles **angles;  /* of each batch, by batch; NULL for one that knows none. NULL where all know none */
    GPtrArray *warnings;    /* of char * */
    guint overlap_warnings; /* of these the last so many tell of shapes that overlap at the start */
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

/* How a body turns; NULL where it does not. */
static inline const TinkerTurn *tinker_model_turn(const TinkerModel *model, int32_t body)
{
    const int32_t turn = model->turn_of != NULL ? model->turn_of[body] : -1;
    return turn < 0 ? NULL : &model->turns[turn];
}

/* The coordinate that a body turns by; -1 where it does not. */
static inline int32_t tinker_model_turn_of(const TinkerModel *model, int32_t body)
{
    const TinkerTurn *turn = tinker_model_turn(model, body);
    return turn == NULL ? -1 : 2 * model->bodies + (int32_t)(turn - model->turns);
}

/* The body that moves along a coordinate. */
static inline int32_t tinker_model_moved_by(const TinkerModel *model, int32_t coordinate)
{
    return coordinate < 2 * model->bodies ? coordinate / 2 : model->turns[coordinate - 2 * model->bodies].body;
}

/* What a vector by coordinate means for a point: of velocities its velocity, of displacements its displacement. */
static inline void tinker_model_at_point(const TinkerModel *model, int32_t point, const double *by_coordinate,
                                         double out[2])
{
    const int32_t body = tinker_model_body_of(model, point);
    out[0] = out[1] = 0;
    if (body < 0) return;
    out[0] = by_coordinate[2 * body];
    out[1] = by_coordinate[2 * body + 1];
    if (point == body) return;
    const int32_t number = model->turn_of[body];
    const double turned = by_coordinate[2 * model->bodies + number] / model->turns[number].gyration;
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    if (at->turn) {
        out[0] = turned;
        out[1] = 0;
        return;
    }
    out[0] -= turned * at->arm[1];
    out[1] += turned * at->arm[0];
}

/* How the x (axis 0) or y (1) of a point depends on the coordinates, for the state set last; of a support on its own
 * entries in a vector by point. Answers how many entries there are. */
static inline int32_t tinker_model_point_entries(const TinkerModel *model, int32_t point, int axis,
                                                 TinkerCoordinateEntry list[2])
{
    if (point < model->bodies || point >= model->first_support) {
        list[0] = (TinkerCoordinateEntry){2 * point + axis, 1};
        return 1;
    }
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    const int32_t number = model->turn_of[at->body];
    if (at->turn) {
        list[0] = (TinkerCoordinateEntry){2 * model->bodies + number, 1 / model->turns[number].gyration};
        return axis == 0 ? 1 : 0;
    }
    const double arm = axis == 0 ? -at->arm[1] : at->arm[0];
    list[0] = (TinkerCoordinateEntry){2 * at->body + axis, 1};
    list[1] = (TinkerCoordinateEntry){2 * model->bodies + number, arm / model->turns[number].gyration};
    return 2;
}

/* What a vector by coordinate says of a body's turning: of places its angle (rad, counting turns), of velocities its
 * rate (rad/s); 0 where it does not turn. */
static inline double tinker_model_angle(const TinkerModel *model, int32_t body, const double *by_coordinate)
{
    const int32_t at = tinker_model_turn_of(model, body);
    return at < 0 ? 0 : by_coordinate[at] / model->turns[at - 2 * model->bodies].gyration;
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
/* Places alone; and velocities alone, of places that were set before. */
void tinker_model_set_places(TinkerModel *model, const double *q);
void tinker_model_set_velocities(TinkerModel *model, const double *v);
/* The other way: point_acceleration of attachments to bodies, from that of the coordinates; and force of the
 * coordinates, which gets what acts on attachments to bodies. */
void tinker_model_accelerate_attachments(TinkerModel *model);
void tinker_model_reduce_forces(TinkerModel *model);
/* The part of a state that belongs to bodies that turn. Called by the functions above. */
void tinker_model_set_turns(TinkerModel *model, const double *q, const double *v);
/* Angles alone, of places that were set before: attachments to bodies are put where they are then. */
void tinker_model_set_angles(TinkerModel *model, const double *q);
/* Whether the angles set last are those of q. */
gboolean tinker_model_has_angles(const TinkerModel *model, const double *q);
/* Packs q and v into the points: of many bodies, shared among threads, or of some that turn. */
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
    if (G_UNLIKELY(model->bodies >= TINKER_SHARE_LEAST || model->turning > 0)) {
        tinker_model_share_state(model, q, v);
        return;
    }
    for (int32_t i = 0; i < model->bodies; i++)
        point[i] = (TinkerPoint){q[2 * i], q[2 * i + 1], v[2 * i], v[2 * i + 1]};
}

#endif

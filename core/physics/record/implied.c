/* Between two points: with d = x_b - x_a and w = v_b - v_a the angle is atan2(d_y, d_x), its rate (d x w) / |d|^2; of
 * what is about turning, theta_b - theta_a and omega_b - omega_a. */
#include "physics/record/implied.h"

#include <math.h>

#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/record/columns.h"
#include "physics/system/books.h"

typedef struct {
    guint column;
    TinkerBlockId block;
    int32_t number;
    int32_t a, b; /* points */
    gboolean about_turning;
    double orientations[2]; /* rad: of the supports that they are on, as placed; 0 of what is on a body */
} Wanted;

struct _TinkerImplied {
    TinkerModel *model;
    GArray *wanted; /* of Wanted */
    gboolean energies;
};

/* The batch that a block is of, and its row in it; NULL where it has none. */
static const TinkerBlockBatch *find_batch(const TinkerModel *model, TinkerBlockId block, int32_t *row)
{
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->block_class != tinker_scene_block_class(model->scene, block)) continue;
        for (*row = 0; *row < batch->count; (*row)++)
            if (batch->ids[*row] == block) return batch;
    }
    return NULL;
}

static double placed_orientation(const TinkerModel *model, int32_t point)
{
    int32_t row;
    if (tinker_model_body_of(model, point) >= 0) return 0;
    const TinkerBlockBatch *batch = find_batch(model, tinker_model_block_of(model, point), &row);
    return batch != NULL ? tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0) : 0;
}

/* The points at the two ends of a block. */
static gboolean find_ends(const TinkerModel *model, TinkerBlockId block, Wanted *wanted)
{
    int32_t row;
    const TinkerBlockBatch *batch = find_batch(model, block, &row);
    const int32_t *points = batch != NULL ? tinker_model_end_points(model, batch) : NULL;
    if (points == NULL) return FALSE;
    wanted->a = points[2 * row];
    wanted->b = points[2 * row + 1];
    wanted->about_turning =
        wanted->number != TINKER_IMPLIED_LENGTH && tinker_block_class_is_about_turning(batch->block_class);
    if (!wanted->about_turning) return TRUE;
    wanted->orientations[0] = placed_orientation(model, wanted->a);
    wanted->orientations[1] = placed_orientation(model, wanted->b);
    return TRUE;
}

static gboolean find_points(const TinkerModel *model, const TinkerColumn *column, Wanted *wanted)
{
    if (column->block == TINKER_NO_BLOCK) return TRUE;
    if (column->quantity == TINKER_IMPLIED_PATH_LENGTH) return FALSE; /* which is not the state's */
    if (column->quantity < TINKER_IMPLIED_DISTANCE) return find_ends(model, column->block, wanted);
    wanted->a = tinker_model_centre(model, column->block);
    wanted->b = tinker_model_centre(model, tinker_quantity_other(column->quantity));
    return wanted->a >= 0 && wanted->b >= 0;
}

TinkerImplied *tinker_implied_new(TinkerModel *model, const GArray *columns)
{
    TinkerImplied *implied = g_new0(TinkerImplied, 1);
    implied->model = model;
    implied->wanted = g_array_new(FALSE, FALSE, sizeof(Wanted));
    for (guint c = 0; columns != NULL && c < columns->len; c++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, c);
        Wanted wanted = {.column = c, .block = column->block, .number = column->quantity};
        if (column->block != TINKER_NO_BLOCK && column->quantity < TINKER_IMPLIED_LENGTH) continue;
        if (!find_points(model, column, &wanted)) continue;
        implied->energies |= column->block == TINKER_NO_BLOCK && column->quantity <= TINKER_SCENE_TOTAL;
        g_array_append_val(implied->wanted, wanted);
    }
    if (implied->wanted->len == 0) g_clear_pointer(&implied, tinker_implied_free);
    return implied;
}

void tinker_implied_free(TinkerImplied *implied)
{
    if (implied == NULL) return;
    g_array_unref(implied->wanted);
    g_free(implied);
}

/* The angle of what a point is on, or its rate. */
static double turn_of(const TinkerModel *model, int32_t point, double orientation, gboolean rate, const double *q,
                      const double *v)
{
    const int32_t body = tinker_model_body_of(model, point);
    if (body >= 0) return tinker_model_angle(model, body, rate ? v : q);
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    if (!at->moving) return rate ? 0 : orientation;
    const TinkerPlace *place = tinker_motions_place(model->motions, at->block);
    return rate ? place->rate : orientation + place->angle;
}

static double turned_between(const TinkerModel *model, const Wanted *wanted, const double *q, const double *v)
{
    const gboolean rate = wanted->number == TINKER_IMPLIED_ANGLE_RATE;
    return turn_of(model, wanted->b, wanted->orientations[1], rate, q, v) -
           turn_of(model, wanted->a, wanted->orientations[0], rate, q, v);
}

static double of_pair(const TinkerModel *model, const Wanted *wanted)
{
    const TinkerPoint *a = &model->point[wanted->a], *b = &model->point[wanted->b];
    double dx = b->x - a->x, dy = b->y - a->y, length = hypot(dx, dy);
    if (wanted->number == TINKER_IMPLIED_ANGLE) return atan2(dy, dx);
    if (wanted->number != TINKER_IMPLIED_ANGLE_RATE) return length;
    if (length == 0) return 0;
    return (dx / length * (b->vy - a->vy) - dy / length * (b->vx - a->vx)) / length;
}

static double momentum(const TinkerModel *model, gboolean of_y)
{
    double sum = 0;
    for (int32_t i = 0; i < model->bodies; i++)
        sum += model->mass[i] * (of_y ? model->point[i].vy : model->point[i].vx);
    return sum;
}

static double of_scene(const TinkerModel *model, const TinkerEnergy *energy, int32_t number)
{
    switch (number) {
    case TINKER_SCENE_KINETIC:
        return energy->kinetic;
    case TINKER_SCENE_POTENTIAL:
        return energy->in_fields + tinker_books_potential_of_origin(model);
    case TINKER_SCENE_STORED:
        return energy->potential - energy->in_fields;
    case TINKER_SCENE_TOTAL:
        return energy->kinetic + energy->potential + tinker_books_potential_of_origin(model);
    case TINKER_SCENE_X_MOMENTUM:
    case TINKER_SCENE_Y_MOMENTUM:
        return momentum(model, number == TINKER_SCENE_Y_MOMENTUM);
    default:
        return 0; /* of the run, not of the state */
    }
}

TinkerStatus tinker_implied_values(const TinkerImplied *implied, const double *q, const double *v, double *values)
{
    const TinkerModel *model = implied->model;
    TinkerEnergy energy = {0};
    TinkerStatus status = implied->energies ? tinker_model_energy(implied->model, &energy) : TINKER_OK;
    for (guint i = 0; status == TINKER_OK && i < implied->wanted->len; i++) {
        const Wanted *wanted = &g_array_index(implied->wanted, Wanted, i);
        values[wanted->column] = wanted->block == TINKER_NO_BLOCK ? of_scene(model, &energy, wanted->number)
                                 : wanted->about_turning          ? turned_between(model, wanted, q, v)
                                                                  : of_pair(model, wanted);
    }
    return status;
}

/* Between two points: with d = x_b - x_a and w = v_b - v_a the angle is atan2(d_y, d_x), its rate (d x w) / |d|^2. */
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
} Wanted;

struct _TinkerImplied {
    TinkerModel *model;
    GArray *wanted; /* of Wanted */
    gboolean energies;
};

/* The points at the two ends of a block. */
static gboolean find_ends(const TinkerModel *model, TinkerBlockId block, Wanted *wanted)
{
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->block_class != tinker_scene_block_class(model->scene, block)) continue;
        const int32_t *points = tinker_model_end_points(model, batch);
        for (int32_t row = 0; points != NULL && row < batch->count; row++) {
            if (batch->ids[row] != block) continue;
            wanted->a = points[2 * row];
            wanted->b = points[2 * row + 1];
            return TRUE;
        }
    }
    return FALSE;
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
        Wanted wanted = {c, column->block, column->quantity, 0, 0};
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

TinkerStatus tinker_implied_values(const TinkerImplied *implied, double *values)
{
    TinkerEnergy energy = {0};
    TinkerStatus status = implied->energies ? tinker_model_energy(implied->model, &energy) : TINKER_OK;
    for (guint i = 0; status == TINKER_OK && i < implied->wanted->len; i++) {
        const Wanted *wanted = &g_array_index(implied->wanted, Wanted, i);
        values[wanted->column] = wanted->block == TINKER_NO_BLOCK ? of_scene(implied->model, &energy, wanted->number)
                                                                  : of_pair(implied->model, wanted);
    }
    return status;
}

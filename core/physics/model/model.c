/* What can be asked of a compiled model. */
#include <math.h>

#include "physics/model/model-data.h"

/* Two runs may fail on two threads at once, and what G_DEFINE_QUARK keeps would be written by both. */
GQuark tinker_model_error_quark(void)
{
    return g_quark_from_static_string("tinker-model-error-quark");
}

const GPtrArray *tinker_model_warnings(const TinkerModel *model)
{
    return model->warnings;
}

void tinker_model_start_place(const TinkerModel *model, int32_t point, double place[2])
{
    if (point < model->bodies) {
        place[0] = model->q_start[2 * point];
        place[1] = model->q_start[2 * point + 1];
        return;
    }
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    place[0] = at->x;
    place[1] = at->y;
    if (at->body < 0) return;
    const double angle = tinker_model_angle(model, at->body, model->q_start), c = cos(angle), s = sin(angle);
    if (at->turn) {
        place[0] = angle;
        return;
    }
    place[0] = model->q_start[2 * at->body] + c * at->x - s * at->y;
    place[1] = model->q_start[2 * at->body + 1] + s * at->x + c * at->y;
}

const int32_t *tinker_model_end_points(const TinkerModel *model, const TinkerBlockBatch *batch)
{
    guint number;
    if (!g_ptr_array_find(model->batches, batch, &number)) return NULL;
    return model->end_points[number];
}

int32_t tinker_model_book_index(const TinkerModel *model, TinkerBook book)
{
    int32_t index = 0;
    for (TinkerBook before = 0; before < book; before++)
        if (model->has_book[before]) index++;
    return model->has_book[book] ? index : -1;
}

static int32_t count_asked(const GArray *batches)
{
    int32_t count = 0;
    for (guint i = 0; i < batches->len; i++)
        count += g_array_index(batches, TinkerAskedBatch, i).batch->count;
    return count;
}

TinkerModelSizes tinker_model_sizes(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    return (TinkerModelSizes){
        .bodies = model->bodies,
        .turning = model->turning,
        .coordinates = model->coordinates,
        .degrees_of_freedom = model->coordinates - (all->rows - all->idle_count - all->redundant),
        .constraint_rows = all->rows - all->idle_count,
        .redundant_rows = all->redundant,
        .merged_lines = model->lines.count,
        .nonlinear_lines = count_asked(model->asked_lines),
        .moving_supports = model->moving_supports,
    };
}

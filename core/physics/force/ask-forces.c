/* Plugins are asked for the forces of their blocks: of lines by their lengths and rates, of force elements by the
 * places of their ends, of fields by those of all bodies. Whoever adds forces up and whoever tells them apart asks
 * here. */
#include <math.h>

#include "physics/force/forces.h"
#include "physics/model/angles.h"
#include "physics/model/failures.h"

TinkerStatus tinker_model_refuse_forces(TinkerModel *model, const TinkerBlockBatch *batch, const TinkerBatch *view,
                                        TinkerStatus status, const char *what)
{
    if (status == TINKER_RETRY_SMALLER && view->failure == NULL) return status;
    const TinkerStatus failed =
        tinker_model_fail(model, batch, view->first + MAX(view->failed_instance, 0), what, view->failure);
    return status == TINKER_RETRY_SMALLER ? status : failed; // a number that is no status is a failure
}

/* Lines ------------------------------------------------------------------------------------------------------------ */

static TinkerLineChunk line_chunk(const TinkerModel *model)
{
    double *c = model->chunk;
    const int32_t n = model->chunk_rows;
    return (TinkerLineChunk){c, c + n, c + 2 * n, c + 3 * n, c + 4 * n, c + 5 * n};
}

static void chunk_geometry(TinkerModel *model, const int32_t *points, int32_t count, const TinkerLineChunk *chunk)
{
    for (int32_t i = 0; i < count; i++) {
        const TinkerPoint *a = &model->point[points[2 * i]], *b = &model->point[points[2 * i + 1]];
        double dx = b->x - a->x, dy = b->y - a->y, square = dx * dx + dy * dy;
        double length = sqrt(square), inverse = square > 0 ? 1.0 / length : 0.0;
        chunk->length[i] = length;
        if (length < model->watched_length) atomic_store_explicit(&model->came_near, TRUE, memory_order_relaxed);
        chunk->x[i] = dx * inverse;
        chunk->y[i] = dy * inverse;
        chunk->rate[i] = chunk->x[i] * (b->vx - a->vx) + chunk->y[i] * (b->vy - a->vy);
    }
}

TinkerStatus tinker_model_ask_lines(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                    TinkerBatch *view, TinkerLineChunk *chunk)
{
    *chunk = line_chunk(model);
    chunk_geometry(model, points, view->count, chunk);
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    TinkerStatus status =
        TINKER_CALL_BATCH(batch, "tension", view, law->tension(view, chunk->length, chunk->rate, chunk->tension));
    if (status != TINKER_OK) return tinker_model_refuse_forces(model, batch, view, status, "tension");
    for (int32_t i = 0; i < view->count; i++)
        if (!isfinite(chunk->tension[i] * chunk->x[i] + chunk->tension[i] * chunk->y[i]))
            return tinker_model_not_finite(model, batch, view->first + i, "tension");
    return TINKER_OK;
}

/* Force elements --------------------------------------------------------------------------------------------------- */

static int32_t row_of_end(const TinkerBlockBatch *batch, int32_t end)
{
    int32_t row = 0;
    while (batch->end_offsets[row + 1] <= end)
        row++;
    return row;
}

TinkerStatus tinker_model_ask_element(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                      int32_t first, int32_t count, TinkerElementForces *answer)
{
    TinkerAngles *angles = tinker_model_angles(model, batch);
    int32_t from = batch->end_offsets[first], ends = batch->end_offsets[first + count] - from;
    TinkerPoint *gathered = (TinkerPoint *)(void *)model->chunk;
    double *force = (double *)(void *)(gathered + ends);
    for (int32_t e = 0; e < ends; e++)
        gathered[e] = model->point[points[e]];
    TinkerBatch view = tinker_model_view(model, batch, first, count, model->column_views);
    const TinkerForceElement *element = batch->block_class->physics->force_element;
    if (angles != NULL) {
        tinker_angles_gather(angles, model, from, ends);
        tinker_angles_show(angles, &view, from, ends);
    }
    TinkerStatus status = TINKER_CALL_BATCH(batch, "force", &view, element->force(&view, gathered, force));
    if (status != TINKER_OK) return tinker_model_refuse_forces(model, batch, &view, status, "force");
    for (int32_t e = 0; e < ends; e++)
        if (!isfinite(force[2 * e] + force[2 * e + 1] + (angles != NULL ? view.angular[e] : 0)))
            return tinker_model_not_finite(model, batch, row_of_end(batch, from + e), "force");
    answer->force = force;
    answer->torque = view.angular;
    answer->turns = angles != NULL ? angles->turns + from : NULL;
    return TINKER_OK;
}

TinkerStatus tinker_model_ask_element_at_rest(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                              int32_t first, int32_t count, const double **answer)
{
    const int32_t ends = batch->end_offsets[first + count] - batch->end_offsets[first];
    TinkerPoint *gathered = (TinkerPoint *)(void *)model->chunk;
    double *force = (double *)(void *)(gathered + ends);
    for (int32_t e = 0; e < ends; e++)
        gathered[e] = (TinkerPoint){.x = model->point[points[e]].x, .y = model->point[points[e]].y};
    TinkerBatch view = tinker_model_view(model, batch, first, count, model->column_views);
    const TinkerForceElement *element = batch->block_class->physics->force_element;
    TinkerStatus status = TINKER_CALL_BATCH(batch, "force", &view, element->force(&view, gathered, force));
    if (status != TINKER_OK) return tinker_model_refuse_forces(model, batch, &view, status, "force");
    for (int32_t e = 0; e < 2 * ends; e++)
        if (!isfinite(force[e])) force[e] = 0;
    *answer = force;
    return TINKER_OK;
}

/* Fields ----------------------------------------------------------------------------------------------------------- */

TinkerStatus tinker_model_ask_field(TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                                    const double **answer)
{
    double *force = model->chunk;
    TinkerBodies bodies = {sizeof(TinkerBodies), model->bodies, model->point, model->mass, 0, model->bodies};
    TinkerBatch view = tinker_model_view(model, batch, first, count, model->column_views);
    const TinkerField *field = batch->block_class->physics->field;
    TinkerStatus status = TINKER_CALL_BATCH(batch, "force", &view, field->force(&view, &bodies, force));
    if (status != TINKER_OK) return tinker_model_refuse_forces(model, batch, &view, status, "force");
    for (int32_t i = 0; i < model->bodies; i++)
        if (!isfinite(force[2 * i] + force[2 * i + 1])) return tinker_model_not_finite(model, batch, first, "force");
    *answer = force;
    return TINKER_OK;
}

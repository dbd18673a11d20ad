/* Compiling, third part: forces. Laws that are linear with constants are merged and added up once; only what is left
 * is asked for at every evaluation. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/compile/compile-lines.h"
#include "physics/compile/compile-private.h"
#include "physics/force/line-parts.h"
#include "physics/model/angles.h"
#include "physics/model/points.h"
#include "plugin/call/guarded.h"
#include "plugin/call/process-state.h"

/* Room for so many rows is enough for one that is asked again and again, for differences. */
#define LEAST_CHUNK 4

/* Bytes: of four numbers for each end and one for each block, or a block's field. */
static gsize room_for_answers(const TinkerBlockBatch *batch)
{
    const gsize numbers = 4 * (gsize)MAX(batch->end_count, 1) + (gsize)batch->count;
    return MAX(numbers * sizeof(double), (gsize)batch->count * sizeof(TinkerLinearField));
}

static gboolean lack_memory(const TinkerModel *model, GError **error)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_MEMORY,
                _("there is no memory for the forces of %d blocks"), tinker_scene_block_count(model->scene));
    return FALSE;
}

static gboolean prepare(TinkerBlockBatch *batch, GError **error)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    if (batch->law_fault != NULL) {
        g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE, batch->law_fault);
        return FALSE;
    }
    if (physics == NULL || physics->prepare == NULL) return TRUE;
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    if (TINKER_CALL_BATCH(batch, "prepare", &view, tinker_prepare(physics, &view)) == TINKER_OK) return TRUE;
    g_autofree char *why = tinker_block_batch_refusal(batch, &view, _("its plugin refuses these properties"));
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE, why);
    return FALSE;
}

/* Force elements ------------------------------------------------------------------------------------------------- */

static void add_driven(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, int32_t point,
                       const double *direction, int32_t column)
{
    TinkerDrivenForce force = {point, {direction[0], direction[1]}, &batch->columns[column][row], batch, row};
    g_array_append_val(model->driven, force);
}

/* Off the centre of a body that turns a constant force is driven by the value 1: its torque changes. */
static void add_constant(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, int32_t point,
                         const double *force)
{
    static const double one = 1;
    if (force[0] == 0 && force[1] == 0) return;
    if (point >= model->first_attachment && point < model->first_support) {
        TinkerDrivenForce driven = {point, {force[0], force[1]}, &one, batch, row};
        g_array_append_val(model->driven, driven);
        return;
    }
    if (model->constant_force == NULL) model->constant_force = g_try_new0(double, 2 * (gsize)MAX(model->points, 1));
    model->lacks_memory |= model->constant_force == NULL;
    if (model->constant_force == NULL) return;
    model->constant_force[2 * point] += force[0];
    model->constant_force[2 * point + 1] += force[1];
}

static gboolean add_linear_forces(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points, CompileWork *work)
{
    const TinkerForceElement *element = batch->block_class->physics->force_element;
    if (element->linear == NULL) return FALSE;
    gsize ends = (gsize)MAX(batch->end_count, 1);
    double *constant = tinker_compile_clear_answers(work, room_for_answers(batch)), *direction = constant + 2 * ends;
    int32_t *columns = (int32_t *)(void *)(direction + 2 * ends);
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    if (TINKER_CALL_BATCH(batch, "linear", &view, element->linear(&view, constant, direction, columns)) != TINKER_OK)
        return FALSE;
    for (int32_t row = 0; row < batch->count; row++) {
        for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++) {
            add_constant(model, batch, row, points[e], constant + 2 * e);
            if (columns[row] >= 0 && columns[row] < batch->block_class->column_count)
                add_driven(model, batch, row, points[e], direction + 2 * e, columns[row]);
        }
    }
    return TRUE;
}

/* Fields --------------------------------------------------------------------------------------------------------- */

static gboolean add_linear_fields(TinkerModel *model, TinkerBlockBatch *batch, CompileWork *work)
{
    const TinkerField *field = batch->block_class->physics->field;
    if (field->linear == NULL) return FALSE;
    TinkerLinearField *laws = tinker_compile_clear_answers(work, (gsize)batch->count * sizeof(TinkerLinearField));
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    if (TINKER_CALL_BATCH(batch, "linear", &view, field->linear(&view, laws)) != TINKER_OK) return FALSE;
    for (int32_t row = 0; row < batch->count; row++) {
        for (int k = 0; k < 2; k++) {
            model->field_acceleration[k] += laws[row].acceleration[k];
            model->field_force[k] += laws[row].force[k];
        }
        model->field_drag += laws[row].drag;
    }
    return TRUE;
}

static void add_constant_accelerations(TinkerModel *model)
{
    for (int32_t i = 0; i < model->bodies; i++)
        for (int k = 0; k < 2; k++) {
            double force = model->field_force[k];
            if (model->constant_force != NULL) force += model->constant_force[2 * i + k];
            model->constant_acceleration[2 * i + k] = model->field_acceleration[k] + force * model->inverse_mass[i];
        }
    if (model->field_force[0] != 0 || model->field_force[1] != 0 || model->field_drag != 0)
        model->has_book[TINKER_BOOK_FIELDS] = TRUE;
}

/* What each end of a force element is on. */
static void note_end_masses(const TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points)
{
    if (batch->law_count == 0) return;
    batch->end_masses = g_new(double, MAX(batch->end_count, 1));
    for (int32_t e = 0; e < batch->end_count; e++) {
        const int32_t body = points[e] < model->bodies             ? points[e]
                             : points[e] < model->first_attachment ? -1
                                                                   : tinker_model_attachment(model, points[e])->body;
        batch->end_masses[e] = body >= 0 ? model->mass[body] : INFINITY;
    }
}

/* All ------------------------------------------------------------------------------------------------------------ */

static gboolean add_batch(TinkerModel *model, TinkerBlockBatch *batch, CompileWork *work, GError **error)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    const int32_t *points = tinker_model_end_points(model, batch);
    if (!prepare(batch, error)) return FALSE;
    if (physics == NULL) return TRUE;
    if (physics->line_law != NULL && !tinker_compile_linear_lines(model, batch, points, work))
        tinker_compile_asked_lines(model, batch, points, work);
    if (physics->force_element != NULL) {
        note_end_masses(model, batch, points);
        model->has_book[physics->force_element->dissipates ? TINKER_BOOK_DAMPERS : TINKER_BOOK_MOTORS] = TRUE;
        model->has_book[TINKER_BOOK_DAMPERS] |= batch->has_law_of_velocity;
        TinkerAskedBatch asked = {batch, points,
                                  tinker_compile_stores_energy(batch, physics->force_element->energy != NULL),
                                  tinker_model_angles(model, batch)};
        if (!add_linear_forces(model, batch, points, work)) g_array_append_val(model->asked_forces, asked);
    }
    if (physics->field != NULL && !add_linear_fields(model, batch, work)) {
        TinkerAskedBatch asked = {batch, NULL, tinker_compile_stores_energy(batch, physics->field->energy != NULL),
                                  NULL};
        g_array_append_val(model->asked_fields, asked);
        model->has_book[TINKER_BOOK_FIELDS] = TRUE;
    }
    if (batch->waveforms > 0 && physics->motion == NULL) g_ptr_array_add(model->waveform_batches, batch);
    return TRUE;
}

static void mark_used_points(TinkerModel *model)
{
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        const int32_t *points = tinker_model_end_points(model, batch);
        if (physics == NULL || physics->motion != NULL) continue;
        for (int32_t e = 0; e < batch->end_count; e++)
            model->point_used[points[e]] = TRUE;
    }
    for (int32_t i = 0; i < model->bodies; i++)
        model->point_used[i] = TRUE;
}

static gboolean open_work(CompileWork *work, const TinkerModel *model)
{
    gsize lines = 1, bytes = 1;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics != NULL && physics->line_law != NULL) lines += (gsize)batch->count;
        bytes = MAX(bytes, room_for_answers(batch));
    }
    *work = (CompileWork){g_try_new(LinearLine, lines), 0, g_try_malloc(bytes)};
    return work->lines != NULL && work->answers != NULL;
}

static void close_work(CompileWork *work)
{
    g_free(work->lines);
    g_free(work->answers);
}

static gboolean add_batches(TinkerModel *model, GError **error)
{
    CompileWork work;
    gboolean done = open_work(&work, model) || lack_memory(model, error);
    for (guint i = 0; done && i < model->batches->len; i++)
        done = add_batch(model, g_ptr_array_index(model->batches, i), &work, error);
    if (done) tinker_compile_merge_lines(model, &work);
    close_work(&work);
    return done;
}

static int32_t most_ends(const TinkerModel *model)
{
    int32_t most = 2;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++)
            most = MAX(most, batch->end_offsets[row + 1] - batch->end_offsets[row]);
    }
    return most;
}

/* FALSE where there is no memory. */
static gboolean allot_chunk(TinkerModel *model)
{
    model->chunk_rows = CLAMP(tinker_batches_most_rows(model->batches), LEAST_CHUNK, TINKER_CHUNK);
    gsize doubles = (gsize)model->chunk_rows * (8 + (gsize)most_ends(model) * 6);
    doubles = MAX(doubles, 8 * (gsize)MAX(model->bodies, 1));
    model->chunk = tinker_guarded_try_new(doubles * sizeof(double), NULL);
    return model->chunk != NULL;
}

gboolean tinker_model_compile_forces(TinkerModel *model, GError **error)
{
    if (!add_batches(model, error)) return FALSE;
    model->velocity_kept = g_try_new0(double, 2 * (gsize)MAX(model->coordinates, 1));
    if (model->lacks_memory || model->velocity_kept == NULL) return lack_memory(model, error);
    model->line_parts = tinker_line_parts_new(model);
    add_constant_accelerations(model);
    mark_used_points(model);
    const guint asked = model->asked_lines->len + model->asked_forces->len + model->asked_fields->len;
    /* of a whole scene single forces may be asked for, whatever was merged */
    if ((asked > 0 || !model->part) && !allot_chunk(model)) return lack_memory(model, error);
    model->has_book[TINKER_BOOK_SUPPORT_MOTION] = model->moving_supports > 0;
    model->more_than_lines = asked > 0 || model->driven->len > 0 || model->constant_force != NULL ||
                             model->moving_supports > 0 || model->has_book[TINKER_BOOK_FIELDS];
    return TRUE;
}

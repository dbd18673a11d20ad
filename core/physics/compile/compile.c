/* Compiling a scene, in order: snapshot, lengths as placed, bodies and points, forces, constraints, start. */
#include "physics/contact/contact-pins.h"
#include "physics/contact/contacts.h"
#include "physics/force/line-parts.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/compile/compile-private.h"
#include "physics/compile/compile.h"
#include "physics/constraint/constraints.h"
#include "physics/model/angles.h"
#include "physics/model/state.h"
#include "plugin/call/guarded.h"
#include "scene/frame/idle-turns.h"
#include "scene/frame/small-wheels.h"

static gboolean refuse_placeholder(TinkerScene *scene, GError **error)
{
    TinkerBlockId block = tinker_scene_first_placeholder(scene);
    if (block == TINKER_NO_BLOCK) return FALSE;
    g_autofree char *reason = tinker_scene_missing_reason(scene, block);
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_PLUGIN, "%s: %s", tinker_scene_block_name(scene, block),
                reason);
    return TRUE;
}

/* The range of a property that was left to the scene's geometry. */
static gboolean check_placed(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row,
                             const TinkerPropertyType *property, double value, GError **error)
{
    gboolean below = (property->flags & TINKER_HAS_MINIMUM) &&
                     (value < property->hard_minimum ||
                      ((property->flags & TINKER_OPEN_MINIMUM) && value == property->hard_minimum));
    if (!below && isfinite(value)) return TRUE;
    const char *name = tinker_scene_block_name(model->scene, batch->ids[row]);
    if (property->meaning == TINKER_MEANING_RADIUS) {
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                    _("%s: what its first end is on has no radius (give the %s, or put that end on something round)"),
                    name, property->id);
        return FALSE;
    }
    if (tinker_block_class_is_wound(batch->block_class)) {
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                    _("%s: its second end lies within the radius about its first end at t = 0 (place it outside)"),
                    name);
        return FALSE;
    }
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                _("%s: its ends are %g m apart at t = 0, which its %s cannot be (place them apart, or give the %s)"),
                name, value, property->id, property->id);
    return FALSE;
}

gboolean tinker_model_resolve_placed(TinkerModel *model, GError **error)
{
    g_autoptr(TinkerFrame) placed = tinker_frame_new(model->scene, error);
    if (placed == NULL) return FALSE;
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerBlockClass *block_class = batch->block_class;
        for (int32_t p = 0; p < block_class->property_count; p++) {
            const TinkerPropertyType *property = &block_class->properties[p];
            const gboolean shaped = (property->flags & TINKER_DEFAULT_AS_SHAPED) != 0;
            if (!shaped && !(property->flags & TINKER_DEFAULT_AS_PLACED)) continue;
            int32_t column = block_class->first_columns[p];
            for (int32_t row = 0; row < batch->count; row++) {
                for (int32_t c = column; c < column + tinker_kind_columns(property->kind); c++) {
                    if (!isnan(batch->columns[c][row])) continue;
                    double value = tinker_frame_column(placed, batch->ids[row], c);
                    if (!shaped && !check_placed(model, batch, row, property, value, error)) return FALSE;
                    batch->columns[c][row] = value;
                }
            }
        }
    }
    return TRUE;
}

/* The model's first piece begins at t = 0. */
static void enter_first_piece(TinkerModel *model)
{
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->evaluator_count == 0) continue;
        tinker_block_batch_enter_behind(batch, 0.0);
        tinker_block_batch_set_time(batch, 0.0);
    }
}

/* What holds for the whole scene, whatever part of it is compiled; lengths as placed are those of the whole scene, too.
 */
static gboolean take_scene(TinkerModel *model, GError **error)
{
    if (refuse_placeholder(model->scene, error)) return FALSE;
    TinkerBlockId loose = tinker_scene_first_detached(model->scene);
    if (loose != TINKER_NO_BLOCK) {
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                    _("%s: an end is not connected (attach it to a block; nothing runs while an end is loose)"),
                    tinker_scene_block_name(model->scene, loose));
        return FALSE;
    }
    return tinker_model_resolve_placed(model, error);
}

gboolean tinker_model_compile_parts(TinkerModel *model, GError **error)
{
    enter_first_piece(model);
    if (!tinker_model_compile_bodies(model, error) || !tinker_model_compile_points(model, error) ||
        !tinker_model_compile_forces(model, error))
        return FALSE;
    if (tinker_model_set_time(model, 0.0) == TINKER_OK) {
        tinker_model_set_state(model, model->q_start, model->v_start);
        tinker_model_place_angles(model);
    }
    return tinker_model_compile_constraints(model, error);
}

static void tell_small_wheels(TinkerModel *model)
{
    g_autoptr(GArray) wheels = tinker_small_wheels_of(model->scene);
    for (guint i = 0; i < wheels->len; i++) {
        const TinkerSmallWheel *wheel = &g_array_index(wheels, TinkerSmallWheel, i);
        if (wheel->is_round)
            tinker_warnings_add(model->warnings, TINKER_WARNING_START, tinker_small_wheel_text(model->scene, wheel));
    }
}

static void tell_idle_turns(TinkerModel *model)
{
    g_autoptr(GArray) idle_turns = tinker_idle_turns_of(model->scene);
    for (guint i = 0; i < idle_turns->len; i++)
        tinker_warnings_add(model->warnings, TINKER_WARNING_START,
                            tinker_idle_turn_text(model->scene, &g_array_index(idle_turns, TinkerIdleTurn, i)));
}

static gboolean compile(TinkerModel *model, GError **error)
{
    if (!tinker_model_compile_parts(model, error)) return FALSE;
    if (!tinker_model_check_pins(model, error)) return FALSE;
    model->contacts = tinker_contacts_new(model);
    if (!tinker_model_check_start(model, error)) return FALSE;
    if (model->part) return TRUE;
    if (model->turning > 0) tell_small_wheels(model);
    tell_idle_turns(model);
    if (model->contacts == NULL) return TRUE;
    tinker_model_set_state(model, model->q_start, model->v_start);
    tinker_contacts_tell_overlaps(model->contacts, model->warnings);
    return TRUE;
}

static int32_t most_columns(const GPtrArray *batches)
{
    int32_t most = 1;
    for (guint i = 0; i < batches->len; i++)
        most = MAX(most, ((TinkerBlockBatch *)g_ptr_array_index(batches, i))->block_class->column_count);
    return most;
}

TinkerModel *tinker_model_new_of_batches(TinkerScene *scene, GPtrArray *batches)
{
    TinkerModel *model = g_new0(TinkerModel, 1);
    model->scene = scene;
    model->batches = batches;
    model->warnings = tinker_warnings_new();
    model->attachments = g_array_new(FALSE, TRUE, sizeof(TinkerAttachment));
    model->asked_lines = g_array_new(FALSE, TRUE, sizeof(TinkerAskedBatch));
    model->asked_forces = g_array_new(FALSE, TRUE, sizeof(TinkerAskedBatch));
    model->asked_fields = g_array_new(FALSE, TRUE, sizeof(TinkerAskedBatch));
    model->driven = g_array_new(FALSE, TRUE, sizeof(TinkerDrivenForce));
    model->waveform_batches = g_ptr_array_new();
    model->column_views = g_new0(const double *, most_columns(model->batches));
    model->chunk_offsets = g_new0(int32_t, tinker_batches_most_rows(model->batches) + 1);
    model->time = NAN;
    model->failure = "";
    return model;
}

TinkerModel *tinker_model_new(TinkerScene *scene, GError **error)
{
    return tinker_model_new_part(scene, NULL, error);
}

TinkerModel *tinker_model_new_part(TinkerScene *scene, const gboolean *include, GError **error)
{
    g_autoptr(TinkerModel) model = tinker_model_new_of_batches(scene, tinker_batches_new(scene, include));
    model->part = include != NULL;
    if (!take_scene(model, error) || !compile(model, error)) return NULL;
    return g_steal_pointer(&model);
}

TinkerModel *tinker_model_new_of(const TinkerModel *whole, const int32_t *numbers, int32_t count, GError **error)
{
    g_autoptr(TinkerModel) model =
        tinker_model_new_of_batches(whole->scene, tinker_batches_take(whole->batches, numbers, count));
    model->part = TRUE;
    if (!compile(model, error)) return NULL;
    return g_steal_pointer(&model);
}

void tinker_model_free(TinkerModel *model)
{
    if (model == NULL) return;
    tinker_contacts_free(model->contacts);
    tinker_constraints_clear(&model->constraints);
    tinker_line_parts_free(model->line_parts);
    tinker_motions_free(model->motions);
    tinker_block_index_free(model->numbers);
    for (guint i = 0; model->angles != NULL && i < model->batches->len; i++)
        tinker_angles_free(model->angles[i]);
    g_free(model->angles);
    g_free(model->end_points);
    g_ptr_array_unref(model->warnings);
    g_ptr_array_unref(model->waveform_batches);
    g_array_unref(model->attachments);
    g_array_unref(model->asked_lines);
    g_array_unref(model->asked_forces);
    g_array_unref(model->asked_fields);
    g_array_unref(model->driven);
    gpointer arrays[] = {model->turns,     model->turn_of,      model->failure_text,   model->body_blocks,
                         model->of_bodies, model->centre_point, model->constant_force, model->point,
                         model->force,     model->column_views, model->chunk_offsets,  model->lines.stiffness};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(model->velocity_kept);
    tinker_guarded_free(model->chunk);
    g_ptr_array_unref(model->batches);
    g_free(model);
}

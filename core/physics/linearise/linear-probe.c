/* Inputs by the linear forms of forces and motions; outputs by differences of the sampler. */
#include "physics/linearise/linear-probe.h"

#include <math.h>
#include <string.h>

#include "physics/force/forces.h"
#include "physics/linearise/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/record/columns.h"
#include "physics/record/sampler.h"

/* Inputs ----------------------------------------------------------------------------------------------------------- */

static const char *unit_of_column(const TinkerBlockClass *block_class, int32_t column)
{
    for (int32_t p = 0; p < block_class->property_count; p++) {
        const TinkerPropertyType *type = &block_class->properties[p];
        if (block_class->first_columns[p] == column)
            return tinker_block_class_si_unit(block_class, type->id, type->dimension);
    }
    return "1";
}

static int32_t column_of(const TinkerBlockBatch *batch, int32_t row, const double *value)
{
    int32_t column = 0;
    while (column < batch->block_class->column_count - 1 && &batch->columns[column][row] != value)
        column++;
    return column;
}

static gboolean find_force(const TinkerModel *model, TinkerLinearInput *input)
{
    gboolean found = FALSE;
    for (guint i = 0; i < model->driven->len; i++) {
        const TinkerDrivenForce *driven = &g_array_index(model->driven, TinkerDrivenForce, i);
        if (driven->batch->ids[driven->row] != input->block) continue;
        input->unit = unit_of_column(driven->batch->block_class, column_of(driven->batch, driven->row, driven->value));
        for (int axis = 0; axis < 2; axis++) {
            TinkerCoordinateEntry entries[2];
            const int32_t count = tinker_model_point_entries(model, driven->point, axis, entries);
            for (int32_t k = 0; k < count; k++)
                input->force[entries[k].coordinate] += driven->direction[axis] * entries[k].value;
        }
        found = TRUE;
    }
    return found;
}

/* The value of a block's waveform, which its plugin is asked with; NULL where it has none. Borrowed. */
static double *asked_value(const TinkerModel *model, TinkerBlockId block, const char **unit)
{
    for (guint i = 0; i < model->waveform_batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->waveform_batches, i);
        const TinkerBlockClass *block_class = batch->block_class;
        for (int32_t row = 0; row < batch->count; row++)
            for (int32_t p = 0; p < block_class->property_count && batch->ids[row] == block; p++) {
                if (block_class->properties[p].kind != TINKER_KIND_WAVEFORM) continue;
                *unit = unit_of_column(block_class, block_class->first_columns[p]);
                return &batch->columns[block_class->first_columns[p]][row];
            }
    }
    return NULL;
}

/* Of a force without a linear form of its own, as a torque or one that turns with its body: what the forces at these
 * places change by with the waveform. */
static gboolean find_asked(TinkerModel *model, TinkerLinearInput *input)
{
    const gsize n = (gsize)MAX(model->coordinates, 1);
    const char *unit;
    double *value = asked_value(model, input->block, &unit), step = 0;
    if (value == NULL) return FALSE;
    const double kept = *value;
    g_autofree double *with = g_new0(double, n), *without = g_new0(double, n);
    TinkerStatus status = tinker_model_applied(model, with, FALSE);
    for (int32_t i = 0; i < model->coordinates; i++)
        step = fmax(step, fabs(with[i] * model->coordinate_mass[i]));
    if (!(step > 0)) step = 1;
    *value = kept + step;
    if (status == TINKER_OK) status = tinker_model_applied(model, with, FALSE);
    *value = kept - step;
    if (status == TINKER_OK) status = tinker_model_applied(model, without, FALSE);
    *value = kept;
    gboolean found = FALSE;
    for (int32_t i = 0; i < model->coordinates && status == TINKER_OK; i++) {
        input->force[i] += model->coordinate_mass[i] * (with[i] - without[i]) / (2 * step);
        found |= with[i] != without[i];
    }
    if (found) input->unit = unit;
    return found;
}

static void move_support(const TinkerModel *model, TinkerLinearInput *input, TinkerBlockId support,
                         const double *direction)
{
    for (int32_t point = model->first_support; point < model->points; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        if (at->block != support || at->turn) continue;
        input->place[2 * point] += direction[0];
        input->place[2 * point + 1] += direction[1];
    }
}

static gboolean find_motion_in(const TinkerModel *model, TinkerBlockBatch *batch, TinkerLinearInput *input)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    if (physics == NULL || physics->motion == NULL || physics->motion->linear == NULL) return FALSE;
    g_autofree double *directions = g_new0(double, 2 * (gsize)batch->count);
    g_autofree int32_t *columns = g_new0(int32_t, batch->count);
    TinkerBatch view = tinker_block_batch_view(batch, model->time);
    for (int32_t row = 0; row < batch->count; row++) {
        if (batch->ids[row] != input->block) continue;
        if (TINKER_CALL_BATCH(batch, "linear", &view, physics->motion->linear(&view, directions, columns)) != TINKER_OK)
            return FALSE;
        input->is_motion = TRUE;
        input->unit = unit_of_column(batch->block_class, columns[row]);
        move_support(model, input, batch->end[batch->end_offsets[row]].block, directions + 2 * (gsize)row);
        return TRUE;
    }
    return FALSE;
}

static gboolean find_motion(const TinkerModel *model, TinkerLinearInput *input)
{
    for (guint i = 0; i < model->batches->len; i++)
        if (find_motion_in(model, g_ptr_array_index(model->batches, i), input)) return TRUE;
    return FALSE;
}

static gboolean find_input(TinkerModel *model, TinkerLinearInput *input)
{
    return find_force(model, input) || find_asked(model, input) || find_motion(model, input);
}

/* The names of all blocks that could be the input. (transfer full) */
static char *list_inputs(TinkerModel *model)
{
    g_autoptr(GString) names = g_string_new(NULL);
    g_autofree double *room = g_new0(double, 4 * (gsize)MAX(model->points, 1));
    for (int32_t place = 0; place < tinker_scene_block_count(model->scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(model->scene, place);
        TinkerLinearInput trial = {.block = block, .force = room, .place = room + 2 * (gsize)model->points};
        if (!find_input(model, &trial)) continue;
        g_string_append_printf(names, "%s\"%s\"", names->len > 0 ? ", " : "",
                               tinker_scene_block_name(model->scene, block));
    }
    return g_string_free(g_steal_pointer(&names), FALSE);
}

static gboolean refuse_input(TinkerModel *model, const char *name, const char *what, GError **error)
{
    g_autofree char *inputs = list_inputs(model);
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME, "\"%s\" %s (%s%s)", name, what,
                inputs[0] != '\0' ? "a response is to one of " : "nothing in this scene drives it by a waveform",
                inputs);
    return FALSE;
}

gboolean tinker_linear_input_find(TinkerModel *model, const char *name, TinkerLinearInput *input, GError **error)
{
    gsize coordinates = 2 * (gsize)MAX(model->points, 1);
    *input = (TinkerLinearInput){.block = tinker_scene_find_block(model->scene, name), .unit = "1"};
    if (input->block == TINKER_NO_BLOCK) return refuse_input(model, name, "is no block of the scene", error);
    input->force = g_new0(double, coordinates);
    input->place = g_new0(double, coordinates);
    if (find_input(model, input)) return TRUE;
    return refuse_input(model, name, "is no force or motion in proportion to a waveform", error);
}

void tinker_linear_input_clear(TinkerLinearInput *input)
{
    g_clear_pointer(&input->force, g_free);
    g_clear_pointer(&input->place, g_free);
}

/* Outputs ---------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerModel *model;
    TinkerSampler *sampler;
    const TinkerLinearInput *input;
    double *q, *v;
    double *driving; /* the waveform's value of a force; NULL: a motion */
} Probe;

/* Moves what is varied by `step`: coordinate `which` of q or v, or (which < 0) derivative `order` of the input. */
static void shift(Probe *probe, int32_t which, double *state, int order, double step)
{
    TinkerModel *model = probe->model;
    if (which >= 0) {
        state[which] += step;
        return;
    }
    if (probe->driving != NULL) {
        if (order == 0) *probe->driving += step;
        return;
    }
    for (int32_t p = model->bodies; p < model->points; p++) {
        TinkerPoint *at = &model->point[p];
        double *values[3][2] = {{&at->x, &at->y},
                                {&at->vx, &at->vy},
                                {&model->point_acceleration[2 * p], &model->point_acceleration[2 * p + 1]}};
        for (int axis = 0; axis < 2; axis++)
            *values[order][axis] += step * probe->input->place[2 * p + axis];
    }
}

/* The derivative by what `shift` moves, into `derivative`; 0 where it is rounding, as of an energy about its least. */
static TinkerStatus differentiate(Probe *probe, int32_t which, double *state, int order, double step,
                                  double *derivative)
{
    static const double weights[] = {45, -9, 1};
    double sum = 0, sizes = 0, kept = which >= 0 ? state[which] : probe->driving != NULL ? *probe->driving : 0;
    TinkerStatus status = TINKER_OK;
    for (int k = 1; k <= 3 && status == TINKER_OK; k++)
        for (int sign = -1; sign <= 1 && status == TINKER_OK; sign += 2) {
            double value = 0;
            shift(probe, which, state, order, sign * k * step);
            status = tinker_sampler_values(probe->sampler, probe->model->time, probe->q, probe->v, &value);
            shift(probe, which, state, order, -sign * k * step);
            if (which >= 0) state[which] = kept;
            if (which < 0 && probe->driving != NULL) *probe->driving = kept;
            sum += sign * weights[k - 1] * value;
            sizes += fabs(weights[k - 1] * value);
        }
    *derivative = fabs(sum) > TINKER_PROBE_ROUNDING * sizes ? sum / (60 * step) : 0;
    return status;
}

static double *driving_value(TinkerModel *model, const TinkerLinearInput *input)
{
    for (guint i = 0; i < model->driven->len && !input->is_motion; i++) {
        const TinkerDrivenForce *driven = &g_array_index(model->driven, TinkerDrivenForce, i);
        if (driven->batch->ids[driven->row] != input->block) continue;
        return &driven->batch->columns[column_of(driven->batch, driven->row, driven->value)][driven->row];
    }
    const char *unit;
    return input->is_motion ? NULL : asked_value(model, input->block, &unit);
}

static gboolean has_motion_of_its_own(const TinkerLinearOutput *output, int32_t size)
{
    for (int32_t i = 0; i < size; i++)
        if (output->by_place[i] != 0 || output->by_speed[i] != 0) return TRUE;
    return output->by_input[0] != 0 || output->by_input[1] != 0 || output->by_input[2] != 0;
}

static TinkerStatus differentiate_all(Probe *probe, double extent, double force, TinkerLinearOutput *output)
{
    int32_t size = probe->model->coordinates;
    TinkerStatus status = TINKER_OK;
    for (int32_t i = 0; i < size && status == TINKER_OK; i++) {
        status = differentiate(probe, i, probe->q, 0, TINKER_PROBE_STEP * extent, &output->by_place[i]);
        if (status == TINKER_OK)
            status = differentiate(probe, i, probe->v, 0, TINKER_PROBE_STEP * extent, &output->by_speed[i]);
    }
    for (int order = 0; order < 3 && status == TINKER_OK; order++) {
        double step = TINKER_PROBE_STEP * (probe->driving != NULL ? force : extent);
        status = differentiate(probe, -1, NULL, order, step, &output->by_input[order]);
    }
    return status;
}

gboolean tinker_linear_output_find(TinkerModel *model, const double *q, const TinkerColumn *column,
                                   const TinkerLinearInput *input, TinkerLinearOutput *output, GError **error)
{
    gsize size = (gsize)MAX(model->coordinates, 1);
    g_autoptr(TinkerLinearisation) linear = tinker_linearise(model, q, error);
    if (linear == NULL) return FALSE;
    g_autofree double *place = g_new0(double, size), *speed = g_new0(double, size);
    memcpy(place, q, sizeof(double) * (gsize)model->coordinates);
    g_autoptr(GArray) columns = g_array_new(FALSE, FALSE, sizeof(TinkerColumn));
    g_array_append_val(columns, *column);
    *output = (TinkerLinearOutput){g_new0(double, size), g_new0(double, size), {0}};
    Probe probe = {model, tinker_sampler_new(model, columns), input, place, speed, driving_value(model, input)};
    double force = linear->force_scale > 0 ? linear->force_scale : 1;
    TinkerStatus status = differentiate_all(&probe, linear->extent, force, output);
    tinker_sampler_free(probe.sampler);
    if (status == TINKER_OK && has_motion_of_its_own(output, model->coordinates)) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN, "\"%s\" %s", column->name,
                status == TINKER_OK ? "does not change with small motions, so it has no frequency response"
                                    : "cannot be worked out near this state");
    return FALSE;
}

void tinker_linear_output_clear(TinkerLinearOutput *output)
{
    g_clear_pointer(&output->by_place, g_free);
    g_clear_pointer(&output->by_speed, g_free);
}

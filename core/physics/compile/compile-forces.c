/* Compiling, second part: forces. Laws that are linear with constants are merged and added up once; only what is left
 * is asked for at every evaluation. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "physics/compile/compile-private.h"
#include "physics/force/line-parts.h"
#include "physics/model/angles.h"
#include "plugin/call/guarded.h"
#include "plugin/call/process-state.h"

/* Room for so many rows is enough for one that is asked again and again, for differences. */
#define LEAST_CHUNK 4

/* One linear law before merging. */
typedef struct {
    int32_t a, b; /* a < b */
    int32_t order;
    double stiffness, length, damping, tension;
} LinearLine;

/* Room to compile forces in. */
typedef struct {
    LinearLine *lines; /* the laws of lines that are linear ... */
    gsize count;       /* ... so far */
    gpointer answers;  /* of one batch to one question */
} LineWork;

/* Bytes: of four numbers for each end and one for each block, or a block's field. */
static gsize room_for_answers(const TinkerBlockBatch *batch)
{
    const gsize numbers = 4 * (gsize)MAX(batch->end_count, 1) + (gsize)batch->count;
    return MAX(numbers * sizeof(double), (gsize)batch->count * sizeof(TinkerLinearField));
}

/* (transfer none) */
static gpointer clear_answers(LineWork *work, gsize bytes)
{
    return memset(work->answers, 0, bytes);
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

/* Lines ---------------------------------------------------------------------------------------------------------- */

static double start_length(const TinkerModel *model, const int32_t *points)
{
    double place_a[2], place_b[2];
    tinker_model_start_place(model, points[0], place_a);
    tinker_model_start_place(model, points[1], place_b);
    return hypot(place_b[0] - place_a[0], place_b[1] - place_a[1]);
}

/* A pull at length 0 has no direction to act in. */
static void warn_without_direction(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row,
                                   const int32_t *points, double tension)
{
    if (tension == 0 || start_length(model, points) > 0) return;
    g_ptr_array_add(
        model->warnings,
        g_strdup_printf(
            _("%s: its ends are at one place, so its force of %.3g N has no direction: it acts on "
              "nothing until they part (place them apart, or give it no force at length 0, as by a rest length of 0)"),
            tinker_scene_block_name(model->scene, batch->ids[row]), fabs(tension)));
}

static gboolean add_linear_lines(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points, LineWork *work)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    if (law->linear == NULL) return FALSE;
    gsize n = (gsize)batch->count;
    double *values = clear_answers(work, 4 * n * sizeof(double));
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    if (TINKER_CALL_BATCH(batch, "linear", &view,
                          law->linear(&view, values, values + n, values + 2 * n, values + 3 * n)) != TINKER_OK)
        return FALSE;
    for (gsize i = 0; i < n; i++) {
        int32_t a = points[2 * i], b = points[2 * i + 1];
        if (a == b || (a >= model->first_support && b >= model->first_support && model->moving_supports == 0)) continue;
        warn_without_direction(model, batch, (int32_t)i, points + 2 * i,
                               values[3 * n + i] - values[i] * values[2 * n + i]);
        work->lines[work->count] = (LinearLine){MIN(a, b),         MAX(a, b),     (int32_t)work->count, values[i],
                                                values[2 * n + i], values[n + i], values[3 * n + i]};
        work->count++;
    }
    return TRUE;
}

static int compare_lines(const void *left, const void *right)
{
    const LinearLine *l = left, *r = right;
    if (l->a != r->a) return l->a < r->a ? -1 : 1;
    if (l->b != r->b) return l->b < r->b ? -1 : 1;
    return l->order < r->order ? -1 : 1;
}

/* Written about the length of the first law with a stiffness, so that a single spring keeps its own length to the bit.
 */
static void merge(TinkerModel *model, LinearLine *into, const LinearLine *line)
{
    double apart = into->length - line->length;
    if (into->stiffness == 0) {
        model->merged_energy -= into->tension * apart;
        into->length = line->length;
        apart = 0;
    }
    into->tension += line->tension + line->stiffness * apart;
    model->merged_energy += line->tension * apart + 0.5 * line->stiffness * apart * apart;
    into->stiffness += line->stiffness;
    into->damping += line->damping;
}

/* Answers how many are left, at the beginning of the array. */
static gsize merge_neighbours(TinkerModel *model, LinearLine *lines, gsize count)
{
    gsize kept = 0;
    qsort(lines, count, sizeof(LinearLine), compare_lines);
    for (gsize i = 0; i < count; i++) {
        LinearLine *last = kept > 0 ? &lines[kept - 1] : NULL;
        if (last != NULL && last->a == lines[i].a && last->b == lines[i].b)
            merge(model, last, &lines[i]);
        else
            lines[kept++] = lines[i];
    }
    return kept;
}

static gboolean allot_merged(TinkerMergedLines *merged, gsize count)
{
    merged->stiffness = g_try_malloc_n(MAX(count, 1), 4 * sizeof(double) + 2 * sizeof(int32_t));
    if (merged->stiffness == NULL) return FALSE;
    merged->length = merged->stiffness + count;
    merged->damping = merged->length + count;
    merged->tension = merged->damping + count;
    merged->a = (int32_t *)(gpointer)(merged->tension + count);
    merged->b = merged->a + count;
    return TRUE;
}

static void merge_lines(TinkerModel *model, LineWork *work)
{
    const gsize kept = merge_neighbours(model, work->lines, work->count);
    TinkerMergedLines *merged = &model->lines;
    if (!allot_merged(merged, kept)) {
        model->lacks_memory = TRUE;
        return;
    }
    merged->count = (int32_t)kept;
    for (gsize i = 0; i < kept; i++) {
        const LinearLine *line = &work->lines[i];
        merged->a[i] = line->a;
        merged->b[i] = line->b;
        merged->stiffness[i] = line->stiffness;
        merged->length[i] = line->length;
        merged->damping[i] = line->damping;
        merged->tension[i] = line->tension;
        merged->any_damping |= line->damping != 0;
    }
    model->has_book[TINKER_BOOK_DAMPERS] |= merged->any_damping;
}

/* A law that a waveform changes gives energy of its own accord: nothing it stores is counted, its power is booked
 * whole. */
static gboolean stores_energy(const TinkerBlockBatch *batch, gboolean offered)
{
    return offered && batch->waveforms == 0;
}

static gboolean moves_anything(const TinkerModel *model, const int32_t *points)
{
    return points[0] != points[1] && MIN(points[0], points[1]) < model->first_support;
}

/* Warns of laws that are asked and have no direction at the start. One that refuses is left to the run, which says why.
 */
static void warn_asked_without_direction(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points,
                                         LineWork *work)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    gsize n = (gsize)batch->count;
    double *length = clear_answers(work, 3 * n * sizeof(double));
    double *rate = length + n, *tension = length + 2 * n;
    gboolean any = FALSE;
    for (gsize i = 0; i < n; i++) {
        length[i] = start_length(model, points + 2 * i);
        any |= length[i] == 0 && moves_anything(model, points + 2 * i);
    }
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    if (!any || TINKER_CALL_BATCH(batch, "tension", &view, law->tension(&view, length, rate, tension)) != TINKER_OK)
        return;
    for (gsize i = 0; i < n; i++)
        if (isfinite(tension[i]) && moves_anything(model, points + 2 * i))
            warn_without_direction(model, batch, (int32_t)i, points + 2 * i, tension[i]);
}

static void ask_line(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points, LineWork *work)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    TinkerAskedBatch asked = {batch, points, stores_energy(batch, law->energy != NULL), NULL};
    g_array_append_val(model->asked_lines, asked);
    warn_asked_without_direction(model, batch, points, work);
    model->has_book[batch->waveforms > 0 ? TINKER_BOOK_MOTORS : TINKER_BOOK_DAMPERS] = TRUE;
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

static gboolean add_linear_forces(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points, LineWork *work)
{
    const TinkerForceElement *element = batch->block_class->physics->force_element;
    if (element->linear == NULL) return FALSE;
    gsize ends = (gsize)MAX(batch->end_count, 1);
    double *constant = clear_answers(work, room_for_answers(batch)), *direction = constant + 2 * ends;
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

static gboolean add_linear_fields(TinkerModel *model, TinkerBlockBatch *batch, LineWork *work)
{
    const TinkerField *field = batch->block_class->physics->field;
    if (field->linear == NULL) return FALSE;
    TinkerLinearField *laws = clear_answers(work, (gsize)batch->count * sizeof(TinkerLinearField));
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

static gboolean add_batch(TinkerModel *model, TinkerBlockBatch *batch, LineWork *work, GError **error)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    const int32_t *points = tinker_model_end_points(model, batch);
    if (!prepare(batch, error)) return FALSE;
    if (physics == NULL) return TRUE;
    if (physics->line_law != NULL && !add_linear_lines(model, batch, points, work))
        ask_line(model, batch, points, work);
    if (physics->force_element != NULL) {
        note_end_masses(model, batch, points);
        model->has_book[physics->force_element->dissipates ? TINKER_BOOK_DAMPERS : TINKER_BOOK_MOTORS] = TRUE;
        TinkerAskedBatch asked = {batch, points, stores_energy(batch, physics->force_element->energy != NULL),
                                  tinker_model_angles(model, batch)};
        if (!add_linear_forces(model, batch, points, work)) g_array_append_val(model->asked_forces, asked);
    }
    if (physics->field != NULL && !add_linear_fields(model, batch, work)) {
        TinkerAskedBatch asked = {batch, NULL, stores_energy(batch, physics->field->energy != NULL), NULL};
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

static gboolean open_line_work(LineWork *work, const TinkerModel *model)
{
    gsize lines = 1, bytes = 1;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics != NULL && physics->line_law != NULL) lines += (gsize)batch->count;
        bytes = MAX(bytes, room_for_answers(batch));
    }
    *work = (LineWork){g_try_new(LinearLine, lines), 0, g_try_malloc(bytes)};
    return work->lines != NULL && work->answers != NULL;
}

static void close_line_work(LineWork *work)
{
    g_free(work->lines);
    g_free(work->answers);
}

static gboolean add_batches(TinkerModel *model, GError **error)
{
    LineWork work;
    gboolean done = open_line_work(&work, model) || lack_memory(model, error);
    for (guint i = 0; done && i < model->batches->len; i++)
        done = add_batch(model, g_ptr_array_index(model->batches, i), &work, error);
    if (done) merge_lines(model, &work);
    close_line_work(&work);
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

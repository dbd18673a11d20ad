/* Forces along lines: laws that are linear with constants are merged, of others it is noted that they are asked. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

#include "physics/compile/compile-lines.h"
#include "physics/model/points.h"
#include "plugin/call/guarded.h"
#include "plugin/call/process-state.h"

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
    tinker_warnings_add(
        model->warnings, TINKER_WARNING_START,
        g_strdup_printf(
            _("%s: its ends are at one place, so its force of %.3g N has no direction: it acts on "
              "nothing until they part (place them apart, or give it no force at length 0, as by a rest length of 0)"),
            tinker_scene_block_name(model->scene, batch->ids[row]), fabs(tension)));
}

gboolean tinker_compile_linear_lines(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points,
                                     CompileWork *work)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    if (law->linear == NULL) return FALSE;
    gsize n = (gsize)batch->count;
    double *values = tinker_compile_clear_answers(work, 4 * n * sizeof(double));
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

void tinker_compile_merge_lines(TinkerModel *model, CompileWork *work)
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

static gboolean moves_anything(const TinkerModel *model, const int32_t *points)
{
    return points[0] != points[1] && MIN(points[0], points[1]) < model->first_support;
}

/* Warns of laws that are asked and have no direction at the start. One that refuses is left to the run, which says why.
 */
static void warn_asked_without_direction(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points,
                                         CompileWork *work)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    gsize n = (gsize)batch->count;
    double *length = tinker_compile_clear_answers(work, 3 * n * sizeof(double));
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

void tinker_compile_asked_lines(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points, CompileWork *work)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    TinkerAskedBatch asked = {batch, points, tinker_compile_stores_energy(batch, law->energy != NULL), NULL};
    g_array_append_val(model->asked_lines, asked);
    warn_asked_without_direction(model, batch, points, work);
    model->has_book[batch->waveforms > 0 ? TINKER_BOOK_MOTORS : TINKER_BOOK_DAMPERS] = TRUE;
    model->has_book[TINKER_BOOK_MOTORS] |= batch->has_timed_law;
}

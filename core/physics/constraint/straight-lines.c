/* Lines of rods: from one end of a rod rods are followed that lead on in its direction; what lies on a way to its other
 * end is held in line with it. So is what lies on a straight way from one support to another that stays where it is
 * beside the first. */
#include "physics/constraint/straight-lines.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

#include <math.h>

gboolean tinker_line_stays(const TinkerModel *model, int32_t a, int32_t b)
{
    if (a == b || a < model->first_support || b < model->first_support) return FALSE;
    const TinkerAttachment *p = tinker_model_attachment(model, a), *q = tinker_model_attachment(model, b);
    return p->block == q->block || (!p->moving && !q->moving);
}

/* Collecting ------------------------------------------------------------------------------------------------------- */

/* A place of a body that turns, which is held by more than rods. */
static gboolean is_off_centre(const TinkerModel *model, int32_t point)
{
    return point >= model->first_attachment && point < model->first_support;
}

static void collect_rods(TinkerLineFinder *finder)
{
    const GArray *batches = finder->model->constraints.batches;
    for (guint k = 0; k < batches->len; k++) {
        const TinkerConstraintBatch *part = &g_array_index(batches, TinkerConstraintBatch, k);
        for (int32_t i = 0; part->distances != NULL && i < part->row_count; i++) {
            TinkerLineRod rod = {
                {part->end_points[2 * i], part->end_points[2 * i + 1]}, &part->distances[i], part->batch->ids[i]};
            if (rod.ends[0] == rod.ends[1] || is_off_centre(finder->model, rod.ends[0]) ||
                is_off_centre(finder->model, rod.ends[1]))
                continue;
            g_array_append_val(finder->rods, rod);
        }
    }
}

static void list_rods_by_point(TinkerLineFinder *finder)
{
    int32_t points = finder->model->points, rods = (int32_t)finder->rods->len;
    finder->starts = g_new0(int32_t, points + 1);
    finder->at = g_new0(int32_t, MAX(2 * rods, 1));
    g_autofree int32_t *next = g_new0(int32_t, points + 1);
    for (int32_t i = 0; i < rods; i++)
        for (int k = 0; k < 2; k++)
            finder->starts[tinker_line_rod(finder, i)->ends[k] + 1]++;
    for (int32_t i = 0; i < points; i++)
        next[i + 1] = finder->starts[i + 1] += finder->starts[i];
    for (int32_t i = 0; i < rods; i++)
        for (int k = 0; k < 2; k++)
            finder->at[next[tinker_line_rod(finder, i)->ends[k]]++] = i;
}

/* Searching -------------------------------------------------------------------------------------------------------- */

static gboolean leads_on(const TinkerLineFinder *finder, const TinkerLineWay *line, int32_t at, int32_t to)
{
    double step[2], whole[2];
    tinker_line_way(finder, at, to, step);
    tinker_line_way(finder, line->from, to, whole);
    double ahead = step[0] * line->along[0] + step[1] * line->along[1];
    double across = step[0] * line->along[1] - step[1] * line->along[0];
    double far = whole[0] * line->along[0] + whole[1] * line->along[1];
    double off = whole[0] * line->along[1] - whole[1] * line->along[0];
    return ahead > 0 && fabs(across) <= TINKER_IN_LINE * ahead && fabs(off) <= TINKER_IN_LINE * far &&
           far <= line->most * (1 + TINKER_IN_LINE);
}

/* Marks what lies ahead, from the points in the queue on. */
static void follow(TinkerLineFinder *finder, const TinkerLineWay *line)
{
    for (guint next = 0; next < finder->queue->len; next++) {
        int32_t at = g_array_index(finder->queue, int32_t, next);
        for (int32_t k = finder->starts[at]; k < finder->starts[at + 1]; k++) {
            int32_t rod = finder->at[k], to = tinker_line_other_end(tinker_line_rod(finder, rod), at);
            if (rod == line->skipped || line->reached[to] == finder->searches) continue;
            if (!leads_on(finder, line, at, to)) continue;
            line->reached[to] = finder->searches;
            g_array_append_val(finder->queue, to);
        }
    }
}

static void begin_at(TinkerLineFinder *finder, const TinkerLineWay *line, int32_t point)
{
    g_array_set_size(finder->queue, 0);
    g_array_append_val(finder->queue, point);
    line->reached[point] = finder->searches;
}

/* Keeps the points between that lie on a way in both directions: those ahead of one end, marked, from the other. */
static void keep_between(TinkerLineFinder *finder, const TinkerLineWay *line, int32_t end)
{
    TinkerLineWay back = {end, line->skipped, {-line->along[0], -line->along[1]}, line->most, finder->back};
    begin_at(finder, &back, end);
    follow(finder, &back);
    GArray *points = g_array_new(FALSE, FALSE, sizeof(int32_t));
    for (guint i = 0; i < finder->queue->len; i++) {
        int32_t point = g_array_index(finder->queue, int32_t, i);
        if (line->reached[point] == finder->searches) g_array_append_val(points, point);
    }
    if (points->len > 2)
        g_ptr_array_add(finder->lines, points);
    else
        g_array_unref(points);
}

gboolean tinker_line_aim(const TinkerLineFinder *finder, int32_t from, int32_t to, TinkerLineWay *line)
{
    tinker_line_way(finder, from, to, line->along);
    double length = hypot(line->along[0], line->along[1]);
    line->from = from;
    line->most = length;
    line->along[0] /= length;
    line->along[1] /= length;
    return length > 0 && isfinite(length);
}

static int32_t count_at(const TinkerLineFinder *finder, int32_t point)
{
    return finder->starts[point + 1] - finder->starts[point];
}

/* Whether others reach from end to end of a rod. */
static void search_along_rod(TinkerLineFinder *finder, int32_t number)
{
    const TinkerLineRod *rod = tinker_line_rod(finder, number);
    int fewer = count_at(finder, rod->ends[0]) > count_at(finder, rod->ends[1]);
    TinkerLineWay line = {.skipped = number, .reached = finder->ahead};
    if (!tinker_line_aim(finder, rod->ends[fewer], rod->ends[1 - fewer], &line)) return;
    finder->searches++;
    begin_at(finder, &line, line.from);
    follow(finder, &line);
    if (line.reached[rod->ends[1 - fewer]] == finder->searches) keep_between(finder, &line, rod->ends[1 - fewer]);
}

/* Whether the rod begins a straight way from its end on a support to another support. */
static void search_from_support(TinkerLineFinder *finder, int32_t number, int32_t support)
{
    int32_t first = tinker_line_other_end(tinker_line_rod(finder, number), support);
    TinkerLineWay line = {.skipped = -1, .reached = finder->ahead};
    if (!tinker_line_aim(finder, support, first, &line)) return;
    line.most = INFINITY;
    finder->searches++;
    begin_at(finder, &line, support);
    begin_at(finder, &line, first);
    follow(finder, &line);
    int32_t end = -1;
    for (guint i = 0; i < finder->queue->len; i++)
        if (tinker_line_stays(finder->model, support, g_array_index(finder->queue, int32_t, i)))
            end = g_array_index(finder->queue, int32_t, i);
    if (end >= 0) keep_between(finder, &line, end);
}

static void search_all(TinkerLineFinder *finder)
{
    int32_t supports = finder->model->first_support;
    for (int32_t i = 0; i < (int32_t)finder->rods->len; i++) {
        const TinkerLineRod *rod = tinker_line_rod(finder, i);
        search_along_rod(finder, i);
        for (int k = 0; k < 2; k++)
            if (rod->ends[k] >= supports && rod->ends[1 - k] < supports) search_from_support(finder, i, rod->ends[k]);
    }
}

void tinker_line_finder_search(TinkerLineFinder *finder, const TinkerModel *model)
{
    *finder = (TinkerLineFinder){.model = model,
                                 .rods = g_array_new(FALSE, FALSE, sizeof(TinkerLineRod)),
                                 .queue = g_array_new(FALSE, FALSE, sizeof(int32_t)),
                                 .lines = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref)};
    collect_rods(finder);
    if (finder->rods->len < 2) return;
    list_rods_by_point(finder);
    finder->ahead = g_new0(int32_t, MAX(model->points, 1));
    finder->back = g_new0(int32_t, MAX(model->points, 1));
    search_all(finder);
}

void tinker_line_finder_clear(TinkerLineFinder *finder)
{
    g_array_unref(finder->rods);
    g_array_unref(finder->queue);
    g_ptr_array_unref(finder->lines);
    gpointer arrays[] = {finder->starts, finder->at, finder->ahead, finder->back};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
}

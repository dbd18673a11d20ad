/* Finding bars: lines with two points in common are one, and rods that the others of a bar leave nothing to do get
 * lengths that fit. */
#include "physics/constraint/straight-lines.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/model.h"

/* Joins the lines that have two points in common. Answers whether any were not one already. */
static gboolean join_lines(const TinkerLineFinder *finder, int32_t *set, GPtrArray *lines_at)
{
    gboolean any = FALSE;
    g_autofree int32_t *met_by = g_new0(int32_t, finder->lines->len), *met_at = g_new0(int32_t, finder->lines->len);
    for (guint i = 0; i < finder->lines->len; i++) {
        const GArray *points = g_ptr_array_index(finder->lines, i);
        for (guint k = 0; k < points->len; k++) {
            int32_t point = g_array_index(points, int32_t, k);
            const GArray *others = g_ptr_array_index(lines_at, (guint)point);
            for (guint n = 0; n < others->len; n++) {
                int32_t other = tinker_sets_first(set, g_array_index(others, int32_t, n));
                if (other == tinker_sets_first(set, (int32_t)i)) continue;
                if (met_by[other] == (int32_t)i + 1 && met_at[other] != point) {
                    tinker_sets_join(set, (int32_t)i, other);
                    any = TRUE;
                } else {
                    met_by[other] = (int32_t)i + 1;
                    met_at[other] = point;
                }
            }
        }
    }
    return any;
}

static GPtrArray *list_lines_by_point(const TinkerLineFinder *finder)
{
    GPtrArray *lines_at = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    for (int32_t i = 0; i < finder->model->points; i++)
        g_ptr_array_add(lines_at, g_array_new(FALSE, FALSE, sizeof(int32_t)));
    for (int32_t i = 0; i < (int32_t)finder->lines->len; i++) {
        const GArray *points = g_ptr_array_index(finder->lines, (guint)i);
        for (guint k = 0; k < points->len; k++)
            g_array_append_val(g_ptr_array_index(lines_at, (guint)g_array_index(points, int32_t, k)), i);
    }
    return lines_at;
}

/* A bar: its points, and where they are along and across the line from end to end. */
typedef struct {
    int32_t number, count;
    int32_t *points, *group; /* `group`: of points whose places along the line are known to one another, by its first */
    double *along, *across;
    int32_t first, last; /* of the points: the ends */
} Bar;

/* FALSE where all its points are at one place: there is no line. */
static gboolean measure_bar(const TinkerLineFinder *finder, Bar *bar)
{
    TinkerLineWay line;
    int32_t apart = 1;
    while (apart < bar->count && !tinker_line_aim(finder, bar->points[0], bar->points[apart], &line))
        apart++;
    if (apart == bar->count) return FALSE;
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t i = 0; i < bar->count; i++) {
            double d[2];
            tinker_line_way(finder, line.from, bar->points[i], d);
            bar->along[i] = d[0] * line.along[0] + d[1] * line.along[1];
            bar->across[i] = d[0] * line.along[1] - d[1] * line.along[0];
            if (i == 0) bar->first = bar->last = 0;
            if (bar->along[i] < bar->along[bar->first]) bar->first = i;
            if (bar->along[i] > bar->along[bar->last]) bar->last = i;
        }
        tinker_line_aim(finder, bar->points[bar->first], bar->points[bar->last], &line);
    }
    return TRUE;
}

/* Both ends of a rod in the bar. */
typedef struct {
    const TinkerLineRod *rod;
    int32_t ends[2]; /* numbers of the bar's points, in their order along it */
} BarRod;

static int by_length(const void *left, const void *right)
{
    const BarRod *l = left, *r = right;
    if (*l->rod->length != *r->rod->length) return *l->rod->length < *r->rod->length ? -1 : 1;
    return l->rod < r->rod ? -1 : l->rod > r->rod;
}

/* (transfer full) */
static GArray *rods_of_bar(const TinkerLineFinder *finder, const Bar *bar, const int32_t *number_of)
{
    GArray *rods = g_array_new(FALSE, FALSE, sizeof(BarRod));
    for (int32_t i = 0; i < bar->count; i++) {
        int32_t point = bar->points[i];
        for (int32_t k = finder->starts[point]; k < finder->starts[point + 1]; k++) {
            const TinkerLineRod *rod = tinker_line_rod(finder, finder->at[k]);
            int32_t to = tinker_line_other_end(rod, point), other = number_of[to];
            if (other < 0 || other >= bar->count || bar->points[other] != to || !(bar->along[other] > bar->along[i]))
                continue;
            BarRod found = {rod, {i, other}};
            g_array_append_val(rods, found);
        }
    }
    g_array_sort(rods, by_length);
    return rods;
}

/* The points of the groups of both become one group, with `to` at its place. */
static void join_groups(Bar *bar, int32_t from, int32_t to, double place)
{
    int32_t group = bar->group[from], moved = bar->group[to];
    double shift = place - bar->along[to];
    for (int32_t i = 0; i < bar->count; i++) {
        if (bar->group[i] != moved) continue;
        bar->group[i] = group;
        bar->along[i] += shift;
    }
}

static gboolean fits(const TinkerLineFinder *finder, const TinkerLineRod *rod)
{
    double d[2];
    tinker_line_way(finder, rod->ends[0], rod->ends[1], d);
    return fabs(hypot(d[0], d[1]) - *rod->length) <= TINKER_START_MISS * *rod->length;
}

/* The rods one after another, shorter ones first, and supports before all: a rod between points whose places along the
 * line are known by then has the length that fits, up to rounding or to what its places may be off by. */
static void fit_lengths(const TinkerLineFinder *finder, Bar *bar, const GArray *rods)
{
    for (int32_t i = 0; i < bar->count; i++) {
        bar->group[i] = i;
        for (int32_t k = 0; k < i; k++)
            if (tinker_line_stays(finder->model, bar->points[k], bar->points[i])) bar->group[i] = bar->group[k];
    }
    for (guint i = 0; i < rods->len; i++) {
        const BarRod *of = &g_array_index(rods, BarRod, i);
        double across = bar->across[of->ends[1]] - bar->across[of->ends[0]], *length = of->rod->length;
        double along = bar->along[of->ends[1]] - bar->along[of->ends[0]], now = hypot(along, across);
        if (!fits(finder, of->rod)) continue; /* the start refuses it */
        if (bar->group[of->ends[0]] == bar->group[of->ends[1]]) {
            *length = now;
            (*finder->fitted)++;
        } else {
            join_groups(bar, of->ends[0], of->ends[1],
                        bar->along[of->ends[0]] + sqrt((*length - across) * (*length + across)));
        }
    }
}

/* The longest rod across a point, else the longest at it. */
static TinkerBlockId rod_across(const Bar *bar, const GArray *rods, int32_t number)
{
    TinkerBlockId across = TINKER_NO_BLOCK, at = TINKER_NO_BLOCK;
    for (guint i = 0; i < rods->len; i++) {
        const BarRod *rod = &g_array_index(rods, BarRod, i);
        if (rod->ends[0] == number || rod->ends[1] == number) at = rod->rod->block;
        if (bar->along[rod->ends[0]] < bar->along[number] && bar->along[number] < bar->along[rod->ends[1]])
            across = rod->rod->block;
    }
    return across != TINKER_NO_BLOCK ? across : at;
}

static void add_rows(const TinkerLineFinder *finder, const Bar *bar, const GArray *rods, GArray *rows)
{
    const int32_t supports = finder->model->first_support, a = bar->points[bar->first], c = bar->points[bar->last];
    double length = bar->along[bar->last] - bar->along[bar->first];
    for (int32_t i = 0; i < bar->count; i++) {
        TinkerStraightRow row = {a, bar->points[i], c, length, bar->across[i], rod_across(bar, rods, i)};
        if (i == bar->first || i == bar->last || MIN(MIN(a, c), row.between) >= supports) continue;
        g_array_append_val(rows, row);
    }
}

/* `number_of`: room, by point. */
static void make_bar(const TinkerLineFinder *finder, const GArray *points, int32_t *number_of, GArray *rows)
{
    gsize count = points->len;
    g_autofree double *along = g_new0(double, count), *across = g_new0(double, count);
    g_autofree int32_t *group = g_new0(int32_t, count);
    Bar bar = {.count = (int32_t)count,
               .points = (int32_t *)(void *)points->data,
               .group = group,
               .along = along,
               .across = across};
    for (int32_t i = 0; i < bar.count; i++)
        number_of[bar.points[i]] = i;
    if (!measure_bar(finder, &bar)) return;
    g_autoptr(GArray) rods = rods_of_bar(finder, &bar, number_of);
    fit_lengths(finder, &bar, rods);
    add_rows(finder, &bar, rods, rows);
}

static int by_number(const void *left, const void *right)
{
    return *(const int32_t *)left - *(const int32_t *)right;
}

/* Each point once, in order. */
static void sort_points(GArray *points)
{
    guint kept = 0;
    g_array_sort(points, by_number);
    for (guint i = 0; i < points->len; i++)
        if (i == 0 || g_array_index(points, int32_t, i) != g_array_index(points, int32_t, kept - 1))
            g_array_index(points, int32_t, kept++) = g_array_index(points, int32_t, i);
    g_array_set_size(points, kept);
}

static void make_bars(const TinkerLineFinder *finder, GArray *rows)
{
    gsize points = (gsize)finder->model->points;
    g_autoptr(GPtrArray) lines_at = list_lines_by_point(finder);
    g_autofree int32_t *set = g_new0(int32_t, finder->lines->len), *number_of = g_new0(int32_t, points);
    tinker_sets_begin(set, (int32_t)finder->lines->len);
    memset(number_of, -1, points * sizeof(int32_t));
    while (join_lines(finder, set, lines_at))
        ;
    for (int32_t i = 0; i < (int32_t)finder->lines->len; i++) { /* the first of a set comes before all others */
        const GArray *line = g_ptr_array_index(finder->lines, (guint)i);
        int32_t bar = tinker_sets_first(set, i);
        if (bar != i) g_array_append_vals(g_ptr_array_index(finder->lines, (guint)bar), line->data, line->len);
    }
    for (int32_t i = 0; i < (int32_t)finder->lines->len; i++) {
        if (tinker_sets_first(set, i) != i) continue;
        GArray *of_bar = g_ptr_array_index(finder->lines, (guint)i);
        sort_points(of_bar);
        make_bar(finder, of_bar, number_of, rows);
    }
}

GArray *tinker_straight_rows_find(const TinkerModel *model, int32_t *fitted)
{
    GArray *rows = g_array_new(FALSE, FALSE, sizeof(TinkerStraightRow));
    TinkerLineFinder finder;
    *fitted = 0;
    tinker_line_finder_search(&finder, model);
    finder.fitted = fitted;
    if (finder.lines->len > 0) make_bars(&finder, rows);
    tinker_line_finder_clear(&finder);
    return rows;
}

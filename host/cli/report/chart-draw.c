/* Charts: the plot. Of a long record only what a picture can show is kept in memory. */
#include "cli/report/chart-private.h"

#include <string.h>

#include "render/plot/plot.h"

/* Buckets of a long record; each keeps its least and its greatest value. Far more than a picture has pixels. */
#define MOST_BUCKETS 32768
#define ROWS_AT_ONCE 1024

/* The points of one curve, thinned while they are read. */
typedef struct {
    GArray *x, *y;          /* of double */
    GArray *bottom, *top;   /* of double: the band; empty without one */
    double low[3], high[3]; /* x, y, half the band's width */
    gboolean filled, has_band;
} CurvePoints;

static void append_point(CurvePoints *points, const double point[3])
{
    g_array_append_val(points->x, point[0]);
    g_array_append_val(points->y, point[1]);
    if (!points->has_band) return;
    double bottom = point[1] - point[2], top = point[1] + point[2];
    g_array_append_val(points->bottom, bottom);
    g_array_append_val(points->top, top);
}

/* Hands on the bucket's extremes in the order of x, which is that of time. */
static void empty_bucket(CurvePoints *points)
{
    if (!points->filled) return;
    gboolean low_first = points->low[0] <= points->high[0];
    append_point(points, low_first ? points->low : points->high);
    if (points->low[0] != points->high[0]) append_point(points, low_first ? points->high : points->low);
    points->filled = FALSE;
}

static void fill_bucket(CurvePoints *points, const double point[3])
{
    if (!points->filled || point[1] < points->low[1]) memcpy(points->low, point, sizeof points->low);
    if (!points->filled || point[1] > points->high[1]) memcpy(points->high, point, sizeof points->high);
    points->filled = TRUE;
}

static gboolean read_points(const TinkerChart *chart, TinkerChartCurve curve, CurvePoints *points, GError **error)
{
    guint width = tinker_chart_width(chart);
    double x_factor = tinker_chart_axis(chart, curve.x).per_si, y_factor = tinker_chart_axis(chart, curve.y).per_si;
    gsize count = chart->record == NULL ? 0 : tinker_record_rows(chart->record);
    gsize bucket = count / MOST_BUCKETS + 1;
    g_autofree double *rows = g_new(double, (gsize)ROWS_AT_ONCE *width);
    for (gsize row = 0; row < count; row++) {
        gsize place = row % ROWS_AT_ONCE;
        if (place == 0 && !tinker_record_read(chart->record, row, MIN(ROWS_AT_ONCE, count - row), rows, error))
            return FALSE;
        const double *values = rows + place * width;
        double point[3] = {x_factor * values[curve.x], y_factor * values[curve.y], 0};
        if (points->has_band) point[2] = y_factor * values[chart->columns->len + curve.y];
        if (bucket == 1 || (curve.x > 0 && row % bucket == 0))
            append_point(points, point);
        else if (curve.x == 0)
            fill_bucket(points, point);
        if (row % bucket == bucket - 1) empty_bucket(points);
    }
    empty_bucket(points);
    return TRUE;
}

/* The label of a lone curve's axis. It names the block, but on the x axis only where y is another's. */
static char *lone_label(const TinkerChart *chart, gboolean of_x)
{
    TinkerChartCurve curve = g_array_index(chart->curves, TinkerChartCurve, 0);
    TinkerGraphAxis x = tinker_chart_axis(chart, curve.x), y = tinker_chart_axis(chart, curve.y);
    TinkerGraphAxis axis = of_x ? x : y;
    if (axis.block == TINKER_NO_BLOCK || (of_x && x.block == y.block)) return tinker_axis_label(axis.title, axis.unit);
    g_autofree char *title = g_strdup_printf("%s: %s", tinker_scene_block_name(chart->scene, axis.block), axis.title);
    return tinker_axis_label(title, axis.unit);
}

/* The label that all curves share on one axis: up to two titles, or what is measured, and the unit. */
static char *common_label(const TinkerChart *chart, gboolean of_x)
{
    TinkerChartCurve first = g_array_index(chart->curves, TinkerChartCurve, 0);
    TinkerGraphAxis axis = tinker_chart_axis(chart, of_x ? first.x : first.y);
    const char *second = NULL; /* title */
    gboolean two_titles = TRUE, same_unit = TRUE;
    for (guint i = 1; i < chart->curves->len; i++) {
        TinkerChartCurve curve = g_array_index(chart->curves, TinkerChartCurve, i);
        TinkerGraphAxis other = tinker_chart_axis(chart, of_x ? curve.x : curve.y);
        if (second == NULL && strcmp(axis.title, other.title) != 0) second = other.title;
        if (strcmp(axis.title, other.title) != 0 && strcmp(second, other.title) != 0) two_titles = FALSE;
        if (strcmp(axis.unit, other.unit) != 0) same_unit = FALSE;
    }
    if (!same_unit) return g_strdup("units as in the legend");
    if (second == NULL) return tinker_axis_label(axis.title, axis.unit);
    g_autofree char *name =
        two_titles ? g_strdup_printf("%s, %s", axis.title, second) : g_strdup(tinker_dimension_name(axis.dimension));
    if (!two_titles) name[0] = g_ascii_toupper(name[0]);
    return tinker_axis_label(name, axis.unit);
}

static gboolean is_path(const TinkerChart *chart)
{
    TinkerChartCurve first = g_array_index(chart->curves, TinkerChartCurve, 0);
    TinkerGraphAxis x = tinker_chart_axis(chart, first.x), y = tinker_chart_axis(chart, first.y);
    return tinker_graph_axes_of_path(&x, &y);
}

static char *legend_label(const TinkerChart *chart, TinkerChartCurve curve)
{
    const TinkerColumn *column = &g_array_index(chart->columns, TinkerColumn, curve.y - 1);
    TinkerGraphAxis axis = tinker_chart_axis(chart, curve.y);
    return tinker_axis_label(column->name, axis.unit);
}

static void free_points(gpointer data)
{
    CurvePoints *points = data;
    g_array_unref(points->x);
    g_array_unref(points->y);
    g_array_unref(points->bottom);
    g_array_unref(points->top);
    g_free(points);
}

static CurvePoints *curve_points_new(gboolean has_band)
{
    CurvePoints *points = g_new0(CurvePoints, 1);
    GArray **arrays[] = {&points->x, &points->y, &points->bottom, &points->top};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = g_array_new(FALSE, FALSE, sizeof(double));
    points->has_band = has_band;
    return points;
}

static const double *numbers(const GArray *array)
{
    return (const double *)(gpointer)array->data;
}

gboolean tinker_chart_draw(TinkerChart *chart, const TinkerTheme *theme, int width, int height, const char *path,
                           GError **error)
{
    guint count = chart->curves->len;
    g_autofree TinkerCurve *curves = g_new0(TinkerCurve, count);
    g_autoptr(GPtrArray) all_points = g_ptr_array_new_with_free_func(free_points);
    g_autoptr(GPtrArray) labels = g_ptr_array_new_with_free_func(g_free);
    for (guint i = 0; i < count; i++) {
        TinkerChartCurve curve = g_array_index(chart->curves, TinkerChartCurve, i);
        CurvePoints *points = curve_points_new(chart->has_bands && curve.x == 0);
        g_ptr_array_add(all_points, points);
        if (!read_points(chart, curve, points, error)) return FALSE;
        g_ptr_array_add(labels, legend_label(chart, curve));
        curves[i] = (TinkerCurve){
            .label = count > 1 ? g_ptr_array_index(labels, i) : NULL,
            .x = numbers(points->x),
            .y = numbers(points->y),
            .low = points->has_band ? numbers(points->bottom) : NULL,
            .high = points->has_band ? numbers(points->top) : NULL,
            .count = points->x->len,
            .colour = (int)i,
        };
    }
    g_autofree char *x_label = count > 1 ? common_label(chart, TRUE) : lone_label(chart, TRUE);
    g_autofree char *y_label = count > 1 ? common_label(chart, FALSE) : lone_label(chart, FALSE);
    TinkerPlot plot = {
        .title = chart->title[0] != '\0' ? chart->title : NULL,
        .x_label = x_label,
        .y_label = y_label,
        .equal_scales = is_path(chart),
        .curves = curves,
        .curve_count = (int)count,
        .theme = theme,
    };
    return tinker_plot_to_file(&plot, width, height, path, error);
}

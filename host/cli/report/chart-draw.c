/* Charts: the plot. Of a long record only what a picture can show is kept in memory. */
#include "cli/report/chart-private.h"

#include <math.h>
#include <string.h>

#include "common/program/exit-status.h"

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

static void read_table(const TinkerChartCurve *curve, CurvePoints *points)
{
    for (guint i = 0; i + 1 < curve->table->len; i += 2) {
        const double *row = &g_array_index(curve->table, double, i);
        const double point[3] = {row[0], curve->axis.per_si * row[1], 0};
        append_point(points, point);
    }
}

static gboolean read_points(const TinkerChart *chart, const TinkerChartCurve *curve, CurvePoints *points,
                            GError **error)
{
    guint width = tinker_chart_width(chart);
    double x_factor = tinker_chart_axis(chart, curve->x).per_si, y_factor = curve->axis.per_si;
    gsize count = chart->record == NULL ? 0 : tinker_record_rows(chart->record);
    gsize bucket = count / MOST_BUCKETS + 1;
    g_autofree double *rows = g_new(double, (gsize)ROWS_AT_ONCE *width);
    for (gsize row = 0; row < count; row++) {
        gsize place = row % ROWS_AT_ONCE;
        if (place == 0 && !tinker_record_read(chart->record, row, MIN(ROWS_AT_ONCE, count - row), rows, error))
            return FALSE;
        const double *values = rows + place * width;
        double point[3] = {x_factor * values[curve->x], y_factor * tinker_chart_value(curve, values), 0};
        if (points->has_band) point[2] = y_factor * tinker_chart_band(chart, curve, values);
        if (bucket == 1 || (curve->x > 0 && row % bucket == 0))
            append_point(points, point);
        else if (curve->x == 0)
            fill_bucket(points, point);
        if (row % bucket == bucket - 1) empty_bucket(points);
    }
    empty_bucket(points);
    return TRUE;
}

static const TinkerChartCurve *curve_at(const TinkerChart *chart, guint number)
{
    return &g_array_index(chart->curves, TinkerChartCurve, number);
}

/* The label of a lone curve's axis. It names the block, but on the x axis only where y is another's. */
static char *lone_label(const TinkerChart *chart, gboolean of_x)
{
    const TinkerChartCurve *curve = curve_at(chart, 0);
    TinkerGraphAxis x = tinker_chart_axis(chart, curve->x), y = curve->axis, axis = of_x ? x : y;
    if (axis.block == TINKER_NO_BLOCK || (of_x && x.block == y.block)) return tinker_axis_label(axis.title, axis.unit);
    g_autofree char *title = g_strdup_printf("%s: %s", tinker_scene_block_name(chart->scene, axis.block), axis.title);
    return tinker_axis_label(title, axis.unit);
}

typedef enum { AXIS_X, AXIS_LEFT, AXIS_RIGHT } AxisPlace;

/* The label that all curves share on one axis. NULL where no curve belongs to it. */
static char *common_label(const TinkerChart *chart, AxisPlace place)
{
    g_autoptr(GArray) axes = g_array_new(FALSE, FALSE, sizeof(TinkerGraphAxis));
    for (guint i = 0; i < chart->curves->len; i++) {
        const TinkerChartCurve *curve = curve_at(chart, i);
        if (place != AXIS_X && curve->right != (place == AXIS_RIGHT)) continue;
        const TinkerGraphAxis axis = place == AXIS_X ? tinker_chart_axis(chart, curve->x) : curve->axis;
        g_array_append_val(axes, axis);
    }
    return tinker_graph_axes_label((const TinkerGraphAxis *)(gpointer)axes->data, axes->len);
}

static gboolean is_path(const TinkerChart *chart)
{
    TinkerGraphAxis x = tinker_chart_axis(chart, curve_at(chart, 0)->x);
    return tinker_graph_axes_of_path(&x, &curve_at(chart, 0)->axis);
}

/* Where there are several runs of one curve the run alone names it. */
static char *legend_label(const TinkerChart *chart, const TinkerChartCurve *curve, gboolean several)
{
    g_autofree char *label = tinker_axis_label(curve->name, curve->axis.unit);
    if (chart->run == NULL) return g_steal_pointer(&label);
    return several ? g_strdup_printf("%s: %s", chart->run, label) : g_strdup(chart->run);
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

/* Everything that a plot borrows. */
typedef struct {
    GArray *curves;    /* of TinkerCurve */
    GPtrArray *points; /* of CurvePoints */
    GPtrArray *labels;
} Drawing;

static void drawing_clear(Drawing *drawing)
{
    g_array_unref(drawing->curves);
    g_ptr_array_unref(drawing->points);
    g_ptr_array_unref(drawing->labels);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Drawing, drawing_clear)

static gboolean add_curves(Drawing *drawing, const TinkerChart *chart, GError **error)
{
    for (guint i = 0; i < chart->curves->len; i++) {
        const TinkerChartCurve *from = curve_at(chart, i);
        CurvePoints *points = curve_points_new(chart->has_bands && from->x == 0 && from->table == NULL);
        g_ptr_array_add(drawing->points, points);
        if (from->table != NULL)
            read_table(from, points);
        else if (!read_points(chart, from, points, error))
            return FALSE;
        g_ptr_array_add(drawing->labels, legend_label(chart, from, chart->curves->len > 1));
        TinkerCurve curve = {
            .label = g_ptr_array_index(drawing->labels, drawing->labels->len - 1),
            .x = numbers(points->x),
            .y = numbers(points->y),
            .low = points->has_band ? numbers(points->bottom) : NULL,
            .high = points->has_band ? numbers(points->top) : NULL,
            .count = points->x->len,
            .colour = (int)drawing->curves->len,
            .markers = from->table != NULL,
            .no_line = from->table != NULL,
            .right = from->right,
        };
        g_array_append_val(drawing->curves, curve);
    }
    return TRUE;
}

/* What the scene's graph asks of its axes, in displayed units. */
static void set_axes(TinkerPlot *plot, const TinkerChart *chart, double ranges[2][2])
{
    const TinkerSceneGraph *axes = chart->axes;
    plot->x_logarithmic = chart->logarithmic[0] || (axes != NULL && axes->logarithmic[0]);
    plot->y_logarithmic = chart->logarithmic[1] || (axes != NULL && axes->logarithmic[1]);
    plot->right_logarithmic = plot->y_logarithmic;
    if (axes == NULL) return;
    const double factors[2] = {tinker_chart_axis(chart, curve_at(chart, 0)->x).per_si, curve_at(chart, 0)->axis.per_si};
    for (int axis = 0; axis < 2; axis++)
        for (int end = 0; end < 2; end++)
            ranges[axis][end] = factors[axis] * axes->range[axis][end];
    if (axes->has_range[0]) plot->x_range = ranges[0];
    if (axes->has_range[1]) plot->y_range = ranges[1];
}

gboolean tinker_chart_draw(TinkerChart *chart, const TinkerTheme *theme, int width, int height, const char *path,
                           GError **error)
{
    g_auto(Drawing) drawing = {g_array_new(FALSE, TRUE, sizeof(TinkerCurve)),
                               g_ptr_array_new_with_free_func(free_points), g_ptr_array_new_with_free_func(g_free)};
    if (!add_curves(&drawing, chart, error)) return FALSE;
    for (guint i = 0; i < chart->others->len; i++)
        if (!add_curves(&drawing, g_ptr_array_index(chart->others, i), error)) return FALSE;
    TinkerCurve *curves = (TinkerCurve *)(gpointer)drawing.curves->data;
    if (drawing.curves->len == 1) curves[0].label = NULL;
    const gboolean lone = chart->curves->len == 1;
    g_autofree char *x_label = lone ? lone_label(chart, TRUE) : common_label(chart, AXIS_X);
    g_autofree char *y_label = lone ? lone_label(chart, FALSE) : common_label(chart, AXIS_LEFT);
    g_autofree char *right_label = common_label(chart, AXIS_RIGHT);
    double ranges[2][2];
    TinkerPlot plot = {
        .title = chart->title[0] != '\0' ? chart->title : NULL,
        .x_label = x_label,
        .y_label = y_label,
        .right_label = right_label,
        .equal_scales = is_path(chart),
        .curves = curves,
        .curve_count = (int)drawing.curves->len,
        .theme = theme,
    };
    set_axes(&plot, chart, ranges);
    return tinker_plot_to_file(&plot, width, height, path, error);
}

static void add_spectrum(Drawing *drawing, const TinkerChart *chart, const TinkerChartSpectrum *spectrum)
{
    g_ptr_array_add(drawing->labels, legend_label(chart, spectrum->curve, TRUE));
    const TinkerCurve curve = {.label = g_ptr_array_index(drawing->labels, drawing->labels->len - 1),
                               .x = numbers(spectrum->frequencies),
                               .y = numbers(spectrum->amplitudes),
                               .count = spectrum->frequencies->len,
                               .colour = (int)drawing->curves->len,
                               .right = spectrum->curve->right};
    g_array_append_val(drawing->curves, curve);
}

gboolean tinker_chart_draw_spectrum(TinkerChart *chart, const TinkerSpectrumOptions *options, const TinkerTheme *theme,
                                    int width, int height, const char *path, GError **error)
{
    g_auto(Drawing) drawing = {g_array_new(FALSE, TRUE, sizeof(TinkerCurve)),
                               g_ptr_array_new_with_free_func(free_points), g_ptr_array_new_with_free_func(g_free)};
    g_autoptr(GPtrArray) spectra = tinker_chart_spectra(chart, options, error);
    if (spectra == NULL) return FALSE;
    for (guint i = 0; i < spectra->len; i++)
        add_spectrum(&drawing, chart, g_ptr_array_index(spectra, i));
    const gboolean lone = chart->curves->len == 1;
    g_autofree char *label = lone ? lone_label(chart, FALSE) : common_label(chart, AXIS_LEFT);
    g_autofree char *y_label = g_strdup_printf("Amplitude: %s", label != NULL ? label : "");
    g_autofree char *right_label = common_label(chart, AXIS_RIGHT);
    const TinkerPlot plot = {
        .title = chart->title[0] != '\0' ? chart->title : NULL,
        .x_label =
            options->window == TINKER_WINDOW_HANN ? "Frequency [Hz] (window: Hann)" : "Frequency [Hz] (no window)",
        .y_label = y_label,
        .right_label = right_label,
        .x_logarithmic = chart->logarithmic[0],
        .y_logarithmic = chart->logarithmic[1],
        .right_logarithmic = chart->logarithmic[1],
        .curves = (const TinkerCurve *)(gpointer)drawing.curves->data,
        .curve_count = (int)drawing.curves->len,
        .theme = theme,
    };
    return tinker_plot_to_file(&plot, width, height, path, error);
}

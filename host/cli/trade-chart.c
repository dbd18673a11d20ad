/* The work-precision chart of a trade. */
#include <math.h>

#include "render/plot.h"
#include "trade-report.h"

/* The points of all methods, and the curves over them. */
typedef struct {
    GArray *curves;    /* of TinkerCurve */
    GPtrArray *points; /* of GArray of double, which the curves borrow */
    double least_wall, greatest_wall;
    const char *advised; /* label of its point */
} Chart;

static const double *keep(Chart *chart, GArray *points)
{
    g_ptr_array_add(chart->points, points);
    return (const double *)(gpointer)points->data;
}

/* An error of 0 has no place on a logarithmic axis: what the reference is confirmed to stands for all below it. */
static double drawn_error(const TinkerTrade *trade, const TinkerTradeRow *row)
{
    return fmax(row->error, 0.1 * trade->reference.level);
}

static void add_method(Chart *chart, const TinkerTrade *trade, guint number)
{
    const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, number);
    GArray *x = g_array_new(FALSE, FALSE, sizeof(double)), *y = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < method->rows->len; i++) {
        const TinkerTradeRow *row = &g_array_index(method->rows, TinkerTradeRow, i);
        double error = drawn_error(trade, row);
        if (isnan(row->error) || isnan(row->wall_s)) continue;
        g_array_append_val(x, row->wall_s);
        g_array_append_val(y, error);
        chart->least_wall = fmin(chart->least_wall, row->wall_s);
        chart->greatest_wall = fmax(chart->greatest_wall, row->wall_s);
    }
    TinkerCurve curve = {.label = method->id, .count = x->len, .colour = (int)number, .markers = TRUE};
    curve.x = keep(chart, x);
    curve.y = keep(chart, y);
    if (curve.count > 0) g_array_append_val(chart->curves, curve);
}

static void add_line(Chart *chart, TinkerCurve curve, const double from[2], const double to[2])
{
    GArray *x = g_array_new(FALSE, FALSE, sizeof(double)), *y = g_array_new(FALSE, FALSE, sizeof(double));
    g_array_append_val(x, from[0]);
    g_array_append_val(y, from[1]);
    if (to != NULL) {
        g_array_append_val(x, to[0]);
        g_array_append_val(y, to[1]);
    }
    curve.count = x->len;
    curve.x = keep(chart, x);
    curve.y = keep(chart, y);
    g_array_append_val(chart->curves, curve);
}

static gboolean any_at_limit(const TinkerTrade *trade)
{
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++)
            if (g_array_index(method->rows, TinkerTradeRow, i).at_limit) return TRUE;
    }
    return FALSE;
}

static void fill_chart(Chart *chart, const TinkerTrade *trade)
{
    for (guint m = 0; m < trade->methods->len; m++)
        add_method(chart, trade, m);
    double level = trade->reference.level;
    if (any_at_limit(trade) && chart->least_wall <= chart->greatest_wall)
        add_line(chart, (TinkerCurve){.label = "limit of the reference", .role = TINKER_CURVE_GUIDE},
                 (double[]){chart->least_wall, level}, (double[]){chart->greatest_wall, level});
    const TinkerTradeRow *advised = &trade->advice.row;
    if (trade->advice.kind != TINKER_TRADE_ADVICE_NONE)
        add_line(chart, (TinkerCurve){.label = chart->advised, .role = TINKER_CURVE_RING},
                 (double[]){advised->wall_s, drawn_error(trade, advised)}, NULL);
}

static char *advised_label(const TinkerTradeSetting *advised)
{
    if (advised->method == NULL || advised->value == 0)
        return g_strdup_printf("advised: %s", advised->method != NULL ? advised->method : "");
    return g_strdup_printf(advised->adaptive ? "advised: %s, tolerance %.3g" : "advised: %s, step %.3g s",
                           advised->method, advised->value);
}

gboolean tinker_trade_draw_chart(const TinkerTrade *trade, const char *title, const TinkerTheme *theme, int width,
                                 int height, const char *path, GError **error)
{
    const TinkerTradeSetting *advised = &trade->advice.row.setting;
    g_autofree char *label = advised_label(advised);
    Chart chart = {
        .curves = g_array_new(FALSE, FALSE, sizeof(TinkerCurve)),
        .points = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref),
        .least_wall = INFINITY,
        .greatest_wall = -INFINITY,
        .advised = label,
    };
    fill_chart(&chart, trade);
    TinkerPlot plot = {
        .title = title,
        .x_label = "Wall time [s]",
        .y_label = "Error, relative",
        .x_logarithmic = TRUE,
        .y_logarithmic = TRUE,
        .curves = (const TinkerCurve *)(gpointer)chart.curves->data,
        .curve_count = (int)chart.curves->len,
        .theme = theme,
    };
    gboolean done = tinker_plot_to_file(&plot, width, height, path, error);
    g_array_unref(chart.curves);
    g_ptr_array_unref(chart.points);
    return done;
}

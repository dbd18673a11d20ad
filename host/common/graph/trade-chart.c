/* The work-precision chart of a trade. Each curve goes with the list of the measurements that its points stand for. */
#include "common/graph/trade-chart.h"

#include <glib/gi18n.h>
#include <math.h>

struct _TinkerTradeChart {
    const TinkerTrade *trade;
    GArray *curves;    /* of TinkerCurve */
    GPtrArray *points; /* of GArray of double, which the curves borrow */
    GPtrArray *rows;   /* of GPtrArray of const TinkerTradeRow *, one a curve */
    double least_wall, greatest_wall;
    char *advised; /* label of its point */
};

/* An error of 0 has no place on a logarithmic axis: what the reference is confirmed to stands for all below it. */
static double drawn_error(const TinkerTrade *trade, const TinkerTradeRow *row)
{
    return fmax(row->error, 0.1 * trade->reference.level);
}

/* Points that are added from here on are this curve's. */
static void begin_curve(TinkerTradeChart *chart, TinkerCurve curve)
{
    for (int i = 0; i < 2; i++)
        g_ptr_array_add(chart->points, g_array_new(FALSE, FALSE, sizeof(double)));
    g_ptr_array_add(chart->rows, g_ptr_array_new());
    g_array_append_val(chart->curves, curve);
}

static void add_point(TinkerTradeChart *chart, double wall, double error, const TinkerTradeRow *row)
{
    GArray *x = g_ptr_array_index(chart->points, chart->points->len - 2);
    GArray *y = g_ptr_array_index(chart->points, chart->points->len - 1);
    TinkerCurve *curve = &g_array_index(chart->curves, TinkerCurve, chart->curves->len - 1);
    g_array_append_val(x, wall);
    g_array_append_val(y, error);
    g_ptr_array_add(g_ptr_array_index(chart->rows, chart->rows->len - 1), (gpointer)row);
    curve->x = (const double *)(gpointer)x->data;
    curve->y = (const double *)(gpointer)y->data;
    curve->count = x->len;
}

static gboolean has_result(const TinkerTradeRow *row)
{
    return !isnan(row->error) && !isnan(row->wall_s);
}

static void add_method(TinkerTradeChart *chart, guint number)
{
    const TinkerTradeMethod *method = g_ptr_array_index(chart->trade->methods, number);
    gboolean begun = FALSE;
    for (guint i = 0; i < method->rows->len; i++) {
        const TinkerTradeRow *row = &g_array_index(method->rows, TinkerTradeRow, i);
        if (!has_result(row)) continue;
        if (!begun) begin_curve(chart, (TinkerCurve){.label = method->id, .colour = (int)number, .markers = TRUE});
        begun = TRUE;
        add_point(chart, row->wall_s, drawn_error(chart->trade, row), row);
        chart->least_wall = fmin(chart->least_wall, row->wall_s);
        chart->greatest_wall = fmax(chart->greatest_wall, row->wall_s);
    }
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

static char *advised_label(const TinkerTradeSetting *advised)
{
    if (advised->method == NULL || advised->value == 0)
        return g_strdup_printf(_("advised: %s"), advised->method != NULL ? advised->method : "");
    return g_strdup_printf(advised->adaptive ? _("advised: %s, tolerance %.3g") : _("advised: %s, step %.3g s"),
                           advised->method, advised->value);
}

TinkerTradeChart *tinker_trade_chart_new(const TinkerTrade *trade)
{
    TinkerTradeChart *chart = g_new0(TinkerTradeChart, 1);
    const TinkerTradeRow *advised = &trade->advice.row;
    *chart = (TinkerTradeChart){
        .trade = trade,
        .curves = g_array_new(FALSE, FALSE, sizeof(TinkerCurve)),
        .points = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref),
        .rows = g_ptr_array_new_with_free_func((GDestroyNotify)g_ptr_array_unref),
        .least_wall = INFINITY,
        .greatest_wall = -INFINITY,
        .advised = advised_label(&advised->setting),
    };
    for (guint m = 0; m < trade->methods->len; m++)
        add_method(chart, m);
    if (any_at_limit(trade) && chart->least_wall <= chart->greatest_wall) {
        begin_curve(chart, (TinkerCurve){.label = _("limit of the reference"), .role = TINKER_CURVE_GUIDE});
        add_point(chart, chart->least_wall, trade->reference.level, NULL);
        add_point(chart, chart->greatest_wall, trade->reference.level, NULL);
    }
    if (trade->advice.kind != TINKER_TRADE_ADVICE_NONE) {
        begin_curve(chart, (TinkerCurve){.label = chart->advised, .role = TINKER_CURVE_RING});
        add_point(chart, advised->wall_s, drawn_error(trade, advised), advised);
    }
    return chart;
}

void tinker_trade_chart_free(TinkerTradeChart *chart)
{
    if (chart == NULL) return;
    g_array_unref(chart->curves);
    g_ptr_array_unref(chart->points);
    g_ptr_array_unref(chart->rows);
    g_free(chart->advised);
    g_free(chart);
}

TinkerPlot tinker_trade_chart_plot(const TinkerTradeChart *chart, const TinkerTheme *theme)
{
    return (TinkerPlot){
        .x_label = _("Wall time [s]"),
        .y_label = _("Error, relative"),
        .x_logarithmic = TRUE,
        .y_logarithmic = TRUE,
        .curves = (const TinkerCurve *)(gpointer)chart->curves->data,
        .curve_count = (int)chart->curves->len,
        .theme = theme,
    };
}

const TinkerTradeRow *tinker_trade_chart_row(const TinkerTradeChart *chart, int curve, gsize point)
{
    if (curve < 0 || curve >= (int)chart->rows->len) return NULL;
    const GPtrArray *rows = g_ptr_array_index(chart->rows, curve);
    return point < rows->len ? g_ptr_array_index(rows, point) : NULL;
}

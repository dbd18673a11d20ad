/* One row a curve and statistic: the number, its error, its unit. */
#include "cli/report/statistics-report.h"

#include <cjson/cJSON.h>
#include <math.h>

#include "cli/report/chart-private.h"
#include "cli/report/text-table.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"

typedef enum { OF_CURVE, OF_TIME, PLAIN } UnitKind;

static const struct {
    const char *name;
    gsize offset;
    UnitKind unit;
} rows[] = {
    {"mean", offsetof(TinkerStatistics, mean), OF_CURVE},
    {"rms", offsetof(TinkerStatistics, rms), OF_CURVE},
    {"min", offsetof(TinkerStatistics, least), OF_CURVE},
    {"max", offsetof(TinkerStatistics, greatest), OF_CURVE},
    {"amplitude", offsetof(TinkerStatistics, amplitude), OF_CURVE},
    {"period", offsetof(TinkerStatistics, period), OF_TIME},
    {"decrement", offsetof(TinkerStatistics, decrement), PLAIN},
    {"damping", offsetof(TinkerStatistics, damping), PLAIN},
};

static void add_cells(TinkerTextTable *table, const TinkerChartCurve *curve, const TinkerStatistics *found)
{
    for (gsize k = 0; k < G_N_ELEMENTS(rows); k++) {
        const TinkerStatistic *statistic = G_STRUCT_MEMBER_P(found, rows[k].offset);
        const char *unit = rows[k].unit == OF_CURVE ? curve->axis.unit : rows[k].unit == OF_TIME ? "s" : "";
        /* 0 is written without a minus */
        g_autofree char *value =
            isnan(statistic->value) ? g_strdup("-") : g_strdup_printf("%.9g", 0.0 + statistic->value);
        g_autofree char *error = isnan(statistic->error) ? g_strdup("-") : g_strdup_printf("%.1g", statistic->error);
        tinker_text_table_add(table, k == 0 ? curve->name : "");
        tinker_text_table_add(table, rows[k].name);
        tinker_text_table_add(table, value);
        tinker_text_table_add(table, error);
        tinker_text_table_add(table, unit);
    }
}

/* Why it has no period, or no damping, as a line each. */
static void add_reasons(GString *reasons, const TinkerChartCurve *curve, const TinkerStatistics *found)
{
    if (found->no_period != TINKER_SWINGS_GOOD)
        g_string_append_printf(reasons, "  %s: no period: %s\n", curve->name, tinker_swings_why(found->no_period));
    if (found->no_damping != TINKER_SWINGS_GOOD && found->no_damping != found->no_period)
        g_string_append_printf(reasons, "  %s: no decrement: %s\n", curve->name, tinker_swings_why(found->no_damping));
}

static void add_number(cJSON *object, const char *key, double value)
{
    if (isfinite(value))
        cJSON_AddNumberToObject(object, key, value);
    else
        cJSON_AddNullToObject(object, key);
}

static void add_json(cJSON *curves, const TinkerChartCurve *curve, const TinkerStatistics *found)
{
    cJSON *object = cJSON_CreateObject();
    cJSON_AddStringToObject(object, "curve", curve->name);
    cJSON_AddStringToObject(object, "unit", curve->axis.unit);
    for (gsize k = 0; k < G_N_ELEMENTS(rows); k++) {
        const TinkerStatistic *statistic = G_STRUCT_MEMBER_P(found, rows[k].offset);
        cJSON *entry = cJSON_AddObjectToObject(object, rows[k].name);
        add_number(entry, "value", statistic->value);
        add_number(entry, "error", statistic->error);
    }
    cJSON_AddItemToArray(curves, object);
}

/* How far the run may have the curve off within the interval: 0 where nobody asked, NAN where that is not known. Of a
 * formula it may be more between samples than at them. */
static gboolean find_run_error(const TinkerChart *chart, const TinkerChartCurve *curve, double from, double to,
                               double *largest, GError **error)
{
    g_autofree double *row = g_new(double, tinker_chart_width(chart));
    const gsize count = chart->record == NULL ? 0 : tinker_record_rows(chart->record);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double)),
                      bands = g_array_new(FALSE, FALSE, sizeof(double));
    *largest = 0;
    for (gsize i = 0; chart->has_bands && curve->table == NULL && i < count; i++) {
        if (!tinker_record_read(chart->record, i, 1, row, error)) return FALSE;
        const double band = curve->axis.per_si * tinker_chart_band(chart, curve, row);
        if (row[0] >= from && row[0] <= to && !(band <= *largest)) *largest = band; /* NAN from where it is not known */
        g_array_append_val(times, row[0]);
        g_array_append_val(bands, band);
    }
    if (curve->formula != NULL && bands->len > 0)
        *largest = tinker_greatest_about((const double *)(gconstpointer)times->data,
                                         (const double *)(gconstpointer)bands->data, bands->len, from, to);
    return TRUE;
}

static gboolean measure(const TinkerChart *chart, const TinkerChartCurve *curve, double from, double to,
                        TinkerStatistics *found, GError **error)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double)),
                      values = g_array_new(FALSE, FALSE, sizeof(double));
    if (!tinker_chart_read_curve(chart, curve, times, values, error)) return FALSE;
    const double *t = (const double *)(gconstpointer)times->data, *y = (const double *)(gconstpointer)values->data;
    double largest;
    if (!find_run_error(chart, curve, from, to, &largest, error)) return FALSE;
    if (times->len > 0 &&
        tinker_statistics(t, y, times->len, fmax(from, t[0]), fmin(to, t[times->len - 1]), largest, found))
        return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "%s: too few samples from %g s to %g s for statistics (let the run last longer)", curve->name, from,
                to);
    return FALSE;
}

gboolean tinker_statistics_report(const TinkerChart *chart, double from, double to, FILE *text, FILE *json,
                                  GError **error)
{
    static const char *const headings[] = {"CURVE", "STATISTIC", "VALUE", "ERROR", "UNIT"};
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("llrrl", 2);
    g_autoptr(GString) reasons = g_string_new("");
    cJSON *root = cJSON_CreateObject(), *curves;
    add_number(root, "from", from);
    add_number(root, "to", to);
    curves = cJSON_AddArrayToObject(root, "curves");
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    gboolean good = TRUE;
    for (guint i = 0; good && i < chart->curves->len; i++) {
        const TinkerChartCurve *curve = &g_array_index(chart->curves, TinkerChartCurve, i);
        TinkerStatistics found;
        good = measure(chart, curve, from, to, &found, error);
        if (!good) break;
        add_cells(table, curve, &found);
        add_reasons(reasons, curve, &found);
        add_json(curves, curve, &found);
    }
    if (good && text != NULL) {
        tinker_text_table_write(table, text);
        tinker_print_text(text, reasons->str);
    }
    if (good && json != NULL) {
        char *printed = cJSON_Print(root);
        tinker_print_text(json, printed);
        cJSON_free(printed);
    }
    cJSON_Delete(root);
    return good;
}

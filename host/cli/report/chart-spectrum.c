/* Charts: spectra of their curves, and these as CSV. Drawn they are in chart-draw.c. */
#include <math.h>

#include "cli/command/output.h"
#include "cli/report/chart-private.h"
#include "common/program/exit-status.h"

gboolean tinker_chart_read_curve(const TinkerChart *chart, const TinkerChartCurve *curve, GArray *times, GArray *values,
                                 GError **error)
{
    g_autofree double *row = g_new(double, tinker_chart_width(chart));
    gsize count = chart->record == NULL ? 0 : tinker_record_rows(chart->record);
    for (gsize i = 0; curve->table == NULL && i < count; i++) {
        if (!tinker_record_read(chart->record, i, 1, row, error)) return FALSE;
        const double value = curve->axis.per_si * tinker_chart_value(curve, row);
        g_array_append_val(times, row[0]);
        g_array_append_val(values, value);
    }
    for (guint i = 0; curve->table != NULL && i + 1 < curve->table->len; i += 2) {
        const double value = curve->axis.per_si * g_array_index(curve->table, double, i + 1);
        g_array_append_val(times, g_array_index(curve->table, double, i));
        g_array_append_val(values, value);
    }
    return TRUE;
}

static void spectrum_free(gpointer data)
{
    TinkerChartSpectrum *spectrum = data;
    g_array_unref(spectrum->frequencies);
    g_array_unref(spectrum->amplitudes);
    g_free(spectrum);
}

static gboolean add_spectrum(GPtrArray *spectra, const TinkerChart *chart, const TinkerChartCurve *curve,
                             const TinkerSpectrumOptions *options, GError **error)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double)),
                      values = g_array_new(FALSE, FALSE, sizeof(double));
    TinkerChartSpectrum *spectrum = g_new(TinkerChartSpectrum, 1);
    *spectrum = (TinkerChartSpectrum){curve, g_array_new(FALSE, FALSE, sizeof(double)),
                                      g_array_new(FALSE, FALSE, sizeof(double))};
    g_ptr_array_add(spectra, spectrum);
    if (!tinker_chart_read_curve(chart, curve, times, values, error)) return FALSE;
    if (tinker_spectrum_of_curve((const double *)(gconstpointer)times->data,
                                 (const double *)(gconstpointer)values->data, times->len, options->from, options->to,
                                 options->window, spectrum->frequencies, spectrum->amplitudes))
        return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "%s: too few evenly spaced samples from %g s to %g s for a spectrum (record more often, or longer)",
                curve->name, options->from, options->to);
    return FALSE;
}

GPtrArray *tinker_chart_spectra(const TinkerChart *chart, const TinkerSpectrumOptions *options, GError **error)
{
    g_autoptr(GPtrArray) spectra = g_ptr_array_new_with_free_func(spectrum_free);
    for (guint i = 0; i < chart->curves->len; i++)
        if (!add_spectrum(spectra, chart, &g_array_index(chart->curves, TinkerChartCurve, i), options, error))
            return NULL;
    return g_steal_pointer(&spectra);
}

/* CSV -------------------------------------------------------------------------------------------------------------- */

static const TinkerChartSpectrum *spectrum_at(const GPtrArray *spectra, guint number)
{
    return g_ptr_array_index(spectra, number);
}

/* Whether a spectrum has frequencies that the one before it does not have: that of a table. */
static gboolean has_own_frequencies(const GPtrArray *spectra, guint number)
{
    return number == 0 || spectrum_at(spectra, number)->curve->table != NULL ||
           spectrum_at(spectra, number - 1)->curve->table != NULL;
}

static void write_headings(TinkerCsvWriter *writer, const TinkerChart *chart, const GPtrArray *spectra)
{
    const TinkerGraphAxis frequency = tinker_graph_axis_frequency();
    for (guint k = 0; k < spectra->len; k++) {
        if (has_own_frequencies(spectra, k)) tinker_csv_axis(writer, chart->scene, &frequency, FALSE);
        tinker_csv_axis(writer, chart->scene, &spectrum_at(spectra, k)->curve->axis, spectra->len > 1);
    }
    tinker_csv_end_row(writer);
}

static void write_cell(TinkerCsvWriter *writer, const GArray *numbers, guint row)
{
    if (row < numbers->len)
        tinker_csv_number(writer, g_array_index(numbers, double, row));
    else
        tinker_csv_text(writer, "");
}

gboolean tinker_chart_write_spectrum_csv(TinkerChart *chart, const TinkerSpectrumOptions *options, int decimals,
                                         const char *path, GError **error)
{
    g_autoptr(GPtrArray) spectra = tinker_chart_spectra(chart, options, error);
    g_auto(TinkerOutput) output = {0};
    guint rows = 0;
    if (spectra == NULL || !tinker_output_open(&output, path, error)) return FALSE;
    g_auto(TinkerCsvWriter) writer = tinker_csv_writer_graph(output.file, decimals);
    write_headings(&writer, chart, spectra);
    for (guint k = 0; k < spectra->len; k++)
        rows = MAX(rows, spectrum_at(spectra, k)->amplitudes->len);
    for (guint row = 0; row < rows; row++) {
        for (guint k = 0; k < spectra->len; k++) {
            if (has_own_frequencies(spectra, k)) write_cell(&writer, spectrum_at(spectra, k)->frequencies, row);
            write_cell(&writer, spectrum_at(spectra, k)->amplitudes, row);
        }
        tinker_csv_end_row(&writer);
    }
    return tinker_output_close(&output, error);
}

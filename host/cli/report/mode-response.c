/* A response along a grid of frequencies, and what is made of it. */
#include "cli/report/mode-response.h"

#include <math.h>

#include "cli/command/output.h"
#include "common/program/csv-writer.h"
#include "common/program/exit-status.h"
#include "render/plot/plot-stack.h"

#define DEGREES (180 / G_PI)
/* Peaks that the legend names: the highest. */
#define MOST_NAMED 5

static gboolean find_ends(TinkerModeResponse *made, const TinkerModeAnalysis *analysis, TinkerScene *scene,
                          const TinkerModeResponseWish *wish, GError **error)
{
    made->columns = tinker_columns_new();
    if (!tinker_columns_add(made->columns, scene, wish->output, error) ||
        !tinker_linear_input_find(analysis->model, wish->input, &made->input, error)) {
        tinker_blame_option("response", error);
        return FALSE;
    }
    const TinkerColumn *column = &g_array_index(made->columns, TinkerColumn, 0);
    made->name = g_strdup_printf("%s per %s", wish->output, wish->input);
    made->unit = tinker_frequency_response_unit(column->unit, made->input.unit);
    return tinker_linear_output_find(analysis->model, analysis->q, column, &made->input, &made->output, error);
}

/* Counterphase is -180 whichever side rounding falls to. */
static double degrees(double complex at)
{
    double phase = carg(at) * DEGREES;
    return phase > 179.9999999 ? phase - 360 : phase;
}

static void sample(TinkerModeResponse *made)
{
    made->amplitude = g_array_new(FALSE, FALSE, sizeof(double));
    made->phase = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < made->grid->len; i++) {
        double complex at = tinker_frequency_response_at(made->response, g_array_index(made->grid, double, i));
        double amplitude = cabs(at), phase = isfinite(amplitude) ? degrees(at) : NAN;
        g_array_append_val(made->amplitude, amplitude);
        g_array_append_val(made->phase, phase);
    }
}

gboolean tinker_mode_response_make(TinkerModeResponse *made, const TinkerModeAnalysis *analysis, TinkerScene *scene,
                                   const TinkerModeResponseWish *wish, GError **error)
{
    double from, to;
    if (!find_ends(made, analysis, scene, wish, error)) return FALSE;
    made->response =
        tinker_frequency_response_new(analysis->linear, analysis->basis, &made->input, &made->output, error);
    if (made->response == NULL) return FALSE;
    tinker_frequency_response_range(analysis->modes, &from, &to);
    if (wish->to > 0) to = wish->to;
    if (wish->to > 0 && wish->from == 0 && from >= to) from = to / 100;
    if (wish->from > 0) from = wish->from;
    if (wish->from > 0 && wish->to == 0 && to <= from) to = 100 * from;
    if (from >= to) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--from %g Hz: not below --to %g Hz (give a range that begins below its end)", from / (2 * G_PI),
                    to / (2 * G_PI));
        return FALSE;
    }
    made->linear = wish->linear;
    made->grid = tinker_frequency_response_grid(analysis->modes, from, to, wish->points, !wish->linear);
    made->peaks = tinker_frequency_response_peaks(made->response, made->grid);
    sample(made);
    return TRUE;
}

void tinker_mode_response_clear(TinkerModeResponse *made)
{
    tinker_linear_input_clear(&made->input);
    tinker_linear_output_clear(&made->output);
    g_clear_pointer(&made->response, tinker_frequency_response_free);
    GArray **arrays[] = {&made->columns, &made->grid, &made->amplitude, &made->phase, &made->peaks};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_clear_pointer(arrays[i], g_array_unref);
    g_clear_pointer(&made->name, g_free);
    g_clear_pointer(&made->unit, g_free);
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

static const double *numbers(const GArray *array)
{
    return (const double *)(gconstpointer)array->data;
}

static int compare_heights(const void *left, const void *right)
{
    double l = cabs(((const TinkerResponsePeak *)left)->at), r = cabs(((const TinkerResponsePeak *)right)->at);
    return (l < r) - (l > r);
}

static char *peak_label(const TinkerResponsePeak *peak)
{
    double hertz = peak->omega / (2 * G_PI), height = cabs(peak->at);
    return isfinite(height) ? g_strdup_printf("peak %.4g at %.4g Hz", height, hertz)
                            : g_strdup_printf("no bound at %.4g Hz", hertz);
}

/* One point of a panel, in the colour of its peak. */
static TinkerCurve mark(const double point[2], int peak, const char *label)
{
    return (TinkerCurve){.label = label,
                         .x = &point[0],
                         .y = &point[1],
                         .count = 1,
                         .colour = peak + 1,
                         .markers = TRUE,
                         .no_line = TRUE};
}

/* What the panels show of the highest peaks. */
typedef struct {
    int count;
    double amplitude[MOST_NAMED][2], phase[MOST_NAMED][2];
    char *labels[MOST_NAMED];
} NamedPeaks;

/* A peak without bound stands as high as the curve is drawn. */
static void name_peaks(const TinkerModeResponse *made, NamedPeaks *named)
{
    g_autoptr(GArray) highest = g_array_copy(made->peaks);
    double top = 0;
    for (guint i = 0; i < made->amplitude->len; i++)
        if (isfinite(numbers(made->amplitude)[i])) top = fmax(top, numbers(made->amplitude)[i]);
    g_array_sort(highest, compare_heights);
    named->count = (int)MIN(highest->len, MOST_NAMED);
    for (int i = 0; i < named->count; i++) {
        const TinkerResponsePeak *peak = &g_array_index(highest, TinkerResponsePeak, i);
        gboolean bounded = isfinite(cabs(peak->at));
        named->amplitude[i][0] = named->phase[i][0] = peak->omega / (2 * G_PI);
        named->amplitude[i][1] = bounded ? cabs(peak->at) : top;
        named->phase[i][1] = bounded ? degrees(peak->at) : NAN;
        named->labels[i] = peak_label(peak);
    }
}

/* Phases jump by 360 degrees where they leave the circle: the curve is interrupted there. */
static void interrupt_jumps(const TinkerModeResponse *made, const double *hertz, GArray *x, GArray *y)
{
    const double nothing = NAN;
    for (guint i = 0; i < made->phase->len; i++) {
        double phase = numbers(made->phase)[i];
        if (i > 0 && fabs(phase - numbers(made->phase)[i - 1]) > 270) {
            g_array_append_val(x, hertz[i]);
            g_array_append_val(y, nothing);
        }
        g_array_append_val(x, hertz[i]);
        g_array_append_val(y, phase);
    }
}

gboolean tinker_mode_response_draw(const TinkerModeResponse *made, const TinkerTheme *theme, int width, int height,
                                   const char *path, GError **error)
{
    TinkerCurve above[MOST_NAMED + 1], below[MOST_NAMED + 1];
    NamedPeaks named = {0};
    g_autoptr(GArray) x = g_array_new(FALSE, FALSE, sizeof(double)), y = g_array_new(FALSE, FALSE, sizeof(double));
    g_autofree double *hertz = g_new0(double, MAX(made->grid->len, 1));
    for (guint i = 0; i < made->grid->len; i++)
        hertz[i] = numbers(made->grid)[i] / (2 * G_PI);
    interrupt_jumps(made, hertz, x, y);
    name_peaks(made, &named);
    above[0] = (TinkerCurve){.x = hertz, .y = numbers(made->amplitude), .count = made->grid->len};
    below[0] = (TinkerCurve){.x = numbers(x), .y = numbers(y), .count = x->len};
    for (int i = 0; i < named.count; i++) {
        above[i + 1] = mark(named.amplitude[i], i, named.labels[i]);
        below[i + 1] = mark(named.phase[i], i, NULL);
    }
    g_autofree char *amplitude = g_strdup_printf("Amplitude [%s]", made->unit);
    TinkerPlot panel = {
        .x_label = "Frequency [Hz]", .x_logarithmic = !made->linear, .curve_count = named.count + 1, .theme = theme};
    TinkerStackedPlot plots[] = {{panel, 0.6}, {panel, 0.4}};
    plots[0].plot.title = made->name;
    plots[0].plot.y_label = amplitude;
    plots[0].plot.y_logarithmic = !made->linear;
    plots[0].plot.curves = above;
    plots[1].plot.y_label = "Phase [deg]";
    plots[1].plot.curves = below;
    gboolean drawn = tinker_plot_stack_to_file(plots, G_N_ELEMENTS(plots), width, height, path, error);
    for (int i = 0; i < named.count; i++)
        g_free(named.labels[i]);
    return drawn;
}

gboolean tinker_mode_response_write_csv(const TinkerModeResponse *made, const char *path, GError **error)
{
    g_auto(TinkerOutput) output = {0};
    if (!tinker_output_open(&output, path, error)) return FALSE;
    g_auto(TinkerCsvWriter) csv = tinker_csv_writer_record(output.file);
    g_autofree char *amplitude = g_strdup_printf("amplitude [%s]", made->unit);
    tinker_csv_text(&csv, "frequency [Hz]");
    tinker_csv_text(&csv, amplitude);
    tinker_csv_text(&csv, "phase [deg]");
    tinker_csv_end_row(&csv);
    for (guint i = 0; i < made->grid->len; i++) {
        tinker_csv_number(&csv, numbers(made->grid)[i] / (2 * G_PI));
        tinker_csv_number(&csv, numbers(made->amplitude)[i]);
        tinker_csv_number(&csv, numbers(made->phase)[i]);
        tinker_csv_end_row(&csv);
    }
    return tinker_output_close(&output, error);
}

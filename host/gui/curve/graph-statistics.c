/* A line a number, with how far it may be off; of what is not defined, as the period of what does not swing, why. */
#include <glib/gi18n.h>
#include <math.h>

#include "gui/curve/graph-data.h"
#include "measure/residuals.h"

#define LEAST_DIGITS 5
#define MOST_DIGITS  12

/* As many digits as the error leaves, zeros at their end too: a value that is cut short would look as if it missed by
 * more than its error. One that is less than it is rounded to the decade of the error: nothing beyond is known. */
void tinker_statistic_append(GString *text, const TinkerStatistic *statistic)
{
    const double size = fabs(statistic->value), error = statistic->error;
    if (size < error && isfinite(error)) {
        const double decade = pow(10, floor(log10(error))), rounded = round(size / decade) * decade;
        g_string_append_printf(text, "%s%g", statistic->value < 0 && rounded > 0 ? "−" : "", rounded);
        return;
    }
    double digits = size > 0 && error > 0 ? floor(log10(size)) - floor(log10(error)) + 1 : LEAST_DIGITS;
    digits = CLAMP(digits, LEAST_DIGITS, MOST_DIGITS);
    g_string_append_printf(text, "%s%#.*g", statistic->value < 0 ? "−" : "", (int)digits, size);
    if (text->str[text->len - 1] == '.') g_string_truncate(text, text->len - 1);
}

static void add_line(GString *text, const char *name, const TinkerStatistic *statistic, const char *unit,
                     TinkerSwings swings)
{
    if (!isfinite(statistic->value)) {
        g_string_append_printf(text, "%s: — (%s)\n", name, tinker_swings_why(swings));
        return;
    }
    const char *gap = unit[0] != '\0' ? " " : "";
    g_string_append_printf(text, "%s = ", name);
    tinker_statistic_append(text, statistic);
    g_string_append_printf(text, "%s%s ± %.1g%s%s\n", gap, unit, statistic->error, gap, unit);
}

static TinkerCurveSamples samples_of(const TinkerGraphSeries *series)
{
    return (TinkerCurveSamples){tinker_graph_series_times(series), tinker_graph_series_y(series),
                                tinker_graph_series_count(series)};
}

/* How well a curve fits each table of measured values that is drawn at its scale: in its unit, or in none. */
static void add_fits(GString *text, const TinkerGraphData *data, guint curve, const double range[2], double band)
{
    const TinkerGraphSeries *series = tinker_graph_data_curve(data, curve);
    const TinkerCurveSamples samples = samples_of(series);
    const char *unit = tinker_graph_series_y_axis(series)->unit;
    for (guint i = 0; i < tinker_graph_data_own_curves(data) && !tinker_graph_series_is_table(series); i++) {
        const TinkerGraphSeries *table = tinker_graph_data_curve(data, i);
        const TinkerCurveSamples measured = samples_of(table);
        const char *its = tinker_graph_series_y_axis(table)->unit;
        TinkerStatistic rms;
        gsize count;
        if (!tinker_graph_series_is_table(table) || !(its[0] == '\0' || g_str_equal(its, unit)) ||
            tinker_graph_series_is_right(table) != tinker_graph_series_is_right(series) ||
            !tinker_residuals(&samples, &measured, range[0], range[1], band, &rms, &count))
            continue;
        g_autofree char *name =
            g_strdup_printf(ngettext("Root mean square of the difference from “%s”, %u value",
                                     "Root mean square of the differences from “%s”, %u values", (gulong)count),
                            tinker_graph_data_name(data, i), (guint)count);
        add_line(text, name, &rms, unit, TINKER_SWINGS_GOOD);
    }
}

static void add_curve(GString *text, const TinkerGraphData *data, guint curve, const TinkerGraphPart *part)
{
    const TinkerGraphSeries *series = tinker_graph_data_curve(data, curve);
    const char *unit = tinker_graph_series_y_axis(series)->unit;
    const TinkerCurveSamples samples = samples_of(series);
    const gsize count = samples.count;
    TinkerStatistics found;
    g_string_append_printf(text, "%s\n", tinker_graph_data_name(data, curve));
    const double from = count > 0 ? fmax(samples.times[0], part != NULL ? part->from : -INFINITY) : 0;
    const double to = count > 0 ? fmin(samples.times[count - 1], part != NULL ? part->to : INFINITY) : 0;
    const double range[2] = {from, to};
    double error = 0;
    const gboolean known = tinker_graph_data_run_error(data, curve, from, to, &error);
    if (count == 0 || !(from < to) ||
        !tinker_statistics(samples.times, samples.values, count, from, to, known ? error : 0, &found)) {
        g_string_append_printf(text, "%s\n\n", _("too few samples"));
        return;
    }
    const TinkerSwings defined = isfinite(found.mean.value) ? TINKER_SWINGS_GOOD : TINKER_SWINGS_UNDEFINED;
    const struct {
        const char *name, *unit;
        const TinkerStatistic *statistic;
        TinkerSwings swings;
    } lines[] = {{_("Mean"), unit, &found.mean, defined},
                 {_("Root mean square"), unit, &found.rms, defined},
                 {_("Least"), unit, &found.least, defined},
                 {_("Greatest"), unit, &found.greatest, defined},
                 {_("Amplitude"), unit, &found.amplitude, defined},
                 {_("Period"), "s", &found.period, found.no_period},
                 {_("Logarithmic decrement"), "", &found.decrement, found.no_damping},
                 {_("Damping ratio"), "", &found.damping, found.no_damping}};
    g_string_append_printf(text,
                           part != NULL && part->between_cursors ? _("between cursors A and B, from %.5g to %.5g s")
                                                                 : _("from %.5g to %.5g s"),
                           from, to);
    g_string_append_c(text, '\n');
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++)
        add_line(text, lines[i].name, lines[i].statistic, lines[i].unit, lines[i].swings);
    add_fits(text, data, curve, range, known ? error : 0);
    if (!known) g_string_append_printf(text, "%s\n", _("without the error of the run, which is not known yet"));
    g_string_append_c(text, '\n');
}

char *tinker_graph_statistics_text(TinkerGraphData *data, const TinkerGraphPart *part)
{
    g_autoptr(GString) text = g_string_new(NULL);
    tinker_graph_data_catch_up(data);
    for (guint i = 0; i < tinker_graph_data_curves(data); i++)
        add_curve(text, data, i, part);
    return g_strdup(g_strchomp(text->str));
}

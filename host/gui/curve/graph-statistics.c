/* A line a number, with how far it may be off; what is not defined, as the period of what does not swing, is left out.
 */
#include <glib/gi18n.h>
#include <math.h>

#include "gui/curve/graph-data.h"
#include "measure/statistics.h"

static void add_line(GString *text, const char *name, const TinkerStatistic *statistic, const char *unit)
{
    if (!isfinite(statistic->value)) return;
    g_autofree char *value = tinker_graph_value_text(name, statistic->value, unit);
    g_string_append_printf(text, "%s ± %.1g\n", value, statistic->error);
}

static void add_curve(GString *text, const TinkerGraphData *data, guint curve, const double *range)
{
    const TinkerGraphSeries *series = tinker_graph_data_curve(data, curve);
    const double *times = tinker_graph_series_times(series);
    const char *unit = tinker_graph_series_y_axis(series)->unit;
    const gsize count = tinker_graph_series_count(series);
    TinkerStatistics found;
    g_string_append_printf(text, "%s\n", tinker_graph_data_name(data, curve));
    const double from = count > 0 ? fmax(times[0], range != NULL ? range[0] : -INFINITY) : 0;
    const double to = count > 0 ? fmin(times[count - 1], range != NULL ? range[1] : INFINITY) : 0;
    double error = 0;
    const gboolean known = tinker_graph_data_run_error(data, curve, from, to, &error);
    if (count == 0 || !(from < to) ||
        !tinker_statistics(times, tinker_graph_series_y(series), count, from, to, known ? error : 0, &found)) {
        g_string_append_printf(text, "%s\n\n", _("too few samples"));
        return;
    }
    const struct {
        const char *name, *unit;
        const TinkerStatistic *statistic;
    } lines[] = {{_("Mean"), unit, &found.mean},
                 {_("Root mean square"), unit, &found.rms},
                 {_("Least"), unit, &found.least},
                 {_("Greatest"), unit, &found.greatest},
                 {_("Amplitude"), unit, &found.amplitude},
                 {_("Period"), "s", &found.period},
                 {_("Logarithmic decrement"), "", &found.decrement},
                 {_("Damping ratio"), "", &found.damping}};
    g_string_append_printf(text, _("from %.5g to %.5g s"), from, to);
    g_string_append_c(text, '\n');
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++)
        add_line(text, lines[i].name, lines[i].statistic, lines[i].unit);
    if (!known) g_string_append_printf(text, "%s\n", _("without the error of the run, which is not known yet"));
    g_string_append_c(text, '\n');
}

char *tinker_graph_statistics_text(TinkerGraphData *data, const double *range)
{
    g_autoptr(GString) text = g_string_new(NULL);
    tinker_graph_data_catch_up(data);
    for (guint i = 0; i < tinker_graph_data_own_curves(data); i++)
        add_curve(text, data, i, range);
    return g_strdup(g_strchomp(text->str));
}

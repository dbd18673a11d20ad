/* The words of a graph: its title, the labels of its axes, the names of its curves, and what stands beside a point. */
#include <glib/gi18n.h>

#include "common/graph/graph-names.h"
#include "gui/curve/graph-data-private.h"
#include "gui/text/translate.h"

static const char *y_title(const TinkerGraphData *data, guint number)
{
    return tinker_translate(tinker_graph_series_y_axis(graph_line(data, number)->series)->title);
}

static TinkerCurveName curve_of(const TinkerGraphData *data, guint number)
{
    return (TinkerCurveName){tinker_graph_series_block(graph_line(data, number)->series), y_title(data, number)};
}

/* Of the curves of the graph, of TinkerCurveName. (transfer full) */
static GArray *own_curves(const TinkerGraphData *data)
{
    GArray *curves = g_array_new(FALSE, FALSE, sizeof(TinkerCurveName));
    for (guint i = 0; i < data->own; i++) {
        const TinkerCurveName curve = curve_of(data, i);
        g_array_append_val(curves, curve);
    }
    return curves;
}

typedef enum { AXIS_X, AXIS_LEFT, AXIS_RIGHT } AxisPlace;

/* (transfer full) */
static GArray *axes_of(const TinkerGraphData *data, AxisPlace place)
{
    GArray *axes = g_array_new(FALSE, FALSE, sizeof(TinkerGraphAxis));
    for (guint i = 0; i < data->lines->len; i++) {
        const TinkerGraphSeries *series = graph_line(data, i)->series;
        if (place != AXIS_X && tinker_graph_series_is_right(series) != (place == AXIS_RIGHT)) continue;
        TinkerGraphAxis axis =
            *(place == AXIS_X ? tinker_graph_series_x_axis(series) : tinker_graph_series_y_axis(series));
        axis.title = tinker_translate(axis.title);
        g_array_append_val(axes, axis);
    }
    return axes;
}

static char *label_of(const TinkerGraphData *data, AxisPlace place)
{
    g_autoptr(GArray) axes = axes_of(data, place);
    return tinker_graph_axes_label((const TinkerGraphAxis *)(gpointer)axes->data, axes->len);
}

static char *title_of(const TinkerGraphData *data)
{
    if (data->graph->title != NULL && data->graph->title[0] != '\0') return g_strdup(data->graph->title);
    g_autoptr(GArray) own = own_curves(data);
    g_autofree char *curves = tinker_curves_title((const TinkerCurveName *)(gpointer)own->data, own->len);
    if (data->own == 1 && !data->over_time && !data->is_spectrum)
        return g_strdup_printf(_("%s over %s"), curves,
                               tinker_translate(tinker_graph_series_x_axis(graph_line(data, 0)->series)->title));
    return data->is_spectrum ? g_strdup_printf(_("Spectrum of %s"), curves) : g_steal_pointer(&curves);
}

static gboolean has_several_units(const TinkerGraphData *data, gboolean right)
{
    g_autoptr(GArray) axes = axes_of(data, right ? AXIS_RIGHT : AXIS_LEFT);
    for (guint i = 1; i < axes->len; i++)
        if (!g_str_equal(g_array_index(axes, TinkerGraphAxis, i).unit, g_array_index(axes, TinkerGraphAxis, 0).unit))
            return TRUE;
    return FALSE;
}

/* What they measure is the amplitude of what they are called. */
static void call_amplitudes(TinkerGraphData *data)
{
    char **labels[] = {&data->y_label, &data->right_label};
    g_free(data->x_label);
    data->x_label = g_strdup(_("Frequency [Hz] (window: Hann)"));
    for (gsize i = 0; i < G_N_ELEMENTS(labels); i++) {
        if (*labels[i] == NULL) continue;
        g_autofree char *label = *labels[i];
        *labels[i] = g_strdup_printf(_("Amplitude: %s"), label);
    }
}

/* Several runs of one curve are told apart by the run alone. (transfer full) */
static char *with_run(const TinkerGraphData *data, const char *name, const char *run)
{
    if (run == NULL) return g_strdup(name);
    return data->own == 1 ? g_strdup(run) : g_strdup_printf("%s (%s)", name, run);
}

/* `now` is what the present run is called beside those that are kept. */
static void name_line(TinkerGraphData *data, guint number, const GArray *own, const char *now)
{
    GraphLine *line = graph_line(data, number);
    const TinkerGraphSeries *series = line->series;
    const TinkerCurveName curve = curve_of(data, number), *all = (const TinkerCurveName *)(gconstpointer)own->data;
    g_autofree char *plain = tinker_curve_name(&curve, all, own->len),
                    *short_name = tinker_curve_legend(&curve, all, own->len);
    g_free(line->run_name);
    line->run_name = line->run != NULL ? tinker_kept_runs_name_beside(tinker_player_kept(data->player), line->run,
                                                                      tinker_document_scene(data->document))
                                       : NULL;
    const gboolean among_runs = data->lines->len > data->own && !tinker_graph_series_is_table(series);
    const char *run = !among_runs ? NULL : line->run != NULL ? line->run_name : now;
    g_free(line->name);
    line->name = with_run(data, plain, run);
    g_autofree char *in_legend = with_run(data, short_name, run);
    g_free(line->label);
    line->label = has_several_units(data, tinker_graph_series_is_right(series))
                      ? tinker_axis_label(in_legend, tinker_graph_series_y_axis(series)->unit)
                      : g_steal_pointer(&in_legend);
}

void graph_data_renew_texts(TinkerGraphData *data)
{
    char **texts[] = {&data->title, &data->x_label, &data->y_label, &data->right_label};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_clear_pointer(texts[i], g_free);
    g_autoptr(GArray) own = own_curves(data);
    g_autofree char *now =
        tinker_kept_runs_present_name(tinker_player_kept(data->player), tinker_document_scene(data->document));
    data->title = title_of(data);
    data->x_label = label_of(data, AXIS_X);
    data->y_label = label_of(data, AXIS_LEFT);
    data->right_label = label_of(data, AXIS_RIGHT);
    if (data->is_spectrum) call_amplitudes(data);
    for (guint i = 0; i < data->lines->len; i++)
        name_line(data, i, own, now);
}

char *tinker_graph_value_text(const char *name, double value, const char *unit)
{
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(number, sizeof number, "%.5g", value + 0.0);
    const char *gap = unit[0] != '\0' ? " " : "";
    return number[0] == '-' ? g_strdup_printf("%s = −%s%s%s", name, number + 1, gap, unit)
                            : g_strdup_printf("%s = %s%s%s", name, number, gap, unit);
}

char *tinker_graph_data_place_text(const TinkerGraphData *data, const char *before, double place)
{
    g_autofree char *name = g_strconcat(before, data->is_spectrum ? "f" : "t", NULL);
    return tinker_graph_value_text(name, place, data->is_spectrum ? "Hz" : "s");
}

char *tinker_graph_data_x_text(const TinkerGraphData *data, guint curve, gsize point)
{
    const TinkerGraphSeries *series = graph_line(data, curve)->series;
    if (data->is_spectrum) return tinker_graph_data_place_text(data, "", tinker_graph_series_x(series)[point]);
    g_autofree char *time = tinker_graph_value_text("t", tinker_graph_series_times(series)[point], "s");
    if (data->over_time) return g_steal_pointer(&time);
    g_autofree char *x = tinker_graph_value_text(data->graph->against, tinker_graph_series_x(series)[point],
                                                 tinker_graph_series_x_axis(series)->unit);
    return g_strdup_printf("%s, %s", time, x);
}

/* The graph that is worked at, which is the one that has or had the focus last, has its first curve's maxima and minima
 * marked on the time line. */
#include <math.h>

#include "gui/curve/graph-reading.h"
#include "gui/graph/graph-view.h"
#include "gui/window/event-marks.h"
#include "gui/window/window-parts.h"

#define EVERY_MS 200       /* while it is recorded */
#define MOST     120       /* of more, none could be told from another, nor be clicked */
#define EXTREMA  "extrema" /* data of the window */

typedef struct {
    TinkerWindow *window;  /* borrowed: it owns this */
    TinkerGraphView *view; /* weak: whose curve it is; NULL */
    guint64 revision;      /* of the data that is marked */
    guint timer;           /* or 0 */
} Extrema;

static void free_extrema(gpointer data)
{
    Extrema *extrema = data;
    g_signal_handlers_disconnect_by_data(extrema->window, extrema);
    g_signal_handlers_disconnect_by_data(extrema->window->player, extrema);
    g_signal_handlers_disconnect_by_data(extrema->window->document, extrema);
    g_clear_weak_pointer(&extrema->view);
    g_clear_handle_id(&extrema->timer, g_source_remove);
    g_free(extrema);
}

static void add_mark(GPtrArray *marks, const TinkerGraphSeries *series, const TinkerGraphReading *reading)
{
    TinkerRunEvent *mark = g_new(TinkerRunEvent, 1);
    *mark = (TinkerRunEvent){reading->at[0], tinker_graph_reading_text(series, reading)};
    g_ptr_array_add(marks, mark);
}

static void show_marks(Extrema *extrema, const TinkerGraphSeries *series)
{
    g_autoptr(GPtrArray) maxima = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_run_event_free);
    g_autoptr(GPtrArray) minima = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_run_event_free);
    g_autoptr(GArray) found = series != NULL ? tinker_graph_reading_extrema(series, MOST + 1) : NULL;
    for (guint i = 0; found != NULL && found->len <= MOST && i < found->len; i++) {
        const TinkerGraphReading *reading = &g_array_index(found, TinkerGraphReading, i);
        add_mark(reading->kind == TINKER_READING_MAXIMUM ? maxima : minima, series, reading);
    }
    tinker_event_marks_set_extrema(tinker_playbar_marks(extrema->window->playbar), maxima, minima);
}

static void look(Extrema *extrema);

static gboolean on_timer(gpointer data)
{
    Extrema *extrema = data;
    extrema->timer = 0;
    look(extrema);
    return G_SOURCE_REMOVE;
}

static void look_later(Extrema *extrema)
{
    if (extrema->timer == 0) extrema->timer = g_timeout_add(EVERY_MS, on_timer, extrema);
}

static void look(Extrema *extrema)
{
    TinkerGraphData *data = extrema->view != NULL ? tinker_graph_view_data(extrema->view) : NULL;
    TinkerRunStatus status;
    const gboolean can = data != NULL && tinker_graph_data_is_over_time(data) && tinker_graph_data_own_curves(data) > 0;
    if (can) tinker_graph_data_update(data);
    const gsize count = can ? tinker_graph_data_count(data) : 0;
    const guint64 revision = tinker_player_generation(extrema->window->player) + ((guint64)count << 32);
    if (revision != extrema->revision) show_marks(extrema, can ? tinker_graph_data_curve(data, 0) : NULL);
    extrema->revision = revision;
    const gboolean grows = tinker_player_status(extrema->window->player, &status) && !status.finished;
    if (can && (grows || tinker_graph_data_is_behind(data))) look_later(extrema);
}

static void on_focus(TinkerWindow *window, GParamSpec *spec, Extrema *extrema)
{
    GtkWidget *focus = gtk_window_get_focus(GTK_WINDOW(window));
    if (focus == NULL) return;
    GtkWidget *view = TINKER_IS_GRAPH_VIEW(focus) ? focus : gtk_widget_get_ancestor(focus, TINKER_TYPE_GRAPH_VIEW);
    if (view == NULL || view == (GtkWidget *)extrema->view) return;
    g_set_weak_pointer(&extrema->view, TINKER_GRAPH_VIEW(view));
    extrema->revision = G_MAXUINT64;
    look_later(extrema);
}

static void on_changed(Extrema *extrema)
{
    look_later(extrema);
}

static void on_edited(Extrema *extrema)
{
    extrema->revision = G_MAXUINT64;
    look_later(extrema);
}

void window_remove_extrema(TinkerWindow *window)
{
    g_object_set_data(G_OBJECT(window), EXTREMA, NULL);
}

void window_add_extrema(TinkerWindow *window)
{
    Extrema *extrema = g_new0(Extrema, 1);
    extrema->window = window;
    g_object_set_data_full(G_OBJECT(window), EXTREMA, extrema, free_extrema);
    g_signal_connect(window, "notify::focus-widget", G_CALLBACK(on_focus), extrema);
    g_signal_connect_data(window->player, "state-changed", G_CALLBACK(on_changed), extrema, NULL, G_CONNECT_SWAPPED);
    g_signal_connect_data(window->player, "rewound", G_CALLBACK(on_changed), extrema, NULL, G_CONNECT_SWAPPED);
    g_signal_connect_data(window->document, "changed", G_CALLBACK(on_edited), extrema, NULL, G_CONNECT_SWAPPED);
}

/* A press that goes nowhere is a click, any other draws a box or takes the curves along. Graphs over time share what
 * they show of it; other axes are each graph's own. */
#include <adwaita.h>
#include <glib/gi18n.h>
#include <math.h>

#include "gui/graph/graph-plot-private.h"

#define WHEEL_STEP 1.2

static gboolean is_over_time(const TinkerGraphPlot *plot)
{
    return tinker_graph_data_is_over_time(plot->data);
}

/* Whether places across, of time or frequency, can be measured at. */
static gboolean is_measured(const TinkerGraphPlot *plot)
{
    return is_over_time(plot) || tinker_graph_data_is_spectrum(plot->data);
}

/* What was zoomed is seen, here and in the other graphs. */
static void zoomed(TinkerGraphPlot *plot, TinkerGraphAxes axes)
{
    if (is_over_time(plot) && (axes & TINKER_GRAPH_X))
        tinker_time_span_set(tinker_player_span(plot->player), plot->zoom.is_set[0] ? plot->zoom.range[0] : NULL);
    tinker_graph_plot_renew(plot);
    g_signal_emit_by_name(plot, "looks-changed");
}

char *tinker_graph_plot_zoom_text(TinkerGraphPlot *plot)
{
    if (!plot->zoom.is_set[0]) return NULL;
    return g_strdup_printf(is_over_time(plot) ? _("shows %.5g to %.5g s") : _("shows %.5g to %.5g"),
                           plot->zoom.range[0][0], plot->zoom.range[0][1]);
}

/* Commands --------------------------------------------------------------------------------------------------------- */

void tinker_graph_plot_zoom(TinkerGraphPlot *plot, TinkerGraphAxes axes, double factor)
{
    const TinkerPlotGeometry *geometry = tinker_graph_plot_geometry(plot);
    if (!(geometry->right > geometry->left)) return;
    tinker_graph_zoom_by(&plot->zoom, geometry, axes, (geometry->left + geometry->right) / 2,
                         (geometry->top + geometry->bottom) / 2, factor);
    zoomed(plot, axes);
}

void tinker_graph_plot_pan(TinkerGraphPlot *plot, double right, double up)
{
    const TinkerPlotGeometry *geometry = tinker_graph_plot_geometry(plot);
    if (!(geometry->right > geometry->left)) return;
    const TinkerGraphAxes axes = right != 0 ? TINKER_GRAPH_X : TINKER_GRAPH_UP;
    tinker_graph_zoom_pan(&plot->zoom, geometry, axes, -right * (geometry->right - geometry->left),
                          up * (geometry->bottom - geometry->top));
    zoomed(plot, axes);
}

void tinker_graph_plot_show_all(TinkerGraphPlot *plot)
{
    tinker_graph_zoom_reset(&plot->zoom);
    zoomed(plot, TINKER_GRAPH_ALL);
}

static void go_to(TinkerGraphPlot *plot, double time)
{
    gtk_widget_activate_action(GTK_WIDGET(plot), "win.go-to", "d", fmax(time, 0));
}

void tinker_graph_plot_go_to_next(TinkerGraphPlot *plot, gboolean forward)
{
    TinkerGraphReading reading = {0};
    if (is_over_time(plot) && tinker_graph_data_curves(plot->data) > 0 &&
        tinker_graph_reading_next(tinker_graph_data_curve(plot->data, 0), tinker_player_time(plot->player), forward,
                                  &reading))
        go_to(plot, reading.at[0]);
    else
        gtk_widget_error_bell(GTK_WIDGET(plot));
}

/* Cursors ---------------------------------------------------------------------------------------------------------- */

/* A third one takes the place of the nearer of two. */
static void put_cursor(TinkerGraphPlot *plot, const TinkerGraphReading *reading)
{
    int number = plot->cursor_count;
    if (number == 2)
        number = fabs(plot->cursors[0].at[0] - reading->at[0]) <= fabs(plot->cursors[1].at[0] - reading->at[0]) ? 0 : 1;
    plot->cursors[number] = *reading;
    plot->cursor_count = MAX(plot->cursor_count, number + 1);
    tinker_graph_plot_renew(plot);
    g_signal_emit_by_name(plot, "looks-changed");
}

void tinker_graph_plot_put_cursor(TinkerGraphPlot *plot)
{
    TinkerGraphReading reading = {0};
    const double time = tinker_player_time(plot->player);
    const TinkerGraphSeries *series =
        is_over_time(plot) && tinker_graph_data_curves(plot->data) > 0 ? tinker_graph_data_curve(plot->data, 0) : NULL;
    if (series != NULL &&
        (tinker_graph_reading_extremum_at(series, time, &reading) || tinker_graph_reading_at(series, time, &reading)))
        put_cursor(plot, &reading);
    else
        gtk_widget_error_bell(GTK_WIDGET(plot));
}

void tinker_graph_plot_clear_cursors(TinkerGraphPlot *plot)
{
    plot->cursor_count = 0;
    tinker_graph_plot_renew(plot);
    g_signal_emit_by_name(plot, "looks-changed");
}

gboolean tinker_graph_plot_between_cursors(TinkerGraphPlot *plot, TinkerGraphPart *part)
{
    if (plot->cursor_count < 2 || !is_over_time(plot)) return FALSE;
    const double a = plot->cursors[0].at[0], b = plot->cursors[1].at[0];
    *part = (TinkerGraphPart){fmin(a, b), fmax(a, b), TRUE};
    return part->from < part->to;
}

static char *unit_of(const TinkerGraphPlot *plot, int cursor)
{
    return g_strdup(tinker_graph_series_y_axis(tinker_graph_data_curve(plot->data, plot->cursors[cursor].curve))->unit);
}

char *tinker_graph_plot_cursor_text(TinkerGraphPlot *plot)
{
    if (plot->cursor_count == 0) return NULL;
    const double *a = plot->cursors[0].at, *b = plot->cursors[1].at;
    g_autofree char *unit = unit_of(plot, 0);
    if (plot->cursor_count == 1) {
        g_autofree char *x = tinker_graph_data_place_text(plot->data, "", a[0]),
                        *y = tinker_graph_value_text("y", a[1], unit);
        return g_strdup_printf("A: %s, %s", x, y);
    }
    g_autofree char *other = unit_of(plot, 1), *dx = tinker_graph_data_place_text(plot->data, "Δ", b[0] - a[0]);
    g_autofree char *rate = is_over_time(plot) ? tinker_graph_value_text("1/Δt", 1 / fabs(b[0] - a[0]), "Hz") : NULL;
    const char *gap = rate != NULL ? ", " : "", *shown_rate = rate != NULL ? rate : "";
    if (!g_str_equal(unit, other)) return g_strdup_printf("%s%s%s", dx, gap, shown_rate);
    g_autofree char *dy = tinker_graph_value_text("Δy", b[1] - a[1], unit);
    return g_strdup_printf("%s, %s%s%s", dx, dy, gap, shown_rate);
}

/* The mouse -------------------------------------------------------------------------------------------------------- */

static GdkModifierType modifiers_of(gpointer controller)
{
    return gtk_event_controller_get_current_event_state(controller);
}

/* What the pointer reads of a curve at a place, as it is drawn beside it. */
static gboolean read_pointer(TinkerGraphPlot *plot, double x, double y, TinkerGraphReading *reading)
{
    TinkerPlot picture = {.memory = plot->memory};
    tinker_graph_plot_fill(plot, &picture);
    return tinker_graph_plot_read(plot, &picture, x, y, reading);
}

static void clicked(TinkerGraphPlot *plot, double x, double y, GdkModifierType modifiers)
{
    const TinkerPlotGeometry *at = &plot->geometry;
    TinkerGraphReading reading = {0};
    if (x < at->left || x > at->right || y < at->top || y > at->bottom) return;
    if (modifiers & GDK_CONTROL_MASK) {
        /* what is read there, if anything is: a cursor beside the point that is told would surprise */
        if (is_measured(plot) && ((plot->show_values && read_pointer(plot, x, y, &reading)) ||
                                  tinker_graph_plot_read_place(plot, x, y, &reading)))
            put_cursor(plot, &reading);
    } else if (is_over_time(plot)) {
        if (!tinker_graph_data_is_empty(plot->data)) go_to(plot, tinker_plot_scale_value(&at->x, x));
    } else if (!is_measured(plot) && read_pointer(plot, x, y, &reading)) {
        go_to(plot, tinker_graph_series_times(tinker_graph_data_curve(plot->data, reading.curve))[reading.point]);
    }
}

static void on_drag_begin(GtkGestureDrag *gesture, double x, double y, TinkerGraphPlot *plot)
{
    const guint button = gtk_gesture_single_get_current_button(GTK_GESTURE_SINGLE(gesture));
    const gboolean pans = button == GDK_BUTTON_MIDDLE || (modifiers_of(gesture) & GDK_SHIFT_MASK);
    if (button == GDK_BUTTON_SECONDARY) {
        gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_DENIED);
        return;
    }
    plot->drag = pans ? TINKER_GRAPH_PAN : TINKER_GRAPH_BOX;
    plot->drag_start[0] = plot->drag_now[0] = x;
    plot->drag_start[1] = plot->drag_now[1] = y;
}

static void on_drag_update(GtkGestureDrag *gesture, double dx, double dy, TinkerGraphPlot *plot)
{
    const double x = plot->drag_start[0] + dx, y = plot->drag_start[1] + dy;
    const TinkerGraphAxes axes = tinker_graph_axes_at(&plot->geometry, plot->drag_start[0], plot->drag_start[1]);
    if (plot->drag == TINKER_GRAPH_PAN) {
        tinker_graph_zoom_pan(&plot->zoom, tinker_graph_plot_geometry(plot), axes, x - plot->drag_now[0],
                              y - plot->drag_now[1]);
        zoomed(plot, axes);
    }
    plot->drag_now[0] = x;
    plot->drag_now[1] = y;
    tinker_graph_plot_renew(plot);
}

static void on_drag_end(GtkGestureDrag *gesture, double dx, double dy, TinkerGraphPlot *plot)
{
    const TinkerGraphAxes axes = tinker_graph_box_axes(plot);
    const TinkerGraphDrag drag = plot->drag;
    plot->drag = TINKER_GRAPH_NO_DRAG;
    if (drag == TINKER_GRAPH_BOX && axes != 0) {
        tinker_graph_zoom_box(&plot->zoom, tinker_graph_plot_geometry(plot), axes, plot->drag_start, plot->drag_now);
        zoomed(plot, axes);
    } else if (drag != TINKER_GRAPH_NO_DRAG && axes == 0) {
        clicked(plot, plot->drag_start[0], plot->drag_start[1], modifiers_of(gesture));
    }
    tinker_graph_plot_renew(plot);
}

static void on_drag_cancel(GtkGesture *gesture, GdkEventSequence *sequence, TinkerGraphPlot *plot)
{
    plot->drag = TINKER_GRAPH_NO_DRAG;
    tinker_graph_plot_renew(plot);
}

static void on_pressed(GtkGestureClick *gesture, int presses, double x, double y, TinkerGraphPlot *plot)
{
    if (presses == 2) tinker_graph_plot_show_all(plot);
}

/* Whether the graph lies on a page that the wheel would scroll: not all of a window that is smaller than its parts. */
static gboolean is_scrolled(TinkerGraphPlot *plot)
{
    GtkWidget *scroller = gtk_widget_get_ancestor(GTK_WIDGET(plot), GTK_TYPE_SCROLLED_WINDOW);
    if (scroller == NULL || gtk_widget_get_ancestor(scroller, ADW_TYPE_VIEW_STACK) == NULL) return FALSE;
    GtkAdjustment *down = gtk_scrolled_window_get_vadjustment(GTK_SCROLLED_WINDOW(scroller));
    return gtk_adjustment_get_upper(down) > gtk_adjustment_get_page_size(down);
}

/* Both axes, with Control the one across alone, with Shift the one upwards; and beside the curves that beside which it
 * is. On a page that scrolls the plain wheel is the page's, and Control stands for it. */
static gboolean on_scroll(GtkEventControllerScroll *scroll, double dx, double dy, TinkerGraphPlot *plot)
{
    const GdkModifierType modifiers = modifiers_of(scroll);
    const double by = dy != 0 ? dy : dx;
    TinkerGraphAxes axes = tinker_graph_axes_at(&plot->geometry, plot->pointer[0], plot->pointer[1]);
    const gboolean page_scrolls = is_scrolled(plot);
    if (page_scrolls && !(modifiers & (GDK_CONTROL_MASK | GDK_SHIFT_MASK))) return GDK_EVENT_PROPAGATE;
    if (!page_scrolls && (modifiers & GDK_CONTROL_MASK)) axes = TINKER_GRAPH_X;
    if (modifiers & GDK_SHIFT_MASK) axes = TINKER_GRAPH_UP;
    tinker_graph_zoom_by(&plot->zoom, tinker_graph_plot_geometry(plot), axes, plot->pointer[0], plot->pointer[1],
                         pow(WHEEL_STEP, -by));
    zoomed(plot, axes);
    return GDK_EVENT_STOP;
}

static void on_motion(GtkEventControllerMotion *controller, double x, double y, TinkerGraphPlot *plot)
{
    plot->pointer_inside = TRUE;
    plot->pointer[0] = x;
    plot->pointer[1] = y;
    if (plot->show_values) tinker_graph_plot_renew(plot);
    if (plot->drag == TINKER_GRAPH_NO_DRAG) tinker_graph_plot_point_at(plot, x, y);
}

static void on_leave(GtkEventControllerMotion *controller, TinkerGraphPlot *plot)
{
    plot->pointer_inside = FALSE;
    tinker_graph_plot_point_away(plot);
    if (plot->show_values) tinker_graph_plot_renew(plot);
}

static void on_span_changed(TinkerGraphPlot *plot)
{
    if (!is_over_time(plot)) return;
    plot->zoom.is_set[0] = tinker_time_span_get(tinker_player_span(plot->player), plot->zoom.range[0]);
    tinker_graph_plot_renew(plot);
    g_signal_emit_by_name(plot, "looks-changed");
}

/* A cursor may be on a curve of a run that is gone. */
static void on_kept_changed(TinkerGraphPlot *plot)
{
    for (int i = 0; i < plot->cursor_count; i++)
        if (plot->cursors[i].curve >= tinker_graph_data_own_curves(plot->data)) plot->cursor_count = 0;
    tinker_graph_plot_renew(plot);
}

static gboolean on_tooltip(TinkerGraphPlot *plot, int x, int y, gboolean by_key, GtkTooltip *tooltip)
{
    g_autofree char *names = by_key ? NULL : tinker_graph_plot_legend_text(plot, x, y);
    gtk_tooltip_set_text(tooltip, names);
    return names != NULL;
}

void tinker_graph_plot_add_input(TinkerGraphPlot *plot)
{
    GtkEventController *motion = gtk_event_controller_motion_new();
    GtkEventController *scroll = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_BOTH_AXES);
    GtkGesture *drag = gtk_gesture_drag_new(), *click = gtk_gesture_click_new();
    g_signal_connect(motion, "enter", G_CALLBACK(on_motion), plot);
    g_signal_connect(motion, "motion", G_CALLBACK(on_motion), plot);
    g_signal_connect(motion, "leave", G_CALLBACK(on_leave), plot);
    g_signal_connect(scroll, "scroll", G_CALLBACK(on_scroll), plot);
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(drag), 0);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_drag_begin), plot);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag_update), plot);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_drag_end), plot);
    g_signal_connect(drag, "cancel", G_CALLBACK(on_drag_cancel), plot);
    g_signal_connect(click, "pressed", G_CALLBACK(on_pressed), plot);
    GtkEventController *all[] = {motion, scroll, GTK_EVENT_CONTROLLER(drag), GTK_EVENT_CONTROLLER(click)};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++)
        gtk_widget_add_controller(GTK_WIDGET(plot), all[i]);
    gtk_widget_set_has_tooltip(GTK_WIDGET(plot), TRUE);
    g_signal_connect(plot, "query-tooltip", G_CALLBACK(on_tooltip), NULL);
    g_signal_connect_object(tinker_player_kept(plot->player), "changed", G_CALLBACK(on_kept_changed), plot,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(tinker_player_span(plot->player), "changed", G_CALLBACK(on_span_changed), plot,
                            G_CONNECT_SWAPPED);
}

/* The chart is drawn by the plots of the core; the point under the pointer is a reading of it. Keyboards have the
 * table. */
#include "gui/accuracy/trade-view.h"

#include <glib/gi18n.h>

#include "common/graph/trade-chart.h"
#include "gui/document/run-choice.h"
#include "gui/document/status-text.h"
#include "gui/widget/desktop-theme.h"

#define REACH 18 /* pixels about a point that count as on it */

struct _TinkerTradeView {
    GtkDrawingArea parent_instance;
    TinkerTradeChart *chart;   /* NULL: none */
    TinkerPaintMemory *memory; /* NULL: none */
    TinkerPlotPoint hovered;
    const TinkerTradeRow *row; /* under the pointer, or NULL */
};

G_DEFINE_FINAL_TYPE(TinkerTradeView, tinker_trade_view, GTK_TYPE_DRAWING_AREA)

static guint chosen_signal;

static TinkerPlot plot_of(const TinkerTradeView *view)
{
    TinkerPlot plot = tinker_trade_chart_plot(view->chart, tinker_desktop_theme());
    plot.memory = view->memory;
    return plot;
}

static void draw(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    TinkerTradeView *view = TINKER_TRADE_VIEW(area);
    if (view->chart == NULL) return;
    TinkerPlot plot = plot_of(view);
    g_autofree char *setting = NULL, *result = NULL;
    TinkerPlotReading reading;
    if (view->row != NULL) {
        g_autofree char *wall = tinker_duration_text(view->row->wall_s, 3);
        g_autofree char *error = tinker_status_size_text(view->row->error, 2);
        setting = tinker_run_choice_text(&view->row->setting);
        result = g_strdup_printf(_("error %s in %s"), error, wall);
        reading = (TinkerPlotReading){view->hovered.curve, view->hovered.point, setting, result};
        plot.reading = &reading;
    }
    tinker_plot_draw(cairo, &plot, width, height);
}

/* The pointer ------------------------------------------------------------------------------------------------------ */

static void hover(TinkerTradeView *view, double x, double y)
{
    const TinkerTradeRow *last = view->row;
    GtkWidget *widget = GTK_WIDGET(view);
    view->row = NULL;
    if (view->chart != NULL) {
        TinkerPlot plot = plot_of(view);
        if (tinker_plot_pick(&plot, gtk_widget_get_width(widget), gtk_widget_get_height(widget), x, y, REACH,
                             &view->hovered))
            view->row = tinker_trade_chart_row(view->chart, view->hovered.curve, view->hovered.point);
    }
    if (view->row == last) return;
    gtk_widget_set_cursor_from_name(widget, view->row != NULL ? "pointer" : NULL);
    gtk_widget_queue_draw(widget);
}

static void on_motion(GtkEventControllerMotion *motion, double x, double y, TinkerTradeView *view)
{
    hover(view, x, y);
}

static void on_leave(TinkerTradeView *view)
{
    hover(view, -2 * REACH, -2 * REACH);
}

static void on_click(GtkGestureClick *click, int presses, double x, double y, TinkerTradeView *view)
{
    hover(view, x, y);
    if (view->row != NULL) g_signal_emit(view, chosen_signal, 0, view->row);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void forget(TinkerTradeView *view)
{
    g_clear_pointer(&view->chart, tinker_trade_chart_free);
    g_clear_pointer(&view->memory, tinker_paint_memory_free);
    view->row = NULL;
}

void tinker_trade_view_set_trade(TinkerTradeView *view, const TinkerTrade *trade)
{
    forget(view);
    if (trade != NULL) {
        view->chart = tinker_trade_chart_new(trade);
        view->memory = tinker_paint_memory_new();
    }
    gtk_widget_queue_draw(GTK_WIDGET(view));
}

static void tinker_trade_view_finalize(GObject *object)
{
    forget(TINKER_TRADE_VIEW(object));
    G_OBJECT_CLASS(tinker_trade_view_parent_class)->finalize(object);
}

static void tinker_trade_view_class_init(TinkerTradeViewClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_trade_view_finalize;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "tradeview");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_IMG);
    chosen_signal = g_signal_new("chosen", TINKER_TYPE_TRADE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                                 1, G_TYPE_POINTER);
}

static void tinker_trade_view_init(TinkerTradeView *view)
{
    GtkEventController *motion = gtk_event_controller_motion_new();
    GtkGesture *click = gtk_gesture_click_new();
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(view), draw, NULL, NULL);
    g_signal_connect(motion, "motion", G_CALLBACK(on_motion), view);
    g_signal_connect_swapped(motion, "leave", G_CALLBACK(on_leave), view);
    g_signal_connect(click, "released", G_CALLBACK(on_click), view);
    gtk_widget_add_controller(GTK_WIDGET(view), motion);
    gtk_widget_add_controller(GTK_WIDGET(view), GTK_EVENT_CONTROLLER(click));
    tinker_desktop_theme_redraws(GTK_WIDGET(view));
    gtk_accessible_update_property(GTK_ACCESSIBLE(view), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Chart of the error over the computing time, by method"),
                                   GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, _("The table below has the same values."), -1);
}

/* The dock is a row of equal columns; where they get too narrow, what it lies in has to scroll. */
#include "gui/graph/graph-dock.h"

#define LEAST_WIDTH    180 /* of a graph; widget units */
#define LEAST_HEIGHT   150
#define NATURAL_HEIGHT 220
#define GAP            1

struct _TinkerGraphDock {
    TinkerGraphBoard parent_instance;
    gboolean settled;
};

G_DEFINE_FINAL_TYPE(TinkerGraphDock, tinker_graph_dock, TINKER_TYPE_GRAPH_BOARD)

static gboolean is_docked(const TinkerSceneGraph *graph)
{
    return !graph->has_place;
}

static void tinker_graph_dock_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *least,
                                      int *natural, int *least_baseline, int *natural_baseline)
{
    int count = tinker_graph_board_count(TINKER_GRAPH_BOARD(widget));
    *least_baseline = *natural_baseline = -1;
    if (orientation == GTK_ORIENTATION_HORIZONTAL) {
        *least = *natural = count * (LEAST_WIDTH + GAP);
    } else {
        *least = TINKER_GRAPH_DOCK(widget)->settled ? LEAST_HEIGHT : NATURAL_HEIGHT;
        *natural = NATURAL_HEIGHT;
    }
}

static void tinker_graph_dock_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerGraphBoard *board = TINKER_GRAPH_BOARD(widget);
    int count = tinker_graph_board_count(board);
    for (int i = 0; i < count; i++) {
        GtkWidget *view = GTK_WIDGET(tinker_graph_board_view(board, i));
        int left = width * i / count, right = width * (i + 1) / count - (i + 1 < count ? GAP : 0);
        /* GTK wants to have been asked for the size of whatever it is to allocate. */
        gtk_widget_measure(view, GTK_ORIENTATION_HORIZONTAL, -1, NULL, NULL, NULL, NULL);
        gtk_widget_size_allocate(view, &(GtkAllocation){left, 0, right - left, height}, -1);
    }
}

static void tinker_graph_dock_class_init(TinkerGraphDockClass *class)
{
    GTK_WIDGET_CLASS(class)->measure = tinker_graph_dock_measure;
    GTK_WIDGET_CLASS(class)->size_allocate = tinker_graph_dock_size_allocate;
    TINKER_GRAPH_BOARD_CLASS(class)->shows = is_docked;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "graph-dock");
}

static void tinker_graph_dock_init(TinkerGraphDock *dock) {}

void tinker_graph_dock_settle(TinkerGraphDock *dock)
{
    dock->settled = TRUE;
    gtk_widget_queue_resize(GTK_WIDGET(dock));
}

GtkWidget *tinker_graph_dock_new(void)
{
    return g_object_new(TINKER_TYPE_GRAPH_DOCK, NULL);
}

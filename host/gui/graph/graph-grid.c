/* As many columns as have room; the rows share the height that there is, and what the grid lies in scrolls where that
 * is too little. */
#include "gui/graph/graph-grid.h"

#define LEAST_WIDTH  420 /* of a column where there is more than one; widget units */
#define FIRST_WIDTH  260 /* of the only one */
#define LEAST_HEIGHT 260 /* of a row */
#define MOST_COLUMNS 3
#define GAP          12

struct _TinkerGraphGrid {
    TinkerGraphBoard parent_instance;
};

G_DEFINE_FINAL_TYPE(TinkerGraphGrid, tinker_graph_grid, TINKER_TYPE_GRAPH_BOARD)

static gboolean always(const TinkerSceneGraph *graph)
{
    return TRUE;
}

static int columns_in(int count, int width)
{
    return CLAMP((width + GAP) / (LEAST_WIDTH + GAP), 1, CLAMP(count, 1, MOST_COLUMNS));
}

static GtkSizeRequestMode tinker_graph_grid_get_request_mode(GtkWidget *widget)
{
    return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

static void tinker_graph_grid_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *least,
                                      int *natural, int *least_baseline, int *natural_baseline)
{
    int count = tinker_graph_board_count(TINKER_GRAPH_BOARD(widget));
    *least_baseline = *natural_baseline = -1;
    if (orientation == GTK_ORIENTATION_HORIZONTAL) {
        *least = FIRST_WIDTH;
        *natural = CLAMP(count, 1, MOST_COLUMNS) * (LEAST_WIDTH + GAP) - GAP;
        return;
    }
    int columns = columns_in(count, for_size < 0 ? FIRST_WIDTH : for_size);
    int rows = (count + columns - 1) / columns;
    *least = *natural = MAX(rows * (LEAST_HEIGHT + GAP) - GAP, 0);
}

static void tinker_graph_grid_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerGraphBoard *board = TINKER_GRAPH_BOARD(widget);
    int count = tinker_graph_board_count(board), columns = columns_in(count, width);
    int rows = (count + columns - 1) / columns;
    for (int i = 0; i < count; i++) {
        GtkWidget *view = GTK_WIDGET(tinker_graph_board_view(board, i));
        int column = i % columns, row = i / columns;
        int left = (width + GAP) * column / columns, right = (width + GAP) * (column + 1) / columns - GAP;
        int top = (height + GAP) * row / rows, bottom = (height + GAP) * (row + 1) / rows - GAP;
        gtk_widget_measure(view, GTK_ORIENTATION_HORIZONTAL, -1, NULL, NULL, NULL, NULL);
        gtk_widget_size_allocate(view, &(GtkAllocation){left, top, right - left, bottom - top}, -1);
    }
}

static void added(TinkerGraphBoard *board, TinkerGraphView *view)
{
    gtk_widget_add_css_class(GTK_WIDGET(view), "framed");
}

static void tinker_graph_grid_class_init(TinkerGraphGridClass *class)
{
    GTK_WIDGET_CLASS(class)->get_request_mode = tinker_graph_grid_get_request_mode;
    GTK_WIDGET_CLASS(class)->measure = tinker_graph_grid_measure;
    GTK_WIDGET_CLASS(class)->size_allocate = tinker_graph_grid_size_allocate;
    TINKER_GRAPH_BOARD_CLASS(class)->shows = always;
    TINKER_GRAPH_BOARD_CLASS(class)->added = added;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "graph-grid");
}

static void tinker_graph_grid_init(TinkerGraphGrid *grid) {}

GtkWidget *tinker_graph_grid_new(void)
{
    return g_object_new(TINKER_TYPE_GRAPH_GRID, NULL);
}

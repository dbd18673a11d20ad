/* After every change of the scene the views are brought in line with its graphs: those that still fit stay, or whose
 * graph has other curves now, and with them the focus, what is zoomed and what was switched on in them. The board is
 * hidden where it shows none. */
#include "gui/graph/graph-board.h"

#include "gui/widget/unparent.h"

typedef struct {
    TinkerDocument *document;
    TinkerPlayer *player;
    GPtrArray *views; /* of TinkerGraphView, which are children: borrowed */
} TinkerGraphBoardPrivate;

G_DEFINE_ABSTRACT_TYPE_WITH_PRIVATE(TinkerGraphBoard, tinker_graph_board, GTK_TYPE_WIDGET)

static TinkerGraphBoardPrivate *private_of(TinkerGraphBoard *board)
{
    return tinker_graph_board_get_instance_private(board);
}

TinkerDocument *tinker_graph_board_document(TinkerGraphBoard *board)
{
    return private_of(board)->document;
}

TinkerPlayer *tinker_graph_board_player(TinkerGraphBoard *board)
{
    return private_of(board)->player;
}

int tinker_graph_board_count(TinkerGraphBoard *board)
{
    return (int)private_of(board)->views->len;
}

TinkerGraphView *tinker_graph_board_view(TinkerGraphBoard *board, int place)
{
    return g_ptr_array_index(private_of(board)->views, place);
}

const TinkerSceneGraph *tinker_graph_board_graph(TinkerGraphBoard *board, TinkerGraphView *view)
{
    GPtrArray *graphs = tinker_scene_graphs(tinker_document_scene(private_of(board)->document));
    return g_ptr_array_index(graphs, tinker_graph_view_number(view));
}

/* Keeping up ------------------------------------------------------------------------------------------------------- */

/* Takes the first view that fits out of `old`; NULL. */
static TinkerGraphView *take_fitting(GPtrArray *old, const TinkerSceneGraph *graph)
{
    for (guint i = 0; i < old->len; i++)
        if (tinker_graph_view_fits(g_ptr_array_index(old, i), graph)) return g_ptr_array_steal_index(old, i);
    return NULL;
}

static TinkerGraphView *new_view(TinkerGraphBoard *board)
{
    TinkerGraphBoardPrivate *private = private_of(board);
    TinkerGraphBoardClass *class = TINKER_GRAPH_BOARD_GET_CLASS(board);
    TinkerGraphView *view = tinker_graph_view_new(private->document, private->player, class->floats);
    gtk_widget_set_parent(GTK_WIDGET(view), GTK_WIDGET(board));
    if (class->added != NULL) class->added(board, view);
    return view;
}

static void put_in_order(TinkerGraphBoard *board)
{
    GPtrArray *views = private_of(board)->views;
    for (guint i = 0; i < views->len; i++) {
        GtkWidget *before = i > 0 ? g_ptr_array_index(views, i - 1) : NULL, *view = g_ptr_array_index(views, i);
        if (gtk_widget_get_prev_sibling(view) != before) gtk_widget_insert_after(view, GTK_WIDGET(board), before);
    }
}

/* The numbers of the graphs that the board shows, of int. (transfer full) */
static GArray *shown_graphs(TinkerGraphBoard *board, const GPtrArray *graphs)
{
    GArray *numbers = g_array_new(FALSE, FALSE, sizeof(int));
    for (int i = 0; i < (int)graphs->len; i++)
        if (TINKER_GRAPH_BOARD_GET_CLASS(board)->shows(g_ptr_array_index(graphs, i))) g_array_append_val(numbers, i);
    return numbers;
}

/* A view for each of these graphs. Where as many views are left over as graphs have none, those graphs are what the
 * views' own have become: other curves in the same place. */
static void find_views(TinkerGraphBoard *board, const GPtrArray *graphs, const GArray *numbers, GPtrArray *old)
{
    GPtrArray *views = private_of(board)->views;
    guint missing = 0;
    for (guint k = 0; k < numbers->len; k++) {
        g_ptr_array_add(views, take_fitting(old, g_ptr_array_index(graphs, g_array_index(numbers, int, k))));
        missing += g_ptr_array_index(views, k) == NULL;
    }
    const gboolean changed = missing == old->len;
    for (guint k = 0; k < numbers->len; k++) {
        if (g_ptr_array_index(views, k) == NULL)
            g_ptr_array_index(views, k) = changed ? g_ptr_array_steal_index(old, 0) : (gpointer)new_view(board);
        tinker_graph_view_set_number(g_ptr_array_index(views, k), g_array_index(numbers, int, k));
    }
}

static void on_changed(TinkerGraphBoard *board)
{
    TinkerGraphBoardPrivate *private = private_of(board);
    GPtrArray *graphs = tinker_scene_graphs(tinker_document_scene(private->document));
    g_autoptr(GPtrArray) old = g_steal_pointer(&private->views);
    g_autoptr(GArray) numbers = shown_graphs(board, graphs);
    private->views = g_ptr_array_new();
    find_views(board, graphs, numbers, old);
    for (guint i = 0; i < old->len; i++)
        gtk_widget_unparent(g_ptr_array_index(old, i));
    put_in_order(board);
    gtk_widget_set_visible(GTK_WIDGET(board), private->views->len > 0);
    gtk_widget_queue_resize(GTK_WIDGET(board));
}

void tinker_graph_board_set_player(TinkerGraphBoard *board, TinkerDocument *document, TinkerPlayer *player)
{
    TinkerGraphBoardPrivate *private = private_of(board);
    private->document = g_object_ref(document);
    private->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), board, G_CONNECT_SWAPPED);
    on_changed(board);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_graph_board_dispose(GObject *object)
{
    TinkerGraphBoardPrivate *private = private_of(TINKER_GRAPH_BOARD(object));
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_pointer(&private->views, g_ptr_array_unref);
    g_clear_object(&private->player);
    g_clear_object(&private->document);
    G_OBJECT_CLASS(tinker_graph_board_parent_class)->dispose(object);
}

static void tinker_graph_board_class_init(TinkerGraphBoardClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_graph_board_dispose;
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_graph_board_init(TinkerGraphBoard *board)
{
    private_of(board)->views = g_ptr_array_new();
    gtk_widget_set_visible(GTK_WIDGET(board), FALSE);
}

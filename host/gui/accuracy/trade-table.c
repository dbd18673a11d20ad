/* A row of the list is an object that borrows its measurement; what a column shows and sorts by is in the table of
 * columns. */
#include "gui/accuracy/trade-table.h"

#include <glib/gi18n.h>
#include <math.h>

#include "common/words/trade-words.h"
#include "gui/document/status-text.h"
#include "gui/widget/unparent.h"
#include "units/quantity/units.h"

/* Rows ------------------------------------------------------------------------------------------------------------- */

#define TINKER_TYPE_TRADE_ITEM (tinker_trade_item_get_type())
G_DECLARE_FINAL_TYPE(TinkerTradeItem, tinker_trade_item, TINKER, TRADE_ITEM, GObject)

struct _TinkerTradeItem {
    GObject parent_instance;
    const TinkerTradeRow *row;
    guint method; /* number */
};

G_DEFINE_FINAL_TYPE(TinkerTradeItem, tinker_trade_item, G_TYPE_OBJECT)

static void tinker_trade_item_class_init(TinkerTradeItemClass *class) {}

static void tinker_trade_item_init(TinkerTradeItem *item) {}

/* Columns ---------------------------------------------------------------------------------------------------------- */

static char *method_text(const TinkerTradeRow *row)
{
    return g_strdup(row->setting.method);
}

static char *value_text(const TinkerTradeRow *row)
{
    return tinker_trade_value_text(&row->setting);
}

static char *wall_text(const TinkerTradeRow *row)
{
    return isnan(row->wall_s) ? g_strdup("") : tinker_duration_text(row->wall_s, 3);
}

static char *share_text(double share)
{
    return isnan(share) ? g_strdup("") : tinker_status_size_text(share, 2);
}

static char *error_text(const TinkerTradeRow *row)
{
    return share_text(row->error);
}

static char *energy_text(const TinkerTradeRow *row)
{
    return share_text(row->energy_error);
}

static char *note_text(const TinkerTradeRow *row)
{
    return tinker_trade_note_text(row, TRUE);
}

static double value_rank(const TinkerTradeItem *item)
{
    return item->row->setting.value;
}

static double method_rank(const TinkerTradeItem *item)
{
    return item->method;
}

static double wall_rank(const TinkerTradeItem *item)
{
    return item->row->wall_s;
}

static double error_rank(const TinkerTradeItem *item)
{
    return item->row->error;
}

static double energy_rank(const TinkerTradeItem *item)
{
    return item->row->energy_error;
}

static double note_rank(const TinkerTradeItem *item)
{
    return item->row->advised ? 0 : item->row->at_limit ? 1 : item->row->note != NULL ? 3 : 2;
}

typedef struct {
    const char *title;
    char *(*text)(const TinkerTradeRow *row);    /* (transfer full) */
    double (*rank)(const TinkerTradeItem *item); /* NAN comes last */
    gboolean number, wide;
} Column;

static const Column columns[] = {
    {N_("Method"), method_text, method_rank, FALSE, FALSE},
    {N_("Step or Tolerance"), value_text, value_rank, TRUE, FALSE},
    {N_("Computing Time"), wall_text, wall_rank, TRUE, FALSE},
    {N_("Error"), error_text, error_rank, TRUE, FALSE},
    {N_("Energy Error"), energy_text, energy_rank, TRUE, FALSE},
    {N_("Note"), note_text, note_rank, FALSE, TRUE},
};

static int compare_items(const void *left, const void *right, void *data)
{
    const Column *column = data;
    double l = column->rank((TinkerTradeItem *)left), r = column->rank((TinkerTradeItem *)right);
    if (isnan(l) || isnan(r)) return isnan(l) - isnan(r);
    return (l > r) - (l < r);
}

static void on_setup(GtkSignalListItemFactory *factory, GtkListItem *cell, const Column *column)
{
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    if (column->number) gtk_widget_add_css_class(label, "numeric");
    if (column->wide) gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    gtk_list_item_set_child(cell, label);
}

static void on_bind(GtkSignalListItemFactory *factory, GtkListItem *cell, const Column *column)
{
    const TinkerTradeRow *row = TINKER_TRADE_ITEM(gtk_list_item_get_item(cell))->row;
    GtkWidget *label = gtk_list_item_get_child(cell);
    g_autofree char *text = column->text(row);
    gtk_label_set_text(GTK_LABEL(label), text);
    if (column->wide) gtk_widget_set_tooltip_text(label, text[0] != '\0' ? text : NULL);
    if (row->advised)
        gtk_widget_add_css_class(label, "advised");
    else
        gtk_widget_remove_css_class(label, "advised");
}

/* The table -------------------------------------------------------------------------------------------------------- */

struct _TinkerTradeTable {
    GtkWidget parent_instance;
    GtkWidget *view;
    GListStore *items;
    GtkSingleSelection *selection; /* borrowed from the view */
    guint idle;                    /* id of a source, or 0 */
};

G_DEFINE_FINAL_TYPE(TinkerTradeTable, tinker_trade_table, GTK_TYPE_WIDGET)

static guint chosen_signal;

static void add_method(TinkerTradeTable *table, const TinkerTradeMethod *method, guint number)
{
    for (guint i = 0; i < method->rows->len; i++) {
        g_autoptr(TinkerTradeItem) item = g_object_new(TINKER_TYPE_TRADE_ITEM, NULL);
        item->row = &g_array_index(method->rows, TinkerTradeRow, i);
        item->method = number;
        g_list_store_append(table->items, item);
    }
}

/* The advised row is where one begins to read. A list that has just been filled cannot be scrolled before it is laid
 * out. */
static gboolean select_advised(void *data)
{
    TinkerTradeTable *table = data;
    table->idle = 0;
    GListModel *model = G_LIST_MODEL(table->selection);
    for (guint i = 0; i < g_list_model_get_n_items(model); i++) {
        g_autoptr(TinkerTradeItem) item = g_list_model_get_item(model, i);
        if (!item->row->advised) continue;
        gtk_single_selection_set_selected(table->selection, i);
        GtkWidget *list = gtk_widget_get_last_child(table->view);
        gtk_widget_activate_action(list, "list.scroll-to-item", "u", i);
        break;
    }
    return G_SOURCE_REMOVE;
}

void tinker_trade_table_set_trade(TinkerTradeTable *table, const TinkerTrade *trade)
{
    g_list_store_remove_all(table->items);
    for (guint m = 0; trade != NULL && m < trade->methods->len; m++)
        add_method(table, g_ptr_array_index(trade->methods, m), m);
    if (table->idle == 0) table->idle = g_idle_add_full(G_PRIORITY_LOW, select_advised, table, NULL);
}

static void on_activate(GtkColumnView *view, guint place, TinkerTradeTable *table)
{
    g_autoptr(TinkerTradeItem) item = g_list_model_get_item(G_LIST_MODEL(table->selection), place);
    if (item != NULL) g_signal_emit(table, chosen_signal, 0, item->row);
}

static void add_column(TinkerTradeTable *table, const Column *column)
{
    GtkListItemFactory *factory = gtk_signal_list_item_factory_new();
    g_signal_connect(factory, "setup", G_CALLBACK(on_setup), (gpointer)column);
    g_signal_connect(factory, "bind", G_CALLBACK(on_bind), (gpointer)column);
    g_autoptr(GtkColumnViewColumn) added = gtk_column_view_column_new(_(column->title), factory);
    g_autoptr(GtkSorter) sorter = GTK_SORTER(gtk_custom_sorter_new(compare_items, (gpointer)column, NULL));
    gtk_column_view_column_set_sorter(added, sorter);
    gtk_column_view_column_set_expand(added, column->wide);
    gtk_column_view_column_set_resizable(added, TRUE);
    gtk_column_view_append_column(GTK_COLUMN_VIEW(table->view), added);
}

static void tinker_trade_table_dispose(GObject *object)
{
    TinkerTradeTable *table = TINKER_TRADE_TABLE(object);
    if (table->idle != 0) g_source_remove(table->idle);
    table->idle = 0;
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&table->items);
    G_OBJECT_CLASS(tinker_trade_table_parent_class)->dispose(object);
}

static void tinker_trade_table_class_init(TinkerTradeTableClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_trade_table_dispose;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "tradetable");
    chosen_signal = g_signal_new("chosen", TINKER_TYPE_TRADE_TABLE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                                 1, G_TYPE_POINTER);
}

static void tinker_trade_table_init(TinkerTradeTable *table)
{
    table->items = g_list_store_new(TINKER_TYPE_TRADE_ITEM);
    table->view = gtk_column_view_new(NULL);
    GtkSorter *sorter = g_object_ref(gtk_column_view_get_sorter(GTK_COLUMN_VIEW(table->view)));
    GtkSortListModel *sorted = gtk_sort_list_model_new(g_object_ref(G_LIST_MODEL(table->items)), sorter);
    table->selection = gtk_single_selection_new(G_LIST_MODEL(sorted));
    gtk_column_view_set_model(GTK_COLUMN_VIEW(table->view), GTK_SELECTION_MODEL(table->selection));
    g_object_unref(table->selection);
    for (gsize i = 0; i < G_N_ELEMENTS(columns); i++)
        add_column(table, &columns[i]);
    g_signal_connect(table->view, "activate", G_CALLBACK(on_activate), table);
    gtk_widget_add_css_class(table->view, "data-table");
    gtk_accessible_update_property(GTK_ACCESSIBLE(table->view), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Measurements"), -1);
    GtkWidget *scrolled = gtk_scrolled_window_new();
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), table->view);
    gtk_widget_set_parent(scrolled, GTK_WIDGET(table));
}

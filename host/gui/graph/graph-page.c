/* The row's lists follow the scene. Its button selects the block and leaves the rest to win.add-graph. */
#include "gui/graph/graph-page.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#include "gui/graph/energy-chart.h"
#include "gui/graph/graph-grid.h"
#include "gui/graph/graph-menu.h"
#include "gui/text/translate.h"
#include "gui/widget/choices.h"
#include "gui/widget/unparent.h"

struct _TinkerGraphPage {
    GtkWidget parent_instance;
    TinkerDocument *document;
    GArray *blocks;        /* of TinkerBlockId: those in the list */
    TinkerBlockId offered; /* of them, unless the user chose another one */
    GtkWidget *row, *block, *quantity, *against, *energy, *chart, *stack;
    gboolean updating;
};

G_DEFINE_FINAL_TYPE(TinkerGraphPage, tinker_graph_page, GTK_TYPE_WIDGET)

/* Lists ------------------------------------------------------------------------------------------------------------ */

static TinkerBlockId chosen_block(TinkerGraphPage *page)
{
    guint chosen = gtk_drop_down_get_selected(GTK_DROP_DOWN(page->block));
    return chosen < page->blocks->len ? g_array_index(page->blocks, TinkerBlockId, chosen) : TINKER_NO_BLOCK;
}

static const TinkerBlockClass *chosen_class(TinkerGraphPage *page)
{
    TinkerBlockId block = chosen_block(page);
    TinkerScene *scene = tinker_document_scene(page->document);
    return block != TINKER_NO_BLOCK && tinker_scene_has_block(scene, block) ? tinker_scene_block_class(scene, block)
                                                                            : NULL;
}

static gboolean same_texts(GListModel *list, const GPtrArray *texts)
{
    gboolean same = list != NULL && g_list_model_get_n_items(list) == texts->len;
    for (guint i = 0; same && i < texts->len; i++)
        same = g_strcmp0(gtk_string_list_get_string(GTK_STRING_LIST(list), i), g_ptr_array_index(texts, i)) == 0;
    return same;
}

/* Shows these texts, of const char *; what was chosen stays, and FALSE is the answer, where they are the same as
 * before. */
static gboolean set_texts(GtkWidget *list, GPtrArray *texts)
{
    if (same_texts(gtk_drop_down_get_model(GTK_DROP_DOWN(list)), texts)) return FALSE;
    g_autoptr(GtkStringList) model = gtk_string_list_new(NULL);
    for (guint i = 0; i < texts->len; i++)
        gtk_string_list_append(model, g_ptr_array_index(texts, i));
    gtk_drop_down_set_model(GTK_DROP_DOWN(list), G_LIST_MODEL(model));
    return TRUE;
}

/* The first quantity that stands in a record, or -1. */
static int first_recorded(const TinkerBlockClass *block_class)
{
    for (int32_t i = 0; block_class != NULL && i < block_class->quantity_count; i++)
        if (block_class->quantities[i].flags & TINKER_RECORDED) return i;
    return -1;
}

static void list_quantities(TinkerGraphPage *page)
{
    const TinkerBlockClass *block_class = chosen_class(page);
    g_autoptr(GPtrArray) titles = g_ptr_array_new();
    for (int32_t i = 0; block_class != NULL && i < block_class->quantity_count; i++)
        g_ptr_array_add(titles, (gpointer)tinker_translate(block_class->quantities[i].title));
    if (set_texts(page->quantity, titles))
        gtk_drop_down_set_selected(GTK_DROP_DOWN(page->quantity), (guint)MAX(first_recorded(block_class), 0));
    g_ptr_array_insert(titles, 0, _("Time"));
    set_texts(page->against, titles);
}

static void choose_block(TinkerGraphPage *page, TinkerBlockId block)
{
    for (guint i = 0; i < page->blocks->len; i++)
        if (g_array_index(page->blocks, TinkerBlockId, i) == block)
            gtk_drop_down_set_selected(GTK_DROP_DOWN(page->block), i);
}

static void on_block_chosen(TinkerGraphPage *page)
{
    if (!page->updating && page->document != NULL) list_quantities(page);
}

static void on_selection_changed(TinkerGraphPage *page)
{
    choose_block(page, tinker_document_selected(page->document));
}

/* What is shown has the page: the chart of the energy all of it where it stands alone. */
static void show_places(TinkerGraphPage *page)
{
    const gboolean graphs = tinker_scene_graphs(tinker_document_scene(page->document))->len > 0;
    const gboolean energy = gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(page->energy));
    gtk_stack_set_visible_child_name(GTK_STACK(page->stack), graphs ? "graphs" : "none");
    gtk_widget_set_visible(page->stack, graphs || !energy);
    gtk_widget_set_visible(page->chart, energy);
    gtk_widget_set_vexpand(page->chart, !graphs);
}

static void on_changed(TinkerGraphPage *page)
{
    TinkerScene *scene = tinker_document_scene(page->document);
    TinkerBlockId chosen = chosen_block(page), likely = TINKER_NO_BLOCK;
    g_autoptr(GPtrArray) names = g_ptr_array_new();
    page->updating = TRUE;
    g_array_set_size(page->blocks, 0);
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (!tinker_block_class_has_graphs(block_class)) continue;
        if (likely == TINKER_NO_BLOCK && first_recorded(block_class) >= 0) likely = block;
        g_array_append_val(page->blocks, block);
        g_ptr_array_add(names, (gpointer)tinker_scene_block_name(scene, block));
    }
    if (set_texts(page->block, names)) {
        const gboolean is_own = chosen != page->offered;
        choose_block(page, likely);
        page->offered = chosen_block(page);
        if (is_own) choose_block(page, chosen);
    }
    page->updating = FALSE;
    list_quantities(page);
    gtk_widget_set_sensitive(page->row, page->blocks->len > 0);
    show_places(page);
}

static void on_add(TinkerGraphPage *page)
{
    const TinkerBlockClass *block_class = chosen_class(page);
    guint quantity = gtk_drop_down_get_selected(GTK_DROP_DOWN(page->quantity));
    guint against = gtk_drop_down_get_selected(GTK_DROP_DOWN(page->against));
    if (block_class == NULL || quantity >= (guint)block_class->quantity_count) return;
    gboolean over_time = against == 0 || against > (guint)block_class->quantity_count;
    g_autofree char *target = g_strjoin(over_time ? NULL : "/", block_class->quantities[quantity].id,
                                        over_time ? NULL : block_class->quantities[against - 1].id, NULL);
    tinker_document_select(page->document, chosen_block(page));
    gtk_widget_activate_action(GTK_WIDGET(page), "win.add-graph", "s", target);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static GtkWidget *add_list(GtkWidget *row, const char *title)
{
    GtkWidget *label = gtk_label_new(title), *list = gtk_drop_down_new(NULL, NULL);
    tinker_choices_cut_off(GTK_DROP_DOWN(list));
    gtk_widget_add_css_class(label, "dim-label");
    gtk_accessible_update_property(GTK_ACCESSIBLE(list), GTK_ACCESSIBLE_PROPERTY_LABEL, title, -1);
    gtk_box_append(GTK_BOX(row), label);
    gtk_box_append(GTK_BOX(row), list);
    return list;
}

static void add_row(TinkerGraphPage *page)
{
    page->row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8);
    gtk_widget_add_css_class(page->row, "graph-row");
    page->block = add_list(page->row, _("Block"));
    page->quantity = add_list(page->row, _("Quantity"));
    page->against = add_list(page->row, _("Over"));
    GtkWidget *button = gtk_button_new_with_mnemonic(_("_Add Graph"));
    gtk_widget_add_css_class(button, "suggested-action");
    gtk_box_append(GTK_BOX(page->row), button);
    page->energy = gtk_toggle_button_new_with_mnemonic(_("_Energy"));
    gtk_widget_set_tooltip_text(page->energy, _("Where the energy is and where it went"));
    gtk_box_append(GTK_BOX(page->row), page->energy);
    g_signal_connect_swapped(page->block, "notify::selected", G_CALLBACK(on_block_chosen), page);
    g_signal_connect_swapped(button, "clicked", G_CALLBACK(on_add), page);
    gtk_widget_set_parent(page->row, GTK_WIDGET(page));
}

static void add_stack(TinkerGraphPage *page, TinkerPlayer *player)
{
    page->stack = gtk_stack_new();
    gtk_widget_set_vexpand(page->stack, TRUE);
    GtkWidget *none = adw_status_page_new(), *scroller = gtk_scrolled_window_new(), *grid = tinker_graph_grid_new();
    adw_status_page_set_icon_name(ADW_STATUS_PAGE(none), "tinker-graph-symbolic");
    adw_status_page_set_title(ADW_STATUS_PAGE(none), _("No Graphs Yet"));
    adw_status_page_set_description(ADW_STATUS_PAGE(none),
                                    _("Choose a block and a quantity above, or right-click a block on the canvas and "
                                      "choose “Add Graph”."));
    tinker_graph_board_set_player(TINKER_GRAPH_BOARD(grid), page->document, player);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scroller), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scroller), grid);
    gtk_stack_add_named(GTK_STACK(page->stack), none, "none");
    gtk_stack_add_named(GTK_STACK(page->stack), scroller, "graphs");
    gtk_widget_set_parent(page->stack, GTK_WIDGET(page));
}

/* Between the row and the graphs. */
static void add_energy(TinkerGraphPage *page, TinkerPlayer *player)
{
    page->chart = tinker_energy_chart_new(page->document, player);
    gtk_widget_add_css_class(page->chart, "energy");
    gtk_widget_insert_after(page->chart, GTK_WIDGET(page), page->row);
    g_signal_connect_swapped(page->energy, "toggled", G_CALLBACK(show_places), page);
}

static void tinker_graph_page_dispose(GObject *object)
{
    TinkerGraphPage *page = TINKER_GRAPH_PAGE(object);
    page->updating = TRUE;
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&page->document);
    g_clear_pointer(&page->blocks, g_array_unref);
    G_OBJECT_CLASS(tinker_graph_page_parent_class)->dispose(object);
}

static void tinker_graph_page_class_init(TinkerGraphPageClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_graph_page_dispose;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "graph-page");
}

static void tinker_graph_page_init(TinkerGraphPage *page)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(page));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
    page->blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    page->offered = TINKER_NO_BLOCK;
}

GtkWidget *tinker_graph_page_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerGraphPage *page = g_object_new(TINKER_TYPE_GRAPH_PAGE, NULL);
    page->document = g_object_ref(document);
    add_row(page);
    add_stack(page, player);
    add_energy(page, player);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), page, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "selection-changed", G_CALLBACK(on_selection_changed), page, G_CONNECT_SWAPPED);
    on_changed(page);
    return GTK_WIDGET(page);
}

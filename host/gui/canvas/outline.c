/* A list view over items that each hold the id of a block. The items are made anew only where blocks came, went,
 * changed places or names; what a row says beyond the name is asked for when it is shown, so that thousands of blocks
 * cost little. */
#include <glib/gi18n.h>
#include <string.h>

#include "gui/canvas/outline-private.h"
#include "gui/widget/unparent.h"

#define SEARCH_FROM   8   /* blocks: fewer are seen at a glance */
#define REFRESH_DELAY 100 /* ms: a drag need not be followed faster */

G_DEFINE_FINAL_TYPE(TinkerOutline, tinker_outline, GTK_TYPE_WIDGET)

enum { ACTIVATED, MENU, SIGNALS };
static guint signals[SIGNALS];

static TinkerScene *scene_of(TinkerOutline *outline)
{
    return tinker_document_scene(outline->document);
}

/* Selection -------------------------------------------------------------------------------------------------------- */

/* By id; a set. (transfer full) */
static GHashTable *selected_blocks(TinkerOutline *outline)
{
    int count;
    const TinkerBlockId *blocks = tinker_document_selection(outline->document, &count);
    GHashTable *set = g_hash_table_new(NULL, NULL);
    for (int i = 0; i < count; i++)
        g_hash_table_add(set, GINT_TO_POINTER(blocks[i]));
    return set;
}

static gboolean same_selection(TinkerOutline *outline, const GArray *blocks)
{
    g_autoptr(GHashTable) selected = selected_blocks(outline);
    if (g_hash_table_size(selected) != blocks->len) return FALSE;
    for (guint i = 0; i < blocks->len; i++)
        if (!g_hash_table_contains(selected, GINT_TO_POINTER(g_array_index(blocks, TinkerBlockId, i)))) return FALSE;
    return TRUE;
}

/* What was selected here is selected in the document. */
static void on_selected(TinkerOutline *outline)
{
    if (outline->mirroring) return;
    g_autoptr(GtkBitset) selected = gtk_selection_model_get_selection(outline->selection);
    g_autoptr(GArray) blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    GtkBitsetIter iter;
    guint place;
    for (gboolean more = gtk_bitset_iter_init_first(&iter, selected, &place); more;
         more = gtk_bitset_iter_next(&iter, &place)) {
        g_autoptr(OutlineItem) item = g_list_model_get_item(G_LIST_MODEL(outline->selection), place);
        if (tinker_scene_has_block(scene_of(outline), item->block)) g_array_append_val(blocks, item->block);
    }
    if (same_selection(outline, blocks)) return;
    outline->mirroring = TRUE;
    tinker_document_select_all_of(outline->document, (const TinkerBlockId *)(gpointer)blocks->data, (int)blocks->len);
    outline->mirroring = FALSE;
    outline->reached =
        tinker_pointed_block(blocks->len == 1 ? g_array_index(blocks, TinkerBlockId, 0) : TINKER_NO_BLOCK);
    tinker_document_point(outline->document, outline->reached);
}

/* What keys had come to is pointed at no more. */
static void on_left(TinkerOutline *outline)
{
    if (outline->document != NULL) tinker_document_point_away(outline->document, outline->reached);
    outline->reached = tinker_pointed_block(TINKER_NO_BLOCK);
}

/* What is selected in the document is selected here, and can be seen. */
static void mirror(TinkerOutline *outline)
{
    if (outline->mirroring) return;
    g_autoptr(GHashTable) wanted = selected_blocks(outline);
    guint length = g_list_model_get_n_items(G_LIST_MODEL(outline->selection)), first = GTK_INVALID_LIST_POSITION;
    g_autoptr(GtkBitset) selected = gtk_bitset_new_empty(), all = gtk_bitset_new_range(0, length);
    for (guint i = 0; i < length; i++) {
        g_autoptr(OutlineItem) item = g_list_model_get_item(G_LIST_MODEL(outline->selection), i);
        if (!g_hash_table_contains(wanted, GINT_TO_POINTER(item->block))) continue;
        gtk_bitset_add(selected, i);
        if (first == GTK_INVALID_LIST_POSITION) first = i;
    }
    outline->mirroring = TRUE;
    gtk_selection_model_set_selection(outline->selection, selected, all);
    outline->mirroring = FALSE;
    if (first != GTK_INVALID_LIST_POSITION)
        gtk_widget_activate_action(outline->list, "list.scroll-to-item", "u", first);
}

static void on_activated(TinkerOutline *outline)
{
    g_signal_emit(outline, signals[ACTIVATED], 0);
}

/* Items follow the scene
 * ------------------------------------------------------------------------------------------------ */

static gboolean is_current(TinkerOutline *outline)
{
    TinkerScene *scene = scene_of(outline);
    guint count = (guint)tinker_scene_block_count(scene);
    if (g_list_model_get_n_items(G_LIST_MODEL(outline->items)) != count) return FALSE;
    for (guint i = 0; i < count; i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, (int32_t)i);
        g_autoptr(OutlineItem) item = g_list_model_get_item(G_LIST_MODEL(outline->items), i);
        if (item->block != block || !g_str_equal(item->name, tinker_scene_block_name(scene, block))) return FALSE;
    }
    return TRUE;
}

static void fill(TinkerOutline *outline)
{
    TinkerScene *scene = scene_of(outline);
    guint count = (guint)tinker_scene_block_count(scene);
    g_autoptr(GPtrArray) items = g_ptr_array_new_with_free_func(g_object_unref);
    for (guint i = 0; i < count; i++)
        g_ptr_array_add(items, outline_item_new(scene, tinker_scene_block_at(scene, (int32_t)i)));
    outline->mirroring = TRUE;
    g_list_store_splice(outline->items, 0, g_list_model_get_n_items(G_LIST_MODEL(outline->items)), items->pdata, count);
    outline->mirroring = FALSE;
    g_autofree char *text = g_strdup_printf("%u", count);
    gtk_label_set_text(GTK_LABEL(outline->count), text);
    gboolean searchable = count >= SEARCH_FROM || *outline->wanted != '\0';
    gtk_widget_set_visible(outline->search, searchable);
    gtk_search_entry_set_key_capture_widget(GTK_SEARCH_ENTRY(outline->search), searchable ? outline->list : NULL);
    mirror(outline);
}

static void refresh(TinkerOutline *outline)
{
    if (is_current(outline))
        outline_describe_rows(outline);
    else
        fill(outline);
}

static gboolean on_refresh(gpointer data)
{
    TinkerOutline *outline = data;
    outline->refresh = 0;
    refresh(outline);
    return G_SOURCE_REMOVE;
}

static void refresh_soon(TinkerOutline *outline)
{
    if (outline->refresh == 0) outline->refresh = g_timeout_add(REFRESH_DELAY, on_refresh, outline);
}

/* Searching -------------------------------------------------------------------------------------------------------- */

static gboolean is_wanted(gpointer item, gpointer data)
{
    const TinkerOutline *outline = data;
    return *outline->wanted == '\0' || strstr(OUTLINE_ITEM(item)->folded, outline->wanted) != NULL;
}

static void on_searched(TinkerOutline *outline)
{
    g_free(outline->wanted);
    outline->wanted = g_utf8_casefold(gtk_editable_get_text(GTK_EDITABLE(outline->search)), -1);
    outline->mirroring = TRUE;
    gtk_filter_changed(outline->filter, GTK_FILTER_CHANGE_DIFFERENT);
    outline->mirroring = FALSE;
    mirror(outline);
}

/* Return in the search entry selects the first block that is found by what stands there, of which the list may not know
 * yet: it is told of changes some time after they are made. */
static void on_search_activated(TinkerOutline *outline)
{
    if (*gtk_editable_get_text(GTK_EDITABLE(outline->search)) == '\0') return;
    on_searched(outline);
    if (g_list_model_get_n_items(G_LIST_MODEL(outline->selection)) == 0) return;
    gtk_selection_model_select_item(outline->selection, 0, TRUE);
    on_activated(outline);
}

static void on_search_stopped(TinkerOutline *outline)
{
    gtk_editable_set_text(GTK_EDITABLE(outline->search), "");
    gtk_widget_grab_focus(outline->list);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static GtkWidget *make_header(TinkerOutline *outline)
{
    GtkWidget *header = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *title = outline_add_label(header, "heading");
    gtk_widget_add_css_class(header, "panel-header");
    gtk_label_set_text(GTK_LABEL(title), _("Outline"));
    gtk_widget_set_hexpand(title, TRUE);
    outline->count = outline_add_label(header, "dim-label");
    return header;
}

static GtkWidget *make_search(TinkerOutline *outline)
{
    outline->search = gtk_search_entry_new();
    g_object_set(outline->search, "placeholder-text", _("Search Blocks"), NULL);
    gtk_accessible_update_property(GTK_ACCESSIBLE(outline->search), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Search Blocks"),
                                   -1);
    gtk_widget_add_css_class(outline->search, "panel-search");
    gtk_widget_set_visible(outline->search, FALSE);
    g_signal_connect_swapped(outline->search, "search-changed", G_CALLBACK(on_searched), outline);
    g_signal_connect_swapped(outline->search, "activate", G_CALLBACK(on_search_activated), outline);
    g_signal_connect_swapped(outline->search, "stop-search", G_CALLBACK(on_search_stopped), outline);
    return outline->search;
}

static GtkWidget *make_list(TinkerOutline *outline)
{
    outline->items = g_list_store_new(OUTLINE_TYPE_ITEM);
    outline->filter = GTK_FILTER(gtk_custom_filter_new(is_wanted, outline, NULL));
    GtkFilterListModel *found =
        gtk_filter_list_model_new(g_object_ref(G_LIST_MODEL(outline->items)), g_object_ref(outline->filter));
    outline->selection = GTK_SELECTION_MODEL(gtk_multi_selection_new(G_LIST_MODEL(found)));
    g_signal_connect_swapped(outline->selection, "selection-changed", G_CALLBACK(on_selected), outline);
    outline->list = gtk_list_view_new(g_object_ref(outline->selection), outline_row_factory(outline));
    gtk_accessible_update_property(GTK_ACCESSIBLE(outline->list), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Outline"), -1);
    g_signal_connect_swapped(outline->list, "activate", G_CALLBACK(on_activated), outline);
    gtk_widget_add_css_class(outline->list, "navigation-sidebar");
    GtkEventController *focus = gtk_event_controller_focus_new();
    g_signal_connect_swapped(focus, "leave", G_CALLBACK(on_left), outline);
    gtk_widget_add_controller(outline->list, focus);

    GtkWidget *scrolled = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), outline->list);
    gtk_widget_set_vexpand(scrolled, TRUE);
    return scrolled;
}

GtkWidget *tinker_outline_new(TinkerDocument *document)
{
    TinkerOutline *outline = g_object_new(TINKER_TYPE_OUTLINE, NULL);
    outline->document = g_object_ref(document);
    g_signal_connect_object(document, "changed", G_CALLBACK(refresh_soon), outline, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "selection-changed", G_CALLBACK(mirror), outline, G_CONNECT_SWAPPED);
    fill(outline);
    return GTK_WIDGET(outline);
}

static void tinker_outline_dispose(GObject *object)
{
    TinkerOutline *outline = TINKER_OUTLINE(object);
    if (outline->refresh != 0) g_source_remove(outline->refresh);
    outline->refresh = 0;
    outline->mirroring = TRUE;
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&outline->selection);
    g_clear_object(&outline->filter);
    g_clear_object(&outline->items);
    g_clear_object(&outline->document);
    g_clear_pointer(&outline->rows, g_hash_table_unref);
    g_clear_pointer(&outline->wanted, g_free);
    G_OBJECT_CLASS(tinker_outline_parent_class)->dispose(object);
}

static void tinker_outline_class_init(TinkerOutlineClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_outline_dispose;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "outline");
    /* as on the canvas, behind the search entry, which takes them for its text */
    gtk_widget_class_add_binding_action(GTK_WIDGET_CLASS(class), GDK_KEY_Delete, 0, "win.delete", NULL);
    gtk_widget_class_add_binding_action(GTK_WIDGET_CLASS(class), GDK_KEY_c, GDK_CONTROL_MASK, "win.copy", NULL);
    gtk_widget_class_add_binding_action(GTK_WIDGET_CLASS(class), GDK_KEY_x, GDK_CONTROL_MASK, "win.cut", NULL);
    gtk_widget_class_add_binding_action(GTK_WIDGET_CLASS(class), GDK_KEY_v, GDK_CONTROL_MASK, "win.paste", NULL);
    signals[ACTIVATED] =
        g_signal_new("activated", TINKER_TYPE_OUTLINE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    signals[MENU] = g_signal_new("menu", TINKER_TYPE_OUTLINE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2,
                                 G_TYPE_DOUBLE, G_TYPE_DOUBLE);
}

static void tinker_outline_init(TinkerOutline *outline)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(outline));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
    outline->rows = g_hash_table_new(NULL, NULL);
    outline->wanted = g_strdup("");
    outline->reached = tinker_pointed_block(TINKER_NO_BLOCK);
    gtk_widget_set_parent(make_header(outline), GTK_WIDGET(outline));
    gtk_widget_set_parent(make_search(outline), GTK_WIDGET(outline));
    gtk_widget_set_parent(make_list(outline), GTK_WIDGET(outline));
}

/* Rows of the outline: icon, name and type of a block, and its menu. */
#include "gui/canvas/outline-private.h"
#include "gui/document/icon-guard.h"
#include "gui/text/block-words.h"
#include "gui/widget/desktop-theme.h"

#define ICON_WIDTH  30
#define ICON_HEIGHT 20

static void draw_icon(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    TinkerOutline *outline = data;
    GtkListItem *row = g_object_get_data(G_OBJECT(area), "row");
    OutlineItem *item = gtk_list_item_get_item(row);
    if (item == NULL || outline->document == NULL ||
        !tinker_scene_has_block(tinker_document_scene(outline->document), item->block))
        return;
    const TinkerBlockClass *block_class =
        tinker_scene_block_class(tinker_document_scene(outline->document), item->block);
    if (block_class != NULL) tinker_guarded_icon_paint(cairo, block_class, width, height, tinker_desktop_theme());
}

GtkWidget *outline_add_label(GtkWidget *box, const char *css_class)
{
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    if (css_class != NULL) gtk_widget_add_css_class(label, css_class);
    gtk_box_append(GTK_BOX(box), label);
    return label;
}

/* The block under the pointer is what a menu is about, unless it is one of several that are selected. */
static void on_right_click(GtkGestureClick *gesture, int presses, double x, double y, TinkerOutline *outline)
{
    GtkWidget *box = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(gesture));
    OutlineItem *item = gtk_list_item_get_item(g_object_get_data(G_OBJECT(box), "row"));
    if (item == NULL || !tinker_scene_has_block(tinker_document_scene(outline->document), item->block)) return;
    if (!tinker_document_is_selected(outline->document, item->block))
        tinker_document_select(outline->document, item->block);
    gtk_widget_translate_coordinates(box, GTK_WIDGET(outline), x, y, &x, &y);
    g_signal_emit_by_name(outline, "menu", x, y);
}

static void on_setup(GtkSignalListItemFactory *factory, GtkListItem *row, TinkerOutline *outline)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8), *icon = gtk_drawing_area_new();
    gtk_drawing_area_set_content_width(GTK_DRAWING_AREA(icon), ICON_WIDTH);
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(icon), ICON_HEIGHT);
    g_object_set_data(G_OBJECT(icon), "row", row);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(icon), draw_icon, outline, NULL);
    tinker_desktop_theme_redraws(GTK_WIDGET(icon));
    gtk_box_append(GTK_BOX(box), icon);
    gtk_widget_set_hexpand(outline_add_label(box, NULL), TRUE);
    outline_add_label(box, "dim-label");
    GtkGesture *menu = gtk_gesture_click_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(menu), GDK_BUTTON_SECONDARY);
    g_signal_connect(menu, "pressed", G_CALLBACK(on_right_click), outline);
    gtk_widget_add_controller(box, GTK_EVENT_CONTROLLER(menu));
    g_object_set_data(G_OBJECT(box), "row", row);
    gtk_list_item_set_child(row, box);
}

/* What a screen reader says of a row stands on the widget that GTK puts around ours. */
static void describe(TinkerOutline *outline, GtkListItem *row)
{
    GtkWidget *box = gtk_list_item_get_child(row), *outer = gtk_widget_get_parent(box);
    OutlineItem *item = gtk_list_item_get_item(row);
    if (item == NULL || !tinker_scene_has_block(tinker_document_scene(outline->document), item->block)) return;
    g_autofree char *words = tinker_block_words(tinker_document_scene(outline->document), item->block);
    if (outer != NULL) gtk_accessible_update_property(GTK_ACCESSIBLE(outer), GTK_ACCESSIBLE_PROPERTY_LABEL, words, -1);
}

static void on_bind(GtkSignalListItemFactory *factory, GtkListItem *row, TinkerOutline *outline)
{
    GtkWidget *icon = gtk_widget_get_first_child(gtk_list_item_get_child(row));
    GtkWidget *name = gtk_widget_get_next_sibling(icon), *type = gtk_widget_get_next_sibling(name);
    OutlineItem *item = gtk_list_item_get_item(row);
    gboolean there = tinker_scene_has_block(tinker_document_scene(outline->document), item->block);
    gtk_label_set_text(GTK_LABEL(name), item->name);
    gtk_label_set_text(GTK_LABEL(type),
                       there ? tinker_block_type_title(tinker_document_scene(outline->document), item->block) : "");
    gtk_widget_queue_draw(icon);
    g_hash_table_add(outline->rows, row);
    describe(outline, row);
}

static void on_unbind(GtkSignalListItemFactory *factory, GtkListItem *row, TinkerOutline *outline)
{
    g_hash_table_remove(outline->rows, row);
}

void outline_describe_rows(TinkerOutline *outline)
{
    GHashTableIter iter;
    gpointer row;
    g_hash_table_iter_init(&iter, outline->rows);
    while (g_hash_table_iter_next(&iter, &row, NULL))
        describe(outline, row);
}

GtkListItemFactory *outline_row_factory(TinkerOutline *outline)
{
    GtkListItemFactory *factory = gtk_signal_list_item_factory_new();
    g_signal_connect(factory, "setup", G_CALLBACK(on_setup), outline);
    g_signal_connect(factory, "bind", G_CALLBACK(on_bind), outline);
    g_signal_connect(factory, "unbind", G_CALLBACK(on_unbind), outline);
    return factory;
}

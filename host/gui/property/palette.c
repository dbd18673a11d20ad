/* A list of buttons under headings, of which words that are typed leave those that they are found in. Which categories
 * there are, and what is in them, the manifests tell; a block's library is opened for its icon. A drag is followed by a
 * gesture of our own, so that the block itself can be seen on its way. */
#include "gui/property/palette.h"

#include <glib/gi18n.h>
#include <string.h>

#include "gui/document/icon-guard.h"
#include "gui/text/translate.h"
#include "gui/text/word-search.h"
#include "gui/widget/desktop-theme.h"
#include "gui/widget/tooltip.h"
#include "gui/widget/unparent.h"
#include "law/law-text.h"

#define ICON_WIDTH     48
#define ICON_HEIGHT    32
#define DRAG_THRESHOLD 6.0
#define SEARCH_WIDTH   6   /* characters, at least */
#define LEAST_WIDTH    172 /* px, with names */

struct _TinkerPalette {
    GtkWidget parent_instance;
    GtkWidget *search, *none, *list;
    GtkWidget *last; /* the button of the block that was placed last; borrowed, may be NULL */
    TinkerCatalogue *catalogue;
    TinkerCanvas *canvas;
    gboolean compact; /* symbols alone */
};

G_DEFINE_FINAL_TYPE(TinkerPalette, tinker_palette, GTK_TYPE_WIDGET)

/* One block of the palette. */
typedef struct {
    TinkerPalette *palette;
    const TinkerBlockClass *block_class;
    GtkWidget *button, *label;
    GStrv words; /* that it is found by */
    GStrv names; /* those of them that are of its title */
    gboolean dragged;
} Item;

static void item_free(gpointer data)
{
    g_strfreev(((Item *)data)->words);
    g_strfreev(((Item *)data)->names);
    g_free(data);
}

/* Of a widget in the list; NULL of a heading. */
static Item *item_of(GtkWidget *widget)
{
    return g_object_get_data(G_OBJECT(widget), "item");
}

/* What stands over the blocks of a category, and in which order; categories of others come behind, by their own name.
 */
static const struct {
    const char *category, *heading;
} headings[] = {
    {TINKER_CONNECTABLE, N_("Bodies")}, {TINKER_CONNECTOR, N_("Connectors")},  {TINKER_JOINT, N_("Joints")},
    {TINKER_FORCE, N_("Forces")},       {TINKER_ROPE, N_("Ropes and wheels")}, {TINKER_MOTION, N_("Motions")},
    {TINKER_FIELD, N_("Fields")},       {TINKER_MEASURE, N_("Measuring")},
};

static guint rank_of(const char *category)
{
    guint rank = 0;
    while (rank < G_N_ELEMENTS(headings) && g_strcmp0(headings[rank].category, category) != 0)
        rank++;
    return rank;
}

/* Placing ---------------------------------------------------------------------------------------------------------- */

static void on_clicked(Item *item)
{
    if (!item->dragged) {
        tinker_canvas_add(item->palette->canvas, item->block_class);
        item->palette->last = item->button;
    }
    item->dragged = FALSE;
    gtk_widget_grab_focus(GTK_WIDGET(item->palette->canvas));
}

static void on_drag(GtkGestureDrag *gesture, double dx, double dy, Item *item)
{
    double x, y, canvas_x, canvas_y;
    if (!item->dragged && dx * dx + dy * dy < DRAG_THRESHOLD * DRAG_THRESHOLD) return;
    item->dragged = TRUE;
    gtk_gesture_drag_get_start_point(gesture, &x, &y);
    GtkWidget *canvas = GTK_WIDGET(item->palette->canvas);
    if (!gtk_widget_translate_coordinates(item->button, canvas, x + dx, y + dy, &canvas_x, &canvas_y)) return;
    tinker_canvas_place_move(item->palette->canvas, item->block_class, canvas_x, canvas_y);
}

static void on_drag_end(GtkGestureDrag *gesture, double dx, double dy, Item *item)
{
    if (!item->dragged) return;
    if (tinker_canvas_place_drop(item->palette->canvas) != TINKER_NO_BLOCK) {
        item->palette->last = item->button;
        gtk_widget_grab_focus(GTK_WIDGET(item->palette->canvas));
    }
    /* The button that the drag began on reads the release as a click, which on_clicked passes over; unless it was left.
     */
    double x = 0, y = 0;
    gtk_gesture_drag_get_start_point(gesture, &x, &y);
    if (!gtk_widget_contains(item->button, x + dx, y + dy)) item->dragged = FALSE;
}

static void on_drag_cancel(GtkGesture *gesture, GdkEventSequence *sequence, Item *item)
{
    item->dragged = FALSE;
    tinker_canvas_place_cancel(item->palette->canvas);
}

/* The list --------------------------------------------------------------------------------------------------------- */

static void draw_icon(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    const Item *item = data;
    tinker_guarded_icon_paint(cairo, item->block_class, width, height, tinker_desktop_theme());
}

static GtkWidget *icon_of(Item *item)
{
    GtkWidget *icon = gtk_drawing_area_new();
    gtk_drawing_area_set_content_width(GTK_DRAWING_AREA(icon), ICON_WIDTH);
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(icon), ICON_HEIGHT);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(icon), draw_icon, item, NULL);
    tinker_desktop_theme_redraws(icon);
    return icon;
}

/* What it does and its law, below its name where that is not seen; NULL: nothing is known. (transfer full) */
static char *tooltip_of(const Item *item, gboolean named)
{
    const TinkerBlockType *type = item->block_class->type;
    g_autoptr(GString) text = g_string_new(named ? tinker_translate(type->title) : NULL);
    g_auto(GStrv) law = tinker_class_law_lines(item->block_class);
    if (type->summary != NULL)
        g_string_append_printf(text, "%s%s.", named ? "\n" : "", tinker_translate(type->summary));
    for (char **line = law; *line != NULL; line++)
        g_string_append_printf(text, "%s%s", text->len > 0 ? "\n" : "", *line);
    if (type->summary != NULL) g_string_append_printf(text, "\n%s", _("Click or drag it onto the canvas."));
    return text->len > 0 ? g_strdup(text->str) : NULL;
}

static GtkWidget *button_of(TinkerPalette *palette, const TinkerBlockClass *block_class)
{
    const TinkerBlockType *type = block_class->type;
    const char *title = tinker_translate(type->title);
    Item *item = g_new0(Item, 1);
    item->palette = palette;
    item->block_class = block_class;
    g_autofree char *found_by =
        g_strjoin(" ", title, type->summary != NULL ? tinker_translate(type->summary) : "", NULL);
    item->words = tinker_search_words(found_by);
    item->names = tinker_search_words(title);
    item->button = gtk_button_new();
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8);
    item->label = gtk_label_new(title);
    gtk_label_set_xalign(GTK_LABEL(item->label), 0);
    gtk_box_append(GTK_BOX(row), icon_of(item));
    gtk_box_append(GTK_BOX(row), item->label);
    gtk_button_set_child(GTK_BUTTON(item->button), row);
    gtk_widget_add_css_class(item->button, "flat");
    g_autofree char *tooltip = tooltip_of(item, FALSE);
    tinker_widget_begin_tooltip(item->button, tooltip);
    gtk_accessible_update_property(GTK_ACCESSIBLE(item->button), GTK_ACCESSIBLE_PROPERTY_LABEL, title, -1);
    g_object_set_data_full(G_OBJECT(item->button), "item", item, item_free);
    g_signal_connect_swapped(item->button, "clicked", G_CALLBACK(on_clicked), item);
    GtkGesture *drag = gtk_gesture_drag_new();
    gtk_event_controller_set_propagation_phase(GTK_EVENT_CONTROLLER(drag), GTK_PHASE_CAPTURE);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag), item);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_drag_end), item);
    g_signal_connect(drag, "cancel", G_CALLBACK(on_drag_cancel), item);
    gtk_widget_add_controller(item->button, GTK_EVENT_CONTROLLER(drag));
    return item->button;
}

static void add_heading(TinkerPalette *palette, const char *category)
{
    guint rank = rank_of(category);
    GtkWidget *label = gtk_label_new(rank < G_N_ELEMENTS(headings) ? _(headings[rank].heading) : category);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_widget_add_css_class(label, "heading");
    gtk_widget_add_css_class(label, "palette-heading");
    gtk_box_append(GTK_BOX(palette->list), label);
}

static int compare_types(const void *left, const void *right)
{
    const TinkerTypeEntry *l = *(TinkerTypeEntry *const *)left, *r = *(TinkerTypeEntry *const *)right;
    int by_rank = (int)rank_of(l->category) - (int)rank_of(r->category);
    if (by_rank != 0) return by_rank;
    int by_category = g_strcmp0(l->category, r->category);
    return by_category != 0 ? by_category : g_utf8_collate(tinker_translate(l->title), tinker_translate(r->title));
}

/* Every type that a scene could name, once, by category and title; borrowed from the libraries. */
static GPtrArray *usable_types(const GPtrArray *libraries)
{
    GPtrArray *types = tinker_libraries_types(libraries);
    g_ptr_array_sort(types, compare_types);
    return types;
}

/* Searching -------------------------------------------------------------------------------------------------------- */

/* A heading is shown where a block below it is. */
static void on_searched(TinkerPalette *palette)
{
    g_auto(GStrv) stems = tinker_search_stems(gtk_editable_get_text(GTK_EDITABLE(palette->search)));
    gboolean any = FALSE, below = FALSE;
    for (GtkWidget *child = gtk_widget_get_last_child(palette->list); child != NULL;
         child = gtk_widget_get_prev_sibling(child)) {
        const Item *item = item_of(child);
        const gboolean shown = item != NULL ? tinker_search_finds(item->words, stems) : below && !palette->compact;
        gtk_widget_set_visible(child, shown);
        below = item != NULL && (shown || below);
        any |= shown;
    }
    gtk_widget_set_visible(palette->none, !any);
}

/* Return places the first whose title has what stands in the entry, else the first that is found by it: what is like a
 * spring is not meant by "spring". The list may not know the entry yet: it is told of changes some time after they are
 * made. Where nothing is searched for, nothing has been found. */
static void on_search_activated(TinkerPalette *palette)
{
    g_auto(GStrv) stems = tinker_search_stems(gtk_editable_get_text(GTK_EDITABLE(palette->search)));
    if (*stems == NULL) return;
    on_searched(palette);
    Item *first = NULL;
    gboolean is_named = FALSE;
    for (GtkWidget *child = gtk_widget_get_first_child(palette->list); child != NULL && !is_named;
         child = gtk_widget_get_next_sibling(child)) {
        Item *item = item_of(child);
        if (item == NULL || !gtk_widget_get_visible(child)) continue;
        is_named = tinker_search_finds(item->names, stems);
        if (first == NULL || is_named) first = item;
    }
    if (first == NULL) return;
    on_clicked(first);
    gtk_editable_set_text(GTK_EDITABLE(palette->search), "");
}

static void on_search_stopped(TinkerPalette *palette)
{
    gtk_editable_set_text(GTK_EDITABLE(palette->search), "");
    gtk_widget_grab_focus(GTK_WIDGET(palette->canvas));
}

/* Letters that are typed in the list are searched for. */
static void on_search_started(TinkerPalette *palette)
{
    gtk_widget_grab_focus(palette->search);
    gtk_editable_set_position(GTK_EDITABLE(palette->search), -1);
}

static GtkWidget *make_search(TinkerPalette *palette)
{
    palette->search = gtk_search_entry_new();
    gtk_widget_add_css_class(palette->search, "palette-search");
    gtk_editable_set_width_chars(GTK_EDITABLE(palette->search), SEARCH_WIDTH); /* the blocks say how wide the list is */
    gtk_editable_set_max_width_chars(GTK_EDITABLE(palette->search), SEARCH_WIDTH);
    g_object_set(palette->search, "placeholder-text", _("Find a Block"), NULL);
    gtk_accessible_update_property(GTK_ACCESSIBLE(palette->search), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Find a Block"),
                                   -1);
    g_signal_connect_swapped(palette->search, "search-changed", G_CALLBACK(on_searched), palette);
    g_signal_connect_swapped(palette->search, "search-started", G_CALLBACK(on_search_started), palette);
    g_signal_connect_swapped(palette->search, "activate", G_CALLBACK(on_search_activated), palette);
    g_signal_connect_swapped(palette->search, "stop-search", G_CALLBACK(on_search_stopped), palette);
    return palette->search;
}

void tinker_palette_set_compact(TinkerPalette *palette, gboolean compact)
{
    if (compact == palette->compact) return;
    palette->compact = compact;
    gtk_widget_set_size_request(GTK_WIDGET(palette), compact ? -1 : LEAST_WIDTH, -1);
    gtk_editable_set_width_chars(GTK_EDITABLE(palette->search), compact ? 1 : SEARCH_WIDTH);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(palette->search), compact ? 1 : SEARCH_WIDTH);
    g_object_set(palette->search, "placeholder-text", compact ? NULL : _("Find a Block"), NULL);
    for (GtkWidget *child = gtk_widget_get_first_child(palette->list); child != NULL;
         child = gtk_widget_get_next_sibling(child)) {
        const Item *item = item_of(child);
        if (item == NULL) continue;
        gtk_widget_set_visible(item->label, !compact);
        g_autofree char *tooltip = tooltip_of(item, compact);
        gtk_widget_set_tooltip_text(item->button, tooltip);
    }
    on_searched(palette);
}

void tinker_palette_focus(TinkerPalette *palette)
{
    if (palette->last == NULL || !gtk_widget_get_visible(palette->last) || !gtk_widget_grab_focus(palette->last))
        gtk_widget_child_focus(palette->list, GTK_DIR_TAB_FORWARD);
}

void tinker_palette_set_canvas(TinkerPalette *palette, TinkerCatalogue *catalogue, TinkerCanvas *canvas)
{
    palette->catalogue = catalogue;
    palette->canvas = canvas;
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue), types = usable_types(libraries);
    const char *category = NULL;
    for (guint i = 0; i < types->len; i++) {
        const TinkerTypeEntry *entry = g_ptr_array_index(types, i);
        const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, entry->id, NULL);
        if (block_class == NULL) continue;
        if (g_strcmp0(category, entry->category) != 0) add_heading(palette, entry->category);
        category = entry->category;
        gtk_box_append(GTK_BOX(palette->list), button_of(palette, block_class));
    }
}

static void tinker_palette_dispose(GObject *object)
{
    tinker_unparent_children(GTK_WIDGET(object));
    G_OBJECT_CLASS(tinker_palette_parent_class)->dispose(object);
}

static void tinker_palette_class_init(TinkerPaletteClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_palette_dispose;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "palette");
}

static void tinker_palette_init(TinkerPalette *palette)
{
    GtkWidget *scrolled = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_orientable_set_orientation(GTK_ORIENTABLE(gtk_widget_get_layout_manager(GTK_WIDGET(palette))),
                                   GTK_ORIENTATION_VERTICAL);
    palette->list = gtk_box_new(GTK_ORIENTATION_VERTICAL, 2);
    palette->none = gtk_label_new(_("No block has all of these words"));
    gtk_widget_set_visible(palette->none, FALSE);
    gtk_widget_add_css_class(palette->none, "dim-label");
    gtk_label_set_wrap(GTK_LABEL(palette->none), TRUE);
    gtk_label_set_max_width_chars(GTK_LABEL(palette->none), 1);
    gtk_widget_set_parent(make_search(palette), GTK_WIDGET(palette));
    gtk_search_entry_set_key_capture_widget(GTK_SEARCH_ENTRY(palette->search), palette->list);
    gtk_widget_set_parent(palette->none, GTK_WIDGET(palette));
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), palette->list);
    gtk_widget_set_vexpand(scrolled, TRUE);
    gtk_widget_set_parent(scrolled, GTK_WIDGET(palette));
}

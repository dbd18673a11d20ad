/* Puts the parts together, and passes time on to the player while it plays. */
#include "gui/window/window-parts.h"

#include <glib/gi18n.h>

#include "gui/document/icon-guard.h"
#include "gui/document/refusal-notices.h"
#include "gui/gallery/welcome.h"
#include "gui/mode/modes-page.h"
#include "gui/property/property-panel.h"
#include "gui/text/message.h"
#include "gui/text/sentence.h"
#include "gui/widget/popup-menu.h"
#include "gui/window/scene-card.h"
#include "gui/window/side-panel.h"

G_DEFINE_FINAL_TYPE(TinkerWindow, tinker_window, ADW_TYPE_APPLICATION_WINDOW)

#define LONGEST_TICK 0.1  /* s: after a hang, playback goes on from where it was */
#define NARROW       1000 /* px: a window in which blocks are shown as symbols alone */

/* Playing ---------------------------------------------------------------------------------------------------------- */

static gboolean on_tick(GtkWidget *widget, GdkFrameClock *clock, gpointer data)
{
    TinkerWindow *window = TINKER_WINDOW(widget);
    gint64 now = gdk_frame_clock_get_frame_time(clock);
    double seconds = window->last_tick == 0 ? 0 : 1e-6 * (double)(now - window->last_tick);
    window->last_tick = now;
    tinker_player_advance(window->player, MIN(seconds, LONGEST_TICK));
    return G_SOURCE_CONTINUE;
}

static void on_state_changed(TinkerWindow *window)
{
    gboolean playing = tinker_player_state(window->player) == TINKER_PLAYER_PLAYING;
    if (playing && window->ticks == 0) {
        window->last_tick = 0;
        window->ticks = gtk_widget_add_tick_callback(GTK_WIDGET(window), on_tick, NULL, NULL);
    } else if (!playing && window->ticks != 0) {
        gtk_widget_remove_tick_callback(GTK_WIDGET(window), window->ticks);
        window->ticks = 0;
    }
    window_update_actions(window);
}

static void on_failed(TinkerPlayer *player, const char *message, TinkerWindow *window)
{
    g_autofree char *text = tinker_sentence_in(tinker_document_scene(window->document), message);
    window_message(window, _("The Run Stopped"), text);
}

static void on_rewound(TinkerWindow *window)
{
    window_toast(window, _("Back at the start, which is what you edit"));
}

/* The document ----------------------------------------------------------------------------------------------------- */

static void on_file_changed(TinkerWindow *window)
{
    g_autofree char *name = tinker_document_name(window->document);
    g_autofree char *title = g_strdup_printf("%s%s", tinker_document_is_modified(window->document) ? "• " : "", name);
    const char *path = tinker_document_path(window->document);
    g_autofree char *folder = path != NULL ? g_path_get_dirname(path) : NULL;
    adw_window_title_set_title(window->title, title);
    adw_window_title_set_subtitle(window->title, folder != NULL ? folder : "");
    gtk_window_set_title(GTK_WINDOW(window), title);
    window_update_actions(window);
}

static gboolean tinker_window_close_request(GtkWindow *base)
{
    TinkerWindow *window = TINKER_WINDOW(base);
    if (!window->may_close && tinker_document_is_modified(window->document)) {
        window_ask_to_close(window);
        return TRUE;
    }
    window_store_state(window);
    return GTK_WINDOW_CLASS(tinker_window_parent_class)->close_request(base);
}

/* The menu of the selection
 * ---------------------------------------------------------------------------------------------- */

static void on_menu(GtkWidget *over, double x, double y, TinkerWindow *window)
{
    g_autoptr(GtkBuilder) builder = gtk_builder_new_from_resource("/org/tinker/Tinker/menus.ui");
    GMenu *model = G_MENU(gtk_builder_get_object(builder, "canvas_menu"));
    window_add_start_menu(window, model);
    window_append_graph_menu(window, model);
    window_append_instrument_menu(window, model);
    if (over == GTK_WIDGET(window->canvas)) window_append_outline_menu(window, model);
    tinker_popup_menu(over, G_MENU_MODEL(model), x, y);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

static void on_canvas_faults(TinkerCanvas *canvas, TinkerWindow *window)
{
    GPtrArray *notices = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
    GList *faults = tinker_canvas_faults(canvas);
    for (GList *fault = faults; fault != NULL; fault = fault->next)
        g_ptr_array_add(notices, tinker_notice_new(TINKER_NOTICE_WARNING, fault->data, NULL, NULL, NULL, NULL));
    g_list_free(faults);
    tinker_notice_bar_set(window->notices, "drawing", notices);
}

/* Called whenever something over the canvas gets its place. */
static gboolean on_cover_placed(GtkOverlay *overlay, GtkWidget *child, GdkRectangle *place, TinkerWindow *window)
{
    if (child == GTK_WIDGET(window->banners)) {
        tinker_notice_bar_set_room(window->notices, gtk_widget_get_height(GTK_WIDGET(overlay)));
        tinker_canvas_cover_placed(window->canvas);
    }
    return FALSE; /* where it is anyway */
}

/* Equations, and above them the modes, which are worked out when they are unfolded. */
static GtkWidget *new_model_page(TinkerWindow *window, TinkerModesTask *task)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0);
    GtkWidget *modes = gtk_expander_new(_("Natural Frequencies and Modes"));
    gtk_expander_set_child(GTK_EXPANDER(modes),
                           tinker_modes_page_new(window->document, window->player, window->canvas, task));
    gtk_widget_add_css_class(modes, "modes");
    gtk_accessible_update_property(GTK_ACCESSIBLE(modes), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Natural Frequencies and Modes"), -1);
    gtk_box_append(GTK_BOX(box), modes);
    gtk_box_append(GTK_BOX(box), window->equations);
    return box;
}

/* The width of the widest text that is shown below a widget. */
static int widest_text(GtkWidget *widget)
{
    int widest = 0;
    if (GTK_IS_LABEL(widget)) gtk_widget_measure(widget, GTK_ORIENTATION_HORIZONTAL, -1, NULL, &widest, NULL, NULL);
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        if (gtk_widget_get_child_visible(child)) widest = MAX(widest, widest_text(child));
    return widest;
}

/* As wide as the names in it, which all have the room of the longest: otherwise it would cut them off before the title
 * gives way. What it wants by itself is more than a small window has. */
static void show_names_whole(GtkWidget *switcher)
{
    int count = 0;
    for (GtkWidget *child = gtk_widget_get_first_child(switcher); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        count++;
    gtk_widget_set_size_request(switcher, count * widest_text(switcher), -1);
}

static void connect_parts(TinkerWindow *window)
{
    tinker_canvas_set_cover(window->canvas, GTK_WIDGET(window->banners));
    g_signal_connect_object(window->canvas_overlay, "get-child-position", G_CALLBACK(on_cover_placed), window, 0);
    tinker_canvas_set_player(window->canvas, window->document, window->player);
    tinker_palette_set_canvas(window->palette, tinker_document_catalogue(window->document), window->canvas);
    tinker_playbar_set_player(window->playbar, window->player);
    window_add_graphs(window);
    window_add_extrema(window);
    window_add_instruments(window);
    window_add_measuring(window);
    window_add_outline_actions(window);
    GtkWidget *start = window_new_start_panel(window);
    window->equations = tinker_equations_page_new(window->document, window->player);
    g_autoptr(TinkerModesTask) modes = tinker_modes_task_new(window->document);
    window->side_panel =
        tinker_side_panel_new(window->document, window->player, start,
                              tinker_scene_card_new(window->document, window->plan), new_model_page(window, modes));
    window->properties = tinker_side_panel_properties(window->side_panel);
    tinker_property_panel_set_modes(TINKER_PROPERTY_PANEL(window->properties), modes);
    g_object_bind_property(window->properties, "trims", start, "trims", G_BINDING_SYNC_CREATE);
    window_add_switch(window, "trim-decimals", window->properties, "trims");
    gtk_box_append(window->panel, window->side_panel);
    g_signal_connect_object(window->player, "state-changed", G_CALLBACK(on_state_changed), window, G_CONNECT_SWAPPED);
    g_signal_connect_object(window->player, "failed", G_CALLBACK(on_failed), window, 0);
    g_signal_connect_object(window->player, "rewound", G_CALLBACK(on_rewound), window, G_CONNECT_SWAPPED);
    g_signal_connect_object(window->document, "file-changed", G_CALLBACK(on_file_changed), window, G_CONNECT_SWAPPED);
    g_signal_connect_object(window->document, "selection-changed", G_CALLBACK(window_update_actions), window,
                            G_CONNECT_SWAPPED);
    tinker_welcome_add(window->canvas_overlay, window->document, window->player);
    g_signal_connect_object(window->canvas, "menu", G_CALLBACK(on_menu), window, 0);
    g_signal_connect_object(tinker_side_panel_outline(window->side_panel), "menu", G_CALLBACK(on_menu), window, 0);
    g_signal_connect_object(window->canvas, "faults", G_CALLBACK(on_canvas_faults), window, 0);
}

TinkerWindow *tinker_window_new(AdwApplication *application, TinkerCatalogue *catalogue)
{
    TinkerWindow *window = g_object_new(TINKER_TYPE_WINDOW, "application", application, NULL);
    window->document = tinker_document_new(catalogue);
    window->player = tinker_player_new(window->document);
    window->plan = tinker_plan_task_new(window->document);
    window_add_actions(window);
    window_add_open_menu(window);
    window_add_autosave(window);
    connect_parts(window);
    window_add_accuracy(window);
    window_add_film(window);
    window_add_present(window);
    g_signal_connect_object(window->film, "changed", G_CALLBACK(window_update_actions), window, G_CONNECT_SWAPPED);
    tinker_notice_bar_set(window->notices, "plugins",
                          tinker_refusal_notices(tinker_document_catalogue(window->document)));
    tinker_notice_bar_set(window->notices, "icons", tinker_guarded_icon_notices());
    window_add_start(window);
    window_add_joints(window);
    show_names_whole(window->switcher);
    window_restore_state(window);
    window_start_first(window);
    on_file_changed(window);
    gtk_widget_grab_focus(GTK_WIDGET(window->canvas));
    return window;
}

static void tinker_window_dispose(GObject *object)
{
    TinkerWindow *window = TINKER_WINDOW(object);
    /* What the parts do as they go is not to be shown by others that have gone. */
    if (window->document != NULL) g_signal_handlers_disconnect_by_data(window->document, window);
    if (window->player != NULL) g_signal_handlers_disconnect_by_data(window->player, window);
    window_remove_accuracy(window);
    window_remove_extrema(window);
    gtk_widget_dispose_template(GTK_WIDGET(window), TINKER_TYPE_WINDOW);
    g_clear_object(&window->film); /* gives up what is under way */
    g_clear_object(&window->autosave);
    g_clear_object(&window->player);
    g_clear_object(&window->document);
    G_OBJECT_CLASS(tinker_window_parent_class)->dispose(object);
}

#define BIND(part) gtk_widget_class_bind_template_child(widget_class, TinkerWindow, part)

/* In a narrow window the canvas has the room of the blocks' names. */
static void on_layout(GdkSurface *surface, int width, int height, TinkerWindow *window)
{
    tinker_palette_set_compact(window->palette, width < NARROW);
}

static void tinker_window_realize(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(tinker_window_parent_class)->realize(widget);
    g_signal_connect_object(gtk_native_get_surface(GTK_NATIVE(widget)), "layout", G_CALLBACK(on_layout), widget, 0);
}

static void tinker_window_class_init(TinkerWindowClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_window_dispose;
    GTK_WINDOW_CLASS(class)->close_request = tinker_window_close_request;
    widget_class->realize = tinker_window_realize;
    gtk_widget_class_set_template_from_resource(widget_class, "/org/tinker/Tinker/window.ui");
    BIND(canvas);
    BIND(header);
    BIND(palette);
    BIND(playbar);
    BIND(toasts);
    BIND(title);
    BIND(pages);
    BIND(switcher);
    BIND(panel);
    BIND(palette_side);
    BIND(panel_side);
    BIND(dock);
    BIND(status);
    BIND(banners);
    BIND(canvas_overlay);
    BIND(graph_layer);
    BIND(open_button);
    BIND(recent_menu);
    BIND(examples_menu);
}

static void tinker_window_init(TinkerWindow *window)
{
    g_type_ensure(TINKER_TYPE_CANVAS);
    g_type_ensure(TINKER_TYPE_GRAPH_LAYER);
    g_type_ensure(TINKER_TYPE_PALETTE);
    g_type_ensure(TINKER_TYPE_PLAYBAR);
    gtk_widget_init_template(GTK_WIDGET(window));
}

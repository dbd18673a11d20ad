/* Every command is an action, so that menus, keys, buttons, tests and D-Bus share one path. */
#include <glib/gi18n.h>

#include "gui/gallery/gallery.h"
#include "gui/text/sentence.h"
#include "gui/window/help-window.h"
#include "gui/window/window-parts.h"
#include "scene/history/fragment.h"

#define ZOOM_STEP   1.25
#define FORCES_STEP 2.0

typedef void (*Command)(TinkerWindow *window);

/* Running ---------------------------------------------------------------------------------------------------------- */

/* Says why the scene cannot run, and selects the block that is to blame. */
static void tell_refusal(TinkerWindow *window, TinkerBlockId culprit, const GError *error)
{
    if (culprit != TINKER_NO_BLOCK) tinker_document_select(window->document, culprit);
    g_autofree char *text = tinker_sentence_in(tinker_document_scene(window->document), error->message);
    window_message(window, _("The Scene Cannot Run Yet"), text);
}

static void play(TinkerWindow *window)
{
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    tinker_autosave_now(window->autosave); /* who knows what a plugin does */
    if (tinker_player_state(window->player) == TINKER_PLAYER_PLAYING)
        tinker_player_pause(window->player);
    else if (!tinker_player_play(window->player, &culprit, &error))
        tell_refusal(window, culprit, error);
}

static void step_by_one(TinkerWindow *window, gboolean forward)
{
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    tinker_autosave_now(window->autosave);
    if (!tinker_player_step(window->player, forward, &culprit, &error)) tell_refusal(window, culprit, error);
}

static void step_forward(TinkerWindow *window)
{
    step_by_one(window, TRUE);
}

static void step_back(TinkerWindow *window)
{
    step_by_one(window, FALSE);
}

static void on_go_to(GSimpleAction *action, GVariant *time, gpointer data)
{
    TinkerWindow *window = data;
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    tinker_autosave_now(window->autosave);
    if (!tinker_player_go_to(window->player, g_variant_get_double(time), &culprit, &error))
        tell_refusal(window, culprit, error);
}

static void reset(TinkerWindow *window)
{
    tinker_player_reset(window->player);
}

/* Editing ---------------------------------------------------------------------------------------------------------- */

static void undo(TinkerWindow *window)
{
    tinker_document_undo(window->document);
}

static void redo(TinkerWindow *window)
{
    tinker_document_redo(window->document);
}

static void delete_selected(TinkerWindow *window)
{
    tinker_document_remove_selected(window->document);
}

static void bring_to_front(TinkerWindow *window)
{
    tinker_document_order_selected(window->document, TRUE);
}

static void send_to_back(TinkerWindow *window)
{
    tinker_document_order_selected(window->document, FALSE);
}

/* To the blocks there are, which the arrow keys go through; Return places one. */
static void place(TinkerWindow *window)
{
    gtk_widget_set_visible(GTK_WIDGET(window->palette_side), TRUE);
    adw_view_stack_set_visible_child_name(window->pages, "model");
    tinker_palette_focus(window->palette);
}

static char *text_of_selection(TinkerWindow *window)
{
    int count;
    const TinkerBlockId *blocks = tinker_document_selection(window->document, &count);
    return count > 0 ? tinker_fragment_to_text(tinker_document_scene(window->document), blocks, count) : NULL;
}

static void copy(TinkerWindow *window)
{
    g_autofree char *text = text_of_selection(window);
    if (text != NULL) gdk_clipboard_set_text(gtk_widget_get_clipboard(GTK_WIDGET(window)), text);
}

static void cut(TinkerWindow *window)
{
    copy(window);
    tinker_document_remove_selected(window->document);
}

/* Adds the blocks of a text beside where they came from, and selects them. */
static void paste_text(TinkerWindow *window, const char *text)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GArray) pasted = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    double grid = tinker_scene_head(tinker_document_scene(window->document))->canvas_grid, by = 5 * grid;
    if (tinker_player_time(window->player) > 0) tinker_player_rewind(window->player);
    tinker_document_interrupt(window->document);
    if (!tinker_fragment_paste(tinker_document_history(window->document), text, by, -by, pasted, &error)) {
        window_toast(window, error->message);
        return;
    }
    tinker_document_touch(window->document);
    tinker_document_select_all_of(window->document, (const TinkerBlockId *)(gpointer)pasted->data, (int)pasted->len);
}

static void on_clipboard_text(GObject *source, GAsyncResult *result, gpointer data)
{
    g_autoptr(TinkerWindow) window = data;
    g_autofree char *text = gdk_clipboard_read_text_finish(GDK_CLIPBOARD(source), result, NULL);
    if (text != NULL) paste_text(window, text);
}

static void paste(TinkerWindow *window)
{
    gdk_clipboard_read_text_async(gtk_widget_get_clipboard(GTK_WIDGET(window)), NULL, on_clipboard_text,
                                  g_object_ref(window));
}

static void duplicate(TinkerWindow *window)
{
    g_autofree char *text = text_of_selection(window);
    if (text != NULL) paste_text(window, text);
}

static void select_all(TinkerWindow *window)
{
    TinkerScene *scene = tinker_document_scene(window->document);
    int32_t count = tinker_scene_block_count(scene);
    g_autofree TinkerBlockId *blocks = g_new(TinkerBlockId, (gsize)count + 1);
    for (int32_t place = 0; place < count; place++)
        blocks[place] = tinker_scene_block_at(scene, place);
    tinker_document_select_all_of(window->document, blocks, count);
}

/* Looking ---------------------------------------------------------------------------------------------------------- */

static void zoom_in(TinkerWindow *window)
{
    tinker_canvas_zoom(window->canvas, ZOOM_STEP);
}

static void zoom_out(TinkerWindow *window)
{
    tinker_canvas_zoom(window->canvas, 1 / ZOOM_STEP);
}

static void zoom_fit(TinkerWindow *window)
{
    tinker_canvas_fit(window->canvas);
}

static void zoom_width(TinkerWindow *window)
{
    tinker_canvas_show_width(window->canvas);
}

static void longer_forces(TinkerWindow *window)
{
    tinker_canvas_scale_forces(window->canvas, FORCES_STEP);
}

static void shorter_forces(TinkerWindow *window)
{
    tinker_canvas_scale_forces(window->canvas, 1 / FORCES_STEP);
}

/* Made when it is asked for: GTK would make it with every window. */
static void show_help_overlay(TinkerWindow *window)
{
    g_autoptr(GtkBuilder) builder = gtk_builder_new_from_resource("/org/tinker/Tinker/help-overlay.ui");
    GtkWindow *overlay = GTK_WINDOW(gtk_builder_get_object(builder, "help_overlay"));
    gtk_window_set_transient_for(overlay, GTK_WINDOW(window));
    gtk_window_present(overlay);
}

static void show_gallery(TinkerWindow *window)
{
    tinker_gallery_show(GTK_WINDOW(window), tinker_document_catalogue(window->document));
}

static void show_help(TinkerWindow *window)
{
    tinker_help_show(GTK_WINDOW(window));
}

/* Files ------------------------------------------------------------------------------------------------------------ */

static void save(TinkerWindow *window)
{
    window_save(window, FALSE);
}

static void save_as(TinkerWindow *window)
{
    window_save(window, TRUE);
}

/* The table -------------------------------------------------------------------------------------------------------- */

/* Keys that mean something to an entry, too, are caught behind it; see tinker_window_set_accels. */
static const struct {
    const char *name;
    Command command;
    const char *keys[3];
    gboolean of_canvas; /* keys count only where the canvas has the focus */
} commands[] = {
    {"help", show_help, {"F1"}, FALSE},
    {"show-help-overlay", show_help_overlay, {"<Control>question"}, FALSE},
    {"new", tinker_window_new_scene, {"<Control>n"}, FALSE},
    {"open", window_choose_file, {"<Control>o"}, FALSE},
    {"gallery", show_gallery, {"<Control><Shift>o"}, FALSE},
    {"save", save, {"<Control>s"}, FALSE},
    {"save-as", save_as, {"<Control><Shift>s"}, FALSE},
    {"export-film", window_export_film, {NULL}, FALSE},
    {"save-picture", window_save_picture, {"<Control><Shift>p"}, FALSE},
    {"print", window_print, {"<Control>p"}, FALSE},
    {"undo", undo, {"<Control>z"}, TRUE},
    {"redo", redo, {"<Control><Shift>z", "<Control>y"}, TRUE},
    {"cut", cut, {"<Control>x"}, TRUE},
    {"copy", copy, {"<Control>c"}, TRUE},
    {"paste", paste, {"<Control>v"}, TRUE},
    {"duplicate", duplicate, {"<Control>d"}, FALSE},
    {"delete", delete_selected, {"Delete", "BackSpace"}, TRUE},
    {"bring-to-front", bring_to_front, {"<Shift>Page_Up"}, TRUE},
    {"send-to-back", send_to_back, {"<Shift>Page_Down"}, TRUE},
    {"place", place, {"Insert"}, FALSE},
    {"select-all", select_all, {"<Control>a"}, TRUE},
    {"new-graph", window_new_graph, {"<Control>g"}, FALSE},
    {"keep-run", window_keep_run, {"<Control>k"}, FALSE},
    {"kept-runs", window_kept_runs, {"<Control><Shift>k"}, FALSE},
    {"play", play, {"space"}, TRUE},
    {"step", step_forward, {"period"}, TRUE},
    {"step-back", step_back, {"comma"}, TRUE},
    {"reset", reset, {"Home"}, TRUE},
    {"zoom-in", zoom_in, {"<Control>plus", "<Control>equal"}, FALSE},
    {"zoom-out", zoom_out, {"<Control>minus"}, FALSE},
    {"zoom-fit", zoom_fit, {"<Control>0"}, FALSE},
    {"zoom-width", zoom_width, {"<Control>1"}, FALSE},
    {"longer-forces", longer_forces, {"bracketright"}, TRUE},
    {"shorter-forces", shorter_forces, {"bracketleft"}, TRUE},
};

/* An entry takes over what is being typed when it loses the focus. One that is wrong gets it back, for Escape and
 * another try. */
static void take_over_entry(TinkerWindow *window)
{
    GtkWidget *focus = gtk_window_get_focus(GTK_WINDOW(window));
    if (!GTK_IS_EDITABLE(focus)) return;
    GtkWidget *around = gtk_widget_get_ancestor(focus, GTK_TYPE_ENTRY);
    g_autoptr(GtkWidget) entry = around != NULL ? g_object_ref(around) : NULL;
    gtk_window_set_focus(GTK_WINDOW(window), NULL);
    gboolean is_wrong = entry != NULL && gtk_widget_get_mapped(entry) && gtk_widget_has_css_class(entry, "error");
    gtk_widget_grab_focus(is_wrong ? entry : GTK_WIDGET(window->canvas));
}

static void on_activate(GSimpleAction *action, GVariant *parameter, gpointer window)
{
    take_over_entry(window);
    const char *name = g_action_get_name(G_ACTION(action));
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++)
        if (g_strcmp0(commands[i].name, name) == 0) commands[i].command(window);
}

void tinker_window_set_accels(GtkApplication *application)
{
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        if (commands[i].of_canvas) continue;
        g_autofree char *action = g_strconcat("win.", commands[i].name, NULL);
        const char *keys[] = {commands[i].keys[0], commands[i].keys[1], NULL};
        gtk_application_set_accels_for_action(application, action, keys);
    }
    gtk_application_set_accels_for_action(application, "win.show-palette", (const char *[]){"F9", NULL});
    gtk_application_set_accels_for_action(application, "win.show-panel", (const char *[]){"<Shift>F9", NULL});
    gtk_application_set_accels_for_action(application, "win.ruler", (const char *[]){"<Control>r", NULL});
    gtk_application_set_accels_for_action(application, "win.protractor", (const char *[]){"<Control><Shift>r", NULL});
    gtk_application_set_accels_for_action(application, "win.present", (const char *[]){"F11", NULL});
    gtk_application_set_accels_for_action(application, "app.quit", (const char *[]){"<Control>q", NULL});
    gtk_application_set_accels_for_action(application, "app.new-window", (const char *[]){"<Control><Shift>n", NULL});
    gtk_application_set_accels_for_action(application, "window.close", (const char *[]){"<Control>w", NULL});
}

/* Undo and redo belong to the whole window, behind its entries: a button may have the focus, or nothing. */
static gboolean has_key_on(gsize command, gboolean canvas)
{
    const char *const everywhere[] = {"undo", "redo", NULL};
    return commands[command].of_canvas && g_strv_contains(everywhere, commands[command].name) != canvas;
}

static void add_keys(TinkerWindow *window, GtkWidget *to)
{
    GtkEventController *controller = gtk_shortcut_controller_new();
    const gboolean canvas = to == GTK_WIDGET(window->canvas);
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++)
        for (int k = 0; has_key_on(i, canvas) && k < 2 && commands[i].keys[k] != NULL; k++) {
            g_autofree char *action = g_strconcat("win.", commands[i].name, NULL);
            gtk_shortcut_controller_add_shortcut(
                GTK_SHORTCUT_CONTROLLER(controller),
                gtk_shortcut_new(gtk_shortcut_trigger_parse_string(commands[i].keys[k]), gtk_named_action_new(action)));
        }
    gtk_widget_add_controller(to, controller);
}

static void enable(TinkerWindow *window, const char *name, gboolean enabled)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), name);
    g_simple_action_set_enabled(G_SIMPLE_ACTION(action), enabled);
}

void window_update_actions(TinkerWindow *window)
{
    int selected;
    tinker_document_selection(window->document, &selected);
    TinkerHistory *history = tinker_document_history(window->document);
    enable(window, "undo", tinker_history_can_undo(history) != NULL);
    enable(window, "redo", tinker_history_can_redo(history) != NULL);
    enable(window, "export-film", window_can_export_film(window));
    static const char *const of_selection[] = {"cut", "copy", "duplicate", "delete", "bring-to-front", "send-to-back"};
    for (gsize i = 0; i < G_N_ELEMENTS(of_selection); i++)
        enable(window, of_selection[i], selected > 0);
}

void window_add_switch(TinkerWindow *window, const char *name, gpointer object, const char *property)
{
    g_autoptr(GPropertyAction) action = g_property_action_new(name, object, property);
    g_action_map_add_action(G_ACTION_MAP(window), G_ACTION(action));
}

void window_add_actions(TinkerWindow *window)
{
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        const GActionEntry entry = {.name = commands[i].name, .activate = on_activate};
        g_action_map_add_action_entries(G_ACTION_MAP(window), &entry, 1, window);
    }
    const GActionEntry go_to = {.name = "go-to", .activate = on_go_to, .parameter_type = "d"};
    g_action_map_add_action_entries(G_ACTION_MAP(window), &go_to, 1, window);
    static const char *const shown[] = {
        "show-labels", "show-forces",        "show-velocities", "show-accelerations",       "show-net-forces",
        "show-trails", "show-local-origins", "show-grid",       "forces-on-this-body-only", "follow"};
    for (gsize i = 0; i < G_N_ELEMENTS(shown); i++)
        window_add_switch(window, shown[i], window->canvas, shown[i]);
    window_add_switch(window, "show-palette", window->palette_side, "visible");
    window_add_switch(window, "show-panel", window->panel_side, "visible");
    add_keys(window, GTK_WIDGET(window->canvas));
    add_keys(window, GTK_WIDGET(window));
}

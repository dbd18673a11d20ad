/* Full screen for a projector: the canvas, its graphs and the play bar alone, all that is written or drawn larger. What
 * was folded away before is so again afterwards. */
#include "gui/window/window-parts.h"

#define DATA "tinker-before-presenting"

/* Whether a part was shown before. */
typedef struct {
    gboolean palette, panel;
} Before;

static GtkWidget *const *parts_of(TinkerWindow *window, GtkWidget *parts[4])
{
    parts[0] = GTK_WIDGET(window->palette_side);
    parts[1] = GTK_WIDGET(window->panel_side);
    parts[2] = window->header;
    parts[3] = GTK_WIDGET(window->status);
    return parts;
}

static void begin(TinkerWindow *window)
{
    Before *before = g_new(Before, 1);
    GtkWidget *parts[4];
    *before = (Before){gtk_widget_get_visible(GTK_WIDGET(window->palette_side)),
                       gtk_widget_get_visible(GTK_WIDGET(window->panel_side))};
    g_object_set_data_full(G_OBJECT(window), DATA, before, g_free);
    for (int i = 0; i < 4; i++)
        gtk_widget_set_visible(parts_of(window, parts)[i], FALSE);
    gtk_widget_add_css_class(GTK_WIDGET(window), "presentation");
    gtk_window_fullscreen(GTK_WINDOW(window));
    gtk_widget_grab_focus(GTK_WIDGET(window->canvas));
}

static void end(TinkerWindow *window)
{
    const Before *before = g_object_get_data(G_OBJECT(window), DATA);
    gtk_widget_set_visible(GTK_WIDGET(window->palette_side), before->palette);
    gtk_widget_set_visible(GTK_WIDGET(window->panel_side), before->panel);
    gtk_widget_set_visible(window->header, TRUE);
    gtk_widget_set_visible(GTK_WIDGET(window->status), TRUE);
    gtk_widget_remove_css_class(GTK_WIDGET(window), "presentation");
    gtk_window_unfullscreen(GTK_WINDOW(window));
    g_object_set_data(G_OBJECT(window), DATA, NULL);
}

static void present(GSimpleAction *action, GVariant *state, gpointer data)
{
    TinkerWindow *window = data;
    const gboolean now = g_variant_get_boolean(state), before = g_object_get_data(G_OBJECT(window), DATA) != NULL;
    if (now != before) (now ? begin : end)(window);
    g_object_set(window->canvas, "large", now, NULL);
    g_simple_action_set_state(action, state);
}

/* Escape ends it, where nobody else has a use for it. */
static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       TinkerWindow *window)
{
    if (key != GDK_KEY_Escape || g_object_get_data(G_OBJECT(window), DATA) == NULL) return GDK_EVENT_PROPAGATE;
    g_action_group_change_action_state(G_ACTION_GROUP(window), "present", g_variant_new_boolean(FALSE));
    return GDK_EVENT_STOP;
}

void window_add_present(TinkerWindow *window)
{
    static const GActionEntry actions[] = {{.name = "present", .state = "false", .change_state = present}};
    g_action_map_add_action_entries(G_ACTION_MAP(window), actions, G_N_ELEMENTS(actions), window);
    GtkEventController *keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE); /* the canvas takes it, too */
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), window);
    gtk_widget_add_controller(GTK_WIDGET(window), keys);
}

/* What a window looks like is remembered when it closes, for the next one: its size, the panes that have a name, the
 * panels that are folded away, what the canvas shows. */
#include "gui/text/settings.h"
#include "gui/window/window-parts.h"

#define GROUP_WINDOW "window"
#define GROUP_PANES  "panes"
#define GROUP_CANVAS "canvas"
#define LEAST_SIZE   300

static const char *const switches[] = {"show-labels",        "show-forces",     "show-velocities",
                                       "show-accelerations", "show-net-forces", "show-trails",
                                       "show-local-origins", "show-grid",       "forces-on-this-body-only"};

typedef void (*ForPane)(GtkPaned *pane, const char *name);

/* Only panes with a name are remembered: others may be another thing next time. */
static void for_panes(GtkWidget *widget, ForPane call)
{
    const char *name = gtk_widget_get_name(widget);
    if (GTK_IS_PANED(widget) && g_strcmp0(name, G_OBJECT_TYPE_NAME(widget)) != 0) call(GTK_PANED(widget), name);
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        for_panes(child, call);
}

static void restore_pane(GtkPaned *pane, const char *name)
{
    int position = tinker_settings_integer(GROUP_PANES, name, -1);
    if (position > 0) gtk_paned_set_position(pane, position);
}

static void store_pane(GtkPaned *pane, const char *name)
{
    gboolean set;
    g_object_get(pane, "position-set", &set, NULL);
    if (set) tinker_settings_set_integer(GROUP_PANES, name, gtk_paned_get_position(pane));
}

void window_restore_state(TinkerWindow *window)
{
    int width = tinker_settings_integer(GROUP_WINDOW, "width", 0);
    int height = tinker_settings_integer(GROUP_WINDOW, "height", 0);
    if (width >= LEAST_SIZE && height >= LEAST_SIZE) gtk_window_set_default_size(GTK_WINDOW(window), width, height);
    if (tinker_settings_switch(GROUP_WINDOW, "maximized", FALSE)) gtk_window_maximize(GTK_WINDOW(window));
    for (gsize i = 0; i < G_N_ELEMENTS(switches); i++) {
        gboolean value;
        g_object_get(window->canvas, switches[i], &value, NULL);
        g_object_set(window->canvas, switches[i], tinker_settings_switch(GROUP_CANVAS, switches[i], value), NULL);
    }
    gtk_widget_set_visible(GTK_WIDGET(window->palette_side), tinker_settings_switch(GROUP_WINDOW, "palette", TRUE));
    gtk_widget_set_visible(GTK_WIDGET(window->panel_side), tinker_settings_switch(GROUP_WINDOW, "panel", TRUE));
    g_object_set(window->properties, "trims", tinker_settings_switch(GROUP_WINDOW, "trim-decimals", FALSE), NULL);
    for_panes(GTK_WIDGET(window), restore_pane);
}

void window_store_state(TinkerWindow *window)
{
    int width, height;
    gtk_window_get_default_size(GTK_WINDOW(window), &width, &height);
    tinker_settings_set_integer(GROUP_WINDOW, "width", width);
    tinker_settings_set_integer(GROUP_WINDOW, "height", height);
    tinker_settings_set_switch(GROUP_WINDOW, "maximized", gtk_window_is_maximized(GTK_WINDOW(window)));
    for (gsize i = 0; i < G_N_ELEMENTS(switches); i++) {
        gboolean value;
        g_object_get(window->canvas, switches[i], &value, NULL);
        tinker_settings_set_switch(GROUP_CANVAS, switches[i], value);
    }
    tinker_settings_set_switch(GROUP_WINDOW, "palette", gtk_widget_get_visible(GTK_WIDGET(window->palette_side)));
    tinker_settings_set_switch(GROUP_WINDOW, "panel", gtk_widget_get_visible(GTK_WIDGET(window->panel_side)));
    gboolean trims;
    g_object_get(window->properties, "trims", &trims, NULL);
    tinker_settings_set_switch(GROUP_WINDOW, "trim-decimals", trims);
    for_panes(GTK_WIDGET(window), store_pane);
    tinker_settings_store();
}

/* One process serves all windows; a second start hands its files over to the first. */
#include "application.h"

#include <glib/gi18n.h>

#include "background.h"
#include "installation.h"
#include "window.h"

struct _TinkerApplication {
    AdwApplication parent_instance;
    TinkerCatalogue *catalogue;
};

G_DEFINE_FINAL_TYPE(TinkerApplication, tinker_application, ADW_TYPE_APPLICATION)

TinkerCatalogue *tinker_application_catalogue(TinkerApplication *application)
{
    if (application->catalogue == NULL) application->catalogue = tinker_installation_catalogue(NULL);
    return application->catalogue;
}

static TinkerWindow *new_window(TinkerApplication *application)
{
    TinkerWindow *window = tinker_window_new(application);
    gtk_window_present(GTK_WINDOW(window));
    return window;
}

/* Actions ------------------------------------------------------------------------------------------------------------- */

static void on_new_window(GSimpleAction *action, GVariant *parameter, gpointer application)
{
    new_window(application);
}

static void on_quit(GSimpleAction *action, GVariant *parameter, gpointer application)
{
    GList *windows = g_list_copy(gtk_application_get_windows(GTK_APPLICATION(application)));
    for (GList *window = windows; window != NULL; window = window->next)
        gtk_window_close(window->data);
    g_list_free(windows);
}

static void on_about(GSimpleAction *action, GVariant *parameter, gpointer application)
{
    adw_show_about_window(gtk_application_get_active_window(application), "application-name", "Tinker",
                          "application-icon", TINKER_APPLICATION_ID, "version", TINKER_VERSION, "developer-name",
                          _("The Tinker founders"), "license-type", GTK_LICENSE_MIT_X11, "comments",
                          _("A visual playground for engineering dynamics"), NULL);
}

static const GActionEntry actions[] = {
    {.name = "new-window", .activate = on_new_window},
    {.name = "quit", .activate = on_quit},
    {.name = "about", .activate = on_about},
};

/* Life ---------------------------------------------------------------------------------------------------------------- */

static void tinker_application_startup(GApplication *base)
{
    G_APPLICATION_CLASS(tinker_application_parent_class)->startup(base);
    g_action_map_add_action_entries(G_ACTION_MAP(base), actions, G_N_ELEMENTS(actions), base);
    gtk_window_set_default_icon_name(TINKER_APPLICATION_ID);
    tinker_window_set_accels(GTK_APPLICATION(base));
}

static void tinker_application_activate(GApplication *base)
{
    GtkWindow *window = gtk_application_get_active_window(GTK_APPLICATION(base));
    if (window != NULL)
        gtk_window_present(window);
    else
        new_window(TINKER_APPLICATION(base));
}

/* Each file gets a window of its own; the first takes one that nothing has been done in. */
static void tinker_application_open(GApplication *base, GFile **files, int count, const char *hint)
{
    for (int i = 0; i < count; i++) {
        GtkWindow *active = gtk_application_get_active_window(GTK_APPLICATION(base));
        TinkerWindow *window =
            active != NULL && TINKER_IS_WINDOW(active) && tinker_window_is_untouched(TINKER_WINDOW(active))
                ? TINKER_WINDOW(active)
                : new_window(TINKER_APPLICATION(base));
        g_autofree char *path = g_file_get_path(files[i]);
        tinker_window_open(window, path);
    }
}

static void tinker_application_finalize(GObject *object)
{
    tinker_background_wait();
    g_clear_pointer(&TINKER_APPLICATION(object)->catalogue, tinker_catalogue_free);
    G_OBJECT_CLASS(tinker_application_parent_class)->finalize(object);
}

static void tinker_application_class_init(TinkerApplicationClass *class)
{
    G_APPLICATION_CLASS(class)->startup = tinker_application_startup;
    G_APPLICATION_CLASS(class)->activate = tinker_application_activate;
    G_APPLICATION_CLASS(class)->open = tinker_application_open;
    G_OBJECT_CLASS(class)->finalize = tinker_application_finalize;
}

static void tinker_application_init(TinkerApplication *application) {}

TinkerApplication *tinker_application_new(void)
{
    return g_object_new(TINKER_TYPE_APPLICATION, "application-id", TINKER_APPLICATION_ID, "flags",
                        G_APPLICATION_HANDLES_OPEN, "resource-base-path", "/org/tinker/Tinker", NULL);
}

/* One process serves all windows; a second start hands its files over to the first. With folders of plugins of its own,
 * and for pictures, a process stays by itself. */
#include "gui/app/application.h"

#include <glib/gi18n.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "common/program/exit-status.h"
#include "common/program/installation.h"
#include "gui/app/command-line.h"
#include "gui/app/screenshot.h"
#include "gui/document/background.h"
#include "gui/document/recovery.h"
#include "gui/text/settings.h"
#include "gui/window/window-recovery.h"
#include "gui/window/window.h"

/* s that a thread has to stop in, at the end. */
#define LONGEST_WAIT 10

struct _TinkerApplication {
    AdwApplication parent_instance;
    TinkerCatalogue *catalogue;
    TinkerCommandLine line;
    gboolean line_is_read;
    gboolean recovery_offered;
    int status; /* exit status, of pictures */
};

G_DEFINE_FINAL_TYPE(TinkerApplication, tinker_application, ADW_TYPE_APPLICATION)

/* The installed blocks. Borrowed; lives as long as the application. */
static TinkerCatalogue *catalogue_of(TinkerApplication *application)
{
    if (application->catalogue == NULL)
        application->catalogue = tinker_installation_catalogue((const char *const *)application->line.plugin_folders);
    return application->catalogue;
}

int tinker_application_status(TinkerApplication *application)
{
    return application->status;
}

/* Once, over the first window. */
static gboolean offer_recovery(gpointer data)
{
    GtkWindow *window = gtk_application_get_active_window(data);
    if (TINKER_IS_WINDOW(window)) tinker_window_offer_recovery(TINKER_WINDOW(window), data);
    return G_SOURCE_REMOVE;
}

static TinkerWindow *new_window(TinkerApplication *application)
{
    TinkerWindow *window = tinker_window_new(ADW_APPLICATION(application), catalogue_of(application));
    gtk_window_present(GTK_WINDOW(window));
    if (!application->recovery_offered) g_idle_add_full(G_PRIORITY_LOW, offer_recovery, application, NULL);
    application->recovery_offered = TRUE;
    return window;
}

/* Actions ---------------------------------------------------------------------------------------------------------- */

static void on_new_window(GSimpleAction *action, GVariant *parameter, gpointer application)
{
    new_window(application);
}

static void on_new_scene(GSimpleAction *action, GVariant *parameter, gpointer application)
{
    tinker_window_new_scene(new_window(application));
}

/* Windows with changes that are not saved ask first, and stay. */
static void on_quit(GSimpleAction *action, GVariant *parameter, gpointer application)
{
    GList *windows = gtk_application_get_windows(GTK_APPLICATION(application));
    windows = g_list_copy_deep(windows, (GCopyFunc)(void (*)(void))g_object_ref, NULL);
    for (GList *window = windows; window != NULL; window = window->next)
        gtk_window_close(window->data);
    g_list_free_full(windows, g_object_unref);
}

static void on_about(GSimpleAction *action, GVariant *parameter, gpointer application)
{
    adw_show_about_window(gtk_application_get_active_window(application), "application-name", "Tinker",
                          "application-icon", TINKER_APPLICATION_ID, "version", TINKER_VERSION, "developer-name",
                          _("The Tinker founders"), "license-type", GTK_LICENSE_MIT_X11, "comments",
                          _("A visual playground for engineering dynamics"), NULL);
}

static void apply_style(const char *style)
{
    AdwColorScheme scheme = g_strcmp0(style, "light") == 0  ? ADW_COLOR_SCHEME_FORCE_LIGHT
                            : g_strcmp0(style, "dark") == 0 ? ADW_COLOR_SCHEME_FORCE_DARK
                                                            : ADW_COLOR_SCHEME_DEFAULT;
    adw_style_manager_set_color_scheme(adw_style_manager_get_default(), scheme);
}

static void on_style(GSimpleAction *action, GVariant *style, gpointer application)
{
    g_simple_action_set_state(action, style);
    apply_style(g_variant_get_string(style, NULL));
    tinker_settings_set_text("window", "style", g_variant_get_string(style, NULL));
    tinker_settings_store();
}

static const GActionEntry actions[] = {
    {.name = "new-window", .activate = on_new_window},
    {.name = "new-scene", .activate = on_new_scene},
    {.name = "quit", .activate = on_quit},
    {.name = "about", .activate = on_about},
};

static void add_style_action(GApplication *application)
{
    g_autofree char *style = tinker_settings_text("window", "style", "system");
    g_autoptr(GSimpleAction) action =
        g_simple_action_new_stateful("style", G_VARIANT_TYPE_STRING, g_variant_new_string(style));
    g_signal_connect(action, "change-state", G_CALLBACK(on_style), application);
    g_action_map_add_action(G_ACTION_MAP(application), G_ACTION(action));
    apply_style(style);
}

/* The command line ------------------------------------------------------------------------------------------------- */

static int tinker_application_handle_local_options(GApplication *base, GVariantDict *options)
{
    TinkerApplication *application = TINKER_APPLICATION(base);
    g_autoptr(GError) error = NULL;
    application->line_is_read = TRUE;
    if (!tinker_command_line_read(&application->line, options, &error)) return tinker_report_error(NULL, error);
    if (application->line.version) {
        printf("tinker-gui %s\n", TINKER_VERSION);
        return TINKER_EXIT_DONE;
    }
    if (application->line.screenshot != NULL) tinker_screenshot_prepare(application->line.screenshot);
    if (application->line.screenshot != NULL || application->line.plugin_folders != NULL)
        g_application_set_flags(base, g_application_get_flags(base) | G_APPLICATION_NON_UNIQUE);
    if (!application->line.new_scene) return -1;
    if (!g_application_register(base, NULL, &error)) {
        tinker_report_note("%s", error->message);
        return TINKER_EXIT_RUN_FAILED;
    }
    if (!g_application_get_is_remote(base)) return -1;
    g_action_group_activate_action(G_ACTION_GROUP(base), "new-scene", NULL);
    return TINKER_EXIT_DONE;
}

/* GLib ends with 1 where it finds an option that there is not. */
static gboolean tinker_application_local_command_line(GApplication *base, char ***arguments, int *status)
{
    gboolean handled =
        G_APPLICATION_CLASS(tinker_application_parent_class)->local_command_line(base, arguments, status);
    if (handled && *status == 1 && !TINKER_APPLICATION(base)->line_is_read) *status = TINKER_EXIT_USAGE;
    return handled;
}

/* Life ------------------------------------------------------------------------------------------------------------- */

/* An icon of each size is drawn for it, which the first frame does not wait for. */
static void set_icon(gpointer nothing)
{
    gtk_window_set_default_icon_name(TINKER_APPLICATION_ID);
}

static void tinker_application_startup(GApplication *base)
{
    G_APPLICATION_CLASS(tinker_application_parent_class)->startup(base);
    g_action_map_add_action_entries(G_ACTION_MAP(base), actions, G_N_ELEMENTS(actions), base);
    add_style_action(base);
    g_idle_add_once(set_icon, NULL);
    tinker_window_set_accels(GTK_APPLICATION(base));
    tinker_recovery_note_crashes();
}

static void on_picture_taken(int status, gpointer data)
{
    TinkerApplication *application = data;
    application->status = status;
    g_application_release(G_APPLICATION(application));
    g_application_quit(G_APPLICATION(application));
}

static void take_picture(TinkerApplication *application)
{
    g_application_hold(G_APPLICATION(application));
    tinker_screenshot_take(ADW_APPLICATION(application), catalogue_of(application), application->line.screenshot,
                           on_picture_taken, application);
}

static void tinker_application_activate(GApplication *base)
{
    TinkerApplication *application = TINKER_APPLICATION(base);
    GtkWindow *window = gtk_application_get_active_window(GTK_APPLICATION(base));
    if (application->line.screenshot != NULL)
        take_picture(application);
    else if (window != NULL)
        gtk_window_present(window);
    else if (application->line.new_scene)
        on_new_scene(NULL, NULL, application);
    else
        new_window(application);
}

/* Each file gets a window of its own; the first takes one that nothing has been done in. */
static void tinker_application_open(GApplication *base, GFile **files, int count, const char *hint)
{
    TinkerApplication *application = TINKER_APPLICATION(base);
    if (application->line.screenshot != NULL) {
        tinker_report_note(_("the scene of --screenshot is named by --scene FILE"));
        application->status = TINKER_EXIT_USAGE;
        return;
    }
    for (int i = 0; i < count; i++) {
        GtkWindow *active = gtk_application_get_active_window(GTK_APPLICATION(base));
        TinkerWindow *window =
            active != NULL && TINKER_IS_WINDOW(active) && tinker_window_is_untouched(TINKER_WINDOW(active))
                ? TINKER_WINDOW(active)
                : new_window(application);
        tinker_window_open_file(window, files[i]);
    }
}

/* A thread is still at work though it was told to stop: a plugin never comes back. Everything is saved or given up by
 * now, and nothing that the thread may use can be freed. */
G_NORETURN static void end_without_threads(void)
{
    tinker_report_note(_("ended while a plugin was still at work (it may hang)"));
    fflush(NULL);
    _exit(EXIT_FAILURE);
}

static void tinker_application_finalize(GObject *object)
{
    if (!tinker_background_wait(LONGEST_WAIT)) end_without_threads();
    g_clear_pointer(&TINKER_APPLICATION(object)->catalogue, tinker_catalogue_free);
    tinker_command_line_clear(&TINKER_APPLICATION(object)->line);
    G_OBJECT_CLASS(tinker_application_parent_class)->finalize(object);
}

static void tinker_application_class_init(TinkerApplicationClass *class)
{
    G_APPLICATION_CLASS(class)->startup = tinker_application_startup;
    G_APPLICATION_CLASS(class)->activate = tinker_application_activate;
    G_APPLICATION_CLASS(class)->open = tinker_application_open;
    G_APPLICATION_CLASS(class)->handle_local_options = tinker_application_handle_local_options;
    G_APPLICATION_CLASS(class)->local_command_line = tinker_application_local_command_line;
    G_OBJECT_CLASS(class)->finalize = tinker_application_finalize;
}

static void tinker_application_init(TinkerApplication *application)
{
    tinker_command_line_add(G_APPLICATION(application));
}

TinkerApplication *tinker_application_new(void)
{
    tinker_report_as("tinker-gui");
    return g_object_new(TINKER_TYPE_APPLICATION, "application-id", TINKER_APPLICATION_ID, "flags",
                        G_APPLICATION_HANDLES_OPEN, "resource-base-path", "/org/tinker/Tinker", NULL);
}

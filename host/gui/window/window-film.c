/* Films: the dialog, the name of the file, and the bar that shows how far it is. */
#include <glib/gi18n.h>
#include <string.h>

#include "common/film/film-pictures.h"
#include "common/film/film.h"
#include "gui/film/film-dialog.h"
#include "gui/text/message.h"
#include "gui/window/window-files.h"

/* A film that waits for its name. */
typedef struct {
    TinkerWindow *window; /* owned */
    TinkerFilmSettings settings;
    char *path; /* once it is known; owned */
} Wish;

static Wish *wish_new(TinkerWindow *window, const TinkerFilmSettings *settings, const char *path)
{
    Wish *wish = g_new(Wish, 1);
    *wish = (Wish){g_object_ref(window), *settings, g_strdup(path)};
    return wish;
}

static void wish_free(gpointer data)
{
    Wish *wish = data;
    g_object_unref(wish->window);
    g_free(wish->path);
    g_free(wish);
}

/* The name of the first file that a film of this path is written to. (transfer full) */
static char *first_file(const char *path)
{
    return tinker_film_is_joined(path) ? g_strdup(path) : tinker_film_pictures_name(path, 1);
}

/* The bar ---------------------------------------------------------------------------------------------------------- */

static void show_progress(TinkerWindow *window)
{
    gtk_progress_bar_set_fraction(window->film_progress, tinker_film_task_progress(window->film));
}

static void tell_end(TinkerWindow *window)
{
    const char *path = tinker_film_task_path(window->film), *failure = tinker_film_task_failure(window->film);
    g_autofree char *first = first_file(path), *name = g_path_get_basename(first);
    const char *stopped_by = tinker_film_task_stopped_by(window->film);
    g_autofree char *saved = stopped_by != NULL ? g_strdup_printf(_("Saved as %s; it ends where %s"), name, stopped_by)
                                                : g_strdup_printf(_("Saved as %s"), name);
    switch (tinker_film_task_state(window->film)) {
    case TINKER_FILM_WRITTEN:
        window_toast(window, saved);
        break;
    case TINKER_FILM_CUT_SHORT:
        window_message(window, _("The Film Ends Early"), failure);
        break;
    case TINKER_FILM_CANCELLED:
        window_toast(window, _("The film was cancelled"));
        break;
    case TINKER_FILM_FAILED:
        window_message(window, _("The Film Was Not Exported"), failure);
        break;
    default:
        break;
    }
}

static void on_cancel(TinkerWindow *window)
{
    gtk_widget_set_sensitive(window->film_cancel, FALSE);
    tinker_film_task_cancel(window->film);
}

static void add_bar(TinkerWindow *window)
{
    GtkWidget *progress = gtk_progress_bar_new();
    g_autofree char *name = g_path_get_basename(tinker_film_task_path(window->film));
    g_autofree char *text = g_strdup_printf(_("Exporting %s"), name);
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_MIDDLE);
    gtk_progress_bar_set_show_text(GTK_PROGRESS_BAR(progress), TRUE);
    gtk_widget_set_hexpand(progress, TRUE);
    gtk_widget_set_valign(progress, GTK_ALIGN_CENTER);
    gtk_accessible_update_property(GTK_ACCESSIBLE(progress), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Progress of the film"),
                                   -1);
    window->film_progress = GTK_PROGRESS_BAR(progress);
    window->film_cancel = gtk_button_new_with_mnemonic(_("_Cancel"));
    g_signal_connect_swapped(window->film_cancel, "clicked", G_CALLBACK(on_cancel), window);
    window->film_bar = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 12);
    gtk_widget_add_css_class(window->film_bar, "film-bar");
    gtk_box_append(GTK_BOX(window->film_bar), label);
    gtk_box_append(GTK_BOX(window->film_bar), progress);
    gtk_box_append(GTK_BOX(window->film_bar), window->film_cancel);
    gtk_box_append(window->banners, window->film_bar);
}

/* There only while there is something to show: what is merely hidden, assistive programs would still find. */
static void remove_bar(TinkerWindow *window)
{
    gboolean had_focus = gtk_widget_is_focus(window->film_cancel);
    gtk_box_remove(window->banners, window->film_bar);
    window->film_bar = window->film_cancel = NULL;
    window->film_progress = NULL;
    if (had_focus) gtk_widget_grab_focus(GTK_WIDGET(window->canvas));
}

static void on_film_changed(TinkerWindow *window)
{
    gboolean running = tinker_film_task_state(window->film) == TINKER_FILM_UNDER_WAY;
    if (window->film_bar != NULL) remove_bar(window);
    if (running) add_bar(window);
    if (!running) tell_end(window);
}

void window_add_film(TinkerWindow *window)
{
    window->film = tinker_film_task_new();
    g_signal_connect_object(window->film, "changed", G_CALLBACK(on_film_changed), window, G_CONNECT_SWAPPED);
    g_signal_connect_object(window->film, "progress", G_CALLBACK(show_progress), window, G_CONNECT_SWAPPED);
}

/* The file --------------------------------------------------------------------------------------------------------- */

static void start(const Wish *wish)
{
    TinkerWindow *window = wish->window;
    TinkerScene *scene = tinker_document_scene(window->document);
    TinkerFilmSettings settings = wish->settings;
    g_autoptr(TinkerFileSet) files = tinker_document_files(window->document);
    g_autoptr(GError) error = NULL;
    settings.path = wish->path;
    const double pictures = tinker_film_settings_pictures(&settings, tinker_scene_head(scene)->run.duration);
    if (!tinker_film_add_outputs(files, NULL, settings.path, pictures, &error)) {
        window_message(window, _("The Film Was Not Exported"), error->message);
        return;
    }
    gboolean *kinds = settings.over.vectors.kinds;
    g_object_get(window->canvas, "show-labels", &settings.show_labels, "show-grid", &settings.show_grid, "show-forces",
                 &settings.over.forces, "show-velocities", &kinds[TINKER_VECTOR_VELOCITY], "show-accelerations",
                 &kinds[TINKER_VECTOR_ACCELERATION], "show-net-forces", &kinds[TINKER_VECTOR_NET_FORCE], "show-trails",
                 &settings.show_trails, NULL);
    tinker_film_task_start(window->film, scene, &settings);
    gtk_widget_grab_focus(window->film_cancel);
}

static void on_overwrite(AdwMessageDialog *dialog, const char *answer, const Wish *wish)
{
    if (g_strcmp0(answer, "overwrite") == 0) start(wish);
}

static void ask_to_overwrite(Wish *wish, const char *path)
{
    g_autofree char *name = g_path_get_basename(path);
    GtkWidget *dialog = adw_message_dialog_new(GTK_WINDOW(wish->window), _("Overwrite File?"), NULL);
    adw_message_dialog_format_body(ADW_MESSAGE_DIALOG(dialog),
                                   _("There is a file “%s” already. What it holds is lost if you overwrite it."), name);
    adw_message_dialog_add_responses(ADW_MESSAGE_DIALOG(dialog), "cancel", _("_Cancel"), "overwrite", _("_Overwrite"),
                                     NULL);
    adw_message_dialog_set_response_appearance(ADW_MESSAGE_DIALOG(dialog), "overwrite", ADW_RESPONSE_DESTRUCTIVE);
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "cancel");
    adw_message_dialog_set_close_response(ADW_MESSAGE_DIALOG(dialog), "cancel");
    tinker_connect_answer(dialog, G_CALLBACK(on_overwrite), wish, wish_free);
    gtk_window_present(GTK_WINDOW(dialog));
}

/* The chosen name, with the ending of the chosen kind where it has none of a film. (transfer full) */
static char *with_ending(const char *chosen, const char *filter, const char *ending)
{
    for (const TinkerFilmFormat *format = tinker_film_formats(); format->name != NULL; format++) {
        if (tinker_path_has_ending(chosen, format->ending)) return g_strdup(chosen);
        if (g_strcmp0(filter, _(format->name)) == 0) ending = format->ending;
    }
    return g_strconcat(chosen, ending, NULL);
}

/* The file that the film would take the place of, where the file dialog has not asked about it. (transfer full) */
static char *file_in_the_way(const char *path, const char *chosen)
{
    g_autofree char *first = first_file(path);
    gboolean asked = g_strcmp0(first, chosen) == 0;
    return !asked && g_file_test(first, G_FILE_TEST_EXISTS) ? g_steal_pointer(&first) : NULL;
}

static void on_name(GtkNativeDialog *dialog, int response, Wish *wish)
{
    GtkFileFilter *filter = gtk_file_chooser_get_filter(GTK_FILE_CHOOSER(dialog));
    g_autoptr(GFile) file =
        response == GTK_RESPONSE_ACCEPT ? gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog)) : NULL;
    g_autofree char *chosen = file != NULL ? g_file_get_path(file) : NULL;
    if (chosen != NULL) {
        wish->path = with_ending(chosen, filter != NULL ? gtk_file_filter_get_name(filter) : NULL, wish->settings.path);
        g_autofree char *in_the_way = file_in_the_way(wish->path, chosen);
        if (in_the_way != NULL)
            ask_to_overwrite(wish_new(wish->window, &wish->settings, wish->path), in_the_way);
        else
            start(wish);
    } else if (file != NULL) {
        window_message(wish->window, _("The Film Was Not Exported"), _("Choose a local folder."));
    }
    g_object_unref(dialog);
}

static void add_filters(GtkFileChooser *chooser, const char *chosen)
{
    for (const TinkerFilmFormat *format = tinker_film_formats(); format->name != NULL; format++) {
        g_autoptr(GtkFileFilter) filter = gtk_file_filter_new();
        g_autofree char *pattern = g_strconcat("*", format->ending, NULL);
        gtk_file_filter_set_name(filter, _(format->name));
        gtk_file_filter_add_pattern(filter, pattern);
        gtk_file_chooser_add_filter(chooser, filter);
        if (strcmp(format->ending, chosen) == 0) gtk_file_chooser_set_filter(chooser, filter);
    }
}

/* The scene's name, without what scenes end in. */
static void on_chosen(TinkerFilmDialog *from, const TinkerFilmSettings *settings, TinkerWindow *window)
{
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(_("Save Film"), GTK_WINDOW(window),
                                                               GTK_FILE_CHOOSER_ACTION_SAVE, _("_Save"), _("_Cancel"));
    g_autofree char *title = tinker_document_name(window->document);
    if (g_str_has_suffix(title, WINDOW_SCENE_ENDING)) title[strlen(title) - strlen(WINDOW_SCENE_ENDING)] = '\0';
    g_autofree char *name = g_strconcat(g_strdelimit(title, "/", '-'), settings->path, NULL);
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    add_filters(GTK_FILE_CHOOSER(dialog), settings->path);
    gtk_file_chooser_set_current_name(GTK_FILE_CHOOSER(dialog), name);
    tinker_connect_answer(dialog, G_CALLBACK(on_name), wish_new(window, settings, NULL), wish_free);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

void window_export_film(TinkerWindow *window)
{
    double duration = tinker_scene_head(tinker_document_scene(window->document))->run.duration;
    GtkWidget *dialog = tinker_film_dialog_new(GTK_WINDOW(window), duration);
    g_signal_connect_object(dialog, "chosen", G_CALLBACK(on_chosen), window, 0);
    gtk_window_present(GTK_WINDOW(dialog));
}

gboolean window_can_export_film(TinkerWindow *window)
{
    return window->film == NULL || tinker_film_task_state(window->film) != TINKER_FILM_UNDER_WAY;
}

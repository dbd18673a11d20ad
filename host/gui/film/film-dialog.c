/* Rows of choices that are tables here, and a line that says what they come to. */
#include "gui/film/film-dialog.h"

#include <glib/gi18n.h>

#include "common/film/film.h"
#include "common/film/motion-film.h"

struct _TinkerFilmDialog {
    AdwWindow parent_instance;
    double duration; /* s */

    /* Parts of film-dialog.ui. */
    AdwComboRow *format, *size, *rate, *speed;
    GtkSwitch *graphs;
    GtkLabel *sum;
    GtkWidget *missing, *choose;
};

G_DEFINE_FINAL_TYPE(TinkerFilmDialog, tinker_film_dialog, ADW_TYPE_WINDOW)

static guint chosen_signal;

/* The last one needs no other program. */
static const TinkerFilmFormat formats[] = {{N_("GIF animation"), ".gif"},
                                           {N_("WebM film"), ".webm"},
                                           {N_("MP4 film"), ".mp4"},
                                           {N_("Numbered PNGs"), ".png"},
                                           {NULL, NULL}};
static const int sizes[][2] = {{320, 240}, {640, 480}, {960, 720}, {1280, 720}, {1920, 1080}};
static const double rates[] = {10, 20, 25, 30, 50, 60};
static const double speeds[] = {0.1, 0.25, 0.5, 1, 2, 4, 10};
enum { FIRST_SIZE = 1, FIRST_RATE = 2, FIRST_SPEED = 3 };

const TinkerFilmFormat *tinker_film_formats(void)
{
    return tinker_film_can_join() ? formats : &formats[G_N_ELEMENTS(formats) - 2];
}

static TinkerFilmSettings settings_of(TinkerFilmDialog *dialog)
{
    const int *size = sizes[adw_combo_row_get_selected(dialog->size)];
    return (TinkerFilmSettings){
        .path = tinker_film_formats()[adw_combo_row_get_selected(dialog->format)].ending,
        .width = size[0],
        .height = size[1],
        .frames_per_second = rates[adw_combo_row_get_selected(dialog->rate)],
        .speed = speeds[adw_combo_row_get_selected(dialog->speed)],
        .show_graphs = gtk_switch_get_active(dialog->graphs),
    };
}

static void on_changed(TinkerFilmDialog *dialog)
{
    if (dialog->duration <= 0) return; /* the rows are still being filled */
    TinkerFilmSettings settings = settings_of(dialog);
    double pictures = tinker_film_settings_pictures(&settings, dialog->duration);
    gboolean fits = pictures <= TINKER_MOTION_FILM_MOST_PICTURES;
    g_autofree char *sum =
        fits ? g_strdup_printf(_("The whole run of %g s: a film of %.4g s in %.0f pictures"), dialog->duration,
                               dialog->duration / settings.speed, pictures)
             : g_strdup_printf(
                   _("The film would have %.0f pictures: choose fewer a second, a higher speed, or a shorter "
                     "duration of the scene"),
                   pictures);
    gtk_label_set_text(dialog->sum, sum);
    gtk_widget_set_sensitive(dialog->choose, fits);
}

static void on_choose(TinkerFilmDialog *dialog)
{
    TinkerFilmSettings settings = settings_of(dialog);
    g_object_ref(dialog);
    gtk_window_close(GTK_WINDOW(dialog));
    g_signal_emit(dialog, chosen_signal, 0, &settings);
    g_object_unref(dialog);
}

static void fill(AdwComboRow *row, GtkStringList *words, guint selected)
{
    adw_combo_row_set_model(row, G_LIST_MODEL(words));
    adw_combo_row_set_selected(row, selected);
    g_object_unref(words);
}

static char *speed_words(double speed)
{
    if (speed == 1) return g_strdup(_("Real time"));
    return speed < 1 ? g_strdup_printf(_("%g times slower"), 1 / speed) : g_strdup_printf(_("%g times faster"), speed);
}

static void fill_rows(TinkerFilmDialog *dialog)
{
    GtkStringList *format = gtk_string_list_new(NULL), *size = gtk_string_list_new(NULL),
                  *rate = gtk_string_list_new(NULL), *speed = gtk_string_list_new(NULL);
    for (const TinkerFilmFormat *one = tinker_film_formats(); one->name != NULL; one++)
        gtk_string_list_append(format, _(one->name));
    for (gsize i = 0; i < G_N_ELEMENTS(sizes); i++)
        gtk_string_list_take(size, g_strdup_printf("%d × %d", sizes[i][0], sizes[i][1]));
    for (gsize i = 0; i < G_N_ELEMENTS(rates); i++)
        gtk_string_list_take(rate, g_strdup_printf("%g", rates[i]));
    for (gsize i = 0; i < G_N_ELEMENTS(speeds); i++)
        gtk_string_list_take(speed, speed_words(speeds[i]));
    fill(dialog->format, format, 0);
    fill(dialog->size, size, FIRST_SIZE);
    fill(dialog->rate, rate, FIRST_RATE);
    fill(dialog->speed, speed, FIRST_SPEED);
}

static void tinker_film_dialog_dispose(GObject *object)
{
    gtk_widget_dispose_template(GTK_WIDGET(object), TINKER_TYPE_FILM_DIALOG);
    G_OBJECT_CLASS(tinker_film_dialog_parent_class)->dispose(object);
}

static void tinker_film_dialog_class_init(TinkerFilmDialogClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_film_dialog_dispose;
    chosen_signal = g_signal_new("chosen", TINKER_TYPE_FILM_DIALOG, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                                 1, G_TYPE_POINTER);
    gtk_widget_class_set_template_from_resource(widget_class, "/org/tinker/Tinker/film-dialog.ui");
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, format);
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, size);
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, rate);
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, speed);
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, graphs);
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, sum);
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, missing);
    gtk_widget_class_bind_template_child(widget_class, TinkerFilmDialog, choose);
    gtk_widget_class_bind_template_callback(widget_class, on_changed);
    gtk_widget_class_bind_template_callback(widget_class, on_choose);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_Escape, 0, "window.close", NULL);
}

static void tinker_film_dialog_init(TinkerFilmDialog *dialog)
{
    gtk_widget_init_template(GTK_WIDGET(dialog));
    fill_rows(dialog);
    gtk_widget_set_visible(dialog->missing, !tinker_film_can_join());
    gtk_widget_grab_focus(dialog->choose);
}

GtkWidget *tinker_film_dialog_new(GtkWindow *parent, double duration)
{
    TinkerFilmDialog *dialog = g_object_new(TINKER_TYPE_FILM_DIALOG, "transient-for", parent, NULL);
    dialog->duration = duration;
    on_changed(dialog);
    return GTK_WIDGET(dialog);
}

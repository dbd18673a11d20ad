/* The time line is a scale as long as the run will be; what is recorded is shown as its filled part. */
#include "playbar.h"

#include <glib/gi18n.h>
#include <math.h>

#include "unparent.h"

#define SLOW_PACE  0.95 /* below it, the run is said to be slower than its playback */
#define LEAST_LINE 60   /* px: width of the time line in a narrow window */
#define USUAL_LINE 160  /* px */

struct _TinkerPlaybar {
    GtkWidget parent_instance;
    TinkerPlayer *player;
    GtkWidget *play, *line, *time, *pace, *speed;
    gboolean updating;
};

G_DEFINE_FINAL_TYPE(TinkerPlaybar, tinker_playbar, GTK_TYPE_WIDGET)

static const double speeds[] = {0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 100};

static void show_pace(TinkerPlaybar *playbar)
{
    double pace = tinker_player_pace(playbar->player);
    gtk_widget_set_visible(playbar->pace, pace < SLOW_PACE);
    if (pace >= SLOW_PACE) return;
    g_autofree char *text = g_strdup_printf(_("slower than asked: %.2g×"), pace * tinker_player_speed(playbar->player));
    gtk_label_set_text(GTK_LABEL(playbar->pace), text);
}

/* Another bar may have set it. */
static void show_speed(TinkerPlaybar *playbar)
{
    for (guint i = 0; i < G_N_ELEMENTS(speeds); i++)
        if (speeds[i] == tinker_player_speed(playbar->player))
            gtk_drop_down_set_selected(GTK_DROP_DOWN(playbar->speed), i);
}

static void on_moved(TinkerPlaybar *playbar)
{
    double time = tinker_player_time(playbar->player), duration = tinker_player_duration(playbar->player);
    playbar->updating = TRUE;
    gtk_range_set_range(GTK_RANGE(playbar->line), 0, fmax(duration, 1e-9));
    gtk_range_set_fill_level(GTK_RANGE(playbar->line), tinker_player_reached(playbar->player));
    gtk_range_set_value(GTK_RANGE(playbar->line), time);
    playbar->updating = FALSE;
    g_autofree char *text = g_strdup_printf("t = %.2f s", time);
    gtk_label_set_text(GTK_LABEL(playbar->time), text);
    show_pace(playbar);
}

static void on_state_changed(TinkerPlaybar *playbar)
{
    gboolean playing = tinker_player_state(playbar->player) == TINKER_PLAYER_PLAYING;
    const char *label = playing ? _("Pause") : _("Play");
    gtk_button_set_icon_name(GTK_BUTTON(playbar->play),
                             playing ? "media-playback-pause-symbolic" : "media-playback-start-symbolic");
    gtk_widget_set_tooltip_text(playbar->play, label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(playbar->play), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    show_speed(playbar);
    show_pace(playbar);
}

static void on_line_moved(TinkerPlaybar *playbar)
{
    if (playbar->updating) return;
    tinker_player_pause(playbar->player);
    tinker_player_seek(playbar->player, gtk_range_get_value(GTK_RANGE(playbar->line)));
    on_moved(playbar);
}

static void on_speed_chosen(TinkerPlaybar *playbar)
{
    guint chosen = gtk_drop_down_get_selected(GTK_DROP_DOWN(playbar->speed));
    if (playbar->player != NULL && chosen < G_N_ELEMENTS(speeds) &&
        speeds[chosen] != tinker_player_speed(playbar->player))
        tinker_player_set_speed(playbar->player, speeds[chosen]);
}

void tinker_playbar_set_player(TinkerPlaybar *playbar, TinkerPlayer *player)
{
    playbar->player = g_object_ref(player);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), playbar, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_state_changed), playbar, G_CONNECT_SWAPPED);
    on_state_changed(playbar);
    on_moved(playbar);
}

/* The widget ---------------------------------------------------------------------------------------------------------- */

static GtkWidget *add_button(GtkWidget *box, const char *icon, const char *label, const char *action)
{
    GtkWidget *button = gtk_button_new_from_icon_name(icon);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_add_css_class(button, "circular");
    gtk_widget_set_tooltip_text(button, label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), action);
    gtk_box_append(GTK_BOX(box), button);
    return button;
}

static GtkWidget *speed_chooser(void)
{
    g_autoptr(GtkStringList) list = gtk_string_list_new(NULL);
    guint normal = 0;
    for (guint i = 0; i < G_N_ELEMENTS(speeds); i++) {
        g_autofree char *text = g_strdup_printf("%g×", speeds[i]);
        gtk_string_list_append(list, text);
        if (speeds[i] == 1) normal = i;
    }
    GtkWidget *chooser = gtk_drop_down_new(G_LIST_MODEL(g_steal_pointer(&list)), NULL);
    gtk_drop_down_set_selected(GTK_DROP_DOWN(chooser), normal);
    gtk_widget_set_tooltip_text(chooser, _("Speed of playback"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(chooser), GTK_ACCESSIBLE_PROPERTY_LABEL, C_("play-back", "Speed"),
                                   -1);
    return chooser;
}

static GtkWidget *time_line(void)
{
    GtkWidget *line = gtk_scale_new_with_range(GTK_ORIENTATION_HORIZONTAL, 0, 1, 0.01);
    gtk_scale_set_draw_value(GTK_SCALE(line), FALSE);
    gtk_range_set_show_fill_level(GTK_RANGE(line), TRUE);
    gtk_range_set_restrict_to_fill_level(GTK_RANGE(line), TRUE);
    gtk_widget_set_size_request(line, LEAST_LINE, -1);
    gtk_widget_set_hexpand(line, TRUE);
    gtk_widget_set_tooltip_text(line, _("Time line: drag to look at any recorded instant"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(line), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Time line"), -1);
    return line;
}

/* The time line is as long as one likes where there is room, and gives way in a narrow window. */
static void tinker_playbar_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
                                   int *natural, int *minimum_baseline, int *natural_baseline)
{
    GtkWidget *box = gtk_widget_get_first_child(widget);
    gtk_widget_measure(box, orientation, for_size, minimum, natural, minimum_baseline, natural_baseline);
    if (orientation == GTK_ORIENTATION_HORIZONTAL) *natural += USUAL_LINE - LEAST_LINE;
}

static void tinker_playbar_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    gtk_widget_allocate(gtk_widget_get_first_child(widget), width, height, baseline, NULL);
}

static void tinker_playbar_dispose(GObject *object)
{
    TinkerPlaybar *playbar = TINKER_PLAYBAR(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&playbar->player);
    G_OBJECT_CLASS(tinker_playbar_parent_class)->dispose(object);
}

static void tinker_playbar_class_init(TinkerPlaybarClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_playbar_dispose;
    GTK_WIDGET_CLASS(class)->measure = tinker_playbar_measure;
    GTK_WIDGET_CLASS(class)->size_allocate = tinker_playbar_size_allocate;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "playbar");
}

static void tinker_playbar_init(TinkerPlaybar *playbar)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    add_button(box, "media-skip-backward-symbolic", _("Reset to the Start"), "win.reset");
    add_button(box, "media-seek-backward-symbolic", _("One Sample Back"), "win.step-back");
    playbar->play = add_button(box, "media-playback-start-symbolic", _("Play"), "win.play");
    add_button(box, "media-seek-forward-symbolic", _("One Sample Forward"), "win.step");
    playbar->line = time_line();
    playbar->time = gtk_label_new("t = 0.00 s");
    playbar->pace = gtk_label_new(NULL);
    gtk_label_set_ellipsize(GTK_LABEL(playbar->pace), PANGO_ELLIPSIZE_END);
    playbar->speed = speed_chooser();
    gtk_widget_add_css_class(playbar->time, "numeric");
    gtk_widget_add_css_class(playbar->pace, "warning");
    gtk_label_set_width_chars(GTK_LABEL(playbar->time), 12);
    GtkWidget *parts[] = {playbar->line, playbar->time, playbar->pace, playbar->speed};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        gtk_box_append(GTK_BOX(box), parts[i]);
    gtk_widget_set_visible(playbar->pace, FALSE);
    gtk_widget_add_css_class(box, "osd");
    gtk_widget_add_css_class(box, "toolbar");
    gtk_widget_set_parent(box, GTK_WIDGET(playbar));
    g_signal_connect_swapped(playbar->line, "value-changed", G_CALLBACK(on_line_moved), playbar);
    g_signal_connect_swapped(playbar->speed, "notify::selected", G_CALLBACK(on_speed_chosen), playbar);
}

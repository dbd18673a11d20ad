/* The time line is a scale as long as the run will be; what is recorded is shown as its filled part. The time beside it
 * is an entry: what is typed there is gone to, and recorded first where it is not yet. */
#include "gui/window/playbar.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/property/property-rows.h"
#include "gui/widget/entry-select.h"
#include "gui/widget/tooltip.h"
#include "gui/widget/unparent.h"

#define SLOW_PACE  0.95 /* below it, the run is said to be slower than its playback */
#define LEAST_LINE 120  /* px: width of the time line in a narrow window */
#define TIME_CHARS 8

struct _TinkerPlaybar {
    GtkWidget parent_instance;
    TinkerPlayer *player;
    GtkWidget *play, *line, *marks, *time, *pace, *speed;
    gboolean updating;
    gboolean typed; /* something was typed into the entry, and not gone to yet */
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

/* Unless another time is being typed. */
static void show_time(TinkerPlaybar *playbar)
{
    g_autofree char *text = tinker_quantity_format(
        tinker_player_time(playbar->player), (TinkerDimension)TINKER_DIMENSION_TIME, "s", TINKER_UNIT_SYSTEM_SI, 2);
    if (playbar->typed || g_str_equal(gtk_editable_get_text(GTK_EDITABLE(playbar->time)), text)) return;
    playbar->updating = TRUE;
    gtk_editable_set_text(GTK_EDITABLE(playbar->time), text);
    playbar->updating = FALSE;
}

static void on_moved(TinkerPlaybar *playbar)
{
    double time = tinker_player_time(playbar->player), duration = tinker_player_duration(playbar->player);
    playbar->updating = TRUE;
    gtk_range_set_range(GTK_RANGE(playbar->line), 0, fmax(duration, 1e-9));
    gtk_range_set_fill_level(GTK_RANGE(playbar->line), tinker_player_reached(playbar->player));
    gtk_range_set_value(GTK_RANGE(playbar->line), time);
    playbar->updating = FALSE;
    tinker_event_marks_update(TINKER_EVENT_MARKS(playbar->marks));
    show_time(playbar);
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

/* The time --------------------------------------------------------------------------------------------------------- */

static void set_wrong(TinkerPlaybar *playbar, const char *problem)
{
    GtkAccessible *accessible = GTK_ACCESSIBLE(playbar->time);
    gtk_widget_set_tooltip_text(playbar->time, problem != NULL ? problem : _("Time: type where to go"));
    gtk_accessible_update_property(accessible, GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, problem != NULL ? problem : "", -1);
    if (problem != NULL) {
        gtk_widget_add_css_class(playbar->time, "error");
        gtk_accessible_update_state(accessible, GTK_ACCESSIBLE_STATE_INVALID, GTK_ACCESSIBLE_INVALID_TRUE, -1);
    } else {
        gtk_widget_remove_css_class(playbar->time, "error");
        gtk_accessible_reset_state(accessible, GTK_ACCESSIBLE_STATE_INVALID);
    }
}

static void forget_typed(TinkerPlaybar *playbar)
{
    playbar->typed = FALSE;
    set_wrong(playbar, NULL);
    show_time(playbar);
}

/* Goes where the entry says, with any unit of time, without one in s. */
static void on_time_entered(TinkerPlaybar *playbar)
{
    double time;
    g_autoptr(GError) error = NULL;
    const char *text = gtk_editable_get_text(GTK_EDITABLE(playbar->time));
    if (!playbar->typed) return;
    if (!property_parse_number(text, (TinkerDimension)TINKER_DIMENSION_TIME, "s", &time, &error)) {
        set_wrong(playbar, error->message);
        return;
    }
    forget_typed(playbar);
    gtk_widget_activate_action(GTK_WIDGET(playbar), "win.go-to", "d", time);
    gtk_editable_select_region(GTK_EDITABLE(playbar->time), 0, -1);
}

static void on_time_typed(TinkerPlaybar *playbar)
{
    if (!playbar->updating) playbar->typed = TRUE;
}

static gboolean on_time_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                            TinkerPlaybar *playbar)
{
    if (key != GDK_KEY_Escape || !playbar->typed) return GDK_EVENT_PROPAGATE;
    forget_typed(playbar);
    return GDK_EVENT_STOP;
}

static GtkWidget *time_entry(TinkerPlaybar *playbar)
{
    GtkWidget *entry = gtk_entry_new();
    gtk_editable_set_width_chars(GTK_EDITABLE(entry), TIME_CHARS);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(entry), TIME_CHARS);
    gtk_editable_set_enable_undo(GTK_EDITABLE(entry), FALSE); /* it shows another time ever so often */
    gtk_editable_set_alignment(GTK_EDITABLE(entry), 1);
    gtk_widget_set_valign(entry, GTK_ALIGN_CENTER);
    gtk_widget_add_css_class(entry, "numeric");
    gtk_accessible_update_property(GTK_ACCESSIBLE(entry), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Time"), -1);
    tinker_entry_select_by_click(entry);
    tinker_entry_listen(entry, G_CALLBACK(on_time_typed), G_CALLBACK(on_time_entered), G_CALLBACK(forget_typed),
                        G_CALLBACK(on_time_key), playbar);
    return entry;
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
    tinker_event_marks_set_player(TINKER_EVENT_MARKS(playbar->marks), player);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), playbar, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_state_changed), playbar, G_CONNECT_SWAPPED);
    on_state_changed(playbar);
    on_moved(playbar);
}

TinkerEventMarks *tinker_playbar_marks(TinkerPlaybar *playbar)
{
    return TINKER_EVENT_MARKS(playbar->marks);
}

void tinker_playbar_update(TinkerPlaybar *playbar)
{
    on_moved(playbar);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static GtkWidget *add_button(GtkWidget *box, const char *icon, const char *label, const char *action)
{
    GtkWidget *button = gtk_button_new_from_icon_name(icon);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_add_css_class(button, "circular");
    tinker_widget_begin_tooltip(button, label);
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
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "playbar");
}

static void tinker_playbar_init(TinkerPlaybar *playbar)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    add_button(box, "media-skip-backward-symbolic", _("Reset to the Start"), "win.reset");
    add_button(box, "tinker-step-back-symbolic", _("One Sample Back"), "win.step-back");
    playbar->play = add_button(box, "media-playback-start-symbolic", _("Play"), "win.play");
    add_button(box, "tinker-step-forward-symbolic", _("One Sample Forward"), "win.step");
    playbar->line = time_line();
    playbar->marks = tinker_event_marks_new(playbar->line);
    GtkWidget *symbol = gtk_label_new("t =");
    playbar->time = time_entry(playbar);
    playbar->pace = gtk_label_new(NULL);
    gtk_label_set_ellipsize(GTK_LABEL(playbar->pace), PANGO_ELLIPSIZE_END);
    playbar->speed = speed_chooser();
    gtk_widget_add_css_class(playbar->pace, "warning");
    /* Tab goes by heights first, and the middle of an entry is a little above that of buttons: it has a box of its own,
     * as high as all, not to come before them. */
    GtkWidget *end = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    GtkWidget *parts[] = {symbol, playbar->time, playbar->pace, playbar->speed};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        gtk_box_append(GTK_BOX(end), parts[i]);
    gtk_box_append(GTK_BOX(box), playbar->marks);
    gtk_box_append(GTK_BOX(box), end);
    gtk_widget_set_visible(playbar->pace, FALSE);
    set_wrong(playbar, NULL);
    gtk_widget_set_parent(box, GTK_WIDGET(playbar));
    g_signal_connect_swapped(playbar->line, "value-changed", G_CALLBACK(on_line_moved), playbar);
    g_signal_connect_swapped(playbar->speed, "notify::selected", G_CALLBACK(on_speed_chosen), playbar);
}

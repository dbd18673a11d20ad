/* The marks lie over the line, whose child they are beside: a scale's own marks would take room, and catch the handle.
 */
#include "gui/window/event-marks.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "gui/widget/unparent.h"

#define NEAR        4.0 /* widget units: so close to a mark the pointer is on it */
#define WIDTH       2.0
#define STICKS_OUT  5.0 /* above the trough and below it */
#define MOST_TOLD   5   /* in a tooltip */
#define MOST_SPOKEN 20

struct _TinkerEventMarks {
    GtkWidget parent_instance;
    GtkWidget *line, *layer;
    TinkerPlayer *player;
    GPtrArray *events; /* of TinkerRunEvent *; NULL before there is a player */
};

G_DEFINE_FINAL_TYPE(TinkerEventMarks, tinker_event_marks, GTK_TYPE_WIDGET)

static const TinkerRunEvent *event_of(const TinkerEventMarks *marks, guint number)
{
    return g_ptr_array_index(marks->events, number);
}

static guint count_of(const TinkerEventMarks *marks)
{
    return marks->events != NULL ? marks->events->len : 0;
}

/* The line's handle. */
static GtkWidget *find_handle(GtkWidget *within)
{
    if (strcmp(gtk_widget_get_css_name(within), "slider") == 0) return within;
    GtkWidget *found = NULL;
    for (GtkWidget *child = gtk_widget_get_first_child(within); child != NULL && found == NULL;
         child = gtk_widget_get_next_sibling(child))
        found = find_handle(child);
    return found;
}

/* How much of the trough the handle takes: a theme may let it stick out by margins below 0. (What
 * gtk_range_get_slider_range() tells begins with the part of the trough before it.) */
static double handle_room(GtkWidget *line)
{
    GtkWidget *handle = find_handle(line);
    GtkBorder margin;
    if (handle == NULL) return 0;
    gtk_style_context_get_margin(gtk_widget_get_style_context(handle), &margin);
    return gtk_widget_get_width(handle) + margin.left + margin.right;
}

/* Where the middle of the handle is for a time. */
static double place_of(const TinkerEventMarks *marks, double time)
{
    GdkRectangle trough;
    GtkAdjustment *adjustment = gtk_range_get_adjustment(GTK_RANGE(marks->line));
    gtk_range_get_range_rect(GTK_RANGE(marks->line), &trough);
    double share = time / fmax(gtk_adjustment_get_upper(adjustment), 1e-9), handle = handle_room(marks->line);
    if (gtk_widget_get_direction(marks->line) == GTK_TEXT_DIR_RTL) share = 1 - share;
    return trough.x + handle / 2 + share * (trough.width - handle);
}

/* Texts ---------------------------------------------------------------------------------------------------------------
 */

static void add_line(GString *text, const TinkerRunEvent *event)
{
    g_string_append_printf(text, _("%s%.4g s: %s"), text->len > 0 ? "\n" : "", event->time, event->text);
}

/* Of `count` events from this one on. (transfer full) */
static char *text_of(const TinkerEventMarks *marks, guint from, guint count, guint most)
{
    GString *text = g_string_new(NULL);
    for (guint i = from; i < from + MIN(count, most); i++)
        add_line(text, event_of(marks, i));
    if (count > most) g_string_append_printf(text, _("\nand %u more"), count - most);
    return g_string_free(text, FALSE);
}

/* The events whose marks are there: how many; the first is *from. */
static guint find_at(const TinkerEventMarks *marks, double x, guint *from)
{
    guint count = 0;
    for (guint i = 0; i < count_of(marks); i++) {
        if (fabs(place_of(marks, event_of(marks, i)->time) - x) > NEAR) continue;
        if (count++ == 0) *from = i;
    }
    return count;
}

const TinkerRunEvent *tinker_event_marks_at(TinkerEventMarks *marks, double x)
{
    guint from;
    return find_at(marks, x, &from) > 0 ? event_of(marks, from) : NULL;
}

static gboolean on_tooltip(GtkWidget *line, int x, int y, gboolean by_keyboard, GtkTooltip *tooltip,
                           TinkerEventMarks *marks)
{
    guint from = 0, count = by_keyboard ? 0 : find_at(marks, x, &from);
    if (count == 0) return FALSE;
    g_autofree char *text = text_of(marks, from, count, MOST_TOLD);
    gtk_tooltip_set_text(tooltip, text);
    return TRUE;
}

/* Before the line itself, which would go to the pointer's place alone. */
static void on_pressed(GtkGestureClick *gesture, int presses, double x, double y, TinkerEventMarks *marks)
{
    const TinkerRunEvent *event = tinker_event_marks_at(marks, x);
    if (event == NULL) return;
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    gtk_widget_activate_action(GTK_WIDGET(marks), "win.go-to", "d", event->time);
}

static void add_click(TinkerEventMarks *marks)
{
    GtkGesture *click = gtk_gesture_click_new();
    gtk_event_controller_set_propagation_phase(GTK_EVENT_CONTROLLER(click), GTK_PHASE_CAPTURE);
    g_signal_connect(click, "pressed", G_CALLBACK(on_pressed), marks);
    gtk_widget_add_controller(marks->line, GTK_EVENT_CONTROLLER(click));
}

/* Drawing -------------------------------------------------------------------------------------------------------------
 */

static void draw(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    TinkerEventMarks *marks = data;
    GdkRectangle trough;
    GdkRGBA colour;
    double left, top, last = -INFINITY;
    gtk_range_get_range_rect(GTK_RANGE(marks->line), &trough);
    gtk_widget_translate_coordinates(marks->line, marks->layer, 0, trough.y, &left, &top); /* it has a padding */
    gtk_style_context_get_color(gtk_widget_get_style_context(GTK_WIDGET(area)), &colour);
    gdk_cairo_set_source_rgba(cairo, &colour);
    for (guint i = 0; i < count_of(marks); i++) {
        const double x = round(left + place_of(marks, event_of(marks, i)->time) - WIDTH / 2);
        if (x == last) continue;
        last = x;
        cairo_rectangle(cairo, x, top - STICKS_OUT, WIDTH, STICKS_OUT);
        cairo_rectangle(cairo, x, top + trough.height, WIDTH, STICKS_OUT);
    }
    cairo_fill(cairo);
}

/* What happens --------------------------------------------------------------------------------------------------------
 */

void tinker_event_marks_update(TinkerEventMarks *marks)
{
    GPtrArray *events = tinker_player_events(marks->player);
    if (events == marks->events) return;
    g_clear_pointer(&marks->events, g_ptr_array_unref);
    marks->events = g_ptr_array_ref(events);
    g_autofree char *text = text_of(marks, 0, events->len, MOST_SPOKEN);
    gtk_accessible_update_property(GTK_ACCESSIBLE(marks->line), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
    gtk_widget_queue_draw(marks->layer);
}

void tinker_event_marks_set_player(TinkerEventMarks *marks, TinkerPlayer *player)
{
    marks->player = g_object_ref(player);
    tinker_event_marks_update(marks);
}

static void tinker_event_marks_dispose(GObject *object)
{
    TinkerEventMarks *marks = TINKER_EVENT_MARKS(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&marks->player);
    g_clear_pointer(&marks->events, g_ptr_array_unref);
    G_OBJECT_CLASS(tinker_event_marks_parent_class)->dispose(object);
}

static void tinker_event_marks_class_init(TinkerEventMarksClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_event_marks_dispose;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "eventmarks");
}

static void tinker_event_marks_init(TinkerEventMarks *marks) {}

GtkWidget *tinker_event_marks_new(GtkWidget *line)
{
    TinkerEventMarks *marks = g_object_new(TINKER_TYPE_EVENT_MARKS, NULL);
    marks->line = line;
    marks->layer = gtk_drawing_area_new();
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(marks->layer), draw, marks, NULL);
    gtk_widget_set_can_target(marks->layer, FALSE);
    gtk_widget_set_parent(line, GTK_WIDGET(marks));
    gtk_widget_set_parent(marks->layer, GTK_WIDGET(marks));
    gtk_widget_set_hexpand(GTK_WIDGET(marks), TRUE);
    add_click(marks);
    g_signal_connect(line, "query-tooltip", G_CALLBACK(on_tooltip), marks);
    g_signal_connect_object(gtk_range_get_adjustment(GTK_RANGE(line)), "changed", G_CALLBACK(gtk_widget_queue_draw),
                            marks->layer, G_CONNECT_SWAPPED);
    return GTK_WIDGET(marks);
}

/* The marks lie over the line, whose child they are beside: a scale's own marks would take room, and catch the handle.
 */
#include "gui/window/event-marks.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "gui/widget/desktop-theme.h"
#include "gui/widget/unparent.h"

#define NEAR        4.0 /* widget units: so close to a mark the pointer is on it */
#define WIDTH       2.0
#define STICKS_OUT  5.0 /* above the trough and below it */
#define TIP         3.5 /* half of a tip's width */
#define MOST_TOLD   5   /* in a tooltip */
#define MOST_SPOKEN 20

/* What is marked. */
enum { EVENTS, MAXIMA, MINIMA, LISTS };

struct _TinkerEventMarks {
    GtkWidget parent_instance;
    GtkWidget *line, *layer;
    TinkerPlayer *player;
    GPtrArray *lists[LISTS]; /* of TinkerRunEvent *; NULL: none */
    double pressed;          /* s: of the mark that the pointer was pressed on, and is near yet; NAN */
};

G_DEFINE_FINAL_TYPE(TinkerEventMarks, tinker_event_marks, GTK_TYPE_WIDGET)

static const TinkerRunEvent *event_of(const TinkerEventMarks *marks, int list, guint number)
{
    return g_ptr_array_index(marks->lists[list], number);
}

static guint count_of(const TinkerEventMarks *marks, int list)
{
    return marks->lists[list] != NULL ? marks->lists[list]->len : 0;
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

/* Texts ------------------------------------------------------------------------------------------------------------ */

static void add_line(GString *text, const TinkerRunEvent *event)
{
    g_string_append_printf(text, _("%s%.4g s: %s"), text->len > 0 ? "\n" : "", event->time, event->text);
}

static int compare_times(const void *left, const void *right)
{
    const TinkerRunEvent *l = *(TinkerRunEvent *const *)left, *r = *(TinkerRunEvent *const *)right;
    return (l->time > r->time) - (l->time < r->time);
}

/* What is marked, of all lists in order of time; near a place of the line (widget units) alone, unless it is NAN.
 * Borrowed events. (transfer full) */
static GPtrArray *find_marked(const TinkerEventMarks *marks, double x)
{
    GPtrArray *found = g_ptr_array_new();
    for (int list = 0; list < LISTS; list++)
        for (guint i = 0; i < count_of(marks, list); i++) {
            const TinkerRunEvent *event = event_of(marks, list, i);
            if (isnan(x) || fabs(place_of(marks, event->time) - x) <= NEAR) g_ptr_array_add(found, (gpointer)event);
        }
    g_ptr_array_sort(found, compare_times);
    return found;
}

/* (transfer full) */
static char *text_of(const GPtrArray *events, guint most)
{
    GString *text = g_string_new(NULL);
    for (guint i = 0; i < MIN(events->len, most); i++)
        add_line(text, g_ptr_array_index(events, i));
    if (events->len > most) g_string_append_printf(text, _("\nand %u more"), events->len - most);
    return g_string_free(text, FALSE);
}

/* The one whose mark is nearest to this place, or NULL. Borrowed until the next update. */
static const TinkerRunEvent *event_at(TinkerEventMarks *marks, double x)
{
    g_autoptr(GPtrArray) near = find_marked(marks, x);
    const TinkerRunEvent *nearest = NULL;
    double least = INFINITY;
    for (guint i = 0; i < near->len; i++) {
        const TinkerRunEvent *event = g_ptr_array_index(near, i);
        const double away = fabs(place_of(marks, event->time) - x);
        if (!(away < least)) continue;
        least = away;
        nearest = event;
    }
    return nearest;
}

static gboolean on_tooltip(GtkWidget *line, int x, int y, gboolean by_keyboard, GtkTooltip *tooltip,
                           TinkerEventMarks *marks)
{
    if (by_keyboard) return FALSE;
    g_autoptr(GPtrArray) near = find_marked(marks, x);
    if (near->len == 0) return FALSE;
    g_autofree char *text = text_of(near, MOST_TOLD);
    gtk_tooltip_set_text(tooltip, text);
    return TRUE;
}

/* Before the line itself, which would go to the pointer's place alone, and from which it may be dragged on. */
static void on_pressed(GtkGestureClick *gesture, int presses, double x, double y, TinkerEventMarks *marks)
{
    const TinkerRunEvent *event = event_at(marks, x);
    marks->pressed = event != NULL ? event->time : NAN;
    if (event != NULL) gtk_widget_activate_action(GTK_WIDGET(marks), "win.go-to", "d", event->time);
}

/* As long as the pointer is near the mark that it was pressed on, the line stays there. */
static gboolean on_line_dragged(GtkRange *line, GtkScrollType scroll, double value, TinkerEventMarks *marks)
{
    if (isnan(marks->pressed)) return FALSE;
    if (fabs(place_of(marks, value) - place_of(marks, marks->pressed)) <= NEAR) return TRUE;
    marks->pressed = NAN;
    return FALSE;
}

static void add_click(TinkerEventMarks *marks)
{
    GtkGesture *click = gtk_gesture_click_new();
    gtk_event_controller_set_propagation_phase(GTK_EVENT_CONTROLLER(click), GTK_PHASE_CAPTURE);
    g_signal_connect(click, "pressed", G_CALLBACK(on_pressed), marks);
    gtk_widget_add_controller(marks->line, GTK_EVENT_CONTROLLER(click));
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

/* An event sticks out of the line on either side; a maximum has a tip above it, a minimum one below. */
static void add_mark(cairo_t *cairo, int list, double x, double top, double bottom)
{
    if (list == EVENTS) {
        cairo_rectangle(cairo, x, top - STICKS_OUT, WIDTH, STICKS_OUT);
        cairo_rectangle(cairo, x, bottom, WIDTH, STICKS_OUT);
        return;
    }
    const double middle = x + WIDTH / 2, base = list == MAXIMA ? top : bottom;
    const double tip = list == MAXIMA ? base - STICKS_OUT : base + STICKS_OUT;
    cairo_move_to(cairo, middle - TIP, base);
    cairo_line_to(cairo, middle + TIP, base);
    cairo_line_to(cairo, middle, tip);
    cairo_close_path(cairo);
}

static void draw(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    TinkerEventMarks *marks = data;
    GdkRectangle trough;
    GdkRGBA colour;
    double left, top;
    const double *curve = tinker_desktop_theme()->curves[0];
    gtk_range_get_range_rect(GTK_RANGE(marks->line), &trough);
    gtk_widget_translate_coordinates(marks->line, marks->layer, 0, trough.y, &left, &top); /* it has a padding */
    gtk_style_context_get_color(gtk_widget_get_style_context(GTK_WIDGET(area)), &colour);
    for (int list = LISTS; list-- > 0;) {
        double last = -INFINITY;
        if (list == EVENTS)
            gdk_cairo_set_source_rgba(cairo, &colour);
        else
            cairo_set_source_rgb(cairo, curve[0], curve[1], curve[2]);
        for (guint i = 0; i < count_of(marks, list); i++) {
            const double x = round(left + place_of(marks, event_of(marks, list, i)->time) - WIDTH / 2);
            if (x == last) continue;
            last = x;
            add_mark(cairo, list, x, top, top + trough.height);
        }
        cairo_fill(cairo);
    }
}

/* What happens ----------------------------------------------------------------------------------------------------- */

static void tell_marked(TinkerEventMarks *marks)
{
    g_autoptr(GPtrArray) all = find_marked(marks, NAN);
    g_autofree char *text = text_of(all, MOST_SPOKEN);
    gtk_accessible_update_property(GTK_ACCESSIBLE(marks->line), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
    gtk_widget_queue_draw(marks->layer);
}

static void set_list(TinkerEventMarks *marks, int list, GPtrArray *events)
{
    if (events != NULL) g_ptr_array_ref(events);
    g_clear_pointer(&marks->lists[list], g_ptr_array_unref);
    marks->lists[list] = events;
}

void tinker_event_marks_set_extrema(TinkerEventMarks *marks, GPtrArray *maxima, GPtrArray *minima)
{
    set_list(marks, MAXIMA, maxima);
    set_list(marks, MINIMA, minima);
    tell_marked(marks);
}

void tinker_event_marks_update(TinkerEventMarks *marks)
{
    GPtrArray *events = tinker_player_events(marks->player);
    if (events == marks->lists[EVENTS]) return;
    set_list(marks, EVENTS, events);
    tell_marked(marks);
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
    for (int list = 0; list < LISTS; list++)
        g_clear_pointer(&marks->lists[list], g_ptr_array_unref);
    G_OBJECT_CLASS(tinker_event_marks_parent_class)->dispose(object);
}

static void tinker_event_marks_class_init(TinkerEventMarksClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_event_marks_dispose;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "eventmarks");
}

static void tinker_event_marks_init(TinkerEventMarks *marks)
{
    marks->pressed = NAN;
}

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
    g_signal_connect(line, "change-value", G_CALLBACK(on_line_dragged), marks);
    g_signal_connect_object(gtk_range_get_adjustment(GTK_RANGE(line)), "changed", G_CALLBACK(gtk_widget_queue_draw),
                            marks->layer, G_CONNECT_SWAPPED);
    return GTK_WIDGET(marks);
}

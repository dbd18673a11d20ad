/* A drag of `FULL_TURN` pixels is the whole range; with Shift it is finer. */
#include "gui/instrument/knob.h"

#include <math.h>

#define SIZE      56
#define FULL_TURN 160.0 /* widget units */
#define FINER     0.1
#define FROM      (0.75 * G_PI) /* rad, clockwise from +x: where the range begins, */
#define SPAN      (1.5 * G_PI)  /* and how far it goes */

struct _TinkerKnob {
    GtkWidget parent_instance;
    GtkAdjustment *adjustment;
    double start; /* the value as a drag began */
};

G_DEFINE_FINAL_TYPE(TinkerKnob, tinker_knob, GTK_TYPE_WIDGET)

static double share_of(TinkerKnob *knob)
{
    const double low = gtk_adjustment_get_lower(knob->adjustment), high = gtk_adjustment_get_upper(knob->adjustment);
    return high > low ? (gtk_adjustment_get_value(knob->adjustment) - low) / (high - low) : 0;
}

static void paint(GtkWidget *widget, cairo_t *cairo, double width, double height)
{
    const double radius = fmin(width, height) / 2 - 4, end = FROM + SPAN * share_of(TINKER_KNOB(widget));
    GdkRGBA ink, accent;
    GtkStyleContext *style = gtk_widget_get_style_context(widget);
    gtk_style_context_get_color(style, &ink);
    if (!gtk_style_context_lookup_color(style, "accent_color", &accent)) accent = ink;
    cairo_translate(cairo, width / 2, height / 2);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_width(cairo, 5);
    cairo_arc(cairo, 0, 0, radius, FROM, FROM + SPAN);
    cairo_set_source_rgba(cairo, ink.red, ink.green, ink.blue, 0.25);
    cairo_stroke(cairo);
    cairo_arc(cairo, 0, 0, radius, FROM, end);
    gdk_cairo_set_source_rgba(cairo, &accent);
    cairo_stroke(cairo);
    cairo_set_line_width(cairo, 3);
    cairo_move_to(cairo, 0.25 * radius * cos(end), 0.25 * radius * sin(end));
    cairo_line_to(cairo, 0.75 * radius * cos(end), 0.75 * radius * sin(end));
    gdk_cairo_set_source_rgba(cairo, &ink);
    cairo_stroke(cairo);
}

static void tinker_knob_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    const float width = (float)gtk_widget_get_width(widget), height = (float)gtk_widget_get_height(widget);
    cairo_t *cairo = gtk_snapshot_append_cairo(snapshot, &GRAPHENE_RECT_INIT(0, 0, width, height));
    paint(widget, cairo, width, height);
    cairo_destroy(cairo);
}

static void tinker_knob_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *least, int *natural,
                                int *least_baseline, int *natural_baseline)
{
    *least = *natural = SIZE;
}

/* Turning ---------------------------------------------------------------------------------------------------------- */

static void turn_by(TinkerKnob *knob, double from, double share)
{
    const double low = gtk_adjustment_get_lower(knob->adjustment), high = gtk_adjustment_get_upper(knob->adjustment);
    gtk_adjustment_set_value(knob->adjustment, CLAMP(from + share * (high - low), low, high));
}

static void on_drag_begin(GtkGestureDrag *gesture, double x, double y, TinkerKnob *knob)
{
    gtk_widget_grab_focus(GTK_WIDGET(knob));
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    knob->start = gtk_adjustment_get_value(knob->adjustment);
}

static void on_drag(GtkGestureDrag *gesture, double dx, double dy, TinkerKnob *knob)
{
    const GdkModifierType modifiers = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    turn_by(knob, knob->start, (modifiers & GDK_SHIFT_MASK ? FINER : 1) * (dx - dy) / FULL_TURN);
}

static gboolean on_scroll(GtkEventControllerScroll *controller, double dx, double dy, TinkerKnob *knob)
{
    gtk_adjustment_set_value(knob->adjustment, gtk_adjustment_get_value(knob->adjustment) -
                                                   dy * gtk_adjustment_get_step_increment(knob->adjustment));
    return GDK_EVENT_STOP;
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       TinkerKnob *knob)
{
    GtkAdjustment *of = knob->adjustment;
    const double value = gtk_adjustment_get_value(of), step = gtk_adjustment_get_step_increment(of),
                 page = gtk_adjustment_get_page_increment(of);
    const struct {
        guint key;
        double value;
    } keys[] = {{GDK_KEY_Up, value + step},
                {GDK_KEY_Right, value + step},
                {GDK_KEY_Down, value - step},
                {GDK_KEY_Left, value - step},
                {GDK_KEY_Page_Up, value + page},
                {GDK_KEY_Page_Down, value - page},
                {GDK_KEY_Home, gtk_adjustment_get_lower(of)},
                {GDK_KEY_End, gtk_adjustment_get_upper(of)}};
    if (modifiers & (GDK_SHIFT_MASK | GDK_CONTROL_MASK)) return GDK_EVENT_PROPAGATE;
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++) {
        if (keys[i].key != key) continue;
        gtk_adjustment_set_value(of, keys[i].value);
        return GDK_EVENT_STOP;
    }
    return GDK_EVENT_PROPAGATE;
}

static void on_value_changed(TinkerKnob *knob)
{
    gtk_accessible_update_property(GTK_ACCESSIBLE(knob), GTK_ACCESSIBLE_PROPERTY_VALUE_NOW,
                                   gtk_adjustment_get_value(knob->adjustment), -1);
    gtk_widget_queue_draw(GTK_WIDGET(knob));
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_knob_dispose(GObject *object)
{
    g_clear_object(&TINKER_KNOB(object)->adjustment);
    G_OBJECT_CLASS(tinker_knob_parent_class)->dispose(object);
}

static void tinker_knob_class_init(TinkerKnobClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_knob_dispose;
    widget_class->snapshot = tinker_knob_snapshot;
    widget_class->measure = tinker_knob_measure;
    gtk_widget_class_set_css_name(widget_class, "knob");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_SLIDER);
}

static void tinker_knob_init(TinkerKnob *knob)
{
    gtk_widget_set_focusable(GTK_WIDGET(knob), TRUE);
    GtkGesture *drag = gtk_gesture_drag_new();
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_drag_begin), knob);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag), knob);
    gtk_widget_add_controller(GTK_WIDGET(knob), GTK_EVENT_CONTROLLER(drag));
    GtkEventController *scroll = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);
    g_signal_connect(scroll, "scroll", G_CALLBACK(on_scroll), knob);
    gtk_widget_add_controller(GTK_WIDGET(knob), scroll);
    GtkEventController *keys = gtk_event_controller_key_new();
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), knob);
    gtk_widget_add_controller(GTK_WIDGET(knob), keys);
}

GtkWidget *tinker_knob_new(GtkAdjustment *adjustment)
{
    TinkerKnob *knob = g_object_new(TINKER_TYPE_KNOB, NULL);
    knob->adjustment = g_object_ref_sink(adjustment);
    g_signal_connect_object(adjustment, "value-changed", G_CALLBACK(on_value_changed), knob, G_CONNECT_SWAPPED);
    gtk_accessible_update_property(GTK_ACCESSIBLE(knob), GTK_ACCESSIBLE_PROPERTY_VALUE_MIN,
                                   gtk_adjustment_get_lower(adjustment), GTK_ACCESSIBLE_PROPERTY_VALUE_MAX,
                                   gtk_adjustment_get_upper(adjustment), -1);
    on_value_changed(knob);
    return GTK_WIDGET(knob);
}

#include "gui/equation/equation-term.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/widget/tooltip.h"
#include "render/formula/formula.h"

#define SIZE        17.0 /* of letters, px */
#define VALUE_SIZE  11.0
#define VALUE_ROOM  16.0 /* beneath the formula */
#define VALUE_WIDTH 66.0 /* of most values: terms keep their places while they change */
#define BRACKET     3.0  /* how high it is, over the value of several terms, */
#define FAINT       0.5  /* and how much of the letters' colour it has */
#define PAD         3.0
#define SMALLEST    0.6 /* of its size a formula is drawn where there is less room */

struct _TinkerEquationTerm {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPointed what;
    TinkerMathText *formula;
    char *mathml; /* it is of */
    char *value;
    GtkWidget *last;            /* of those whose value it is together; NULL: its own */
    double value_width;         /* of the longest value so far */
    gboolean shows_value, told; /* told: the description has the value */
    double width, above, below; /* of the formula, */
    double least;               /* and of the widest that there was */
};

G_DEFINE_FINAL_TYPE(TinkerEquationTerm, tinker_equation_term, GTK_TYPE_WIDGET)

static void tinker_equation_term_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
                                         int *natural, int *minimum_baseline, int *natural_baseline)
{
    const TinkerEquationTerm *term = TINKER_EQUATION_TERM(widget);
    const double beneath = term->value == NULL ? 0 : term->last != NULL ? VALUE_WIDTH / 2 : term->value_width;
    const double width = term->shows_value ? fmax(term->width, beneath) : term->least;
    const double height = term->above + term->below + (term->shows_value ? VALUE_ROOM : 0);
    *minimum = *natural = (int)ceil((orientation == GTK_ORIENTATION_HORIZONTAL ? width : height) + 2 * PAD);
    if (orientation == GTK_ORIENTATION_HORIZONTAL) *minimum = (int)ceil(SMALLEST * width + 2 * PAD);
    *minimum_baseline = *natural_baseline = -1;
}

/* Where the terms of a value end to the right of this one; `whole`: all of them, else some are in another line. */
static double right_end(TinkerEquationTerm *term, gboolean *whole)
{
    double right = gtk_widget_get_width(GTK_WIDGET(term));
    GtkWidget *at = GTK_WIDGET(term);
    *whole = TRUE;
    while (term->last != NULL && at != term->last && *whole) {
        graphene_rect_t box;
        at = gtk_widget_get_next_sibling(at);
        *whole = at != NULL && gtk_widget_compute_bounds(at, GTK_WIDGET(term), &box) && box.origin.x >= right - PAD;
        if (*whole) right = (double)box.origin.x + (double)box.size.width;
    }
    return right;
}

static void draw_bracket(cairo_t *cairo, const GdkRGBA *colour, double right, double y)
{
    cairo_set_source_rgba(cairo, colour->red, colour->green, colour->blue, FAINT * colour->alpha);
    cairo_set_line_width(cairo, 1);
    cairo_move_to(cairo, PAD, y - BRACKET);
    cairo_line_to(cairo, PAD, y);
    cairo_line_to(cairo, right - PAD, y);
    cairo_line_to(cairo, right - PAD, y - BRACKET);
    cairo_stroke(cairo);
    gdk_cairo_set_source_rgba(cairo, colour);
}

/* In the middle beneath its terms, smaller where it is longer than they are. */
static void draw_value(TinkerEquationTerm *term, cairo_t *cairo, const GdkRGBA *colour, double right, gboolean whole)
{
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    const double height = gtk_widget_get_height(GTK_WIDGET(term));
    g_autofree char *shown = g_strconcat(whole ? "" : "Σ ", term->value, NULL);
    TinkerText text = {.text = shown, .size = VALUE_SIZE, .anchor_x = 0.5, .anchor_y = 1, .passing = TRUE};
    text.size *= fmin(1, right / fmax(tinker_text_width(&pen, &text), 1));
    if (term->last != NULL) draw_bracket(cairo, colour, right, height - VALUE_ROOM + BRACKET);
    tinker_text_draw(&pen, cairo, &text, right / 2, height - 1);
    tinker_text_pen_clear(&pen);
}

static void tinker_equation_term_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    TinkerEquationTerm *term = TINKER_EQUATION_TERM(widget);
    const double width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    const double scale = fmin(1, (width - 2 * PAD) / fmax(term->width, 1));
    gboolean whole;
    const double right = right_end(term, &whole);
    const graphene_rect_t bounds = GRAPHENE_RECT_INIT(0, 0, (float)fmax(width, right), (float)height);
    GdkRGBA colour;
    if (term->formula == NULL) return;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &colour);
    cairo_t *cairo = gtk_snapshot_append_cairo(snapshot, &bounds);
    gdk_cairo_set_source_rgba(cairo, &colour);
    cairo_save(cairo);
    cairo_translate(cairo, term->shows_value ? (width - scale * term->width) / 2 : PAD, PAD + term->above);
    cairo_scale(cairo, scale, scale);
    tinker_math_text_draw(term->formula, cairo, 0, 0);
    cairo_restore(cairo);
    if (term->shows_value && term->value != NULL) draw_value(term, cairo, &colour, right, whole);
    cairo_destroy(cairo);
}

/* Pointing --------------------------------------------------------------------------------------------------------- */

static void point(TinkerEquationTerm *term)
{
    if (term->what.block != TINKER_NO_BLOCK) tinker_document_point(term->document, term->what);
}

static void point_away(TinkerEquationTerm *term)
{
    tinker_document_point_away(term->document, term->what);
}

static void on_pointed(TinkerEquationTerm *term)
{
    if (tinker_pointed_lights(tinker_document_pointed(term->document), &term->what))
        gtk_widget_add_css_class(GTK_WIDGET(term), "lit");
    else
        gtk_widget_remove_css_class(GTK_WIDGET(term), "lit");
}

static void choose(TinkerEquationTerm *term)
{
    if (tinker_scene_has_block(tinker_document_scene(term->document), term->what.block))
        tinker_document_select(term->document, term->what.block);
}

static void on_click(GtkGestureClick *gesture, int presses, double x, double y, TinkerEquationTerm *term)
{
    gtk_widget_grab_focus(GTK_WIDGET(term));
    choose(term);
}

static gboolean on_key(GtkEventControllerKey *keys, guint key, guint code, GdkModifierType modifiers,
                       TinkerEquationTerm *term)
{
    if (key != GDK_KEY_Return && key != GDK_KEY_KP_Enter) return GDK_EVENT_PROPAGATE;
    choose(term);
    return GDK_EVENT_STOP;
}

static void add_input(TinkerEquationTerm *term)
{
    GtkEventController *motion = gtk_event_controller_motion_new(), *focus = gtk_event_controller_focus_new();
    GtkEventController *keys = gtk_event_controller_key_new();
    GtkGesture *click = gtk_gesture_click_new();
    g_signal_connect_swapped(motion, "enter", G_CALLBACK(point), term);
    g_signal_connect_swapped(motion, "leave", G_CALLBACK(point_away), term);
    g_signal_connect_swapped(focus, "enter", G_CALLBACK(point), term);
    g_signal_connect_swapped(focus, "leave", G_CALLBACK(point_away), term);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), term);
    g_signal_connect(click, "pressed", G_CALLBACK(on_click), term);
    gtk_widget_add_controller(GTK_WIDGET(term), motion);
    gtk_widget_add_controller(GTK_WIDGET(term), focus);
    gtk_widget_add_controller(GTK_WIDGET(term), keys);
    gtk_widget_add_controller(GTK_WIDGET(term), GTK_EVENT_CONTROLLER(click));
    gtk_widget_set_focusable(GTK_WIDGET(term), TRUE);
    g_signal_connect_object(term->document, "pointed-changed", G_CALLBACK(on_pointed), term, G_CONNECT_SWAPPED);
    on_pointed(term);
}

/* Values ----------------------------------------------------------------------------------------------------------- */

double tinker_equation_term_above(TinkerEquationTerm *term)
{
    return PAD + term->above;
}

void tinker_equation_term_show_value(TinkerEquationTerm *term, gboolean shown)
{
    if (term->shows_value == shown) return;
    term->shows_value = shown;
    gtk_widget_queue_resize(GTK_WIDGET(term));
}

GtkWidget *tinker_equation_term_last(TinkerEquationTerm *term)
{
    return term->last;
}

/* Terms make room for a value that is longer than all before it. */
static void make_room(TinkerEquationTerm *term)
{
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    const TinkerText text = {.text = term->value, .size = VALUE_SIZE, .passing = TRUE};
    const double width = fmax(tinker_text_width(&pen, &text), VALUE_WIDTH);
    tinker_text_pen_clear(&pen);
    if (width <= term->value_width) return;
    term->value_width = width;
    gtk_widget_queue_resize(GTK_WIDGET(term));
}

void tinker_equation_term_set_value(TinkerEquationTerm *term, const char *value, GtkWidget *last, gboolean tell)
{
    if (term->last != last) gtk_widget_queue_resize(GTK_WIDGET(term));
    term->last = last;
    if (g_strcmp0(term->value, value) != 0) {
        g_free(term->value);
        term->value = g_strdup(value);
        term->told = FALSE;
        if (value != NULL) make_room(term);
        gtk_widget_queue_draw(GTK_WIDGET(term));
    }
    if (!tell || term->told) return;
    term->told = TRUE;
    g_autofree char *told = value == NULL  ? g_strdup("")
                            : last != NULL ? g_strdup_printf(_("together %s"), value)
                                           : g_strdup(value);
    gtk_accessible_update_property(GTK_ACCESSIBLE(term), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, told, -1);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

static void set_formula(TinkerEquationTerm *term, const char *mathml)
{
    g_clear_pointer(&term->formula, tinker_math_text_free);
    g_free(term->mathml);
    term->mathml = g_strdup(mathml);
    term->formula = tinker_math_text_new(mathml, SIZE, NULL);
    if (term->formula != NULL) tinker_math_text_measure(term->formula, &term->width, &term->above, &term->below);
    term->least = fmax(term->least, term->width);
}

void tinker_equation_term_set_formula(TinkerEquationTerm *term, const char *mathml)
{
    const double width = term->least, height = term->above + term->below;
    if (g_strcmp0(term->mathml, mathml) == 0) return;
    set_formula(term, mathml);
    if (term->least > width || term->above + term->below != height)
        gtk_widget_queue_resize(GTK_WIDGET(term));
    else
        gtk_widget_queue_draw(GTK_WIDGET(term));
}

GtkWidget *tinker_equation_term_new(TinkerDocument *document, TinkerPointed what, const char *mathml,
                                    const char *spoken)
{
    TinkerEquationTerm *term = g_object_new(TINKER_TYPE_EQUATION_TERM, NULL);
    TinkerScene *scene = tinker_document_scene(document);
    /* an edit may have taken it away since the equations were written */
    const char *name = tinker_scene_has_block(scene, what.block) ? tinker_scene_block_name(scene, what.block) : NULL;
    g_autofree char *label = name != NULL ? g_strdup_printf("%s: %s", name, spoken) : g_strdup(spoken);
    term->document = g_object_ref(document);
    term->what = what;
    set_formula(term, mathml);
    gtk_accessible_update_property(GTK_ACCESSIBLE(term), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    if (name != NULL) {
        tinker_widget_begin_tooltip(GTK_WIDGET(term), name);
        add_input(term);
    }
    return GTK_WIDGET(term);
}

static void tinker_equation_term_finalize(GObject *object)
{
    TinkerEquationTerm *term = TINKER_EQUATION_TERM(object);
    g_clear_pointer(&term->formula, tinker_math_text_free);
    g_free(term->mathml);
    g_free(term->value);
    g_object_unref(term->document);
    G_OBJECT_CLASS(tinker_equation_term_parent_class)->finalize(object);
}

static void tinker_equation_term_class_init(TinkerEquationTermClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->finalize = tinker_equation_term_finalize;
    widget_class->measure = tinker_equation_term_measure;
    widget_class->snapshot = tinker_equation_term_snapshot;
    gtk_widget_class_set_css_name(widget_class, "equationterm");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_IMG);
}

static void tinker_equation_term_init(TinkerEquationTerm *term)
{
    term->what = tinker_pointed_block(TINKER_NO_BLOCK);
}

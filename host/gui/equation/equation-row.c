#include "gui/equation/equation-row.h"

#include <glib/gi18n.h>
#include <math.h>

#include "common/diagram/diagram-picture.h"
#include "gui/equation/equation-matrix.h"
#include "gui/widget/tooltip.h"
#include "gui/widget/unparent.h"

#define LINE_GAP 4
#define TERM_GAP 2
#define INDENT   24 /* at least, of all lines but the first */

/* What the value of a term is added up from. */
typedef struct {
    TinkerEquationTerm *term; /* a child */
    TinkerBlockId block;
    TinkerTermKind kind;
} Term;

struct _TinkerEquationRow {
    GtkWidget parent_instance;
    TinkerBlockId body;
    int component;
    GArray *terms;    /* of Term */
    guint left_count; /* children before the equals sign, where these are terms; else 0 */
};

G_DEFINE_FINAL_TYPE(TinkerEquationRow, tinker_equation_row, GTK_TYPE_WIDGET)

/* Layout ----------------------------------------------------------------------------------------------------------- */

static void size_of(GtkWidget *child, int size[2])
{
    gtk_widget_measure(child, GTK_ORIENTATION_HORIZONTAL, -1, NULL, &size[0], NULL, NULL);
    gtk_widget_measure(child, GTK_ORIENTATION_VERTICAL, -1, NULL, &size[1], NULL, NULL);
}

static int least_width(GtkWidget *child)
{
    int width;
    gtk_widget_measure(child, GTK_ORIENTATION_HORIZONTAL, -1, &width, NULL, NULL, NULL);
    return width;
}

/* How far above and below their letters' line the children from `first` to before `last` reach. */
static void line_reach(GtkWidget *first, GtkWidget *last, double reach[2])
{
    reach[0] = reach[1] = 0;
    for (GtkWidget *child = first; child != last; child = gtk_widget_get_next_sibling(child)) {
        int size[2];
        const double above = tinker_equation_term_above(TINKER_EQUATION_TERM(child));
        size_of(child, size);
        reach[0] = fmax(reach[0], above);
        reach[1] = fmax(reach[1], size[1] - above);
    }
}

/* Where a line begins: beneath the first term, or further left where its own first one is too wide for that. */
static double line_start(GtkWidget *begin, double indent, double width)
{
    int size[2];
    if (gtk_widget_get_prev_sibling(begin) == NULL) return 0;
    size_of(begin, size);
    return fmin(indent, fmax(INDENT, width - size[0]));
}

/* How wide a child is with those that share its value, which stay in one line where they have room in one. */
static double width_together(GtkWidget *child, double room)
{
    GtkWidget *last = tinker_equation_term_last(TINKER_EQUATION_TERM(child));
    int size[2];
    size_of(child, size);
    double width = size[0];
    for (GtkWidget *at = child; last != NULL && at != last;) {
        at = gtk_widget_get_next_sibling(at);
        if (at == NULL) break;
        size_of(at, size);
        width += TERM_GAP + size[0];
    }
    size_of(child, size);
    return width <= room ? width : size[0];
}

/* Lays out within a width and answers the height; `place`: and gives the children their places. One that is wider than
 * a line of its own becomes smaller. */
static double lay_out(GtkWidget *row, double width, gboolean place)
{
    GtkWidget *first = gtk_widget_get_first_child(row);
    int size[2];
    double y = 0, indent = 0;
    if (first == NULL) return 0;
    size_of(first, size);
    indent = fmin(size[0] + TERM_GAP, width / 2);
    for (GtkWidget *begin = first; begin != NULL;) {
        const double start = line_start(begin, indent, width);
        double x = start, reach[2];
        GtkWidget *end = begin;
        do {
            size_of(end, size);
            x += size[0] + TERM_GAP;
            end = gtk_widget_get_next_sibling(end);
        } while (end != NULL && x + width_together(end, width - indent) <= width);
        line_reach(begin, end, reach);
        x = start;
        for (GtkWidget *child = begin; child != end && place; child = gtk_widget_get_next_sibling(child)) {
            size_of(child, size);
            const double above = tinker_equation_term_above(TINKER_EQUATION_TERM(child));
            const int room = MAX((int)(width - x), least_width(child));
            const GtkAllocation box = {(int)x, (int)(y + reach[0] - above), MIN(size[0], room), size[1]};
            gtk_widget_size_allocate(child, &box, -1);
            x += size[0] + TERM_GAP;
        }
        y += reach[0] + reach[1] + (end != NULL ? LINE_GAP : 0);
        begin = end;
    }
    return y;
}

static GtkSizeRequestMode tinker_equation_row_mode(GtkWidget *widget)
{
    return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

static void tinker_equation_row_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
                                        int *natural, int *minimum_baseline, int *natural_baseline)
{
    *minimum_baseline = *natural_baseline = -1;
    *minimum = *natural = 0;
    if (orientation == GTK_ORIENTATION_VERTICAL) {
        *minimum = *natural = (int)ceil(lay_out(widget, for_size < 0 ? G_MAXINT : for_size, FALSE)) + 1;
        return;
    }
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child)) {
        int size[2];
        size_of(child, size);
        *minimum = MAX(*minimum, least_width(child) + (gtk_widget_get_prev_sibling(child) != NULL ? INDENT : 0));
        *natural += size[0] + TERM_GAP;
    }
}

static void tinker_equation_row_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    lay_out(widget, width, TRUE);
    /* a value is drawn over the width of several terms, which may have moved beside the first */
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        if (tinker_equation_term_last(TINKER_EQUATION_TERM(child)) != NULL) gtk_widget_queue_draw(child);
}

/* Values ----------------------------------------------------------------------------------------------------------- */

/* Whether a force is what the term stands for: of what touches there are two. */
static gboolean is_of(const TinkerActingForce *force, const Term *term, TinkerBlockId body)
{
    if (force->by != term->block || force->on != body) return FALSE;
    if (term->kind == TINKER_TERM_NORMAL) return force->kind == TINKER_ACTING_NORMAL;
    if (term->kind == TINKER_TERM_FRICTION) return force->kind == TINKER_ACTING_FRICTION;
    return force->kind != TINKER_ACTING_NORMAL && force->kind != TINKER_ACTING_FRICTION;
}

static gboolean shares_force(const Term *term, const Term *other)
{
    return other->block == term->block && other->kind == term->kind;
}

/* How many terms before this one, and how many in all, stand for one force: of a rope that runs over a wheel, or the
 * two of a moment, r_x F_y and r_y F_x. */
static guint count_sharing(const TinkerEquationRow *row, guint number, guint *before)
{
    const Term *term = &g_array_index(row->terms, Term, number);
    guint count = 0;
    *before = 0;
    for (guint i = 0; i < row->terms->len; i++) {
        if (!shares_force(term, &g_array_index(row->terms, Term, i))) continue;
        count++;
        if (i < number) ++*before;
    }
    return count;
}

/* What the terms of one force add up to: N, of the third equation N m about the centre of the body. */
static double sum_of(const TinkerEquationRow *row, const Term *term, const TinkerModelState *state)
{
    double sum = 0;
    for (guint k = 0; k < state->forces->len; k++) {
        const TinkerActingForce *force = &g_array_index(state->forces, TinkerActingForce, k);
        if (!is_of(force, term, row->body)) continue;
        const double parts[] = {force->fx, force->fy, tinker_model_state_moment(state, force)};
        sum += parts[row->component];
    }
    return fabs(sum) > tinker_model_state_nothing(state, row->body, row->component == 2) ? sum : 0;
}

/* The last of the terms that share the force of the first one, where they stand beside one another; NULL: it has none,
 * or they do not. */
static TinkerEquationTerm *last_sharing(const TinkerEquationRow *row, guint first, guint count)
{
    for (guint i = first + 1; i < first + count; i++)
        if (i >= row->terms->len ||
            !shares_force(&g_array_index(row->terms, Term, first), &g_array_index(row->terms, Term, i)))
            return NULL;
    return count > 1 ? g_array_index(row->terms, Term, first + count - 1).term : NULL;
}

/* What stands beneath a term: nothing but beneath the first of those that share their force; with a sum sign where
 * these do not stand beside one another. (transfer full) */
static char *value_of(const TinkerEquationRow *row, guint number, const TinkerModelState *state, TinkerUnitSystem units,
                      TinkerEquationTerm **last)
{
    guint before;
    const guint count = count_sharing(row, number, &before);
    if (before > 0) return NULL;
    *last = last_sharing(row, number, count);
    const double sum = sum_of(row, &g_array_index(row->terms, Term, number), state);
    g_autofree char *text = tinker_load_brief(sum, row->component == 2, units);
    return g_strconcat(count > 1 && *last == NULL ? "Σ " : "", text, NULL);
}

void tinker_equation_row_show_values(TinkerEquationRow *row, const TinkerModelState *state, TinkerUnitSystem units,
                                     gboolean tell)
{
    const gboolean shows = state != NULL && row->component >= 0;
    for (guint i = 0; i < row->terms->len; i++) {
        const Term *term = &g_array_index(row->terms, Term, i);
        TinkerEquationTerm *last = NULL;
        g_autofree char *value = shows ? value_of(row, i, state, units, &last) : NULL;
        tinker_equation_term_show_value(term->term, shows);
        tinker_equation_term_set_value(term->term, value, (GtkWidget *)last, tell);
    }
}

gboolean tinker_equation_row_is_balance(TinkerEquationRow *row)
{
    return row->left_count > 0;
}

void tinker_equation_row_show_line_values(TinkerEquationRow *row, const TinkerEquationLine *line,
                                          TinkerUnitSystem units, gboolean tell)
{
    g_autoptr(GArray) all = g_array_new(FALSE, TRUE, sizeof(TinkerLineTerm));
    if (row->left_count == 0) return;
    if (line != NULL) {
        g_array_append_vals(all, line->left_terms->data, line->left_terms->len);
        g_array_append_vals(all, line->terms->data, line->terms->len);
    }
    tinker_equation_terms_show_values(gtk_widget_get_first_child(GTK_WIDGET(row)), all, units, tell);
}

void tinker_equation_row_update(TinkerEquationRow *row, const TinkerEquationLine *line)
{
    GtkWidget *right = gtk_widget_get_last_child(GTK_WIDGET(row));
    tinker_equation_term_set_formula(TINKER_EQUATION_TERM(right), g_array_index(line->terms, TinkerLineTerm, 0).text);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

/* Terms before the equals sign, which stands behind the last. */
static void add_left_terms(TinkerEquationRow *row, TinkerDocument *document, const TinkerEquationLine *shown,
                           const TinkerEquationLine *spoken)
{
    row->left_count = shown->left_terms->len;
    for (guint i = 0; i < row->left_count; i++) {
        const TinkerLineTerm *term = &g_array_index(shown->left_terms, TinkerLineTerm, i);
        const char *said = g_array_index(spoken->left_terms, TinkerLineTerm, i).text;
        const gboolean is_last = i + 1 == row->left_count;
        g_autofree char *mathml =
            g_strconcat(i > 0 ? "<mrow></mrow>" : "", term->text, is_last ? "<mo>=</mo>" : "", NULL);
        g_autofree char *reading = is_last ? g_strdup_printf(_("%s equals"), said) : g_strdup(said);
        GtkWidget *widget = tinker_equation_term_new(document, tinker_pointed_block(term->block), mathml, reading);
        gtk_widget_set_parent(widget, GTK_WIDGET(row));
    }
}

static void add_left(TinkerEquationRow *row, TinkerDocument *document, const TinkerEquationLine *shown,
                     const TinkerEquationLine *spoken)
{
    g_autofree char *mathml = g_strconcat(shown->left, "<mo>=</mo>", NULL);
    g_autofree char *reading = g_strdup_printf(_("%s equals"), spoken->left);
    GtkWidget *left = tinker_equation_term_new(document, tinker_pointed_block(shown->block), mathml, reading);
    gtk_widget_set_parent(left, GTK_WIDGET(row));
}

/* What touches has two terms of one block, which is all that the tooltip of a term tells. */
static void tell_kind(GtkWidget *term, TinkerTermKind kind)
{
    const char *name = gtk_widget_get_tooltip_text(term);
    if (name == NULL || (kind != TINKER_TERM_NORMAL && kind != TINKER_TERM_FRICTION)) return;
    g_autofree char *text =
        g_strdup_printf(kind == TINKER_TERM_NORMAL ? _("%s: normal force N") : _("%s: friction f"), name);
    tinker_widget_begin_tooltip(term, text);
}

/* Of a body's equation the force on it; of a law all that comes from its block. */
static TinkerPointed pointed_of(const TinkerEquationLine *line, const TinkerLineTerm *term)
{
    if (line->component < 0) return tinker_pointed_block(term->block);
    return tinker_diagram_pointed(term->block, line->block, term->kind);
}

GtkWidget *tinker_equation_row_new(TinkerDocument *document, const TinkerEquationLine *shown,
                                   const TinkerEquationLine *spoken)
{
    TinkerEquationRow *row = g_object_new(TINKER_TYPE_EQUATION_ROW, NULL);
    row->body = shown->block;
    row->component = shown->component;
    if (shown->left_terms != NULL)
        add_left_terms(row, document, shown, spoken);
    else
        add_left(row, document, shown, spoken);
    for (guint i = 0; i < shown->terms->len; i++) {
        const TinkerLineTerm *term = &g_array_index(shown->terms, TinkerLineTerm, i);
        const TinkerLineTerm *reading = &g_array_index(spoken->terms, TinkerLineTerm, i);
        /* what stands before a sign keeps room around it */
        g_autofree char *mathml = g_strconcat(i > 0 ? "<mrow></mrow>" : "", term->text, NULL);
        GtkWidget *widget = tinker_equation_term_new(document, pointed_of(shown, term), mathml, reading->text);
        const Term one = {TINKER_EQUATION_TERM(widget), term->block, term->kind};
        tell_kind(widget, term->kind);
        gtk_widget_set_parent(widget, GTK_WIDGET(row));
        if (shown->component >= 0) g_array_append_val(row->terms, one);
    }
    return GTK_WIDGET(row);
}

static void tinker_equation_row_dispose(GObject *object)
{
    tinker_unparent_children(GTK_WIDGET(object));
    G_OBJECT_CLASS(tinker_equation_row_parent_class)->dispose(object);
}

static void tinker_equation_row_finalize(GObject *object)
{
    g_array_unref(TINKER_EQUATION_ROW(object)->terms);
    G_OBJECT_CLASS(tinker_equation_row_parent_class)->finalize(object);
}

static void tinker_equation_row_class_init(TinkerEquationRowClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_equation_row_dispose;
    G_OBJECT_CLASS(class)->finalize = tinker_equation_row_finalize;
    widget_class->get_request_mode = tinker_equation_row_mode;
    widget_class->measure = tinker_equation_row_measure;
    widget_class->size_allocate = tinker_equation_row_size_allocate;
    gtk_widget_class_set_css_name(widget_class, "equationrow");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_equation_row_init(TinkerEquationRow *row)
{
    row->terms = g_array_new(FALSE, FALSE, sizeof(Term));
}

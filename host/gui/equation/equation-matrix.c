/* What is wider than the page is scrolled. */
#include "gui/equation/equation-matrix.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/widget/unparent.h"

#define BRACKET    5.0 /* px: how far its arms reach */
#define LINE_WIDTH 1.4
#define ASIDE      8  /* px: around the entries */
#define BETWEEN    14 /* px: columns, */
#define ROWS       4  /* and rows */

struct _TinkerEquationMatrix {
    GtkWidget parent_instance;
    GtkWidget *left, *grid;
};

G_DEFINE_FINAL_TYPE(TinkerEquationMatrix, tinker_equation_matrix, GTK_TYPE_WIDGET)

/* Drawing ---------------------------------------------------------------------------------------------------------- */

static void draw_bracket(cairo_t *cairo, double x, double arm, double top, double bottom)
{
    cairo_move_to(cairo, x + arm, top);
    cairo_line_to(cairo, x, top);
    cairo_line_to(cairo, x, bottom);
    cairo_line_to(cairo, x + arm, bottom);
    cairo_stroke(cairo);
}

static void draw_brackets(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    GdkRGBA colour;
    gtk_style_context_get_color(gtk_widget_get_style_context(GTK_WIDGET(area)), &colour);
    gdk_cairo_set_source_rgba(cairo, &colour);
    cairo_set_line_width(cairo, LINE_WIDTH);
    draw_bracket(cairo, LINE_WIDTH, BRACKET, LINE_WIDTH, height - LINE_WIDTH);
    draw_bracket(cairo, width - LINE_WIDTH, -BRACKET, LINE_WIDTH, height - LINE_WIDTH);
}

/* Values ----------------------------------------------------------------------------------------------------------- */

/* The last of the terms behind number `from` that have one value with it; NULL: there are none. */
static GtkWidget *last_of(GtkWidget *child, const GArray *terms, guint from)
{
    GtkWidget *last = NULL;
    for (guint i = from + 1; i < terms->len && g_array_index(terms, TinkerLineTerm, i).follows; i++)
        last = child = gtk_widget_get_next_sibling(child);
    return last;
}

void tinker_equation_terms_show_values(GtkWidget *first, const GArray *terms, TinkerUnitSystem units, gboolean tell)
{
    GtkWidget *child = first;
    for (guint i = 0; child != NULL; i++, child = gtk_widget_get_next_sibling(child)) {
        const TinkerLineTerm *term = terms != NULL && i < terms->len ? &g_array_index(terms, TinkerLineTerm, i) : NULL;
        const gboolean shows = term != NULL && term->has_value && isfinite(term->value);
        g_autofree char *size = shows ? tinker_quantity_brief(fabs(term->value), term->dimension, units) : NULL;
        g_autofree char *text = shows ? g_strconcat(term->value < 0 ? "−" : "", size, NULL) : NULL;
        tinker_equation_term_show_value(TINKER_EQUATION_TERM(child), shows || (term != NULL && term->follows));
        tinker_equation_term_set_value(TINKER_EQUATION_TERM(child), text, shows ? last_of(child, terms, i) : NULL,
                                       tell);
    }
}

void tinker_equation_matrix_show_values(TinkerEquationMatrix *matrix, const TinkerEquationLine *line,
                                        TinkerUnitSystem units, gboolean tell)
{
    guint i = 0;
    for (GtkWidget *cell = gtk_widget_get_first_child(matrix->grid); cell != NULL;
         cell = gtk_widget_get_next_sibling(cell), i++)
        tinker_equation_terms_show_values(gtk_widget_get_first_child(cell),
                                          line != NULL ? g_ptr_array_index(line->matrix->cells, i) : NULL, units, tell);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

static GtkWidget *new_cell(TinkerDocument *document, const GArray *shown, const GArray *spoken, guint number,
                           guint columns)
{
    GtkWidget *cell = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 2);
    for (guint i = 0; i < shown->len; i++) {
        const TinkerLineTerm *term = &g_array_index(shown, TinkerLineTerm, i);
        g_autofree char *mathml = g_strconcat(i > 0 ? "<mrow></mrow>" : "", term->text, NULL);
        g_autofree char *reading = g_strdup_printf(_("row %u, column %u: %s"), number / columns + 1,
                                                   number % columns + 1, g_array_index(spoken, TinkerLineTerm, i).text);
        GtkWidget *widget = tinker_equation_term_new(document, tinker_pointed_block(term->block), mathml, reading);
        gtk_widget_set_valign(widget, GTK_ALIGN_CENTER);
        gtk_box_append(GTK_BOX(cell), widget);
    }
    gtk_widget_set_halign(cell, GTK_ALIGN_CENTER);
    gtk_widget_set_valign(cell, GTK_ALIGN_CENTER);
    return cell;
}

/* The entries, over an area that draws the brackets. */
static GtkWidget *new_entries(TinkerEquationMatrix *matrix, TinkerDocument *document, const TinkerEquationLine *shown,
                              const TinkerEquationLine *spoken)
{
    GtkWidget *overlay = gtk_overlay_new(), *area = gtk_drawing_area_new();
    const guint columns = shown->matrix->columns;
    matrix->grid = gtk_grid_new();
    gtk_grid_set_column_spacing(GTK_GRID(matrix->grid), BETWEEN);
    gtk_grid_set_row_spacing(GTK_GRID(matrix->grid), ROWS);
    gtk_widget_set_margin_top(matrix->grid, ROWS);
    gtk_widget_set_margin_bottom(matrix->grid, ROWS);
    gtk_widget_set_margin_start(matrix->grid, ASIDE);
    gtk_widget_set_margin_end(matrix->grid, ASIDE);
    for (guint i = 0; i < shown->matrix->cells->len; i++) {
        GtkWidget *cell = new_cell(document, g_ptr_array_index(shown->matrix->cells, i),
                                   g_ptr_array_index(spoken->matrix->cells, i), i, columns);
        gtk_grid_attach(GTK_GRID(matrix->grid), cell, (int)(i % columns), (int)(i / columns), 1, 1);
    }
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(area), draw_brackets, NULL, NULL);
    gtk_overlay_set_child(GTK_OVERLAY(overlay), area);
    gtk_overlay_add_overlay(GTK_OVERLAY(overlay), matrix->grid);
    gtk_overlay_set_measure_overlay(GTK_OVERLAY(overlay), matrix->grid, TRUE);
    gtk_widget_set_halign(overlay, GTK_ALIGN_START);
    return overlay;
}

/* A wheel over it scrolls the page: what only goes sideways leaves the rest of it to what is around. */
static void scroll_sideways_alone(GtkWidget *scrolled)
{
    g_autoptr(GListModel) controllers = gtk_widget_observe_controllers(scrolled);
    for (guint i = 0; i < g_list_model_get_n_items(controllers); i++) {
        g_autoptr(GObject) controller = g_list_model_get_item(controllers, i);
        if (GTK_IS_EVENT_CONTROLLER_SCROLL(controller))
            gtk_event_controller_scroll_set_flags(GTK_EVENT_CONTROLLER_SCROLL(controller),
                                                  GTK_EVENT_CONTROLLER_SCROLL_HORIZONTAL);
    }
}

GtkWidget *tinker_equation_matrix_new(TinkerDocument *document, const TinkerEquationLine *shown,
                                      const TinkerEquationLine *spoken)
{
    TinkerEquationMatrix *matrix = g_object_new(TINKER_TYPE_EQUATION_MATRIX, NULL);
    GtkWidget *scrolled = gtk_scrolled_window_new();
    g_autofree char *mathml = g_strconcat(shown->left, "<mo>=</mo>", NULL);
    g_autofree char *reading = g_strdup_printf(_("%s equals"), spoken->left);
    g_autofree char *label =
        g_strdup_printf(_("%s: %u rows, %u columns"), spoken->left, shown->matrix->rows, shown->matrix->columns);
    matrix->left = tinker_equation_term_new(document, tinker_pointed_block(TINKER_NO_BLOCK), mathml, reading);
    gtk_widget_set_valign(matrix->left, GTK_ALIGN_CENTER);
    gtk_widget_set_parent(matrix->left, GTK_WIDGET(matrix));
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_AUTOMATIC, GTK_POLICY_NEVER);
    gtk_scrolled_window_set_propagate_natural_height(GTK_SCROLLED_WINDOW(scrolled), TRUE);
    scroll_sideways_alone(scrolled);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), new_entries(matrix, document, shown, spoken));
    gtk_widget_set_hexpand(scrolled, TRUE);
    gtk_widget_set_parent(scrolled, GTK_WIDGET(matrix));
    gtk_accessible_update_property(GTK_ACCESSIBLE(matrix), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    return GTK_WIDGET(matrix);
}

static void tinker_equation_matrix_dispose(GObject *object)
{
    tinker_unparent_children(GTK_WIDGET(object));
    G_OBJECT_CLASS(tinker_equation_matrix_parent_class)->dispose(object);
}

static void tinker_equation_matrix_class_init(TinkerEquationMatrixClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_equation_matrix_dispose;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "equationmatrix");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_equation_matrix_init(TinkerEquationMatrix *matrix) {}

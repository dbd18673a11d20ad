#include "gui/equation/equation-list.h"

#include <string.h>

#include "gui/equation/equation-matrix.h"
#include "gui/equation/equation-row.h"

GtkWidget *tinker_equation_label(const char *text, const char *css_class)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_widget_add_css_class(label, css_class);
    return label;
}

static void add_text(GtkWidget *box, const char *text, const char *css_class)
{
    gtk_box_append(GTK_BOX(box), tinker_equation_label(text, css_class));
}

/* Beside a value stands what it is of. */
static void add_value(GtkWidget *box, GtkWidget *row, const char *comment)
{
    GtkWidget *both = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 12), *label = tinker_equation_label(comment, "dim-label");
    gtk_widget_set_hexpand(label, TRUE);
    gtk_box_append(GTK_BOX(both), row);
    gtk_box_append(GTK_BOX(both), label);
    gtk_box_append(GTK_BOX(box), both);
}

static gboolean is_value(const TinkerEquationLine *line)
{
    if (line->terms->len != 1) return FALSE;
    const char *text = g_array_index(line->terms, TinkerLineTerm, 0).text;
    return strstr(text, "<mtext>") != NULL || strstr(text, "<mi>") == NULL; /* a unit, or a number alone */
}

void tinker_equation_list_add(GtkWidget *box, TinkerDocument *document, const TinkerEquationLine *shown,
                              const TinkerEquationLine *spoken)
{
    if (shown->heading != NULL) {
        add_text(box, shown->heading, "heading");
        return;
    }
    if (shown->matrix != NULL) {
        gtk_box_append(GTK_BOX(box), tinker_equation_matrix_new(document, shown, spoken));
        return;
    }
    GtkWidget *row = tinker_equation_row_new(document, shown, spoken);
    const gboolean has_comment = shown->comment != NULL && shown->component < 0;
    if (has_comment && is_value(shown)) {
        add_value(box, row, shown->comment);
        return;
    }
    gtk_box_append(GTK_BOX(box), row);
    if (has_comment) add_text(box, shown->comment, "caption");
}

static gboolean is_seen(GtkWidget *child)
{
    GtkWidget *page = gtk_widget_get_ancestor(child, GTK_TYPE_SCROLLED_WINDOW);
    graphene_rect_t box;
    if (page == NULL || !gtk_widget_compute_bounds(child, page, &box)) return TRUE;
    return box.origin.y + box.size.height >= 0 && box.origin.y <= (float)gtk_widget_get_height(page);
}

static void set_text(GtkWidget *label, const char *text)
{
    if (g_strcmp0(gtk_label_get_text(GTK_LABEL(label)), text) != 0) gtk_label_set_text(GTK_LABEL(label), text);
}

void tinker_equation_list_update(GtkWidget *box, const GPtrArray *lines, guint first, guint end)
{
    GtkWidget *child = gtk_widget_get_first_child(box);
    for (guint i = first; i < end && child != NULL; i++, child = gtk_widget_get_next_sibling(child)) {
        const TinkerEquationLine *line = g_ptr_array_index(lines, i);
        const gboolean has_comment = line->comment != NULL && line->component < 0 && line->heading == NULL;
        if (line->heading != NULL) {
            if (is_seen(child)) set_text(child, line->heading);
        } else if (line->matrix == NULL && !is_value(line)) {
            if (has_comment) child = gtk_widget_get_next_sibling(child); // it stands below
        } else if (line->matrix == NULL && is_seen(child)) {
            GtkWidget *row = has_comment ? gtk_widget_get_first_child(child) : child;
            if (!TINKER_IS_EQUATION_ROW(row)) continue;
            tinker_equation_row_update(TINKER_EQUATION_ROW(row), line);
            if (has_comment) set_text(gtk_widget_get_next_sibling(row), line->comment);
        }
    }
}

void tinker_equation_list_show_values(GtkWidget *box, const TinkerModelState *state, TinkerUnitSystem units,
                                      gboolean tell)
{
    for (GtkWidget *row = gtk_widget_get_first_child(box); row != NULL; row = gtk_widget_get_next_sibling(row))
        if (TINKER_IS_EQUATION_ROW(row)) tinker_equation_row_show_values(TINKER_EQUATION_ROW(row), state, units, tell);
}

/* A block by its name, too, which tips and readings have. */
static void append_part(GString *text, const TinkerScene *scene, TinkerBlockId block, const char *written)
{
    const char *name = tinker_scene_has_block(scene, block) ? tinker_scene_block_name(scene, block) : "";
    g_string_append_printf(text, "%d %s %s\n", block, name, written);
}

static void append_terms(GString *text, const TinkerScene *scene, const GArray *terms)
{
    for (guint i = 0; i < terms->len; i++) {
        const TinkerLineTerm *term = &g_array_index(terms, TinkerLineTerm, i);
        append_part(text, scene, term->block, term->text);
    }
}

/* The next line behind number `at` that has values of its own; NULL: none. */
static const TinkerEquationLine *next_valued(const GPtrArray *lines, guint *at)
{
    while (lines != NULL && *at < lines->len) {
        const TinkerEquationLine *line = g_ptr_array_index(lines, (*at)++);
        if (line->matrix != NULL || line->left_terms != NULL) return line;
    }
    return NULL;
}

void tinker_equation_list_show_line_values(GtkWidget *box, const GPtrArray *lines, TinkerUnitSystem units,
                                           gboolean tell)
{
    guint at = 0;
    for (GtkWidget *row = gtk_widget_get_first_child(box); row != NULL; row = gtk_widget_get_next_sibling(row)) {
        if (TINKER_IS_EQUATION_MATRIX(row))
            tinker_equation_matrix_show_values(TINKER_EQUATION_MATRIX(row), next_valued(lines, &at), units, tell);
        else if (TINKER_IS_EQUATION_ROW(row) && tinker_equation_row_is_balance(TINKER_EQUATION_ROW(row)))
            tinker_equation_row_show_line_values(TINKER_EQUATION_ROW(row), next_valued(lines, &at), units, tell);
    }
}

char *tinker_equation_lines_written(const GPtrArray *lines, const TinkerScene *scene)
{
    GString *text = g_string_new(NULL);
    for (guint i = 0; i < lines->len; i++) {
        const TinkerEquationLine *line = g_ptr_array_index(lines, i);
        if (line->heading != NULL || is_value(line)) continue;
        append_part(text, scene, line->block, line->left);
        if (line->left_terms != NULL) append_terms(text, scene, line->left_terms);
        for (guint k = 0; line->matrix != NULL && k < line->matrix->cells->len; k++)
            append_terms(text, scene, g_ptr_array_index(line->matrix->cells, k));
        append_terms(text, scene, line->terms);
    }
    return g_string_free(text, FALSE);
}

/* The lines of a page that has no text. */
#include "equations/write/lines.h"
#include "equations/write/page-private.h"

static void term_clear(gpointer data)
{
    g_free(((TinkerLineTerm *)data)->text);
}

static void line_free(gpointer data)
{
    TinkerEquationLine *line = data;
    g_free(line->heading);
    g_free(line->left);
    g_free(line->comment);
    g_array_unref(line->terms);
    g_clear_pointer(&line->left_terms, g_array_unref);
    if (line->matrix != NULL) g_ptr_array_unref(line->matrix->cells);
    g_free(line->matrix);
    g_free(line);
}

static GArray *terms_new(void)
{
    GArray *terms = g_array_new(FALSE, TRUE, sizeof(TinkerLineTerm));
    g_array_set_clear_func(terms, term_clear);
    return terms;
}

static TinkerEquationLine *add_line(TinkerPage *page)
{
    TinkerEquationLine *line = g_new0(TinkerEquationLine, 1);
    line->block = page->about;
    line->component = -1;
    line->terms = terms_new();
    g_ptr_array_add(page->lines, line);
    return line;
}

void tinker_page_line_heading(TinkerPage *page, const char *heading)
{
    add_line(page)->heading = g_strdup(heading);
}

void tinker_page_line(TinkerPage *page, char *left, char *right, char *comment)
{
    TinkerEquationLine *line = add_line(page);
    const TinkerLineTerm term = {.text = right, .block = page->about, .kind = TINKER_TERM_FORCE};
    line->left = left;
    line->comment = comment;
    g_array_append_val(line->terms, term);
}

void tinker_page_line_sum(TinkerPage *page, char *left, int component, char *comment)
{
    TinkerEquationLine *line = add_line(page);
    line->left = left;
    line->component = component;
    line->comment = comment;
}

static void add_term(TinkerPage *page, TinkerBlockId block, TinkerTermKind kind, const TinkerExpression *expression)
{
    TinkerEquationLine *line = g_ptr_array_index(page->lines, page->lines->len - 1);
    const TinkerLineTerm term = {.text = tinker_expression_typeset_term(expression, line->terms->len == 0, page->format,
                                                                        tinker_equations_look, (void *)page->equations),
                                 .block = block,
                                 .kind = kind};
    g_array_append_val(line->terms, term);
}

void tinker_page_line_terms(TinkerPage *page, TinkerBlockId block, TinkerTermKind kind,
                            const TinkerExpression *expression)
{
    const gboolean is_sum = expression->kind == TINKER_EXPRESSION_SUM;
    for (int i = 0; i < (is_sum ? expression->count : 1); i++)
        add_term(page, block, kind, is_sum ? expression->parts[i] : expression);
}

TinkerEquationLine *tinker_page_line_balance(TinkerPage *page)
{
    TinkerEquationLine *line = add_line(page);
    line->left = g_strdup("");
    line->left_terms = terms_new();
    return line;
}

TinkerEquationLine *tinker_page_line_matrix(TinkerPage *page, char *left, guint rows, guint columns)
{
    TinkerEquationLine *line = add_line(page);
    line->left = left;
    line->matrix = g_new(TinkerLineMatrix, 1);
    *line->matrix = (TinkerLineMatrix){rows, columns, g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref)};
    for (guint i = 0; i < rows * columns; i++)
        g_ptr_array_add(line->matrix->cells, terms_new());
    return line;
}

GPtrArray *tinker_page_lines_new(void)
{
    return g_ptr_array_new_with_free_func(line_free);
}

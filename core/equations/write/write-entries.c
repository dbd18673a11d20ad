/* Matrices entry by entry, and the terms that entries are made of. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "equations/write/page-private.h"
#include "law/build.h"

/* Blocks ----------------------------------------------------------------------------------------------------------- */

static gboolean is_body(const TinkerEquations *equations, TinkerBlockId block)
{
    for (guint i = 0; i < equations->bodies->len; i++)
        if (((const TinkerBodyEquation *)g_ptr_array_index(equations->bodies, i))->block == block) return TRUE;
    return FALSE;
}

/* The first block of the symbols that is no body, else the first of all. */
static TinkerBlockId block_of(const TinkerEquations *equations, const TinkerExpression *expression)
{
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) {
        const TinkerEquationDefinition *definition = tinker_equations_definition(equations, expression->name);
        const TinkerEquationSymbol *symbol = tinker_equations_symbol(equations, expression->name);
        return definition != NULL ? definition->block : symbol != NULL ? symbol->block : TINKER_NO_BLOCK;
    }
    TinkerBlockId found = TINKER_NO_BLOCK;
    for (int i = 0; i < expression->count; i++) {
        const TinkerBlockId block = block_of(equations, expression->parts[i]);
        if (block == TINKER_NO_BLOCK) continue;
        if (found == TINKER_NO_BLOCK || (is_body(equations, found) && !is_body(equations, block))) found = block;
    }
    return found;
}

/* Terms ------------------------------------------------------------------------------------------------------------ */

/* One summand times the variable, with its sign. (transfer full) */
static char *term_text(const TinkerPage *page, const TinkerExpression *part, gboolean first, const char *variable)
{
    if (variable == NULL)
        return tinker_expression_typeset_term(part, first, page->format, tinker_equations_look,
                                              (void *)page->equations);
    const gboolean negative = part->kind == TINKER_EXPRESSION_NEGATIVE;
    g_autofree char *factor = tinker_page_factor(page, negative ? part->parts[0] : part);
    const char *sign = first && !negative ? "" : tinker_typeset_sign(page->format, negative ? '-' : '+');
    return g_strconcat(sign, factor, tinker_typeset_sign(page->format, '*'), variable, NULL);
}

void tinker_page_add_terms(const TinkerPage *page, GArray *terms, const TinkerExpression *factor, const char *variable,
                           double variable_value, TinkerDimension dimension)
{
    const gboolean is_sum = factor->kind == TINKER_EXPRESSION_SUM;
    for (int i = 0; i < (is_sum ? factor->count : 1); i++) {
        const TinkerExpression *part = is_sum ? factor->parts[i] : factor;
        const TinkerLineTerm term = {.text =
                                         term_text(page, part, variable != NULL ? terms->len == 0 : i == 0, variable),
                                     .block = block_of(page->equations, part),
                                     .follows = i > 0,
                                     .has_value = i == 0 && !tinker_expression_is_number(factor, 0),
                                     .value = tinker_equations_value(page->equations, factor) * variable_value,
                                     .dimension = dimension};
        g_array_append_val(terms, term);
    }
}

/* Matrices --------------------------------------------------------------------------------------------------------- */

/* Letters as they stand in a terminal. */
static int width_of(const char *text)
{
    int width = 0;
    for (const char *p = text; *p != '\0'; p = g_utf8_next_char(p))
        width += !g_unichar_iszerowidth(g_utf8_get_char(p));
    return width;
}

/* Columns in the middle of their width, between brackets over all rows. */
static char *in_text(const TinkerPageMatrix *matrix, GPtrArray *cells)
{
    static const char *const brackets[2][4] = {{"[", "⎡", "⎢", "⎣"}, {"]", "⎤", "⎥", "⎦"}};
    g_autofree int *widths = g_new0(int, matrix->columns);
    GString *text = g_string_new(NULL);
    for (guint i = 0; i < cells->len; i++)
        widths[i % matrix->columns] = MAX(widths[i % matrix->columns], width_of(g_ptr_array_index(cells, i)));
    for (guint i = 0; i < matrix->rows; i++) {
        const int shape = matrix->rows == 1 ? 0 : i == 0 ? 1 : i + 1 < matrix->rows ? 2 : 3;
        g_string_append_printf(text, "%s%s", i > 0 ? "\n" : "", brackets[0][shape]);
        for (guint k = 0; k < matrix->columns; k++) {
            const char *cell = g_ptr_array_index(cells, i * matrix->columns + k);
            const int free = widths[k] - width_of(cell);
            g_string_append_printf(text, "%*s%s%*s", free / 2 + (k > 0 ? 3 : 1), "", cell, free - free / 2, "");
        }
        g_string_append_printf(text, " %s", brackets[1][shape]);
    }
    return g_string_free(text, FALSE);
}

/* With these around all, each row and each cell, and between rows and between cells. (transfer full) */
static char *in_marks(const TinkerPageMatrix *matrix, GPtrArray *cells, const char *const marks[8])
{
    GString *text = g_string_new(marks[0]);
    for (guint i = 0; i < matrix->rows; i++) {
        g_string_append_printf(text, "%s%s", i > 0 ? marks[6] : "", marks[2]);
        for (guint k = 0; k < matrix->columns; k++)
            g_string_append_printf(text, "%s%s%s%s", k > 0 ? marks[7] : "", marks[4],
                                   (const char *)g_ptr_array_index(cells, i * matrix->columns + k), marks[5]);
        g_string_append(text, marks[3]);
    }
    g_string_append(text, marks[1]);
    return g_string_free(text, FALSE);
}

static char *matrix_text(const TinkerPage *page, const TinkerPageMatrix *matrix)
{
    static const char *const latex[] = {"\\begin{bmatrix}", "\\end{bmatrix}", "", "", "", "", " \\\\ ", " & "};
    static const char *const mathml[] = {
        "<mrow><mo>[</mo><mtable>", "</mtable><mo>]</mo></mrow>", "<mtr>", "</mtr>", "<mtd>", "</mtd>", "", ""};
    static const char *const speech[] = {"", "", "", "", "", "", "; ", ", "};
    g_autoptr(GPtrArray) cells = g_ptr_array_new_with_free_func(g_free);
    for (guint i = 0; i < matrix->rows * matrix->columns; i++)
        g_ptr_array_add(cells, tinker_page_expression(page, matrix->entries[i]));
    switch (page->format) {
    case TINKER_TYPESET_LATEX:
        return in_marks(matrix, cells, latex);
    case TINKER_TYPESET_MATHML:
        return in_marks(matrix, cells, mathml);
    case TINKER_TYPESET_SPEECH:
        return in_marks(matrix, cells, speech);
    default:
        return in_text(matrix, cells);
    }
}

void tinker_page_matrix(TinkerPage *page, char *left, const TinkerPageMatrix *matrix)
{
    if (page->lines == NULL) {
        tinker_page_equation(page, left, matrix_text(page, matrix), NULL);
        return;
    }
    const TinkerEquationLine *line = tinker_page_line_matrix(page, left, matrix->rows, matrix->columns);
    for (guint i = 0; i < matrix->rows * matrix->columns; i++)
        tinker_page_add_terms(page, g_ptr_array_index(line->matrix->cells, i), matrix->entries[i], NULL, 1,
                              matrix->dimension);
}

/* Headings and equations: aligned lines in a terminal, an align environment, a table of MathML. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "equations/write/break-latex.h"
#include "equations/write/latex-text.h"
#include "equations/write/page-private.h"
#include "units/quantity/units.h"

enum { LEFT, RIGHT, COMMENT, PARTS };

static const char html_head[] =
    "<!DOCTYPE html>\n<html lang=\"%s\">\n<head>\n<meta charset=\"utf-8\">\n<title>%s</title>\n<style>\n"
    ":root { color-scheme: light dark; }\nbody { font-family: sans-serif; margin: 2em auto; padding: 0 1em; max-width: "
    "60em; }\n"
    "math { font-size: 1.2em; }\ndiv.rows { overflow-x: auto; margin-bottom: 0.8em; }\n"
    "td { padding: 0.2em 0.25em; vertical-align: baseline; }\ntd:first-child { text-align: right; white-space: nowrap; "
    "}\n"
    "td:last-child { padding-left: 1.5em; }\n</style>\n</head>\n<body>\n<h1>%s</h1>\n";

static char *safe_text(const TinkerPage *page, const char *text)
{
    if (page->format == TINKER_TYPESET_LATEX) return tinker_latex_text(text);
    return page->format == TINKER_TYPESET_MATHML ? g_markup_escape_text(text, -1) : g_strdup(text);
}

void tinker_page_begin(TinkerPage *page, TinkerTypesetFormat format, const TinkerEquations *equations,
                       const char *title)
{
    *page =
        (TinkerPage){g_string_new(NULL), format, equations, g_ptr_array_new_with_free_func(g_free), NULL, -1, FALSE};
    g_autofree char *safe = safe_text(page, title);
    if (format == TINKER_TYPESET_LATEX)
        g_string_append_printf(page->text, "%s\\section*{%s}\n", tinker_latex_head, safe);
    else if (format == TINKER_TYPESET_MATHML)
        g_string_append_printf(page->text, html_head, C_("language of the page", "en"), safe, safe);
    else
        g_string_append_printf(page->text, "%s\n", safe);
}

/* Letters as they stand in a terminal: combining dots take no room. */
static int width_of(const char *text)
{
    int width = 0;
    for (const char *p = text; *p != '\0'; p = g_utf8_next_char(p))
        width += !g_unichar_iszerowidth(g_utf8_get_char(p));
    return width;
}

static const char *row_part(const TinkerPage *page, guint row, int part)
{
    return g_ptr_array_index(page->rows, PARTS * row + (guint)part);
}

#define WIDEST 60 /* equations beyond this do not push the comments of the others away */

/* Of its widest line. */
static int width_of_lines(const char *text)
{
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    int width = 0;
    for (int i = 0; lines[i] != NULL; i++)
        width = MAX(width, width_of(lines[i]));
    return width;
}

/* A matrix has the equals sign before its middle. */
static void append_equation(TinkerPage *page, guint row, int left)
{
    g_auto(GStrv) lines = g_strsplit(row_part(page, row, RIGHT), "\n", -1);
    const int count = (int)g_strv_length(lines), middle = (count - 1) / 2;
    const char *name = row_part(page, row, LEFT);
    for (int i = 0; i < count; i++)
        g_string_append_printf(page->text, "%s  %*s%s%s%s", i > 0 ? "\n" : "",
                               left - (i == middle ? width_of(name) : 0), "", i == middle ? name : "",
                               i == middle ? " = " : "   ", lines[i]);
}

static void flush_text(TinkerPage *page, guint rows)
{
    int left = 0, right = 0;
    for (guint i = 0; i < rows; i++) {
        left = MAX(left, width_of(row_part(page, i, LEFT)));
        const int width = width_of_lines(row_part(page, i, RIGHT));
        if (width <= WIDEST) right = MAX(right, width);
    }
    for (guint i = 0; i < rows; i++) {
        const char *comment = row_part(page, i, COMMENT), *value = row_part(page, i, RIGHT);
        append_equation(page, i, left);
        if (comment != NULL && width_of(value) > WIDEST)
            g_string_append_printf(page->text, "\n  %*s    %s", left, "", comment);
        else if (comment != NULL)
            g_string_append_printf(page->text, "%*s   %s", right - width_of(value), "", comment);
        g_string_append_c(page->text, '\n');
    }
}

/* Points, of a sheet of A4 on its side with 20 mm around it. */
#define PAPER        728.0
#define MOST_COMMENT 190.0
#define MOST_LEFT    150.0 /* what is longer on the left stands on the right, before its equals sign */
#define INDENT       20.0
#define GAPS         30.0 /* between columns, at least */

/* Beside an equation; a long one in several lines. */
static void add_latex_comment(TinkerPage *page, const char *comment)
{
    g_autofree char *safe = tinker_latex_text(comment);
    if (tinker_latex_text_width(comment) <= MOST_COMMENT)
        g_string_append_printf(page->text, " && \\text{%s}", safe);
    else
        g_string_append_printf(page->text, " && \\parbox[t]{%.0fpt}{\\raggedright %s}", MOST_COMMENT, safe);
}

/* What cannot be cut, as a long root, is made smaller. (transfer full) */
static char *fitted_line(const char *line, double most)
{
    const double width = tinker_latex_width(line);
    if (width <= most) return g_strdup(line);
    char factor[16];
    g_ascii_formatd(factor, sizeof factor, "%.2f", floor(100 * most / width) / 100);
    return g_strdup_printf("\\scalebox{%s}{$\\displaystyle %s$}", factor, line);
}

/* One equation, in as many lines as it needs. */
static void add_latex_row(TinkerPage *page, guint row, double most)
{
    const char *left = row_part(page, row, LEFT), *right = row_part(page, row, RIGHT);
    const char *comment = row_part(page, row, COMMENT);
    const gboolean long_left = tinker_latex_width(left) > MOST_LEFT;
    g_autofree char *all = long_left ? g_strconcat(left, "=", right, NULL) : g_strdup(right);
    g_autoptr(GPtrArray) lines = tinker_latex_lines(all, most);
    for (guint i = 0; i < lines->len; i++) {
        g_autofree char *line = fitted_line(g_ptr_array_index(lines, i), most);
        if (i > 0)
            g_string_append_printf(page->text, " \\\\\n&\\qquad{}%s", line);
        else if (long_left)
            g_string_append_printf(page->text, "&%s", line);
        else
            g_string_append_printf(page->text, "%s &= %s", left, line);
        if (i == 0 && comment != NULL) add_latex_comment(page, comment);
    }
}

static void flush_latex(TinkerPage *page, guint rows)
{
    double left = 0, comment = 0;
    for (guint i = 0; i < rows; i++) {
        const double width = tinker_latex_width(row_part(page, i, LEFT));
        if (width <= MOST_LEFT) left = MAX(left, width);
        const char *text = row_part(page, i, COMMENT);
        if (text != NULL) comment = MAX(comment, tinker_latex_text_width(text));
    }
    const double most = PAPER - left - MIN(comment, MOST_COMMENT) - GAPS - INDENT;
    g_string_append(page->text, "\\begin{align*}\n");
    for (guint i = 0; i < rows; i++) {
        add_latex_row(page, i, most);
        g_string_append(page->text, i + 1 < rows ? " \\\\\n" : "\n");
    }
    g_string_append(page->text, "\\end{align*}\n");
}

static void flush_mathml(TinkerPage *page, guint rows)
{
    g_string_append(page->text, "<div class=\"rows\"><table>\n");
    for (guint i = 0; i < rows; i++) {
        const char *comment = row_part(page, i, COMMENT);
        g_autofree char *safe = g_markup_escape_text(comment != NULL ? comment : "", -1);
        g_string_append_printf(page->text,
                               "<tr><td><math>%s</math></td><td><math displaystyle=\"true\"><mrow><mo>=</mo>%s"
                               "</mrow></math></td><td>%s</td></tr>\n",
                               row_part(page, i, LEFT), row_part(page, i, RIGHT), safe);
    }
    g_string_append(page->text, "</table></div>\n");
}

static void flush(TinkerPage *page)
{
    static void (*const write_rows[])(TinkerPage *, guint) = {flush_text, flush_latex, flush_mathml};
    if (page->rows->len > 0) write_rows[page->format](page, page->rows->len / PARTS);
    g_ptr_array_set_size(page->rows, 0);
}

void tinker_page_heading(TinkerPage *page, const char *heading)
{
    static const char *const forms[] = {"\n%s\n", "\\subsection*{%s}\n", "<h2>%s</h2>\n"};
    page->about = -1;
    page->in_state = FALSE;
    if (page->lines != NULL) {
        tinker_page_line_heading(page, heading);
        return;
    }
    flush(page);
    g_autofree char *safe = safe_text(page, heading);
    g_auto(GStrv) around = g_strsplit(forms[page->format], "%s", 2);
    g_string_append_printf(page->text, "%s%s%s", around[0], safe, around[1]);
}

void tinker_page_gap(TinkerPage *page)
{
    flush(page);
    if (page->format == TINKER_TYPESET_TEXT) g_string_append_c(page->text, '\n');
}

void tinker_page_equation(TinkerPage *page, char *left, char *right, char *comment)
{
    char *const parts[] = {left, right, comment};
    if (page->lines != NULL) {
        tinker_page_line(page, left, right, comment);
        return;
    }
    for (int i = 0; i < PARTS; i++)
        g_ptr_array_add(page->rows, parts[i]);
}

void tinker_page_equals(TinkerPage *page, char *left, const TinkerExpression *right, char *comment)
{
    if (page->lines == NULL || right->kind != TINKER_EXPRESSION_SUM) {
        tinker_page_equation(page, left, tinker_page_expression(page, right), comment);
        return;
    }
    tinker_page_line_sum(page, left, -1, comment);
    tinker_page_line_terms(page, page->about, TINKER_TERM_FORCE, right);
}

void tinker_page_vanishes(TinkerPage *page, const TinkerExpression *sum)
{
    g_autoptr(TinkerExpression) nothing = tinker_expression_number(0);
    char *zero = tinker_page_expression(page, nothing);
    if (page->lines != NULL)
        tinker_page_equals(page, zero, sum, NULL);
    else
        tinker_page_equation(page, tinker_page_expression(page, sum), zero, NULL);
}

char *tinker_page_end(TinkerPage *page)
{
    flush(page);
    g_ptr_array_unref(page->rows);
    if (page->format == TINKER_TYPESET_LATEX) g_string_append(page->text, "\\end{document}\n");
    if (page->format == TINKER_TYPESET_MATHML) g_string_append(page->text, "</body>\n</html>\n");
    return g_string_free(page->text, FALSE);
}

char *tinker_page_expression(const TinkerPage *page, const TinkerExpression *expression)
{
    return tinker_expression_typeset(expression, page->format, tinker_equations_look, (void *)page->equations);
}

char *tinker_page_factor(const TinkerPage *page, const TinkerExpression *expression)
{
    return tinker_expression_typeset_factor(expression, page->format, tinker_equations_look, (void *)page->equations);
}

static char *typeset_symbol(const TinkerPage *page, const TinkerSymbolLook *look)
{
    GString *text = g_string_new(NULL);
    tinker_symbol_typeset(text, look, page->format);
    return g_string_free(text, FALSE);
}

char *tinker_page_written(const TinkerPage *page, const char *stem, const char *index, int dots)
{
    return typeset_symbol(page, &(TinkerSymbolLook){stem, index, dots, NULL});
}

char *tinker_page_derivative(const TinkerPage *page, const char *name, int dots)
{
    TinkerSymbolLook look;
    tinker_equations_look(name, &look, (void *)page->equations);
    look.dots += dots;
    return typeset_symbol(page, &look);
}

char *tinker_page_symbol(const TinkerPage *page, const char *name)
{
    return tinker_page_derivative(page, name, 0);
}

/* "N m s^2" as the window has it, "N·m·s²". (transfer full) */
static char *unit_in_print(const TinkerPage *page, const char *unit)
{
    const gboolean latex = page->format == TINKER_TYPESET_LATEX;
    GString *text = g_string_new(unit);
    g_string_replace(text, "^2", latex ? "$^2$" : "²", 0);
    g_string_replace(text, "^3", latex ? "$^3$" : "³", 0);
    g_string_replace(text, " ", latex ? "$\\cdot$" : "·", 0);
    return g_string_free(text, FALSE);
}

/* (transfer full) */
static char *join_unit(const TinkerPage *page, const char *digits, const char *unit)
{
    if (page->format == TINKER_TYPESET_LATEX) return g_strdup_printf("%s\\,\\text{%s}", digits, unit);
    if (page->format == TINKER_TYPESET_MATHML) return g_strdup_printf("%s<mtext>&#xa0;%s</mtext>", digits, unit);
    return g_strdup_printf("%s %s", digits, unit);
}

static char *with_unit(const TinkerPage *page, double value, const char *unit)
{
    g_autoptr(TinkerExpression) number = tinker_expression_number(value);
    g_autofree char *safe = unit_in_print(page, unit), *digits = tinker_page_expression(page, number);
    return unit[0] == '\0' ? g_steal_pointer(&digits) : join_unit(page, digits, safe);
}

char *tinker_page_quantity(const TinkerPage *page, double value, TinkerDimension dimension)
{
    return with_unit(page, value, tinker_unit_si_symbol(dimension));
}

char *tinker_page_amount(const TinkerPage *page, double value, TinkerDimension dimension, gboolean energy)
{
    return with_unit(page, value, tinker_equation_unit(dimension, energy));
}

/* A unit as it was typed, whatever stands in it. (transfer full) */
static char *typed_unit(const TinkerPage *page, const char *typed)
{
    g_autofree char *safe = safe_text(page, typed);
    if (page->format != TINKER_TYPESET_LATEX) {
        g_strdelimit(safe, "*", ' ');
        return unit_in_print(page, safe);
    }
    GString *text = g_string_new(safe);
    g_string_replace(text, "\\^{}2", "$^2$", 0);
    g_string_replace(text, "\\^{}3", "$^3$", 0);
    g_string_replace(text, " ", "$\\cdot$", 0);
    g_string_replace(text, "*", "$\\cdot$", 0);
    return g_string_free(text, FALSE);
}

char *tinker_page_typed(const TinkerPage *page, const char *typed, double value, TinkerDimension dimension)
{
    g_autofree char *text = g_strstrip(g_strdup(typed));
    char *unit = NULL;
    TinkerUnit read;
    const double number = g_ascii_strtod(text, &unit);
    unit += strspn(unit, " ");
    g_autofree char *si = tinker_page_quantity(page, value, dimension);
    if (*unit == '\0' || !tinker_unit_parse(unit, &read, NULL)) return g_steal_pointer(&si);
    g_autoptr(TinkerExpression) amount = tinker_expression_number(number);
    g_autofree char *digits = tinker_page_expression(page, amount), *shown = typed_unit(page, unit);
    g_autofree char *as_typed = join_unit(page, digits, shown);
    if (read.factor == 1) return g_steal_pointer(&as_typed);
    return g_strconcat(as_typed, page->format == TINKER_TYPESET_MATHML ? "<mo>=</mo>" : " = ", si, NULL);
}

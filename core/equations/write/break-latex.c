/* LaTeX breaks no displayed formula by itself. Widths are those of Computer Modern, rounded up: a few points that are
 * lost at the end of a line do not show, and a line that runs off the paper does. */
#include "equations/write/break-latex.h"

#include <string.h>

/* Points. */
#define SMALL    0.75 /* of indices and exponents */
#define OPERATOR 12.5 /* with the space around it */
#define BRACKET  8.0  /* that grows with what it holds */
#define ROOT     9.0
#define BRACE    20.0 /* of cases, with the space between their columns */
#define LEAST    0.4  /* of a line: what would be shorter is rather broken within brackets */
#define COMMANDS 7.0  /* Greek letters, and what else is one sign */
#define TEXT     5.6  /* a letter of a text or of a function's name */

static double width_between(const char *at, const char *end);

static gboolean begins(const char *at, const char *end, const char *what)
{
    const gsize length = strlen(what);
    return (gsize)(end - at) >= length && strncmp(at, what, length) == 0;
}

/* Behind the brace that closes the one at `at`. */
static const char *group_end(const char *at, const char *end)
{
    int depth = 0;
    for (; at < end; at++) {
        if (*at == '\\' && at + 1 < end) {
            at++;
            continue;
        }
        depth += (*at == '{') - (*at == '}');
        if (depth == 0) return at + 1;
    }
    return end;
}

/* Of the next group, which is passed. */
static double take_group(const char **at, const char *end)
{
    if (*at >= end || **at != '{') return 0;
    const char *begin = *at + 1, *after = group_end(*at, end);
    *at = after;
    return width_between(begin, after - 1);
}

static double take_text(const char **at, const char *end)
{
    if (*at >= end || **at != '{') return 0;
    const char *after = group_end(*at, end);
    const double width = TEXT * (double)g_utf8_strlen(*at + 1, after - *at - 2);
    *at = after;
    return width;
}

#define MOST_COLUMNS 16
#define COLUMN       10.0 /* between the columns of a matrix */

/* Each column as wide as its widest entry. */
static double take_matrix(const char **at, const char *end)
{
    static const char closing[] = "\\end{bmatrix}";
    const char *cell = *at, *p = *at;
    double widths[MOST_COLUMNS] = {0}, sum = 2 * BRACKET;
    int column = 0;
    for (gboolean more = TRUE; more; p++) {
        const gboolean next_row = begins(p, end, "\\\\");
        more = p < end && !begins(p, end, closing);
        if (more && !next_row && *p != '&') continue;
        widths[column] = MAX(widths[column], width_between(cell, p) + COLUMN);
        column = next_row || !more ? 0 : MIN(column + 1, MOST_COLUMNS - 1);
        cell = p + (next_row ? 2 : 1);
        p += next_row;
    }
    for (int i = 0; i < MOST_COLUMNS; i++)
        sum += widths[i];
    *at = MIN(p - 1 + strlen(closing), end);
    return sum;
}

/* Two columns, as wide as their widest row. */
static double take_cases(const char **at, const char *end)
{
    static const char closing[] = "\\end{cases}";
    const char *row = *at, *p = *at;
    double widest = 0;
    int inner = 0;
    for (; p < end && (inner > 0 || !begins(p, end, closing)); p++) {
        inner += begins(p, end, "\\begin{cases}") - begins(p, end, closing);
        if (inner > 0 || !begins(p, end, "\\\\")) continue;
        widest = MAX(widest, width_between(row, p));
        row = p + 2;
    }
    widest = MAX(widest, width_between(row, p));
    *at = MIN(p + strlen(closing), end);
    return widest + BRACE;
}

/* What begins with a backslash. */
static double take_command(const char **at, const char *end)
{
    static const char *const spelled[] = {"sin", "cos", "tan", "sinh",   "cosh",   "tanh",   "exp",
                                          "min", "max", "ln",  "arcsin", "arccos", "arctan", NULL};
    const char *name = *at + 1;
    gsize length = 0;
    while (name + length < end && g_ascii_isalpha(name[length]))
        length++;
    if (length == 0) {
        *at = name + 1;
        return *name == ',' ? 1.7 : TEXT;
    }
    g_autofree char *command = g_strndup(name, length);
    *at = name + length;
    if (strcmp(command, "frac") == 0) {
        const double above = take_group(at, end), below = take_group(at, end);
        return MAX(above, below) + 2.5;
    }
    if (strcmp(command, "sqrt") == 0) return ROOT + take_group(at, end);
    if (strcmp(command, "dot") == 0 || strcmp(command, "ddot") == 0) return take_group(at, end);
    if (strcmp(command, "mathrm") == 0 || strcmp(command, "text") == 0 || strcmp(command, "operatorname") == 0)
        return take_text(at, end);
    if (strcmp(command, "begin") == 0) {
        const gboolean is_matrix = begins(*at, end, "{bmatrix}");
        *at = group_end(*at, end);
        return is_matrix ? take_matrix(at, end) : take_cases(at, end);
    }
    if (strcmp(command, "left") == 0 || strcmp(command, "right") == 0) {
        *at = MIN(*at + 1, end);
        return BRACKET;
    }
    if (strcmp(command, "cdot") == 0 || strcmp(command, "le") == 0 || strcmp(command, "ge") == 0) return OPERATOR;
    return g_strv_contains(spelled, command) ? TEXT * (double)length + 1.7 : COMMANDS;
}

/* The width of the next sign, group or command, which is passed. */
static double take(const char **at, const char *end)
{
    const char sign = **at;
    if (sign == '\\') return take_command(at, end);
    if (sign == '{') return take_group(at, end);
    if (sign == '_' || sign == '^') {
        ++*at;
        return *at < end ? SMALL * take(at, end) : 0;
    }
    *at = g_utf8_next_char(*at);
    if (strchr("+-=<>", sign) != NULL) return OPERATOR;
    if (sign == ' ') return 0;
    if (g_ascii_isdigit(sign) || sign == '(' || sign == ')') return 5;
    return strchr("mMW&", sign) != NULL ? 10.5 : g_ascii_isupper(sign) ? 8 : 6.3;
}

static double width_between(const char *at, const char *end)
{
    double width = 0;
    while (at < end)
        width += take(&at, end);
    return width;
}

double tinker_latex_width(const char *formula)
{
    return width_between(formula, formula + strlen(formula));
}

/* Where a line may end: before a sign. */
typedef struct {
    const char *at;
    int depth; /* of brackets around it, */
    int open;  /* and of those that grow */
    double width;
} Place;

/* The last of those that are in the fewest brackets, if it fills its line well. NULL for none. */
static const Place *best_place(const GArray *places, double most)
{
    const Place *best = NULL;
    for (guint i = 0; i < places->len; i++) {
        const Place *each = &g_array_index(places, Place, i);
        const gboolean fills = each->width >= LEAST * most;
        if (best == NULL || (fills && (each->depth <= best->depth || best->width < LEAST * most))) best = each;
    }
    return best;
}

/* Takes the text up to a place, with invisible brackets for those that stay open at an end. */
static void add_line(GPtrArray *lines, const char *begin, const char *end, int open_before, int open_behind)
{
    GString *line = g_string_new(NULL);
    for (int i = 0; i < open_before; i++)
        g_string_append(line, "\\left.");
    g_string_append_len(line, begin, end - begin);
    for (int i = 0; i < open_behind; i++)
        g_string_append(line, "\\right.");
    g_ptr_array_add(lines, g_string_free(line, FALSE));
}

GPtrArray *tinker_latex_lines(const char *formula, double most)
{
    GPtrArray *lines = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(Place));
    const char *end = formula + strlen(formula), *begin = formula, *at = formula;
    int depth = 0, grown = 0, open = 0;
    double width = 0;
    gboolean behind_operand = FALSE;
    while (at < end) {
        const char *token = at;
        const gboolean sign = strchr("+-=", *token) != NULL;
        if (sign && behind_operand) g_array_append_vals(places, &(Place){token, depth, grown, width}, 1);
        width += take(&at, end);
        const int grows = begins(token, end, "\\left") - begins(token, end, "\\right");
        const int deeper = grows + (*token == '(') - (*token == ')');
        grown += grows;
        depth += deeper;
        if (*token != ' ') behind_operand = !sign && deeper <= 0 && *token != ',';
        if (width <= most || places->len == 0) continue;
        const Place place = *best_place(places, most);
        add_line(lines, begin, place.at, open, place.open);
        begin = at = place.at;
        depth = place.depth;
        grown = open = place.open;
        width = 0;
        behind_operand = FALSE;
        g_array_set_size(places, 0);
    }
    add_line(lines, begin, end, open, grown);
    return lines;
}

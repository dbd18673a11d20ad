/* Sizes and places, from the leaves up: each node knows how wide it is and how far it reaches above and below the line
 * that its letters stand on. The proportions are those of D. E. Knuth, The TeXbook, appendix G, simplified. */
#include "render/formula/formula-private.h"

#include <math.h>
#include <string.h>

/* In sizes of letters. */
#define SCRIPT       0.72 /* the size of powers and indices */
#define LEAST_SCRIPT 8.0  /* canvas units */
#define NESTED       0.88 /* of a fraction within a fraction */
#define AROUND       0.28 /* beside a sign between terms */
#define AROUND_EQUAL 0.34
#define THIN         0.15 /* between factors */
#define FACTOR       0.12 /* around a dot that multiplies */
#define FRACTION_GAP 0.14 /* above and below the line of a fraction */
#define FRACTION_OUT 0.1  /* the line is so much longer at each end */
#define ROOT_GAP     0.12
#define ROOT_SIGN    0.62 /* the width of the root's hook */
#define DOT_ROOM     0.26 /* for dots above a letter */
#define RAISE        0.42
#define LOWER        0.2
#define BRACKET      0.34 /* the width of a bracket that has grown */
#define ORDINARY     1.02 /* how high a bracket is that has not */
#define ROW_GAP      0.35
#define COLUMN_GAP   0.8

static gboolean is_bracket(const FormulaNode *node)
{
    return node->kind == FORMULA_SIGN && node->text[0] != '\0' && strchr("(){|", node->text[0]) != NULL;
}

TinkerText formula_text(const FormulaNode *node)
{
    const gboolean slanted = node->kind == FORMULA_LETTER && g_utf8_strlen(node->text, -1) == 1;
    return (TinkerText){.text = node->text,
                        .size = node->size,
                        .face = slanted                       ? TINKER_FACE_LETTER
                                : node->kind == FORMULA_WORDS ? TINKER_FACE_PLAIN
                                                              : TINKER_FACE_FORMULA};
}

static void lay_out_text(FormulaNode *node, TinkerTextPen *pen)
{
    const TinkerText text = formula_text(node);
    if (strcmp(node->text, "\xe2\x81\xa2") == 0 || strcmp(node->text, "\xe2\x81\xa1") == 0) { /* times, applied to */
        g_clear_pointer(&node->text, g_free);
        node->text = g_strdup("");
        node->width = THIN * node->size;
        return;
    }
    tinker_text_measure_ink(pen, &text, &node->width, &node->above, &node->below);
    if (node->text[0] == '\0') node->above = node->below = 0;
}

/* What stands on both sides of a sign, by what it is and whether something stands before it. */
static double room_around(const FormulaNode *row, guint number)
{
    static const char *const equal[] = {"=", "<", ">", "≤", "≥", "≠", NULL};
    static const char *const between[] = {"+", "−", NULL};
    const FormulaNode *sign = formula_part(row, number);
    if (g_strv_contains(equal, sign->text)) return AROUND_EQUAL;
    const FormulaNode *before = number > 0 ? formula_part(row, number - 1) : NULL;
    const gboolean opens = before == NULL || (is_bracket(before) && before->text[0] != ')' && before->text[0] != '|');
    if (g_strv_contains(between, sign->text)) return opens ? 0 : AROUND;
    return strcmp(sign->text, "·") == 0 ? FACTOR : 0;
}

/* Brackets grow to what stands in their row, evenly about the axis. */
static void grow_brackets(FormulaNode *row)
{
    double reach = 0;
    const double axis = FORMULA_AXIS * row->size;
    for (guint i = 0; i < row->parts->len; i++) {
        const FormulaNode *part = formula_part(row, i);
        if (!is_bracket(part)) reach = fmax(reach, fmax(part->above - axis, part->below + axis));
    }
    for (guint i = 0; i < row->parts->len; i++) {
        FormulaNode *part = formula_part(row, i);
        if (!is_bracket(part) || (2 * reach < ORDINARY * row->size && part->text[0] != '{')) continue;
        part->grown = TRUE;
        part->width = BRACKET * row->size;
        part->above = reach + axis;
        part->below = reach - axis;
    }
}

static void lay_out_row(FormulaNode *row)
{
    double x = 0;
    grow_brackets(row);
    for (guint i = 0; i < row->parts->len; i++) {
        FormulaNode *part = formula_part(row, i);
        const double around = part->kind == FORMULA_SIGN ? room_around(row, i) * row->size : 0;
        const FormulaNode *next = i + 1 < row->parts->len ? formula_part(row, i + 1) : NULL;
        /* nothing between a function and its bracket */
        if (part->kind == FORMULA_SIGN && part->text[0] == '\0' && next != NULL && is_bracket(next)) part->width = 0;
        part->x = x + around;
        x = part->x + part->width + around;
        if (part->kind == FORMULA_SIGN && strcmp(part->text, ",") == 0) x += THIN * row->size;
        row->above = fmax(row->above, part->above - part->y);
        row->below = fmax(row->below, part->below + part->y);
    }
    row->width = x;
}

static void lay_out_fraction(FormulaNode *node)
{
    FormulaNode *over = formula_part(node, 0), *under = formula_part(node, 1);
    const double axis = FORMULA_AXIS * node->size, gap = FRACTION_GAP * node->size;
    const double widest = fmax(over->width, under->width), out = FRACTION_OUT * node->size;
    node->width = widest + 4 * out;
    over->x = 2 * out + (widest - over->width) / 2;
    under->x = 2 * out + (widest - under->width) / 2;
    over->y = -(axis + gap + over->below);
    under->y = -axis + gap + under->above;
    node->above = over->above - over->y;
    node->below = under->y + under->below;
}

static void lay_out_script(FormulaNode *node, guint number, gboolean raised)
{
    FormulaNode *base = formula_part(node, 0), *script = formula_part(node, number);
    script->x = base->width + 0.04 * node->size;
    script->y = raised
                    ? -fmax(RAISE * node->size, base->above - 0.55 * script->above)
                    : fmax(LOWER * node->size, base->below + (base->above > 1.2 * node->size ? 0.1 * node->size : 0));
    node->width = fmax(node->width, script->x + script->width);
    node->above = fmax(node->above, script->above - script->y);
    node->below = fmax(node->below, script->below + script->y);
}

static void lay_out_scripts(FormulaNode *node)
{
    const FormulaNode *base = formula_part(node, 0);
    node->width = base->width;
    node->above = base->above;
    node->below = base->below;
    for (guint i = 1; i < node->parts->len; i++)
        lay_out_script(node, i, node->kind == FORMULA_POWER || i == 2);
}

static void lay_out_root(FormulaNode *node)
{
    lay_out_row(node);
    const double sign = ROOT_SIGN * node->size;
    for (guint i = 0; i < node->parts->len; i++)
        formula_part(node, i)->x += sign;
    node->width += sign + 0.1 * node->size;
    node->above += ROOT_GAP * node->size + FORMULA_RULE * node->size;
    node->below = fmax(node->below, 0.02 * node->size) + FORMULA_RULE * node->size;
}

/* Dots are drawn, not written. */
static void lay_out_accent(FormulaNode *node)
{
    const FormulaNode *base = formula_part(node, 0);
    node->width = base->width;
    node->above = base->above + DOT_ROOM * node->size;
    node->below = base->below;
}

static void lay_out_table(FormulaNode *table)
{
    double widths[8] = {0}, y = 0;
    for (guint i = 0; i < table->parts->len; i++)
        for (guint k = 0; k < formula_part(table, i)->parts->len && k < G_N_ELEMENTS(widths); k++)
            widths[k] = fmax(widths[k], formula_part(formula_part(table, i), k)->width);
    for (guint i = 0; i < table->parts->len; i++) {
        FormulaNode *row = formula_part(table, i);
        double x = 0;
        row->above = row->below = 0;
        for (guint k = 0; k < row->parts->len && k < G_N_ELEMENTS(widths); k++) {
            FormulaNode *cell = formula_part(row, k);
            cell->x = x;
            x += widths[k] + COLUMN_GAP * table->size;
            row->above = fmax(row->above, cell->above);
            row->below = fmax(row->below, cell->below);
        }
        row->y = y + row->above;
        row->width = x - COLUMN_GAP * table->size;
        table->width = fmax(table->width, row->width);
        y = row->y + row->below + ROW_GAP * table->size;
    }
    y -= ROW_GAP * table->size;
    table->above = y / 2 + FORMULA_AXIS * table->size;
    table->below = y - table->above;
    for (guint i = 0; i < table->parts->len; i++)
        formula_part(table, i)->y -= table->above;
}

/* What a part's letters have of its parent's size. */
static double size_of_part(const FormulaNode *node, guint number)
{
    const gboolean scripts = node->kind == FORMULA_POWER || node->kind == FORMULA_INDEX || node->kind == FORMULA_BOTH;
    if (scripts && number > 0) return fmin(node->size, fmax(SCRIPT * node->size, LEAST_SCRIPT));
    return node->kind == FORMULA_FRACTION ? NESTED * node->size : node->size;
}

void formula_lay_out(FormulaNode *node, TinkerTextPen *pen, double size)
{
    node->size = size;
    for (guint i = 0; i < node->parts->len; i++)
        formula_lay_out(formula_part(node, i), pen, size_of_part(node, i));
    switch (node->kind) {
    case FORMULA_LETTER:
    case FORMULA_DIGITS:
    case FORMULA_SIGN:
    case FORMULA_WORDS:
        lay_out_text(node, pen);
        break;
    case FORMULA_FRACTION:
        lay_out_fraction(node);
        break;
    case FORMULA_POWER:
    case FORMULA_INDEX:
    case FORMULA_BOTH:
        lay_out_scripts(node);
        break;
    case FORMULA_ROOT:
        lay_out_root(node);
        break;
    case FORMULA_ACCENT:
        lay_out_accent(node);
        break;
    case FORMULA_TABLE:
        lay_out_table(node);
        break;
    case FORMULA_TABLE_ROW:
        break; /* with its table */
    case FORMULA_ROW:
    case FORMULA_CELL:
        lay_out_row(node);
        break;
    }
}

/* Nodes as ink. */
#include <math.h>
#include <string.h>

#include "render/formula/formula-private.h"

/* In sizes of letters. */
#define DOT       0.07 /* the radius of a derivative's dot */
#define DOT_APART 0.13 /* half of what two dots are apart */
#define DOT_ABOVE 0.15 /* a letter's ink */
#define STROKE    0.07 /* of brackets and roots */

static void draw_bracket(const FormulaNode *node, cairo_t *cairo, double x, double y)
{
    const double top = y - node->above, bottom = y + node->below, middle = (top + bottom) / 2;
    const double near = x + 0.8 * node->width, far = x + 0.2 * node->width;
    const gboolean closes = node->text[0] == ')';
    const double ends = closes ? far : near, bow = closes ? near : far;
    switch (node->text[0]) {
    case '|':
        cairo_move_to(cairo, x + node->width / 2, top);
        cairo_line_to(cairo, x + node->width / 2, bottom);
        break;
    case '{': {
        const double spine = x + node->width / 2, curl = 0.3 * node->size;
        cairo_move_to(cairo, near, top);
        cairo_curve_to(cairo, spine, top, spine, top, spine, top + curl);
        cairo_line_to(cairo, spine, middle - curl);
        cairo_curve_to(cairo, spine, middle, spine, middle, x, middle);
        cairo_curve_to(cairo, spine, middle, spine, middle, spine, middle + curl);
        cairo_line_to(cairo, spine, bottom - curl);
        cairo_curve_to(cairo, spine, bottom, spine, bottom, near, bottom);
        break;
    }
    default: {
        const double out = bow + (bow - ends) / 3; /* the curve's middle then lies on the bow */
        cairo_move_to(cairo, ends, top);
        cairo_curve_to(cairo, out, top + 0.25 * (bottom - top), out, bottom - 0.25 * (bottom - top), ends, bottom);
        break;
    }
    }
    cairo_set_line_width(cairo, STROKE * node->size);
    cairo_stroke(cairo);
}

static void draw_root(const FormulaNode *node, cairo_t *cairo, double x, double y)
{
    const double size = node->size, top = y - node->above + FORMULA_RULE * size;
    cairo_set_line_width(cairo, FORMULA_RULE * size);
    cairo_move_to(cairo, x + 0.08 * size, y - 0.28 * size);
    cairo_line_to(cairo, x + 0.2 * size, y - 0.36 * size);
    cairo_line_to(cairo, x + 0.36 * size, y + node->below - FORMULA_RULE * size);
    cairo_line_to(cairo, x + 0.56 * size, top);
    cairo_line_to(cairo, x + node->width, top);
    cairo_stroke(cairo);
}

static void draw_dots(const FormulaNode *node, cairo_t *cairo, double x, double y)
{
    const FormulaNode *base = formula_part(node, 0);
    const double slant =
        base->kind == FORMULA_LETTER ? 0.06 * node->size : 0; /* a slanted letter's top is to the right */
    const double middle = x + base->width / 2 + slant, height = y - base->above - DOT_ABOVE * node->size;
    const gboolean two = strcmp(formula_part(node, 1)->text, "¨") == 0;
    for (int i = two ? -1 : 0; i <= 1; i += two ? 2 : 4) {
        cairo_arc(cairo, middle + i * DOT_APART * node->size, height, DOT * node->size, 0, 2 * G_PI);
        cairo_fill(cairo);
    }
}

static void draw_node(const FormulaNode *node, TinkerTextPen *pen, cairo_t *cairo, double x, double y)
{
    const gboolean accent = node->kind == FORMULA_ACCENT;
    if (node->grown) {
        draw_bracket(node, cairo, x, y);
    } else if (node->text[0] != '\0') {
        const TinkerText text = formula_text(node);
        tinker_text_draw_on_line(pen, cairo, &text, x, y);
    }
    if (node->kind == FORMULA_FRACTION) {
        cairo_set_line_width(cairo, FORMULA_RULE * node->size);
        cairo_move_to(cairo, x + 0.1 * node->size, y - FORMULA_AXIS * node->size);
        cairo_line_to(cairo, x + node->width - 0.1 * node->size, y - FORMULA_AXIS * node->size);
        cairo_stroke(cairo);
    }
    if (node->kind == FORMULA_ROOT) draw_root(node, cairo, x, y);
    if (accent) draw_dots(node, cairo, x, y);
    for (guint i = 0; i < (accent ? 1 : node->parts->len); i++) {
        const FormulaNode *part = formula_part(node, i);
        draw_node(part, pen, cairo, x + part->x, y + part->y);
    }
}

TinkerMathText *tinker_math_text_new(const char *mathml, double size, GError **error)
{
    FormulaNode *root = formula_read(mathml, error);
    if (root == NULL) return NULL;
    TinkerMathText *formula = g_new0(TinkerMathText, 1);
    formula->root = root;
    formula->pen = (TinkerTextPen)TINKER_TEXT_PEN_INIT;
    formula_lay_out(root, &formula->pen, size);
    return formula;
}

void tinker_math_text_free(TinkerMathText *formula)
{
    tinker_text_pen_clear(&formula->pen);
    formula_node_free(formula->root);
    g_free(formula);
}

void tinker_math_text_measure(const TinkerMathText *formula, double *width, double *above, double *below)
{
    *width = formula->root->width;
    *above = formula->root->above;
    *below = formula->root->below;
}

void tinker_math_text_draw(const TinkerMathText *formula, cairo_t *cairo, double x, double y)
{
    TinkerTextPen pen = formula->pen; /* its layout is made by now */
    cairo_save(cairo);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_BEVEL);
    draw_node(formula->root, &pen, cairo, x, y);
    cairo_restore(cairo);
}

/* What reading, layout and drawing of a formula share. */
#ifndef TINKER_RENDER_FORMULA_PRIVATE_H
#define TINKER_RENDER_FORMULA_PRIVATE_H

#include "render/formula/formula.h"

typedef enum {
    FORMULA_ROW,
    FORMULA_LETTER, /* mi: one letter is slanted, several are upright */
    FORMULA_DIGITS,
    FORMULA_SIGN,
    FORMULA_WORDS,
    FORMULA_FRACTION,
    FORMULA_POWER,
    FORMULA_INDEX,
    FORMULA_BOTH, /* an index, and a power above it */
    FORMULA_ROOT,
    FORMULA_ACCENT,
    FORMULA_TABLE,
    FORMULA_TABLE_ROW,
    FORMULA_CELL,
} FormulaKind;

typedef struct _FormulaNode FormulaNode;
struct _FormulaNode {
    FormulaKind kind;
    char *text;       /* of what has no parts */
    GPtrArray *parts; /* of FormulaNode */

    double size;                /* of its letters */
    double x, y;                /* of its left end on the line, from its parent's; y downwards */
    double width, above, below; /* above and below its line */
    gboolean grown;             /* a bracket that is as high as above and below say */
};

/* (transfer full) */
FormulaNode *formula_read(const char *mathml, GError **error);
void formula_node_free(FormulaNode *node);

void formula_lay_out(FormulaNode *node, TinkerTextPen *pen, double size);

/* Proportions, in sizes of letters. */
#define FORMULA_AXIS 0.29 /* the line of fractions above the line of letters */
#define FORMULA_RULE 0.05 /* its thickness */

static inline FormulaNode *formula_part(const FormulaNode *node, guint number)
{
    return (FormulaNode *)g_ptr_array_index(node->parts, number);
}

/* How a text of this node is written. */
TinkerText formula_text(const FormulaNode *node);

struct _TinkerMathText {
    FormulaNode *root;
    TinkerTextPen pen;
};

#endif

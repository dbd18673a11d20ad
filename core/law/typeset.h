/* Expressions written for people: as a line of text, as LaTeX, as MathML. */
#ifndef TINKER_CORE_LAW_TYPESET_H
#define TINKER_CORE_LAW_TYPESET_H

#include "units/expression-tree.h"

typedef enum { TINKER_TYPESET_TEXT, TINKER_TYPESET_LATEX, TINKER_TYPESET_MATHML } TinkerTypesetFormat;

/* How a symbol looks: "x" with the index "1" and one dot is x₁ with a dot over it. */
typedef struct {
    const char *stem;  /* "x", "L0", "θ" */
    const char *index; /* "" for none */
    int dots;
    const char *component; /* "x" of a force's component, behind the index; NULL: none */
} TinkerSymbolLook;

typedef void (*TinkerLookFunc)(const char *symbol, TinkerSymbolLook *look, void *data);

/* Numbers have six significant digits. (transfer full) */
char *tinker_expression_typeset(const TinkerExpression *expression, TinkerTypesetFormat format, TinkerLookFunc look,
                                void *data);

/* One symbol, appended. */
void tinker_symbol_typeset(GString *text, const TinkerSymbolLook *look, TinkerTypesetFormat format);

#endif

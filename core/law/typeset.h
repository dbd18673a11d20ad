/* Expressions written for people: as a line of text, as LaTeX, as MathML, as it is read out. */
#ifndef TINKER_CORE_LAW_TYPESET_H
#define TINKER_CORE_LAW_TYPESET_H

#include "units/expression/expression-tree.h"

typedef enum {
    TINKER_TYPESET_TEXT,
    TINKER_TYPESET_LATEX,
    TINKER_TYPESET_MATHML,
    TINKER_TYPESET_SPEECH
} TinkerTypesetFormat;

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

/* The same as a factor of something: a sum stands in brackets. (transfer full) */
char *tinker_expression_typeset_factor(const TinkerExpression *expression, TinkerTypesetFormat format,
                                       TinkerLookFunc look, void *data);
/* As a term of a sum: with its sign, plus or minus, unless it is the first and positive. (transfer full) */
char *tinker_expression_typeset_term(const TinkerExpression *expression, gboolean first, TinkerTypesetFormat format,
                                     TinkerLookFunc look, void *data);

/* What stands between terms, '+' and '-', and between factors, '*'. Static. */
const char *tinker_typeset_sign(TinkerTypesetFormat format, char sign);

/* A Greek letter's name in LaTeX, "theta"; NULL where the letter is none. Static. */
const char *tinker_greek_name(const char *letter);

/* A symbol's square. (transfer full) */
char *tinker_symbol_squared(const TinkerSymbolLook *look, TinkerTypesetFormat format);

/* One symbol, appended. */
void tinker_symbol_typeset(GString *text, const TinkerSymbolLook *look, TinkerTypesetFormat format);

#endif

/* What the three formats share. */
#ifndef TINKER_CORE_LAW_TYPESET_PRIVATE_H
#define TINKER_CORE_LAW_TYPESET_PRIVATE_H

#include "law/typeset.h"

/* How tightly a node binds; one that binds less than its place asks for stands in brackets. */
typedef enum {
    TINKER_BINDS_COMPARISON,
    TINKER_BINDS_SUM,
    TINKER_BINDS_SIGN,
    TINKER_BINDS_PRODUCT,
    TINKER_BINDS_POWER,
    TINKER_BINDS_ATOM,
} TinkerBinding;

/* What differs between formats. Each part writes itself into the text. */
typedef struct {
    const char *open, *close;   /* brackets, */
    const char *high[2];        /* and around what is higher than a line; NULL: the same */
    const char *plus, *minus;   /* between terms */
    const char *sign;           /* before one */
    const char *times;          /* between factors, */
    const char *times_number;   /* and before one that begins with a digit, */
    const char *times_function; /* or with a function's name; NULL: as the first */
    const char *comma;          /* between arguments */
    gboolean stacked;           /* fractions and roots are drawn, and need no brackets */
    const char *group[2];       /* around what is one thing to the format */
    const char *fraction[3];    /* before, between, behind; of a stacked one */
    const char *power[3];       /* likewise */
    const char *raised[10];     /* powers of 0 to 9 that are written behind what they are of; NULL: this one is not */
    /* Puts an exponent on the symbol that is written from `symbol` on, over its index; NULL: as on anything else. */
    void (*raise)(GString *text, gsize symbol, const char *exponent);
    const char *root[2], *absolute[2];
    const char *cases[4]; /* before; between value and condition; behind it; behind all */
    const char *otherwise;
    void (*number)(GString *text, double number);
    void (*symbol)(GString *text, const TinkerSymbolLook *look);
    void (*function)(GString *text, const char *name);
    void (*compare)(GString *text, const char *sign);
} TinkerTypesetStyle;

extern const TinkerTypesetStyle tinker_text_style, tinker_latex_style, tinker_mathml_style;

/* What is read out has words that belong to a language. */
const TinkerTypesetStyle *tinker_speech_style(void);
/* Takes out spaces and pauses that come twice, or at an end. */
void tinker_speech_tidy(GString *text);

/* "12.5", "1.2e-05", without the format's own form of powers of ten. */
void tinker_typeset_digits(char digits[32], double number);

/* Takes the power of ten off the digits of a number, "1.2e-05" is 1.2 and -5; FALSE where it has none. */
gboolean tinker_typeset_power(char digits[32], int *power);

/* "<=" as a sign: "≤". */
const char *tinker_typeset_comparison(const char *sign);

/* Bytes of a stem before its index: "L0" is L with the index 0, "μd" μ with the index d, "theta" a word. */
gsize tinker_stem_letters(const char *stem);

#endif

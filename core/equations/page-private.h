/* A page of headings and equations in one of the formats. */
#ifndef TINKER_CORE_EQUATIONS_PAGE_PRIVATE_H
#define TINKER_CORE_EQUATIONS_PAGE_PRIVATE_H

#include "equations/equations.h"

typedef struct {
    GString *text;
    TinkerTypesetFormat format;
    const TinkerEquations *equations;
    GPtrArray *rows; /* of char *: left, right and comment of equations that have not been written yet */
} TinkerPage;

void tinker_page_begin(TinkerPage *page, TinkerTypesetFormat format, const TinkerEquations *equations,
                       const char *title);
void tinker_page_heading(TinkerPage *page, const char *heading);

/* left = right, and what it is; all are taken over. `comment` is plain text, and may be NULL. */
void tinker_page_equation(TinkerPage *page, char *left, char *right, char *comment);

/* Ends a block of equations that are aligned with each other. */
void tinker_page_gap(TinkerPage *page);

/* Adds the names that an expression needs (const char *, interned). */
void tinker_equations_mark(const TinkerEquations *equations, const TinkerExpression *expression, GHashTable *needed);

/* The definitions that these names need, then the values of symbols. */
void tinker_page_names(TinkerPage *page, GHashTable *needed, gboolean values);

/* (transfer full) */
char *tinker_page_end(TinkerPage *page);

/* In the page's format. (transfer full) */
char *tinker_page_expression(const TinkerPage *page, const TinkerExpression *expression);
char *tinker_page_symbol(const TinkerPage *page, const char *name);
/* The symbol with so many dots more. */
char *tinker_page_derivative(const TinkerPage *page, const char *name, int dots);
/* A number with its unit. */
char *tinker_page_quantity(const TinkerPage *page, double value, TinkerDimension dimension);

#endif

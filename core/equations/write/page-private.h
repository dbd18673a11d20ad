/* A page of headings and equations in one of the formats. */
#ifndef TINKER_CORE_EQUATIONS_PAGE_PRIVATE_H
#define TINKER_CORE_EQUATIONS_PAGE_PRIVATE_H

#include "equations/write/lines.h"
#include "equations/write/write.h"

typedef struct {
    GString *text;
    TinkerTypesetFormat format;
    const TinkerEquations *equations;
    GPtrArray *rows;     /* of char *: left, right and comment of equations that have not been written yet */
    GPtrArray *lines;    /* of TinkerEquationLine: where they go instead (lines.h), without a text; or NULL */
    TinkerBlockId about; /* whose the next equations are; -1: nobody's, as after each heading */
    gboolean in_state;   /* the heading before them is that of tinker_page_state */
} TinkerPage;

void tinker_page_begin(TinkerPage *page, TinkerTypesetFormat format, const TinkerEquations *equations,
                       const char *title);
void tinker_page_heading(TinkerPage *page, const char *heading);

/* left = right, and what it is; all are taken over. `comment` is plain text, and may be NULL. */
void tinker_page_equation(TinkerPage *page, char *left, char *right, char *comment);

/* left = right, of which the summands may stand in several lines; `left` and `comment` are taken over. */
void tinker_page_equals(TinkerPage *page, char *left, const TinkerExpression *right, char *comment);

/* sum = 0; as lines, which break on the right alone, 0 = sum. */
void tinker_page_vanishes(TinkerPage *page, const TinkerExpression *sum);

/* Equations as lines of a page, in place of its text; page-lines.c. A sum has its terms added, of each block all
 * summands one by one: between any two the line may break. */
GPtrArray *tinker_page_lines_new(void);
void tinker_page_line_heading(TinkerPage *page, const char *heading);
void tinker_page_line(TinkerPage *page, char *left, char *right, char *comment);
void tinker_page_line_sum(TinkerPage *page, char *left, int component, char *comment);
void tinker_page_line_terms(TinkerPage *page, TinkerBlockId block, TinkerTermKind kind,
                            const TinkerExpression *expression);

/* A line with terms on both sides, none yet; one with a matrix, whose cells have none yet. Borrowed. */
TinkerEquationLine *tinker_page_line_balance(TinkerPage *page);
TinkerEquationLine *tinker_page_line_matrix(TinkerPage *page, char *left, guint rows, guint columns);

/* A matrix, or a vector, by rows. */
typedef struct {
    guint rows, columns;
    const TinkerExpression *const *entries;
    TinkerDimension dimension;
} TinkerPageMatrix;

/* left = matrix, in brackets; `left` is taken over. write-entries.c. */
void tinker_page_matrix(TinkerPage *page, char *left, const TinkerPageMatrix *matrix);
/* Adds the summands of factor times variable (NULL: 1) as terms, each of the block that its symbols are of, what acts
 * before what it acts on; the value of them all, times that of the variable, goes to the first, unless it is the number
 * 0. write-entries.c. */
void tinker_page_add_terms(const TinkerPage *page, GArray *terms, const TinkerExpression *factor, const char *variable,
                           double variable_value, TinkerDimension dimension);
/* "M", "C", "K". */
extern const char *const page_matrix_letters[TINKER_MATRICES];
/* The entries of a matrix that is too large to be written, by their kinds; write-patterns.c. */
void tinker_page_pattern(TinkerPage *page, const TinkerMatrixIsland *island, TinkerMatrixKind kind);

/* What the writers of write.h put between a page's beginning and its end. */
void tinker_equations_put_newton(TinkerPage *page, const TinkerEquationsShown *shown);
void tinker_equations_put_matrix(TinkerPage *page, const TinkerMatrixForm *form, const TinkerEquationsShown *shown);
void tinker_equations_put_angles(TinkerPage *page, const TinkerAngleForm *form, const TinkerEquationsShown *shown);

/* Ends a block of equations that are aligned with each other. */
void tinker_page_gap(TinkerPage *page);

/* The definitions that these names need, then the values of symbols: first those that are given, then those at the
 * time. */
void tinker_page_names(TinkerPage *page, GHashTable *needed);

/* A symbol's value at the time, below a heading that says which time; strings are as of tinker_page_equation. */
void tinker_page_state(TinkerPage *page, TinkerBlockId block, char *symbol, char *value, char *comment);

/* (transfer full) */
char *tinker_page_end(TinkerPage *page);

/* In the page's format. (transfer full) */
char *tinker_page_expression(const TinkerPage *page, const TinkerExpression *expression);
/* As a factor of something. (transfer full) */
char *tinker_page_factor(const TinkerPage *page, const TinkerExpression *expression);
char *tinker_page_symbol(const TinkerPage *page, const char *name);
/* A symbol that the page makes: a stem with an index, perhaps "", and dots. */
char *tinker_page_written(const TinkerPage *page, const char *stem, const char *index, int dots);
/* The symbol with so many dots more. */
char *tinker_page_derivative(const TinkerPage *page, const char *name, int dots);
/* A number with its unit. */
char *tinker_page_quantity(const TinkerPage *page, double value, TinkerDimension dimension);
/* Of what may be a torque or an energy: in N m or in J. */
char *tinker_page_amount(const TinkerPage *page, double value, TinkerDimension dimension, gboolean energy);
/* A number as it was typed with its unit, and where that is none of SI's own its value in SI as well. (transfer full)
 */
char *tinker_page_typed(const TinkerPage *page, const char *typed, double value, TinkerDimension dimension);

/* What stands behind a symbol, in the words of the locale. Borrowed. */
const char *tinker_page_words(const char *english);
/* Which property a symbol is the value of: its label where the locale has one, else the words of its key. (transfer
 * full) */
char *tinker_page_property_words(const TinkerEquations *equations, const TinkerEquationSymbol *symbol);

#endif

/* Equations line by line and term by term, for who shows them in parts: each term knows the block that it comes from.
 */
#ifndef TINKER_CORE_EQUATION_LINES_H
#define TINKER_CORE_EQUATION_LINES_H

#include "equations/write/write.h"

/* What is added up on the right of a line; all of it where the line is no sum of forces. */
typedef struct {
    char *text;          /* in the format; of all but the first with the sign before it */
    TinkerBlockId block; /* -1: of none */
    TinkerTermKind kind; /* of a body's equation */
    gboolean follows;    /* one value with the term before it, which has it */
    gboolean has_value;  /* of what is linear, at the time of the equations: */
    double value;
    TinkerDimension dimension;
} TinkerLineTerm;

/* Entries by rows, each what is added up in it. */
typedef struct {
    guint rows, columns;
    GPtrArray *cells; /* of GArray of TinkerLineTerm */
} TinkerLineMatrix;

typedef struct {
    char *heading;       /* NULL: an equation, with all that follows */
    TinkerBlockId block; /* whose it is: a body, or the block of a law; -1: of none */
    int component;       /* of a body's equation: 0 and 1 forces in x and y, 2 torques; else -1 */
    char *left;
    GArray *left_terms;       /* of TinkerLineTerm: in the place of `left`; or NULL */
    GArray *terms;            /* of TinkerLineTerm */
    TinkerLineMatrix *matrix; /* on the right, in the place of terms; or NULL */
    char *comment;            /* plain text, or NULL */
} TinkerEquationLine;

/* Newton's equations, or of `matrix` or `angles` where one is given, as the writers of write.h put them. Lines are the
 * same in every format. Element: TinkerEquationLine *. (transfer full) */
GPtrArray *tinker_equations_lines(const TinkerEquations *equations, const TinkerMatrixForm *matrix,
                                  const TinkerAngleForm *angles, const TinkerEquationsShown *shown);

#endif

/* Equations for people: a text for the terminal, a document of LaTeX, a page with MathML. */
#ifndef TINKER_CORE_EQUATIONS_WRITE_H
#define TINKER_CORE_EQUATIONS_WRITE_H

#include "equations/angles/angles.h"
#include "equations/matrix/matrix.h"
#include "equations/newton/equations.h"

typedef struct {
    TinkerTypesetFormat format;
    const char *title;
    const TinkerBlockId *blocks; /* of bodies that are shown, ended by -1; NULL: all */
    gboolean values;             /* with the numbers at the time */
} TinkerEquationsShown;

/* Newton's equations: of each body, with the laws of its terms, constraints, and what the symbols stand for; or, where
 * one is given, of `matrix` linear islands with their matrices, of one coordinate as the textbook has it, with its
 * frequency, or of `angles` trees of rods in their angles. (transfer full) */
char *tinker_equations_write(const TinkerEquations *equations, const TinkerMatrixForm *matrix,
                             const TinkerAngleForm *angles, const TinkerEquationsShown *shown);

#endif

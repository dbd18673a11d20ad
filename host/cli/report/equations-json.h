/* Equations as JSON, complete enough to be worked out by others: docs/reference/equations.md. */
#ifndef TINKER_CLI_EQUATIONS_JSON_H
#define TINKER_CLI_EQUATIONS_JSON_H

#include "equations/angles/angles.h"
#include "equations/matrix/matrix.h"
#include "equations/newton/equations.h"

/* The forces on these bodies (ended by -1; NULL: on all). (transfer full, g_free) */
char *tinker_equations_json(const TinkerEquations *equations, const TinkerBlockId *blocks);

/* The linear islands with matrices. (transfer full, g_free) */
char *tinker_equations_matrix_json(const TinkerEquations *equations, const TinkerMatrixForm *form);

/* Trees of rods in their angles. (transfer full, g_free) */
char *tinker_equations_angles_json(const TinkerEquations *equations, const TinkerAngleForm *form);

#endif

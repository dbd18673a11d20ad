/* Linear solves with symmetric matrices whose pattern never changes: by a band where there is a narrow one (a chain),
 * else by the sparse factor of sparse-ldl.h. */
#ifndef TINKER_NUMERICS_SYMMETRIC_SOLVER_H
#define TINKER_NUMERICS_SYMMETRIC_SOLVER_H

#include <glib.h>

#include <tinker/integrator.h>

typedef enum {
    TINKER_SOLVER_FITTING, /* what suits the pattern */
    TINKER_SOLVER_BANDED,
    TINKER_SOLVER_SPARSE,
} TinkerSolverKind;

typedef struct _TinkerSymmetricSolver TinkerSymmetricSolver;

/* The pattern is borrowed. NULL where the factor would be too large. (transfer full) */
TinkerSymmetricSolver *tinker_symmetric_solver_new(const TinkerPattern *pattern, TinkerSolverKind kind);
void tinker_symmetric_solver_free(TinkerSymmetricSolver *solver);

/* TINKER_SOLVER_BANDED or TINKER_SOLVER_SPARSE. */
TinkerSolverKind tinker_symmetric_solver_kind(const TinkerSymmetricSolver *solver);

/* Factors the symmetric part (A + A^T) / 2 of the values, which are in the order of the pattern. FALSE where a pivot
 * vanishes; a sparse one also where a diagonal entry is not positive. */
gboolean tinker_symmetric_solver_factor(TinkerSymmetricSolver *solver, const double *values);

/* Solves with the last factor, in place. */
void tinker_symmetric_solver_solve(TinkerSymmetricSolver *solver, double *b);

#endif

/* The derivatives of a model's applied forces, as sparse matrices over its coordinates. */
#ifndef TINKER_CORE_JACOBIAN_H
#define TINKER_CORE_JACOBIAN_H

#include <tinker/integrator.h>

#include "physics/model/model.h"

typedef struct _TinkerJacobian TinkerJacobian;

/* Works the pattern out once. The model is borrowed. (transfer full) */
TinkerJacobian *tinker_jacobian_new(TinkerModel *model);
void tinker_jacobian_free(TinkerJacobian *jacobian);

/* 2 coordinates a body. Borrowed. */
const TinkerPattern *tinker_jacobian_pattern(const TinkerJacobian *jacobian);

/* stiffness = -df/dq and damping = -df/dv at a state, `entries` values each, in the order of the pattern. Line laws and
 * fields give theirs exactly (with the part that turns a line's direction); force elements by differences. Forces of a
 * field that couples bodies are differentiated by each body's own place alone. */
TinkerStatus tinker_jacobian_evaluate(TinkerJacobian *jacobian, double t, const double *q, const double *v,
                                      double *stiffness, double *damping);

/* J^T W J of the constraints at a state, with W the mass that moves along each row: see TinkerSystem.row_masses. */
TinkerStatus tinker_jacobian_row_masses(TinkerJacobian *jacobian, double t, const double *q, double *values);

#endif

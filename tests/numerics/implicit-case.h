/* What tests of the implicit methods share. */
#ifndef TEST_IMPLICIT_CASE_H
#define TEST_IMPLICIT_CASE_H

#include "numerics/methods/integrators.h"

const TinkerIntegrator *implicit_newmark(void);
const TinkerIntegrator *implicit_alpha(void);

/* A stepper of the method with this spectral radius at infinity; destroyed by the method. */
void *implicit_create(const TinkerIntegrator *method, const TinkerSystem *system, double radius);

/* So many steps of the same length, none of which may fail. */
void implicit_step_equally(const TinkerIntegrator *method, void *stepper, TinkerState *state, double h, int steps);

#endif

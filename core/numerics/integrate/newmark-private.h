/* The stepper of the implicit methods of structural dynamics, and its iteration. */
#ifndef TINKER_NUMERICS_NEWMARK_PRIVATE_H
#define TINKER_NUMERICS_NEWMARK_PRIVATE_H

#include "numerics/integrate/hermite.h"
#include "numerics/integrate/linear-band.h"
#include "numerics/integrate/newmark-family.h"
#include "numerics/solve/symmetric-solver.h"

typedef struct NewmarkStepper {
    const TinkerSystem *system;
    TinkerNewmarkWeights own;     /* of the method */
    TinkerNewmarkWeights weights; /* of the step in progress */
    const char *refusal;
    TinkerHermite dense;
    TinkerSymmetricSolver *solver;
    TinkerLinearBand *band; /* of a linear system with a narrow band: in place of all that iterates */
    int linear;             /* one solve with one matrix is the solution */
    int carried;            /* `a` and `power_from` belong to the present state */
    double h;               /* of the last step; 0: none */
    double moving;          /* of the correction found last, what moves the end: not along the rows of constraints */
    double held;            /* share of the matrix that forces make and masses do not: 0 loose, 1 stiff */
    int factored;
    int32_t *diagonal; /* entries of the pattern */
    double *stiffness, *damping, *row_masses;
    double *a, *x;              /* the acceleration before, the one looked for */
    double *correction, *along; /* of x; its part along the rows of constraints */
    double *base, *descent;     /* the best iterate so far and its correction */
    double *q, *v;              /* at the end */
    double *behind, *ahead;     /* accelerations by the forces, at the start and the end */
    double *power_from, *power_to;
    double memory[];
} NewmarkStepper;

/* newmark-newton.c: the acceleration x of the step from `state` to `limit`, and where it leads, (q, v). */
TinkerStatus newmark_find_acceleration(NewmarkStepper *self, const TinkerState *state, double h, double limit);

#endif

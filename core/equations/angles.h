/* Lagrange's equations of trees of rods, in the angles of the rods: m l^2 theta'' + m g l sin theta = 0. */
#ifndef TINKER_CORE_EQUATION_ANGLES_H
#define TINKER_CORE_EQUATION_ANGLES_H

#include "equations/equations.h"

/* Of a rod: from its end nearer to the support to the other, counter-clockwise from straight down. */
typedef struct {
    TinkerBlockId rod, body;        /* the body at its far end */
    int before;                     /* the number of the rod that it hangs on; -1: the support */
    const TinkerLineEquation *line; /* borrowed from the equations */
    char *angle, *rate, *acceleration;
    double value, rate_value; /* rad, rad/s */
} TinkerRodAngle;

typedef struct {
    GArray *angles;       /* of TinkerRodAngle, each behind the one that it hangs on */
    GPtrArray *equations; /* of TinkerExpression, N m: each is 0 */
} TinkerAngleTree;

typedef struct {
    GPtrArray *trees;       /* of TinkerAngleTree */
    GPtrArray *definitions; /* of TinkerEquationDefinition: accelerations of supports that move */
    GPtrArray *why;         /* of TinkerNotWritten, without symbols: a body that is in no tree, and the reason */
} TinkerAngleForm;

/* The trees of rods of a scene; adds the looks of their symbols to the equations. (transfer full) */
TinkerAngleForm *tinker_angle_form_new(TinkerEquations *equations);
void tinker_angle_form_free(TinkerAngleForm *form);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerAngleForm, tinker_angle_form_free)

#endif

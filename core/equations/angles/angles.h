/* Lagrange's equations of trees of rods and pinned bodies, in their angles: m l^2 theta'' + m g l sin theta = 0. */
#ifndef TINKER_CORE_EQUATION_ANGLES_H
#define TINKER_CORE_EQUATION_ANGLES_H

#include "equations/newton/equations.h"

/* Of a rod: from its end nearer to the support to the other; of a body that turns: from the joint nearer to the support
 * to its centre. Counter-clockwise from straight down; of a body that is pinned at its centre, its own angle. */
typedef struct {
    TinkerBlockId rod, body;        /* whose angle it is: the rod, or the body itself; and the body that it moves */
    int before;                     /* the number of the angle that it hangs on; -1: the support */
    const TinkerLineEquation *line; /* the rod or the pin that it hangs by; borrowed from the equations */
    int near;                       /* the end of that which is nearer to the support */
    gboolean turns;                 /* it is that of a body */
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
    GPtrArray *lengths;     /* likewise: of bodies, between their joints and their centres */
    GPtrArray *why;         /* of TinkerNotWritten, without symbols: a body that is in no tree, and the reason */
} TinkerAngleForm;

/* The trees of rods of a scene; adds the looks of their symbols to the equations. (transfer full) */
TinkerAngleForm *tinker_angle_form_new(TinkerEquations *equations);
/* Adds the names that its equations need, and its definitions. */
void tinker_angle_form_mark(const TinkerAngleForm *form, const TinkerEquations *equations, GHashTable *needed);
void tinker_angle_form_free(TinkerAngleForm *form);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerAngleForm, tinker_angle_form_free)

#endif

/* What the files of the form in angles share. */
#ifndef TINKER_CORE_EQUATION_ANGLES_PRIVATE_H
#define TINKER_CORE_EQUATION_ANGLES_PRIVATE_H

#include "equations/angles.h"
#include "law/build.h"

static inline TinkerRodAngle *tinker_angle_at(const TinkerAngleTree *tree, int number)
{
    return &g_array_index(tree->angles, TinkerRodAngle, number);
}

/* The equation of a body; NULL where it is none. */
const TinkerBodyEquation *tinker_angle_body(const TinkerEquations *equations, TinkerBlockId block);

/* Fills the tree that hangs on a support by this rod or pin. NULL, or why it has no angles. */
const char *tinker_angle_tree_fill(TinkerAngleTree *tree, const TinkerEquations *equations,
                                   const TinkerLineEquation *line, int near);

/* The equation of an angle; `pivot` is the support's acceleration. (transfer full) */
TinkerExpression *tinker_angle_equation(const TinkerEquations *equations, const TinkerAngleTree *tree, int number,
                                        TinkerExpression *const pivot[2]);

#endif

/* What the files of the form in angles share. */
#ifndef TINKER_CORE_EQUATION_ANGLES_PRIVATE_H
#define TINKER_CORE_EQUATION_ANGLES_PRIVATE_H

#include "equations/angles/angles.h"
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

/* What an angle does to a place that hangs on it: the way from its joint to there, along e and n of the angle (m). */
typedef struct {
    TinkerExpression *p, *q; /* owned */
} TinkerAngleArm;

/* What angle k does to the centre of body i, which is that of angle k or hangs on it. Lengths on bodies get names,
 * which are added to the form. */
TinkerAngleArm tinker_angle_arm(TinkerEquations *equations, TinkerAngleForm *form, const TinkerAngleTree *tree, int k,
                                int i);
void tinker_angle_arm_clear(TinkerAngleArm *arm);

/* The equation of an angle; `pivot` is the support's acceleration. (transfer full) */
TinkerExpression *tinker_angle_equation(TinkerEquations *equations, TinkerAngleForm *form, const TinkerAngleTree *tree,
                                        int number, TinkerExpression *const pivot[2]);

#endif

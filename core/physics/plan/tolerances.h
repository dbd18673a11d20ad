/* What is rounding, and what is let pass, of plans. Each: its unit and what it is relative to; what it says. */
#ifndef TINKER_PLAN_TOLERANCES_H
#define TINKER_PLAN_TOLERANCES_H

/* No unit; of the largest frequency: lower ones are 0 and rounding. */
#define TINKER_LEAST_FREQUENCY 1e-7
/* No unit; of the extent: parts of a motion with smaller amplitudes are rounding. */
#define TINKER_LEAST_AMPLITUDE 1e-12
/* No unit; of the energy: parts of a motion that hold less do not count. */
#define TINKER_CARRIES_ENERGY 1e-4
/* No unit; of how fast an island that is not linear changes: slower swings are the root of what rounding makes of a
 * stiffness. */
#define TINKER_LEAST_SWING 1e-6
/* No unit; of the fastest rate: slower growth is rounding, of bodies that nothing holds. */
#define TINKER_LEAST_GROWTH 1e-6
/* No unit; of the frequency of the largest stiffness: slower growth of what is in motion is the rounding of
 * differences, which the root of a stiffness enlarges. */
#define TINKER_LEAST_GROWTH_IN_MOTION 1e-3
/* No unit; of a row's length: less left of a row is that of one which depends on others. Its square is TINKER_DEPENDENT
 * of numerics/solve/rank.h, which the solvers go by. */
#define TINKER_DEPENDENT_LENGTH 1e-5
/* No unit; of the largest entry: a matrix whose entries differ by less across its diagonal is symmetric. */
#define TINKER_SYMMETRIC_MATRIX 1e-9
/* No unit; of the largest entry: the like of one whose entries may be differences, by its products. */
#define TINKER_SYMMETRIC_DIFFERENCES 1e-6
/* No unit; of the product of their largest entries: two matrices whose products differ by less commute. */
#define TINKER_COMMUTES 1e-10
/* As tolerances of methods: none is chosen or made tighter than this, where rounding is all that is left; */
#define TINKER_TIGHTEST_TOLERANCE 1e-14
/* and as tight as one is made where that costs nothing. */
#define TINKER_FREE_TOLERANCE 1e-6

#endif

/* What is rounding, and what is let pass, of the laws of contact. Problems are scaled: velocities, and W, are near 1.
 * * Each: its unit and what it is relative to; what it says; and where that was tried, tests that fail where it is
 * 1e4 times as large or as small ("-": none). */
#ifndef TINKER_NUMERICS_CONTACT_TOLERANCES_H
#define TINKER_NUMERICS_CONTACT_TOLERANCES_H

/* No unit; of the largest entry of a scaled problem: smaller pivots are rounding. */
#define TINKER_SMALLEST_PIVOT 1e-12
/* No unit; of constants near 1: smaller ones are taken as 0 by the rule that orders pivots. */
#define TINKER_SMALLEST_CONSTANT 1e-13
/* No unit; of the largest constant: so far constants are set apart, so that no two unknowns fall to 0 at once; and
 * where what that leads to is no solution with the true ones. */
#define TINKER_SET_APART        1e-10
#define TINKER_SET_LITTLE_APART 1e-12
/* No unit; of the largest constant: a covering unknown that is smaller at the end of a path is rounding. */
#define TINKER_COVERS_NOTHING 1e-8
/* No unit; of the largest velocity: what pivots alone find may miss a law by this. Held by:
 * numerics-contact-impacts. */
#define TINKER_PIVOTED 1e-7
/* No unit; of the terms that meet in an inequality: a solution may miss it by this; if none keeps to that, by this
 * share of the largest constant. */
#define TINKER_LCP_MISS 1e-11
/* No unit; of the terms that an energy is the sum of: smaller energies are 0. */
#define TINKER_ENERGY_ROUNDING 2e-15
/* No unit; of what meets in an acceleration: smaller accelerations are 0. */
#define TINKER_MODE_ROUNDING 1e-13
/* No unit; of the time in which accelerations change velocities: the instant that a jam is looked at after. */
#define TINKER_MOMENT 1e-7
/* No unit; of what a contact has in W: so soft it is made for the least of several answers. Held by:
 * numerics-contact-modes. */
#define TINKER_SOFT 1e-6
/* No unit; of what meets in a velocity: a guess at what a few contacts do may miss a law by this. */
#define TINKER_GUESS_ROUNDING 2e-14
/* No unit; of what meets in a velocity: the like of very many: chains of many bodies gather more rounding. */
#define TINKER_MANY_ROUNDING 2e-13
/* No unit; of what meets in a velocity: what is found no better may miss a law by this. */
#define TINKER_LOOSE 1e-10
/* No unit; of the largest velocity: slower contacts rest, for a first guess. */
#define TINKER_RESTING 1e-9
/* No unit; of the largest impulse: in a step of impulses answers as near as this end the splitting. */
#define TINKER_MANY_NEAR 1e-9
/* No unit; of TINKER_MANY_NEAR: and so many times as far they are met in the end. */
#define TINKER_MANY_NEARLY 1e4
/* No unit; of the bound of friction: friction nearer to it slides. */
#define TINKER_AT_BOUND 1e-9
/* No unit; of W_tt: a normal direction whose W_nn is smaller is one that nothing moves along. */
#define TINKER_IMMOVABLE 1e-13
/* No unit; of the largest velocity: what closes more slowly along a direction that nothing moves along does not.
 * Held by: physics-contact-flush. */
#define TINKER_STANDS_STILL 1e-12
/* No unit; of the largest velocity: pairs that approach more slowly strike no more in a sequence. */
#define TINKER_SEQUENCE_STILL 1e-13
/* No unit; of the largest velocity: smaller changes end the sweeps. */
#define TINKER_SWEEPS_CONVERGED 1e-14

#endif

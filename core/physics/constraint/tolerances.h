/* What is rounding, and what is let pass, of constraints. Each: its unit and what it is relative to; what it says;
 * and where that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_CONSTRAINT_TOLERANCES_H
#define TINKER_CONSTRAINT_TOLERANCES_H

/* No unit; of a row's length (a speed: of the fastest; a demand: of the largest): a start that misses a constraint by
 * no more is corrected, by more it is refused. Held by: physics-constraints, physics-straight-bars. */
#define TINKER_START_MISS 1e-6
/* No unit; of the diagonal of J M^-1 J^T, and of what contacts act on: what is added to it where rows depend on one
 * another: each solve brings an independent part closer by this over its eigenvalue, and what dependent rows disagree
 * in by rounding is magnified by its reciprocal. Held by: physics-redundant-rods, physics-singular. */
#define TINKER_PROXIMAL_SHIFT 1e-5
/* No unit; of the largest demand on a row: where no more is missed no smaller shift is looked for. Held by:
 * physics-mechanisms. */
#define TINKER_MET 1e-9
/* No unit; of that diagonal: the least that is tried, by steps of so much, where the start cannot be solved with more.
 * What dependent rows disagree in by rounding is then magnified until it shows in their forces. Held by:
 * physics-mechanisms. */
#define TINKER_LEAST_SHIFT 1e-13
#define TINKER_SHIFT_STEP  1e-2
/* No unit; of the least diagonal entry: rows up to the largest so many times as large share one shift. Held by:
 * physics-singular. */
#define TINKER_EVEN_ROWS 1e3
/* No unit; of a row's length: a projection that gains no more has come as near as rounding lets it. Held by:
 * physics-redundant-rods, physics-singular. */
#define TINKER_ROUNDING_MISS 1e-12
/* No unit; of a row's length: where RATTLE's Newton steps leave more and gain nothing, it is no rounding of places, but
 * a singular place that the step leads across. Held by: physics-mechanisms. */
#define TINKER_STALLED_MISS 1e-14
/* No unit; of a row's length: so much may be left at a singular place (a flat parallelogram), where rows depend on
 * each other, Newton steps only halve the miss, and no first-order step removes the last of it: the motion leaves the
 * place again, and the next projection finds it regular. Held by: physics-redundant-rods. */
#define TINKER_SINGULAR_MISS 1e-6
/* No unit; of the energy of a push: what is left of it where the constraints hold against it. Held by: -. */
#define TINKER_HELD 1e-9
/* No unit; of the push: what holds by more does so by being a little off a straight line alone. Held by:
 * physics-straight-bars, physics-redundant-rods. */
#define TINKER_HARDEST 1e3
/* Rows: the condition of S grows with the square of what hangs together, or its fourth power where that is welded. From
 * so many on, what a solve leaves of J a is more than steps at usual tolerances can stand: it is solved for once more.
 * What is solved along chains (row-chains.h, pin-chains.h) is left as it is. Held by: physics-mechanisms. */
#define TINKER_REFINED_ROWS 512
/* Rad: rods within this of the direction of another are in line with it, as are those between places that are typed
 * with four or five digits; beyond, their own tensions hold what pushes across. Held by: physics-row-chains,
 * physics-redundant-rods. */
#define TINKER_IN_LINE 1e-4

#endif

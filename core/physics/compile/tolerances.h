/* What is rounding where a scene becomes a model. Each: its unit and what it is relative to; what it says; and where
 * that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_COMPILE_TOLERANCES_H
#define TINKER_COMPILE_TOLERANCES_H

/* No unit; of the mass, or inertia, of what a hand holds while a mechanism is assembled. Held by: physics-assemble. */
#define TINKER_HELD_MASS 1e6
/* No unit; of the distance to the hand: nearer is not looked for. Held by: -. */
#define TINKER_ASSEMBLED 1e-6
/* No unit; of how far from the origin something is: an extent that is less is rounding of places. Held by: -. */
#define TINKER_LEAST_EXTENT 1e-6
/* No unit; of the scene's extent: ends that are closer coincide, but for rounding, and give no length. Held by: -. */
#define TINKER_ROUNDED_DISTANCE 1e-12

#endif

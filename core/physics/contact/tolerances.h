/* What is rounding, and what is let pass, of contacts, by events and as impulses. Each: its unit and what it is
 * relative to; what it says; and where that was tried, tests that fail where it is 1e4 times as large or as small
 * ("-": none). */
#ifndef TINKER_CONTACT_TOLERANCES_H
#define TINKER_CONTACT_TOLERANCES_H

/* No unit; of the largest speed: a slower rebound ends in rest, but for one that loses nothing. Held by:
 * physics-contact-bounces. */
#define TINKER_LEAST_REBOUND 1e-6
/* m/s: the largest speed counts as no less. In the age of the universe that goes half a metre: what blows left of
 * bodies that came to rest is slower, and is not to be taken for a lift-off. Held by: physics-contact-rest. */
#define TINKER_SLOWEST 1e-18
/* No unit; of the largest speed: a start that slides along a top more slowly may stick. Held by: -. */
#define TINKER_START_SLOW 1e-9
/* No unit; 1 - the cosine of the angle: two normals are opposite to within this. Held by: -. */
#define TINKER_OPPOSITE 1e-12
/* rad; and of the smaller of two shapes: edges that differ by no more are one line. Held by: -. */
#define TINKER_ONE_LINE 1e-6
/* No unit; of what meets in an equation: smaller misses of an elimination are rounding; a solve that leaves more than
 * half of one is the last. Held by: physics-contact-elimination. */
#define TINKER_MISS_ROUNDING 1e-14
/* No unit; of a force along one of its rows: what the other rows of joints leave of it, where they hold the same, so
 * that the pin's share is not determined. Held by: -. */
#define TINKER_SHARED_PIN 1e-6
/* No unit: bodies that touch one another and whose masses differ by more are uneven: what solves for their forces by W
 * is looked at again by the bodies. Held by: physics-contact-uneven. */
#define TINKER_UNEVEN 30.0
/* No unit: where they differ by more, W is scaled by the light ones, too, and a row may have as much less left without
 * that it depends on others. At smaller ratios refining is enough, and steps of stacks that share loads crept with it.
 * Held by: physics-contact-uneven. */
#define TINKER_VERY_UNEVEN 1e5
/* No unit; of the largest entry of a scaled W: smaller pivots of uneven bodies are rounding. Held by:
 * physics-contact-uneven. */
#define TINKER_UNEVEN_DEPENDENT 1e-14
/* No unit; of what a pull moves along a row of its own, were there no other: where other constraints leave less of it,
 * they hold the row. Held by: physics-ropes. */
#define TINKER_ROW_HELD 1e-12

#endif

/* What is rounding, and what is let pass, of events. Each: its unit and what it is relative to; what it says; and
 * where that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_EVENT_TOLERANCES_H
#define TINKER_EVENT_TOLERANCES_H

#include <float.h>

/* No unit; of the extent: a gap is closed within this: rounding, or another body at the same instant. Held by:
 * physics-contact-bounces, physics-contact-rods. */
#define TINKER_CLOSED_GAP 1e-13
/* No unit; of the extent: beyond this bodies that leave a plate are clear of it. */
#define TINKER_CLEAR 1e-9
/* No unit; of the tolerance times the extent: a gap of what has just opened, and joints tie, that is nothing beside
 * what steps make of places. */
#define TINKER_LEFT 1e-2
/* No unit; of the largest speed: slower is rounding. What parts or strikes is held against
 * tinker_change_speed_scale instead: it opens and closes contacts, also where rounding is all that moves. */
#define TINKER_STILL 1e-12
/* No unit; of the largest speed: what closes faster after an impact cannot be kept out. */
#define TINKER_SQUEEZED 1e-6
/* No unit; of the largest speed: what slides slower behind a blow is at rest, as a rebound so slow is none. */
#define TINKER_SLOW_SLIDE 1e-6
/* No unit; of the largest speed: what an event finds slower has stopped. */
#define TINKER_STOPPED 1e-10
/* No unit; of what the method makes of a speed of 0: or slower than so many times that. */
#define TINKER_STOPPED_NOISES 10
/* No unit; of the largest speed: what dense output makes of 0, of adaptive methods at the least. */
#define TINKER_SPEED_ROUNDING 1e-13
/* No unit; of the largest speed: the like of methods with fixed steps. */
#define TINKER_SPEED_ROUNDING_OF_STEPS 1e-11
/* No unit; of the largest speed: slower it may have begun to slip either way. */
#define TINKER_UNCLEAR_SPEED 1e-9
/* No unit; of what the method makes of a speed of 0: or slower than so many times that. */
#define TINKER_UNCLEAR_NOISES 10
/* No unit; of the speeds: speeds that differ by more differ by more than rounding. */
#define TINKER_SAME_SPEED 1e-10
/* No unit; of the largest speed at a step's start: in a step that nothing comes near in nobody gets so many times as
 * fast. */
#define TINKER_FASTER 4.0
/* No unit; of what acts: smaller forces are none. */
#define TINKER_FORCE_NOISE 1e-10
/* No unit; of a static coefficient: what moves with so much less is held by that alone. */
#define TINKER_SHORT_OF_LIMIT 1e-6
/* No unit; of what acts: what was found to press no more, at an instant that is known no better, presses by no more. */
#define TINKER_LET_GO 1e-7
/* No unit; of what a force or an acceleration is made of: below 0 by no more it has not fallen. */
#define TINKER_FORCE_ROUNDING 1e-11
/* No unit; of the square of the fastest by the size of what moves: an acceleration that is made of squares of
 * roundings. Held by: physics-contact-flush. */
#define TINKER_TURNING_ROUNDING 1e-24
/* No unit; of the coordinates that a place is made of: below 0 by no more it has not fallen. */
#define TINKER_PLACE_ROUNDING (16 * DBL_EPSILON)
/* No unit; of the time: an instant is known no better. */
#define TINKER_INSTANT (8 * DBL_EPSILON)
/* No unit; of the time: changes that follow so soon are at one instant. */
#define TINKER_ONE_INSTANT (64 * DBL_EPSILON)
/* No unit; of what another share of a load would accelerate bodies by itself: the motion depends on it where it makes
 * more of a difference. Held by: physics-contact-share. */
#define TINKER_SHARE_MATTERS 1e-6
/* No unit; of the extent: by so much a state is moved past a place where a force jumps, and by more if that is not
 * enough. */
#define TINKER_PAST_EDGE 1e-14
/* No unit; of a usual step: one contact's changes that follow so soon go by turns. */
#define TINKER_BY_TURNS 1e-5
/* No unit; of the time: a blow that is solved exactly falls within this of its instant. */
#define TINKER_BLOW_INSTANT (16 * DBL_EPSILON)
/* No unit: cosines and sines up to here are 0 but for rounding of angles. */
#define TINKER_NO_ANGLE (4 * DBL_EPSILON)
/* No unit; of a step: an event so near to its start is at its start. */
#define TINKER_AT_ONCE 1e-15
/* No unit; of a usual step: a contact that is expected so soon is what the step is made for, and in so short a part
 * of it the motion is far smoother than the method needs. */
#define TINKER_SOON 0.0625
/* No unit; of the tolerance: an error that is nothing beside what steps make. */
#define TINKER_CARRIED_SHARE 1e-4
/* No unit; of the tolerance, by the estimate of a step: so much less, and a state from within the step is good. */
#define TINKER_CUT_ERROR 1e-3
/* No unit; of accelerations: within a usual step they change by less than so many times as much. */
#define TINKER_CARRIED_CHANGE 10.0
/* No unit; of a usual step: so near to an event its state may be carried to it. */
#define TINKER_FARTHEST_CARRY 1e-3
/* Rad: a polynomial follows so much of a swing to rounding. */
#define TINKER_LONGEST_ARC 1.5
/* Rad: so far a plate may swing within a step while bodies rest on it. */
#define TINKER_LONGEST_SWING 0.2
/* Rad: so far a body may turn within a step. */
#define TINKER_LONGEST_TURN 100.0
/* No unit; of the way to the limit: the first step of an exact island from rest. */
#define TINKER_FIRST_WAY 1e-4
/* No unit; of the largest value in a step: what a polynomial through the values does not resolve. */
#define TINKER_NOTHING 1e-13
/* No unit; of a step: what rises and falls within it is looked at more closely. */
#define TINKER_FALLS_AT_ONCE 1e-3
/* No unit; of what a value changes by in a step: what the polynomial may miss between nodes. */
#define TINKER_RESOLVED 1e-3
/* No unit; of the size of a value: and besides. */
#define TINKER_NOTICED 1e-7
/* No unit; of the level of a trigger, which is rounding: and at least. */
#define TINKER_MISSED_NOISE 1e3
/* No unit; of what a value changes by within a step: one so many times as large does not reach 0, by its values at
 * three places. */
#define TINKER_SURELY 8.0
/* No unit; of what a value changes by within a step: the like by its values at the ends. */
#define TINKER_MOST_SURELY 100.0
/* No unit; of the largest speed: velocities behind an impact that differ by less are one outcome. Held by:
 * physics-impact-law. */
#define TINKER_SAME_OUTCOME 1e-9
/* No unit; of a pin's force: what its friction makes of it is found to this. Held by: physics-pin-friction. */
#define TINKER_PINS_SETTLED 1e-14
/* No unit; of the time: CROWD events within it never end. */
#define TINKER_CROWDED 1e-9
/* No unit; of the time: nor do SLOW_CROWDS times as many, each CROWD within this. */
#define TINKER_SLOW_CROWDED 1e-6

#endif

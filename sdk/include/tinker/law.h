/* Tinker SDK: a block's law, stated as data beside its code.
 *
 * From it the host makes the lines that say what a block does, and the equations of a scene; it typesets them,
 * differentiates them and checks their dimensions, and `tinker plugins check` holds the code to it at random states
 * (rule "law"). A block may leave it out: all else works, and where its law would be shown its force has a name and no
 * more.
 *
 * The law is a list of equations, symbol = expression, each of which may use the symbols before it. Expressions are of
 * the grammar that waveforms have as well (docs/reference/expressions.md). Their symbols are:
 *  - of each property its `symbol` ("k"), where it has none its id; of a vector with x and y behind it ("wx", "wy";
 *    "point_x" where it is the id); of a waveform its value at t. Properties that are read-only or texts have none;
 *  - t, and by role what is listed here. Where there are several ends they are counted from 1: x1, y1, x2, ...
 *
 * role           symbols                                        equations
 * line law       L, rate                                        tension; potential, of L alone
 * force element  x, y, vx, vy, theta, omega, turns of its end,  force_x and force_y of its end, or force_x1, ...;
 *                or x1, y1, ...                                 torque, torque1, ... beside what the forces do by their
 *                                                               arms; potential: minus its gradient may stand for both;
 *                                                               of blows impulse_x, impulse_y and angular_impulse, or
 *                                                               impulse_x1, ...: what the end is given at the instant
 * field          x, y, vx, vy, m of the body                    force_x, force_y; potential
 * that couples   those, and x2, y2, vx2, vy2, m2 of another     pair_force_x, pair_force_y: what the other does to the
 *                                                               body; pair_potential, of each pair once
 * constraint     x, y, theta, turns of its end, or x1, y1,      g, or g1, g2, ... of several rows
 *                ...; x_start, y_start, theta_start, or
 *                x1_start, ...: what they were at the start;
 *                L, the sum of the distances from end to end
 *                w_start of each waveform w: its value at the
 *                start
 * motion                                                        displacement_x, displacement_y; rotation
 *
 * theta is the angle of what an end is on, omega how fast it turns, both counter-clockwise; turns is 1 where that has
 * an angle, a body that turns or a support, and 0 for a point mass, whose theta is 0. With it a joint says what a point
 * mass leaves of it: g3 = turns1*turns2*(theta2 - theta2_start - theta1 + theta1_start) of a weld. A row that is 0
 * whatever the places are is left out of the equations. All symbols of an end that a block may have and has not are 0.
 * At an end of which a law states a torque, a force that it does not state is 0.
 *
 * A joint states its rows and nothing else: the host takes their gradients, which are the directions in which their
 * multipliers act at each end, and the moments of these by the arms. A row g has the unit of its declared dimension;
 * where it is an angle its multiplier is a torque.
 *
 *     static const TinkerLawEquation law[] = {        (a pin)
 *         TINKER_EQUATION("g1", "x2 - x1", NULL, TINKER_DIMENSION_LENGTH),
 *         TINKER_EQUATION("g2", "y2 - y1", NULL, TINKER_DIMENSION_LENGTH),
 *     };
 *
 * Equations of other symbols are steps on the way. Where the code takes care of a limit, such as a direction at length
 * 0, the law need not. Places are in the world. Angles count as numbers in dimensions. */
#ifndef TINKER_LAW_H
#define TINKER_LAW_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct TinkerLawEquation {
    uint32_t struct_size;
    int32_t reserved;
    const char *symbol;        /* letters, digits and _, beginning with a letter */
    const char *is;            /* the expression */
    const char *means;         /* in a few words, "how far it is drawn out"; NULL for the symbols of the table */
    TinkerDimension dimension; /* of the symbol */
    int32_t reserved_2;
} TinkerLawEquation;

#ifdef __cplusplus
}
#endif
#endif

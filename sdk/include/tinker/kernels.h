/* Tinker SDK: numerics that most blocks share. Plain C99 and C++11, static inline: nothing to link to but libm. */
#ifndef TINKER_KERNELS_H
#define TINKER_KERNELS_H

#include <float.h>
#include <math.h>

#include "graph.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_PI 3.14159265358979323846

/* Outside this range the square of a length over- or underflows, or loses digits as a subnormal number. */
#define TINKER_LEAST_SQUARE    1e-280
#define TINKER_GREATEST_SQUARE 1e280

/* Column `column` of a batch; a property's first column is the sum of the column counts of those declared before it. */
static inline const double *tinker_column(const TinkerBatch *batch, int32_t column)
{
    return batch->columns[column];
}

/* Where the ends of an instance begin among those of a call, for blocks of any number of ends too; `instance` may be
 * batch->count, where all of them end. */
static inline int32_t tinker_first_end(const TinkerBatch *batch, int32_t instance)
{
    return batch->ends < 0 ? batch->end_offsets[instance] : instance * batch->ends;
}

/* Reports an instance (0 to count - 1) whose property is at fault. `text` is static. */
static inline TinkerStatus tinker_fail(TinkerBatch *batch, int32_t instance, const char *text)
{
    batch->failed_instance = instance;
    batch->failure = text;
    return TINKER_FAILED;
}

/* Reports an instance that is not computable here, as tinker_fail does. A smaller step may help; `text` is what the
 * user reads where none does. */
static inline TinkerStatus tinker_retry(TinkerBatch *batch, int32_t instance, const char *text)
{
    tinker_fail(batch, instance, text);
    return TINKER_RETRY_SMALLER;
}

/* sqrt(x^2 + y^2), also where the squares leave the range of a double. */
static inline double tinker_length(double x, double y)
{
    const double square = x * x + y * y;
    return square >= TINKER_LEAST_SQUARE && square <= TINKER_GREATEST_SQUARE ? sqrt(square) : hypot(x, y);
}

/* The unit vector at an angle (rad). Quarter turns are exact: the rounded -pi/2 has the cosine 6e-17, which would let
 * whatever falls drift sideways. An angle counts as a quarter turn within four roundings, so that "270 deg" is one too.
 */
static inline void tinker_direction(double angle, double direction[2])
{
    const double turn = floor(angle / (TINKER_PI / 2.0) + 0.5);
    const double off = fabs(angle - turn * (TINKER_PI / 2.0));
    if (fabs(turn) < 1e6 && off <= 4.0 * DBL_EPSILON * fabs(angle)) {
        const int quarter = (int)turn & 3;
        direction[0] = quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0;
        direction[1] = quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0;
        return;
    }
    direction[0] = cos(angle);
    direction[1] = sin(angle);
}

/* The angle from the vector (ax, ay) to (bx, by), counter-clockwise, less the angle at rest: from -pi to pi, so that
 * its jump lies opposite to rest, wherever rest is. */
static inline double tinker_turn_from_rest(double ax, double ay, double bx, double by, double rest)
{
    const double along = ax * bx + ay * by, across = ax * by - ay * bx;
    double direction[2];
    tinker_direction(rest, direction);
    return atan2(across * direction[0] - along * direction[1], along * direction[0] + across * direction[1]);
}

/* A moment (N m, counter-clockwise) on the arm from a hinge to its tip, as a pair of forces: adds M / r across the arm
 * at the tip, and the opposite at the hinge. Answers 0, and adds nothing, where the arm has no length. */
static inline int tinker_add_moment(const TinkerPoint *hinge, const TinkerPoint *tip, double moment, double *on_hinge,
                                    double *on_tip)
{
    const double x = tip->x - hinge->x, y = tip->y - hinge->y, square = x * x + y * y;
    if (!(square > 0.0)) return 0;
    const double across[2] = {-moment * y / square, moment * x / square};
    for (int axis = 0; axis < 2; axis++) {
        on_tip[axis] += across[axis];
        on_hinge[axis] -= across[axis];
    }
    return 1;
}

/* Distance between the two ends of every instance that has exactly two. */
static inline void tinker_end_distances(int32_t count, const TinkerPoint *TINKER_RESTRICT ends,
                                        double *TINKER_RESTRICT length)
{
    for (int32_t i = 0; i < count; i++) {
        length[i] = tinker_length(ends[2 * i + 1].x - ends[2 * i].x, ends[2 * i + 1].y - ends[2 * i].y);
    }
}

/* Its rate of change; 0 where the ends coincide, since the direction is undefined there. */
static inline void tinker_end_rates(int32_t count, const TinkerPoint *TINKER_RESTRICT ends,
                                    double *TINKER_RESTRICT rate)
{
    for (int32_t i = 0; i < count; i++) {
        const TinkerPoint a = ends[2 * i], b = ends[2 * i + 1];
        const double dx = b.x - a.x, dy = b.y - a.y, length = tinker_length(dx, dy);
        rate[i] = length > 0.0 ? dx / length * (b.vx - a.vx) + dy / length * (b.vy - a.vy) : 0.0;
    }
}

/* The row of a path from end to end, as a rope over wheels has one. With its strands k = 1 ... n, d_k = x_k - x_(k-1),
 * L_k = |d_k|, n_k = d_k / L_k and w_k = v_k - v_(k-1):
 *     path = sum of L_k,   dpath/dx_k = n_k - n_(k+1),   drift = sum of (n_k x w_k)^2 / L_k.
 * Writes the derivatives as x and y of each end; answers the shortest strand. A strand of length 0 has no direction,
 * and counts for nothing. */
static inline double tinker_path_row(const TinkerPoint *end, int32_t ends, double *path, double *jacobian,
                                     double *drift)
{
    double shortest = INFINITY;
    *path = *drift = 0.0;
    for (int32_t k = 0; k < 2 * ends; k++) {
        jacobian[k] = 0.0;
    }
    for (int32_t k = 1; k < ends; k++) {
        const TinkerPoint *a = &end[k - 1], *b = &end[k];
        const double dx = b->x - a->x, dy = b->y - a->y, length = tinker_length(dx, dy);
        shortest = fmin(shortest, length);
        if (length == 0.0) continue;
        const double nx = dx / length, ny = dy / length, across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        *path += length;
        *drift += across / length * across;
        jacobian[2 * k - 2] -= nx;
        jacobian[2 * k - 1] -= ny;
        jacobian[2 * k] += nx;
        jacobian[2 * k + 1] += ny;
    }
    return shortest;
}

/* Component 0 to 5 (x, y, vx, vy, ax, ay) of the first end of every instance that has exactly one. */
static inline TinkerStatus tinker_point_values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t component,
                                               double *values)
{
    if (component >= 4 && input->accelerations == NULL) return tinker_fail(batch, 0, "accelerations are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *point = &input->ends[i];
        switch (component) {
        case 0:
            values[i] = point->x;
            break;
        case 1:
            values[i] = point->y;
            break;
        case 2:
            values[i] = point->vx;
            break;
        case 3:
            values[i] = point->vy;
            break;
        default:
            values[i] = input->accelerations[2 * i + component - 4];
            break;
        }
    }
    return TINKER_OK;
}

/* Component 0 to 3 (speed, magnitude of the acceleration, momentum in x, in y) of the centre of every instance, of
 * these masses. */
static inline TinkerStatus tinker_centre_values(TinkerBatch *batch, const TinkerGraphInput *input, const double *mass,
                                                int32_t component, double *values)
{
    const double *a = input->accelerations;
    if (component == 1 && a == NULL) return tinker_fail(batch, 0, "accelerations are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *point = &input->ends[i];
        values[i] = component == 0   ? tinker_length(point->vx, point->vy)
                    : component == 1 ? tinker_length(a[2 * i], a[2 * i + 1])
                    : component == 2 ? mass[i] * point->vx
                                     : mass[i] * point->vy;
    }
    return TINKER_OK;
}

/* Component 0 to 2 (normal force, friction force, magnitude of the whole) of what acts on every instance through its
 * contacts; 0 from a host that tells of none. */
static inline TinkerStatus tinker_contact_values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t component,
                                                 double *values)
{
    const double *contacts = TINKER_HAS(TinkerGraphInput, input, contacts) ? input->contacts : NULL;
    for (int32_t i = 0; i < batch->count; i++) {
        if (contacts == NULL) {
            values[i] = 0.0;
        } else if (component < 2) {
            values[i] = contacts[4 * i + component];
        } else {
            values[i] = tinker_length(contacts[4 * i + 2], contacts[4 * i + 3]);
        }
    }
    return TINKER_OK;
}

/* Defines the loop of a line law with two properties as a function
 *     static void name(int32_t count, const double *p, const double *q, const double *length, const double *rate,
 *                      double *result)
 * in whose `expression` the properties have the names given, and `L` and `rate` are those of one instance. The loop
 * runs over plain restrict pointers, which is what the compiler vectorises:
 *     TINKER_LINE_LOOP(spring_tension_loop, k, L0, k * (L - L0)) */
#define TINKER_LINE_LOOP(name, p, q, expression)                                                                       \
    static void name(int32_t count, const double *TINKER_RESTRICT p##_column,                                          \
                     const double *TINKER_RESTRICT q##_column, const double *TINKER_RESTRICT length_,                  \
                     const double *TINKER_RESTRICT rate_, double *TINKER_RESTRICT result_)                             \
    {                                                                                                                  \
        for (int32_t i_ = 0; i_ < count; i_++) {                                                                       \
            const double p = p##_column[i_], q = q##_column[i_], L = length_[i_], rate = rate_[i_];                    \
            (void)p, (void)q, (void)L, (void)rate;                                                                     \
            result_[i_] = (expression);                                                                                \
        }                                                                                                              \
    }

#ifdef __cplusplus
}
#endif
#endif

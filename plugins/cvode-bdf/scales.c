/* What errors are measured against: the extent and the largest speed of the system, never |q|, nothing absolute. */
#include "stepper-private.h"

#include <float.h>
#include <math.h>

/* Rounding of an entry, and of what it is made from. */
#define ROUNDING (16.0 * DBL_EPSILON)

double stepper_largest(int32_t count, const double *x)
{
    double most = 0.0;
    for (int32_t i = 0; i < count; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

static double positive_or_one(double value)
{
    return value > 0.0 && isfinite(value) ? value : 1.0;
}

void stepper_scales_start(Stepper *stepper, const TinkerState *state, double limit, const double *a)
{
    const TinkerSystem *system = stepper->system;
    double extent = 0.0, speed = 0.0, remaining = limit - state->t, push = stepper_largest(system->size, a);
    system->scales(system->context, state->q, state->v, &extent, &speed);
    /* s: how long the push needs to move the system across itself */
    double time = push > 0.0 && extent > 0.0 ? fmin(sqrt(extent / push), remaining) : remaining;
    stepper->start_speed = positive_or_one(fmax(speed, push * time));
    stepper->start_extent = positive_or_one(fmax(extent, stepper->start_speed * time));
}

realtype stepper_norm(N_Vector errors, N_Vector weights)
{
    const double *error = N_VGetArrayPointer(errors), *w = N_VGetArrayPointer(weights);
    sunindextype count = N_VGetLength(errors);
    double most = 0.0;
    for (sunindextype i = 0; i < count; i++) {
        double each = fabs(error[i] * w[i]);
        if (!(each <= most)) most = each;
        if (isnan(most)) break;
    }
    return most;
}

/* The scales at y, and to begin with those that the motion is headed for: a motion from rest has none of its own yet,
 * and the first steps, of order 1, cannot be accurate to a part of what they themselves bring about. This share halves
 * with every step. */
static void find_scales(const Stepper *stepper, const double *q, const double *v, double h, long steps, double *extent,
                        double *speed)
{
    const double share = steps < 100 ? ldexp(1.0, -(int)steps) : 0.0;
    stepper->system->scales(stepper->system->context, q, v, extent, speed);
    *speed = fmax(*speed, share * stepper->start_speed);
    if (!(*speed > 0.0)) *speed = stepper->start_speed;
    *extent = fmax(fmax(*extent, h * *speed), share * stepper->start_extent);
    if (!(*extent > 0.0)) *extent = stepper->start_extent;
}

/* Below the rounding of q itself nothing is asked for, nor for an error in v that moves the system by less than 16
 * roundings within the step. */
int stepper_weights(N_Vector y, N_Vector weights, void *data)
{
    const Stepper *stepper = data;
    const int32_t n = stepper->system->size;
    const double *q = N_VGetArrayPointer(y);
    double *w = N_VGetArrayPointer(weights), extent = 0.0, speed = 0.0, h = 0.0;
    long steps = 0;
    if (n == 0) {
        w[0] = 1.0;
        return 0;
    }
    CVodeGetNumSteps(stepper->cvode, &steps);
    if (steps > 0) CVodeGetCurrentStep(stepper->cvode, &h);
    find_scales(stepper, q, q + n, h, steps, &extent, &speed);
    double scale_q = fmax(stepper->tolerance * extent, ROUNDING * stepper_largest(n, q));
    double scale_v = stepper->tolerance * speed + (h > 0.0 ? ROUNDING * extent / h : 0.0);
    if (!(scale_q > 0.0) || !(scale_v > 0.0) || !isfinite(scale_q) || !isfinite(scale_v)) return -1;
    for (int32_t i = 0; i < n; i++) {
        w[i] = 1.0 / scale_q;
        w[n + i] = 1.0 / scale_v;
    }
    return 0;
}

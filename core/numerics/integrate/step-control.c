/* Step size control: trial lengths, the error norm, the starting step. */
#include "numerics/integrate/step-control.h"
#include "numerics/solve/largest.h"

#include <float.h>

#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"

#define SAFETY        0.9
#define STRETCH       1.01 /* how much longer a step may become so as to land: the safety covers it */
#define FACTOR_BROKEN 0.1  /* after a trial whose error is not a number */
#define FADING        0.9  /* of the usual length of steps, from one that is shorter to the next */
/* A motion that is small beside the extent may be this much faster than the extent tells; what looks faster still is
 * the rounding of a velocity and a force that both vanish. */
#define LOCAL_RATE_CAP 1e4

/* Below this, t + h is too coarse to tell stages apart. */
static double least_step(double t)
{
    return fmax(16.0 * DBL_EPSILON * fabs(t), DBL_MIN);
}

void tinker_step_control_init(TinkerStepControl *control, const TinkerStepLaw *law, double tolerance)
{
    control->law = law;
    control->tolerance = fmax(TINKER_STEP_SHARE * tolerance, 2.0 * DBL_EPSILON);
    control->usual_before = 0.0;
    tinker_step_control_forget(control);
}

void tinker_step_control_forget(TinkerStepControl *control)
{
    control->h = 0.0;
    control->last_error = TINKER_LEAST_ERROR;
    control->usual = 0.0;
}

double tinker_step_control_trial(const TinkerStepControl *control, double t, double limit, int *lands)
{
    double remaining = limit - t, h = fmax(control->h, least_step(t));
    *lands = STRETCH * h >= remaining;
    if (*lands) return remaining;
    return 2.0 * h > remaining ? 0.5 * remaining : h;
}

void tinker_step_control_accept(TinkerStepControl *control, double h, double error, int rejected)
{
    const TinkerStepLaw *law = control->law;
    double factor = law->greatest_factor;
    if (error > 0.0) factor = SAFETY * pow(error, -law->exponent) * pow(control->last_error, law->memory);
    factor = fmin(law->greatest_factor, fmax(law->least_factor, factor));
    if (rejected && factor > 1.0) factor = 1.0;
    double next = h * factor;
    int cut_short = STRETCH * h < control->h; /* not by the rounding of t alone */
    control->h = cut_short && !rejected ? fmax(next, control->h) : next;
    control->last_error = fmax(error, TINKER_LEAST_ERROR);
    control->usual = fmax(h, FADING * control->usual);
    control->usual_before = fmax(h, FADING * control->usual_before);
}

int tinker_step_control_reject(TinkerStepControl *control, double t, double h, double error)
{
    double factor = FACTOR_BROKEN;
    if (isfinite(error)) factor = fmax(control->law->least_factor, SAFETY * pow(error, -control->law->exponent));
    control->h = h * factor;
    return control->h > least_step(t);
}

double tinker_relative(double value, double scale)
{
    return value == 0.0 ? 0.0 : value / scale;
}

TinkerErrorScale tinker_error_scale(const TinkerSystem *system, const TinkerStepControl *control, double h,
                                    const double *q0, const double *v0, const double *q1, const double *v1,
                                    const double *a)
{
    double usual = fmax(h, control->usual), tolerance = control->tolerance;
    double extent = 0.0, speed = 0.0, extent_end = 0.0, speed_end = 0.0;
    system->scales(system->context, q0, v0, &extent, &speed);
    system->scales(system->context, q1, v1, &extent_end, &speed_end);
    extent = fmax(extent, extent_end);
    speed = fmax(speed, speed_end);
    if (!(speed > 0.0)) speed = h * tinker_largest(system->size, a);
    if (!(extent > 0.0)) extent = h * speed;
    double rounding = 2.0 * DBL_EPSILON * extent / usual * (h / usual);
    return (TinkerErrorScale){.q = tolerance * extent, .v = tolerance * speed + rounding};
}

/* The rate, 1/s, at which something that changes by `change` in t^power crosses `scale`; 0 where that says nothing. */
static double crossing_rate(double change, double scale, double power)
{
    if (!(scale > 0.0) || !(change > 0.0)) return 0.0;
    double rate = pow(change / scale, 1.0 / power);
    return isfinite(rate) ? rate : 0.0;
}

TinkerStatus tinker_starting_step(const TinkerSystem *system, int order, double tolerance, const TinkerState *state,
                                  double limit, const double *a, double *q1, double *v1, double *a1, double *h)
{
    int32_t n = system->size;
    double extent = 0.0, speed = 0.0, remaining = limit - state->t;
    system->scales(system->context, state->q, state->v, &extent, &speed);
    double force = tinker_largest(n, a);
    double rate = fmax(crossing_rate(tinker_largest(n, state->v), extent, 1.0), crossing_rate(force, extent, 2.0));
    if (!(extent > 0.0)) rate = crossing_rate(force, speed, 1.0);
    double probe = rate > 0.0 ? fmin(0.01 / rate, remaining) : 1e-6 * remaining;

    for (int32_t i = 0; i < n; i++) {
        q1[i] = state->q[i] + probe * state->v[i];
        v1[i] = state->v[i] + probe * a[i];
    }
    TinkerStatus status = system->acceleration(system->context, state->t + probe, q1, v1, a1, NULL);
    if (status == TINKER_FAILED) return status;
    if (status == TINKER_OK) {
        for (int32_t i = 0; i < n; i++)
            a1[i] -= a[i];
        double jerk = tinker_largest(n, a1) / probe;
        rate = fmax(rate, crossing_rate(jerk, extent, 3.0));
        double local = fmin(crossing_rate(jerk, force, 1.0), crossing_rate(jerk, speed, 2.0));
        rate = fmax(rate, rate > 0.0 ? fmin(local, LOCAL_RATE_CAP * rate) : local);
    }
    *h = rate > 0.0 ? pow(tolerance, 1.0 / (order + 1)) / rate : remaining;
    if (status != TINKER_OK) *h = fmin(*h, 0.1 * probe);
    *h = fmin(*h, remaining);
    return TINKER_OK;
}

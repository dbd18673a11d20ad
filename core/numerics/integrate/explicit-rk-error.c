/* How far off a trial of the adaptive explicit Runge-Kutta methods is. */
#include "numerics/integrate/explicit-rk-private.h"
#include "numerics/solve/largest.h"

#include <glib.h>
#include <math.h>

#include "numerics/integrate/books-error.h"
#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"

/* `tangent`: without what projection takes off the trial's end. */
static double measure(RkStepper *stepper, const RkRow *row, double h, TinkerErrorScale scale, gboolean tangent)
{
    const TinkerSystem *system = stepper->system;
    int32_t n = system->size;
    rk_combine(stepper, row, h, &(RkOnto){.q_out = stepper->error_q, .v_out = stepper->error_v});
    double *const parts[] = {stepper->error_q, stepper->error_v};
    for (int k = 0; k < 2 && tangent; k++)
        if (system->project_velocity(system->context, stepper->t1, stepper->q, parts[k], 1) != TINKER_OK)
            return INFINITY;
    double q = tinker_relative(tinker_largest(n, stepper->error_q), scale.q);
    double v = tinker_relative(tinker_largest(n, stepper->error_v), scale.v);
    return q > v || isnan(q) ? q : v;
}

static double measure_all(RkStepper *stepper, double h, TinkerErrorScale scale, gboolean tangent)
{
    const TinkerTableau *tableau = stepper->scheme->tableau;
    double error = measure(stepper, &stepper->scheme->error, h, scale, tangent);
    if (tableau->dense_error) error = fmax(error, measure(stepper, &stepper->scheme->dense_error, h, scale, tangent));
    if (!tableau->second_error) return error;
    return tinker_tableau_join_errors(error, measure(stepper, &stepper->scheme->second_error, h, scale, tangent));
}

/* The largest of what any acceleration changes by within the trial: of what goes on as before it is a small part, of a
 * force that sets in all. */
static double change_of_force(const RkStepper *stepper)
{
    double change = 0;
    for (int stage = 1; stage < stepper->scheme->tableau->stages; stage++)
        for (int32_t i = 0; i < stepper->system->size; i++)
            change = fmax(change, fabs(stepper->a[stage][i] - stepper->a[0][i]));
    return change;
}

/* A force that sets in on what is at rest, within a step, has nothing to be measured by but what it does itself in that
 * step, however short that is. Where the trials have been cut down to a small part of the usual step, it counts as what
 * it brings about in a part of one of those, where that is far more than all there is. */
static void begin_scale(const RkStepper *stepper, TinkerErrorScale *scale)
{
    const double usual = stepper->control.usual_before, tolerance = stepper->control.tolerance;
    const double force = change_of_force(stepper);
    if (!(scale->v < TINKER_CUT_DOWN * tolerance * usual * force)) return;
    const double late = fmax(TINKER_CUT_DOWN * tolerance * usual, TINKER_SETS_IN * fabs(stepper->t1));
    scale->v = fmax(scale->v, late * force);
    scale->q = fmax(scale->q, late * usual * force);
}

/* The error of the trial whose end lies in (q, v), relative to the tolerance.
 *
 * Near a singular place of a mechanism (links in one line) rows nearly depend on each other: they determine some
 * accelerations by a small difference alone, in which rounding grows as 1 / distance, so that shorter steps only meet
 * more of it. It lies across the motion that the rows allow, and projection takes it off but for its square. So an
 * error that is far too large is measured again along the motion; where that leaves next to nothing, this and the
 * square count. What is at rest, such as a long chain that hangs, has no motion to measure it along: rounding that is
 * projected off there moves weights, and the energy tells. Books are not projected: where there are any, the error that
 * lies across tells of theirs. */
static double find_error_of_motion(RkStepper *stepper, double h)
{
    int32_t n = stepper->system->size;
    if (!isfinite(tinker_largest(n, stepper->q)) || !isfinite(tinker_largest(n, stepper->v))) return INFINITY;
    TinkerErrorScale scale = tinker_error_scale(stepper->system, &stepper->control, h, stepper->q0, stepper->v0,
                                                stepper->q, stepper->v, stepper->a[0]);
    if (h < TINKER_CUT_DOWN * stepper->control.usual_before) begin_scale(stepper, &scale);
    double error = measure_all(stepper, h, scale, FALSE);
    if (!(error > TINKER_FAR_OFF) || !isfinite(error)) return error;
    if (!tinker_is_constrained(stepper->system) || stepper->system->books > 0) return error;
    const double way = h * tinker_largest(n, stepper->v0);
    if (!(tinker_largest(n, stepper->error_q) < TINKER_UNMOVED * way)) return error;
    double along = measure_all(stepper, h, scale, TRUE);
    if (!(along < TINKER_ERROR_ALONG * error)) return error;
    return fmax(along, fmin(TINKER_SQUARE_SHARE * stepper->control.tolerance * error * error, TINKER_MISPLACED));
}

/* Where velocities hardly change, the error of the motion tells nothing of the books, and they count themselves. */
static double find_error_of_books(RkStepper *stepper, double h, double error)
{
    if (!(error <= 1.0) || stepper->system->books == 0) return error;
    const TinkerBooksTrial trial = {.tableau = stepper->scheme->tableau,
                                    .a = stepper->a,
                                    .power = stepper->power,
                                    .h = h,
                                    .books0 = stepper->books0,
                                    .q = stepper->q,
                                    .v = stepper->v,
                                    .tolerance = stepper->control.tolerance};
    return fmax(error, tinker_books_error(stepper->system, &trial));
}

double rk_find_error(RkStepper *stepper, double h)
{
    return find_error_of_books(stepper, h, find_error_of_motion(stepper, h));
}

/* What errors are measured by: the scales of an island's motion, and what rounding makes of it. */
#include <float.h>
#include <math.h>

#include "numerics/exact/exact.h"
#include "numerics/solve/largest.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/run/estimate-private.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

/* How far a random walk of roundings goes, in units of the root of their number. */
#define WALK 4.0
/* In roundings of its places: an island that moves within less rests. */
#define PLACES_ROUND_WITHIN 64

void tinker_estimate_scales(TinkerIslandRun *run, double *extent, double *speed)
{
    run->system.system.scales(&run->system, run->state.q, run->state.v, extent, speed);
}

/* How far an exact island has been from where it started, and how fast it has been on the way at least: its steps are
 * long, and where it has come to rest within the first they have seen no speed of it. */
static void note_swing(TinkerEstimatePart *part, const TinkerIslandRun *run)
{
    if (part->start == NULL) return;
    for (int32_t i = 0; i < run->system.system.size; i++)
        part->swing = fmax(part->swing, fabs(run->state.q[i] - part->start[i]));
    if (run->state.t > 0) part->mean_speed = fmax(part->mean_speed, part->swing / run->state.t);
}

/* Every step of an exact solution rounds its modes, and with a place that is off by epsilon of its swing a mode's
 * speed is off by w times that. Where something slow deflects what is stiff that is much beside the speed. In m/s,
 * as a random walk of the steps. */
static double rounding_of_speeds(const TinkerEstimatePart *part, const TinkerIslandRun *run)
{
    const gboolean exact = run->system.system.linear != NULL && tinker_method_is_exact(run->choice.method);
    if (part->start == NULL || !exact) return 0;
    return WALK * DBL_EPSILON * sqrt((double)run->summary.steps) * part->fastest * part->swing;
}

double tinker_estimate_rounding(TinkerEstimate *estimate, guint number, double t)
{
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    TinkerSystem *system = &run->system.system;
    TinkerEstimatePart *part = &estimate->parts[number];
    double extent, speed, *greatest = &part->acceleration;
    gint64 evaluations = run->model->evaluations;
    if (system->acceleration(system->context, run->state.t, run->state.q, run->state.v, estimate->now.q, NULL) ==
        TINKER_OK)
        *greatest = fmax(*greatest, tinker_largest(system->size, estimate->now.q));
    run->model->evaluations = evaluations;
    system->scales(system->context, run->state.q, run->state.v, &extent, &speed);
    if (system->linear != NULL && tinker_method_is_exact(run->choice.method)) note_swing(part, run);
    speed = fmax(speed, part->mean_speed);
    double places = extent > 0 ? speed / extent : 0, speeds = speed > 0 ? *greatest / speed : 0;
    double steps = speed > 0 ? rounding_of_speeds(part, run) / speed : 0;
    return fmax(DBL_EPSILON * t * fmax(places, speeds), steps);
}

gboolean tinker_estimate_part_rests(const TinkerEstimatePart *part, const TinkerIslandRun *run, double extent)
{
    const TinkerContacts *contacts = run->model->contacts;
    if (extent < PLACES_ROUND_WITHIN * part->rounding) return TRUE;
    return tinker_contacts_act(contacts) && extent < TINKER_RESTS_WITHIN * tinker_contacts_extent(contacts);
}

/* The largest of the bodies' distances from one place to another. */
static double largest_way(const TinkerIslandRun *run, const double *from, const double *to)
{
    double largest = 0;
    for (int32_t i = 0; i < 2 * run->model->bodies; i += 2) {
        const double x = to[i] - from[i], y = to[i + 1] - from[i + 1];
        largest = fmax(largest, x * x + y * y);
    }
    return sqrt(largest);
}

void tinker_estimate_scales_at(TinkerEstimate *estimate, TinkerIslandRun *run, const TinkerEstimatePart *part, double t,
                               double *extent, double *speed)
{
    TinkerEstimateRoom *then = &estimate->then, *now = &estimate->now;
    tinker_estimate_scales(run, extent, speed);
    if (!tinker_method_is_adaptive(run->choice.method) || t >= run->state.t || t < part->reached - part->length) return;
    if (tinker_island_run_unprojected_at(run, part->reached - part->length, then->q, then->v) != TINKER_OK ||
        tinker_island_run_unprojected_at(run, t, now->q, now->v) != TINKER_OK)
        return;
    *extent = fmin(*extent, part->extent + largest_way(run, then->q, now->q));
    for (int32_t i = 0; i < run->model->coordinates; i++)
        then->v[i] = 0;
    *speed = fmin(*speed, fmax(part->speed, largest_way(run, then->v, now->v)));
}

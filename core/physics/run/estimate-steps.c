/* Where in a step of the run its companion is compared with it. */
#include <math.h>

#include "physics/event/contact-run.h"
#include "physics/run/estimate-private.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

/* An adaptive companion lands on these shares of every step of the run: there dense output errs most, and its own
 * steps are so much shorter that it is the finer of the two where a tenth of the tolerance makes no difference, as
 * where stability or a break makes the steps. To reach a sample behind them it makes a step of that share, which
 * ends within the next step of the run: that is where it lands then, in place of a landing that is as near as this
 * share of the step. */
static const double landings[] = {0.3, 0.72};
#define STEP_BEYOND 0.58
#define NEAR        0.1

static void note_step(TinkerEstimatePart *part, TinkerIslandRun *run)
{
    part->length = run->state.t - part->reached;
    part->reached = run->state.t;
    if (!tinker_method_is_adaptive(run->choice.method)) return;
    part->extent = part->next_extent;
    part->speed = part->next_speed;
    tinker_estimate_scales(run, &part->next_extent, &part->next_speed);
}

static int32_t choose_landings(TinkerEstimatePart *part, double *times)
{
    const double from = part->reached - part->length;
    const gboolean has_begun = part->begun > from && part->begun < part->reached;
    int32_t points = 0;
    if (has_begun) times[points++] = part->begun;
    for (gsize i = 0; i < G_N_ELEMENTS(landings); i++) {
        const double landing = from + landings[i] * part->length;
        if (!has_begun || landing > part->begun + NEAR * part->length) times[points++] = landing;
    }
    part->begun = -INFINITY;
    return points;
}

/* Where the companion's steps end within the run's; at the end alone where dense output is of an order above that of
 * the method. */
static int32_t choose_ends(TinkerEstimatePart *part, const TinkerIntegrator *method, double *times)
{
    int32_t points = 0;
    const double slack = TINKER_SAME_TIME_IN_STEP * part->grid.spacing, from = part->reached - part->length;
    double next;
    if (method->dense_order < method->order && part->grid.spacing > 0) {
        while ((next = tinker_time_grid_at(&part->grid, part->next_step)) <= from + slack)
            part->next_step++;
        for (; next < part->reached - slack && points < TINKER_MOST_STEP_POINTS - 1;
             next = tinker_time_grid_at(&part->grid, ++part->next_step))
            times[points++] = next;
    }
    times[points++] = part->reached;
    return points;
}

int32_t tinker_estimate_part_step(TinkerEstimatePart *part, TinkerIslandRun *run, double *times)
{
    const TinkerIntegrator *method = run->choice.method;
    note_step(part, run);
    if (!tinker_method_is_adaptive(method)) {
        part->landing = part->beyond = times[0] = part->reached;
        return tinker_method_is_exact(method) ? 1 : choose_ends(part, method, times);
    }
    const int32_t points = choose_landings(part, times);
    part->landing = times[points - 1];
    const gboolean stops = run->state.t >= run->piece_end ||
                           (run->contacts != NULL && tinker_contact_run_has_pending_event(run->contacts));
    part->beyond = stops ? part->reached : part->landing + STEP_BEYOND * part->length;
    return points;
}

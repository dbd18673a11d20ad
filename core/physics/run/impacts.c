/* Impacts of a run and of its companion, and the distance of two states. */
#include "physics/run/impacts.h"

#include <math.h>

#include "physics/event/contact-run.h"
#include "physics/impulse/impulse.h"
#include "physics/model/model-data.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

/* Near an impact, in steps, where an impact is one of a whole step. */
#define STEPS_NEAR_IMPACT 3
/* One impact comes to the run and to its companion this much apart: so long after it they are taken to be
 * behind it. */
#define BEHIND_IMPACT 2

TinkerImpacts tinker_impacts_of(const TinkerIslandRun *run)
{
    if (tinker_method_solves_contact(run->choice.method))
        return (TinkerImpacts){tinker_impulse_last_impact(run->stepper), -INFINITY,
                               STEPS_NEAR_IMPACT * run->choice.step};
    if (run->contacts == NULL) return (TinkerImpacts){-INFINITY, -INFINITY, 0};
    return (TinkerImpacts){tinker_contact_run_last_impact(run->contacts),
                           tinker_contact_run_passed_impact(run->contacts), 0};
}

gboolean tinker_impacts_are_near(const TinkerImpacts *impacts, double t)
{
    return fabs(impacts->last - t) <= (impacts->within > 0 ? impacts->within : TINKER_NEAR_IMPACT * t);
}

/* An impact comes to the two at two instants; between them velocities tell nothing. */
static gboolean strikes_between(const TinkerImpacts *impacts, const TinkerImpacts *others, double t)
{
    double ours = fmax(impacts->passed, 0), theirs = fmax(others->passed, 0);
    return t <= fmax(ours, theirs) + BEHIND_IMPACT * fabs(ours - theirs);
}

gboolean tinker_impacts_let_speeds_tell(const TinkerImpacts *ours, const TinkerImpacts *theirs, double t)
{
    if (ours->last == -INFINITY && theirs->last == -INFINITY) return TRUE; /* nothing has struck yet */
    return !tinker_impacts_are_near(ours, t) && !tinker_impacts_are_near(theirs, t) &&
           !strikes_between(ours, theirs, t);
}

/* The largest of four lanes is that of all, and none of them waits for another. */
double tinker_largest_square(int32_t bodies, const double *from, const double *to, double so_far)
{
    double largest[4] = {so_far, so_far, so_far, so_far};
    int32_t i = 0;
    for (; i + 4 <= bodies; i += 4)
        for (int k = 0; k < 4; k++) {
            const int32_t at = 2 * (i + k);
            const double x = to[at] - from[at], y = to[at + 1] - from[at + 1], square = x * x + y * y;
            largest[k] = square > largest[k] ? square : largest[k];
        }
    for (; i < bodies; i++) {
        const double x = to[2 * i] - from[2 * i], y = to[2 * i + 1] - from[2 * i + 1], square = x * x + y * y;
        largest[0] = square > largest[0] ? square : largest[0];
    }
    const double one = MAX(largest[0], largest[1]), other = MAX(largest[2], largest[3]);
    return MAX(one, other);
}

double tinker_largest_way(const TinkerModel *model, const double *from, const double *to, double so_far)
{
    so_far = tinker_largest_square(model->bodies, from, to, so_far);
    for (int32_t i = 2 * model->bodies; i < model->coordinates; i++)
        so_far = MAX(so_far, (to[i] - from[i]) * (to[i] - from[i]));
    return so_far;
}

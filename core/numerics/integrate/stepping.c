/* The lines that every step begins or ends with. */
#include <glib/gi18n-lib.h>

#include "numerics/integrate/stepping.h"

const char *tinker_failure_of(const TinkerSystem *system, const char *otherwise)
{
    const char *reason = system->failure ? system->failure(system->context) : NULL;
    return reason ? reason : otherwise;
}

TinkerStatus tinker_fixed_step_begin(double t, double limit, TinkerStepReport *report)
{
    double h = limit - t;
    report->rejected = 0;
    report->t_from = t;
    report->step = h;
    report->error = 0.0;
    report->failure = NULL;
    if (isfinite(h) && h != 0.0) return TINKER_OK;
    report->failure = N_("a step must end at a finite time other than the one it starts at");
    return TINKER_FAILED;
}

TinkerStatus tinker_fixed_step_fail(const TinkerSystem *system, TinkerStepReport *report)
{
    report->failure = tinker_failure_of(
        system,
        N_("the system could not be evaluated within the step; a smaller step or an adaptive method may succeed"));
    return TINKER_FAILED;
}

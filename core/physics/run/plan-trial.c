#include "physics/run/plan-trial.h"

#include <math.h>

#include "physics/event/contact-run.h"
#include "physics/island/island-run.h"
#include "physics/plan/islands.h"
#include "physics/plan/operations.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/run/island-steps.h"
#include "physics/run/simulation-private.h"
#include "physics/system/summary.h"

/* What the trials of all islands may take together: some ten milliseconds. */
#define TRIAL_OPERATIONS 1e8

typedef struct {
    double share; /* of the run that was made, in time; 0: it could not begin */
    TinkerCounts counts;
} TinkerTrial;

/* Where events and warnings of the trial go: nobody reads them. */
static void unread_new(TinkerSummary *unread)
{
    *unread = (TinkerSummary){0};
    unread->events = g_ptr_array_new_with_free_func(tinker_event_free);
    unread->warnings = tinker_warnings_new();
}

static void unread_clear(TinkerSummary *unread)
{
    g_clear_pointer(&unread->events, g_ptr_array_unref);
    g_clear_pointer(&unread->warnings, g_ptr_array_unref);
}

/* Steps until the end or the limit; where a run stops by itself, it has come to its end, too. */
static TinkerTrial make_steps(TinkerIslandRun *run, const TinkerOperationRates *rates, double end, double operations)
{
    TinkerTrial made = {0};
    gboolean stopped = FALSE;
    while (run->state.t < end && !stopped) {
        stopped = !tinker_island_run_step(run, end, NULL);
        made.counts.steps = (double)run->summary.steps;
        made.counts.evaluations = (double)run->model->evaluations;
        made.counts.corrections = (double)run->model->corrections;
        if (run->contacts != NULL) made.counts.looks = (double)tinker_contact_run_looks(run->contacts);
        if (tinker_operations_counted(rates, &made.counts) > operations) break;
    }
    made.share = stopped || run->state.t >= end ? 1 : run->state.t / end;
    return made;
}

/* Steps an island by `choice` until the run's end, or until about `operations` have been spent on it. By counts alone:
 * the same scene has the same trial on every machine. */
static TinkerTrial make_trial(const TinkerIsland *island, const TinkerChoice *choice, const TinkerRunOptions *options,
                              const TinkerOperationRates *rates, double operations)
{
    const double end = tinker_options_span(options);
    TinkerTrial made = {0};
    TinkerSummary unread;
    unread_new(&unread);
    TinkerIslandRun *run =
        tinker_island_run_new(island, choice, options->spectral_radius, MAX(end, 1.0), &unread, NULL, NULL);
    if (run != NULL) made = make_steps(run, rates, end, operations);
    tinker_island_run_free(run);
    unread_clear(&unread);
    return made;
}

/* What the run will take, by its first steps; by the forecast alone where it cannot begin. */
static void count_run(TinkerIslandPlan *plan, const TinkerIsland *island, const TinkerRunOptions *options,
                      double operations)
{
    const TinkerOperationRates rates = tinker_operations_rates(island, plan->choice.method);
    const TinkerTrial trial = make_trial(island, &plan->choice, options, &rates, operations);
    if (!(trial.share > 0)) return;
    const TinkerCounts whole = {trial.counts.steps / trial.share, trial.counts.evaluations / trial.share,
                                trial.counts.looks / trial.share, trial.counts.corrections / trial.share};
    plan->evaluations = whole.evaluations;
    plan->operations = tinker_operations_counted(&rates, &whole) +
                       tinker_operations_samples(island, plan->choice.method, tinker_options_samples(options));
    plan->expected_s = plan->operations * TINKER_SECONDS_PER_OPERATION;
}

TinkerPlan *tinker_plan_new_counted(TinkerModel *model, GPtrArray *islands, const TinkerRunOptions *options,
                                    GError **error)
{
    TinkerPlan *plan = tinker_plan_new(model, islands, options, error);
    for (guint i = 0; plan != NULL && i < islands->len; i++)
        count_run(g_ptr_array_index(plan->islands, i), g_ptr_array_index(islands, i), options,
                  TRIAL_OPERATIONS / islands->len);
    return plan;
}

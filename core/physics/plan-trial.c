#include "physics/plan-trial.h"

#include <math.h>

#include "physics/contact-run.h"
#include "physics/model-private.h"
#include "physics/simulation-private.h"

/* Where events and warnings of the trial go: nobody reads them. */
static void unread_new(TinkerSummary *unread)
{
    *unread = (TinkerSummary){0};
    unread->events = g_ptr_array_new_with_free_func(tinker_event_free);
    unread->warnings = g_ptr_array_new_with_free_func(g_free);
    unread->of_scene = g_ptr_array_new();
}

static void unread_clear(TinkerSummary *unread)
{
    g_clear_pointer(&unread->events, g_ptr_array_unref);
    g_clear_pointer(&unread->warnings, g_ptr_array_unref);
    g_clear_pointer(&unread->of_scene, g_ptr_array_unref);
}

/* Steps until the end or the limit; where a run stops by itself, it has come to its end, too. */
static TinkerTrial make_steps(TinkerIslandRun *run, double end, double operations)
{
    TinkerTrial made = {0};
    gboolean stopped = FALSE;
    while (run->state.t < end && !stopped) {
        stopped = !tinker_island_run_step(run, end, NULL);
        made.counts.steps = (double)run->summary.steps;
        made.counts.evaluations = (double)run->model->evaluations;
        if (run->contacts != NULL) made.counts.looks = (double)tinker_contact_run_looks(run->contacts);
        if (tinker_cost_counted(run->island, run->choice.method, &made.counts) > operations) break;
    }
    made.share = stopped || run->state.t >= end ? 1 : run->state.t / end;
    return made;
}

TinkerTrial tinker_trial_make(const TinkerIsland *island, const TinkerChoice *choice, const TinkerRunOptions *options,
                              double operations)
{
    const double end = tinker_options_span(options);
    TinkerTrial made = {0};
    TinkerSummary unread;
    unread_new(&unread);
    TinkerIslandRun *run =
        tinker_island_run_new(island, choice, options->spectral_radius, MAX(end, 1.0), &unread, NULL);
    if (run != NULL) made = make_steps(run, end, operations);
    tinker_island_run_free(run);
    unread_clear(&unread);
    return made;
}

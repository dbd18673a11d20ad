/* Tries, one after another, each a simulation of its own on the same model. */
#include "physics/run/accurate-run.h"
#include "physics/plan/tolerances.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/island/island-run.h"
#include "physics/model/model.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation-private.h"
#include "physics/run/simulation.h"
#include "physics/system/method-call.h"
#include "physics/system/summary.h"

/* A further try aims at this share of the accuracy, since errors do not follow settings quite. */
#define AIM 0.4
/* How the logarithm of the estimate goes with that of the settings, at the least and at the most: two tries are few to
 * tell it from. */
#define LEAST_SLOPE    0.5
#define GREATEST_SLOPE 2.0
/* A try takes at most so many times the steps of the one before it, of a fixed length; or so small a share of its
 * tolerances. */
#define MOST_SHORTENING 30.0
#define LEAST_SHARE     1e-8

/* How the islands are stepped from the start. (transfer full) */
static TinkerChoice *choices_of(const TinkerSimulation *simulation)
{
    TinkerChoice *choices = g_new(TinkerChoice, simulation->all->runs->len + 1);
    for (guint i = 0; i < simulation->all->runs->len; i++)
        choices[i] = ((const TinkerIslandRun *)g_ptr_array_index(simulation->all->runs, i))->choice;
    return choices;
}

/* Makes the settings so tight that errors become `share` of what they are. An exact method's tolerance is that of the
 * one that takes over where something touches. FALSE where nothing can be tightened. */
static gboolean tighten(TinkerChoice *choices, guint count, double share)
{
    gboolean tighter = FALSE;
    for (guint i = 0; i < count; i++) {
        TinkerChoice *choice = &choices[i], before = *choice;
        if (tinker_method_is_fixed(choice->method))
            choice->step *= fmax(pow(share, 1.0 / MAX(choice->method->order, 1)), 1 / MOST_SHORTENING);
        else
            choice->tolerance =
                fmin(choice->tolerance, fmax(TINKER_TIGHTEST_TOLERANCE, choice->tolerance * fmax(share, LEAST_SHARE)));
        tighter |= choice->step < before.step || choice->tolerance < before.tolerance;
    }
    return tighter;
}

/* A try whose companion stopped where the error had passed what can be predicted has no estimate, and is off by all. */
static double error_of(const TinkerSummary *summary, guint number)
{
    const double estimate = g_array_index(summary->tries, TinkerTry, number).error_estimate;
    return isnan(estimate) ? 1 : estimate;
}

/* What share of the last errors a further try is to have. `shares` are those that led to the tries so far, the first 1.
 */
static double wanted_share(const TinkerSummary *summary, const double *shares)
{
    const GArray *tries = summary->tries;
    double last = error_of(summary, tries->len - 1), slope = 1;
    if (tries->len > 1) {
        double before = error_of(summary, tries->len - 2);
        slope = CLAMP(log(last / before) / log(shares[tries->len - 1]), LEAST_SLOPE, GREATEST_SLOPE);
    }
    return pow(AIM * summary->accuracy / last, 1 / slope);
}

static void add_try(TinkerSummary *summary)
{
    const TinkerTry this = {summary->method,      summary->adaptive, summary->step,          summary->tolerance,
                            summary->evaluations, summary->wall_s,   summary->error_estimate};
    g_array_append_val(summary->tries, this);
}

static gboolean is_met(const TinkerSummary *summary)
{
    return summary->error_estimate <= summary->accuracy;
}

static void explain_miss(const TinkerSummary *summary, GError **error)
{
    gboolean at_rounding = summary->tries->len < TINKER_MOST_TRIES;
    if (isfinite(summary->predictable_until))
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY,
                    _("the accuracy of %g is not met: the motion is not predictable beyond t = %.6g s at the tightest "
                      "settings tried (a shorter run can be)"),
                    summary->accuracy, summary->predictable_until);
    else if (isnan(summary->error_estimate))
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY,
                    _("the accuracy of %g is not held: there is no error estimate to hold to it"), summary->accuracy);
    else
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY,
                    at_rounding ? _("the accuracy of %g is not met: the estimated error is %.2g, and rounding leaves "
                                    "nothing to tighten (ask for less accuracy, or for a shorter run)")
                                : _("the accuracy of %g is not met: the estimated error is %.2g after as many tries as "
                                    "are made (ask for less accuracy, name another method, or run a shorter time)"),
                    summary->accuracy, summary->error_estimate);
}

/* Puts a simulation with these choices in the place of the one that has run; where there is none, that one stays. */
static gboolean replace(TinkerSimulation **simulation, const TinkerChoice *choices, GError **error)
{
    TinkerSimulation *last = *simulation;
    TinkerSimulation *next = tinker_simulation_new_chosen(last->all->model, &last->all->options, choices, error);
    if (next == NULL) return FALSE;
    g_array_append_vals(next->all->summary.tries, last->all->summary.tries->data, last->all->summary.tries->len);
    tinker_simulation_free(last);
    *simulation = next;
    return TRUE;
}

/* Where the numbers broke down after the error had passed what was asked for, tighter settings may hold. */
static gboolean may_hold(const TinkerSummary *summary, const GError *failure)
{
    return g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN) &&
           summary->error_estimate > summary->accuracy;
}

/* Sets the choices for a further try; FALSE where none would be better. */
static gboolean choose_again(const TinkerSimulation *simulation, TinkerChoice *choices, double *shares)
{
    const TinkerSummary *summary = &simulation->all->summary;
    guint number = summary->tries->len;
    const gboolean is_known = !isnan(summary->error_estimate) || isfinite(summary->predictable_until);
    if (number == TINKER_MOST_TRIES || !is_known) return FALSE;
    shares[number] = wanted_share(summary, shares);
    return tighten(choices, simulation->all->runs->len, shares[number]);
}

static gboolean hold_accuracy(TinkerSimulation **simulation, const GArray *columns, const TinkerSampleTaker *taker,
                              GError **error)
{
    double shares[TINKER_MOST_TRIES] = {1};
    g_autofree TinkerChoice *choices = choices_of(*simulation);
    for (;;) {
        g_autoptr(GError) failure = NULL;
        tinker_simulation_ask_at_events(*simulation, taker->at_events);
        gboolean done = tinker_simulation_run(*simulation, columns, taker->sample, taker->data, &failure);
        TinkerSummary *summary = &(*simulation)->all->summary;
        add_try(summary);
        if (done && is_met(summary)) return TRUE;
        gboolean again = (done || may_hold(summary, failure)) && choose_again(*simulation, choices, shares);
        if (!again && done) explain_miss(summary, &failure);
        if (!again) {
            g_propagate_error(error, g_steal_pointer(&failure));
            return FALSE;
        }
        if (!replace(simulation, choices, error)) return FALSE;
        if (taker->begin_again != NULL) taker->begin_again(taker->data);
    }
}

gboolean tinker_accurate_run(TinkerSimulation **simulation, const GArray *columns, const TinkerSampleTaker *taker,
                             GError **error)
{
    const TinkerRunOptions *options = &(*simulation)->all->options;
    if (options->accuracy > 0 && options->estimate) return hold_accuracy(simulation, columns, taker, error);
    tinker_simulation_ask_at_events(*simulation, taker->at_events);
    return tinker_simulation_run(*simulation, columns, taker->sample, taker->data, error);
}

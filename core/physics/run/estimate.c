/* The run's side of the error estimate: what the companion's needs of the run is written down as news
 * (comparison.h), after each step of an island and at samples, and handed on (relay.h). What is compared, and where,
 * is decided here: nothing depends on how far the companion has come. */
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/exact/exact.h"
#include "numerics/sharing/sharing.h"
#include "numerics/solve/largest.h"
#include "physics/model/model-data.h"
#include "physics/run/companion.h"
#include "physics/run/estimate-private.h"
#include "physics/run/simulation.h"
#include "physics/system/method-call.h"

/* Of an island of so many bodies threads share the loops already. */
#define MANY_BODIES (TINKER_SHARE_LEAST / 2)

/* Waiting ---------------------------------------------------------------------------------------------------------- */

/* Whether the user has not had enough. */
static gboolean is_wanted(void *data)
{
    const TinkerRunOptions *options = &((TinkerEstimate *)data)->runs->options;
    return options->cancelled == NULL || !options->cancelled(options->data);
}

/* Room for news; NULL with an error where the user stopped the run. */
static void *add_news(TinkerEstimate *estimate, gsize bytes, GError **error)
{
    void *news = tinker_relay_add(estimate->relay, bytes, is_wanted, estimate);
    if (news == NULL) tinker_island_runs_fail_stopped(estimate->runs, error);
    return news;
}

/* A run without a companion goes on, but where it was the user who stopped that. */
static gboolean go_on_alone(TinkerEstimate *estimate, TinkerComparisonState state, GError **error)
{
    return state != TINKER_COMPARISON_STOPPED || tinker_island_runs_fail_stopped(estimate->runs, error);
}

/* What was found is that of all news then. The warning of a companion that failed comes where it would have come at
 * once. */
static const TinkerFindings *catch_up(TinkerEstimate *estimate)
{
    if (!tinker_relay_finish(estimate->relay, is_wanted, estimate)) {
        tinker_comparison_hurry(estimate->comparison);
        tinker_relay_finish(estimate->relay, NULL, NULL);
    }
    TinkerFindings *findings = tinker_comparison_findings(estimate->comparison);
    if (findings->failure != NULL)
        g_ptr_array_insert(estimate->runs->summary.warnings, (gint)findings->failure_place,
                           tinker_warning_new(TINKER_WARNING_METHOD, g_steal_pointer(&findings->failure)));
    return findings;
}

/* Opening ---------------------------------------------------------------------------------------------------------- */

void tinker_estimate_free(TinkerEstimate *estimate)
{
    if (estimate == NULL) return;
    if (estimate->comparison != NULL) tinker_comparison_stop(estimate->comparison);
    tinker_relay_free(estimate->relay);
    tinker_comparison_free(estimate->comparison);
    for (guint i = 0; i < estimate->runs->runs->len; i++)
        g_free(estimate->parts[i].start);
    gpointer arrays[] = {estimate->parts, estimate->then.q, estimate->then.v, estimate->now.q, estimate->now.v};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(estimate);
}

/* Of the places that an island's points have in the scene, and on what they are fixed to. */
static double rounding_of_places(const TinkerModel *model)
{
    double arm = 0;
    for (guint i = 0; i < model->attachments->len; i++) {
        const TinkerAttachment *attachment = &g_array_index(model->attachments, TinkerAttachment, i);
        if (!attachment->turn) arm = fmax(arm, hypot(attachment->arm[0], attachment->arm[1]));
    }
    const double within = tinker_largest(2 * model->bodies, model->q_start);
    return DBL_EPSILON * (hypot(model->origin[0], model->origin[1]) + arm + within);
}

static void open_part(TinkerEstimatePart *part, TinkerIslandRun *run)
{
    const TinkerSystem *system = &run->system.system;
    part->compares = tinker_companion_factor(run) > 0;
    part->landing = part->begun = -INFINITY;
    if (run->choice.step > 0) part->grid = tinker_time_grid(run->choice.step / 2);
    tinker_estimate_scales(run, &part->next_extent, &part->next_speed);
    part->rounding = rounding_of_places(run->model);
    if (!tinker_method_is_exact(run->choice.method) || system->linear == NULL) return;
    part->fastest = tinker_exact_fastest(system->linear);
    part->start = g_memdup2(run->state.q, (gsize)system->size * sizeof(double));
}

static void warn_of_none(TinkerIslandRuns *runs, const char *why)
{
    tinker_summary_warn_of_method(
        &runs->summary, g_strdup_printf(_("there is no error estimate: the companion run cannot be set up (%s)"), why));
}

static TinkerRelay *open_relay(const TinkerEstimate *estimate)
{
    TinkerComparison *comparison = estimate->comparison;
    const gboolean beside = tinker_comparison_has_companion(comparison) && estimate->runs->model->bodies < MANY_BODIES;
    gsize largest = tinker_comparison_sample_bytes(comparison);
    for (guint i = 0; i < estimate->runs->runs->len; i++)
        largest = MAX(largest, tinker_comparison_step_bytes(comparison, i, TINKER_MOST_STEP_POINTS));
    return tinker_relay_new(largest, beside, tinker_comparison_take, comparison);
}

static gboolean follow(void *follower, guint number, double t, GError **error);

TinkerEstimate *tinker_estimate_new(TinkerIslandRuns *runs, const GArray *columns)
{
    g_autoptr(GError) error = NULL;
    TinkerEstimate *estimate = g_new0(TinkerEstimate, 1);
    estimate->runs = runs;
    estimate->parts = g_new0(TinkerEstimatePart, runs->runs->len);
    double **rooms[] = {&estimate->then.q, &estimate->then.v, &estimate->now.q, &estimate->now.v};
    for (gsize i = 0; i < G_N_ELEMENTS(rooms); i++)
        *rooms[i] = g_new0(double, (gsize)runs->model->coordinates + 1);
    for (guint i = 0; i < runs->runs->len; i++)
        open_part(&estimate->parts[i], g_ptr_array_index(runs->runs, i));
    estimate->comparison = tinker_comparison_new(runs, columns, &error);
    if (estimate->comparison != NULL) {
        estimate->relay = open_relay(estimate);
        runs->follower = estimate;
        if (tinker_comparison_has_companion(estimate->comparison)) runs->follow = follow;
        return estimate;
    }
    if (!g_error_matches(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) warn_of_none(runs, error->message);
    tinker_estimate_free(estimate);
    return NULL;
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

/* On the constraints, as samples are: between its ends a step leaves them by far more than it is off along them, most
 * of all where they leave nothing free. */
static void write_states(const TinkerStepNews *news, TinkerIslandRun *run, double *states)
{
    const gsize n = (gsize)run->model->coordinates;
    for (int32_t k = 0; k < news->points; k++, states += 2 * n) {
        if (tinker_island_run_state_at(run, news->times[k], states, states + n) == TINKER_OK) continue;
        for (gsize i = 0; i < 2 * n; i++)
            states[i] = NAN;
    }
}

/* An island of the run has made a step on its way to a sample at t, or goes on from there: the companion is to come
 * as far, not beyond the sample. FALSE only where the user stopped it. */
static gboolean follow(void *follower, guint number, double t, GError **error)
{
    TinkerEstimate *estimate = follower;
    TinkerEstimatePart *part = &estimate->parts[number];
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    if (!part->compares || part->reached >= run->summary.determined_until) return TRUE;
    const TinkerComparisonState state = tinker_comparison_state(estimate->comparison);
    if (state != TINKER_COMPARISON_GOES_ON) return go_on_alone(estimate, state, error);
    const gboolean steps = run->state.t > part->reached;
    const double until = MIN(run->state.t, t);
    if (!steps && !(until > part->told)) return TRUE;
    TinkerStepNews step = {.kind = TINKER_NEWS_STEP, .island = number, .steps = steps, .until = until};
    if (steps) {
        step.points = tinker_estimate_part_step(part, run, step.times);
    }
    TinkerStepNews *news =
        add_news(estimate, tinker_comparison_step_bytes(estimate->comparison, number, step.points), error);
    if (news == NULL) return FALSE;
    step.warnings = estimate->runs->summary.warnings->len;
    step.length = part->length;
    step.to = part->reached;
    step.beyond = part->beyond;
    step.impacts = tinker_impacts_of(run);
    *news = step;
    write_states(news, run, (double *)(gpointer)(news + 1));
    part->told = until;
    return TRUE;
}

/* Samples ---------------------------------------------------------------------------------------------------------- */

static TinkerIslandNews news_of(TinkerEstimate *estimate, guint number, double t)
{
    TinkerEstimatePart *part = &estimate->parts[number];
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    TinkerIslandNews news = {.determined = !(t > run->summary.determined_until)};
    if (!news.determined) return news;
    if (tinker_method_is_exact(run->choice.method) || run->aside.method != NULL)
        news.rounding = tinker_estimate_rounding(estimate, number, t);
    if (!part->compares) return news;
    tinker_estimate_scales_at(estimate, run, part, t, &news.extent, &news.speed);
    news.noise = tinker_island_run_speed_noise(run, news.extent);
    news.rests = tinker_estimate_part_rests(part, run, news.extent);
    news.impacts = tinker_impacts_of(run);
    if (tinker_method_is_adaptive(run->choice.method) && t > part->landing) part->begun = part->beyond;
    return news;
}

gboolean tinker_estimate_look(TinkerEstimate *estimate, double t, GError **error)
{
    const TinkerIslandRuns *runs = estimate->runs;
    TinkerComparison *comparison = estimate->comparison;
    const TinkerComparisonState state = tinker_comparison_state(comparison);
    if (state != TINKER_COMPARISON_GOES_ON) return go_on_alone(estimate, state, error);
    TinkerSampleNews *news = add_news(estimate, tinker_comparison_sample_bytes(comparison), error);
    if (news == NULL) return FALSE;
    *news = (TinkerSampleNews){TINKER_NEWS_SAMPLE, runs->summary.warnings->len, t};
    TinkerIslandNews *islands = (TinkerIslandNews *)(gpointer)(news + 1);
    for (guint i = 0; i < runs->runs->len; i++)
        islands[i] = news_of(estimate, i, t);
    if (!tinker_comparison_has_companion(comparison)) return TRUE;
    const gsize n = (gsize)runs->model->coordinates;
    double *states = (double *)(gpointer)(islands + runs->runs->len);
    memcpy(states, runs->sample_q, n * sizeof(double));
    memcpy(states + n, runs->sample_v, n * sizeof(double));
    memcpy(states + 2 * n, runs->values, tinker_comparison_columns(comparison) * sizeof(double));
    return TRUE;
}

gboolean tinker_estimate_close(TinkerEstimate *estimate, GError **error)
{
    const TinkerFindings *findings = catch_up(estimate);
    if (isfinite(findings->predictable_until))
        tinker_summary_warn_of_method(
            &estimate->runs->summary,
            g_strdup_printf(_("not predictable beyond t = %.6g s: there the estimated error passes a tenth of the "
                              "motion's own size (a smaller step or tolerance moves that time out, in "
                              "chaotic motion only a little)"),
                            findings->predictable_until));
    return go_on_alone(estimate, tinker_comparison_state(estimate->comparison), error);
}

double tinker_estimate_error(TinkerEstimate *estimate)
{
    return catch_up(estimate)->error;
}

double tinker_estimate_predictable_until(TinkerEstimate *estimate)
{
    return catch_up(estimate)->predictable_until;
}

const double *tinker_estimate_bands(TinkerEstimate *estimate)
{
    return catch_up(estimate)->bands;
}

/* The run's side of the error estimate: what the companion's needs of the run is written down as news
 * (comparison.h), after each step of an island and at samples, and handed on (relay.h). What is compared, and where,
 * is decided here: nothing depends on how far the companion has come. */
#include "physics/run/estimate.h"

#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/exact/exact.h"
#include "numerics/sharing/sharing.h"
#include "numerics/solve/largest.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/run/companion.h"
#include "physics/run/comparison.h"
#include "physics/run/relay.h"
#include "physics/run/simulation.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

/* How far a random walk of roundings goes, in units of the root of their number. */
#define WALK 4.0
/* An adaptive companion lands on these shares of every step of the run: there dense output errs most, and its own
 * steps are so much shorter that it is the finer of the two where a tenth of the tolerance makes no difference, as
 * where stability or a break makes the steps. To reach a sample behind them it makes a step of that share, which
 * ends within the next step of the run: that is where it lands then, in place of a landing that is as near as this
 * share of the step. */
static const double landings[] = {0.3, 0.72};
#define STEP_BEYOND 0.58
#define NEAR        0.1
/* In roundings of its places: an island that moves within less rests. */
#define PLACES_ROUND_WITHIN 64
/* Of an island of so many bodies threads share the loops already. */
#define MANY_BODIES (TINKER_SHARE_LEAST / 2)

/* Of one island. */
typedef struct {
    gboolean compares;
    double length;                  /* s: of the run's last step */
    double reached;                 /* s: where that ended */
    double told;                    /* s: the companion has been told to come so far */
    double extent, speed;           /* m, m/s: the scales where it began, of an adaptive method */
    double next_extent, next_speed; /* and where it ended */
    double landing;                 /* s: the last one that the companion was told of */
    double beyond;                  /* s: and where it goes from there if a sample is behind it, */
    double begun;                   /* as it does now; else -INFINITY */
    TinkerTimeGrid grid;            /* of the companion's steps, and the number of the next one; of a fixed method */
    gint64 next_step;
    double acceleration; /* m/s^2: the largest so far */
    double fastest;      /* rad/s: no mode of an exact island is faster */
    double *start;       /* where its coordinates were; NULL where it is not exact */
    double swing;        /* and how far they have been from there, */
    double mean_speed;   /* m/s: on the way to where that was the fastest */
    double rounding;     /* m: of the places of its points in the scene */
} Part;

/* Room for the bodies of an island. */
typedef struct {
    double *q, *v;
} Bodies;

struct _TinkerEstimate {
    TinkerIslandRuns *runs;
    TinkerComparison *comparison;
    TinkerRelay *relay;
    Part *parts; /* island by island */
    Bodies then, now;
};

static void scales_of(TinkerIslandRun *run, double *extent, double *speed)
{
    run->system.system.scales(&run->system, run->state.q, run->state.v, extent, speed);
}

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
                           g_steal_pointer(&findings->failure));
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

static void open_part(Part *part, TinkerIslandRun *run)
{
    const TinkerSystem *system = &run->system.system;
    part->compares = tinker_companion_factor(run) > 0;
    part->landing = part->begun = -INFINITY;
    if (run->choice.step > 0) part->grid = tinker_time_grid(run->choice.step / 2);
    scales_of(run, &part->next_extent, &part->next_speed);
    part->rounding = rounding_of_places(run->model);
    if (!tinker_method_is_exact(run->choice.method) || system->linear == NULL) return;
    part->fastest = tinker_exact_fastest(system->linear);
    part->start = g_memdup2(run->state.q, (gsize)system->size * sizeof(double));
}

static void warn_of_none(TinkerIslandRuns *runs, const char *why)
{
    g_ptr_array_add(runs->summary.warnings,
                    g_strdup_printf(_("there is no error estimate: the companion run cannot be set up (%s)"), why));
}

static TinkerRelay *open_relay(const TinkerEstimate *estimate)
{
    TinkerComparison *comparison = estimate->comparison;
    const gboolean beside = tinker_comparison_has_companion(comparison) && estimate->runs->model->bodies < MANY_BODIES;
    gsize largest = tinker_comparison_sample_bytes(comparison);
    for (guint i = 0; i < estimate->runs->runs->len; i++)
        largest = MAX(largest, tinker_comparison_step_bytes(comparison, i, TINKER_MOST_POINTS));
    return tinker_relay_new(largest, beside, tinker_comparison_take, comparison);
}

static gboolean follow(void *follower, guint number, double t, GError **error);

TinkerEstimate *tinker_estimate_new(TinkerIslandRuns *runs, const GArray *columns)
{
    g_autoptr(GError) error = NULL;
    TinkerEstimate *estimate = g_new0(TinkerEstimate, 1);
    estimate->runs = runs;
    estimate->parts = g_new0(Part, runs->runs->len);
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

static void note_step(Part *part, TinkerIslandRun *run)
{
    part->length = run->state.t - part->reached;
    part->reached = run->state.t;
    if (!tinker_method_is_adaptive(run->choice.method)) return;
    part->extent = part->next_extent;
    part->speed = part->next_speed;
    scales_of(run, &part->next_extent, &part->next_speed);
}

static int32_t choose_landings(Part *part, double *times)
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
static int32_t choose_ends(Part *part, const TinkerIntegrator *method, double *times)
{
    int32_t points = 0;
    const double slack = TINKER_SAME_TIME_IN_STEP * part->grid.spacing, from = part->reached - part->length;
    double next;
    if (method->dense_order < method->order && part->grid.spacing > 0) {
        while ((next = tinker_time_grid_at(&part->grid, part->next_step)) <= from + slack)
            part->next_step++;
        for (; next < part->reached - slack && points < TINKER_MOST_POINTS - 1;
             next = tinker_time_grid_at(&part->grid, ++part->next_step))
            times[points++] = next;
    }
    times[points++] = part->reached;
    return points;
}

/* Where the two are compared in the step that the run has made, and where the companion goes from there. */
static int32_t choose_points(Part *part, const TinkerIslandRun *run, double *times)
{
    const TinkerIntegrator *method = run->choice.method;
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
    Part *part = &estimate->parts[number];
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    if (!part->compares || part->reached >= run->summary.determined_until) return TRUE;
    const TinkerComparisonState state = tinker_comparison_state(estimate->comparison);
    if (state != TINKER_COMPARISON_GOES_ON) return go_on_alone(estimate, state, error);
    const gboolean steps = run->state.t > part->reached;
    const double until = MIN(run->state.t, t);
    if (!steps && !(until > part->told)) return TRUE;
    TinkerStepNews step = {.kind = TINKER_NEWS_STEP, .island = number, .steps = steps, .until = until};
    if (steps) {
        note_step(part, run);
        step.points = choose_points(part, run, step.times);
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

/* How far an exact island has been from where it started, and how fast it has been on the way at least: its steps are
 * long, and where it has come to rest within the first they have seen no speed of it. */
static void note_swing(Part *part, const TinkerIslandRun *run)
{
    if (part->start == NULL) return;
    for (int32_t i = 0; i < run->system.system.size; i++)
        part->swing = fmax(part->swing, fabs(run->state.q[i] - part->start[i]));
    if (run->state.t > 0) part->mean_speed = fmax(part->mean_speed, part->swing / run->state.t);
}

/* Every step of an exact solution rounds its modes, and with a place that is off by epsilon of its swing a mode's
 * speed is off by w times that. Where something slow deflects what is stiff that is much beside the speed. In m/s,
 * as a random walk of the steps. */
static double rounding_of_speeds(const Part *part, const TinkerIslandRun *run)
{
    const gboolean exact = run->system.system.linear != NULL && tinker_method_is_exact(run->choice.method);
    if (part->start == NULL || !exact) return 0;
    return WALK * DBL_EPSILON * sqrt((double)run->summary.steps) * part->fastest * part->swing;
}

/* What rounding makes of an exact solution by time t. A frequency w that is off by one part in 1 / epsilon moves
 * places by epsilon w t of their swing and speeds by as much of theirs, which is epsilon t times the largest speed
 * and acceleration. */
static double rounding(TinkerEstimate *estimate, guint number, double t)
{
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    TinkerSystem *system = &run->system.system;
    Part *part = &estimate->parts[number];
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

/* Whether an island does nothing but rest on plates, or where a joint on a support holds it: what moves there is
 * rounding, and has no scale. */
static gboolean rests(const Part *part, const TinkerIslandRun *run, double extent)
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

/* Up to a sample, which a long step of the run has passed by far where motion begins: what it reaches at its end
 * would make little of errors that are large as yet. */
static void scales_at(TinkerEstimate *estimate, TinkerIslandRun *run, const Part *part, double t, double *extent,
                      double *speed)
{
    Bodies *then = &estimate->then, *now = &estimate->now;
    scales_of(run, extent, speed);
    if (!tinker_method_is_adaptive(run->choice.method) || t >= run->state.t || t < part->reached - part->length) return;
    if (tinker_island_run_unprojected_at(run, part->reached - part->length, then->q, then->v) != TINKER_OK ||
        tinker_island_run_unprojected_at(run, t, now->q, now->v) != TINKER_OK)
        return;
    *extent = fmin(*extent, part->extent + largest_way(run, then->q, now->q));
    for (int32_t i = 0; i < run->model->coordinates; i++)
        then->v[i] = 0;
    *speed = fmin(*speed, fmax(part->speed, largest_way(run, then->v, now->v)));
}

static TinkerIslandNews news_of(TinkerEstimate *estimate, guint number, double t)
{
    Part *part = &estimate->parts[number];
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    TinkerIslandNews news = {.determined = !(t > run->summary.determined_until)};
    if (!news.determined) return news;
    if (tinker_method_is_exact(run->choice.method) || run->aside.method != NULL)
        news.rounding = rounding(estimate, number, t);
    if (!part->compares) return news;
    scales_at(estimate, run, part, t, &news.extent, &news.speed);
    news.noise = tinker_island_run_speed_noise(run, news.extent);
    news.rests = rests(part, run, news.extent);
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
        g_ptr_array_add(
            estimate->runs->summary.warnings,
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

/* A run is deterministic, and sampling it changes no step. So it is run once with samples at even spacing, up to the
 * first between which a condition came to hold; then again with samples between these two, until they are as near to
 * each other as wanted. Events have their exact times from the run. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "measure/until-private.h"
#include "physics/record/sample-times.h"
#include "physics/run/simulation.h"

#define POINTS_AN_INTERVAL 8
#define POINTS_A_ROUND     1000
#define MOST_POINTS        10000000
#define NARROW             1e-11 /* s, or of the time */
#define MOST_ROUNDS        8
#define ROUNDING           (4 * DBL_EPSILON) /* of the largest that either side was */
#define POINTS_BETWEEN     256 /* calls back: a run that is not stepped, as one by "exact", makes none itself */

typedef struct {
    TinkerUntil *until;
    double from, to; /* s: between these it came to hold; to INFINITY: not yet */
    int number;      /* of the condition; -1 */
    gboolean events; /* there are conditions that are events */
    const TinkerRunOptions *options;
    guint points; /* since the last call back */
} Look;

static gboolean comes_to_hold(UntilCondition *condition, double t, const double *values)
{
    const double left = tinker_formula_value(condition->left, t, values);
    if (condition->kind == UNTIL_COMPARISON) {
        const gboolean holds = left != 0, now = holds && condition->idle;
        condition->idle = condition->idle || !holds;
        return now;
    }
    const double right = tinker_formula_value(condition->right, t, values), difference = left - right;
    /* what comes to stand still at the same number is apart by rounding, on whichever side */
    condition->largest = fmax(condition->largest, fmax(fabs(left), fabs(right)));
    const gboolean equal = fabs(difference) <= ROUNDING * condition->largest;
    const int side = equal ? 0 : (difference > 0) - (difference < 0), before = condition->side;
    if (side != 0) condition->side = side;
    return before != 0 && side != before;
}

/* Whether an event is of this kind. Whoever asks for an impact means any: "rest" is one after which nothing bounces. */
static gboolean is_of_kind(const TinkerEvent *event, const char *kind)
{
    return g_str_equal(event->kind, kind) || (g_str_equal(kind, "impact") && g_str_equal(event->kind, "rest"));
}

/* The first event of the kind after the start; INFINITY. */
static double time_of_event(const TinkerSummary *summary, const UntilCondition *condition)
{
    for (guint i = 0; i < summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(summary->events, i);
        g_auto(GStrv) blocks = g_strsplit(event->blocks != NULL ? event->blocks : "", ", ", -1);
        if (event->time > 0 && is_of_kind(event, condition->event) &&
            (condition->block == NULL || g_strv_contains((const char *const *)blocks, condition->block)))
            return event->time;
    }
    return INFINITY;
}

/* FALSE, with TINKER_MODEL_ERROR_STOPPED, where it is not to go on. */
static gboolean call_back(Look *self, double t, GError **error)
{
    const TinkerRunOptions *options = self->options;
    if (++self->points < POINTS_BETWEEN) return TRUE;
    self->points = 0;
    if (options->progress != NULL) options->progress(t, tinker_options_duration(options), options->data);
    if (options->cancelled == NULL || !options->cancelled(options->data)) return TRUE;
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED, "stopped");
    return FALSE;
}

static gboolean look(TinkerSimulation *simulation, double t, const double *values, void *data, GError **error)
{
    Look *self = data;
    const TinkerSummary *summary = self->events ? tinker_simulation_summary(simulation) : NULL;
    double first = INFINITY;
    for (guint i = 0; i < self->until->conditions->len; i++) {
        UntilCondition *condition = &g_array_index(self->until->conditions, UntilCondition, i);
        const double at = condition->kind == UNTIL_EVENT                             ? time_of_event(summary, condition)
                          : comes_to_hold(condition, self->until->start + t, values) ? t
                                                                                     : INFINITY;
        if (!(at <= t) || !(at < first)) continue;
        first = at;
        self->number = (int)i;
    }
    if (isinf(first)) {
        self->from = t;
        return call_back(self, t, error);
    }
    /* an event lies before the sample that tells of it, and is exact */
    if (first < t) self->from = first;
    self->to = first;
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED, "found");
    return FALSE;
}

/* Runs with these samples, up to the first at which a condition holds. */
static gboolean run_once(Look *self, TinkerModel *model, TinkerRunOptions options, const GArray *times, GError **error)
{
    g_autoptr(GError) failure = NULL;
    options.at = (const double *)(gconstpointer)times->data;
    options.at_count = times->len;
    options.estimate = options.bands = FALSE;
    options.accuracy = 0;
    for (guint i = 0; i < self->until->conditions->len; i++) {
        UntilCondition *condition = &g_array_index(self->until->conditions, UntilCondition, i);
        condition->side = 0;
        condition->idle = FALSE;
    }
    self->number = -1;
    self->from = 0;
    self->to = INFINITY;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, error);
    if (simulation == NULL) return FALSE;
    (void)tinker_simulation_run(simulation, self->until->columns, look, self, &failure);
    if (self->number >= 0 || !g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) return TRUE;
    g_propagate_error(error, g_steal_pointer(&failure));
    return FALSE;
}

/* 0, and points from `from` on to `to`. */
static GArray *spread(double from, double to, gsize count)
{
    GArray *times = g_array_new(FALSE, FALSE, sizeof(double));
    const double start = 0;
    g_array_append_val(times, start);
    for (gsize i = 0; i <= count; i++) {
        const double t = i == count ? to : from + (to - from) * ((double)i / (double)count);
        if (t > g_array_index(times, double, times->len - 1)) g_array_append_val(times, t);
    }
    return times;
}

gboolean tinker_until_find(TinkerUntil *until, TinkerModel *model, const TinkerRunOptions *options, double *time,
                           int *number, GError **error)
{
    Look found = {.until = until, .options = options};
    const double duration = tinker_options_duration(options);
    gsize count = (gsize)fmin(ceil(POINTS_AN_INTERVAL * duration / options->interval), MOST_POINTS);
    double from = 0, to = duration;
    for (guint i = 0; i < until->conditions->len; i++) {
        UntilCondition *condition = &g_array_index(until->conditions, UntilCondition, i);
        found.events |= condition->kind == UNTIL_EVENT;
        condition->largest = 0; /* of all rounds: the later ones do not see all of the run */
    }
    for (int round = 0; round < MOST_ROUNDS; round++) {
        g_autoptr(GArray) times = spread(from, to, MAX(count, 1));
        if (!run_once(&found, model, *options, times, error)) return FALSE;
        *time = found.to;
        *number = found.number;
        from = found.from;
        to = found.to;
        count = POINTS_A_ROUND;
        if (!(to - from > NARROW * fmax(1, to)) || isinf(to)) break;
    }
    return TRUE;
}

/* The times of samples of a run with these options that ends at `end`, which is the last. (transfer full) */
static GArray *samples_up_to(const TinkerRunOptions *options, double end)
{
    GArray *times = g_array_new(FALSE, FALSE, sizeof(double));
    TinkerSampleTimes all =
        tinker_sample_times(tinker_options_duration(options), options->interval, options->at, options->at_count);
    for (gint64 i = 0; i < all.count; i++) {
        const double t = tinker_sample_times_at(&all, i);
        if (t >= end) break;
        g_array_append_val(times, t);
    }
    g_array_append_val(times, end);
    tinker_sample_times_clear(&all);
    return times;
}

gboolean tinker_until_end(TinkerUntil *until, TinkerModel *model, double interval, TinkerRunOptions *options,
                          int *number, GError **error)
{
    double end;
    TinkerRunOptions search = *options;
    search.interval = interval;
    *number = -1;
    if (until->conditions->len == 0) return TRUE;
    if (!tinker_until_find(until, model, &search, &end, number, error)) return FALSE;
    if (*number < 0) return TRUE;
    GArray *samples = samples_up_to(options, end);
    g_clear_pointer(&until->samples, g_array_unref);
    until->samples = samples;
    options->at = (const double *)(gpointer)samples->data;
    options->at_count = samples->len;
    return TRUE;
}

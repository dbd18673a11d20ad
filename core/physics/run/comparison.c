/* The companion is a simulation of its own, on a model of its own: nothing that it does can change a bit of the run.
 * Each island's is stepped along with the run's, and compared at points of its steps and at samples, so that what is
 * claimed does not depend on how often somebody looks. */
#include "physics/run/comparison.h"

#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdatomic.h>
#include <string.h>

#include "physics/compile/compile.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/record/columns.h"
#include "physics/run/companion.h"
#include "physics/run/island-runs.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

/* No step of an adaptive companion is longer than this share of the run's. */
#define LONGEST_STEP 0.58
/* us: so long a companion that nobody waits for any more has to catch up. */
#define GRACE 300000

/* Of one island. */
typedef struct {
    double factor;             /* error over distance; 0 where rounding is all there is, and nothing is compared */
    double places, speeds;     /* m^2, m^2/s^2: squares of the largest distances so far */
    double error;              /* of the scales, at the sample looked at last */
    TinkerCompanionEnds *ends; /* NULL where they are not watched, or not any more */
    TinkerImpacts impacts;     /* of the run */
    double length, to,
        beyond; /* of its last step, see TinkerStepNews; and its points, of which the first are behind: */
    int32_t points, behind;
    double times[TINKER_MOST_POINTS];
    const double *states; /* in the news, or in what is kept of them */
    double *kept;
} Part;

struct _TinkerComparison {
    GArray *sizes; /* of int32_t: the coordinates of each island */
    guint islands;
    int32_t coordinates;
    TinkerModel *model;          /* of the companion */
    TinkerIslandRuns *companion; /* NULL where no island needs one */
    Part *parts;                 /* island by island */
    double *q, *v;               /* room for the coordinates of one */
    guint columns;               /* 0: no bands */
    gboolean *turns;             /* of each column: whether it starts again after 2 pi */
    double *bands;
    TinkerFindings findings;
    gint state;              /* atomic: a TinkerComparisonState */
    _Atomic gint64 deadline; /* us: then the companion stops; 0: never */
    GThread *owner;          /* whose the run is: it alone asks the user */
    TinkerRunOptions of_the_run;
};

/* Asked by the companion now and then. */
static gboolean is_late(void *data)
{
    TinkerComparison *self = data;
    const TinkerRunOptions *options = &self->of_the_run;
    gint64 deadline = atomic_load(&self->deadline);
    if (deadline == 0 && options->cancelled != NULL && g_thread_self() == self->owner &&
        options->cancelled(options->data)) {
        tinker_comparison_hurry(self);
        deadline = atomic_load(&self->deadline);
    }
    return deadline > 0 && g_get_monotonic_time() >= deadline;
}

static gboolean open_companion(TinkerComparison *self, TinkerIslandRuns *runs, const GArray *columns, GError **error)
{
    self->model = tinker_model_new(runs->model->scene, error);
    if (self->model == NULL) return FALSE;
    TinkerIslandRuns *companion = self->companion = tinker_companion_new(runs, self->model, error);
    if (companion == NULL) return FALSE;
    companion->options.cancelled = is_late;
    companion->options.data = self;
    if (columns != NULL && runs->options.bands) {
        self->columns = columns->len;
        self->findings.bands = self->bands = g_new0(double, columns->len + 1);
        tinker_island_runs_take_columns(companion, columns);
        self->turns = tinker_columns_turn(columns);
    }
    for (guint i = 0; i < self->islands; i++) {
        Part *part = &self->parts[i];
        TinkerIslandRun *other = g_ptr_array_index(companion->runs, i);
        part->ends = tinker_companion_ends_new(other);
        part->kept = g_new0(double, 2 * TINKER_MOST_POINTS * (gsize)other->model->coordinates);
        other->abandoned = part->factor == 0 && self->bands == NULL; /* nobody asks where it is */
    }
    return TRUE;
}

TinkerComparison *tinker_comparison_new(TinkerIslandRuns *runs, const GArray *columns, GError **error)
{
    TinkerComparison *self = g_new0(TinkerComparison, 1);
    gboolean compares = FALSE;
    self->sizes = g_array_new(FALSE, FALSE, sizeof(int32_t));
    self->islands = runs->runs->len;
    self->coordinates = runs->model->coordinates;
    self->parts = g_new0(Part, self->islands);
    self->q = g_new0(double, (gsize)self->coordinates + 1);
    self->v = g_new0(double, (gsize)self->coordinates + 1);
    self->findings = (TinkerFindings){.predictable_until = INFINITY};
    self->owner = g_thread_self();
    self->of_the_run = runs->options;
    for (guint i = 0; i < self->islands; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(runs->runs, i);
        g_array_append_val(self->sizes, run->model->coordinates);
        self->parts[i].factor = tinker_companion_factor(run);
        compares |= self->parts[i].factor > 0;
    }
    if (!compares || open_companion(self, runs, columns, error)) return self;
    tinker_comparison_free(self);
    return NULL;
}

void tinker_comparison_free(TinkerComparison *self)
{
    if (self == NULL) return;
    for (guint i = 0; i < self->islands; i++) {
        tinker_companion_ends_free(self->parts[i].ends);
        g_free(self->parts[i].kept);
    }
    tinker_island_runs_free(self->companion);
    tinker_model_free(self->model);
    g_array_unref(self->sizes);
    gpointer arrays[] = {self->parts, self->q, self->v, self->bands, self->turns, self->findings.failure};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

/* Distances -------------------------------------------------------------------------------------------------------- */

/* Where the companion has come to a point, or past it where it is exact, which states within its steps are then,
 * too. */
static void compare_at_point(TinkerComparison *self, Part *part, TinkerIslandRun *other)
{
    const gsize n = (gsize)other->model->coordinates;
    const double t = part->times[part->behind], *q = part->states + 2 * n * (gsize)part->behind;
    const double *other_q = other->state.q, *other_v = other->state.v;
    part->behind++;
    if (t != other->state.t && !tinker_method_is_exact(other->choice.method)) return;
    if (t != other->state.t || other->q != other->state.q) {
        if (tinker_island_run_unprojected_at(other, t, self->q, self->v) != TINKER_OK) return; /* a sample will tell */
        other_q = self->q;
        other_v = self->v;
    }
    part->places = tinker_largest_way(other->model, q, other_q, part->places);
    const TinkerImpacts impacts = tinker_impacts_of(other);
    if (tinker_impacts_let_speeds_tell(&part->impacts, &impacts, t))
        part->speeds = tinker_largest_way(other->model, q + n, other_v, part->speeds);
}

static void compare_samples(TinkerComparison *self, guint number, const TinkerIslandNews *news, const double *q,
                            const double *v, double t)
{
    const TinkerIslandRuns *companion = self->companion;
    const TinkerIslandRun *other = g_ptr_array_index(companion->runs, number);
    const TinkerImpacts impacts = tinker_impacts_of(other);
    const gboolean speeds = !tinker_impacts_are_near(&news->impacts, t) && !tinker_impacts_are_near(&impacts, t);
    Part *part = &self->parts[number];
    for (int32_t i = 0; i < other->model->bodies; i++) {
        const int32_t body = 2 * other->island->body_of[i];
        part->places = tinker_largest_square(1, q + body, companion->sample_q + body, part->places);
        if (speeds) part->speeds = tinker_largest_square(1, v + body, companion->sample_v + body, part->speeds);
        const int32_t turn = tinker_model_turn_of(companion->model, body / 2);
        if (turn < 0) continue;
        const double way = companion->sample_q[turn] - q[turn], change = companion->sample_v[turn] - v[turn];
        part->places = MAX(part->places, way * way);
        if (speeds) part->speeds = MAX(part->speeds, change * change);
    }
}

/* The largest distance of the two states of an island so far, by its scales at the sample: what was much beside the
 * first slow moments may be little beside what follows. */
static double distance(const Part *part, const TinkerIslandNews *news)
{
    if (news->rests) return 0;
    double places = news->extent > 0 ? sqrt(part->places) / news->extent : 0, speeds = 0;
    if (news->speed > news->noise) speeds = sqrt(part->speeds) / news->speed;
    return part->factor * fmax(places, speeds);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

static void tell_found(const TinkerComparison *self, double t)
{
    const TinkerRunOptions *options = &self->of_the_run;
    if (options->found == NULL) return;
    const TinkerFound found = {t, self->findings.error, self->findings.predictable_until, self->bands};
    options->found(&found, options->data);
}

/* A companion that cannot go on leaves everything behind it without an estimate and without bands. */
static void give_up(TinkerComparison *self, double t, guint warnings, GError *failed)
{
    TinkerFindings *findings = &self->findings;
    const gboolean stopped = g_error_matches(failed, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED);
    if (!stopped)
        findings->failure = g_strdup_printf(
            _("there is no error estimate beyond t = %.6g s: the companion run stopped (%s)"), t, failed->message);
    findings->failure_place = warnings;
    findings->error = NAN;
    for (guint c = 0; c < self->columns; c++)
        self->bands[c] = NAN;
    g_error_free(failed);
    tell_found(self, t);
    g_atomic_int_set(&self->state, stopped ? TINKER_COMPARISON_STOPPED : TINKER_COMPARISON_FAILED);
}

/* Where the next step of an adaptive companion ends: at the next point of the run's step, which the two are compared
 * at. FALSE where all are behind it: it waits for the run's next, or goes on to a sample as if the run did. */
static gboolean aim(Part *part, TinkerIslandRun *other)
{
    const double t = other->state.t;
    while (part->behind < part->points && part->times[part->behind] - t <= TINKER_SAME_INSTANT * part->to)
        part->behind++;
    const gboolean lands = part->behind < part->points;
    const double beyond = part->beyond > t ? part->beyond : t + LONGEST_STEP * part->length;
    other->latest = lands ? part->times[part->behind] : beyond;
    return lands;
}

/* The news go; what of them is still to be compared stays. */
static void keep_points(Part *part, int32_t coordinates)
{
    if (part->behind == part->points || part->states == part->kept) return;
    memcpy(part->kept, part->states, 2 * (gsize)coordinates * (gsize)part->points * sizeof(double));
    part->states = part->kept;
}

static void note_step(Part *part, const TinkerStepNews *news)
{
    part->impacts = news->impacts;
    if (!news->steps) return;
    part->length = news->length;
    part->to = news->to;
    part->beyond = news->beyond;
    part->points = news->points;
    part->behind = 0;
    part->states = (const double *)(gconstpointer)(news + 1);
    memcpy(part->times, news->times, sizeof part->times);
}

static void take_step(TinkerComparison *self, const TinkerStepNews *news)
{
    GError *failed = NULL;
    Part *part = &self->parts[news->island];
    TinkerIslandRun *other = g_ptr_array_index(self->companion->runs, news->island);
    note_step(part, news);
    for (;;) {
        while (part->behind < part->points && part->times[part->behind] <= other->state.t)
            compare_at_point(self, part, other);
        if (other->state.t >= news->until) break;
        if (tinker_method_is_adaptive(other->choice.method) && !aim(part, other)) break;
        if (part->ends != NULL && tinker_companion_look_at_ends(part->ends))
            g_clear_pointer(&part->ends, tinker_companion_ends_free);
        if (!tinker_island_runs_step(self->companion, news->island, &failed)) {
            give_up(self, other->state.t, news->warnings, failed);
            return;
        }
    }
    keep_points(part, other->model->coordinates);
}

/* Samples ---------------------------------------------------------------------------------------------------------- */

static void widen_bands(TinkerComparison *self, double t, const double *values)
{
    TinkerIslandRuns *companion = self->companion;
    if (tinker_island_runs_sample(companion, t) != TINKER_OK) return;
    double factor = 0;
    for (guint i = 0; i < self->islands; i++)
        factor = fmax(factor, self->parts[i].factor);
    for (guint c = 0; c < self->columns; c++) {
        double off = companion->values[c] - values[c];
        if (self->turns[c]) off = remainder(off, 2 * G_PI);
        self->bands[c] = fmax(self->bands[c], factor * fabs(off));
    }
}

/* Where one motion of many is followed the companion may follow another, and their distance is no error. FALSE where
 * some island is such. */
static gboolean abandon_undetermined(TinkerComparison *self, const TinkerIslandNews *islands)
{
    gboolean all = TRUE;
    for (guint i = 0; i < self->islands; i++) {
        if (islands[i].determined) continue;
        all = FALSE;
        if (self->companion == NULL) continue;
        ((TinkerIslandRun *)g_ptr_array_index(self->companion->runs, i))->abandoned = TRUE;
    }
    return all;
}

/* What an island is off by at the sample; of one that is not determined any more, what it was off by until then. */
static double error_of(TinkerComparison *self, guint number, const TinkerIslandNews *news, const double *q,
                       const double *v, double t)
{
    Part *part = &self->parts[number];
    if (!news->determined) return part->error;
    part->error = news->rounding;
    if (!(part->factor > 0)) return part->error;
    compare_samples(self, number, news, q, v, t);
    return part->error = fmax(part->error, distance(part, news));
}

static void take_sample(TinkerComparison *self, const TinkerSampleNews *news)
{
    GError *failed = NULL;
    TinkerFindings *findings = &self->findings;
    const TinkerIslandNews *islands = (const TinkerIslandNews *)(gconstpointer)(news + 1);
    const double *q = (const double *)(gconstpointer)(islands + self->islands), *v = q + (gsize)self->coordinates;
    const gboolean determined = abandon_undetermined(self, islands);
    if (self->companion != NULL && !tinker_island_runs_advance(self->companion, news->t, &failed)) {
        give_up(self, news->t, news->warnings, failed);
        return;
    }
    findings->error = TINKER_ERROR_FLOOR;
    for (guint i = 0; i < self->islands; i++)
        findings->error = fmax(findings->error, error_of(self, i, &islands[i], q, v, news->t));
    if (!(findings->error > TINKER_UNPREDICTABLE))
        findings->predictable_until = INFINITY;
    else if (isinf(findings->predictable_until))
        findings->predictable_until = news->t;
    if (self->bands != NULL && determined) widen_bands(self, news->t, v + (gsize)self->coordinates);
    tell_found(self, news->t);
}

/* News ------------------------------------------------------------------------------------------------------------- */

gboolean tinker_comparison_has_companion(const TinkerComparison *self)
{
    return self->companion != NULL;
}

guint tinker_comparison_columns(const TinkerComparison *self)
{
    return self->columns;
}

gsize tinker_comparison_step_bytes(const TinkerComparison *self, guint island, int32_t points)
{
    const int32_t coordinates = g_array_index(self->sizes, int32_t, island);
    return sizeof(TinkerStepNews) + 2 * (gsize)coordinates * (gsize)points * sizeof(double);
}

gsize tinker_comparison_sample_bytes(const TinkerComparison *self)
{
    const gsize states = self->companion != NULL ? 2 * (gsize)self->coordinates : 0;
    return sizeof(TinkerSampleNews) + self->islands * sizeof(TinkerIslandNews) +
           (states + self->columns) * sizeof(double);
}

void tinker_comparison_take(void *comparison, const void *news)
{
    TinkerComparison *self = comparison;
    if (g_atomic_int_get(&self->state) != TINKER_COMPARISON_GOES_ON) return;
    if (*(const TinkerNewsKind *)news == TINKER_NEWS_STEP)
        take_step(self, news);
    else
        take_sample(self, news);
}

TinkerComparisonState tinker_comparison_state(const TinkerComparison *self)
{
    return (TinkerComparisonState)g_atomic_int_get(&self->state);
}

void tinker_comparison_stop(TinkerComparison *self)
{
    atomic_store(&self->deadline, 1);
}

void tinker_comparison_hurry(TinkerComparison *self)
{
    gint64 none = 0;
    atomic_compare_exchange_strong(&self->deadline, &none, g_get_monotonic_time() + GRACE);
}

TinkerFindings *tinker_comparison_findings(TinkerComparison *self)
{
    return &self->findings;
}

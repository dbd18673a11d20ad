/* The companion is brought as far as the run has come, and what is found there is told. */
#include "physics/run/comparison-private.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/island/island-run.h"
#include "physics/run/tolerances.h"

/* No step of an adaptive companion is longer than this share of the run's. */
#define LONGEST_STEP 0.58

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
static gboolean aim(ComparisonPart *part, TinkerIslandRun *other)
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
static void keep_points(ComparisonPart *part, int32_t coordinates)
{
    if (part->behind == part->points || part->states == part->kept) return;
    memcpy(part->kept, part->states, 2 * (gsize)coordinates * (gsize)part->points * sizeof(double));
    part->states = part->kept;
}

static void note_step(ComparisonPart *part, const TinkerStepNews *news)
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

void comparison_take_step(TinkerComparison *self, const TinkerStepNews *news)
{
    GError *failed = NULL;
    ComparisonPart *part = &self->parts[news->island];
    TinkerIslandRun *other = g_ptr_array_index(self->companion->runs, news->island);
    note_step(part, news);
    for (;;) {
        while (part->behind < part->points && part->times[part->behind] <= other->state.t)
            comparison_look_at_point(self, part, other);
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

static gboolean is_at_impact(const TinkerImpacts *impacts, double t)
{
    return impacts->within == 0 && tinker_impacts_are_near(impacts, t);
}

/* Whether the run and the companion may stand on two sides of an impact. Those that last for whole steps are no
 * instants: near them speeds are to tell. */
static gboolean may_be_parted_by_impact(const TinkerComparison *self, const TinkerIslandNews *islands, double t)
{
    for (guint i = 0; i < self->islands; i++) {
        const TinkerImpacts theirs = tinker_impacts_of(g_ptr_array_index(self->companion->runs, i));
        if (is_at_impact(&islands[i].impacts, t) || is_at_impact(&theirs, t)) return TRUE;
    }
    return FALSE;
}

static void widen_bands(TinkerComparison *self, const TinkerIslandNews *islands, double t, const double *values)
{
    TinkerIslandRuns *companion = self->companion;
    if (tinker_island_runs_sample(companion, t) != TINKER_OK) return;
    const gboolean parted = may_be_parted_by_impact(self, islands, t);
    double factor = 0;
    for (guint i = 0; i < self->islands; i++)
        factor = fmax(factor, self->parts[i].factor);
    for (guint c = 0; c < self->columns; c++) {
        if (parted && !self->places[c]) continue;
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

/* When the error passed a tenth, of a sample at t that is the first to find it so. */
static double time_of_passing(const TinkerComparison *self, const TinkerIslandNews *islands, double t)
{
    double first = t;
    for (guint i = 0; i < self->islands; i++) {
        const ComparisonPart *part = &self->parts[i];
        if (!islands[i].determined || part->marks == NULL) continue;
        first = fmin(first, comparison_time_of(part, &islands[i], TINKER_UNPREDICTABLE, t));
    }
    return first;
}

void comparison_take_sample(TinkerComparison *self, const TinkerSampleNews *news)
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
        findings->error = fmax(findings->error, comparison_error_of(self, i, &islands[i], q, v, news->t));
    if (!(findings->error > TINKER_UNPREDICTABLE))
        findings->predictable_until = INFINITY;
    else if (isinf(findings->predictable_until))
        findings->predictable_until = time_of_passing(self, islands, news->t);
    for (guint i = 0; i < self->islands; i++)
        if (self->parts[i].marks != NULL) g_array_set_size(self->parts[i].marks, 0);
    if (self->bands != NULL && determined) widen_bands(self, islands, news->t, v + (gsize)self->coordinates);
    tell_found(self, news->t);
}

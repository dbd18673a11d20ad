/* How far the run and its companion are apart, island by island: at points of their steps, and at samples. */
#include "physics/run/comparison-private.h"

#include <math.h>

#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/system/method-call.h"

/* Of squares: between two marks a distance grows by a fiftieth at most. */
#define MARK_GROWTH 1.04

static void mark(ComparisonPart *part, double t)
{
    const ComparisonMark now = {t, part->places, part->speeds};
    if (part->marks->len > 0) {
        const ComparisonMark *last = &g_array_index(part->marks, ComparisonMark, part->marks->len - 1);
        if (now.places <= MARK_GROWTH * last->places && now.speeds <= MARK_GROWTH * last->speeds) return;
    }
    g_array_append_val(part->marks, now);
}

void comparison_look_at_point(TinkerComparison *self, ComparisonPart *part, TinkerIslandRun *other)
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
    mark(part, t);
}

static void compare_samples(TinkerComparison *self, guint number, const TinkerIslandNews *news, const double *q,
                            const double *v, double t)
{
    const TinkerIslandRuns *companion = self->companion;
    const TinkerIslandRun *other = g_ptr_array_index(companion->runs, number);
    const TinkerImpacts impacts = tinker_impacts_of(other);
    const gboolean speeds = !tinker_impacts_are_near(&news->impacts, t) && !tinker_impacts_are_near(&impacts, t);
    ComparisonPart *part = &self->parts[number];
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
static double distance(double factor, const TinkerIslandNews *news, double places_apart, double speeds_apart)
{
    if (news->rests) return 0;
    double places = news->extent > 0 ? sqrt(places_apart) / news->extent : 0, speeds = 0;
    if (news->speed > news->noise) speeds = sqrt(speeds_apart) / news->speed;
    return factor * fmax(places, speeds);
}

double comparison_time_of(const ComparisonPart *part, const TinkerIslandNews *news, double error, double t)
{
    for (guint i = 0; i < part->marks->len; i++) {
        const ComparisonMark *at = &g_array_index(part->marks, ComparisonMark, i);
        if (distance(part->factor, news, at->places, at->speeds) > error) return fmin(at->t, t);
    }
    return t;
}

double comparison_error_of(TinkerComparison *self, guint number, const TinkerIslandNews *news, const double *q,
                           const double *v, double t)
{
    ComparisonPart *part = &self->parts[number];
    if (!news->determined) return part->error;
    part->error = news->rounding;
    if (!(part->factor > 0)) return part->error;
    compare_samples(self, number, news, q, v, t);
    return part->error = fmax(part->error, distance(part->factor, news, part->places, part->speeds));
}

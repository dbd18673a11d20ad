#include "physics/run/sample-watch.h"

#include <math.h>

#include "physics/island/island-run.h"
#include "physics/model/points.h"
#include "physics/run/island-samples.h"

#define LEAST_SAMPLES 8    /* of fewer nobody expects a curve */
#define PLACES        3    /* at which samples miss a motion, at least: a single blow is no swing */
#define MISSED        0.2  /* of its range: so far from the line a curve is missed; a swing in a third of its period */
#define COUNTED       1e-3 /* of the largest range: what moves less is not looked at, */
#define STILL         1e-6 /* nor what moves less than this share of the scene's scales, */
#define NOISE         100  /* nor speeds within so many times their rounding */
#define MARGIN        0.02 /* of the way between two samples, next to either: nobody looks there */

/* To look costs as much as a sample. */
#define FIRST_LOOKS 64 /* between all of the first samples; */
#define LATER_LOOKS 32 /* between one pair of so many later */

/* Of a swing of angular frequency w, what its speed is off by scatters w times as much as what its place is off by,
 * whatever its phase at the samples. With this the interval is a twentieth of the period. */
#define INTERVAL (G_PI / 10)

enum { PLACE, SPEED, KINDS };

/* How one coordinate of the whole model, or its rate, goes on. */
typedef struct {
    double before;         /* at the last sample, where it is to be looked at behind that */
    double least, most;    /* of all that was seen */
    double missed[PLACES]; /* farthest from the line, in descending order */
    double sum, squares;   /* of distances from the line, */
    gint64 count;          /* and how many */
} Curve;

struct _TinkerSampleWatch {
    TinkerIslandRuns *runs;
    Curve *curves[KINDS];
    double *states[KINDS]; /* where the bodies of an island were seen, and how fast: of the whole model */
    double *seen;          /* s: of each island, when, since the last sample; NAN: it was not */
    double *began;         /* s: of each island, when its last step did */
    double *room;          /* which arrays of doubles lie in */
    double from, to;       /* s: the last sample and the next */
    double aim;            /* s: when to look */
    gint64 taken;          /* samples */
    gboolean looks;        /* between the last one and the next */
    guint events;          /* up to the last sample: behind one a speed may have jumped, which is no swing */
};

TinkerSampleWatch *tinker_sample_watch_new(TinkerIslandRuns *runs)
{
    if (runs->times.given != NULL || runs->times.count < LEAST_SAMPLES) return NULL;
    TinkerSampleWatch *watch = g_new0(TinkerSampleWatch, 1);
    const gsize coordinates = (gsize)runs->model->coordinates;
    watch->runs = runs;
    watch->room = g_new0(double, KINDS *coordinates + 2 * runs->runs->len);
    for (int k = 0; k < KINDS; k++) {
        watch->curves[k] = g_new0(Curve, MAX(coordinates, 1));
        watch->states[k] = watch->room + (gsize)k * coordinates;
    }
    watch->seen = watch->room + KINDS * coordinates;
    watch->began = watch->seen + runs->runs->len;
    for (int k = 0; k < KINDS; k++)
        for (gsize i = 0; i < coordinates; i++)
            watch->curves[k][i] = (Curve){.least = INFINITY, .most = -INFINITY};
    return watch;
}

void tinker_sample_watch_free(TinkerSampleWatch *watch)
{
    if (watch == NULL) return;
    for (int k = 0; k < KINDS; k++)
        g_free(watch->curves[k]);
    g_free(watch->room);
    g_free(watch);
}

static void keep_last_sample(TinkerSampleWatch *watch)
{
    for (int32_t i = 0; i < watch->runs->model->coordinates; i++) {
        watch->curves[PLACE][i].before = watch->runs->sample_q[i];
        watch->curves[SPEED][i].before = watch->runs->sample_v[i];
    }
    watch->events = watch->runs->summary.events->len;
    for (guint i = 0; i < watch->runs->runs->len; i++)
        watch->seen[i] = NAN;
}

void tinker_sample_watch_expect(TinkerSampleWatch *watch, double t)
{
    watch->from = watch->to;
    watch->to = t;
    watch->looks = watch->taken > 0 && (watch->taken <= FIRST_LOOKS || watch->taken % LATER_LOOKS == 0);
    if (!watch->looks) return;
    /* the golden ratio: no period has all looks at one phase */
    const double share = fmod(0.6180339887498949 * (double)watch->taken, 1);
    watch->aim = watch->from + (MARGIN + (1 - 2 * MARGIN) * share) * (t - watch->from);
    keep_last_sample(watch);
}

static gboolean is_exact(const TinkerIslandRun *run)
{
    return (run->choice.method->flags & TINKER_INTEGRATOR_LINEAR) != 0;
}

/* Looks at an island at the time that is aimed at, which lies in its last step. */
static void look_within(TinkerSampleWatch *watch, guint island)
{
    TinkerIslandRuns *runs = watch->runs;
    TinkerIslandRun *run = g_ptr_array_index(runs->runs, island);
    if (tinker_island_run_unprojected_at(run, watch->aim, runs->part_q, runs->part_v) != TINKER_OK) return;
    tinker_island_runs_spread(runs, run, runs->part_q, runs->part_v, watch->states[PLACE], watch->states[SPEED]);
    watch->seen[island] = watch->aim;
}

/* At its state. */
static void look_at_end(TinkerSampleWatch *watch, guint island)
{
    TinkerIslandRun *run = g_ptr_array_index(watch->runs->runs, island);
    tinker_island_run_place(run);
    tinker_island_runs_spread(watch->runs, run, run->q, run->v, watch->states[PLACE], watch->states[SPEED]);
    watch->seen[island] = run->state.t;
}

/* Steps of a method that are longer than the way between two samples follow a motion that samples show; those of an
 * exact solution are as long as anybody likes. */
void tinker_sample_watch_step(TinkerSampleWatch *watch, guint island, double from)
{
    watch->began[island] = from;
    if (!watch->looks || from > watch->aim) return;
    const TinkerIslandRun *run = g_ptr_array_index(watch->runs->runs, island);
    const double end = run->state.t, between = watch->to - watch->from;
    if (end < watch->aim || (!is_exact(run) && end - from >= between)) return;
    if (is_exact(run) || end > watch->to - MARGIN * between)
        look_within(watch, island);
    else
        look_at_end(watch, island);
}

static void widen(Curve *curve, double value)
{
    curve->least = fmin(curve->least, value);
    curve->most = fmax(curve->most, value);
}

static void compare(Curve *curve, double value, double off, gboolean counts)
{
    widen(curve, value);
    curve->sum += off;
    curve->squares += off * off;
    curve->count++;
    double missed = counts ? fabs(off) : 0;
    for (int i = 0; i < PLACES; i++) {
        if (!(missed > curve->missed[i])) continue;
        const double less = curve->missed[i];
        curve->missed[i] = missed;
        missed = less;
    }
}

/* Both curves of one coordinate, which was seen at this share of the way from sample to sample. */
static void compare_both(TinkerSampleWatch *watch, int32_t at, double share, gboolean jumped)
{
    const double *const now[KINDS] = {watch->runs->sample_q, watch->runs->sample_v};
    for (int k = 0; k < KINDS; k++) {
        Curve *curve = &watch->curves[k][at];
        const double value = watch->states[k][at], line = curve->before + share * (now[k][at] - curve->before);
        compare(curve, value, value - line, k == PLACE || !jumped);
    }
}

static void take_island(TinkerSampleWatch *watch, guint island)
{
    const TinkerIslandRuns *runs = watch->runs;
    const TinkerIslandRun *run = g_ptr_array_index(runs->runs, island);
    const double share = (watch->seen[island] - watch->from) / (watch->to - watch->from);
    const gboolean jumped =
        runs->summary.events->len != watch->events || tinker_method_solves_contact(run->choice.method);
    for (int32_t i = 0; i < run->model->coordinates; i++) {
        const int32_t at = tinker_island_runs_coordinate(runs, run, i);
        if (!isnan(share)) compare_both(watch, at, share, jumped);
        widen(&watch->curves[PLACE][at], runs->sample_q[at]);
        widen(&watch->curves[SPEED][at], runs->sample_v[at]);
    }
}

void tinker_sample_watch_take(TinkerSampleWatch *watch)
{
    for (guint i = 0; i < watch->runs->runs->len && watch->looks; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(watch->runs->runs, i);
        const gboolean passes_by = isnan(watch->seen[i]) && watch->began[i] <= watch->aim;
        if (passes_by && is_exact(run)) look_within(watch, i); /* its step has many samples */
        take_island(watch, i);
    }
    watch->taken++;
}

/* Of distances from the line, about their mean. */
static double variance_of(const Curve *curve)
{
    const double count = (double)curve->count, mean = curve->sum / count;
    return curve->squares / count - mean * mean;
}

static double range_of(const Curve *curve)
{
    return curve->most - curve->least;
}

/* What is missed most for its range. */
typedef struct {
    double share;  /* of its range */
    int32_t curve; /* the coordinate's number; -1: none is missed */
} Worst;

/* Among coordinates from `first` to before `end`; what moves within `still` from the place where it began rests, and so
 * does what moves as fast as within `slow`. */
static void find_worst(const TinkerSampleWatch *watch, int32_t first, int32_t end, double still, double slow,
                       Worst *worst)
{
    const double least[KINDS] = {still, slow};
    double largest[KINDS] = {0, 0};
    for (int k = 0; k < KINDS; k++)
        for (int32_t i = first; i < end; i++)
            largest[k] = fmax(largest[k], range_of(&watch->curves[k][i]));
    for (int k = 0; k < KINDS; k++) {
        for (int32_t i = first; i < end; i++) {
            const Curve *curve = &watch->curves[k][i];
            const double range = range_of(curve), share = curve->missed[PLACES - 1] / range;
            const gboolean moves = range_of(&watch->curves[PLACE][i]) > still;
            if (moves && range > fmax(COUNTED * largest[k], least[k]) && share > worst->share)
                *worst = (Worst){share, i};
        }
    }
}

/* Of all islands the largest: m, m/s, and m/s of rounding. */
static void find_scales(const TinkerIslandRuns *runs, double *extent, double *speed, double *noise)
{
    *extent = *speed = *noise = 0;
    for (guint i = 0; i < runs->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(runs->runs, i);
        double length = 0, fastest = 0;
        run->system.system.scales(&run->system, run->state.q, run->state.v, &length, &fastest);
        *extent = fmax(*extent, length);
        *speed = fmax(*speed, fastest);
        *noise = fmax(*noise, tinker_island_run_speed_noise(run, length));
    }
}

static Worst find_worst_of_all(const TinkerSampleWatch *watch)
{
    const TinkerModel *model = watch->runs->model;
    const int32_t turns = 2 * model->bodies, end = model->coordinates; /* angles follow lengths */
    Worst worst = {MISSED, -1};
    double extent, speed, noise;
    find_scales(watch->runs, &extent, &speed, &noise);
    const double slow = fmax(STILL * speed, NOISE * noise);
    find_worst(watch, 0, turns, STILL * extent, slow, &worst);
    /* what has no size has none to turn within */
    if (extent > 0) find_worst(watch, turns, end, STILL, slow / extent, &worst);
    return worst;
}

/* To one digit, downwards. */
static double round_down(double value)
{
    const double unit = pow(10, floor(log10(value)));
    return floor(value / unit) * unit;
}

void tinker_sample_watch_tell(const TinkerSampleWatch *watch, TinkerSummary *summary)
{
    const TinkerModel *model = watch->runs->model;
    const int32_t worst = find_worst_of_all(watch).curve;
    if (worst < 0) return;
    const int32_t body = worst < 2 * model->bodies ? worst / 2 : tinker_model_moved_by(model, worst);
    const double place = variance_of(&watch->curves[PLACE][worst]), speed = variance_of(&watch->curves[SPEED][worst]);
    if (!(place > 0) || !(speed > 0)) return;
    tinker_summary_warn_of_samples(summary, tinker_scene_block_name(model->scene, model->body_blocks[body]),
                                   watch->runs->times.grid.spacing, round_down(INTERVAL * sqrt(place / speed)));
}

/* The reference: methods are refined one after another, the most promising first, until two different ones agree. What
 * they agree to, and what the last refinement of the better one left, is all that is known of the true motion, so no
 * smaller error is ever claimed: methods of one family err alike at the same step.
 *
 * Where two runs that finer settings no longer change part from one another, rounding has grown to what is seen: the
 * motion is not predictable beyond. Where a run could not be made finer in the time it had, they agree to less, but for
 * as long as the run lasts. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/trade/trade-private.h"
#include "physics/model/model.h"

#define MOST_CANDIDATES      5
#define ROUNDING             (100 * 2.220446049250313e-16)
#define WANTED_SHARE         0.1   /* of the error that is wished for: what the reference has to be confirmed to */
#define COARSEST_WANTED      1e-4  /* whatever is wished for */
#define GOOD_ENOUGH          1e-11 /* no third method is asked beyond */
#define COARSE_LEVEL         1e-3  /* what agrees to less, for want of time, is cut where it parts */
#define WORST_LEVEL          0.1   /* what agrees to less is no reference */
#define LEAST_AGREED         2     /* samples */
#define FINEST_TOLERANCE     1e-13
#define FIRST_TOLERANCE      1e-7
#define TOLERANCE_FACTOR     1e-2
#define MOST_HALVINGS        60
#define FIRST_STEPS          32 /* of a fixed-step method: its largest step is this part of the duration */
#define SLOWER_PER_HALVING   2.0
#define SLOWER_PER_TOLERANCE 2.2

/* A method, made as fine as it gets. */
typedef struct {
    TinkerTradeSetting setting;
    TinkerTrajectory trajectory; /* empty: no run succeeded */
    double change;               /* from the next coarser run to this one */
    double left;                 /* of that change, the share that finer runs would still make, all together */
    gboolean unfinished;         /* time ran out before finer settings stopped changing it */
} Candidate;

static double rank(const TinkerIntegrator *integrator)
{
    double rank = integrator->order;
    if (integrator->flags & TINKER_INTEGRATOR_ADAPTIVE) rank += 100;
    if (integrator->flags & TINKER_INTEGRATOR_LINEAR) rank += 1000;
    return rank;
}

static int by_rank(const void *a, const void *b)
{
    double first = rank(*(const TinkerIntegrator *const *)a), second = rank(*(const TinkerIntegrator *const *)b);
    return (first < second) - (first > second);
}

/* One more run of the candidate, finer than the one it holds. FALSE: it failed or took too long; then `hopeless` says
 * whether the method does not take this scene at all. */
static gboolean refine_once(TinkerTradeBench *bench, Candidate *candidate, double value, double most,
                            gboolean *hopeless)
{
    g_auto(TinkerTrajectory) finer = {0};
    g_autoptr(GError) failure = NULL;
    TinkerTradeSetting setting = candidate->setting;
    setting.value = value;
    if (!tinker_trade_bench_sample(bench, setting, most, &finer, &failure)) {
        *hopeless = !g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN) &&
                    !g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED);
        return FALSE;
    }
    *hopeless = FALSE;
    candidate->change = candidate->trajectory.states == NULL
                            ? INFINITY
                            : tinker_trade_bench_distance(bench, &candidate->trajectory, &finer, bench->time_count,
                                                          finer.extent, finer.speed);
    tinker_trajectory_clear(&candidate->trajectory);
    candidate->trajectory = finer;
    finer.states = NULL;
    candidate->setting.value = value;
    return TRUE;
}

static void refine_tolerance(TinkerTradeBench *bench, Candidate *candidate, double seconds)
{
    double end = tinker_trade_bench_elapsed(bench) + seconds;
    for (double tolerance = FIRST_TOLERANCE; tolerance > 0.5 * FINEST_TOLERANCE; tolerance *= TOLERANCE_FACTOR) {
        double left = end - tinker_trade_bench_elapsed(bench);
        gboolean hopeless = FALSE;
        candidate->unfinished =
            !(left > 0 && candidate->trajectory.wall_s * SLOWER_PER_TOLERANCE <= left) ||
            (!refine_once(bench, candidate, tolerance, left, &hopeless) && tinker_trade_bench_elapsed(bench) >= end);
        if (candidate->unfinished || hopeless || bench->cancelled) return;
    }
}

/* Halves the step until that changes nothing any more: the changes then stop falling. */
static void refine_step(TinkerTradeBench *bench, Candidate *candidate, double seconds)
{
    double end = tinker_trade_bench_elapsed(bench) + seconds, step = bench->duration / FIRST_STEPS;
    double smallest = INFINITY;
    for (int halving = 0; halving < MOST_HALVINGS && !bench->cancelled; halving++, step /= 2) {
        double left = end - tinker_trade_bench_elapsed(bench);
        candidate->unfinished = !(left > 0 && candidate->trajectory.wall_s * SLOWER_PER_HALVING <= left);
        if (candidate->unfinished) return;
        gboolean hopeless;
        if (!refine_once(bench, candidate, step, left, &hopeless)) {
            if (hopeless) return;
            continue;
        }
        if (candidate->change <= ROUNDING) return;
        if (smallest < 1e-6 && candidate->change > 0.7 * smallest) return;
        smallest = fmin(smallest, candidate->change);
    }
}

static void refine(TinkerTradeBench *bench, Candidate *candidate, const TinkerIntegrator *integrator, double seconds)
{
    gboolean adaptive = (integrator->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    const double left = adaptive ? TOLERANCE_FACTOR : 1 / (exp2(integrator->order) - 1);
    *candidate = (Candidate){.setting = {integrator->id, adaptive, 0}, .change = INFINITY, .left = left};
    (adaptive ? refine_tolerance : refine_step)(bench, candidate, seconds);
    /* One that knows the solution has no coarser run to be told from. */
    if (integrator->flags & TINKER_INTEGRATOR_LINEAR) {
        candidate->change = 0;
        candidate->setting.value = 0;
    }
}

/* Pairs ------------------------------------------------------------------------------------------------------------ */

typedef struct {
    const Candidate *truth, *witness;
    double level;        /* over the whole run, and no less than what refining the truth left */
    gsize agreed;        /* samples up to which they agree as wanted */
    gboolean unfinished; /* one of them could have been made finer */
} Pair;

/* What finer runs would still change; INFINITY where one run alone does not tell. */
static double left_of(const Candidate *candidate)
{
    return isfinite(candidate->change) ? candidate->change * candidate->left : INFINITY;
}

static Pair compare(const TinkerTradeBench *bench, const Candidate *a, const Candidate *b, double wanted)
{
    gboolean a_first = left_of(a) <= left_of(b);
    Pair pair = {a_first ? a : b, a_first ? b : a, 0, 0, a->unfinished || b->unfinished};
    const TinkerTrajectory *truth = &pair.truth->trajectory, *witness = &pair.witness->trajectory;
    pair.level = tinker_trade_bench_distance(bench, truth, witness, bench->time_count, truth->extent, truth->speed);
    if (isfinite(left_of(pair.truth))) pair.level = fmax(pair.level, left_of(pair.truth));
    gsize low = 0, high = bench->time_count; /* the distance over the first n samples never falls with n */
    while (low < high) {
        gsize middle = (low + high + 1) / 2;
        double level = tinker_trade_bench_distance(bench, truth, witness, middle, truth->extent, truth->speed);
        if (level <= wanted)
            low = middle;
        else
            high = middle - 1;
    }
    pair.agreed = low;
    return pair;
}

static gboolean is_better(const Pair *pair, const Pair *than)
{
    if (pair->agreed != than->agreed) return pair->agreed > than->agreed;
    if (pair->unfinished != than->unfinished && than->truth != NULL) return than->unfinished;
    return pair->level < than->level;
}

static Pair best_pair(const TinkerTradeBench *bench, const Candidate *candidates, guint count, double wanted)
{
    Pair best = {.level = INFINITY};
    for (guint a = 0; a < count; a++)
        for (guint b = 0; b < a; b++) {
            Pair pair = compare(bench, &candidates[a], &candidates[b], wanted);
            if (is_better(&pair, &best)) best = pair;
        }
    return best;
}

static gboolean no_reference(TinkerTradeBench *bench, const Candidate *candidates, guint count, GError **error)
{
    if (bench->cancelled) {
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED,
                    _("stopped before two methods had confirmed a reference: nothing was measured"));
        return FALSE;
    }
    g_autoptr(GString) names = g_string_new(NULL);
    for (guint i = 0; i < count; i++)
        g_string_append_printf(names, "%s%s", i > 0 ? ", " : "", candidates[i].setting.method);
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
        _("no two methods agree on this motion to %g of its extent, so there is nothing to measure errors against "
          "(%s; shorten the duration, or give more time)"),
        WORST_LEVEL, count > 0 ? names->str : _("none of them runs it to its end"));
    return FALSE;
}

/* Fills the candidates, the most promising first, until two of them agree well enough; answers how many. */
static guint find_candidates(TinkerTradeBench *bench, const GPtrArray *integrators, double seconds, double wanted,
                             Candidate *candidates)
{
    g_autoptr(GPtrArray) ranked = g_ptr_array_new();
    for (guint i = 0; i < integrators->len; i++)
        g_ptr_array_add(ranked, g_ptr_array_index(integrators, i));
    qsort(ranked->pdata, ranked->len, sizeof(gpointer), by_rank);
    guint count = 0;
    double begun = tinker_trade_bench_elapsed(bench);
    for (guint i = 0; i < ranked->len && count < MOST_CANDIDATES && !tinker_trade_bench_look(bench); i++) {
        double left = begun + seconds - tinker_trade_bench_elapsed(bench);
        if (count >= 2) {
            Pair pair = best_pair(bench, candidates, count, wanted);
            gboolean whole = pair.agreed == bench->time_count;
            gboolean settled = whole ? pair.level <= GOOD_ENOUGH || left < 0.5 * seconds : !pair.unfinished;
            if (settled || left <= 0) break;
        }
        refine(bench, &candidates[count], g_ptr_array_index(ranked, i), fmax(left, 0.2 * seconds) / 3);
        if (candidates[count].trajectory.states != NULL) count++;
    }
    return count;
}

/* What the pair is good for: all of the run, or as far as it agrees. */
static void judge(const TinkerTradeBench *bench, const Pair *pair, TinkerTradeReference *reference, gsize *samples)
{
    const TinkerTrajectory *truth = &pair->truth->trajectory, *witness = &pair->witness->trajectory;
    gboolean whole = pair->agreed == bench->time_count || (pair->unfinished && pair->level <= COARSE_LEVEL) ||
                     pair->agreed < LEAST_AGREED;
    *samples = whole ? bench->time_count : pair->agreed;
    const double level = *samples == bench->time_count ? pair->level
                                                       : tinker_trade_bench_distance(bench, truth, witness, *samples,
                                                                                     truth->extent, truth->speed);
    *reference = (TinkerTradeReference){
        .truth = pair->truth->setting,
        .witness = pair->witness->setting,
        .level = fmax(level, ROUNDING),
        .until = bench->times[*samples - 1],
        .whole = whole,
        .predictable = whole || pair->unfinished,
        .extent = truth->extent,
        .speed = truth->speed,
    };
}

gboolean tinker_trade_find_reference(TinkerTradeBench *bench, const GPtrArray *integrators, double seconds,
                                     TinkerTradeReference *reference, TinkerTrajectory *truth, gsize *samples,
                                     GError **error)
{
    Candidate candidates[MOST_CANDIDATES + 1] = {0};
    double wanted = fmin(WANTED_SHARE * bench->options->error, COARSEST_WANTED);
    guint count = find_candidates(bench, integrators, seconds, wanted, candidates);
    Pair pair = best_pair(bench, candidates, count, wanted);
    gboolean found =
        pair.truth != NULL && (pair.agreed >= LEAST_AGREED || pair.level <= WORST_LEVEL) && !bench->cancelled;
    if (found) {
        judge(bench, &pair, reference, samples);
        Candidate *chosen = &candidates[pair.truth - candidates];
        *truth = chosen->trajectory;
        chosen->trajectory.states = NULL;
    } else {
        no_reference(bench, candidates, count, error);
    }
    for (guint i = 0; i < G_N_ELEMENTS(candidates); i++)
        tinker_trajectory_clear(&candidates[i].trajectory);
    return found;
}

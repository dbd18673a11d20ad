/* Work against precision: what an error costs with each method of ours and with those of other people's solvers, on a
 * damped oscillator (S1), a double pendulum (S2) and a stiff chain (S6), all timed in turns within one run.
 *
 * Ours go the way of every scene: text, blocks of plugins, compiled model, watched run. The clock sees the steps, and
 * the time before the first is shown beside them. Theirs are handed the equations. */
#include <math.h>
#include <string.h>

#include "contest.h"
#include "numerics/exact/exact.h"
#include "peers.h"
#include "physics/island/island-run.h"
#include "physics/plan/run-options.h"
#include "physics/run/island-steps.h"
#include "physics/run/simulation-private.h"
#include "physics/run/simulation.h"
#include "scene-text.h"
#include "subject.h"

#define OSCILLATOR_SAMPLES 6000

/* Ours ------------------------------------------------------------------------------------------------------------- */

typedef struct {
    BenchmarkSubject subject;
    const PeerProblem *problem;
    char **blocks;  /* whose places are looked at, ended by NULL */
    double *places; /* along x, where the problem's coordinate of each block is 0; NULL: it has the places themselves */
    int samples;    /* that an exact method is asked for; 1: that at the end */
    double *q, *v;  /* room for one */
} Run;

static void free_run(gpointer data)
{
    Run *run = data;
    benchmark_subject_clear(&run->subject);
    g_strfreev(run->blocks);
    g_free(run->places);
    g_free(run->q);
    g_free(run->v);
    g_free(run);
}

/* The state in the order of the problem; rates are of no interest. */
static double error_now(Run *run)
{
    double y[PEER_MOST_RATES] = {0};
    for (int i = 0; run->blocks[i] != NULL; i++) {
        double place[2];
        benchmark_subject_place(&run->subject, run->blocks[i], place);
        if (run->places != NULL)
            y[2 * i] = place[0] - run->places[i];
        else
            memcpy(y + 2 * i, place, sizeof place);
    }
    return run->problem->error(tinker_simulation_time(run->subject.simulation), y);
}

/* What an exact method is asked for on the way, as far as the run has got. */
static void look_back(Run *run, TinkerIslandRun *island, int *seen)
{
    double interval = run->problem->duration / run->samples;
    for (; *seen + 1 < run->samples && (*seen + 1) * interval < island->state.t; (*seen)++)
        tinker_island_run_state_at(island, (*seen + 1) * interval, run->q, run->v);
}

/* To the end. */
static double go(Run *run, gboolean looks)
{
    g_autoptr(GError) error = NULL;
    double duration = run->problem->duration, worst = 0;
    TinkerIslandRun *island = g_ptr_array_index(run->subject.simulation->all->runs, 0);
    int seen = 0;
    while (island->state.t < duration) {
        if (!tinker_island_run_step(island, duration, &error)) return INFINITY;
        look_back(run, island, &seen);
        if (looks) worst = fmax(worst, error_now(run));
    }
    return worst;
}

static double time_run(gpointer data)
{
    Run *run = data;
    benchmark_subject_restart(&run->subject);
    double started = benchmark_processor_time();
    go(run, FALSE);
    return benchmark_processor_time() - started;
}

static double time_preparing(Run *run)
{
    double times[9];
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++) {
        g_clear_pointer(&run->subject.simulation, tinker_simulation_free);
        double started = benchmark_processor_time();
        benchmark_subject_restart(&run->subject);
        times[i] = benchmark_processor_time() - started;
    }
    return benchmark_summarize(times, G_N_ELEMENTS(times)).median;
}

/* A scene that is entered again and again. */
typedef struct {
    Contest *contest;
    const PeerProblem *problem;
    char *text, **blocks;
    double *places;
} Entry;

static void enter(const Entry *entry, const char *method, const char *setting, double value)
{
    Run *run = g_new0(Run, 1);
    gboolean samples = strcmp(setting, "samples") == 0, tolerance = strcmp(setting, "tolerance") == 0;
    run->problem = entry->problem;
    run->samples = samples ? (int)value : 1;
    run->blocks = g_strdupv(entry->blocks);
    if (entry->places != NULL) run->places = g_memdup2(entry->places, g_strv_length(entry->blocks) * sizeof(double));
    run->subject = benchmark_subject(entry->text, method, strcmp(setting, "step") == 0 ? value : 0.01);
    TinkerRunOptions *options = &run->subject.options;
    if (tolerance) options->tolerance = value;
    options->duration = options->interval = entry->problem->duration;
    options->estimate = FALSE;
    benchmark_subject_restart(&run->subject);
    TinkerIslandRun *island = g_ptr_array_index(run->subject.simulation->all->runs, 0);
    run->q = g_new0(double, (gsize)island->model->coordinates);
    run->v = g_new0(double, (gsize)island->model->coordinates);
    const TinkerIntegrator *chosen = island->choice.method;
    gboolean is_auto = strcmp(method, "auto") == 0;
    Contestant contestant = {
        .solver = is_auto ? g_strdup_printf("auto: %s", chosen->id) : g_strdup(method),
        .side = chosen->flags & TINKER_INTEGRATOR_LINEAR ? CONTEST_OURS_EXACT : CONTEST_OURS,
        .setting = setting,
        .value = value,
        .once = time_run,
        .data = run,
        .free_data = free_run,
    };
    double worst = go(run, entry->problem->everywhere);
    contestant.error = entry->problem->everywhere || !isfinite(worst) ? worst : error_now(run);
    contestant.preparing = time_preparing(run);
    if (isfinite(contestant.error)) {
        contest_add(entry->contest, &contestant);
        return;
    }
    g_free(contestant.solver);
    free_run(run);
}

static void enter_all(const Entry *entry, const char *method, const char *setting, double from, double to,
                      double factor)
{
    for (double value = from; value >= 0.999 * to; value *= factor)
        enter(entry, method, setting, value);
}

static void clear_entry(Entry *entry)
{
    g_free(entry->text);
    g_strfreev(entry->blocks);
    g_free(entry->places);
}

/* Theirs ----------------------------------------------------------------------------------------------------------- */

typedef struct {
    const Peer *peer;
    const PeerProblem *problem;
    double tolerance, worst;
} PeerRun;

static void look_at_peer(double t, const double *y, void *data)
{
    PeerRun *run = data;
    run->worst = fmax(run->worst, run->problem->error(t, y));
}

static double time_peer(gpointer data)
{
    const PeerRun *run = data;
    double y[PEER_MOST_RATES], started = benchmark_processor_time();
    run->peer->solve(run->peer, run->problem, run->tolerance, y, NULL, NULL);
    return benchmark_processor_time() - started;
}

static ContestSide side_of(const PeerProblem *problem)
{
    return strcmp(problem->form, "angles") == 0 ? CONTEST_ANGLES : CONTEST_PEER;
}

static char *name_of(const char *maker, const char *method, const PeerProblem *problem)
{
    return g_strdup_printf("%s %s%s", maker, method, side_of(problem) == CONTEST_ANGLES ? ", angles" : "");
}

static void enter_peer(Contest *contest, const Peer *peer, const PeerProblem *problem, double tolerance)
{
    PeerRun *run = g_new0(PeerRun, 1);
    *run = (PeerRun){peer, problem, tolerance, 0};
    double y[PEER_MOST_RATES];
    gboolean solved = peer->solve(peer, problem, tolerance, y, problem->everywhere ? look_at_peer : NULL,
                                  problem->everywhere ? run : NULL);
    Contestant contestant = {
        .solver = name_of(peer->maker, peer->method, problem),
        .side = side_of(problem),
        .setting = "tolerance",
        .value = tolerance,
        .error = problem->everywhere ? run->worst : problem->error(problem->duration, y),
        .preparing = NAN,
        .once = time_peer,
        .data = run,
        .free_data = g_free,
    };
    if (solved && isfinite(contestant.error)) {
        contest_add(contest, &contestant);
        return;
    }
    g_free(contestant.solver);
    g_free(run);
}

static void enter_peers(Contest *contest, const Peer *peers)
{
    for (const PeerProblem *problem = peer_problems(); problem->scene != NULL; problem++) {
        gboolean stiff = problem->half_band > 0;
        if (strcmp(problem->scene, contest->scene) != 0) continue;
        for (const Peer *peer = peers; peer->maker != NULL; peer++)
            for (double tolerance = 1e-2; tolerance > (stiff ? 5e-7 : 5e-13); tolerance *= 0.1)
                if (stiff ? peer->takes_stiff : peer->takes_smooth) enter_peer(contest, peer, problem, tolerance);
    }
}

static void enter_scipy(Contest *contest)
{
    g_autoptr(GArray) rows = peer_scipy(contest->scene);
    for (guint i = 0; i < rows->len; i++) {
        const PeerScipyRow *row = &g_array_index(rows, PeerScipyRow, i);
        Contestant contestant = {
            .solver = name_of("SciPy", row->method, row->problem),
            .side = side_of(row->problem),
            .setting = "tolerance",
            .value = row->tolerance,
            .error = row->error,
            .preparing = NAN,
            .timing = {row->median, row->least},
        };
        contest_add(contest, &contestant);
    }
}

static void hold(Entry *entry, BenchmarkReport *report)
{
    enter_peers(entry->contest, peer_gsl());
    enter_peers(entry->contest, peer_sundials());
    enter_scipy(entry->contest);
    contest_hold(entry->contest, report);
    contest_free(entry->contest);
    clear_entry(entry);
}

/* The scenes ------------------------------------------------------------------------------------------------------- */

static Entry open_entry(const char *scene, char *text, int masses)
{
    Entry entry = {contest_new(scene), peer_problem_find(scene, "Cartesian"), text, g_new0(char *, masses + 1), NULL};
    for (int i = 0; i < masses; i++)
        entry.blocks[i] = g_strdup_printf("M%d", i);
    return entry;
}

static void race_oscillator(BenchmarkReport *report)
{
    if (!benchmark_report_wants(report, "S1")) return;
    Entry entry = open_entry("S1", benchmark_oscillator(FALSE), 1);
    entry.places = g_new0(double, 1);
    entry.places[0] = 2.0;
    enter(&entry, "exact", "samples", 10);
    enter(&entry, "exact", "samples", OSCILLATOR_SAMPLES);
    enter_all(&entry, "dop853", "tolerance", 1e-1, 1e-13, 0.1);
    enter_all(&entry, "dopri5", "tolerance", 1e-1, 1e-11, 0.1);
    enter_all(&entry, "verlet6", "step", 0.08, 0.0025, 0.5);
    enter_all(&entry, "rk4", "step", 0.08, 0.00125, 0.5);
    hold(&entry, report);
}

static void race_double_pendulum(BenchmarkReport *report)
{
    const double level[2] = {G_PI / 2, G_PI / 2};
    if (!benchmark_report_wants(report, "S2")) return;
    Entry entry = open_entry("S2", benchmark_chain(2, level, 1.0), 2);
    enter_all(&entry, "auto", "tolerance", 1e-2, 1e-10, 0.1);
    enter_all(&entry, "dop853", "tolerance", 1e-1, 1e-13, 0.1);
    enter_all(&entry, "dopri5", "tolerance", 1e-1, 1e-11, 0.1);
    enter_all(&entry, "verlet6", "step", 0.016, 0.0005, 0.5);
    enter_all(&entry, "rk4", "step", 0.016, 0.0005, 0.5);
    hold(&entry, report);
}

static void race_stiff_chain(BenchmarkReport *report)
{
    if (!benchmark_report_wants(report, "S6")) return;
    Entry entry = open_entry("S6", benchmark_stiff_chain(), BENCHMARK_STIFF_MASSES);
    entry.places = benchmark_line_rests(BENCHMARK_STIFF_MASSES);
    enter_all(&entry, "auto", "tolerance", 1e-2, 1e-9, 0.1);
    enter_all(&entry, "newmark", "step", 0.04, 0.0003125, 0.5);
    enter_all(&entry, "generalized-alpha", "step", 0.02, 0.0003125, 0.5);
    enter(&entry, "exact", "samples", 1);
    enter_all(&entry, "rk4", "step", 1.9e-4, 1.9e-4, 0.5);
    hold(&entry, report);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    race_oscillator(report);
    race_double_pendulum(report);
    race_stiff_chain(report);
    return benchmark_report_end(report);
}

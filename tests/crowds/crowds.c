/* Crowds of bodies in a box, run by events: `crowds [--scenes N] [--seed N] [--most N] [--until S] [--patience S]
 * [--verbose] [--compare] [--claims] [--print]` writes a line for each that stops, overlaps, gains energy or does not
 * balance its books, and fails where there is one; with --claims, for each that is off by more than it claims, too. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "build-catalogue.h"
#include "crowd-run.h"

#define TOLERANCE 1e-9
/* The largest imbalance and gain of energy, relative; m: the largest overlap. */
#define MOST_IMBALANCE 1e-6
#define MOST_GAIN      1e-6
#define MOST_OVERLAP   1e-6
/* m: two runs at tolerances a thousand times apart part by so much from one sample to the next only where one of them
 * decided otherwise; and are as one before. */
#define APART    1e-2
#define TOGETHER 1e-7
/* The tolerance of what is taken for the truth; of a claim: so well it has to be known; errors above this are no longer
 * claimed. */
#define TRUTH       1e-13
#define KNOWN       0.25
#define PREDICTABLE 0.1

typedef struct {
    gint scenes, seed, most;
    double until, patience;
    gboolean verbose, print, compare, claims;
} Options;

typedef struct {
    guint runs, stopped, faulty, judged, beyond;
    double imbalance, gain, overlap, seconds;
} Tally;

/* Says where the same crowd at a tighter tolerance goes elsewhere all at once. */
static void compare(TinkerCatalogue *catalogue, const Options *options, const Crowd *crowd, const CrowdRun *run,
                    guint32 seed)
{
    g_autoptr(GError) error = NULL;
    CrowdRun tight;
    if (!crowd_run(catalogue, crowd, 1e-3 * TOLERANCE, 10 * options->patience, FALSE, &tight, &error))
        printf("seed %u, tight: %s\n", seed, error->message);
    double before = 0;
    for (guint i = 0; i < MIN(run->samples, tight.samples); i++) {
        double apart = 0;
        for (int b = 0; b < crowd->count; b++) {
            const guint at = (guint)((int)i * crowd->count + b) * CROWD_COLUMNS;
            for (guint k = 0; k < 3; k++)
                apart = fmax(
                    apart, fabs(g_array_index(run->rows, double, at + k) - g_array_index(tight.rows, double, at + k)));
        }
        if (before < TOGETHER && apart > 100 * fmax(before, TOGETHER))
            printf("seed %u: parts from its truth from %.2g to %.2g within the sample to t = %.6f s\n", seed, before,
                   apart, crowd->duration * i / CROWD_SAMPLES);
        before = fmax(before, apart);
    }
    crowd_run_clear(&tight);
}

/* The largest error up to each sample: places by the size of the box, speeds by the largest there was. (transfer full)
 */
static double *errors_of(const Crowd *crowd, const CrowdRun *run, const CrowdRun *truth, guint samples)
{
    const double extent = hypot(crowd->inside[0], crowd->inside[1]);
    double *errors = g_new(double, MAX(samples, 1)), apart = 0, faster = 0, speed = 0;
    for (guint i = 0; i < samples; i++) {
        for (guint at = i * (guint)crowd->count * CROWD_COLUMNS, end = at + (guint)crowd->count * CROWD_COLUMNS;
             at < end; at += CROWD_COLUMNS) {
            const double *is = &g_array_index(run->rows, double, at), *ought = &g_array_index(truth->rows, double, at);
            apart = fmax(apart, hypot(is[0] - ought[0], is[1] - ought[1]));
            faster = fmax(faster, hypot(is[3] - ought[3], is[4] - ought[4]));
            speed = fmax(speed, hypot(ought[3], ought[4]));
        }
        errors[i] = fmax(apart / extent, faster / speed);
    }
    return errors;
}

/* Up to where it calls itself predictable, and where two runs nearer to the truth tell what that is. */
static void judge_claims(TinkerCatalogue *catalogue, const Options *options, const Crowd *crowd, const CrowdRun *run,
                         guint32 seed, Tally *tally)
{
    CrowdRun truth, other;
    double worst = 1, at = 0, claimed = 0;
    crowd_run(catalogue, crowd, TRUTH, 10 * options->patience, FALSE, &truth, NULL);
    crowd_run(catalogue, crowd, 10 * TRUTH, 10 * options->patience, FALSE, &other, NULL);
    const guint samples = MIN(run->samples, MIN(truth.samples, other.samples));
    g_autofree double *errors = errors_of(crowd, run, &truth, samples);
    g_autofree double *doubts = errors_of(crowd, &other, &truth, samples);
    for (guint i = 1; i < samples; i++) {
        const double claim = g_array_index(run->claims, double, i);
        if (!(claim < PREDICTABLE) || doubts[i] > KNOWN * claim) break;
        tally->judged++;
        tally->beyond += errors[i] > claim;
        if (!(errors[i] > worst * claim)) continue;
        worst = errors[i] / claim;
        at = crowd->duration * i / CROWD_SAMPLES;
        claimed = claim;
    }
    if (worst > 1) printf("seed %u: off by %.3g times the claim, %.2g, at %.6f s\n", seed, worst, claimed, at);
    crowd_run_clear(&truth);
    crowd_run_clear(&other);
}

static void judge(TinkerCatalogue *catalogue, const Options *options, guint32 seed, Tally *tally)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(Crowd) crowd = crowd_new(seed, options->most);
    CrowdRun run;
    crowd->duration = fmin(crowd->duration, options->until);
    if (options->print) {
        printf("%s", crowd->text);
        return;
    }
    const gboolean done = crowd_run(catalogue, crowd, TOLERANCE, options->patience, options->claims, &run, &error);
    const gboolean faulty = run.balance > MOST_IMBALANCE || run.gain > MOST_GAIN || run.overlap > MOST_OVERLAP;
    tally->runs++;
    tally->stopped += !done;
    tally->faulty += faulty;
    tally->imbalance = fmax(tally->imbalance, run.balance);
    tally->gain = fmax(tally->gain, run.gain);
    tally->overlap = fmax(tally->overlap, run.overlap);
    tally->seconds += run.seconds;
    if (!done) printf("seed %u stops after %.1f s: %s\n", seed, run.seconds, error->message);
    if (options->verbose || faulty)
        printf("seed %u%s: %d bodies, friction %.2f, e %.2f, %.2f s; %" G_GINT64_FORMAT
               " changes, balance %.2g, gain %.2g at %.3f s, overlap %.2g m at %.3f s, %.1f s\n",
               seed, faulty ? " FAULTY" : "", crowd->count, crowd->friction, crowd->restitution, crowd->duration,
               run.changes, run.balance, run.gain, run.gain_time, run.overlap, run.overlap_time, run.seconds);
    if (options->compare) compare(catalogue, options, crowd, &run, seed);
    if (options->claims) judge_claims(catalogue, options, crowd, &run, seed, tally);
    fflush(stdout);
    crowd_run_clear(&run);
}

static gboolean read_options(int argc, char **argv, Options *options)
{
    GOptionEntry entries[] = {
        {"scenes", 0, 0, G_OPTION_ARG_INT, &options->scenes, "how many", "N"},
        {"seed", 0, 0, G_OPTION_ARG_INT, &options->seed, "of the first of them", "N"},
        {"most", 0, 0, G_OPTION_ARG_INT, &options->most, "bodies", "N"},
        {"until", 0, 0, G_OPTION_ARG_DOUBLE, &options->until, "of the motion, at the most", "SECONDS"},
        {"patience", 0, 0, G_OPTION_ARG_DOUBLE, &options->patience, "of processor time for a run", "SECONDS"},
        {"verbose", 0, 0, G_OPTION_ARG_NONE, &options->verbose, "a line for each", NULL},
        {"compare", 0, 0, G_OPTION_ARG_NONE, &options->compare, "with a tighter tolerance", NULL},
        {"claims", 0, 0, G_OPTION_ARG_NONE, &options->claims, "and what its error estimate says", NULL},
        {"print", 0, 0, G_OPTION_ARG_NONE, &options->print, "writes the scenes instead of running them", NULL},
        G_OPTION_ENTRY_NULL,
    };
    g_autoptr(GError) error = NULL;
    g_autoptr(GOptionContext) context = g_option_context_new(NULL);
    g_option_context_add_main_entries(context, entries, NULL);
    const gboolean read = g_option_context_parse(context, &argc, &argv, &error);
    if (!read) fprintf(stderr, "%s\n", error->message);
    options->most = CLAMP(options->most, 3, CROWD_MOST_BODIES);
    return read;
}

int main(int argc, char **argv)
{
    Options options = {.scenes = 10, .seed = 1, .most = CROWD_MOST_BODIES, .until = INFINITY, .patience = 60};
    Tally tally = {.overlap = -INFINITY};
    if (!read_options(argc, argv, &options)) return 2;
    TinkerCatalogue *catalogue = test_build_catalogue();
    for (gint i = 0; i < options.scenes; i++)
        judge(catalogue, &options, (guint32)(options.seed + i), &tally);
    tinker_catalogue_free(catalogue);
    if (options.print) return EXIT_SUCCESS;
    printf("%u runs, %u stopped, %u faulty; imbalance %.2g, gain %.2g, overlap %.2g m at most; %.1f s\n", tally.runs,
           tally.stopped, tally.faulty, tally.imbalance, tally.gain, tally.overlap, tally.seconds);
    if (options.claims) printf("%u of %u samples are off by more than they claim\n", tally.beyond, tally.judged);
    const gboolean looked = tally.runs > 0 && (!options.claims || tally.judged > 0);
    return looked && tally.stopped + tally.faulty + tally.beyond == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

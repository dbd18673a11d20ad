/* Holds the error estimate to what it claims, over random scenes of every kind: `estimate-honesty [--scenes N] [--seed
 * N]
 * [--kind TEXT] [--method TEXT] [--verbose]` prints a table and fails where too many samples are off by more than is
 * claimed. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "build-catalogue.h"
#include "honest-run.h"

/* Shares of the samples whose error is above what is claimed, and above twice that; of the runs that stop. */
#define MOST_ABOVE       0.05
#define MOST_ABOVE_TWICE 0.01
#define MOST_STOPPED     0.02

static const HonestyMethod methods[] = {
    {"auto 1e-9", "auto", 1e-9, 0},     {"auto 1e-6", "auto", 1e-6, 0},       {"auto 1e-3", "auto", 1e-3, 0},
    {"dopri5 1e-5", "dopri5", 1e-5, 0}, {"dop853 1e-11", "dop853", 1e-11, 0}, {"rk4", "rk4", 1e-9, 20},
    {"verlet", "verlet", 1e-9, 40},
};

/* What was found of a kind, or of a method. */
typedef struct {
    const char *name;
    GArray *samples;
    guint runs, stopped, left_out;
} Tally;

typedef struct {
    gint scenes, seed;
    char *kind, *method;
    gboolean verbose, print;
} Options;

static int by_value(const void *left, const void *right)
{
    double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

static guint count_above(const GArray *samples, double factor)
{
    guint above = 0;
    for (guint i = 0; i < samples->len; i++) {
        const HonestySample *sample = &g_array_index(samples, HonestySample, i);
        above += sample->error > factor * sample->claimed;
    }
    return above;
}

static double share(guint count, guint of)
{
    return of > 0 ? (double)count / of : 0;
}

static void print_tally(const Tally *tally)
{
    const GArray *samples = tally->samples;
    g_autofree double *ratios = g_new0(double, samples->len + 1);
    for (guint i = 0; i < samples->len; i++) {
        const HonestySample *sample = &g_array_index(samples, HonestySample, i);
        ratios[i] = sample->claimed / sample->error;
    }
    qsort(ratios, samples->len, sizeof(double), by_value);
    double median = samples->len > 0 ? ratios[samples->len / 2] : NAN;
    double high = samples->len > 0 ? ratios[(gsize)(0.95 * samples->len)] : NAN;
    printf("%-18s %5u %4u %7u %7u %7.2f %7.2f %9.2g %7.3g %9.3g\n", tally->name, tally->runs, tally->stopped,
           samples->len, tally->left_out, 100 * share(count_above(samples, 1), samples->len),
           100 * share(count_above(samples, 2), samples->len), samples->len > 0 ? ratios[0] : NAN, median, high);
}

static void print_head(const char *what)
{
    printf("\n%-18s %5s %4s %7s %7s %7s %7s %9s %7s %9s\n", what, "runs", "stop", "samples", "out", "> 1 %", "> 2 %",
           "least", "median", "95 % <");
}

static void judge_scene(const HonestyTruth *truth, const HonestyMethod *method, Tally *kind, Tally *by_method,
                        guint seed, gboolean verbose)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GArray) samples = g_array_new(FALSE, FALSE, sizeof(HonestySample));
    guint left_out = 0;
    gboolean done = honesty_judge(truth, method, samples, &left_out, &error);
    Tally *tallies[] = {kind, by_method};
    for (gsize i = 0; i < G_N_ELEMENTS(tallies); i++) {
        tallies[i]->runs++;
        tallies[i]->stopped += !done;
        tallies[i]->left_out += left_out;
        g_array_append_vals(tallies[i]->samples, samples->data, samples->len);
    }
    if (!done) printf("# %s, seed %u, %s: %s\n", kind->name, seed, method->name, error->message);
    guint above = count_above(samples, 1);
    if (!verbose || above == 0) return;
    double worst = 0;
    for (guint i = 0; i < samples->len; i++) {
        const HonestySample *sample = &g_array_index(samples, HonestySample, i);
        worst = fmax(worst, sample->error / sample->claimed);
    }
    const HonestySample *last = &g_array_index(samples, HonestySample, samples->len - 1);
    printf("# %s, seed %u, %s: %u of %u samples above, up to %.3g times; error %.2g, claimed %.2g\n", kind->name, seed,
           method->name, above, samples->len, worst, last->error, last->claimed);
}

static void run_scene(TinkerCatalogue *catalogue, const Options *options, guint number, guint seed, Tally *kind,
                      Tally *by_method)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(RandomScene) text = random_scene_new(number, seed);
    if (options->print) {
        printf("%s", text->text);
        return;
    }
    g_autoptr(HonestyTruth) truth = honesty_truth_new(catalogue, text, seed, &error);
    if (truth == NULL) {
        printf("# %s, seed %u: no truth: %s\n", kind->name, seed, error->message);
        kind->stopped++;
        kind->runs++;
        return;
    }
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++)
        if (options->method == NULL || g_str_equal(options->method, methods[m].name))
            judge_scene(truth, &methods[m], kind, &by_method[m], seed, options->verbose);
}

static void tally_init(Tally *tally, const char *name)
{
    *tally = (Tally){name, g_array_new(FALSE, FALSE, sizeof(HonestySample)), 0, 0, 0};
}

static void add_to(Tally *all, const Tally *part)
{
    g_array_append_vals(all->samples, part->samples->data, part->samples->len);
    all->runs += part->runs;
    all->stopped += part->stopped;
    all->left_out += part->left_out;
}

/* Answers the program's exit status. */
static int sum_up(Tally *kinds, Tally *by_method)
{
    Tally all;
    tally_init(&all, "all");
    print_head("kind");
    for (guint k = 0; random_scene_kinds[k] != NULL; k++) {
        if (kinds[k].runs > 0) print_tally(&kinds[k]);
        add_to(&all, &kinds[k]);
        g_array_unref(kinds[k].samples);
    }
    print_head("method");
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        if (by_method[m].runs > 0) print_tally(&by_method[m]);
        g_array_unref(by_method[m].samples);
    }
    printf("\n");
    print_tally(&all);
    gboolean honest = share(count_above(all.samples, 1), all.samples->len) <= MOST_ABOVE &&
                      share(count_above(all.samples, 2), all.samples->len) <= MOST_ABOVE_TWICE &&
                      share(all.stopped, all.runs) <= MOST_STOPPED && all.samples->len > 0;
    g_array_unref(all.samples);
    return honest ? EXIT_SUCCESS : EXIT_FAILURE;
}

static gboolean read_options(int argc, char **argv, Options *options)
{
    GOptionEntry entries[] = {
        {"scenes", 0, 0, G_OPTION_ARG_INT, &options->scenes, "of each kind", "N"},
        {"seed", 0, 0, G_OPTION_ARG_INT, &options->seed, "of the first of them", "N"},
        {"kind", 0, 0, G_OPTION_ARG_STRING, &options->kind, "only these scenes", "TEXT"},
        {"method", 0, 0, G_OPTION_ARG_STRING, &options->method, "only this one", "TEXT"},
        {"verbose", 0, 0, G_OPTION_ARG_NONE, &options->verbose, "names runs that claim too little", NULL},
        {"print", 0, 0, G_OPTION_ARG_NONE, &options->print, "writes the scenes instead of running them", NULL},
        G_OPTION_ENTRY_NULL,
    };
    g_autoptr(GError) error = NULL;
    g_autoptr(GOptionContext) context = g_option_context_new(NULL);
    g_option_context_add_main_entries(context, entries, NULL);
    if (g_option_context_parse(context, &argc, &argv, &error)) return TRUE;
    fprintf(stderr, "%s\n", error->message);
    return FALSE;
}

int main(int argc, char **argv)
{
    Options options = {.scenes = 10, .seed = 1};
    if (!read_options(argc, argv, &options)) return 2;
    TinkerCatalogue *catalogue = test_build_catalogue();
    guint count = g_strv_length((char **)random_scene_kinds);
    g_autofree Tally *kinds = g_new0(Tally, count);
    Tally by_method[G_N_ELEMENTS(methods)];
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++)
        tally_init(&by_method[m], methods[m].name);
    for (guint k = 0; k < count; k++) {
        tally_init(&kinds[k], random_scene_kinds[k]);
        if (options.kind != NULL && !g_str_equal(options.kind, random_scene_kinds[k])) continue;
        for (gint i = 0; i < options.scenes; i++)
            run_scene(catalogue, &options, k, (guint)(options.seed + i), &kinds[k], by_method);
        if (options.verbose) fflush(stdout);
    }
    int status = sum_up(kinds, by_method);
    tinker_catalogue_free(catalogue);
    g_free(options.kind);
    g_free(options.method);
    return status;
}

/* Timing in turns, the table, the verdict; see the header. */
#include "contest.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define ROUNDS        9
#define ROUND_SECONDS 0.002 /* of one contestant in one round, at least */
#define MOST_SECONDS  0.5   /* of one contestant in all rounds, about */
#define WORST_ERROR   0.1   /* beyond it nothing was solved */

static void clear_contestant(gpointer data)
{
    Contestant *contestant = data;
    g_free(contestant->solver);
    if (contestant->free_data != NULL) contestant->free_data(contestant->data);
}

Contest *contest_new(const char *scene)
{
    Contest *contest = g_new0(Contest, 1);
    contest->scene = scene;
    contest->contestants = g_array_new(FALSE, FALSE, sizeof(Contestant));
    g_array_set_clear_func(contest->contestants, clear_contestant);
    return contest;
}

void contest_free(Contest *contest)
{
    g_array_unref(contest->contestants);
    g_free(contest);
}

void contest_add(Contest *contest, const Contestant *contestant)
{
    g_array_append_vals(contest->contestants, contestant, 1);
}

/* Timing ----------------------------------------------------------------------------------------------------------- */

static double time_once(const Contestant *contestant)
{
    double seconds = 0;
    int times = 0;
    for (; seconds < ROUND_SECONDS; times++)
        seconds += contestant->once(contestant->data);
    return seconds / times;
}

static void time_all(Contest *contest)
{
    guint count = contest->contestants->len;
    g_autofree double *values = g_new0(double, ROUNDS *count);
    g_autofree gsize *taken = g_new0(gsize, count);
    for (int round = 0; round < ROUNDS; round++)
        for (guint i = 0; i < count; i++) {
            const Contestant *contestant = &g_array_index(contest->contestants, Contestant, i);
            gboolean enough = taken[i] > 0 && (double)taken[i] * values[ROUNDS * i] > MOST_SECONDS;
            if (contestant->once != NULL && !enough) values[ROUNDS * i + taken[i]++] = time_once(contestant);
        }
    for (guint i = 0; i < count; i++) {
        Contestant *contestant = &g_array_index(contest->contestants, Contestant, i);
        if (contestant->once != NULL) contestant->timing = benchmark_summarize(values + ROUNDS * i, taken[i]);
    }
}

/* The table -------------------------------------------------------------------------------------------------------- */

static const char *const side_names[] = {"ours", "ours, exact", "peer", "peer, angles"};

static cJSON *item_of(const Contest *contest, const Contestant *contestant)
{
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "scene", contest->scene);
    cJSON_AddStringToObject(item, "solver", contestant->solver);
    cJSON_AddStringToObject(item, "side", side_names[contestant->side]);
    cJSON_AddStringToObject(item, "setting", contestant->setting);
    cJSON_AddNumberToObject(item, "value", contestant->value);
    cJSON_AddNumberToObject(item, "error", contestant->error);
    cJSON_AddNumberToObject(item, "seconds_median", contestant->timing.median);
    cJSON_AddNumberToObject(item, "seconds_least", contestant->timing.minimum);
    if (isfinite(contestant->preparing)) cJSON_AddNumberToObject(item, "seconds_preparing", contestant->preparing);
    return item;
}

static void print_table(const Contest *contest, BenchmarkReport *report)
{
    printf("\n%-5s %-24s %-13s %-9s %9s %10s %12s %12s %12s\n", "SCENE", "SOLVER", "SIDE", "SETTING", "VALUE", "ERROR",
           "MEDIAN [us]", "LEAST [us]", "BEFORE [us]");
    for (guint i = 0; i < contest->contestants->len; i++) {
        const Contestant *each = &g_array_index(contest->contestants, Contestant, i);
        printf("%-5s %-24s %-13s %-9s %9.3g %10.2e %12.2f %12.2f", contest->scene, each->solver, side_names[each->side],
               each->setting, each->value, each->error, 1e6 * each->timing.median, 1e6 * each->timing.minimum);
        if (isfinite(each->preparing)) printf(" %12.2f", 1e6 * each->preparing);
        printf("\n");
        benchmark_report_add(report, "precision", item_of(contest, each));
    }
}

/* The verdict ------------------------------------------------------------------------------------------------------ */

static gboolean is_ours(const Contestant *contestant, gboolean with_exact)
{
    return contestant->side == CONTEST_OURS || (with_exact && contestant->side == CONTEST_OURS_EXACT);
}

/* Between two settings of one solver, along the straight line of logarithms. INFINITY where they do not embrace it. */
static double time_between(const Contestant *coarse, const Contestant *fine, double error)
{
    if (strcmp(coarse->solver, fine->solver) != 0 || !(coarse->error > error && fine->error <= error)) return INFINITY;
    double share = log(coarse->error / error) / log(coarse->error / fine->error);
    return coarse->timing.minimum * pow(fine->timing.minimum / coarse->timing.minimum, share);
}

/* The least time in which one of ours is at least that accurate. */
static double our_time(const Contest *contest, double error, gboolean with_exact, const char **solver)
{
    double least = INFINITY;
    for (guint i = 0; i < contest->contestants->len; i++) {
        const Contestant *each = &g_array_index(contest->contestants, Contestant, i);
        if (!is_ours(each, with_exact)) continue;
        double time = each->error <= error ? each->timing.minimum : INFINITY;
        if (i > 0) time = fmin(time, time_between(each - 1, each, error));
        if (time >= least) continue;
        least = time;
        *solver = each->solver;
    }
    return least;
}

static void judge(const Contest *contest, BenchmarkReport *report, gboolean with_exact)
{
    const char *which = with_exact ? "all methods" : "without exact";
    double nearest = INFINITY;
    g_autofree char *nearest_text = NULL;
    int faster = 0, all = 0;
    for (guint i = 0; i < contest->contestants->len; i++) {
        const Contestant *peer = &g_array_index(contest->contestants, Contestant, i);
        const char *solver = "none of ours";
        if (peer->side != CONTEST_PEER || !(peer->error <= WORST_ERROR)) continue;
        double ratio = peer->timing.minimum / our_time(contest, peer->error, with_exact, &solver);
        g_autofree char *text = g_strdup_printf("%s at an error of %.1e takes %.2f times as long as %s", peer->solver,
                                                peer->error, ratio, solver);
        faster += ratio < 1.0;
        all++;
        if (ratio >= nearest) continue;
        nearest = ratio;
        g_free(nearest_text);
        nearest_text = g_steal_pointer(&text);
    }
    g_autofree char *verdict =
        nearest_text == NULL ? g_strdup("there was no peer")
        : faster > 0
            ? g_strdup_printf("peers are faster at %d of their %d points; the fastest, %s", faster, all, nearest_text)
            : g_strdup_printf("no peer is faster at any error; the nearest, %s", nearest_text);
    printf("%s, %s: %s\n", contest->scene, which, verdict);
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "scene", contest->scene);
    cJSON_AddStringToObject(item, "methods", which);
    cJSON_AddStringToObject(item, "verdict", verdict);
    benchmark_report_add(report, "verdicts", item);
}

void contest_hold(Contest *contest, BenchmarkReport *report)
{
    time_all(contest);
    print_table(contest, report);
    judge(contest, report, TRUE);
    judge(contest, report, FALSE);
}

/* How often a run of each bundled scene is made anew while a hand turns a number of it, as a slider does: the mass of
 * its first body that has one. No window, but the window's own document, player and hand. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>
#include <time.h>

#include "build-catalogue.h"
#include "gui/instrument/hand.h"
#include "report.h"

#define TURNED   2.0  /* s: for so long */
#define TURN_MS  5    /* between two values */
#define EXTENT   0.02 /* of the number */
#define GOAL_MS  50.0 /* a run: 20 a second */
#define ENDING   ".tinker.json"
#define QUANTITY "mass"

typedef struct {
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerHand *hand;
    TinkerBlockId block;
    double value, phase;
    guint generation; /* of the run that was counted last */
    guint runs;       /* that have come to their end */
    gboolean over;
} Turning;

/* Processor time of all threads, ms. */
static double process_time(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * (double)time.tv_sec + 1e-6 * (double)time.tv_nsec;
}

static gboolean turn(gpointer data)
{
    Turning *turning = data;
    TinkerRunStatus status;
    const guint generation = tinker_player_generation(turning->player);
    if (generation != turning->generation && tinker_player_status(turning->player, &status) && status.finished) {
        turning->generation = generation;
        turning->runs++;
    }
    turning->phase += 0.1;
    tinker_hand_set(turning->hand, turning->block, QUANTITY, turning->value * (1 + EXTENT * sin(turning->phase)));
    return G_SOURCE_CONTINUE;
}

static gboolean end(gpointer data)
{
    ((Turning *)data)->over = TRUE;
    return G_SOURCE_REMOVE;
}

static gboolean find_number(Turning *turning)
{
    TinkerScene *scene = tinker_document_scene(turning->document);
    TinkerNumber number;
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        turning->block = tinker_scene_block_at(scene, place);
        if (tinker_scene_block_class(scene, turning->block) == NULL ||
            !tinker_scene_find_number(scene, turning->block, QUANTITY, &number))
            continue;
        turning->value = tinker_scene_get(scene, turning->block, number.column);
        return TRUE;
    }
    return FALSE;
}

static void report_scene(BenchmarkReport *report, TinkerCatalogue *catalogue, const char *folder, const char *name)
{
    g_autofree char *path = g_build_filename(folder, name, NULL), *text = NULL;
    g_autofree char *scene = g_strndup(name, strlen(name) - strlen(ENDING));
    gsize length;
    if (!benchmark_report_wants(report, scene) || !g_file_get_contents(path, &text, &length, NULL)) return;
    Turning turning = {.document = tinker_document_new(catalogue)};
    turning.player = tinker_player_new(turning.document);
    turning.hand = tinker_hand_new(turning.document, turning.player);
    if (tinker_document_start(turning.document, text, length, path, NULL) && find_number(&turning)) {
        const double began = process_time();
        const guint timer = g_timeout_add(TURN_MS, turn, &turning);
        g_timeout_add((guint)(1e3 * TURNED), end, &turning);
        while (!turning.over)
            g_main_context_iteration(NULL, TRUE);
        g_source_remove(timer);
        const double runs = MAX(turning.runs, 1);
        benchmark_report_figure(report, scene, "time that goes by a run", 1e3 * TURNED / runs, "ms", GOAL_MS);
        benchmark_report_figure(report, scene, "processor time a run, everything", (process_time() - began) / runs,
                                "ms", GOAL_MS);
    }
    tinker_hand_free(turning.hand);
    g_object_unref(turning.player);
    g_object_unref(turning.document);
}

static int compare_names(const void *left, const void *right)
{
    return strcmp(*(char *const *)left, *(char *const *)right);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    const char *folder = g_getenv("TINKER_SCENES");
    g_autoptr(GDir) scenes = g_dir_open(folder != NULL ? folder : "host/scenes", 0, NULL);
    g_autoptr(GPtrArray) names = g_ptr_array_new_with_free_func(g_free);
    for (const char *name = NULL; scenes != NULL && (name = g_dir_read_name(scenes)) != NULL;)
        if (g_str_has_suffix(name, ENDING)) g_ptr_array_add(names, g_strdup(name));
    g_ptr_array_sort(names, compare_names);
    TinkerCatalogue *catalogue = test_build_catalogue();
    for (guint i = 0; i < names->len; i++)
        report_scene(report, catalogue, folder != NULL ? folder : "host/scenes", g_ptr_array_index(names, i));
    return benchmark_report_end(report);
}

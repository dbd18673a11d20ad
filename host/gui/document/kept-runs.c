/* A run that is kept shares its tasks with the player, and lives on when that one forgets them. */
#include "gui/document/kept-runs.h"

#include <glib/gi18n.h>

#include <string.h>

#include "measure/changes.h"
#include "scene/frame/tops.h"

struct _TinkerKeptRuns {
    GObject parent_instance;
    GPtrArray *runs; /* of TinkerKeptRun */
    guint next_id;
};

G_DEFINE_FINAL_TYPE(TinkerKeptRuns, tinker_kept_runs, G_TYPE_OBJECT)

static guint changed;

static void run_free(gpointer data)
{
    TinkerKeptRun *run = data;
    g_clear_pointer(&run->frame, tinker_frame_free);
    tinker_recording_clear(&run->recording);
    tinker_scene_free(run->scene);
    g_free(run->name);
    g_free(run);
}

guint tinker_kept_runs_count(TinkerKeptRuns *runs)
{
    return runs->runs->len;
}

TinkerKeptRun *tinker_kept_runs_at(TinkerKeptRuns *runs, guint place)
{
    return g_ptr_array_index(runs->runs, place);
}

static int free_number(TinkerKeptRuns *runs)
{
    for (int number = 0;; number++) {
        gboolean taken = FALSE;
        for (guint i = 0; i < runs->runs->len; i++)
            taken |= tinker_kept_runs_at(runs, i)->number == number;
        if (!taken) return number;
    }
}

static TinkerKeptRun *newest(TinkerKeptRuns *runs)
{
    return runs->runs->len > 0 ? tinker_kept_runs_at(runs, runs->runs->len - 1) : NULL;
}

static gboolean is_taken(TinkerKeptRuns *runs, const TinkerKeptRun *by_another_than, const char *name)
{
    for (guint i = 0; i < runs->runs->len; i++) {
        const TinkerKeptRun *run = tinker_kept_runs_at(runs, i);
        if (run != by_another_than && g_str_equal(run->name, name)) return TRUE;
    }
    return FALSE;
}

/* A name that no other run has: with a number behind it where one does, as where a change was taken back. Takes it
 * over.
 */
static char *unlike_others(TinkerKeptRuns *runs, const TinkerKeptRun *run, char *name)
{
    g_autofree char *wanted = name;
    char *free_name = g_strdup(wanted);
    for (guint number = 2; is_taken(runs, run, free_name); number++) {
        g_free(free_name);
        free_name = g_strdup_printf("%s (%u)", wanted, number);
    }
    return free_name;
}

static char *values_since(TinkerKeptRuns *runs, TinkerScene *scene)
{
    return newest(runs) != NULL ? tinker_scene_values_changed(scene, newest(runs)->scene) : NULL;
}

char *tinker_kept_runs_present_name(TinkerKeptRuns *runs, TinkerScene *scene)
{
    g_autofree char *values = values_since(runs, scene);
    return values != NULL ? g_strdup_printf(_("%s, now"), values) : g_strdup(C_("run", "now"));
}

char *tinker_kept_runs_name_beside(TinkerKeptRuns *runs, const TinkerKeptRun *run, TinkerScene *scene)
{
    char *values = run->is_counted ? tinker_scene_values_changed(run->scene, scene) : NULL;
    return values != NULL ? unlike_others(runs, run, values) : g_strdup(run->name);
}

/* A name that only counts says nothing beside a run of which it is known what it changed. */
static void name_newest(TinkerKeptRuns *runs, TinkerScene *scene)
{
    TinkerKeptRun *run = newest(runs);
    char *values = run != NULL && run->is_counted ? tinker_scene_values_changed(run->scene, scene) : NULL;
    if (values == NULL) return;
    g_free(run->name);
    run->name = unlike_others(runs, run, values);
    run->is_counted = FALSE;
}

gboolean tinker_kept_runs_add(TinkerKeptRuns *runs, TinkerScene *scene, const TinkerRecording *recording,
                              const TinkerFrame *shown)
{
    if (runs->runs->len >= TINKER_MOST_KEPT) return FALSE;
    TinkerKeptRun *run = g_new0(TinkerKeptRun, 1);
    char *values = values_since(runs, scene);
    run->is_counted = values == NULL;
    name_newest(runs, scene);
    run->name = unlike_others(runs, run, values != NULL ? values : g_strdup_printf(_("Run %u"), runs->next_id + 1));
    run->id = runs->next_id++;
    run->shown = TRUE;
    run->number = free_number(runs);
    run->scene = tinker_scene_copy(scene);
    run->frame = tinker_frame_new(run->scene, NULL);
    if (run->frame != NULL) tinker_tops_turn_bodies(run->frame);
    if (run->frame != NULL && shown != NULL) tinker_frame_note_spans_of(run->frame, shown);
    tinker_recording_init(&run->recording);
    tinker_recording_share(&run->recording, recording);
    g_ptr_array_add(runs->runs, run);
    g_signal_emit(runs, changed, 0);
    return TRUE;
}

void tinker_kept_runs_remove(TinkerKeptRuns *runs, guint place)
{
    TinkerKeptRun *run = g_ptr_array_steal_index(runs->runs, place);
    g_signal_emit(runs, changed, 0);
    run_free(run);
}

void tinker_kept_runs_remove_all(TinkerKeptRuns *runs)
{
    while (runs->runs->len > 0)
        tinker_kept_runs_remove(runs, runs->runs->len - 1);
    runs->next_id = 0;
}

gboolean tinker_kept_runs_have(TinkerKeptRuns *runs, const TinkerRunTask *task)
{
    for (guint i = 0; i < tinker_kept_runs_count(runs); i++) {
        const GArray *segments = tinker_kept_runs_at(runs, i)->recording.segments;
        for (guint k = 0; k < segments->len; k++)
            if (g_array_index(segments, TinkerSegment, k).task == task) return TRUE;
    }
    return FALSE;
}

void tinker_kept_runs_rename(TinkerKeptRuns *runs, guint place, const char *name)
{
    TinkerKeptRun *run = tinker_kept_runs_at(runs, place);
    const gboolean is_blank = name[strspn(name, " \t")] == '\0';
    if (is_blank || g_str_equal(run->name, name)) return;
    g_free(run->name);
    run->name = unlike_others(runs, run, g_strdup(name));
    run->is_counted = FALSE;
    g_signal_emit(runs, changed, 0);
}

void tinker_kept_runs_show(TinkerKeptRuns *runs, guint place, gboolean shown)
{
    TinkerKeptRun *run = tinker_kept_runs_at(runs, place);
    if (run->shown == shown) return;
    run->shown = shown;
    g_signal_emit(runs, changed, 0);
}

TinkerFrame *tinker_kept_run_frame(TinkerKeptRun *run, double time)
{
    const TinkerSegment *last = tinker_recording_last(&run->recording);
    if (!run->shown || run->frame == NULL || last == NULL || time > tinker_run_task_status(last->task).reached)
        return NULL;
    if (!tinker_recording_place(&run->recording, run->frame, time)) return NULL;
    tinker_frame_note_spans(run->frame); /* of what was recorded after it was kept */
    return run->frame;
}

static void tinker_kept_runs_finalize(GObject *object)
{
    g_ptr_array_unref(TINKER_KEPT_RUNS(object)->runs);
    G_OBJECT_CLASS(tinker_kept_runs_parent_class)->finalize(object);
}

static void tinker_kept_runs_class_init(TinkerKeptRunsClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_kept_runs_finalize;
    changed = g_signal_new("changed", TINKER_TYPE_KEPT_RUNS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_kept_runs_init(TinkerKeptRuns *runs)
{
    runs->runs = g_ptr_array_new_with_free_func(run_free);
}

TinkerKeptRuns *tinker_kept_runs_new(void)
{
    return g_object_new(TINKER_TYPE_KEPT_RUNS, NULL);
}

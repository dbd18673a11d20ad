/* The history: every change is kept as what the blocks it touched were before and after, so that undo and redo need to
 * know nothing of the kinds of change. */
#include "scene/history.h"

#include "scene/scene-private.h"

/* One block; NULL where it was not there. */
typedef struct {
    TinkerBlockId id;
    SceneSnapshot *before, *after;
} Change;

typedef struct {
    char *title, *merge;
    GArray *changes; /* of Change, in the order they were made */
} Step;

struct _TinkerHistory {
    TinkerScene *scene;
    GPtrArray *steps; /* of Step */
    guint done;       /* of them; those behind can be redone */
    Step *open;       /* between begin and end, else NULL */
};

static void change_clear(Change *change)
{
    scene_snapshot_free(change->before);
    scene_snapshot_free(change->after);
}

static void step_free(Step *step)
{
    g_array_unref(step->changes);
    g_free(step->title);
    g_free(step->merge);
    g_free(step);
}

static Step *step_new(const char *title, const char *merge)
{
    Step *step = g_new0(Step, 1);
    step->title = g_strdup(title);
    step->merge = g_strdup(merge);
    step->changes = g_array_new(FALSE, FALSE, sizeof(Change));
    g_array_set_clear_func(step->changes, (GDestroyNotify)change_clear);
    return step;
}

/* Adds a change to a step; one that only alters a block whose last change here only altered it too becomes part of
 * that. Alterations touch nothing but their block, so they may change places with those of others. */
static void step_add(Step *step, Change change)
{
    for (guint i = step->changes->len; change.before != NULL && change.after != NULL && i-- > 0;) {
        Change *earlier = &g_array_index(step->changes, Change, i);
        if (earlier->id != change.id) continue;
        if (earlier->before == NULL || earlier->after == NULL) break;
        scene_snapshot_free(earlier->after);
        scene_snapshot_free(change.before);
        earlier->after = change.after;
        return;
    }
    g_array_append_val(step->changes, change);
}

static void make(TinkerScene *scene, TinkerBlockId id, const SceneSnapshot *state)
{
    if (state != NULL)
        scene_snapshot_restore(scene, state);
    else
        scene_take_out(scene, id);
}

static void step_undo(const Step *step, TinkerScene *scene)
{
    for (guint i = step->changes->len; i-- > 0;) {
        const Change *change = &g_array_index(step->changes, Change, i);
        make(scene, change->id, change->before);
    }
}

static void step_redo(const Step *step, TinkerScene *scene)
{
    for (guint i = 0; i < step->changes->len; i++) {
        const Change *change = &g_array_index(step->changes, Change, i);
        make(scene, change->id, change->after);
    }
}

/* Whether recording went into the open step; if not, the change is a step of its own. */
static gboolean open_own(TinkerHistory *history, const char *verb, const char *name)
{
    if (history->open != NULL) return FALSE;
    g_autofree char *title = g_strdup_printf("%s %s", verb, name);
    tinker_history_begin(history, title, NULL);
    return TRUE;
}

static void record(TinkerHistory *history, const char *verb, TinkerBlockId id, SceneSnapshot *before)
{
    gboolean own = open_own(history, verb, tinker_scene_block_name(history->scene, id));
    step_add(history->open, (Change){id, before, scene_snapshot_take(history->scene, id)});
    if (own) tinker_history_end(history);
}

/* Keeps a change that was made, or drops the snapshot of one that was refused. */
static gboolean record_if(gboolean made, TinkerHistory *history, const char *verb, TinkerBlockId id,
                          SceneSnapshot *before)
{
    if (made)
        record(history, verb, id, before);
    else
        scene_snapshot_free(before);
    return made;
}

TinkerHistory *tinker_history_new(TinkerScene *scene)
{
    TinkerHistory *history = g_new0(TinkerHistory, 1);
    history->scene = scene;
    history->steps = g_ptr_array_new_with_free_func((GDestroyNotify)step_free);
    return history;
}

void tinker_history_free(TinkerHistory *history)
{
    if (history == NULL) return;
    g_clear_pointer(&history->open, step_free);
    g_ptr_array_unref(history->steps);
    g_free(history);
}

void tinker_history_begin(TinkerHistory *history, const char *title, const char *merge)
{
    g_assert(history->open == NULL);
    history->open = step_new(title, merge);
}

void tinker_history_end(TinkerHistory *history)
{
    g_assert(history->open != NULL);
    Step *step = g_steal_pointer(&history->open);
    if (step->changes->len == 0) {
        step_free(step);
        return;
    }
    gboolean nothing_to_redo = history->done == history->steps->len;
    g_ptr_array_set_size(history->steps, (int)history->done);
    Step *last = history->done == 0 ? NULL : g_ptr_array_index(history->steps, history->done - 1);
    if (nothing_to_redo && last != NULL && step->merge != NULL && g_strcmp0(last->merge, step->merge) == 0) {
        for (guint i = 0; i < step->changes->len; i++)
            step_add(last, g_array_index(step->changes, Change, i));
        g_array_set_clear_func(step->changes, NULL); /* they are the last step's now */
        step_free(step);
        return;
    }
    g_ptr_array_add(history->steps, step);
    history->done++;
}

void tinker_history_abort(TinkerHistory *history)
{
    g_assert(history->open != NULL);
    step_undo(history->open, history->scene);
    g_clear_pointer(&history->open, step_free);
}

TinkerBlockId tinker_history_add_block(TinkerHistory *history, const TinkerBlockClass *block_class, const char *name,
                                       GError **error)
{
    TinkerBlockId id = tinker_scene_add_block(history->scene, block_class, name, error);
    if (id != TINKER_NO_BLOCK) record(history, "Add", id, NULL);
    return id;
}

void tinker_history_remove_block(TinkerHistory *history, TinkerBlockId block)
{
    gboolean own = open_own(history, "Remove", tinker_scene_block_name(history->scene, block));
    g_autoptr(GArray) attached = scene_attached_to(history->scene, block);
    g_autofree SceneSnapshot **before = g_new(SceneSnapshot *, attached->len + 1);
    for (guint i = 0; i < attached->len; i++)
        before[i] = scene_snapshot_take(history->scene, g_array_index(attached, TinkerBlockId, i));
    Change removal = {block, scene_snapshot_take(history->scene, block), NULL};

    tinker_scene_remove_block(history->scene, block);
    for (guint i = 0; i < attached->len; i++) {
        TinkerBlockId id = g_array_index(attached, TinkerBlockId, i);
        step_add(history->open, (Change){id, before[i], scene_snapshot_take(history->scene, id)});
    }
    step_add(history->open, removal);
    if (own) tinker_history_end(history);
}

gboolean tinker_history_rename_block(TinkerHistory *history, TinkerBlockId block, const char *name, GError **error)
{
    SceneSnapshot *before = scene_snapshot_take(history->scene, block);
    return record_if(tinker_scene_rename_block(history->scene, block, name, error), history, "Rename", block, before);
}

gboolean tinker_history_set(TinkerHistory *history, TinkerBlockId block, int32_t property, const double *values,
                            GError **error)
{
    SceneSnapshot *before = scene_snapshot_take(history->scene, block);
    return record_if(tinker_scene_set(history->scene, block, property, values, error), history, "Change", block,
                     before);
}

void tinker_history_unset(TinkerHistory *history, TinkerBlockId block, int32_t property)
{
    SceneSnapshot *before = scene_snapshot_take(history->scene, block);
    tinker_scene_unset(history->scene, block, property);
    record(history, "Change", block, before);
}

void tinker_history_set_waveform(TinkerHistory *history, TinkerBlockId block, int32_t property,
                                 TinkerWaveform *waveform)
{
    SceneSnapshot *before = scene_snapshot_take(history->scene, block);
    tinker_scene_set_waveform(history->scene, block, property, waveform);
    record(history, "Change", block, before);
}

void tinker_history_set_text(TinkerHistory *history, TinkerBlockId block, int32_t property, const char *text)
{
    SceneSnapshot *before = scene_snapshot_take(history->scene, block);
    tinker_scene_set_text(history->scene, block, property, text);
    record(history, "Change", block, before);
}

gboolean tinker_history_set_end(TinkerHistory *history, TinkerBlockId block, int32_t end, TinkerSceneEnd to,
                                GError **error)
{
    SceneSnapshot *before = scene_snapshot_take(history->scene, block);
    return record_if(tinker_scene_set_end(history->scene, block, end, to, error), history, "Connect", block, before);
}

const char *tinker_history_can_undo(const TinkerHistory *history)
{
    if (history->done == 0) return NULL;
    return ((const Step *)g_ptr_array_index(history->steps, history->done - 1))->title;
}

const char *tinker_history_can_redo(const TinkerHistory *history)
{
    if (history->done == history->steps->len) return NULL;
    return ((const Step *)g_ptr_array_index(history->steps, history->done))->title;
}

void tinker_history_undo(TinkerHistory *history)
{
    g_assert(history->open == NULL);
    if (history->done == 0) return;
    step_undo(g_ptr_array_index(history->steps, --history->done), history->scene);
}

void tinker_history_redo(TinkerHistory *history)
{
    g_assert(history->open == NULL);
    if (history->done == history->steps->len) return;
    step_redo(g_ptr_array_index(history->steps, history->done++), history->scene);
}

/* The history: every change is kept as what the thing it touched was before and after, so that undo and redo need to
 * know nothing of the kinds of change. The setters are in history-blocks.c and history-scene.c. */
#include "scene/history/history-private.h"

typedef struct {
    const HistoryKind *kind;
    int32_t id;
    gpointer before, after; /* NULL where it was not there */
    gboolean renames;       /* of a block: its name is another one */
} Change;

/* A state of the scene has a number, which no other state has. */
typedef struct {
    char *title, *merge;
    GArray *changes; /* of Change, in the order they were made */
    GHashTable
        *plain; /* block id to the number of its change, where the next plain one (is_plain) becomes part of it */
    guint64 from, to;
} Step;

struct _TinkerHistory {
    TinkerScene *scene;
    GPtrArray *steps; /* of Step */
    guint done;       /* of them; those behind can be redone */
    Step *open;       /* between begin and end, else NULL */
    guint64 revision;
    guint64 state, saved; /* the state that the scene is in, and the one that was marked */
};

static void change_clear(Change *change)
{
    if (change->kind->free == NULL) return;
    if (change->before != NULL) change->kind->free(change->before);
    if (change->after != NULL) change->kind->free(change->after);
}

static gboolean alters(const Change *change)
{
    return change->before != NULL && change->after != NULL;
}

static void step_free(Step *step)
{
    g_array_unref(step->changes);
    g_hash_table_unref(step->plain);
    g_free(step->title);
    g_free(step->merge);
    g_free(step);
}

static Step *step_new(const char *title, const char *merge, guint64 state)
{
    Step *step = g_new0(Step, 1);
    step->title = g_strdup(title);
    step->merge = g_strdup(merge);
    step->changes = g_array_new(FALSE, FALSE, sizeof(Change));
    step->plain = g_hash_table_new(NULL, NULL);
    g_array_set_clear_func(step->changes, (GDestroyNotify)change_clear);
    step->from = step->to = state;
    return step;
}

/* Alterations of blocks that keep their names, which touch nothing but their block, may be made in any order. */
static gboolean is_plain(const Change *change)
{
    return change->kind->of == HISTORY_BLOCK && !change->renames;
}

/* Whether the order of two changes does not matter. Names are taken and given free, and graphs follow them. */
static gboolean commute(const Change *a, const Change *b)
{
    if (a->kind->of == HISTORY_HEAD || b->kind->of == HISTORY_HEAD) return TRUE;
    return is_plain(a) && is_plain(b);
}

/* The last change of the same thing that this one could as well have been made right behind; -1: none. */
static int64_t find_same(const Step *step, const Change *change)
{
    gpointer at;
    if (is_plain(change))
        return g_hash_table_lookup_extended(step->plain, GINT_TO_POINTER(change->id), NULL, &at) ? GPOINTER_TO_INT(at)
                                                                                                 : -1;
    for (guint i = step->changes->len; i-- > 0;) {
        const Change *earlier = &g_array_index(step->changes, Change, i);
        if (earlier->kind == change->kind && earlier->id == change->id) return i;
        if (!commute(earlier, change)) break;
    }
    return -1;
}

/* Keeps the index that serves plain changes: of the blocks altered since the last change that they may not pass. */
static void note_place(Step *step, const Change *change, guint at)
{
    if (change->kind->of == HISTORY_HEAD) return;
    if (!is_plain(change)) g_hash_table_remove_all(step->plain);
    if (change->kind->of == HISTORY_BLOCK)
        g_hash_table_insert(step->plain, GINT_TO_POINTER(change->id), GINT_TO_POINTER((int)at));
}

/* Adds a change to a step; one that only alters a thing which was altered here before becomes part of that, where it
 * could as well have been made right behind it. */
static void step_add(Step *step, Change change)
{
    const int64_t same = alters(&change) ? find_same(step, &change) : -1;
    Change *earlier = same >= 0 ? &g_array_index(step->changes, Change, (guint)same) : NULL;
    if (earlier != NULL && alters(earlier)) {
        change_clear(&(Change){earlier->kind, earlier->id, change.before, earlier->after, FALSE});
        earlier->after = change.after;
        earlier->renames = earlier->renames || change.renames;
        note_place(step, earlier, (guint)same);
        return;
    }
    g_array_append_val(step->changes, change);
    note_place(step, &change, step->changes->len - 1);
}

static void step_undo(const Step *step, TinkerScene *scene)
{
    for (guint i = step->changes->len; i-- > 0;) {
        const Change *change = &g_array_index(step->changes, Change, i);
        change->kind->make(scene, change->id, change->after, change->before);
    }
    scene_settle(scene);
}

static void step_redo(const Step *step, TinkerScene *scene)
{
    for (guint i = 0; i < step->changes->len; i++) {
        const Change *change = &g_array_index(step->changes, Change, i);
        change->kind->make(scene, change->id, change->before, change->after);
    }
    scene_settle(scene);
}

static void enter_state(TinkerHistory *history, guint64 state)
{
    history->state = state;
    history->revision++;
}

TinkerScene *history_scene(TinkerHistory *history)
{
    return history->scene;
}

gboolean history_open_own(TinkerHistory *history, const char *verb, const char *name)
{
    if (history->open != NULL) return FALSE;
    g_autofree char *title = g_strdup_printf("%s %s", verb, name);
    tinker_history_begin(history, title, NULL);
    return TRUE;
}

void history_add(TinkerHistory *history, const HistoryKind *kind, int32_t id, gpointer before, gpointer after)
{
    Change change = {kind, id, before, after, FALSE};
    change.renames = kind->of == HISTORY_BLOCK && alters(&change) && scene_snapshot_renames(before, after);
    step_add(history->open, change);
    enter_state(history, history->revision + 1); /* a number that no state had before */
}

TinkerHistory *tinker_history_new(TinkerScene *scene)
{
    static gint histories;
    TinkerHistory *history = g_new0(TinkerHistory, 1);
    history->scene = scene;
    history->revision = (guint64)g_atomic_int_add(&histories, 1) << 32; /* changes of one that is looked at are fewer */
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
    history->open = step_new(title, merge, history->state);
}

/* Whether a step is to become part of the one before: not across a saved state, which undo is to find again. */
static gboolean is_continued(const TinkerHistory *history, const Step *last, const Step *step)
{
    return history->done == history->steps->len && last->to != history->saved && step->merge != NULL &&
           g_strcmp0(last->merge, step->merge) == 0;
}

void tinker_history_end(TinkerHistory *history)
{
    g_assert(history->open != NULL);
    Step *step = g_steal_pointer(&history->open);
    if (step->changes->len == 0) {
        step_free(step);
        return;
    }
    step->to = history->state;
    Step *last = history->done == 0 ? NULL : g_ptr_array_index(history->steps, history->done - 1);
    if (last != NULL && is_continued(history, last, step)) {
        for (guint i = 0; i < step->changes->len; i++)
            step_add(last, g_array_index(step->changes, Change, i));
        last->to = step->to;
        g_array_set_clear_func(step->changes, NULL); /* they are the last step's now */
        step_free(step);
        return;
    }
    g_ptr_array_set_size(history->steps, (int)history->done);
    g_ptr_array_add(history->steps, step);
    history->done++;
}

void tinker_history_abort(TinkerHistory *history)
{
    g_assert(history->open != NULL);
    step_undo(history->open, history->scene);
    if (history->open->changes->len > 0) enter_state(history, history->open->from);
    g_clear_pointer(&history->open, step_free);
}

gboolean tinker_history_is_open(const TinkerHistory *history)
{
    return history->open != NULL;
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
    const Step *step = g_ptr_array_index(history->steps, --history->done);
    step_undo(step, history->scene);
    enter_state(history, step->from);
}

void tinker_history_redo(TinkerHistory *history)
{
    g_assert(history->open == NULL);
    if (history->done == history->steps->len) return;
    const Step *step = g_ptr_array_index(history->steps, history->done++);
    step_redo(step, history->scene);
    enter_state(history, step->to);
}

gboolean tinker_history_is_saved(const TinkerHistory *history)
{
    return history->state == history->saved;
}

void tinker_history_mark_saved(TinkerHistory *history)
{
    history->saved = history->state;
}

guint64 tinker_history_revision(const TinkerHistory *history)
{
    return history->revision;
}

/* The recorded setters of blocks. Every change is kept as what the block was before and after; of blocks that come or
 * go, all of them together. */
#include "scene/history/history-private.h"

static void make(TinkerScene *scene, int32_t id, gconstpointer from, gconstpointer to)
{
    (void)id, (void)from;
    scene_snapshot_restore(scene, to);
}

static void free_state(gpointer state)
{
    scene_snapshot_free(state);
}

/* Of a block that stays: by block id; SceneSnapshot. */
static const HistoryKind history_block = {HISTORY_BLOCK, make, free_state};

static void make_there(TinkerScene *scene, int32_t id, gconstpointer from, gconstpointer to)
{
    (void)id;
    if (to != NULL)
        scene_blocks_bring_back(scene, to);
    else
        scene_blocks_take_out(scene, from);
}

static void free_blocks(gpointer state)
{
    scene_blocks_free(state);
}

/* Of blocks that come or go: id 0; SceneBlocks. */
static const HistoryKind history_blocks = {HISTORY_OTHER, make_there, free_blocks};

static void record(TinkerHistory *history, const char *verb, TinkerBlockId id, SceneSnapshot *before)
{
    TinkerScene *scene = history_scene(history);
    gboolean own = history_open_own(history, verb, tinker_scene_block_name(scene, id));
    history_add(history, &history_block, id, before, scene_snapshot_take(scene, id));
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

gboolean history_open_several(TinkerHistory *history, const char *verb, const TinkerBlockId *blocks, gsize count)
{
    g_autofree char *name = count == 1 ? g_strdup(tinker_scene_block_name(history_scene(history), blocks[0]))
                                       : g_strdup_printf("%" G_GSIZE_FORMAT " Blocks", count);
    return history_open_own(history, verb, name);
}

TinkerBlockId tinker_history_add_block(TinkerHistory *history, const TinkerBlockClass *block_class, const char *name,
                                       GError **error)
{
    TinkerBlockId id = tinker_scene_add_block(history_scene(history), block_class, name, error);
    if (id != TINKER_NO_BLOCK) history_note_new(history, "Add", &id, 1);
    return id;
}

TinkerBlockId tinker_history_add_block_of(TinkerHistory *history, const TinkerBlockClass *block_class, int32_t ends)
{
    g_assert(ends >= block_class->type->least_ends);
    g_assert(block_class->type->most_ends < 0 || ends <= block_class->type->most_ends);
    const TinkerBlockId id = scene_append(history_scene(history), block_class, ends, NULL);
    scene_assign_default_name(history_scene(history), id);
    history_note_new(history, "Add", &id, 1);
    return id;
}

void history_note_new(TinkerHistory *history, const char *verb, const TinkerBlockId *blocks, gsize count)
{
    gboolean own = history_open_several(history, verb, blocks, count);
    history_add(history, &history_blocks, 0, NULL, scene_blocks_keep(history_scene(history), blocks, count));
    if (own) tinker_history_end(history);
}

/* Of several blocks. (transfer full) */
static GPtrArray *take_all(const TinkerScene *scene, const GArray *blocks)
{
    GPtrArray *snapshots = g_ptr_array_new_with_free_func(free_state);
    for (guint i = 0; i < blocks->len; i++)
        g_ptr_array_add(snapshots, scene_snapshot_take(scene, g_array_index(blocks, TinkerBlockId, i)));
    return snapshots;
}

/* Adds what has become of them; takes the snapshots. */
static void add_all(TinkerHistory *history, const GArray *blocks, GPtrArray *before)
{
    g_ptr_array_set_free_func(before, NULL);
    for (guint i = 0; i < blocks->len; i++) {
        TinkerBlockId id = g_array_index(blocks, TinkerBlockId, i);
        history_add(history, &history_block, id, g_ptr_array_index(before, i),
                    scene_snapshot_take(history_scene(history), id));
    }
}

/* The other blocks that have ends on these, placeholders too, or lie on them. (transfer full) */
static GArray *that_need(const TinkerScene *scene, GHashTable *blocks)
{
    GArray *others = scene_attached_to(scene, blocks);
    g_autoptr(GArray) naming = scene_placeholders_on(scene, blocks);
    g_autoptr(GArray) lying = scene_placed_on(scene, blocks);
    g_array_append_vals(others, naming->data, naming->len);
    g_array_append_vals(others, lying->data, lying->len);
    return others;
}

void tinker_history_remove_blocks(TinkerHistory *history, const TinkerBlockId *blocks, gsize count)
{
    if (count == 0) return;
    TinkerScene *scene = history_scene(history);
    gboolean own = history_open_several(history, "Remove", blocks, count);
    g_autoptr(GHashTable) set = scene_block_set(blocks, count);
    g_autoptr(GArray) attached = that_need(scene, set);
    g_autoptr(GPtrArray) before = take_all(scene, attached);
    SceneBlocks *removed = scene_blocks_keep(scene, blocks, count);

    scene_detach(scene, set);
    scene_take_out(scene, set);
    add_all(history, attached, before);
    history_add(history, &history_blocks, 0, removed, NULL);
    if (own) tinker_history_end(history);
}

void tinker_history_remove_block(TinkerHistory *history, TinkerBlockId block)
{
    tinker_history_remove_blocks(history, &block, 1);
}

gboolean tinker_history_rename_block(TinkerHistory *history, TinkerBlockId block, const char *name, GError **error)
{
    TinkerScene *scene = history_scene(history);
    g_autoptr(GHashTable) set = scene_block_set(&block, 1);
    g_autoptr(GArray) naming = scene_placeholders_on(scene, set);
    g_autoptr(GPtrArray) before = take_all(scene, naming);
    SceneSnapshot *renamed = scene_snapshot_take(scene, block);
    if (!tinker_scene_rename_block(scene, block, name, error)) {
        scene_snapshot_free(renamed);
        return FALSE;
    }
    gboolean own = history_open_own(history, "Rename", name);
    history_add(history, &history_block, block, renamed, scene_snapshot_take(scene, block));
    add_all(history, naming, before);
    if (own) tinker_history_end(history);
    return TRUE;
}

gboolean tinker_history_set(TinkerHistory *history, TinkerBlockId block, int32_t property, const double *values,
                            GError **error)
{
    SceneSnapshot *before = scene_snapshot_take(history_scene(history), block);
    return record_if(tinker_scene_set(history_scene(history), block, property, values, error), history, "Change", block,
                     before);
}

gboolean tinker_history_lay_on(TinkerHistory *history, TinkerBlockId block, TinkerBlockId plate, double along,
                               GError **error)
{
    SceneSnapshot *before = scene_snapshot_take(history_scene(history), block);
    return record_if(tinker_scene_lay_on(history_scene(history), block, plate, along, error), history, "Place", block,
                     before);
}

void tinker_history_unset(TinkerHistory *history, TinkerBlockId block, int32_t property)
{
    SceneSnapshot *before = scene_snapshot_take(history_scene(history), block);
    tinker_scene_unset(history_scene(history), block, property);
    record(history, "Change", block, before);
}

void tinker_history_set_waveform(TinkerHistory *history, TinkerBlockId block, int32_t property,
                                 TinkerWaveform *waveform)
{
    SceneSnapshot *before = scene_snapshot_take(history_scene(history), block);
    tinker_scene_set_waveform(history_scene(history), block, property, waveform);
    record(history, "Change", block, before);
}

void tinker_history_set_text(TinkerHistory *history, TinkerBlockId block, int32_t property, const char *text)
{
    SceneSnapshot *before = scene_snapshot_take(history_scene(history), block);
    tinker_scene_set_text(history_scene(history), block, property, text);
    record(history, "Change", block, before);
}

gboolean tinker_history_set_end(TinkerHistory *history, TinkerBlockId block, int32_t end, TinkerSceneEnd to,
                                GError **error)
{
    SceneSnapshot *before = scene_snapshot_take(history_scene(history), block);
    return record_if(tinker_scene_set_end(history_scene(history), block, end, to, error), history, "Connect", block,
                     before);
}

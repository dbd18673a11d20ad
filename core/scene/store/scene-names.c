/* Names of blocks, each of which is taken once. */
#include <string.h>

#include "scene/store/conditions.h"
#include "scene/store/scene-data.h"

/* A name that ends with a number may leave that number free for its title. */
static void release_number(TinkerScene *scene, const char *name)
{
    const char *space = strrchr(name, ' ');
    if (space == NULL || !g_ascii_isdigit(space[1])) return;
    g_autofree char *title = g_strndup(name, (gsize)(space - name));
    gpointer next;
    if (!g_hash_table_lookup_extended(scene->next_number, title, NULL, &next)) return;
    gint64 number = g_ascii_strtoll(space + 1, NULL, 10);
    if (number < GPOINTER_TO_INT(next))
        g_hash_table_insert(scene->next_number, g_steal_pointer(&title), GINT_TO_POINTER((int)number));
}

void scene_forget_name(TinkerScene *scene, TinkerBlockId block)
{
    SceneSlot *slot = scene_slot(scene, block);
    if (slot->name == NULL) return;
    if (tinker_scene_find_block(scene, slot->name) == block) {
        g_hash_table_remove(scene->by_name, slot->name);
        release_number(scene, slot->name);
    }
    slot->name = NULL;
}

static void rename_in_conditions(TinkerScene *scene, const char *from, const char *to)
{
    char *renamed = tinker_conditions_renamed(scene->head.run.until, from, to);
    if (renamed == NULL) return;
    g_free(scene->head.run.until);
    scene->head.run.until = renamed;
}

void scene_assign_name(TinkerScene *scene, TinkerBlockId block, const char *name)
{
    SceneSlot *slot = scene_slot(scene, block);
    const char *old_name = slot->name;
    for (guint i = 0; old_name != NULL && i < scene->graphs->len; i++)
        scene_graph_rename(g_ptr_array_index(scene->graphs, i), old_name, name);
    for (guint i = 0; old_name != NULL && i < scene->instruments->len; i++)
        scene_instrument_rename(g_ptr_array_index(scene->instruments, i), old_name, name);
    if (old_name != NULL) rename_in_conditions(scene, old_name, name);
    scene_forget_name(scene, block);
    slot->name = g_string_chunk_insert(scene->names, name);
    g_hash_table_replace(scene->by_name, (gpointer)slot->name, GINT_TO_POINTER(block + 1));
}

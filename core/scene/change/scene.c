/* Scenes: the list of blocks with their names, and the drawing order. Rows of blocks are in scene-table.c, several
 * blocks at once in scene-blocks.c, values in scene-properties.c, ends in scene-ends.c, head and graphs in
 * scene-head.c. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "scene/json/text-hash.h"
#include "scene/store/scene-data.h"
#include "units/quantity/plain-text.h"

/* Names -------------------------------------------------------------------------------------------------------- */

char *scene_name_fault(const TinkerScene *scene, const char *name)
{
    if (*name == '\0') return g_strdup("a name must not be empty");
    if (!g_utf8_validate(name, -1, NULL)) return g_strdup("a name must be UTF-8 text");
    if (!tinker_text_is_plain(name)) return g_strdup("a name must be one line of text, without control characters");
    if (tinker_scene_find_block(scene, name) != TINKER_NO_BLOCK)
        return g_strdup_printf("the name \"%s\" is taken: every block needs a name of its own", name);
    return NULL;
}

/* What a type that is not installed is most likely titled, so that ends which count on its default name are found:
 * "my-block" is "My Block". (transfer full) */
static char *likely_title(const char *type)
{
    char *title = g_strdup(type);
    for (char *at = title; *at != '\0'; at++) {
        if (*at == '-') *at = ' ';
        if (at == title || at[-1] == ' ') *at = g_ascii_toupper(*at);
    }
    return title;
}

void scene_assign_default_name(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    g_autofree char *title =
        block_class != NULL ? g_strdup(block_class->type->title) : likely_title(tinker_scene_block_type(scene, block));
    int number = GPOINTER_TO_INT(g_hash_table_lookup(scene->next_number, title));
    g_autofree char *name = g_strdup_printf("%s %d", title, number);
    while (g_hash_table_contains(scene->by_name, name)) {
        g_free(name);
        name = g_strdup_printf("%s %d", title, ++number);
    }
    g_hash_table_insert(scene->next_number, g_strdup(title), GINT_TO_POINTER(number + 1));
    scene_assign_name(scene, block, name);
}

/* Blocks ------------------------------------------------------------------------------------------------------- */

TinkerBlockId scene_append(TinkerScene *scene, const TinkerBlockClass *block_class, int32_t end_count,
                           ScenePlaceholder *placeholder)
{
    TinkerBlockId id = (TinkerBlockId)scene->slots->len;
    SceneSlot slot = {.table = SCENE_PLACEHOLDER};
    g_array_append_val(scene->slots, slot);
    g_array_append_val(scene->order, id);
    if (block_class == NULL) {
        g_hash_table_insert(scene->placeholders, GINT_TO_POINTER(id), placeholder);
        return id;
    }
    SceneTable *table = scene_table_for(scene, block_class);
    scene_table_append(scene, table, id, end_count);
    return id;
}

void scene_move_in_order(TinkerScene *scene, TinkerBlockId block, int32_t place)
{
    g_array_remove_index(scene->order, (guint)scene_order_of(scene, block));
    g_array_insert_val(scene->order, (guint)place, block);
}

TinkerScene *tinker_scene_new(TinkerCatalogue *catalogue)
{
    TinkerScene *scene = g_new0(TinkerScene, 1);
    scene->catalogue = catalogue;
    scene_head_init(&scene->head);
    scene->graphs = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_scene_graph_free);
    scene->instruments = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_scene_instrument_free);
    scene->slots = g_array_new(FALSE, FALSE, sizeof(SceneSlot));
    scene->order = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    scene->tables = g_ptr_array_new_with_free_func((GDestroyNotify)scene_table_free);
    scene->table_of = g_hash_table_new(NULL, NULL);
    scene->names = g_string_chunk_new(4096);
    scene->by_name = g_hash_table_new(tinker_text_hash, g_str_equal);
    scene->next_number = g_hash_table_new_full(tinker_text_hash, g_str_equal, g_free, NULL);
    scene->placeholders = g_hash_table_new_full(NULL, NULL, NULL, (GDestroyNotify)scene_placeholder_free);
    scene->extras = g_hash_table_new_full(NULL, NULL, NULL, g_free);
    scene->places_on = g_hash_table_new_full(NULL, NULL, NULL, g_free);
    scene->end_extras = g_hash_table_new_full(g_int64_hash, g_int64_equal, g_free, g_free);
    scene->sources = g_hash_table_new_full(NULL, NULL, (GDestroyNotify)tinker_waveform_unref, g_free);
    return scene;
}

void tinker_scene_free(TinkerScene *scene)
{
    if (scene == NULL) return;
    scene_head_clear(&scene->head);
    g_ptr_array_unref(scene->graphs);
    g_ptr_array_unref(scene->instruments);
    g_array_unref(scene->slots);
    g_array_unref(scene->order);
    g_ptr_array_unref(scene->tables);
    g_hash_table_unref(scene->table_of);
    g_hash_table_unref(scene->by_name);
    g_string_chunk_free(scene->names);
    g_hash_table_unref(scene->next_number);
    g_hash_table_unref(scene->placeholders);
    g_hash_table_unref(scene->extras);
    g_hash_table_unref(scene->places_on);
    g_hash_table_unref(scene->end_extras);
    g_hash_table_unref(scene->sources);
    g_free(scene->head_extras);
    g_free(scene->canvas_extras);
    g_free(scene->run_extras);
    g_free(scene);
}

TinkerBlockId tinker_scene_add_block(TinkerScene *scene, const TinkerBlockClass *block_class, const char *name,
                                     GError **error)
{
    g_autofree char *fault = name == NULL ? NULL : scene_name_fault(scene, name);
    if (fault != NULL) {
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME, fault);
        return TINKER_NO_BLOCK;
    }
    TinkerBlockId id = scene_append(scene, block_class, MAX(block_class->type->least_ends, 0), NULL);
    if (name == NULL)
        scene_assign_default_name(scene, id);
    else
        scene_assign_name(scene, id, name);
    return id;
}

void tinker_scene_remove_block(TinkerScene *scene, TinkerBlockId block)
{
    g_assert(tinker_scene_has_block(scene, block));
    g_autoptr(GHashTable) set = scene_block_set(&block, 1);
    scene_detach(scene, set);
    scene_take_out(scene, set);
}

gboolean tinker_scene_rename_block(TinkerScene *scene, TinkerBlockId block, const char *name, GError **error)
{
    g_assert(tinker_scene_has_block(scene, block));
    if (g_str_equal(scene_slot(scene, block)->name, name)) return TRUE;
    g_autofree char *fault = scene_name_fault(scene, name);
    if (fault != NULL) {
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME, fault);
        return FALSE;
    }
    scene_placeholders_follow(scene, scene_slot(scene, block)->name, name);
    scene_assign_name(scene, block, name);
    return TRUE;
}

TinkerBlockId tinker_scene_first_placeholder(const TinkerScene *scene)
{
    if (g_hash_table_size(scene->placeholders) == 0) return TINKER_NO_BLOCK;
    for (guint i = 0; i < scene->order->len; i++) {
        TinkerBlockId id = g_array_index(scene->order, TinkerBlockId, i);
        if (scene_slot(scene, id)->table == SCENE_PLACEHOLDER) return id;
    }
    return TINKER_NO_BLOCK;
}

char *tinker_scene_missing_reason(const TinkerScene *scene, TinkerBlockId placeholder)
{
    g_autoptr(GError) missing = NULL;
    tinker_catalogue_type(scene->catalogue, tinker_scene_block_type(scene, placeholder), &missing);
    return g_strdup(missing != NULL ? missing->message
                                    : _("its plugin was installed since the scene was read (open it again)"));
}

TinkerBlockId tinker_scene_first_detached(const TinkerScene *scene)
{
    for (guint i = 0; i < scene->order->len; i++) {
        TinkerBlockId id = g_array_index(scene->order, TinkerBlockId, i);
        const SceneTable *table = scene_table_of(scene, id);
        if (table == NULL) continue;
        int32_t row = scene_slot(scene, id)->row;
        const TinkerSceneEnd *ends = scene_table_ends(table, row);
        for (int32_t end = 0; end < scene_table_end_count(table, row); end++)
            if (ends[end].block == TINKER_NO_BLOCK) return id;
    }
    return TINKER_NO_BLOCK;
}

/* Properties of other blocks that are shown where they are attached, as the descriptors ask for: each block has a group
 * of its own. Of types that could be attached, but are not, the waveform is shown, which is none. */
#include <string.h>

#include "gui/property/property-rows.h"
#include "gui/text/translate.h"

/* Adds the rows of one block that it shows where its end `end` is. A second one of a group has its name in the title.
 */
static void add_rows_of(PropertyBuilder *builder, TinkerBlockId block, int32_t end, GHashTable *groups)
{
    PropertyBuilder own = *builder;
    own.blocks = &block;
    own.count = 1;
    own.block_class = tinker_scene_block_class(builder->scene, block);
    for (int32_t i = 0; i < own.block_class->property_count; i++) {
        const TinkerPropertyType *type = &own.block_class->properties[i];
        if (type->panel != end) continue;
        gpointer first = g_hash_table_lookup(groups, type->group);
        g_autofree char *other = NULL;
        if (first == NULL)
            g_hash_table_insert(groups, (gpointer)type->group, GINT_TO_POINTER(block + 1));
        else if (GPOINTER_TO_INT(first) != block + 1)
            other = g_strdup_printf("%s (%s)", tinker_translate(type->group),
                                    tinker_scene_block_name(builder->scene, block));
        own.group = other;
        property_rows_add_property(&own, i);
    }
}

/* Of all blocks of a table; answers whether there was any. */
static gboolean add_rows_of_table(PropertyBuilder *builder, const TinkerSceneTable *table, GHashTable *groups)
{
    gboolean any = FALSE;
    for (int32_t row = 0; row < table->count; row++) {
        for (int32_t e = table->end_offsets[row]; e < table->end_offsets[row + 1]; e++) {
            if (table->ends[e].block != builder->blocks[0]) continue;
            add_rows_of(builder, table->ids[row], e - table->end_offsets[row], groups);
            any = TRUE;
        }
    }
    return any;
}

static void add_missing(PropertyBuilder *builder, const TinkerBlockClass *block_class)
{
    for (int32_t i = 0; i < block_class->property_count; i++)
        if (block_class->properties[i].kind == TINKER_KIND_WAVEFORM && block_class->properties[i].panel >= 0)
            property_rows_add_missing_waveform(builder, block_class, i);
}

/* Types of the catalogue that could be attached, and are not among `present`. */
static void add_all_missing(PropertyBuilder *builder, GHashTable *present)
{
    TinkerCatalogue *catalogue = tinker_document_catalogue(builder->document);
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue), types = tinker_libraries_types(libraries);
    for (guint i = 0; i < types->len; i++) {
        const TinkerTypeEntry *entry = g_ptr_array_index(types, i);
        const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, entry->id, NULL);
        if (block_class == NULL || !tinker_block_class_is_shown_elsewhere(block_class) ||
            g_hash_table_contains(present, block_class))
            continue;
        if (tinker_block_class_accepts(block_class, builder->block_class)) add_missing(builder, block_class);
    }
}

void property_rows_add_attached(PropertyBuilder *builder)
{
    g_autoptr(GHashTable) groups = g_hash_table_new(g_str_hash, g_str_equal);
    g_autoptr(GHashTable) present = g_hash_table_new(NULL, NULL);
    for (int32_t i = 0; i < tinker_scene_table_count(builder->scene); i++) {
        TinkerSceneTable table;
        tinker_scene_table(builder->scene, i, &table);
        if (!tinker_block_class_is_shown_elsewhere(table.block_class)) continue;
        if (add_rows_of_table(builder, &table, groups)) g_hash_table_add(present, (gpointer)table.block_class);
    }
    add_all_missing(builder, present);
}

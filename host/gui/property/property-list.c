/* Puts the list together, in its order, and changes what its rows stand for. */
#include "gui/property/property-rows.h"

#include <glib/gi18n.h>
#include <string.h>

/* The list --------------------------------------------------------------------------------------------------------- */

static int compare_rows(const void *left, const void *right)
{
    const TinkerPropertyRow *l = *(TinkerPropertyRow *const *)left, *r = *(TinkerPropertyRow *const *)right;
    const int by_group = g_utf8_collate(l->group, r->group), by_title = g_utf8_collate(l->sorted_by, r->sorted_by);
    return by_group != 0 ? by_group : by_title != 0 ? by_title : l->component - r->component;
}

/* (transfer full) */
static char *id_of(const char *name, TinkerRowKind kind, int number)
{
    return g_strdup_printf("%s/%d/%d", name, (int)kind, number);
}

char *tinker_property_law_of_impact_id(void)
{
    g_autofree char *name = g_strdup_printf("%s/%s", tinker_property_group_folded(), property_law_of_impact());
    return id_of(name, TINKER_ROW_CHOICE, 0);
}

/* Rows of one title in one group are told apart by a number. */
static void name_rows(GPtrArray *rows)
{
    g_autoptr(GHashTable) numbers = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (guint i = 0; i < rows->len; i++) {
        TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        char *name = g_strdup_printf("%s/%s", row->group, row->title);
        const int number = GPOINTER_TO_INT(g_hash_table_lookup(numbers, name));
        row->id = id_of(name, row->kind, number);
        g_hash_table_replace(numbers, name, GINT_TO_POINTER(number + 1));
    }
}

static void add_block(PropertyBuilder *builder)
{
    gboolean alone = builder->count == 1;
    if (alone) property_rows_add_name(builder);
    for (int32_t i = 0; builder->block_class != NULL && i < builder->block_class->property_count; i++)
        property_rows_add_property(builder, i);
    if (!alone || builder->block_class == NULL) return;
    property_rows_add_ends(builder);
    property_rows_add_readings(builder);
    property_rows_add_attached(builder);
}

/* Whether all have the type of the first, and somebody provides it. */
static gboolean are_alike(const PropertyBuilder *builder)
{
    for (int i = 1; i < builder->count; i++)
        if (tinker_scene_block_class(builder->scene, builder->blocks[i]) != builder->block_class) return FALSE;
    return builder->count == 1 || builder->block_class != NULL;
}

GPtrArray *tinker_property_list_new(TinkerDocument *document, TinkerPlayer *player, gboolean trims)
{
    PropertyBuilder builder = {
        .document = document,
        .player = player,
        .scene = tinker_document_scene(document),
        .trims = trims,
        .rows = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_property_row_unref),
    };
    builder.system = tinker_scene_head(builder.scene)->units;
    builder.blocks = tinker_document_selection(document, &builder.count);
    if (builder.count > 0) builder.block_class = tinker_scene_block_class(builder.scene, builder.blocks[0]);
    if (builder.count == 0)
        property_rows_add_scene(&builder);
    else if (are_alike(&builder))
        add_block(&builder);
    g_ptr_array_sort(builder.rows, compare_rows);
    name_rows(builder.rows);
    return builder.rows;
}

char *tinker_property_list_heading(TinkerDocument *document)
{
    int count;
    const TinkerBlockId *blocks = tinker_document_selection(document, &count);
    if (count == 0) return g_strdup(_("Scene"));
    if (count == 1) return g_strdup(tinker_scene_block_name(tinker_document_scene(document), blocks[0]));
    return g_strdup_printf(_("%d Blocks"), count);
}

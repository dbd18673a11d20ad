/* Puts the list together, in its order, and changes what its rows stand for. */
#include "gui/property/property-rows.h"

#include <glib/gi18n.h>
#include <string.h>

/* Rows ----------------------------------------------------------------------------------------------------------------
 */

static void row_clear(gpointer data)
{
    TinkerPropertyRow *row = data;
    g_free(row->group);
    g_free(row->title);
    g_free(row->sorted_by);
    g_free(row->id);
    g_free(row->text);
    g_free(row->description);
    g_strfreev(row->choices);
    g_array_unref(row->blocks);
}

TinkerPropertyRow *tinker_property_row_ref(TinkerPropertyRow *row)
{
    return g_rc_box_acquire(row);
}

void tinker_property_row_unref(TinkerPropertyRow *row)
{
    if (row != NULL) g_rc_box_release_full(row, row_clear);
}

gboolean tinker_property_row_same_target(const TinkerPropertyRow *a, const TinkerPropertyRow *b)
{
    return a->kind == b->kind && a->set == b->set && a->choose == b->choose && a->data == b->data &&
           a->property == b->property && a->component == b->component && a->blocks->len == b->blocks->len &&
           (a->blocks->len == 0 ||
            memcmp(a->blocks->data, b->blocks->data, a->blocks->len * sizeof(TinkerBlockId)) == 0);
}

TinkerPropertyRow *property_builder_add(PropertyBuilder *builder, TinkerRowKind kind, const char *group,
                                        const char *title, const char *description)
{
    TinkerPropertyRow *row = g_rc_box_new0(TinkerPropertyRow);
    row->kind = kind;
    row->group = g_strdup(group);
    row->title = g_strdup(title);
    row->sorted_by = g_strdup(title);
    row->description = g_strdup(description);
    row->text = g_strdup("");
    row->unit = "";
    row->sensitive = row->given = TRUE;
    row->chosen = row->file_choice = -1;
    row->blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    if (builder->count > 0) g_array_append_vals(row->blocks, builder->blocks, (guint)builder->count);
    g_ptr_array_add(builder->rows, row);
    return row;
}

void property_row_take_text(TinkerPropertyRow *row, char *text)
{
    g_free(row->text);
    row->text = text;
}

void property_row_sort_by(TinkerPropertyRow *row, const char *text)
{
    g_free(row->sorted_by);
    row->sorted_by = g_strdup(text);
}

/* The list ------------------------------------------------------------------------------------------------------------
 */

static int compare_rows(const void *left, const void *right)
{
    const TinkerPropertyRow *l = *(TinkerPropertyRow *const *)left, *r = *(TinkerPropertyRow *const *)right;
    const int by_group = g_utf8_collate(l->group, r->group), by_title = g_utf8_collate(l->sorted_by, r->sorted_by);
    return by_group != 0 ? by_group : by_title != 0 ? by_title : l->component - r->component;
}

/* Rows of one title in one group are told apart by a number. */
static void name_rows(GPtrArray *rows)
{
    g_autoptr(GHashTable) numbers = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (guint i = 0; i < rows->len; i++) {
        TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        char *name = g_strdup_printf("%s/%s", row->group, row->title);
        const int number = GPOINTER_TO_INT(g_hash_table_lookup(numbers, name));
        row->id = g_strdup_printf("%s/%d/%d", name, (int)row->kind, number);
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

/* Setting -------------------------------------------------------------------------------------------------------------
 */

gboolean property_edit_all(TinkerDocument *document, const TinkerPropertyRow *row, PropertyEdit edit,
                           gconstpointer value, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    TinkerHistory *history = tinker_document_history(document);
    guint count = row->blocks->len;
    for (guint i = 0; i < count; i++)
        if (!tinker_scene_has_block(scene, g_array_index(row->blocks, TinkerBlockId, i)))
            return property_refuse(error, _("The block is no longer there."));
    const char *name = count == 1 ? tinker_scene_block_name(scene, g_array_index(row->blocks, TinkerBlockId, 0)) : NULL;
    g_autofree char *title = name != NULL ? g_strdup_printf(_("Change %s of %s"), row->title, name)
                                          : g_strdup_printf(_("Change %s of %u Blocks"), row->title, count);
    tinker_document_begin(document, title, NULL);
    for (guint i = 0; i < count; i++) {
        if (edit(history, row, g_array_index(row->blocks, TinkerBlockId, i), value, error)) continue;
        tinker_document_abort(document);
        return FALSE;
    }
    tinker_document_end(document);
    return TRUE;
}

gboolean tinker_property_row_set(TinkerDocument *document, const TinkerPropertyRow *row, const char *text,
                                 GError **error)
{
    g_return_val_if_fail(row->set != NULL, FALSE);
    if (!g_utf8_validate(text, -1, NULL)) return property_refuse(error, _("The text is not UTF-8."));
    g_autofree char *typed = g_strstrip(g_strdup(text));
    if (g_str_equal(typed, row->text)) return TRUE;
    return row->set(document, row, typed, error);
}

gboolean tinker_property_row_choose(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    g_return_val_if_fail(row->choose != NULL && choice >= 0, FALSE);
    return choice == row->chosen || row->choose(document, row, choice, error);
}

/* A row of the list: what it says, and what it stands for. */
#include <glib/gi18n.h>
#include <string.h>

#include "gui/property/property-rows.h"
#include "gui/text/translate.h"

static void row_clear(gpointer data)
{
    TinkerPropertyRow *row = data;
    g_free(row->group);
    g_free(row->title);
    g_free(row->sorted_by);
    g_free(row->id);
    g_free(row->text);
    g_free(row->hint);
    g_free(row->control);
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

const char *property_group_of(const PropertyBuilder *builder, const TinkerPropertyType *type)
{
    return builder->group != NULL ? builder->group : tinker_translate(type->group);
}

/* Setting ---------------------------------------------------------------------------------------------------------- */

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

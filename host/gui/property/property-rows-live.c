/* Rows of how things are: what a block's ends are on, and what its quantities are at the time that is shown. */
#include <glib/gi18n.h>

#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"
#include "gui/text/translate.h"
#include "scene/frame/frame.h"

#define LIVE_DIGITS 4 /* as many as can be read while they change */

/* Readings ------------------------------------------------------------------------------------------------------------
 */

void property_rows_add_readings(PropertyBuilder *builder)
{
    const TinkerBlockClass *block_class = builder->block_class;
    gboolean english = builder->system == TINKER_UNIT_SYSTEM_ENGLISH;
    if (block_class->graph == NULL) return;
    for (int32_t i = 0; i < block_class->quantity_count; i++) {
        const TinkerQuantityType *type = &block_class->quantities[i];
        double value;
        if (!tinker_player_value(builder->player, builder->blocks[0], i, &value)) continue;
        TinkerPropertyRow *row = property_builder_add(
            builder, TINKER_ROW_READING, _("Now"), tinker_translate(type->title), tinker_translate(type->description));
        row->property = i;
        row->unit = tinker_block_class_unit(block_class, type->id, type->dimension, english);
        property_row_take_text(row, tinker_number_measured(value, row->unit, LIVE_DIGITS));
    }
}

/* Ends ----------------------------------------------------------------------------------------------------------------
 */

static gboolean edit_end(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block, gconstpointer end,
                         GError **error)
{
    GError *cause = NULL;
    if (tinker_history_set_end(history, block, row->component, *(const TinkerSceneEnd *)end, &cause)) return TRUE;
    property_fail(error, cause, row->data, NULL);
    return FALSE;
}

/* Where an end is at the start: there it stays when it is detached. */
static TinkerSceneEnd loose_end(TinkerScene *scene, TinkerSceneEnd end)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    double place[2] = {0, 0};
    if (frame != NULL) tinker_frame_end(frame, end, place);
    return (TinkerSceneEnd){TINKER_NO_BLOCK, place[0], place[1]};
}

static gboolean refuse_name(TinkerScene *scene, const char *text, GError **error)
{
    int32_t count = tinker_scene_block_count(scene);
    g_autofree const char **names = g_new0(const char *, (gsize)count + 1);
    for (int32_t i = 0; i < count; i++)
        names[i] = tinker_scene_block_name(scene, tinker_scene_block_at(scene, i));
    const char *nearest = tinker_nearest_word(text, names);
    if (nearest == NULL) return property_refuse(error, _("There is no block “%s”."), text);
    return property_refuse(error, _("There is no block “%s”; did you mean “%s”?"), text, nearest);
}

static gboolean set_end(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    TinkerBlockId block = g_array_index(row->blocks, TinkerBlockId, 0), to = tinker_scene_find_block(scene, text);
    if (!tinker_scene_has_block(scene, block)) return property_refuse(error, _("The block is no longer there."));
    if (*text != '\0' && to == TINKER_NO_BLOCK) return refuse_name(scene, text, error);
    TinkerSceneEnd end = {to, 0, 0};
    if (to == TINKER_NO_BLOCK) end = loose_end(scene, tinker_scene_end(scene, block, row->component));
    TinkerPropertyRow named = *row;
    named.data = tinker_scene_block_name(scene, block);
    return property_edit_all(document, &named, edit_end, &end, error);
}

void property_rows_add_ends(PropertyBuilder *builder)
{
    TinkerBlockId block = builder->blocks[0];
    int32_t count = tinker_scene_end_count(builder->scene, block);
    for (int32_t i = 0; i < count; i++) {
        TinkerSceneEnd end = tinker_scene_end(builder->scene, block, i);
        g_autofree char *title = count == 1 ? g_strdup(_("End")) : g_strdup_printf(_("End %d"), i + 1);
        TinkerPropertyRow *row =
            property_builder_add(builder, TINKER_ROW_END, _("Connections"), title,
                                 _("The block that this end is on: type its name, or drag the end onto it."));
        row->component = i;
        row->set = set_end;
        if (end.block != TINKER_NO_BLOCK)
            property_row_take_text(row, g_strdup(tinker_scene_block_name(builder->scene, end.block)));
    }
}

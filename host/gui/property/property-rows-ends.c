/* Rows of what a block's ends are on, and where on it, in its own axes. */
#include <glib/gi18n.h>

#include "analysis/start/joined.h"
#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"
#include "scene/frame/frame.h"

#define PLACE_ROW 1000 /* component of the rows of places: they stand behind the row of their end */

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

/* Where on its block ----------------------------------------------------------------------------------------------- */

static const TinkerDimension length = {0, 1, 0, 0};

/* One coordinate of the place of an end on its block. */
typedef struct {
    TinkerScene *scene;
    int32_t end, axis;
    double value;
} EnteredPlace;

/* What is joined to the block follows: a pin that is put elsewhere on a bar takes the other one along. */
static gboolean edit_place(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                           gconstpointer data, GError **error)
{
    const EnteredPlace *entered = data;
    TinkerSceneEnd end = tinker_scene_end(entered->scene, block, entered->end);
    *(entered->axis == 0 ? &end.x : &end.y) = entered->value;
    GError *cause = NULL;
    if (!tinker_history_set_end(history, block, entered->end, end, &cause)) {
        property_fail(error, cause, tinker_scene_block_name(entered->scene, block), NULL);
        return FALSE;
    }
    tinker_joined_bring(history, entered->scene, end.block);
    return TRUE;
}

static gboolean set_place(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    EnteredPlace entered = {tinker_document_scene(document), (row->component - PLACE_ROW) / 2, row->component % 2, 0};
    const TinkerBlockId block = g_array_index(row->blocks, TinkerBlockId, 0);
    if (!tinker_scene_has_block(entered.scene, block) ||
        tinker_scene_end(entered.scene, block, entered.end).block == TINKER_NO_BLOCK)
        return property_refuse(error, _("The block is no longer there."));
    return property_parse_number(text, length, row->unit, &entered.value, error) &&
           property_edit_all(document, row, edit_place, &entered, error);
}

/* A point mass has its centre alone. */
static gboolean has_places(TinkerScene *scene, TinkerBlockId on)
{
    const TinkerBlockClass *block_class = on != TINKER_NO_BLOCK ? tinker_scene_block_class(scene, on) : NULL;
    return tinker_block_class_has_angle(block_class);
}

static void add_place(PropertyBuilder *builder, int32_t number, const char *title)
{
    const TinkerSceneEnd end = tinker_scene_end(builder->scene, builder->blocks[0], number);
    for (int32_t axis = 0; axis < 2; axis++) {
        /* Translators: "End 1 X", a coordinate of the place of an end */
        g_autofree char *name = g_strdup_printf(axis == 0 ? _("%s X") : _("%s Y"), title);
        TinkerPropertyRow *row = property_builder_add(
            builder, TINKER_ROW_NUMBER, _("Connections"), name,
            _("Where on its block this end is, in the block's own axes, from its centre; they turn with it."));
        property_row_sort_by(row, title);
        row->unit = tinker_unit_for(length, builder->system);
        row->property = -1;
        row->component = PLACE_ROW + 2 * number + axis;
        row->set = set_place;
        property_row_take_text(
            row, tinker_number_write(axis == 0 ? end.x : end.y, length, row->unit, builder->system, builder->trims));
    }
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
        if (has_places(builder->scene, end.block)) add_place(builder, i, title);
    }
}

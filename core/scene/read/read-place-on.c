/* Reading "on" and "along": a body that lies on the top of a plate, which may come later in the file. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "scene/frame/tops.h"
#include "scene/value/reader.h"

gboolean reader_is_place_on(const TinkerBlockClass *block_class, const char *key)
{
    return tinker_class_can_be_put(block_class) && (g_str_equal(key, "on") || g_str_equal(key, "along")) &&
           tinker_block_class_property(block_class, key) < 0;
}

void reader_place_on(SceneReader *reader, const cJSON *json, JsonAt at, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(reader->scene, block);
    const char *position_id = tinker_class_can_be_put(block_class)
                                  ? block_class->properties[block_class->meanings[TINKER_MEANING_POSITION]].id
                                  : NULL;
    if (position_id == NULL) return;
    ReaderPlaceOn on = {.block = block};
    JsonAt position_at = {0};
    gboolean good = TRUE;
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++) {
        if (g_str_equal(member->string, position_id)) position_at = at_child(at, step);
        if (!reader_is_place_on(block_class, member->string)) continue;
        if (g_str_equal(member->string, "on")) {
            on.name_at = at_child(at, step);
            on.name = reader_text(reader, member, on.name_at, "on");
        } else {
            on.along_at = at_child(at, step);
            good = reader_number(reader, member, on.along_at, "along", reader_length, &on.along);
        }
    }
    if (on.name_at.depth == 0 && on.along_at.depth > 0)
        reader_error(reader, at_key(on.along_at), TINKER_SCENE_ERROR_VALUE,
                     _("along is measured on a top, and none is named (give \"on\", the name of a support)"));
    if (on.name_at.depth > 0 && position_at.depth > 0)
        good = reader_error(reader, at_key(position_at), TINKER_SCENE_ERROR_VALUE,
                            _("%s is given beside on, which places it (leave one of them out)"), position_id);
    if (on.name == NULL || !good) return;
    on.name = g_string_chunk_insert(reader->end_names, on.name);
    g_array_append_val(reader->places_on, on);
}

/* A place that is allowed, and hardly meant. */
static void look_at_top(SceneReader *reader, const ReaderPlaceOn *on, const TinkerFrame *frame, TinkerBlockId plate)
{
    const TinkerTop top = tinker_top_of(frame, plate);
    const char *name = tinker_scene_block_name(reader->scene, plate);
    reader_label(reader, tinker_scene_block_name(reader->scene, on->block));
    if (tinker_frame_meaning(frame, plate, TINKER_MEANING_SOLID, 0, 1) == 0)
        reader_warning(reader, on->name_at, TINKER_SCENE_ERROR_VALUE,
                       _("on names \"%s\", which is not solid and carries nothing (set its \"solid\" to true)"), name);
    else if (fabs(on->along) > top.half_width)
        reader_warning(reader, on->along_at.depth > 0 ? on->along_at : on->name_at, TINKER_SCENE_ERROR_VALUE,
                       _("along is %g m, beyond the end of the top of \"%s\" (it reaches from %g m to %g m)"),
                       on->along, name, -top.half_width, top.half_width);
}

/* The block that is named; TINKER_NO_BLOCK with an error where it is none to lie on. */
static TinkerBlockId find_plate(SceneReader *reader, const ReaderPlaceOn *on)
{
    reader_label(reader, tinker_scene_block_name(reader->scene, on->block));
    const TinkerBlockId plate = tinker_scene_find_block(reader->scene, on->name);
    if (plate == TINKER_NO_BLOCK) {
        g_autofree char *suggestion = reader_suggest_block(reader, on->name);
        reader_error(reader, on->name_at, TINKER_SCENE_ERROR_VALUE, _("on names no block \"%s\"%s"), on->name,
                     suggestion);
        return TINKER_NO_BLOCK;
    }
    g_autofree char *fault = scene_place_on_fault(reader->scene, on->block, plate);
    if (fault == NULL) return plate;
    reader_error(reader, on->name_at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
    return TINKER_NO_BLOCK;
}

void reader_finish_places_on(SceneReader *reader)
{
    if (reader->places_on->len == 0) return;
    for (guint i = 0; i < reader->places_on->len; i++) {
        const ReaderPlaceOn *read = &g_array_index(reader->places_on, ReaderPlaceOn, i);
        const ScenePlaceOn on = {find_plate(reader, read), read->along};
        if (on.plate != TINKER_NO_BLOCK) scene_set_place_on(reader->scene, read->block, &on);
    }
    scene_settle(reader->scene);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(reader->scene, NULL);
    for (guint i = 0; frame != NULL && i < reader->places_on->len; i++) {
        const ReaderPlaceOn *read = &g_array_index(reader->places_on, ReaderPlaceOn, i);
        const ScenePlaceOn *on = scene_place_on(reader->scene, read->block);
        if (on != NULL && tinker_class_has_top(tinker_scene_block_class(reader->scene, on->plate)))
            look_at_top(reader, read, frame, on->plate);
    }
}

/* Writing controls and meters: two lists at the top level. */
#include "scene/store/quantities.h"
#include "scene/write/writer.h"

static void write_range(SceneWriter *writer, const TinkerSceneInstrument *instrument)
{
    TinkerNumber number = {0};
    const TinkerBlockId block = tinker_scene_find_block(writer->scene, instrument->block);
    const gboolean known = tinker_scene_find_number(writer->scene, block, instrument->of, &number);
    const TinkerDimension dimension = known ? number.type->dimension : (TinkerDimension){0};
    scene_write_number_member(writer, "from", instrument->from, dimension);
    scene_write_number_member(writer, "to", instrument->to, dimension);
    if (instrument->step > 0) scene_write_number_member(writer, "step", instrument->step, dimension);
}

static void write_instrument(SceneWriter *writer, const TinkerSceneInstrument *instrument)
{
    static const TinkerDimension length = {.length = 1};
    const gboolean controls = tinker_instrument_controls(instrument);
    g_string_append_c(writer->out, '{');
    scene_write_text_member(writer, "block", instrument->block);
    scene_write_text_member(writer, controls ? "property" : "quantity", instrument->of);
    if (controls) write_range(writer, instrument);
    scene_write_text_member(writer, "kind", scene_instrument_kinds[instrument->kind]);
    if (instrument->has_place) {
        scene_write_key(writer, "place");
        scene_write_vector(writer, instrument->place, length);
    }
    if (instrument->makes_way) {
        scene_write_key(writer, "makes_way");
        g_string_append(writer->out, "true");
    }
    scene_write_extras(writer, instrument->extras);
    g_string_append_c(writer->out, '}');
}

void scene_write_instruments(SceneWriter *writer)
{
    const GPtrArray *all = writer->scene->instruments;
    for (int controls = 1; controls >= 0; controls--) {
        int written = 0;
        for (guint i = 0; i < all->len; i++) {
            const TinkerSceneInstrument *instrument = g_ptr_array_index(all, i);
            if (tinker_instrument_controls(instrument) != controls) continue;
            if (written == 0) g_string_append(writer->out, controls ? ",\n  \"controls\": [" : ",\n  \"meters\": [");
            g_string_append(writer->out, written++ == 0 ? "\n    " : ",\n    ");
            write_instrument(writer, instrument);
        }
        if (written > 0) g_string_append(writer->out, "\n  ]");
    }
}

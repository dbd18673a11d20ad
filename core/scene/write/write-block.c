/* Writing one block on one line: its ends, the values that were given, and what the reader did not know. */
#include <math.h>
#include <string.h>

#include "scene/write/writer.h"
#include "units/quantity/point-text.h"

/* Values ------------------------------------------------------------------------------------------------------- */

static void write_plain(GString *out, double value)
{
    char text[64];
    tinker_number_to_text(value, text, sizeof text);
    g_string_append(out, text);
}

/* A number; in English units where the text reads back to the same bits. */
static void write_number(SceneWriter *writer, double value, TinkerDimension dimension)
{
    if (writer->units == TINKER_WRITE_ENGLISH) {
        g_autofree char *text = tinker_quantity_to_text(value, dimension, TINKER_UNIT_SYSTEM_ENGLISH);
        double back;
        if (strchr(text, ' ') != NULL && tinker_quantity_parse(text, dimension, &back, NULL) &&
            memcmp(&back, &value, sizeof back) == 0) {
            json_append_string(writer->out, text);
            return;
        }
    }
    write_plain(writer->out, value);
}

void scene_write_vector(SceneWriter *writer, const double values[2], TinkerDimension dimension)
{
    g_string_append_c(writer->out, '[');
    write_number(writer, values[0], dimension);
    g_string_append(writer->out, ", ");
    write_number(writer, values[1], dimension);
    g_string_append_c(writer->out, ']');
}

void scene_write_key(SceneWriter *writer, const char *key)
{
    if (writer->out->str[writer->out->len - 1] != '{') g_string_append(writer->out, ", ");
    json_append_string(writer->out, key);
    g_string_append(writer->out, ": ");
}

void scene_write_text_member(SceneWriter *writer, const char *key, const char *text)
{
    scene_write_key(writer, key);
    json_append_string(writer->out, text);
}

void scene_write_number_member(SceneWriter *writer, const char *key, double value, TinkerDimension dimension)
{
    scene_write_key(writer, key);
    write_number(writer, value, dimension);
}

void scene_write_extras(SceneWriter *writer, const char *extras)
{
    if (extras == NULL) return;
    if (writer->out->str[writer->out->len - 1] != '{') g_string_append(writer->out, ", ");
    g_string_append(writer->out, extras);
}

/* Blocks ------------------------------------------------------------------------------------------------------- */

/* Whether a waveform has a form in a file: a table that was not read from one has none. */
static gboolean has_text(const SceneWriter *writer, TinkerWaveform *waveform)
{
    return tinker_waveform_kind(waveform) != TINKER_WAVEFORM_TABLE || writer->texts != NULL ||
           g_hash_table_contains(writer->scene->sources, waveform);
}

/* A fragment's waveforms are told apart by their texts, so that whoever reads it in the same process gets the waveforms
 * themselves: a table's file need not be there. */
static void write_kept(SceneWriter *writer, const char *source, TinkerWaveform *waveform)
{
    const SceneKeptWaveform *kept = source == NULL ? NULL : g_hash_table_lookup(writer->texts, source);
    gboolean plain = source != NULL && (kept == NULL || kept->waveform == waveform);
    char *text = plain ? g_strdup(source)
                       : g_strdup_printf("{\"table\": \"in memory %u\"}", g_hash_table_size(writer->texts) + 1);
    g_string_append(writer->out, text);
    SceneKeptWaveform *keep = g_new(SceneKeptWaveform, 1);
    *keep = (SceneKeptWaveform){tinker_waveform_ref(waveform), g_strdup(source)};
    g_hash_table_replace(writer->texts, text, keep);
}

static void write_waveform(SceneWriter *writer, TinkerWaveform *waveform)
{
    const char *source = g_hash_table_lookup(writer->scene->sources, waveform);
    TinkerWaveformKind kind = tinker_waveform_kind(waveform);
    if (writer->texts != NULL && (source != NULL || kind == TINKER_WAVEFORM_TABLE)) {
        write_kept(writer, source, waveform);
        return;
    }
    if (source != NULL) {
        g_string_append(writer->out, source);
    } else if (kind == TINKER_WAVEFORM_EXPRESSION) {
        g_string_append_c(writer->out, '{');
        scene_write_text_member(writer, "expression", tinker_waveform_expression(waveform));
        g_string_append_c(writer->out, '}');
    } else {
        const char *word = kind == TINKER_WAVEFORM_SINE ? "sine" : kind == TINKER_WAVEFORM_COSINE ? "cosine" : "none";
        json_append_string(writer->out, word);
    }
}

/* FALSE: the text is no list of points. */
static gboolean write_points(SceneWriter *writer, const TinkerPropertyType *type, const char *text)
{
    g_autoptr(GArray) points = tinker_point_text_parse(text, type->dimension, NULL);
    if (points == NULL) return FALSE;
    scene_write_key(writer, type->id);
    g_string_append_c(writer->out, '[');
    for (guint i = 0; i < points->len; i += 2) {
        if (i > 0) g_string_append(writer->out, ", ");
        scene_write_vector(writer, &g_array_index(points, double, i), type->dimension);
    }
    g_string_append_c(writer->out, ']');
    return TRUE;
}

/* A number that a law names stands without quotes where it is read back as the same digits: "1e3" and "3.0" are kept.
 */
static gboolean is_plain_number(const TinkerPropertyType *type, const char *text)
{
    char *end = NULL;
    const double value = (type->flags & TINKER_TEXT_QUANTITY) != 0 ? g_ascii_strtod(text, &end) : NAN;
    if (!isfinite(value) || end == text || *end != '\0') return FALSE;
    g_autofree char *digits = tinker_quantity_to_text(value, type->dimension, TINKER_UNIT_SYSTEM_SI);
    return strcmp(digits, text) == 0;
}

static void write_property(SceneWriter *writer, TinkerBlockId id, const TinkerBlockClass *block_class, int32_t property)
{
    const TinkerPropertyType *type = &block_class->properties[property];
    const gboolean is_position = property == block_class->meanings[TINKER_MEANING_POSITION];
    const gboolean required = (type->flags & TINKER_REQUIRED) != 0 &&
                              !(is_position && scene_place_on(writer->scene, id) != NULL); /* which places it */
    if (!required && !tinker_scene_property_given(writer->scene, id, property)) return;
    if (type->kind == TINKER_KIND_TEXT) {
        const char *text = tinker_scene_get_text(writer->scene, id, property);
        if ((type->flags & TINKER_TEXT_POINTS) != 0 && write_points(writer, type, text)) return;
        if (is_plain_number(type, text)) {
            scene_write_key(writer, type->id);
            g_string_append(writer->out, text);
            return;
        }
        scene_write_text_member(writer, type->id, text);
        return;
    }
    if (type->kind == TINKER_KIND_WAVEFORM) {
        TinkerWaveform *waveform = tinker_scene_get_waveform(writer->scene, id, property);
        if (!has_text(writer, waveform)) return;
        scene_write_key(writer, type->id);
        write_waveform(writer, waveform);
        return;
    }
    double values[2] = {0, 0};
    for (int32_t c = 0; c < tinker_kind_columns(type->kind); c++)
        values[c] = tinker_scene_get(writer->scene, id, block_class->first_columns[property] + c);
    scene_write_key(writer, type->id);
    if (type->kind == TINKER_KIND_VECTOR)
        scene_write_vector(writer, values, type->dimension);
    else if (type->kind == TINKER_KIND_SWITCH)
        g_string_append(writer->out, values[0] != 0 ? "true" : "false");
    else if (type->kind == TINKER_KIND_CHOICE)
        json_append_string(writer->out, type->choices[(int32_t)values[0]]);
    else
        write_number(writer, values[0], type->dimension);
}

static void write_end(SceneWriter *writer, TinkerBlockId id, int32_t number)
{
    static const TinkerDimension length = {.length = 1};
    TinkerSceneEnd end = tinker_scene_end(writer->scene, id, number);
    double place[2] = {end.x, end.y};
    gboolean cut = end.block != TINKER_NO_BLOCK && writer->only != NULL && !writer->only[end.block];
    if (cut) scene_end_place(writer->scene, end, place);
    if (cut || end.block == TINKER_NO_BLOCK) {
        scene_write_vector(writer, place, length);
        return;
    }
    const char *name = tinker_scene_block_name(writer->scene, end.block);
    g_autofree gint64 *key = scene_end_key(id, number);
    const char *extras = g_hash_table_lookup(writer->scene->end_extras, key);
    if (end.x == 0 && end.y == 0 && extras == NULL) {
        json_append_string(writer->out, name);
        return;
    }
    g_string_append_c(writer->out, '{');
    scene_write_text_member(writer, "block", name);
    if (end.x != 0 || end.y != 0) {
        scene_write_key(writer, "at");
        scene_write_vector(writer, place, length);
    }
    scene_write_extras(writer, extras);
    g_string_append_c(writer->out, '}');
}

static void write_ends(SceneWriter *writer, TinkerBlockId id)
{
    int32_t count = tinker_scene_end_count(writer->scene, id);
    if (count == 0) return;
    scene_write_key(writer, "ends");
    g_string_append_c(writer->out, '[');
    for (int32_t end = 0; end < count; end++) {
        if (end > 0) g_string_append(writer->out, ", ");
        write_end(writer, id, end);
    }
    g_string_append_c(writer->out, ']');
}

/* A body that lies on a top; where the plate is not written, it is by its position. */
static void write_place_on(SceneWriter *writer, TinkerBlockId id, const TinkerBlockClass *block_class)
{
    static const TinkerDimension length = {.length = 1}, angle = TINKER_DIMENSION_ANGLE;
    const ScenePlaceOn *on = scene_place_on(writer->scene, id);
    if (on == NULL) return;
    if (writer->only == NULL || writer->only[on->plate]) {
        scene_write_text_member(writer, "on", tinker_scene_block_name(writer->scene, on->plate));
        if (on->along != 0) scene_write_number_member(writer, "along", on->along, length);
        return;
    }
    const int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    const int32_t orientation = block_class->meanings[TINKER_MEANING_ORIENTATION];
    double centre[2];
    for (int32_t c = 0; c < 2; c++)
        centre[c] = tinker_scene_get(writer->scene, id, block_class->first_columns[position] + c);
    scene_write_key(writer, block_class->properties[position].id);
    scene_write_vector(writer, centre, length);
    if (orientation < 0 || tinker_scene_property_given(writer->scene, id, orientation)) return;
    scene_write_number_member(writer, block_class->properties[orientation].id,
                              tinker_scene_get(writer->scene, id, block_class->first_columns[orientation]), angle);
}

/* Marks the blocks that something in the scene names. */
static void find_named(SceneWriter *writer)
{
    TinkerScene *scene = writer->scene;
    writer->named = g_new0(guint8, (gsize)tinker_scene_id_limit(scene) + 1);
    for (int32_t t = 0; t < tinker_scene_table_count(scene); t++) {
        TinkerSceneTable table;
        tinker_scene_table(scene, t, &table);
        for (int32_t end = 0; end < table.end_offsets[table.count]; end++)
            if (table.ends[end].block != TINKER_NO_BLOCK) writer->named[table.ends[end].block] = 1;
    }
    GHashTableIter iter;
    gpointer on;
    g_hash_table_iter_init(&iter, scene->places_on);
    while (g_hash_table_iter_next(&iter, NULL, &on))
        writer->named[((const ScenePlaceOn *)on)->plate] = 1;
    for (guint i = 0; i < scene->graphs->len; i++) {
        const TinkerSceneGraph *graph = g_ptr_array_index(scene->graphs, i);
        g_autoptr(GArray) blocks = scene_graph_blocks(scene, graph);
        for (guint k = 0; k < blocks->len; k++)
            writer->named[g_array_index(blocks, TinkerBlockId, k)] = 1;
    }
    for (guint i = 0; i < scene->instruments->len; i++) {
        const TinkerSceneInstrument *instrument = g_ptr_array_index(scene->instruments, i);
        const TinkerBlockId block = tinker_scene_find_block(scene, instrument->block);
        if (block != TINKER_NO_BLOCK) writer->named[block] = 1;
    }
}

/* As it was read; but its name is the one it has now, and is there if something uses it. */
static void write_placeholder(SceneWriter *writer, TinkerBlockId id)
{
    const ScenePlaceholder *placeholder = g_hash_table_lookup(writer->scene->placeholders, GINT_TO_POINTER(id));
    const char *name = tinker_scene_block_name(writer->scene, id);
    gboolean same = g_str_equal(name, placeholder->name);
    if (same && !placeholder->named && writer->named == NULL) find_named(writer);
    if (same && (placeholder->named || !writer->named[id])) {
        g_string_append(writer->out, placeholder->text);
        return;
    }
    g_autoptr(GArray) parts = json_split(placeholder->text, 0);
    g_autoptr(GString) others = g_string_new(NULL);
    for (guint i = 0; i < parts->len; i++) {
        const JsonPart *part = &g_array_index(parts, JsonPart, i);
        if (!json_key_is(placeholder->text, part, "type") && !json_key_is(placeholder->text, part, "name"))
            json_append_member(others, placeholder->text, part);
    }
    g_string_append_c(writer->out, '{');
    scene_write_text_member(writer, "type", placeholder->type);
    scene_write_text_member(writer, "name", name);
    scene_write_extras(writer, others->len == 0 ? NULL : others->str);
    g_string_append_c(writer->out, '}');
}

void scene_write_block(SceneWriter *writer, TinkerBlockId id)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, id);
    if (block_class == NULL) {
        write_placeholder(writer, id);
        return;
    }
    g_string_append_c(writer->out, '{');
    scene_write_text_member(writer, "type", block_class->type->id);
    scene_write_text_member(writer, "name", tinker_scene_block_name(writer->scene, id));
    write_ends(writer, id);
    write_place_on(writer, id, block_class);
    for (int32_t property = 0; property < block_class->property_count; property++)
        write_property(writer, id, block_class, property);
    scene_write_extras(writer, g_hash_table_lookup(writer->scene->extras, GINT_TO_POINTER(id)));
    g_string_append_c(writer->out, '}');
}

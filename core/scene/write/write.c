/* Writing a scene in its normal form: the keys in a fixed order, one block a line, what was given and nothing else. */
#include <errno.h>
#include <glib/gstdio.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files/replace-file.h"
#include "scene/write/writer.h"
#include "units/quantity/plain-text.h"

static const TinkerDimension no_dimension = {0};

/* A key of the top level, on a line of its own. */
static void top_key(SceneWriter *writer, const char *key)
{
    g_string_append(writer->out, ",\n  ");
    json_append_string(writer->out, key);
    g_string_append(writer->out, ": ");
}

static void top_text(SceneWriter *writer, const char *key, const char *text)
{
    if (text == NULL || *text == '\0') return;
    top_key(writer, key);
    json_append_string(writer->out, text);
}

static void write_canvas(SceneWriter *writer, const TinkerSceneHead *defaults)
{
    static const TinkerDimension length = {.length = 1};
    const TinkerSceneHead *head = &writer->scene->head;
    if (head->canvas_width == defaults->canvas_width && head->canvas_grid == defaults->canvas_grid &&
        head->canvas_snap == defaults->canvas_snap && writer->scene->canvas_extras == NULL)
        return;
    top_key(writer, "canvas");
    g_string_append_c(writer->out, '{');
    scene_write_number_member(writer, "width", head->canvas_width, length);
    scene_write_number_member(writer, "grid", head->canvas_grid, length);
    scene_write_key(writer, "snap");
    g_string_append(writer->out, head->canvas_snap ? "true" : "false");
    scene_write_extras(writer, writer->scene->canvas_extras);
    g_string_append_c(writer->out, '}');
}

static void write_run(SceneWriter *writer, const TinkerSceneHead *defaults)
{
    const TinkerRunSettings *run = &writer->scene->head.run;
    top_key(writer, "run");
    g_string_append_c(writer->out, '{');
    scene_write_number_member(writer, "duration", run->duration, no_dimension);
    scene_write_number_member(writer, "interval", run->interval, no_dimension);
    scene_write_text_member(writer, "method", run->method);
    scene_write_number_member(writer, "step", run->step, no_dimension);
    scene_write_number_member(writer, "tolerance", run->tolerance, no_dimension);
    if (run->accuracy != defaults->run.accuracy)
        scene_write_number_member(writer, "accuracy", run->accuracy, no_dimension);
    if (g_strcmp0(run->contacts, defaults->run.contacts) != 0)
        scene_write_text_member(writer, "contacts", run->contacts);
    if (g_strcmp0(run->impact_law, defaults->run.impact_law) != 0)
        scene_write_text_member(writer, "impact_law", run->impact_law);
    if (run->spectral_radius != defaults->run.spectral_radius)
        scene_write_number_member(writer, "spectral_radius", run->spectral_radius, no_dimension);
    if (*run->until != '\0') scene_write_text_member(writer, "until", run->until);
    scene_write_extras(writer, writer->scene->run_extras);
    g_string_append_c(writer->out, '}');
}

static void write_curve(SceneWriter *writer, const TinkerSceneCurve *curve)
{
    const struct {
        const char *key, *text;
    } texts[] = {{"block", curve->block},
                 {"quantity", curve->quantity},
                 {"expression", curve->expression},
                 {"table", curve->table}};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        if (texts[i].text != NULL) scene_write_text_member(writer, texts[i].key, texts[i].text);
    if (curve->table != NULL) {
        scene_write_key(writer, "column");
        g_string_append_printf(writer->out, "%d", curve->column);
        if (curve->time_column != 0) {
            scene_write_key(writer, "time_column");
            g_string_append_printf(writer->out, "%d", curve->time_column);
        }
    }
    if (curve->title != NULL) scene_write_text_member(writer, "title", curve->title);
    if (curve->unit != NULL) scene_write_text_member(writer, "unit", curve->unit);
    if (curve->axis == 2) {
        scene_write_key(writer, "axis");
        g_string_append_c(writer->out, '2');
    }
    scene_write_extras(writer, curve->extras);
}

/* A curve that is a quantity and nothing else stands in the graph itself, if it is the only one. */
static gboolean is_short(const TinkerSceneGraph *graph)
{
    const TinkerSceneCurve *curve = g_ptr_array_index(graph->curves, 0);
    return graph->curves->len == 1 && curve->block != NULL && curve->title == NULL && curve->axis == 1 &&
           curve->extras == NULL;
}

static void write_curves(SceneWriter *writer, const TinkerSceneGraph *graph)
{
    if (is_short(graph)) {
        write_curve(writer, g_ptr_array_index(graph->curves, 0));
        return;
    }
    scene_write_key(writer, "curves");
    for (guint i = 0; i < graph->curves->len; i++) {
        g_string_append(writer->out, i == 0 ? "[{" : ", {");
        write_curve(writer, g_ptr_array_index(graph->curves, i));
        g_string_append_c(writer->out, '}');
    }
    g_string_append_c(writer->out, ']');
}

static void write_axes(SceneWriter *writer, const TinkerSceneGraph *graph)
{
    if (graph->logarithmic[0] || graph->logarithmic[1]) {
        scene_write_key(writer, "scale");
        g_string_append_printf(writer->out, "[\"%s\", \"%s\"]", graph->logarithmic[0] ? "log" : "linear",
                               graph->logarithmic[1] ? "log" : "linear");
    }
    if (!graph->has_range[0] && !graph->has_range[1]) return;
    static const TinkerDimension plain = {0};
    scene_write_key(writer, "range");
    for (int axis = 0; axis < 2; axis++) {
        g_string_append(writer->out, axis == 0 ? "[" : ", ");
        if (graph->has_range[axis])
            scene_write_vector(writer, graph->range[axis], plain);
        else
            g_string_append(writer->out, "null");
    }
    g_string_append_c(writer->out, ']');
}

static void write_graph(SceneWriter *writer, const TinkerSceneGraph *graph)
{
    static const TinkerDimension length = {.length = 1};
    g_string_append_c(writer->out, '{');
    write_curves(writer, graph);
    if (!g_str_equal(graph->against, "time")) scene_write_text_member(writer, "against", graph->against);
    write_axes(writer, graph);
    if (graph->has_place) {
        scene_write_key(writer, "place");
        scene_write_vector(writer, graph->place, length);
    }
    if (graph->has_size) {
        scene_write_key(writer, "size");
        scene_write_vector(writer, graph->size, length);
    }
    if (graph->title != NULL) scene_write_text_member(writer, "title", graph->title);
    scene_write_extras(writer, graph->extras);
    g_string_append_c(writer->out, '}');
}

/* Entry `place` of a list that has one on each line. */
static void list_entry(SceneWriter *writer, int32_t place)
{
    g_string_append(writer->out, place == 0 ? "\n    " : ",\n    ");
}

static gboolean is_written(const SceneWriter *writer, TinkerBlockId id)
{
    return writer->only == NULL || (id != TINKER_NO_BLOCK && writer->only[id]);
}

void scene_write_blocks(SceneWriter *writer)
{
    int32_t count = tinker_scene_block_count(writer->scene), written = 0;
    top_key(writer, "blocks");
    g_string_append_c(writer->out, '[');
    for (int32_t place = 0; place < count; place++) {
        TinkerBlockId id = tinker_scene_block_at(writer->scene, place);
        if (!is_written(writer, id)) continue;
        list_entry(writer, written++);
        scene_write_block(writer, id);
    }
    g_string_append(writer->out, written == 0 ? "]" : "\n  ]");
}

/* Of some blocks alone those graphs are written that need no others. */
static gboolean all_written(const SceneWriter *writer, const TinkerSceneGraph *graph)
{
    if (writer->only == NULL) return TRUE;
    g_autoptr(GArray) blocks = scene_graph_blocks(writer->scene, graph);
    for (guint i = 0; i < blocks->len; i++)
        if (!is_written(writer, g_array_index(blocks, TinkerBlockId, i))) return FALSE;
    return blocks->len > 0;
}

void scene_write_graphs(SceneWriter *writer)
{
    const GPtrArray *graphs = writer->scene->graphs;
    int32_t written = 0;
    for (guint i = 0; i < graphs->len; i++) {
        const TinkerSceneGraph *graph = g_ptr_array_index(graphs, i);
        if (!all_written(writer, graph)) continue;
        if (written == 0) {
            top_key(writer, "graphs");
            g_string_append_c(writer->out, '[');
        }
        list_entry(writer, written++);
        write_graph(writer, graph);
    }
    if (written > 0) g_string_append(writer->out, "\n  ]");
}

static void write_document(SceneWriter *writer)
{
    const TinkerSceneHead *head = &writer->scene->head;
    TinkerSceneHead defaults;
    scene_head_init(&defaults);
    g_string_append(writer->out, "{\n  \"tinker\": 1");
    top_text(writer, "title", head->title);
    top_text(writer, "description", head->description);
    top_text(writer, "author", head->author);
    if (head->units == TINKER_UNIT_SYSTEM_ENGLISH) top_text(writer, "units", "English");
    write_canvas(writer, &defaults);
    write_run(writer, &defaults);
    scene_write_blocks(writer);
    scene_write_graphs(writer);
    scene_write_instruments(writer);
    if (writer->scene->head_extras != NULL) g_string_append_printf(writer->out, ",\n  %s", writer->scene->head_extras);
    g_string_append(writer->out, "\n}\n");
    scene_head_clear(&defaults);
}

char *tinker_scene_to_text(TinkerScene *scene, TinkerWriteUnits units)
{
    SceneWriter writer = {.scene = scene, .units = units, .out = g_string_new(NULL)};
    write_document(&writer);
    g_free(writer.named);
    return g_string_free(writer.out, FALSE);
}

static gboolean write_standard_output(const char *text, gsize length, GError **error)
{
    if (fwrite(text, 1, length, stdout) == length && fflush(stdout) == 0) return TRUE;
    g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE, "standard output cannot be written");
    return FALSE;
}

gboolean tinker_scene_write_file(TinkerScene *scene, const char *path, TinkerWriteUnits units, GError **error)
{
    g_autofree char *text = tinker_scene_to_text(scene, units);
    if (g_str_equal(path, "-")) {
        g_autofree char *plain = tinker_text_escaped(text, TRUE); /* it may be a terminal */
        return write_standard_output(plain, strlen(plain), error);
    }
    gsize length = strlen(text);

    g_autoptr(GError) reason = NULL;
    if (tinker_replace_file(path, text, length, 0666, &reason)) return TRUE;
    g_autofree char *folder = g_path_get_dirname(path);
    g_autofree char *no_folder =
        g_file_test(folder, G_FILE_TEST_EXISTS) ? NULL : g_strdup_printf("the folder %s does not exist", folder);
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE, "%s: the file cannot be written: %s", path,
                no_folder != NULL ? no_folder : reason->message);
    return FALSE;
}

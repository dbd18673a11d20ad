/* Reading graphs: which quantity of which block, and where the graph stands on the canvas. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "scene/store/quantities.h"
#include "scene/value/reader.h"

/* Where a curve's members stand; the places are for messages. */
typedef struct {
    TinkerSceneCurve *curve;
    JsonAt at, block_at, quantity_at, expression_at, table_at, axis_at, unit_at;
    gboolean given; /* some member of it: block, quantity, expression or table */
    gboolean wrong; /* some member was no text, which has been told */
} ReadCurve;

typedef struct {
    TinkerSceneGraph *graph;
    ReadCurve own;  /* of the graph itself: the only one, in the short form */
    GArray *curves; /* of ReadCurve, of "curves"; NULL where there is no such key */
    JsonAt against_at, curves_at, range_at;
} ReadGraph;

static void take_text(SceneReader *reader, const cJSON *json, JsonAt at, char **text)
{
    const char *given = reader_text(reader, json, at, json->string);
    if (given == NULL) return;
    g_free(*text);
    *text = g_strdup(given);
}

static void read_column(SceneReader *reader, const cJSON *json, JsonAt at, int *column)
{
    double number;
    if (!reader_number(reader, json, at, json->string, reader_pure, &number)) return;
    if (number >= 0 && number <= TINKER_TABLE_MOST_COLUMN && number == floor(number))
        *column = (int)number;
    else
        reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s must be a whole number from 0"), json->string);
}

/* A member of a curve; FALSE where it is none. */
static gboolean read_curve_member(SceneReader *reader, const cJSON *json, JsonAt at, ReadCurve *read)
{
    TinkerSceneCurve *curve = read->curve;
    const struct {
        const char *key;
        char **text;
        JsonAt *at;
    } texts[] = {{"block", &curve->block, &read->block_at},
                 {"quantity", &curve->quantity, &read->quantity_at},
                 {"expression", &curve->expression, &read->expression_at},
                 {"table", &curve->table, &read->table_at}};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        if (!g_str_equal(json->string, texts[i].key)) continue;
        *texts[i].at = at;
        take_text(reader, json, at, texts[i].text);
        read->given = TRUE;
        read->wrong |= *texts[i].text == NULL;
        return TRUE;
    }
    return FALSE;
}

/* A member of an entry of "curves". */
static void read_entry_member(SceneReader *reader, const cJSON *json, JsonAt at, ReadCurve *read, GString **unknown)
{
    static const char *const keys[] = {"block",       "quantity", "expression", "table", "column",
                                       "time_column", "title",    "unit",       "axis",  NULL};
    TinkerSceneCurve *curve = read->curve;
    if (read_curve_member(reader, json, at, read)) return;
    if (g_str_equal(json->string, "title")) {
        take_text(reader, json, at, &curve->title);
    } else if (g_str_equal(json->string, "unit")) {
        read->unit_at = at;
        take_text(reader, json, at, &curve->unit);
    } else if (g_str_equal(json->string, "column")) {
        read_column(reader, json, at, &curve->column);
    } else if (g_str_equal(json->string, "time_column")) {
        read_column(reader, json, at, &curve->time_column);
    } else if (g_str_equal(json->string, "axis")) {
        double axis;
        read->axis_at = at;
        if (reader_number(reader, json, at, "axis", reader_pure, &axis))
            curve->axis = axis == 1 || axis == 2 ? (int)axis : 0;
    } else {
        reader_keep_unknown(reader, at, json->string, keys, unknown);
    }
}

static ReadCurve new_curve(JsonAt at)
{
    TinkerSceneCurve *curve = g_new0(TinkerSceneCurve, 1);
    curve->axis = 1;
    curve->column = 1;
    return (ReadCurve){.curve = curve, .at = at};
}

static void read_curves(SceneReader *reader, const cJSON *json, JsonAt at, ReadGraph *read)
{
    read->curves_at = at;
    read->curves = g_array_new(FALSE, FALSE, sizeof(ReadCurve));
    if (!cJSON_IsArray(json)) {
        reader_wrong_kind(reader, json, at, "curves", _("an array"));
        return;
    }
    int number = 0;
    for (const cJSON *entry = json->child; entry != NULL; entry = entry->next, number++) {
        ReadCurve curve = new_curve(at_child(at, number));
        GString *unknown = NULL;
        int step = 0;
        if (!cJSON_IsObject(entry)) {
            reader_error(reader, curve.at, TINKER_SCENE_ERROR_VALUE,
                         _("a curve is an object, {\"block\": ..., \"quantity\": ...} or {\"expression\": ...}"));
            scene_curve_free(curve.curve);
            continue;
        }
        for (const cJSON *member = entry->child; member != NULL; member = member->next, step++)
            read_entry_member(reader, member, at_child(curve.at, step), &curve, &unknown);
        if (curve.curve->column == curve.curve->time_column)
            reader_error(reader, curve.at, TINKER_SCENE_ERROR_VALUE,
                         _("column must be another one than that of the time (%d)"), curve.curve->time_column);
        curve.curve->extras = unknown == NULL ? NULL : g_string_free(unknown, FALSE);
        g_array_append_val(read->curves, curve);
    }
}

/* "scale" and "range": two entries, of x and of y. */
static gboolean is_pair(SceneReader *reader, const cJSON *json, JsonAt at, const char *what)
{
    if (cJSON_IsArray(json) && cJSON_GetArraySize(json) == 2) return TRUE;
    return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s must be an array of two: of x and of y"), what);
}

static void read_scale(SceneReader *reader, const cJSON *json, JsonAt at, TinkerSceneGraph *graph)
{
    static const char *const scales[] = {"linear", "log", NULL};
    if (!is_pair(reader, json, at, "scale")) return;
    for (int axis = 0; axis < 2; axis++)
        graph->logarithmic[axis] =
            reader_choice(reader, cJSON_GetArrayItem(json, axis), at_child(at, axis), "scale", scales) == 1;
}

static void read_range(SceneReader *reader, const cJSON *json, JsonAt at, TinkerSceneGraph *graph)
{
    if (!is_pair(reader, json, at, "range")) return;
    for (int axis = 0; axis < 2; axis++) {
        const cJSON *entry = cJSON_GetArrayItem(json, axis);
        if (!cJSON_IsNull(entry))
            graph->has_range[axis] =
                reader_vector(reader, entry, at_child(at, axis), "range", reader_pure, graph->range[axis]);
    }
}

static gboolean read_size(SceneReader *reader, const cJSON *json, JsonAt at, double size[2])
{
    if (!reader_vector(reader, json, at, "size", reader_length, size)) return FALSE;
    g_autofree char *fault = scene_graph_size_fault(size);
    return fault == NULL || reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
}

static void read_member(SceneReader *reader, const cJSON *json, JsonAt at, ReadGraph *read, GString **unknown)
{
    static const char *const keys[] = {"block", "quantity", "curves", "against", "scale",
                                       "range", "place",    "size",   "title",   NULL};
    TinkerSceneGraph *graph = read->graph;
    const gboolean own = g_str_equal(json->string, "block") || g_str_equal(json->string, "quantity");
    if (own && read_curve_member(reader, json, at, &read->own)) return;
    if (g_str_equal(json->string, "against")) {
        read->against_at = at;
        take_text(reader, json, at, &graph->against);
    } else if (g_str_equal(json->string, "curves")) {
        read_curves(reader, json, at, read);
    } else if (g_str_equal(json->string, "scale")) {
        read_scale(reader, json, at, graph);
    } else if (g_str_equal(json->string, "range")) {
        read->range_at = at;
        read_range(reader, json, at, graph);
    } else if (g_str_equal(json->string, "title")) {
        take_text(reader, json, at, &graph->title);
    } else if (g_str_equal(json->string, "place")) {
        graph->has_place = reader_vector(reader, json, at, "place", reader_length, graph->place);
    } else if (g_str_equal(json->string, "size")) {
        graph->has_size = read_size(reader, json, at, graph->size);
    } else {
        reader_keep_unknown(reader, at, json->string, keys, unknown);
    }
}

/* Checks ----------------------------------------------------------------------------------------------------------- */

static gboolean check_quantity(SceneReader *reader, JsonAt at, const char *what, TinkerBlockId block,
                               const char *quantity)
{
    g_autofree char *fault = scene_quantity_fault(reader->scene, block, quantity);
    return fault == NULL || reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: %s", what, fault);
}

static gboolean check_block(SceneReader *reader, const ReadGraph *graph, const ReadCurve *read)
{
    const TinkerSceneCurve *curve = read->curve;
    TinkerBlockId block;
    gboolean good = !read->wrong;
    if (read->block_at.depth == 0)
        good = reader_error(reader, read->at, TINKER_SCENE_ERROR_SYNTAX, _("the key \"block\" is missing"));
    if (read->quantity_at.depth == 0)
        good = reader_error(reader, read->at, TINKER_SCENE_ERROR_SYNTAX, _("the key \"quantity\" is missing"));
    if (curve->block == NULL) return FALSE;
    if (!tinker_scene_find_owner(reader->scene, curve->block, &block)) {
        g_autofree char *suggestion = reader_suggest_block(reader, curve->block);
        return reader_error(reader, read->block_at, TINKER_SCENE_ERROR_VALUE, _("block: there is no block \"%s\"%s"),
                            curve->block, suggestion);
    }
    if (curve->quantity != NULL)
        good = check_quantity(reader, read->quantity_at, "quantity", block, curve->quantity) && good;
    if (!scene_graph_is_of_samples(graph->graph))
        good = check_quantity(reader, graph->against_at, "against", block, graph->graph->against) && good;
    return good;
}

static gboolean check_curve(SceneReader *reader, const ReadGraph *graph, const ReadCurve *read)
{
    const TinkerSceneCurve *curve = read->curve;
    const gboolean quantity = read->block_at.depth > 0 || read->quantity_at.depth > 0;
    const int kinds = quantity + (read->expression_at.depth > 0) + (read->table_at.depth > 0);
    if (kinds != 1)
        return reader_error(reader, read->at, TINKER_SCENE_ERROR_VALUE,
                            _("a curve has either \"block\" and \"quantity\", or \"expression\", or \"table\""));
    if (quantity && !check_block(reader, graph, read)) return FALSE;
    if (read->wrong) return FALSE;
    g_autofree char *fault = scene_curve_fault(reader->scene, graph->graph, curve);
    if (fault == NULL) return TRUE;
    const JsonAt at = curve->axis == 0                      ? read->axis_at
                      : quantity && read->unit_at.depth > 0 ? read->unit_at
                      : read->expression_at.depth > 0       ? read->expression_at
                                                            : read->at;
    return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
}

/* A table is looked for where the scene is: a curve without one is told of, and kept. */
static void check_table(SceneReader *reader, const ReadCurve *read)
{
    g_autoptr(GError) error = NULL;
    if (read->curve->table == NULL || reader->folder == NULL) return;
    g_autofree char *path = reader_table_path(reader->folder, read->curve->table, &error);
    if (path == NULL) reader_error(reader, read->table_at, TINKER_SCENE_ERROR_FILE, _("table: %s"), error->message);
}

static void check_graph(SceneReader *reader, JsonAt at, ReadGraph *read)
{
    if (read->curves != NULL && read->own.given)
        reader_error(reader, read->own.block_at.depth > 0 ? read->own.block_at : read->own.quantity_at,
                     TINKER_SCENE_ERROR_VALUE,
                     _("\"curves\" and \"block\" exclude each other (a curve of \"curves\" has the block)"));
    if (read->curves != NULL && read->curves->len == 0)
        reader_error(reader, read->curves_at, TINKER_SCENE_ERROR_VALUE, _("curves: a graph needs a curve"));
    g_autofree char *range = scene_graph_range_fault(read->graph, 0);
    if (range == NULL) range = scene_graph_range_fault(read->graph, 1);
    if (range != NULL) reader_error(reader, read->range_at, TINKER_SCENE_ERROR_VALUE, "%s", range);
    for (guint i = 0; read->curves != NULL && i < read->curves->len; i++) {
        const ReadCurve *curve = &g_array_index(read->curves, ReadCurve, i);
        if (check_curve(reader, read, curve)) check_table(reader, curve);
        g_ptr_array_add(read->graph->curves, curve->curve);
    }
    if (read->curves != NULL) {
        scene_curve_free(read->own.curve);
        g_array_unref(read->curves);
        return;
    }
    read->own.at = at;
    check_block(reader, read, &read->own);
    g_ptr_array_add(read->graph->curves, read->own.curve);
}

static void read_graph(SceneReader *reader, const cJSON *json, JsonAt at)
{
    ReadGraph read = {.graph = tinker_scene_graph_new(), .own = new_curve(at)};
    GString *unknown = NULL;
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++)
        read_member(reader, member, at_child(at, step), &read, &unknown);
    check_graph(reader, at, &read);
    read.graph->extras = unknown == NULL ? NULL : g_string_free(unknown, FALSE);
    g_ptr_array_add(reader->scene->graphs, read.graph);
}

void reader_graphs(SceneReader *reader, const JsonPart *part)
{
    cJSON *json = reader_parse(reader, part);
    if (json == NULL) return;
    if (!cJSON_IsArray(json)) reader_wrong_kind(reader, json, at_root(part->start), "graphs", _("an array"));
    int number = 0;
    for (const cJSON *member = cJSON_IsArray(json) ? json->child : NULL; member != NULL;
         member = member->next, number++) {
        JsonAt at = at_child(at_root(part->start), number);
        reader_label_entry(reader, "graphs", number, NULL);
        if (cJSON_IsObject(member))
            read_graph(reader, member, at);
        else
            reader_error(reader, at, TINKER_SCENE_ERROR_VALUE,
                         _("a graph is an object, {\"block\": ..., \"quantity\": ...}"));
    }
    reader_label(reader, NULL);
    cJSON_Delete(json);
}

/* The record is read from where the last reading ended. Both quantities of a phase plot have a cursor of their own, and
 * the run may go on between the two readings: only points that have both count. */
#include "gui/document/graph-data.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>

#include "files/replace-file.h"
#include "graph-axis.h"
#include "gui/text/translate.h"
#include "gui/widget/path-thin.h"

#define THIN_SHARE 3000.0 /* of the range: less than a pixel */
#define THIN_TAIL  50     /* the part of the points that may be new before all are thinned again */

struct _TinkerGraphData {
    TinkerDocument *document;
    TinkerPlayer *player;

    /* The graph. */
    char *block, *quantity, *against; /* `against` is NULL over time */
    char *title;
    char *x_label, *y_label;
    TinkerGraphAxis x_axis, y_axis;
    gboolean is_path;

    /* The record. */
    guint generation;
    TinkerSeriesCursor x_cursor, y_cursor;
    GArray *times, *x, *y; /* of double; x is empty over time */
    double time;           /* s: the present */
    guint64 revision;      /* of the picture */

    /* The path thinned, as far as its first points. */
    GArray *kept;            /* of guint */
    GArray *thin_x, *thin_y; /* of double */
    gsize thinned;
    gboolean drawn_thin;

    /* What a plot borrows. */
    TinkerCurve curves[2];
    double now, now_x, now_y;
    double axes_x[2], axes_y[2], floor_y[2];
};

static void forget_points(TinkerGraphData *data)
{
    g_array_set_size(data->times, 0);
    g_array_set_size(data->x, 0);
    g_array_set_size(data->y, 0);
    g_array_set_size(data->kept, 0);
    data->thinned = 0;
    data->x_cursor = data->y_cursor = (TinkerSeriesCursor){0};
    data->revision++;
}

static const double *numbers(const GArray *array)
{
    return (const double *)(gpointer)array->data;
}

/* The graph -----------------------------------------------------------------------------------------------------------
 */

/* Nobody knows the quantities of a placeholder: it has their ids for titles. */
static TinkerGraphAxis axis_of(TinkerScene *scene, const char *block_name, const char *id)
{
    TinkerBlockId block;
    int32_t quantity =
        tinker_scene_find_owner(scene, block_name, &block) ? tinker_scene_find_quantity(scene, block, id) : -1;
    if (quantity < 0) return (TinkerGraphAxis){.title = id, .unit = "", .per_si = 1, .block = block};
    return tinker_graph_axis(scene, block, quantity);
}

static void renew_texts(TinkerGraphData *data, const char *own_title)
{
    g_free(data->title);
    g_free(data->x_label);
    g_free(data->y_label);
    const char *y = tinker_translate(data->y_axis.title), *x = tinker_translate(data->x_axis.title);
    if (own_title != NULL && own_title[0] != '\0')
        data->title = g_strdup(own_title);
    else if (data->against == NULL)
        data->title = g_strdup_printf("%s: %s", data->block, y);
    else
        data->title = g_strdup_printf(_("%s: %s over %s"), data->block, y, x);
    data->x_label = tinker_axis_label(x, data->x_axis.unit);
    data->y_label = tinker_axis_label(y, data->y_axis.unit);
}

void tinker_graph_data_set_graph(TinkerGraphData *data, const TinkerSceneGraph *graph)
{
    TinkerScene *scene = tinker_document_scene(data->document);
    static const TinkerSceneCurve none = {.block = (char *)"", .quantity = (char *)""};
    const TinkerSceneCurve *first = tinker_scene_graph_curve(graph), *curve = first != NULL ? first : &none;
    gboolean over_time = g_str_equal(graph->against, "time");
    gboolean same = g_strcmp0(data->block, curve->block) == 0 && g_strcmp0(data->quantity, curve->quantity) == 0 &&
                    g_strcmp0(data->against, over_time ? NULL : graph->against) == 0;
    double x_factor = data->x_axis.per_si, y_factor = data->y_axis.per_si;
    if (!same) {
        char *names[] = {data->block, data->quantity, data->against};
        data->block = g_strdup(curve->block);
        data->quantity = g_strdup(curve->quantity);
        data->against = over_time ? NULL : g_strdup(graph->against);
        for (gsize i = 0; i < G_N_ELEMENTS(names); i++)
            g_free(names[i]);
    }
    data->y_axis = axis_of(scene, data->block, data->quantity);
    data->x_axis = over_time ? tinker_graph_axis_time() : axis_of(scene, data->block, data->against);
    data->is_path = tinker_graph_axes_of_path(&data->x_axis, &data->y_axis);
    data->revision++;
    if (!same || data->x_axis.per_si != x_factor || data->y_axis.per_si != y_factor) forget_points(data);
    renew_texts(data, graph->title);
}

const char *tinker_graph_data_title(const TinkerGraphData *data)
{
    return data->title;
}

/* The record ----------------------------------------------------------------------------------------------------------
 */

/* Takes over a portion. */
static void take(TinkerGraphData *data, const char *quantity, TinkerSeriesCursor *cursor, double per_si, GArray *times,
                 GArray *values)
{
    TinkerScene *scene = tinker_document_scene(data->document);
    TinkerBlockId block;
    gboolean found = tinker_scene_find_owner(scene, data->block, &block);
    guint first = values->len;
    cursor->behind = FALSE;
    TinkerQuantity of = {block, found ? tinker_scene_find_quantity(scene, block, quantity) : -1};
    if (of.quantity < 0) return;
    tinker_player_series(data->player, of, cursor, times, values);
    for (guint i = first; i < values->len; i++)
        g_array_index(values, double, i) *= per_si;
}

guint64 tinker_graph_data_update(TinkerGraphData *data)
{
    if (data->block == NULL) return data->revision;
    guint generation = tinker_player_generation(data->player);
    double before = data->time;
    gsize count = tinker_graph_data_count(data);
    if (generation != data->generation) forget_points(data);
    data->generation = generation;
    take(data, data->quantity, &data->y_cursor, data->y_axis.per_si, data->times, data->y);
    if (data->against != NULL) {
        g_autoptr(GArray) same_times = g_array_new(FALSE, FALSE, sizeof(double));
        take(data, data->against, &data->x_cursor, data->x_axis.per_si, same_times, data->x);
    }
    data->time = tinker_player_time(data->player);
    if (data->time != before || count != tinker_graph_data_count(data)) data->revision++;
    return data->revision;
}

gboolean tinker_graph_data_is_behind(const TinkerGraphData *data)
{
    return data->y_cursor.behind || data->x_cursor.behind;
}

void tinker_graph_data_catch_up(TinkerGraphData *data)
{
    do
        tinker_graph_data_update(data);
    while (tinker_graph_data_is_behind(data));
}

gsize tinker_graph_data_count(const TinkerGraphData *data)
{
    return data->against != NULL ? MIN(data->x->len, data->y->len) : data->y->len;
}

const double *tinker_graph_data_x(const TinkerGraphData *data)
{
    return numbers(data->against != NULL ? data->x : data->times);
}

const double *tinker_graph_data_y(const TinkerGraphData *data)
{
    return numbers(data->y);
}

gboolean tinker_graph_data_present(const TinkerGraphData *data, gsize *point)
{
    const double *times = numbers(data->times);
    gsize low = 0, high = tinker_graph_data_count(data);
    while (low < high) {
        gsize middle = low + (high - low) / 2;
        if (times[middle] <= data->time)
            low = middle + 1;
        else
            high = middle;
    }
    *point = low - 1;
    return low > 0;
}

/* Thinning ------------------------------------------------------------------------------------------------------------
 */

static double range_of(const double *values, gsize count)
{
    double least = INFINITY, greatest = -INFINITY;
    for (gsize i = 0; i < count; i++) {
        least = values[i] < least ? values[i] : least;
        greatest = values[i] > greatest ? values[i] : greatest;
    }
    return greatest > least ? greatest - least : 1;
}

/* While the record grows, most points were thinned before. */
static void thin(TinkerGraphData *data)
{
    const double *x = numbers(data->x), *y = numbers(data->y);
    gsize count = tinker_graph_data_count(data);
    if (count > data->thinned + data->thinned / THIN_TAIL) {
        double tolerance[2] = {range_of(x, count) / THIN_SHARE, range_of(y, count) / THIN_SHARE};
        g_array_set_size(data->kept, 0);
        tinker_path_thin(x, y, count, tolerance, data->kept);
        data->thinned = count;
    }
    for (guint i = g_array_index(data->kept, guint, data->kept->len - 1) + 1; i < count; i++)
        g_array_append_val(data->kept, i);
    g_array_set_size(data->thin_x, 0);
    g_array_set_size(data->thin_y, 0);
    for (guint i = 0; i < data->kept->len; i++) {
        guint point = g_array_index(data->kept, guint, i);
        g_array_append_val(data->thin_x, x[point]);
        g_array_append_val(data->thin_y, y[point]);
    }
}

gsize tinker_graph_data_point(const TinkerGraphData *data, gsize drawn)
{
    return data->drawn_thin ? g_array_index(data->kept, guint, drawn) : drawn;
}

/* The plot ------------------------------------------------------------------------------------------------------------
 */

/* A plot without a point has no axes: this curve lies on the frame, where nobody sees it. */
static void fill_bare_axes(TinkerGraphData *data, TinkerPlot *plot)
{
    double duration = tinker_player_duration(data->player);
    data->axes_x[0] = data->axes_y[0] = data->floor_y[0] = data->floor_y[1] = 0;
    data->axes_x[1] = data->against == NULL && duration > 0 ? duration : 1;
    data->axes_y[1] = 1;
    data->curves[0] = (TinkerCurve){.x = data->axes_x, .y = data->floor_y, .count = 2, .role = TINKER_CURVE_GUIDE};
    plot->curve_count = 1;
    plot->x_range = data->axes_x;
    plot->y_range = data->axes_y;
}

/* The present point of a phase plot, straight between two samples; over time the cursor marks it. */
static void add_present(TinkerGraphData *data, TinkerPlot *plot)
{
    gsize point, last = tinker_graph_data_count(data) - 1;
    if (data->against == NULL) {
        data->now = data->time;
        plot->cursor = &data->now;
    } else if (tinker_graph_data_present(data, &point)) {
        const double *times = numbers(data->times), *x = numbers(data->x), *y = numbers(data->y);
        gsize next = MIN(point + 1, last);
        double span = times[next] - times[point], share = span > 0 ? fmin((data->time - times[point]) / span, 1) : 0;
        data->now_x = x[point] + share * (x[next] - x[point]);
        data->now_y = y[point] + share * (y[next] - y[point]);
        data->curves[1] =
            (TinkerCurve){.x = &data->now_x, .y = &data->now_y, .count = 1, .role = TINKER_CURVE_RING, .no_line = TRUE};
        plot->curve_count = 2;
    }
}

void tinker_graph_data_fill_plot(TinkerGraphData *data, TinkerPlot *plot)
{
    gsize count = tinker_graph_data_count(data);
    plot->x_label = data->x_label;
    plot->y_label = data->y_label;
    plot->equal_scales = data->is_path;
    plot->curves = data->curves;
    if (count == 0) {
        fill_bare_axes(data, plot);
        return;
    }
    data->curves[0] = (TinkerCurve){.x = tinker_graph_data_x(data), .y = tinker_graph_data_y(data), .count = count};
    data->drawn_thin = data->against != NULL && plot->quick;
    if (data->drawn_thin) {
        thin(data);
        data->curves[0] =
            (TinkerCurve){.x = numbers(data->thin_x), .y = numbers(data->thin_y), .count = data->kept->len};
    }
    plot->curve_count = 1;
    add_present(data, plot);
}

/* Texts ---------------------------------------------------------------------------------------------------------------
 */

static char *value_text(const char *name, double value, const char *unit)
{
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(number, sizeof number, "%.5g", value + 0.0);
    const char *gap = unit[0] != '\0' ? " " : "";
    return number[0] == '-' ? g_strdup_printf("%s = −%s%s%s", name, number + 1, gap, unit)
                            : g_strdup_printf("%s = %s%s%s", name, number, gap, unit);
}

char *tinker_graph_data_x_text(const TinkerGraphData *data, gsize point)
{
    g_autofree char *time = value_text("t", g_array_index(data->times, double, point), "s");
    if (data->against == NULL) return g_steal_pointer(&time);
    g_autofree char *x = value_text(data->against, g_array_index(data->x, double, point), data->x_axis.unit);
    return g_strdup_printf("%s, %s", time, x);
}

char *tinker_graph_data_y_text(const TinkerGraphData *data, gsize point)
{
    return value_text(data->quantity, g_array_index(data->y, double, point), data->y_axis.unit);
}

/* CSV -----------------------------------------------------------------------------------------------------------------
 */

static void write_rows(const TinkerGraphData *data, TinkerCsvWriter *writer, gboolean units)
{
    const TinkerScene *scene = tinker_document_scene(data->document);
    const double *x = tinker_graph_data_x(data), *y = tinker_graph_data_y(data);
    tinker_csv_axis(writer, scene, &data->x_axis, FALSE, units);
    tinker_csv_axis(writer, scene, &data->y_axis, FALSE, units);
    tinker_csv_end_row(writer);
    for (gsize i = 0; i < tinker_graph_data_count(data); i++) {
        tinker_csv_number(writer, x[i]);
        tinker_csv_number(writer, y[i]);
        tinker_csv_end_row(writer);
    }
}

gboolean tinker_graph_data_check_output(const TinkerGraphData *data, const char *path, GError **error)
{
    g_autoptr(TinkerFileSet) files = tinker_document_files(data->document);
    return tinker_file_set_add_output(files, NULL, path, error);
}

gboolean tinker_graph_data_write_csv(TinkerGraphData *data, const char *path, int decimals, GError **error)
{
    if (!tinker_graph_data_check_output(data, path, error)) return FALSE;
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    gboolean done = FALSE;
    if (stream != NULL) {
        g_auto(TinkerCsvWriter) writer = tinker_csv_writer_graph(stream, decimals);
        write_rows(data, &writer, decimals < 0);
        done = fclose(stream) == 0 && !writer.failed;
    }
    if (done && !tinker_replace_file(path, text, length, 0666, error)) {
        done = FALSE;
        g_prefix_error(error, "%s: ", path);
    } else if (!done) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_NOMEM, _("there is no memory to write %zu rows"),
                    tinker_graph_data_count(data));
    }
    free(text);
    return done;
}

/* Life ----------------------------------------------------------------------------------------------------------------
 */

TinkerGraphData *tinker_graph_data_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerGraphData *data = g_new0(TinkerGraphData, 1);
    data->document = g_object_ref(document);
    data->player = g_object_ref(player);
    data->generation = tinker_player_generation(player);
    GArray **arrays[] = {&data->times, &data->x, &data->y, &data->thin_x, &data->thin_y};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = g_array_new(FALSE, FALSE, sizeof(double));
    data->kept = g_array_new(FALSE, FALSE, sizeof(guint));
    return data;
}

void tinker_graph_data_free(TinkerGraphData *data)
{
    if (data == NULL) return;
    g_object_unref(data->document);
    g_object_unref(data->player);
    char *texts[] = {data->block, data->quantity, data->against, data->title, data->x_label, data->y_label};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    GArray *arrays[] = {data->times, data->x, data->y, data->thin_x, data->thin_y, data->kept};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_array_unref(arrays[i]);
    g_free(data);
}

/* What a live window pays for a frame: moving the bodies, painting the scene into an image of 1200 by 800 pixels, and
 * graphs beside it. Labels are on, the theme is the light one; one memory serves all frames of a scene, as in a window.
 */
#include <cairo.h>
#include <math.h>
#include <string.h>

#include "build-catalogue.h"
#include "render/picture/painter.h"
#include "render/plot/plot.h"
#include "report.h"
#include "scene-text.h"
#include "scene/read/scene-json.h"
#include "subject.h"

#define WIDTH       1200
#define HEIGHT      800
#define PLOT_WIDTH  480
#define PLOT_HEIGHT 320
#define SWAY        0.15  /* m: how far bodies move, so that connectors are pushed and pulled */
#define FRAME_TIME  0.016 /* s */

typedef struct {
    TinkerCatalogue *catalogue;
    TinkerScene *scene;
    TinkerFrame *frame;
    TinkerView view;
    TinkerPaintOptions options;
    cairo_surface_t *surface;
    cairo_t *cairo;
    GArray *bodies; /* of TinkerBlockId: those that the window moves */
    GArray *places; /* of their x and y in turns, as placed */
    gint64 frames;
} Stage;

static void stage_open(Stage *stage, const char *text)
{
    g_autoptr(GError) error = NULL;
    *stage = (Stage){.catalogue = test_build_catalogue(), .options = tinker_paint_options_default()};
    stage->scene = tinker_scene_read_text(stage->catalogue, text, strlen(text), NULL, NULL, &error);
    if (stage->scene != NULL) stage->frame = tinker_frame_new(stage->scene, &error);
    if (stage->frame == NULL) g_error("%s", error->message);
    stage->options.quick = TRUE;
    stage->options.memory = tinker_paint_memory_new();
    stage->surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, WIDTH, HEIGHT);
    stage->cairo = cairo_create(stage->surface);
    stage->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    stage->places = g_array_new(FALSE, FALSE, sizeof(double));
    for (int32_t place = 0; place < tinker_scene_block_count(stage->scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(stage->scene, place);
        double centre[3];
        const TinkerBlockClass *block_class = tinker_scene_block_class(stage->scene, block);
        if (block_class == NULL) g_error("%s: its plugin is missing", tinker_scene_block_name(stage->scene, block));
        if (block_class->meanings[TINKER_MEANING_MASS] < 0) continue;
        tinker_frame_centre(stage->frame, block, &centre[0], &centre[1], &centre[2]);
        g_array_append_val(stage->bodies, block);
        g_array_append_vals(stage->places, centre, 2);
    }
}

static void stage_close(Stage *stage)
{
    cairo_destroy(stage->cairo);
    cairo_surface_destroy(stage->surface);
    g_array_unref(stage->bodies);
    g_array_unref(stage->places);
    tinker_paint_memory_free(stage->options.memory);
    tinker_frame_free(stage->frame);
    tinker_scene_free(stage->scene);
    tinker_catalogue_free(stage->catalogue);
}

/* Every body goes round a small circle, each a little ahead of the one before. */
static void move_bodies(Stage *stage)
{
    double t = FRAME_TIME * (double)++stage->frames;
    const double *at = (const double *)(const void *)stage->places->data;
    if (!tinker_frame_set_time(stage->frame, t, NULL)) g_error("a motion failed");
    for (guint i = 0; i < stage->bodies->len; i++)
        tinker_frame_place(stage->frame, g_array_index(stage->bodies, TinkerBlockId, i),
                           at[2 * i] + SWAY * cos(3 * t + i), at[2 * i + 1] + SWAY * sin(3 * t + i), 0);
}

/* As BenchmarkWork: a unit is a frame. */
static double work_moving(gint64 frames, void *data)
{
    double started = benchmark_processor_time();
    for (; frames > 0; frames--)
        move_bodies(data);
    return benchmark_processor_time() - started;
}

static double work_painting(gint64 frames, void *data)
{
    Stage *stage = data;
    double seconds = 0;
    for (; frames > 0; frames--) {
        move_bodies(stage);
        double started = benchmark_processor_time();
        tinker_paint_scene(stage->cairo, stage->frame, &stage->view, &stage->options);
        cairo_surface_flush(stage->surface);
        seconds += benchmark_processor_time() - started;
    }
    return seconds;
}

/* The middle of the scene, with so many of its blocks in sight. */
static void set_view(Stage *stage, double visible)
{
    double box[4];
    tinker_painter_bounds(stage->frame, box);
    stage->view = tinker_view_fit(box, WIDTH, HEIGHT, 24);
    double share = visible / tinker_scene_block_count(stage->scene);
    if (share < 1) tinker_view_zoom(&stage->view, sqrt(1 / share), WIDTH / 2, HEIGHT / 2);
}

static double milliseconds(BenchmarkWork first, BenchmarkWork second, void *data, double *of_second)
{
    BenchmarkTask one = {.work = first, .data = data}, other = {.work = second, .data = data};
    benchmark_time_pair(&one, &other);
    *of_second = 1e3 * other.timing.minimum;
    return 1e3 * one.timing.minimum;
}

static void report_scene(BenchmarkReport *report, const char *name, char *text, double goal)
{
    static const double visible[] = {INFINITY, 2000, 500, 20};
    g_autofree char *owned = text;
    if (!benchmark_report_wants(report, name)) return;
    Stage stage;
    stage_open(&stage, owned);
    double moving = NAN;
    benchmark_report_figure(report, name, "blocks", tinker_scene_block_count(stage.scene), "1", NAN);
    for (gsize i = 0; i < G_N_ELEMENTS(visible); i++) {
        if (visible[i] < INFINITY && visible[i] > tinker_scene_block_count(stage.scene) / 2) continue;
        g_autofree char *what = isfinite(visible[i]) ? g_strdup_printf("painted, %.0f blocks in sight", visible[i])
                                                     : g_strdup("painted, fit to view");
        set_view(&stage, visible[i]);
        double painting = milliseconds(work_painting, work_moving, &stage, &moving);
        benchmark_report_figure(report, name, what, painting, "ms", goal);
    }
    benchmark_report_figure(report, name, "bodies moved", moving, "ms", NAN);
    stage_close(&stage);
}

/* Graphs ----------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerCurve curve;
    TinkerPlot plot;
    cairo_t *cairo;
} Graph;

static double work_plotting(gint64 units, void *data)
{
    Graph *graph = data;
    double started = benchmark_processor_time();
    for (; units > 0; units--)
        tinker_plot_draw(graph->cairo, &graph->plot, PLOT_WIDTH, PLOT_HEIGHT);
    return benchmark_processor_time() - started;
}

/* `crowded`: hundreds of swings to a pixel, at rest, where all is drawn as finely as it can be. */
static double report_graph(BenchmarkReport *report, gsize points, gboolean indexed, gboolean crowded, double goal)
{
    g_autofree char *name = g_strdup_printf("graph of %" G_GSIZE_FORMAT " points%s%s", points,
                                            indexed ? ", zoomed" : "", crowded ? ", crowded, at rest" : "");
    const double faster = crowded ? 1000 : 1;
    g_autofree double *t = g_new(double, points), *y = g_new(double, points);
    double ignored, ms;
    if (!benchmark_report_wants(report, name)) return NAN;
    for (gsize i = 0; i < points; i++) {
        t[i] = 10.0 * (double)i / (double)(points - 1);
        y[i] = exp(-0.1 * t[i]) * cos(7 * faster * t[i]) + 0.1 * sin(90 * t[i]);
    }
    static const double part[2] = {2.5, 7.5};
    g_autoptr(TinkerCurveIndex) index = tinker_curve_index_new();
    tinker_curve_index_add(index, t, y, points);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, PLOT_WIDTH, PLOT_HEIGHT);
    Graph graph = {.curve = {.label = "y", .x = t, .y = y, .count = points, .index = indexed ? index : NULL},
                   .cairo = cairo_create(surface)};
    graph.plot = (TinkerPlot){.x_label = "Time [s]",
                              .y_label = "Y Position [m]",
                              .x_range = indexed ? part : NULL,
                              .curves = &graph.curve,
                              .curve_count = 1,
                              .quick = !crowded,
                              .memory = tinker_paint_memory_new()};
    ms = milliseconds(work_plotting, work_plotting, &graph, &ignored);
    benchmark_report_figure(report, name, "drawn", ms, "ms", goal);
    tinker_paint_memory_free(graph.plot.memory);
    cairo_destroy(graph.cairo);
    cairo_surface_destroy(surface);
    return ms;
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    report_scene(report, "lattice of about 200 blocks", benchmark_net(8), 6);
    report_scene(report, "lattice of about 5000 blocks", benchmark_net(41), 25);
    report_scene(report, "pendulums, about 200 blocks", benchmark_pendulums(67), 6);
    report_scene(report, "pendulums, about 5000 blocks", benchmark_pendulums(1667), 25);
    report_graph(report, 1000, FALSE, FALSE, 1);
    report_graph(report, 100000, FALSE, FALSE, 2);
    report_graph(report, 1000000, TRUE, FALSE, 16);
    report_graph(report, 1000000, TRUE, TRUE, 16);
    return benchmark_report_end(report);
}

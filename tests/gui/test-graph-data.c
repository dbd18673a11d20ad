/* What a graph of the window shows and exports: its values against closed forms and the published table of a free fall.
 */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "graph-fixture.h"
#include "gui/curve/graph-edit.h"
#include "gui/curve/graph-reading.h"
#include "render/draw/theme.h"

/* The file that the menu exports, as far as the first ten steps. */
static void test_published_table(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-free-fall.csv", NULL), *text = NULL;
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 51);
    g_assert_true(tinker_graph_data_write_csv(data, path, 5, &error));
    g_assert_true(g_file_get_contents(path, &text, NULL, &error));
    static const char expected[] = "Time,Y Position\n0,0\n0.01,-0.00049\n0.02,-0.00196\n0.03,-0.00441\n0.04,-0.00785\n"
                                   "0.05,-0.01226\n0.06,-0.01766\n0.07,-0.02403\n0.08,-0.03139\n0.09,-0.03973\n"
                                   "0.1,-0.04905\n";
    g_assert_true(g_str_has_prefix(text, expected));
    g_remove(path);
    g_autofree char *exact = NULL;
    g_assert_true(tinker_graph_data_write_csv(data, path, -1, &error));
    g_assert_true(g_file_get_contents(path, &exact, NULL, &error));
    g_assert_true(g_str_has_prefix(exact, "Time,Y Position\n0,0\n0.01,-0.0004905\n"));
    g_remove(path);
    g_assert_false(tinker_graph_data_write_csv(data, "/nowhere/at/all.csv", 5, &error));
    g_assert_error(error, G_FILE_ERROR, G_FILE_ERROR_NOENT);
}

/* Neither the values nor a picture take the place of the scene. */
static void test_scene_stays(void)
{
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-graph-XXXXXX", NULL), *text = NULL;
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_autoptr(GError) error = NULL;
    const int file = g_mkstemp(path);
    g_assert_cmpint(file, >=, 0);
    close(file);
    g_assert_true(tinker_document_save(fixture->document, path, NULL));
    g_assert_false(tinker_graph_data_write_csv(data, path, 5, &error));
    g_assert_nonnull(strstr(error->message, path));
    g_assert_false(tinker_graph_data_check_output(data, path, NULL));
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_autofree char *scene = gui_fixture_text(fixture);
    g_assert_cmpstr(text, ==, scene);
    g_remove(path);
}

/* 50 samples of 0.01 s hold five whole periods of 10 Hz: Hann's window has half of the line on both sides of it. What
 * it is over is one step for undo. */
static void test_spectrum(void)
{
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'curves': [{'expression': '3*sin(2*pi*10*t)'}]}");
    g_autofree char *before = gui_fixture_text(fixture);
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_graph_set_against(fixture->document, 0, "y", &error));
    g_assert_nonnull(strstr(error->message, "only quantities are drawn against a quantity"));
    g_assert_true(tinker_graph_set_against(fixture->document, 0, "frequency", NULL));
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    tinker_graph_data_catch_up(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 26);
    for (gsize i = 0; i < 26; i++) {
        g_assert_cmpfloat_with_epsilon(tinker_graph_data_x(data)[i], 2.0 * (double)i, 1e-9);
        g_assert_cmpfloat_with_epsilon(tinker_graph_data_y(data)[i], i == 5 ? 3 : i == 4 || i == 6 ? 1.5 : 0, 1e-5);
    }
    gsize peak;
    g_assert_true(tinker_graph_data_present(data, 0, &peak));
    g_autofree char *x_text = tinker_graph_data_x_text(data, 0, peak);
    g_assert_cmpstr(x_text, ==, "f = 10 Hz");
    g_assert_cmpstr(tinker_graph_data_title(data), ==, "Spectrum of 3*sin(2*pi*10*t)");
    TinkerPlot plot = {.theme = tinker_theme_find("light")};
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_null(plot.cursor);
    g_assert_cmpstr(plot.x_label, ==, "Frequency [Hz] (window: Hann)");
    g_assert_cmpint(plot.curve_count, ==, 1);
    g_assert_cmpfloat(plot.x_range[0], ==, 0);
    g_assert_cmpfloat_with_epsilon(plot.x_range[1], 24, 1e-9); /* twice 12 Hz, the highest that is not faint */
    tinker_document_undo(fixture->document);
    g_autofree char *undone = gui_fixture_text(fixture);
    g_assert_cmpstr(undone, ==, before);
}

/* Between two samples the graph, a meter and the body on the canvas say the same: what lies straight between them. */
static void test_now_is_where_the_body_is(void)
{
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    const TinkerBlockId mass = gui_fixture_block(fixture, "Mass 0");
    TinkerScene *scene = tinker_document_scene(fixture->document);
    tinker_player_seek(fixture->player, 0.3025);
    tinker_graph_data_catch_up(data);
    const double truth = -GRAVITY / 2 * (0.75 * 0.3 * 0.3 + 0.25 * 0.31 * 0.31);
    double now[2], metered, x, y, orientation;
    g_assert_true(tinker_graph_data_now(data, 0, now));
    g_assert_cmpfloat_with_epsilon(now[0], 0.3025, 1e-12);
    g_assert_cmpfloat_with_epsilon(now[1], truth, 1e-9);
    g_assert_true(tinker_player_value(fixture->player, mass, tinker_scene_find_quantity(scene, mass, "y"), &metered));
    g_assert_cmpfloat_with_epsilon(metered, truth, 1e-9);
    tinker_frame_centre(tinker_player_frame(fixture->player), mass, &x, &y, &orientation);
    g_assert_cmpfloat_with_epsilon(y, truth, 1e-9);
    g_autofree char *text = tinker_graph_data_present_text(data);
    g_assert_cmpstr(text, ==, "t = 0.3025 s, y = −0.44893 m");
}

/* Of y = c - cos(omega t), 20.5 samples a swing. */
static GuiFixture *swing(double c, double omega)
{
    GuiFixture *fixture = gui_fixture_new("");
    g_autofree char *scene = g_strdup_printf(
        "'run': {'duration': %.17g, 'interval': %.17g}, 'blocks': [{'type': 'support', 'name': 'S', 'position': [0, "
        "9]}, {'type': 'mass', 'name': 'M', 'position': [0, %.17g]}, {'type': 'spring', 'name': 'K', 'ends': ['S', "
        "'M'], 'stiffness': %.17g, 'rest_length': %.17g}], 'graphs': [{'block': 'M', 'quantity': 'y'}]",
        4 * G_PI / omega, 2 * G_PI / omega / 20.5, c - 1, omega * omega, 9 - c);
    gui_fixture_start_scene(fixture, scene);
    graph_fixture_run_until(fixture, 4 * G_PI / omega);
    return fixture;
}

/* Zeros of a closed form between sparse samples; also those of a dip between two samples, which are both above 0. */
static void test_reading_of_zeros(void)
{
    static const double heights[] = {0, 0.7, 0.999};
    const double omega = 5;
    for (gsize i = 0; i < G_N_ELEMENTS(heights); i++) {
        g_autoptr(GuiFixture) fixture = swing(heights[i], omega);
        g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
        const TinkerGraphSeries *series = tinker_graph_data_curve(data, 0);
        const double first = acos(heights[i]), zeros[] = {first, 2 * G_PI - first};
        TinkerGraphReading reading = {0};
        double time = 0;
        tinker_graph_data_catch_up(data);
        for (gsize k = 0; k < 2; k++) {
            do {
                g_assert_true(tinker_graph_reading_next(series, time, TRUE, &reading));
                time = reading.at[0];
            } while (reading.kind != TINKER_READING_ZERO);
            g_assert_cmpfloat_with_epsilon(time, zeros[k] / omega, 3e-4);
        }
    }
}

/* Where a ball comes down to 0 and turns back there is no zero beside the minimum, before it or behind it. */
static void test_no_zero_where_a_curve_touches(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(
        fixture, "'run': {'duration': 0.5}, 'blocks': [{'type': 'gravity', 'name': 'G'}, {'type': 'support', 'name': "
                 "'S', 'position': [0, -0.75], 'height': 0.5, 'restitution': 0.8}, {'type': 'mass', 'name': 'M', "
                 "'height': 1, 'position': [0, 0.4]}], 'graphs': [{'block': 'M', 'quantity': 'y'}]");
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    const TinkerGraphSeries *series = tinker_graph_data_curve(data, 0);
    TinkerGraphReading reading = {0};
    tinker_graph_data_catch_up(data);
    g_assert_true(tinker_graph_reading_next(series, 0.05, TRUE, &reading));
    g_assert_cmpint(reading.kind, ==, TINKER_READING_MINIMUM);
    g_assert_cmpfloat_with_epsilon(reading.at[0], sqrt(2 * 0.4 / GRAVITY), 1e-9);
    g_assert_cmpfloat_with_epsilon(reading.at[1], 0, 1e-9);
    g_assert_false(tinker_graph_reading_next(series, reading.at[0], TRUE, &reading) &&
                   reading.kind == TINKER_READING_ZERO);
}

/* Nor where what was thrown up comes to 0 from below, at a sample and between two. */
static void test_no_zero_at_a_top(void)
{
    static const double tops[] = {0.4, 0.437};
    for (gsize i = 0; i < G_N_ELEMENTS(tops); i++) {
        g_autoptr(GuiFixture) fixture = gui_fixture_new("");
        g_autofree char *scene = g_strdup_printf(
            "'run': {'duration': 1, 'interval': 0.1}, 'blocks': [{'type': 'gravity', 'name': 'G'}, {'type': 'mass', "
            "'name': 'M', 'position': [0, %.17g], 'velocity': [0, %.17g]}], 'graphs': [{'block': 'M', 'quantity': "
            "'y'}]",
            -0.5 * GRAVITY * tops[i] * tops[i], GRAVITY * tops[i]);
        gui_fixture_start_scene(fixture, scene);
        graph_fixture_run_until(fixture, 1);
        g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
        const TinkerGraphSeries *series = tinker_graph_data_curve(data, 0);
        TinkerGraphReading reading = {0};
        tinker_graph_data_catch_up(data);
        g_assert_true(tinker_graph_reading_next(series, 0.05, TRUE, &reading));
        g_assert_cmpint(reading.kind, ==, TINKER_READING_MAXIMUM);
        g_assert_cmpfloat_with_epsilon(reading.at[0], tops[i], 1e-6);
        g_assert_false(tinker_graph_reading_next(series, reading.at[0], TRUE, &reading) &&
                       reading.kind == TINKER_READING_ZERO);
    }
}

/* A ball that falls 0.4 m onto a floor turns back there, after sqrt(2 h / g), whatever the samples. */
static void test_reading_of_a_kink(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(
        fixture,
        "'run': {'duration': 0.5}, 'blocks': [{'type': 'gravity', 'name': 'G'}, {'type': 'support', 'name': "
        "'S', 'position': [0, -0.25], 'height': 0.5, 'restitution': 0.8}, {'type': 'mass', 'name': 'M', 'height': 1, "
        "'position': [0, 0.9]}], 'graphs': [{'block': 'M', 'quantity': 'y'}]");
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    TinkerGraphReading reading = {0};
    tinker_graph_data_catch_up(data);
    g_assert_true(tinker_graph_reading_next(tinker_graph_data_curve(data, 0), 0.05, TRUE, &reading));
    g_assert_cmpint(reading.kind, ==, TINKER_READING_MINIMUM);
    g_assert_cmpfloat_with_epsilon(reading.at[0], sqrt(2 * 0.4 / GRAVITY), 1e-9);
    g_assert_cmpfloat_with_epsilon(reading.at[1], 0.5, 1e-9);
    double now[2]; /* the straight line between the samples about it lies some millimetres above */
    graph_fixture_run_until(fixture, reading.at[0]);
    tinker_graph_data_catch_up(data);
    g_assert_true(tinker_graph_data_now(data, 0, now));
    g_assert_cmpfloat_with_epsilon(now[0], reading.at[0], 1e-9);
    g_assert_cmpfloat_with_epsilon(now[1], 0.5, 1e-9);
}

/* v^2 = -2 g y all along the fall, whatever the time. */
static void test_phase_plot(void)
{
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'vy', 'against': 'y'}");
    graph_fixture_run_until(fixture, 0.3);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    const double *y = tinker_graph_data_x(data), *v = tinker_graph_data_y(data);
    gsize count = tinker_graph_data_count(data), present;
    g_assert_cmpuint(count, >=, 31);
    for (gsize i = 0; i < count; i++)
        g_assert_cmpfloat_with_epsilon(v[i] * v[i], -2 * GRAVITY * y[i], 1e-9);
    g_assert_true(tinker_graph_data_present(data, 0, &present));
    g_assert_cmpfloat_with_epsilon(v[present], -GRAVITY * 0.3, 1e-9);
    g_assert_cmpstr(tinker_graph_data_title(data), ==, "Mass 0: Y Velocity over Y Position");
    g_autofree char *x_text = tinker_graph_data_x_text(data, 0, 10);
    g_assert_cmpstr(x_text, ==, "t = 0.1 s, y = −0.04905 m");
    TinkerPlot plot = {.theme = tinker_theme_find("light")};
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_null(plot.cursor);
    g_assert_cmpint(plot.curve_count, ==, 2);
    g_assert_cmpint(plot.curves[1].role, ==, TINKER_CURVE_RING);
    g_assert_cmpfloat_with_epsilon(plot.curves[1].x[0], -0.5 * GRAVITY * 0.09, 1e-9);
}

/* 1 ft = 0.3048 m by definition. Changing the units converts what is recorded. */
static void test_english_units(void)
{
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    gsize count = tinker_graph_data_count(data);
    g_assert_cmpfloat_with_epsilon(tinker_graph_data_y(data)[50], -0.5 * GRAVITY * 0.25, 1e-12);
    TinkerPlot plot = {0};
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpstr(plot.x_label, ==, "Time [s]");
    g_assert_cmpstr(plot.y_label, ==, "Y Position [m]");
    g_assert_cmpfloat(*plot.cursor, ==, 0.5);

    TinkerScene *scene = tinker_document_scene(fixture->document);
    TinkerSceneHead head = *tinker_scene_head(scene);
    head.units = TINKER_UNIT_SYSTEM_ENGLISH;
    tinker_document_begin(fixture->document, "Units", NULL);
    tinker_history_set_head(tinker_document_history(fixture->document), &head, NULL);
    tinker_document_end(fixture->document);
    tinker_graph_data_set_graph(data, g_ptr_array_index(tinker_scene_graphs(scene), 0));
    tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, count);
    g_assert_cmpfloat_with_epsilon(tinker_graph_data_y(data)[50], -0.5 * GRAVITY * 0.25 / 0.3048, 1e-12);
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpstr(plot.y_label, ==, "Y Position [ft]");
}

/* Scales and ranges are the scene's, in the units that it displays. */
static void test_scales(void)
{
    g_autoptr(GuiFixture) fixture =
        graph_fixture_fall("English", "{'block': 'Mass 0', 'quantity': 'y', 'scale': ['log', 'linear'], "
                                      "'range': [[0.1, 0.4], [-3.048, 0]]}");
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    TinkerPlot plot = {0};
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_true(plot.x_logarithmic && !plot.y_logarithmic);
    g_assert_cmpfloat(plot.x_range[1], ==, 0.4);
    g_assert_cmpfloat_with_epsilon(plot.y_range[0], -10, 1e-12);
}

/* Before a run there are axes and no point; a reset forgets what was recorded; another run fills it anew. */
static void test_generations(void)
{
    gsize point;
    TinkerPlot plot = {0};
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 0);
    g_assert_false(tinker_graph_data_present(data, 0, &point));
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpfloat(plot.x_range[1], ==, 0.5);
    g_assert_cmpint(plot.curve_count, ==, 1);

    guint64 before = tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_update(data), ==, before);
    graph_fixture_run_until(fixture, 0.5);
    guint64 filled = tinker_graph_data_update(data);
    g_assert_cmpuint(filled, !=, before);
    g_assert_cmpuint(tinker_graph_data_update(data), ==, filled);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 51);
    tinker_player_seek(fixture->player, 0.2);
    g_assert_cmpuint(tinker_graph_data_update(data), !=, filled);

    /* Who goes back to the start sees what was; an edit, which makes it another motion, takes it away. */
    tinker_player_reset(fixture->player);
    tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 51);
    TinkerScene *scene = tinker_document_scene(fixture->document);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, gui_fixture_block(fixture, "Mass 0"));
    int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    tinker_document_begin(fixture->document, "Move", NULL);
    tinker_history_set(tinker_document_history(fixture->document), gui_fixture_block(fixture, "Mass 0"), position,
                       (double[]){0, 2}, NULL);
    tinker_document_end(fixture->document);
    tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 0);
    graph_fixture_run_until(fixture, 0.5);
    tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 51);
    g_assert_cmpfloat_with_epsilon(tinker_graph_data_y(data)[50], 2 - 0.5 * GRAVITY * 0.25, 1e-12);
}

static void add_tests(void)
{
    g_test_add_func("/gui/graph-data/now", test_now_is_where_the_body_is);
    g_test_add_func("/gui/graph-data/kink", test_reading_of_a_kink);
    g_test_add_func("/gui/graph-data/zeros", test_reading_of_zeros);
    g_test_add_func("/gui/graph-data/touch", test_no_zero_where_a_curve_touches);
    g_test_add_func("/gui/graph-data/top", test_no_zero_at_a_top);
    g_test_add_func("/gui/graph-data/published-table", test_published_table);
    g_test_add_func("/gui/graph-data/scene-stays", test_scene_stays);
    g_test_add_func("/gui/graph-data/phase-plot", test_phase_plot);
    g_test_add_func("/gui/graph-data/spectrum", test_spectrum);
    g_test_add_func("/gui/graph-data/english-units", test_english_units);
    g_test_add_func("/gui/graph-data/scales", test_scales);
    g_test_add_func("/gui/graph-data/generations", test_generations);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

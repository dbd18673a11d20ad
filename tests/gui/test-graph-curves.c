/* Several curves in one graph: of several quantities, of runs that are kept, and of all energies. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "graph-fixture.h"
#include "gui/curve/energy-data.h"

/* Two quantities, a whole energy and a table in one graph: a fall from rest has y = -g t^2 / 2, vy = -g t, and the sum
 * of its energies stays 0. The table's rows are its own. */
/* What is drawn of them: two axes, a table as marks, units where one axis has several. */
static void assert_drawn(TinkerGraphData *data)
{
    TinkerPlot plot = {0};
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpint(plot.curve_count, ==, 5);
    g_assert_true(plot.curves[1].right && !plot.curves[0].right);
    g_assert_true(plot.curves[4].no_line && plot.curves[4].markers);
    g_assert_cmpstr(plot.right_label, ==, "speed [m/s]");
    g_assert_cmpstr(plot.y_label, ==, "units as in the legend");
    g_assert_cmpstr(plot.curves[2].label, ==, "sum [J]");
}

/* At 0, 0.1, 0.2 s the fall is at 0, -0.04905, -0.1962 m, and the rows are off by 0, -0.00095, -0.0038; nothing else is
 * in m on the left. */
static void assert_fit(TinkerGraphData *data)
{
    g_autofree char *statistics = tinker_graph_statistics_text(data, NULL);
    const char *fit = strstr(statistics, "Root mean square of the differences from “measured.csv, 1”, 3 values = ");
    g_assert_nonnull(fit);
    g_assert_cmpfloat_with_epsilon(g_ascii_strtod(strstr(fit, "= ") + 2, NULL),
                                   sqrt((0.00095 * 0.00095 + 0.0038 * 0.0038) / 3), 1e-9);
    g_assert_null(strstr(strstr(fit, "= "), "differences from"));
}

static void test_several_curves(void)
{
    static const char graph[] =
        "{'curves': [{'block': 'Mass 0', 'quantity': 'y'}, {'block': 'Mass 0', 'quantity': 'vy', 'axis': 2, 'title': "
        "'speed'}, {'expression': '0.5*{Mass 0.mass}*{Mass 0.vy}^2 + 9.81*{Mass 0.mass}*{Mass 0.y}', 'unit': 'J', "
        "'title': 'sum'}, {'expression': '2*t'}, {'table': 'measured.csv', 'column': 1, 'unit': 'm'}]}";
    g_autofree char *folder = g_dir_make_tmp("tinker-graph-XXXXXX", NULL);
    g_autofree char *path = g_build_filename(folder, "scene.tinker.json", NULL);
    g_autofree char *table = g_build_filename(folder, "measured.csv", NULL);
    g_autofree char *csv = g_build_filename(folder, "out.csv", NULL), *text = NULL;
    g_autoptr(GError) error = NULL;
    g_assert_true(g_file_set_contents(table, "0,0\n0.1,-0.05\n0.2,-0.2\n", -1, NULL));
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_assert_true(tinker_document_save(fixture->document, path, &error));
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_autofree char *graphs = g_strdelimit(g_strdup(graph), "'", '"');
    char **parts = g_regex_split_simple("\"graphs\": *\\[.*\\]", text, G_REGEX_DOTALL, 0);
    g_assert_cmpuint(g_strv_length(parts), ==, 2);
    g_autofree char *whole = g_strconcat(parts[0], "\"graphs\": [", graphs, "]", parts[1], NULL);
    g_strfreev(parts);
    g_clear_pointer(&text, g_free);
    g_assert_true(g_file_set_contents(path, whole, -1, NULL));
    g_assert_true(tinker_document_open(fixture->document, path, NULL, &error));
    g_assert_no_error(error);
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_assert_cmpuint(tinker_graph_data_curves(data), ==, 5);
    for (guint k = 0; k < 4; k++)
        g_assert_cmpuint(tinker_graph_series_count(tinker_graph_data_curve(data, k)), ==, 51);
    for (gsize i = 0; i < 51; i++) {
        const double t = tinker_graph_data_x(data)[i];
        const double expected[] = {-0.5 * GRAVITY * t * t, -GRAVITY * t, 0, 2 * t};
        for (guint k = 0; k < G_N_ELEMENTS(expected); k++)
            g_assert_cmpfloat_with_epsilon(tinker_graph_series_y(tinker_graph_data_curve(data, k))[i], expected[k],
                                           1e-9);
    }
    const TinkerGraphSeries *measured = tinker_graph_data_curve(data, 4);
    g_assert_cmpuint(tinker_graph_series_count(measured), ==, 3);
    g_assert_cmpfloat(tinker_graph_series_y(measured)[2], ==, -0.2);
    g_assert_cmpstr(tinker_graph_data_name(data, 0), ==, "Mass 0: Y Position");

    assert_drawn(data);
    assert_fit(data);

    /* the columns that the command line writes of such a graph */
    g_assert_true(tinker_graph_data_write_csv(data, csv, 5, &error));
    g_assert_true(g_file_get_contents(csv, &text, NULL, NULL));
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    g_assert_cmpstr(lines[0], ==, "Time,Mass 0 Y Position,Mass 0 speed,sum,2*t,Time,\"measured.csv, 1\"");
    g_assert_cmpstr(lines[3], ==, "0.02,-0.00196,-0.1962,0,0.04,0.2,-0.2");
    g_assert_cmpstr(lines[4], ==, "0.03,-0.00441,-0.2943,0,0.06,,");
    const char *files[] = {path, table, csv, folder};
    for (gsize i = 0; i < G_N_ELEMENTS(files); i++)
        g_remove(files[i]);
}

static void set_velocity(GuiFixture *fixture, double upwards)
{
    gui_fixture_set(fixture, "Mass 0", "velocity", 0, upwards);
}

/* One quantity of several blocks: the axis tells it, the legend the blocks alone; a table has to tell both. */
static void test_one_quantity_of_several_blocks(void)
{
    static const char members[] =
        "'run': {'duration': 0.5, 'interval': 0.01}, 'blocks': [{'type': 'gravity', 'name': 'Gravity'}, {'type': "
        "'mass', 'name': 'Ball', 'position': [0, 0]}, {'type': 'mass', 'name': 'Stone', 'position': [3, 1]}], "
        "'graphs': [{'curves': [{'block': 'Ball', 'quantity': 'y'}, {'block': 'Stone', 'quantity': 'y'}]}]";
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-several.csv", NULL), *text = NULL;
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(fixture, members);
    graph_fixture_run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    TinkerPlot plot = {0};
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpstr(tinker_graph_data_title(data), ==, "Y Position: Ball, Stone");
    g_assert_cmpstr(plot.y_label, ==, "Y Position [m]");
    g_assert_cmpstr(plot.curves[0].label, ==, "Ball");
    g_assert_cmpstr(plot.curves[1].label, ==, "Stone");
    g_assert_cmpstr(tinker_graph_data_name(data, 1), ==, "Stone: Y Position");
    g_assert_true(tinker_graph_data_write_csv(data, path, 5, NULL));
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_assert_true(g_str_has_prefix(text, "Time,Ball Y Position,Stone Y Position\n"));
    g_remove(path);
    g_assert_true(tinker_player_keep(fixture->player));
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpstr(plot.curves[2].label, ==, "Ball (Run 1)");
}

/* The only run that is kept is called by what was changed since, in a table as in the legend. */
static void test_first_kept_run(void)
{
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-first.csv", NULL), *text = NULL;
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    graph_fixture_run_until(fixture, 0.5);
    g_assert_true(tinker_player_keep(fixture->player));
    gui_fixture_set(fixture, "Mass 0", "velocity", 0, 1);
    graph_fixture_run_until(fixture, 0.5);
    tinker_graph_data_set_graph(data,
                                g_ptr_array_index(tinker_scene_graphs(tinker_document_scene(fixture->document)), 0));
    tinker_graph_data_catch_up(data);
    g_assert_true(tinker_graph_data_write_csv(data, path, 5, NULL));
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_assert_true(g_str_has_prefix(text, "Time,Y Position,Time,Mass 0.y (Mass 0: Vy 0 m/s)\n"));
    g_remove(path);
    TinkerKeptRuns *kept = tinker_player_kept(fixture->player);
    tinker_kept_runs_rename(kept, 0, "  ");
    g_assert_cmpstr(tinker_graph_data_run(data, 1), ==, "Mass 0: Vy 0 m/s");
}

/* Runs that are kept stay beside the next ones, with what was changed for a name: y = v t - g t^2 / 2 of each v. */
static void test_kept_runs(void)
{
    static const double velocities[] = {0, 1, 2};
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-kept.csv", NULL), *text = NULL;
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    TinkerKeptRuns *kept = tinker_player_kept(fixture->player);
    g_assert_false(tinker_player_keep(fixture->player)); /* there is none yet */
    for (gsize k = 0; k < G_N_ELEMENTS(velocities); k++) {
        if (k > 0) {
            g_assert_true(tinker_player_keep(fixture->player));
            set_velocity(fixture, velocities[k]);
        }
        graph_fixture_run_until(fixture, 0.5);
    }
    tinker_graph_data_catch_up(data);
    g_assert_cmpuint(tinker_graph_data_own_curves(data), ==, 1);
    g_assert_cmpuint(tinker_graph_data_curves(data), ==, 3);
    static const int order[] = {2, 0, 1}; /* the present one, then the kept ones */
    for (guint curve = 0; curve < 3; curve++) {
        const TinkerGraphSeries *series = tinker_graph_data_curve(data, curve);
        g_assert_cmpuint(tinker_graph_series_count(series), ==, 51);
        const double v = velocities[order[curve]];
        g_assert_cmpfloat_with_epsilon(tinker_graph_series_y(series)[50], 0.5 * v - 0.5 * GRAVITY * 0.25, 1e-9);
    }
    TinkerPlot plot = {0};
    set_velocity(fixture, 2); /* nothing, but the graph looks again */
    tinker_graph_data_set_graph(data,
                                g_ptr_array_index(tinker_scene_graphs(tinker_document_scene(fixture->document)), 0));
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpstr(plot.curves[0].label, ==, "Mass 0: Vy 2 m/s, now");
    g_assert_cmpstr(plot.curves[1].label, ==, "Mass 0: Vy 0 m/s");
    g_assert_cmpstr(plot.curves[2].label, ==, "Mass 0: Vy 1 m/s");
    g_assert_cmpint(plot.curves[1].colour, !=, plot.curves[2].colour);
    const int colour = plot.curves[2].colour;

    /* the ghost of the motion is where its curve is */
    TinkerFrame *frame = tinker_kept_run_frame(tinker_kept_runs_at(kept, 1), 0.25);
    double x, y, angle;
    tinker_frame_centre(frame, gui_fixture_block(fixture, "Mass 0"), &x, &y, &angle);
    g_assert_cmpfloat_with_epsilon(y, 0.25 - 0.5 * GRAVITY * 0.0625, 1e-9);

    tinker_kept_runs_rename(kept, 1, "thrown");
    g_assert_true(tinker_graph_data_write_csv(data, path, 5, NULL));
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_assert_true(g_str_has_prefix(text, "Time,Y Position,Time,Mass 0.y (Mass 0: Vy 0 m/s),Time,Mass 0.y (thrown)\n"));
    g_remove(path);

    tinker_kept_runs_show(kept, 0, FALSE);
    g_assert_null(tinker_kept_run_frame(tinker_kept_runs_at(kept, 0), 0.25));
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpint(plot.curve_count, ==, 2);
    g_assert_cmpint(plot.curves[1].colour, ==, colour);
    tinker_kept_runs_remove(kept, 1);
    g_assert_cmpuint(tinker_graph_data_curves(data), ==, 1);
    for (int i = 0; i < TINKER_MOST_KEPT - 1; i++)
        g_assert_true(tinker_player_keep(fixture->player));
    g_assert_false(tinker_player_keep(fixture->player));
}

static void assert_kept_name(TinkerKeptRuns *kept, guint place, const char *name)
{
    g_assert_cmpstr(tinker_kept_runs_at(kept, place)->name, ==, name);
}

/* No two runs have one name, though a change is taken back and made again, or one is called as another. */
static void test_names_of_kept_runs(void)
{
    static const double velocities[] = {0, 1, 0, 1};
    static const char *const names[] = {"Mass 0: Vy 0 m/s", "Mass 0: Vy 1 m/s", "Mass 0: Vy 0 m/s (2)",
                                        "Mass 0: Vy 1 m/s (2)"};
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    TinkerKeptRuns *kept = tinker_player_kept(fixture->player);
    for (gsize k = 0; k < G_N_ELEMENTS(velocities); k++) {
        set_velocity(fixture, velocities[k]);
        graph_fixture_run_until(fixture, 0.5);
        g_assert_true(tinker_player_keep(fixture->player));
    }
    for (guint i = 0; i < G_N_ELEMENTS(names); i++)
        assert_kept_name(kept, i, names[i]);
    tinker_kept_runs_rename(kept, 2, "thrown");
    tinker_kept_runs_rename(kept, 1, "thrown");
    assert_kept_name(kept, 1, "thrown (2)");
    tinker_kept_runs_rename(kept, 2, "fallen");
    tinker_kept_runs_rename(kept, 1, "thrown");
    assert_kept_name(kept, 1, "thrown");
}

/* Every layer is an area in its own colour of the theme (which test-theme holds apart from the others, for all eyes),
 * and not in a shade that is mixed with the ground. */
static void assert_areas(TinkerEnergyData *data, const TinkerTheme *theme, const gboolean has[TINKER_ENERGY_LAYERS])
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 600, 400);
    cairo_t *cairo = cairo_create(surface);
    TinkerPlot plot = {.theme = theme};
    tinker_energy_data_fill_plot(data, &plot);
    tinker_plot_draw(cairo, &plot, 600, 400);
    cairo_surface_flush(surface);
    const guint32 *pixels = (const guint32 *)(gconstpointer)cairo_image_surface_get_data(surface);
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++) {
        const double *c = theme->curves[k];
        const guint32 wanted =
            (guint32)lround(255 * c[0]) << 16 | (guint32)lround(255 * c[1]) << 8 | (guint32)lround(255 * c[2]);
        int area = 0;
        for (gsize i = 0; i < (gsize)600 * 400; i++)
            area += (pixels[i] & 0xffffff) == wanted;
        g_test_message("%s, %d: %d pixels", theme->id, k, area);
        if (has[k])
            g_assert_cmpint(area, >, 4000);
        else
            g_assert_cmpint(area, ==, 0);
    }
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
}

/* A fall: what is kinetic was potential, from the lowest place on; an oscillator with a damper: all that was taken is
 * there, and nothing is given. */
static void test_energy(void)
{
    double layers[TINKER_ENERGY_LAYERS], sum, all = 0;
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "");
    g_autoptr(TinkerEnergyData) data = tinker_energy_data_new(fixture->document, fixture->player);
    tinker_energy_data_update(data);
    g_assert_false(tinker_energy_data_now(data, layers, &sum));
    graph_fixture_run_until(fixture, 0.5);
    tinker_player_seek(fixture->player, 0.3);
    tinker_energy_data_update(data);
    g_assert_cmpuint(tinker_energy_data_count(data), ==, 51);
    g_assert_true(tinker_energy_data_now(data, layers, &sum));
    const double square = GRAVITY * GRAVITY;
    g_assert_cmpfloat_with_epsilon(layers[TINKER_ENERGY_KINETIC], 0.5 * square * 0.09, 1e-9);
    g_assert_cmpfloat_with_epsilon(layers[TINKER_ENERGY_POTENTIAL], 0.5 * square * (0.25 - 0.09), 1e-9);
    g_assert_cmpfloat_with_epsilon(sum, 0.5 * square * 0.25, 1e-9);
    TinkerPlot plot = {0};
    tinker_energy_data_fill_plot(data, &plot);
    g_assert_cmpint(plot.curve_count, ==, 3); /* nothing is stored, nor taken */
    for (gsize i = 0; i < 51; i++)            /* the layers reach up to the line */
        g_assert_cmpfloat_with_epsilon(plot.curves[1].high[i], plot.curves[2].y[i], 1e-9);

    g_autoptr(GuiFixture) damped = gui_fixture_new("");
    gui_fixture_start_scene(damped,
                            "'run': {'duration': 2, 'interval': 0.01}, 'blocks': [{'type': 'support', 'name': 'Wall', "
                            "'position': [0, 0]}, {'type': 'mass', 'name': 'Mass 0', 'position': [0, -2], 'mass': 1, "
                            "'velocity': [0, 1]}, {'type': 'spring', 'name': 'Spring 0', 'stiffness': 25, 'ends': "
                            "['Wall', 'Mass 0']}, {'type': 'damper', 'name': 'Damper 0', 'damping': 1, 'ends': "
                            "['Wall', 'Mass 0']}]");
    g_autoptr(TinkerEnergyData) books = tinker_energy_data_new(damped->document, damped->player);
    graph_fixture_run_until(damped, 2);
    tinker_energy_data_update(books);
    g_assert_true(tinker_energy_data_now(books, layers, &sum));
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++)
        all += layers[k];
    g_assert_cmpfloat_with_epsilon(sum, 0.5, 1e-7); /* m v^2 / 2 at the start */
    g_assert_cmpfloat_with_epsilon(all, sum, 1e-7);
    /* what is left falls as exp(-c t / m), within a factor that the phase makes of it */
    g_assert_cmpfloat(layers[TINKER_ENERGY_DAMPERS], >, 0.5 * (1 - 1.3 * exp(-2)));
    g_assert_cmpfloat(layers[TINKER_ENERGY_DAMPERS], <, 0.5 * (1 - 0.7 * exp(-2)));
    static const gboolean has[TINKER_ENERGY_LAYERS] = {TRUE, FALSE, TRUE, TRUE, FALSE, FALSE};
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++)
        g_assert_cmpint(tinker_energy_data_has(books, (TinkerEnergyLayer)k), ==, has[k]);
    for (const char *const *id = tinker_theme_ids(); *id != NULL; id++)
        assert_areas(books, tinker_theme_find(*id), has);
}

static void add_tests(void)
{
    g_test_add_func("/gui/graph-data/several-curves", test_several_curves);
    g_test_add_func("/gui/graph-data/one-quantity-of-several-blocks", test_one_quantity_of_several_blocks);
    g_test_add_func("/gui/graph-data/first-kept-run", test_first_kept_run);
    g_test_add_func("/gui/graph-data/kept-runs", test_kept_runs);
    g_test_add_func("/gui/graph-data/names-of-kept-runs", test_names_of_kept_runs);
    g_test_add_func("/gui/graph-data/energy", test_energy);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

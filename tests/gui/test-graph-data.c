/* Graphs of the window: their values against closed forms and the published table of a free fall, and that every edit
 * of them is one step that can be taken back. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "gui-fixture.h"
#include "gui/curve/energy-data.h"
#include "gui/curve/graph-data.h"
#include "gui/document/graph-edit.h"
#include "render/draw/theme.h"

#define GRAVITY 9.81

/* A mass falls from rest at the origin. (transfer full) */
static GuiFixture *fall(const char *units, const char *graphs)
{
    GuiFixture *fixture = gui_fixture_new("");
    g_autofree char *members = g_strdup_printf("'units': '%s', 'run': {'duration': 0.5, 'interval': 0.01}, 'blocks': "
                                               "[{'type': 'gravity', 'name': 'Gravity'}, {'type': 'mass', 'name': "
                                               "'Mass 0', 'mass': 1, 'position': [0, 0]}], 'graphs': [%s]",
                                               units, graphs);
    gui_fixture_start_scene(fixture, members);
    return fixture;
}

static void run_until(GuiFixture *fixture, double time)
{
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_player_play(fixture->player, &culprit, &error));
    g_assert_no_error(error);
    g_assert_true(tinker_player_wait(fixture->player, time, &error));
    g_assert_no_error(error);
    tinker_player_pause(fixture->player);
    tinker_player_seek(fixture->player, time);
}

/* Data of the scene's first graph. (transfer full) */
static TinkerGraphData *data_of(GuiFixture *fixture)
{
    TinkerGraphData *data = tinker_graph_data_new(fixture->document, fixture->player);
    tinker_graph_data_set_graph(data,
                                g_ptr_array_index(tinker_scene_graphs(tinker_document_scene(fixture->document)), 0));
    tinker_graph_data_update(data);
    return data;
}

static char *text_of(GuiFixture *fixture)
{
    return tinker_scene_to_text(tinker_document_scene(fixture->document), TINKER_WRITE_SI);
}

/* The file that the menu exports, as far as the first ten steps. */
static void test_published_table(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-free-fall.csv", NULL), *text = NULL;
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = data_of(fixture);
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
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_autoptr(TinkerGraphData) data = data_of(fixture);
    g_autoptr(GError) error = NULL;
    const int file = g_mkstemp(path);
    g_assert_cmpint(file, >=, 0);
    close(file);
    g_assert_true(tinker_document_save(fixture->document, path, NULL));
    g_assert_false(tinker_graph_data_write_csv(data, path, 5, &error));
    g_assert_nonnull(strstr(error->message, path));
    g_assert_false(tinker_graph_data_check_output(data, path, NULL));
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_autofree char *scene = text_of(fixture);
    g_assert_cmpstr(text, ==, scene);
    g_remove(path);
}

/* v^2 = -2 g y all along the fall, whatever the time. */
static void test_phase_plot(void)
{
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'vy', 'against': 'y'}");
    run_until(fixture, 0.3);
    g_autoptr(TinkerGraphData) data = data_of(fixture);
    const double *y = tinker_graph_data_x(data), *v = tinker_graph_data_y(data);
    gsize count = tinker_graph_data_count(data), present;
    g_assert_cmpuint(count, >=, 31);
    for (gsize i = 0; i < count; i++)
        g_assert_cmpfloat_with_epsilon(v[i] * v[i], -2 * GRAVITY * y[i], 1e-9);
    g_assert_true(tinker_graph_data_present(data, 0, &present));
    g_assert_cmpfloat_with_epsilon(v[present], -GRAVITY * 0.3, 1e-9);
    g_assert_cmpstr(tinker_graph_data_title(data), ==, "Mass 0: Y Velocity over Y Position");
    g_autofree char *x_text = tinker_graph_data_x_text(data, 0, 10), *y_text = tinker_graph_data_y_text(data, 0, 10);
    g_assert_cmpstr(x_text, ==, "t = 0.1 s, y = −0.04905 m");
    g_assert_cmpstr(y_text, ==, "vy = −0.981 m/s");
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
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = data_of(fixture);
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

/* Two quantities, a whole energy and a table in one graph: a fall from rest has y = -g t^2 / 2, vy = -g t, and the sum
 * of its energies stays 0. The table's rows are its own. */
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
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
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
    run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = data_of(fixture);
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

    TinkerPlot plot = {0};
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpint(plot.curve_count, ==, 5);
    g_assert_true(plot.curves[1].right && !plot.curves[0].right);
    g_assert_true(plot.curves[4].no_line && plot.curves[4].markers);
    g_assert_cmpstr(plot.right_label, ==, "speed [m/s]");
    g_assert_cmpstr(plot.y_label, ==, "units as in the legend");
    g_assert_cmpstr(plot.curves[2].label, ==, "sum [J]");

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

/* Runs that are kept stay beside the next ones, with what was changed for a name: y = v t - g t^2 / 2 of each v. */
static void test_kept_runs(void)
{
    static const double velocities[] = {0, 1, 2};
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-kept.csv", NULL), *text = NULL;
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_autoptr(TinkerGraphData) data = data_of(fixture);
    TinkerKeptRuns *kept = tinker_player_kept(fixture->player);
    g_assert_false(tinker_player_keep(fixture->player)); /* there is none yet */
    for (gsize k = 0; k < G_N_ELEMENTS(velocities); k++) {
        if (k > 0) {
            g_assert_true(tinker_player_keep(fixture->player));
            set_velocity(fixture, velocities[k]);
        }
        run_until(fixture, 0.5);
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
    g_assert_cmpstr(plot.curves[0].label, ==, "Mass 0: Vy 1 → 2 m/s");
    g_assert_cmpstr(plot.curves[1].label, ==, "Run 1");
    g_assert_cmpstr(plot.curves[2].label, ==, "Mass 0: Vy 0 → 1 m/s");
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
    g_assert_true(g_str_has_prefix(text, "Time,Y Position,Time,Mass 0.y (Run 1),Time,Mass 0.y (thrown)\n"));
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

/* A fall: what is kinetic was potential, from the lowest place on; an oscillator with a damper: all that was taken is
 * there, and nothing is given. */
static void test_energy(void)
{
    double layers[TINKER_ENERGY_LAYERS], sum, all = 0;
    g_autoptr(GuiFixture) fixture = fall("SI", "");
    g_autoptr(TinkerEnergyData) data = tinker_energy_data_new(fixture->document, fixture->player);
    tinker_energy_data_update(data);
    g_assert_false(tinker_energy_data_now(data, layers, &sum));
    run_until(fixture, 0.5);
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
    g_assert_cmpint(plot.curve_count, ==, TINKER_ENERGY_LAYERS + 1);
    for (gsize i = 0; i < 51; i++) /* the layers reach up to the line */
        g_assert_cmpfloat_with_epsilon(plot.curves[TINKER_ENERGY_LAYERS - 1].high[i],
                                       plot.curves[TINKER_ENERGY_LAYERS].y[i], 1e-9);

    g_autoptr(GuiFixture) damped = gui_fixture_new("");
    gui_fixture_start_scene(damped,
                            "'run': {'duration': 2, 'interval': 0.01}, 'blocks': [{'type': 'support', 'name': 'Wall', "
                            "'position': [0, 0]}, {'type': 'mass', 'name': 'Mass 0', 'position': [0, -2], 'mass': 1, "
                            "'velocity': [0, 1]}, {'type': 'spring', 'name': 'Spring 0', 'stiffness': 25, 'ends': "
                            "['Wall', 'Mass 0']}, {'type': 'damper', 'name': 'Damper 0', 'damping': 1, 'ends': "
                            "['Wall', 'Mass 0']}]");
    g_autoptr(TinkerEnergyData) books = tinker_energy_data_new(damped->document, damped->player);
    run_until(damped, 2);
    tinker_energy_data_update(books);
    g_assert_true(tinker_energy_data_now(books, layers, &sum));
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++)
        all += layers[k];
    g_assert_cmpfloat_with_epsilon(sum, 0.5, 1e-7); /* m v^2 / 2 at the start */
    g_assert_cmpfloat_with_epsilon(all, sum, 1e-7);
    /* what is left falls as exp(-c t / m), within a factor that the phase makes of it */
    g_assert_cmpfloat(layers[TINKER_ENERGY_DAMPERS], >, 0.5 * (1 - 1.3 * exp(-2)));
    g_assert_cmpfloat(layers[TINKER_ENERGY_DAMPERS], <, 0.5 * (1 - 0.7 * exp(-2)));
}

/* Scales and ranges are the scene's, in the units that it displays. */
static void test_scales(void)
{
    g_autoptr(GuiFixture) fixture = fall("English", "{'block': 'Mass 0', 'quantity': 'y', 'scale': ['log', 'linear'], "
                                                    "'range': [[0.1, 0.4], [-3.048, 0]]}");
    run_until(fixture, 0.5);
    g_autoptr(TinkerGraphData) data = data_of(fixture);
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
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'y'}");
    g_autoptr(TinkerGraphData) data = data_of(fixture);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 0);
    g_assert_false(tinker_graph_data_present(data, 0, &point));
    tinker_graph_data_fill_plot(data, &plot);
    g_assert_cmpfloat(plot.x_range[1], ==, 0.5);
    g_assert_cmpint(plot.curve_count, ==, 1);

    guint64 before = tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_update(data), ==, before);
    run_until(fixture, 0.5);
    guint64 filled = tinker_graph_data_update(data);
    g_assert_cmpuint(filled, !=, before);
    g_assert_cmpuint(tinker_graph_data_update(data), ==, filled);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 51);
    tinker_player_seek(fixture->player, 0.2);
    g_assert_cmpuint(tinker_graph_data_update(data), !=, filled);

    tinker_player_reset(fixture->player);
    tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 0);
    TinkerScene *scene = tinker_document_scene(fixture->document);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, gui_fixture_block(fixture, "Mass 0"));
    int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    tinker_document_begin(fixture->document, "Move", NULL);
    tinker_history_set(tinker_document_history(fixture->document), gui_fixture_block(fixture, "Mass 0"), position,
                       (double[]){0, 2}, NULL);
    tinker_document_end(fixture->document);
    run_until(fixture, 0.5);
    tinker_graph_data_update(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, 51);
    g_assert_cmpfloat_with_epsilon(tinker_graph_data_y(data)[50], 2 - 0.5 * GRAVITY * 0.25, 1e-12);
}

/* Every edit is one step: as many undos lead back through the same texts, as many redos forward again. */
static void test_edits_are_steps(void)
{
    g_autoptr(GPtrArray) texts = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GuiFixture) fixture = fall("SI", "{'block': 'Mass 0', 'quantity': 'y', 'pen': 3}");
    TinkerBlockId mass = gui_fixture_block(fixture, "Mass 0");
    TinkerDocument *document = fixture->document;
    g_ptr_array_add(texts, text_of(fixture));
    g_assert_cmpint(tinker_graph_add(document, mass, "vy", "y", (double[]){1, 2}, (double[]){3, 4}, NULL), ==, 1);
    g_ptr_array_add(texts, text_of(fixture));
    g_assert_cmpint(tinker_graph_move(document, 1, (double[]){5, 6}, NULL, TRUE, NULL), ==, 1);
    g_ptr_array_add(texts, text_of(fixture));
    g_assert_cmpint(tinker_graph_move(document, 0, (double[]){0, 1}, (double[]){2, 1}, TRUE, NULL), ==, 1);
    g_ptr_array_add(texts, text_of(fixture));
    tinker_graph_dock(document, 0);
    g_ptr_array_add(texts, text_of(fixture));
    tinker_graph_remove(document, 0);
    g_ptr_array_add(texts, text_of(fixture));
    g_assert_cmpint(tinker_graph_move(document, 0, (double[]){0, 1}, (double[]){2, 1}, TRUE, NULL), ==, 0);
    g_assert_cmpstr(tinker_history_can_undo(tinker_document_history(document)), ==, "Delete Graph");
    for (guint i = texts->len - 1; i-- > 0;) {
        tinker_document_undo(document);
        g_autofree char *text = text_of(fixture);
        g_assert_cmpstr(text, ==, g_ptr_array_index(texts, i));
    }
    g_assert_null(tinker_history_can_undo(tinker_document_history(document)));
    for (guint i = 1; i < texts->len; i++) {
        tinker_document_redo(document);
        g_autofree char *text = text_of(fixture);
        g_assert_cmpstr(text, ==, g_ptr_array_index(texts, i));
    }
}

static void assert_graph(const TinkerSceneGraph *graph, const char *quantity, const char *against, gboolean floats)
{
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->block, ==, "Mass 0");
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->quantity, ==, quantity);
    g_assert_cmpstr(graph->against, ==, against);
    g_assert_cmpint(graph->has_place, ==, floats);
}

/* Size, place and order come back from the file; what is not good is refused and leaves no step. */
static void test_saved_and_read(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-graphs.tinker.json", NULL);
    g_autoptr(GuiFixture) fixture = fall("SI", "");
    TinkerBlockId mass = gui_fixture_block(fixture, "Mass 0");
    g_assert_cmpint(tinker_graph_add(fixture->document, mass, "sideways", NULL, NULL, NULL, &error), ==, -1);
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
    g_clear_error(&error);
    g_assert_null(tinker_history_can_undo(tinker_document_history(fixture->document)));
    tinker_graph_add(fixture->document, mass, "y", NULL, (double[]){0.1, -0.7}, (double[]){2.25, 1.5}, NULL);
    tinker_graph_add(fixture->document, mass, "x", NULL, NULL, NULL, NULL);
    tinker_graph_add(fixture->document, mass, "vy", "y", (double[]){1, 1}, (double[]){2, 2}, NULL);
    tinker_graph_move(fixture->document, 0, NULL, NULL, TRUE, NULL);
    g_assert_true(tinker_document_save(fixture->document, path, &error));
    g_assert_true(tinker_document_open(fixture->document, path, NULL, &error));
    g_remove(path);
    GPtrArray *graphs = tinker_scene_graphs(tinker_document_scene(fixture->document));
    g_assert_cmpuint(graphs->len, ==, 3);
    assert_graph(g_ptr_array_index(graphs, 0), "x", "time", FALSE);
    assert_graph(g_ptr_array_index(graphs, 1), "vy", "y", TRUE);
    const TinkerSceneGraph *front = g_ptr_array_index(graphs, 2);
    assert_graph(front, "y", "time", TRUE);
    g_assert_cmpfloat(front->place[0], ==, 0.1);
    g_assert_cmpfloat(front->place[1], ==, -0.7);
    g_assert_cmpfloat(front->size[0], ==, 2.25);
    g_assert_cmpfloat(front->size[1], ==, 1.5);
}

static gboolean apart(const TinkerGraphBox *a, const TinkerGraphBox *b)
{
    return a->x + a->width <= b->x || b->x + b->width <= a->x || a->y + a->height <= b->y || b->y + b->height <= a->y;
}

/* As long as there is room, new graphs stay clear of one another and inside the area. */
static void test_room(void)
{
    TinkerGraphBox taken[4];
    for (int i = 0; i < 4; i++) {
        taken[i] = (TinkerGraphBox){0, 0, 340, 230};
        tinker_graph_find_room(&taken[i], 800, 600, taken, i);
        g_assert_cmpfloat(taken[i].x, >=, 0);
        g_assert_cmpfloat(taken[i].y, >=, 0);
        g_assert_cmpfloat(taken[i].x + 340, <=, 800);
        g_assert_cmpfloat(taken[i].y + 230, <=, 600);
        for (int k = 0; k < i; k++)
            g_assert_true(apart(&taken[i], &taken[k]));
    }
    g_assert_cmpfloat(taken[0].x, >, 400); /* the first: upper right */
    g_assert_cmpfloat(taken[0].y, <, 100);
    TinkerGraphBox large = {0, 0, 900, 700};
    tinker_graph_find_room(&large, 800, 600, taken, 4);
    g_assert_cmpfloat(large.x, ==, 0);
    g_assert_cmpfloat(large.y, ==, 0);
}

static void add_tests(void)
{
    g_test_add_func("/gui/graph-data/published-table", test_published_table);
    g_test_add_func("/gui/graph-data/scene-stays", test_scene_stays);
    g_test_add_func("/gui/graph-data/phase-plot", test_phase_plot);
    g_test_add_func("/gui/graph-data/english-units", test_english_units);
    g_test_add_func("/gui/graph-data/several-curves", test_several_curves);
    g_test_add_func("/gui/graph-data/kept-runs", test_kept_runs);
    g_test_add_func("/gui/graph-data/energy", test_energy);
    g_test_add_func("/gui/graph-data/scales", test_scales);
    g_test_add_func("/gui/graph-data/generations", test_generations);
    g_test_add_func("/gui/graph-edit/steps", test_edits_are_steps);
    g_test_add_func("/gui/graph-edit/saved-and-read", test_saved_and_read);
    g_test_add_func("/gui/graph-edit/room", test_room);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

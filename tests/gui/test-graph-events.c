/* A graph of a ball that bounces: its jumps stand upright and its corners where they are, for eye, reading and
 * statistics. Dropped from 1 m, it meets the floor with sqrt(2 g) and leaves it with half of that. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "graph-fixture.h"
#include "gui/curve/graph-reading.h"

#define BOUNCE                                                                                                         \
    "'run': {'duration': 0.8, 'interval': 0.01}, 'blocks': [{'type': 'gravity'},"                                      \
    "{'type': 'support', 'name': 'S', 'position': [0, -0.2], 'restitution': 0.5},"                                     \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1], 'width': 0, 'height': 0, 'restitution': 0.5}],"                 \
    "'graphs': [{'block': 'M', 'quantity': '%s'}]"
#define SAMPLES 81
#define IMPACT  sqrt(2 / GRAVITY)
#define SPEED   sqrt(2 * GRAVITY)

static GuiFixture *bounce(const char *quantity)
{
    GuiFixture *fixture = gui_fixture_new("");
    g_autofree char *members = g_strdup_printf(BOUNCE, quantity);
    TinkerRunStatus status = {0};
    gui_fixture_start_scene(fixture, members);
    graph_fixture_run_until(fixture, 0.8);
    while (tinker_player_status(fixture->player, &status) && !status.finished)
        g_usleep(1000);
    return fixture;
}

static void assert_near(double value, double truth, double bound)
{
    g_assert_cmpfloat_with_epsilon(value, truth, bound);
}

/* Two points at the instant, and all samples around them. */
static void test_points(void)
{
    g_autoptr(GuiFixture) fixture = bounce("vy");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    const double *x = tinker_graph_data_x(data), *y = tinker_graph_data_y(data);
    g_assert_cmpuint(tinker_graph_data_count(data), ==, SAMPLES + 2);
    g_assert_cmpfloat(x[46], ==, x[47]);
    assert_near(x[46], IMPACT, 1e-9);
    assert_near(y[46], -SPEED, 1e-8);
    assert_near(y[47], 0.5 * SPEED, 1e-8);
    assert_near(x[48], 0.46, 1e-15);
}

/* What is exported is the samples alone. */
static void test_export(void)
{
    g_autoptr(GuiFixture) fixture = bounce("y");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-bounce.csv", NULL), *text = NULL;
    g_assert_true(tinker_graph_data_write_csv(data, path, 5, NULL));
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_remove(path);
    g_auto(GStrv) lines = g_strsplit(g_strchomp(text), "\n", -1);
    g_assert_cmpuint(g_strv_length(lines), ==, SAMPLES + 1);
    for (guint i = 0; i < SAMPLES; i++)
        assert_near(g_ascii_strtod(lines[i + 1], NULL), 0.01 * i, 1e-12);
}

/* The lowest point is on the floor, at the instant, and there the curve turns. */
static void test_corner(void)
{
    g_autoptr(GuiFixture) fixture = bounce("y");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    TinkerGraphReading reading = {0};
    g_assert_true(tinker_graph_reading_next(tinker_graph_data_curve(data, 0), 0.1, TRUE, &reading));
    g_assert_cmpint(reading.kind, ==, TINKER_READING_MINIMUM);
    assert_near(reading.at[0], IMPACT, 1e-9);
    assert_near(reading.at[1], 0, 1e-9);
    /* and then the top of the next flight, a quarter as high */
    g_assert_true(tinker_graph_reading_next(tinker_graph_data_curve(data, 0), reading.at[0], TRUE, &reading));
    g_assert_cmpint(reading.kind, ==, TINKER_READING_MAXIMUM);
    assert_near(reading.at[0], 1.5 * IMPACT, 1e-8);
    assert_near(reading.at[1], 0.25, 1e-8);
}

/* Both ends of a jump can be gone to, and what is read at each is true of its side; nothing is between them, no zero
 * either. */
static void test_both_sides(void)
{
    g_autoptr(GuiFixture) fixture = bounce("vy");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    const TinkerGraphSeries *series = tinker_graph_data_curve(data, 0);
    static const double sides[] = {-1, 0.5};
    static const TinkerReadingKind kinds[] = {TINKER_READING_MINIMUM, TINKER_READING_MAXIMUM};
    TinkerGraphReading reading = {0}, at = {0};
    double time = 0.2, now[2];
    for (int i = 0; i < 2; i++) {
        g_assert_true(tinker_graph_reading_next(series, time, TRUE, &reading));
        g_assert_cmpint(reading.kind, ==, kinds[i]);
        time = reading.at[0];
        assert_near(time, IMPACT, 1e-9);
        assert_near(reading.at[1], sides[i] * SPEED, 1e-8);
        tinker_player_seek(fixture->player, time);
        tinker_graph_data_update(data);
        g_assert_true(tinker_graph_data_now(data, 0, now));
        assert_near(now[1], sides[i] * SPEED, 1e-8);
        g_assert_true(tinker_graph_reading_at(series, time, &at));
        assert_near(at.at[1], sides[i] * SPEED, 1e-8);
    }
    g_assert_true(tinker_graph_reading_next(series, time, FALSE, &reading));
    assert_near(reading.at[1], -SPEED, 1e-8);
    g_assert_true(tinker_graph_reading_next(series, time, TRUE, &reading));
    g_assert_cmpint(reading.kind, ==, TINKER_READING_ZERO);
    assert_near(reading.at[0], 1.5 * IMPACT, 1e-8);
}

/* What a meter shows between two samples, one of which is before the impact: free fall, not the way across. */
static void test_meter(void)
{
    g_autoptr(GuiFixture) fixture = bounce("vy");
    const TinkerScene *scene = tinker_document_scene(fixture->document);
    const TinkerBlockId mass = tinker_scene_find_block(scene, "M");
    const int32_t vy = tinker_scene_find_quantity(scene, mass, "vy");
    static const double times[] = {0.4505, 0.4512, 0.453, 0.459};
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++) {
        double value, truth = -GRAVITY * times[i];
        if (times[i] > IMPACT) truth = 0.5 * SPEED - GRAVITY * (times[i] - IMPACT);
        tinker_player_seek(fixture->player, times[i]);
        g_assert_true(tinker_player_value(fixture->player, mass, vy, &value));
        assert_near(value, truth, 1e-8);
    }
}

/* The number behind the name of a line, and its error. */
static void assert_line(const char *text, const char *name, double truth, double most)
{
    const char *line = strstr(text, name);
    char *end;
    g_assert_nonnull(line);
    const char *number = strchr(line, '=') + 2;
    const gboolean is_negative = g_str_has_prefix(number, "−");
    const double value = g_ascii_strtod(number + (is_negative ? strlen("−") : 0), &end);
    const double error = g_ascii_strtod(strstr(end, "± ") + strlen("± "), NULL);
    assert_near(is_negative ? -value : value, truth, most);
    g_assert_cmpfloat(error, <, most);
}

/* Least, greatest and mean are those of the motion: the mean velocity is the way over the time. */
static void test_statistics(void)
{
    g_autoptr(GuiFixture) fixture = bounce("vy"), other = bounce("y");
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture), height = graph_fixture_data(other);
    g_autofree char *text = tinker_graph_statistics_text(data, NULL), *low = tinker_graph_statistics_text(height, NULL);
    const double flown = 0.8 - IMPACT, end = 0.5 * SPEED * flown - 0.5 * GRAVITY * flown * flown;
    assert_line(text, "Least", -SPEED, 1e-5);
    assert_line(text, "Greatest", 0.5 * SPEED, 1e-5);
    assert_line(text, "Mean", (end - 1) / 0.8, 1e-5);
    assert_line(low, "Least", 0, 1e-7);
}

static void add_tests(void)
{
    g_test_add_func("/gui/graph-events/points", test_points);
    g_test_add_func("/gui/graph-events/export", test_export);
    g_test_add_func("/gui/graph-events/corner", test_corner);
    g_test_add_func("/gui/graph-events/both-sides", test_both_sides);
    g_test_add_func("/gui/graph-events/meter", test_meter);
    g_test_add_func("/gui/graph-events/statistics", test_statistics);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

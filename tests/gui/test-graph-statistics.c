/* Statistics of curves whose truth is known, of a run that is far coarser than its samples: a mass of 1 kg on a spring
 * of 25 N/m, let go 1 m below its rest at y = 2, is at 2 - cos(5 t). */
#include "graph-fixture.h"

#include <math.h>
#include <string.h>

#define COARSE                                                                                                         \
    "'run': {'duration': 12, 'interval': 0.002, 'method': 'rk4', 'step': 0.1}, 'blocks': ["                            \
    "{'type': 'support', 'name': 'S', 'position': [0, 4], 'orientation': '180 deg'},"                                  \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1]},"                                                               \
    "{'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, 'rest_length': 2}],"                         \
    "'graphs': [{'curves': [{'expression': '2*{M.y} - 4', 'title': 'twice'}]}]"
#define PERIOD    (2 * G_PI / 5) /* s */
#define AMPLITUDE 2.0            /* m */

/* Runs it to its end, estimate and all. */
static void run_whole(GuiFixture *fixture)
{
    TinkerRunStatus status = {0};
    graph_fixture_run_until(fixture, 12);
    while (tinker_player_status(fixture->player, &status) && !status.finished)
        g_usleep(1000);
}

/* The number in the line of this name, and its error. */
static void read_line(const char *text, const char *name, double *value, double *error)
{
    const char *line = strstr(text, name), *after;
    g_assert_nonnull(line);
    char *end;
    *value = g_ascii_strtod(strchr(line, '=') + 1, &end);
    after = strstr(end, "± ");
    g_assert_nonnull(after);
    *error = g_ascii_strtod(after + strlen("± "), NULL);
}

/* The errors are those of the run: they cover what is off, and are not without bounds. */
static void test_error_of_run(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(fixture, COARSE);
    run_whole(fixture);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_autofree char *text = tinker_graph_statistics_text(data, NULL);
    g_test_message("%s", text);
    g_assert_null(strstr(text, "without the error"));
    const struct {
        const char *name;
        double truth, most;
    } lines[] = {{"Period", PERIOD, 0.02}, {"Amplitude", AMPLITUDE, 0.5}};
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++) {
        double value, error;
        read_line(text, lines[i].name, &value, &error);
        g_assert_cmpfloat(fabs(value - lines[i].truth), >, 1e-4 * lines[i].truth);
        g_assert_cmpfloat(fabs(value - lines[i].truth), <=, error);
        g_assert_cmpfloat(error, <, lines[i].most);
    }
    /* it grows with time, and an early part is not held to the end of the run */
    double early, late;
    g_assert_true(tinker_graph_data_run_error(data, 0, 0, 2, &early));
    g_assert_true(tinker_graph_data_run_error(data, 0, 0, 12, &late));
    g_assert_cmpfloat(early, >, 0);
    g_assert_cmpfloat(early, <, 0.5 * late);
}

/* A value has the digits that its error leaves: of a motion that is known exactly, the text itself is right to within
 * the error beside it. That has one digit, of which it may be two thirds, and the value is rounded by half a unit of
 * it. */
static void test_digits(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    g_autofree char *exact = g_strdup(COARSE);
    char *method = strstr(exact, "'method': 'rk4', 'step': 0.1");
    memset(method, ' ', strlen("'method': 'rk4', 'step': 0.1"));
    memcpy(method, "'method': 'exact'", strlen("'method': 'exact'"));
    gui_fixture_start_scene(fixture, exact);
    run_whole(fixture);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_autofree char *text = tinker_graph_statistics_text(data, NULL);
    g_test_message("%s", text);
    const struct {
        const char *name;
        double truth;
    } lines[] = {{"Period", PERIOD}, {"Amplitude", AMPLITUDE}, {"Greatest", 2.0}};
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++) {
        double value, error;
        read_line(text, lines[i].name, &value, &error);
        g_assert_cmpfloat(error, <, 1e-4);
        g_assert_cmpfloat(fabs(value - lines[i].truth), <=, 2 * error);
    }
}

/* Nothing damps it: of a damping ratio that is less than its error no digit is shown. */
static void test_less_than_its_error(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(fixture, COARSE);
    run_whole(fixture);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    const TinkerGraphPart early = {0, 6, FALSE};
    g_autofree char *text = tinker_graph_statistics_text(data, &early);
    g_test_message("%s", text);
    g_assert_nonnull(strstr(text, "Damping ratio = 0 ± "));
}

/* No more is said than is known, and no less: a value is rounded to the decade of an error that is greater. */
static void test_about_its_error(void)
{
    static const struct {
        TinkerStatistic of;
        const char *text;
    } rows[] = {{{0.9, 1}, "1"},      {{-0.8, 1}, "−1"},       {{-0.2, 1}, "0"},        {{0.04, 0.05}, "0.04"},
                {{-2e-9, 3e-7}, "0"}, {{2e-7, 3e-7}, "2e-07"}, {{97, 98}, "100"},       {{33, 98}, "30"},
                {{0, 0.5}, "0"},      {{1, 1}, "1.0000"},      {{-1.5, 0.5}, "−1.5000"}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(GString) text = g_string_new(NULL);
        tinker_statistic_append(text, &rows[i].of);
        g_assert_cmpstr(text->str, ==, rows[i].text);
    }
}

/* Between two cursors no more is counted than stands there, and the text says so: twice the height above rest is
 * -2 cos(5 t), and rises from 0.4 to 0.5 s. */
static void test_between_cursors(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(fixture, COARSE);
    run_whole(fixture);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    const TinkerGraphPart part = {0.4, 0.5, TRUE};
    g_autofree char *text = tinker_graph_statistics_text(data, &part);
    const struct {
        const char *name;
        double truth;
    } lines[] = {{"Mean", -2 * (sin(2.5) - sin(2)) / 0.5}, {"Least", -2 * cos(2)}, {"Greatest", -2 * cos(2.5)}};
    g_test_message("%s", text);
    g_assert_nonnull(strstr(text, "between cursors A and B, from 0.4 to 0.5 s"));
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++) {
        double value, error;
        read_line(text, lines[i].name, &value, &error);
        g_assert_cmpfloat(fabs(value - lines[i].truth), <=, error);
        g_assert_cmpfloat(error, <, 0.05);
    }
}

/* A run that is kept has statistics of its own beside those of the present one, by its name, as long as it is shown: on
 * a spring a quarter as stiff the mass swings half as fast. */
static void test_kept_run(void)
{
    static const char *const names[] = {"K: K 25 N/m\n", "K: K 6.25 N/m, now\n"};
    static const double periods[] = {PERIOD, 2 * PERIOD};
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(fixture, COARSE);
    run_whole(fixture);
    g_assert_true(tinker_player_keep(fixture->player));
    gui_fixture_set(fixture, "K", "stiffness", 6.25, 0);
    run_whole(fixture);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_autofree char *text = tinker_graph_statistics_text(data, NULL);
    g_test_message("%s", text);
    g_assert_null(strstr(text, "without the error"));
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        const char *part = strstr(text, names[i]);
        double value, error;
        g_assert_nonnull(part);
        read_line(part, "Period", &value, &error);
        g_assert_cmpfloat(fabs(value - periods[i]), <=, error);
        g_assert_cmpfloat(error, <, 0.2 * periods[i]);
    }
    tinker_kept_runs_show(tinker_player_kept(fixture->player), 0, FALSE);
    g_autofree char *alone = tinker_graph_statistics_text(data, NULL);
    g_assert_null(strstr(alone, names[0]));
}

/* Where there is no estimate the numbers say so. */
static void test_not_known(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(fixture, COARSE);
    tinker_player_begin_trial(fixture->player);
    run_whole(fixture);
    tinker_player_end_trial(fixture->player);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_autofree char *text = tinker_graph_statistics_text(data, NULL);
    g_assert_nonnull(strstr(text, "without the error of the run"));
    while (tinker_player_estimate(fixture->player))
        g_usleep(1000);
    g_autofree char *later = tinker_graph_statistics_text(data, NULL);
    g_assert_null(strstr(later, "without the error of the run"));
}

/* What bounces has no period, and the text tells why; it is never below the floor that it bounces on. */
static void test_bounces(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    gui_fixture_start_scene(fixture,
                            "'run': {'duration': 5}, 'blocks': [{'type': 'gravity', 'name': 'G'}, {'type': 'support', "
                            "'name': 'S', 'position': [0, -0.25], 'height': 0.5, 'restitution': 0.8}, {'type': 'mass', "
                            "'name': 'M', 'height': 1, 'position': [0, 2.5]}], "
                            "'graphs': [{'curves': [{'expression': '{M.y} - 0.5', 'title': 'gap'}]}]");
    graph_fixture_run_until(fixture, 5);
    g_autoptr(TinkerGraphData) data = graph_fixture_data(fixture);
    g_autofree char *text = tinker_graph_statistics_text(data, NULL);
    double least, error;
    g_test_message("%s", text);
    read_line(text, "Least", &least, &error);
    g_assert_cmpfloat(fabs(least), <=, 2 * error);
    g_assert_cmpfloat(error, <, 1e-4);
    g_assert_nonnull(strstr(text, "Period: — (its swings do not take equally long)"));
    g_assert_nonnull(strstr(text, "Damping ratio: — (its swings do not take equally long)"));
}

static void add_tests(void)
{
    g_test_add_func("/gui/graph-statistics/error-of-run", test_error_of_run);
    g_test_add_func("/gui/graph-statistics/digits", test_digits);
    g_test_add_func("/gui/graph-statistics/less-than-its-error", test_less_than_its_error);
    g_test_add_func("/gui/graph-statistics/between-cursors", test_between_cursors);
    g_test_add_func("/gui/graph-statistics/about-its-error", test_about_its_error);
    g_test_add_func("/gui/graph-statistics/bounces", test_bounces);
    g_test_add_func("/gui/graph-statistics/not-known", test_not_known);
    g_test_add_func("/gui/graph-statistics/kept-run", test_kept_run);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

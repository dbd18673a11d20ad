/* Axes: ranges that can be shown whatever the data, labels that can be read, factors and offsets in the title. */
#include <math.h>
#include <string.h>

#include "render/plot/plot-private.h"

typedef struct {
    double least, greatest;
    gboolean logarithmic;
    const char *label;
    const char *title; /* expected */
} Case;

static TinkerAxis axis_of(double least, double greatest, gboolean logarithmic, const char *label)
{
    TinkerAxis axis = {.logarithmic = logarithmic, .start = 0, .length = 100};
    tinker_axis_set_range(&axis, least, greatest, 0);
    tinker_axis_choose_ticks(&axis, 8, label);
    return axis;
}

static void test_titles(void)
{
    static const Case cases[] = {
        {0, 10, FALSE, "Time [s]", "Time [s]"},
        {-3e-9, 3e-9, FALSE, "X [m]", "X [10⁻⁹ m]"},
        {0, 4e7, FALSE, "Force [N]", "Force [10⁶ N]"},
        {0, 4e7, FALSE, "Count", "Count [10⁶]"},
        {9.81 - 1e-7, 9.81 + 1e-7, FALSE, "A [m/s²]", "A − 9.81 [10⁻⁹ m/s²]"},
        {-9.81 - 1e-7, -9.81 + 1e-7, FALSE, "A [m/s²]", "A + 9.81 [10⁻⁹ m/s²]"},
        {1e6, 1e6 + 1, FALSE, "T", "T − 1×10⁶"},
        {1e-9, 1e-3, TRUE, "Error [1]", "Error [1]"},
        {0, 10, FALSE, NULL, ""},
        {0, 1e-9, FALSE, "", "[10⁻⁹]"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        TinkerAxis axis = axis_of(cases[i].least, cases[i].greatest, cases[i].logarithmic, cases[i].label);
        g_assert_cmpstr(axis.title, ==, cases[i].title);
        tinker_axis_clear(&axis);
    }
}

/* Labels of any range are short, differ from each other, and read back, with factor and offset, as their tick. */
static void test_labels(void)
{
    for (int i = 0; i < 5000; i++) {
        double size = pow(10, g_test_rand_double_range(-290, 290)) * (g_test_rand_bit() ? 1 : -1);
        double width = fabs(size) * pow(10, g_test_rand_double_range(-11, 1));
        TinkerAxis axis = axis_of(size, size + width, FALSE, "Q [m]");
        g_assert_cmpint(axis.tick_count, >=, 2);
        for (int n = 0; n < axis.tick_count; n++) {
            g_assert_cmpint(g_utf8_strlen(axis.labels[n], -1), <=, 9);
            g_assert_true(g_utf8_validate(axis.labels[n], -1, NULL));
            if (n > 0) g_assert_cmpstr(axis.labels[n], !=, axis.labels[n - 1]);
        }
        tinker_axis_clear(&axis);
    }
}

static void test_decades(void)
{
    TinkerAxis axis = axis_of(1e-3, 1e3, TRUE, "Q");
    g_assert_cmpint(axis.tick_count, ==, 7);
    g_assert_cmpstr(axis.labels[0], ==, "10⁻³");
    g_assert_cmpstr(axis.labels[6], ==, "10³");
    g_assert_cmpint(axis.decade_stride, ==, 1);
    g_assert_cmpfloat_with_epsilon(tinker_axis_place(&axis, 1), 50, 1e-9);
    g_assert_true(isnan(tinker_axis_place(&axis, 0)));
    g_assert_true(isnan(tinker_axis_place(&axis, -1)));
    tinker_axis_clear(&axis);
    axis = axis_of(1e-290, 1e290, TRUE, "Q");
    g_assert_cmpint(axis.tick_count, <=, 8);
    g_assert_cmpint(axis.tick_count, >=, 3);
    tinker_axis_clear(&axis);
    axis = axis_of(2, 5, TRUE, "Q");
    g_assert_cmpint(axis.tick_count, >=, 3);
    for (int i = 0; i < axis.tick_count; i++)
        g_assert_cmpfloat_with_epsilon(pow(10, axis.ticks[i]), g_ascii_strtod(axis.labels[i], NULL), 1e-9);
    tinker_axis_clear(&axis);
}

/* A range without extent is widened about its value; no data make an axis too. */
static void test_ranges(void)
{
    static const double constants[] = {0, 1, -5, 1e-250, 1e250, 12.5};
    for (gsize i = 0; i < G_N_ELEMENTS(constants); i++) {
        TinkerAxis axis = axis_of(constants[i], constants[i], FALSE, "Q");
        g_assert_cmpfloat(axis.low, <, constants[i]);
        g_assert_cmpfloat(axis.high, >, constants[i]);
        g_assert_cmpfloat_with_epsilon(tinker_axis_place(&axis, constants[i]), 50, 1e-6);
        tinker_axis_clear(&axis);
    }
    /* What a run's error makes of a constant is shown as one: no offset, and labels that can be read. */
    TinkerAxis axis = axis_of(12, 12 + 1e-9, FALSE, "Q");
    g_assert_cmpfloat(axis.high - axis.low, >, 1);
    g_assert_null(strstr(axis.title, "12"));
    tinker_axis_clear(&axis);
    axis = axis_of(INFINITY, -INFINITY, FALSE, "Q");
    g_assert_true(axis.empty);
    g_assert_cmpint(axis.tick_count, >, 1);
    tinker_axis_clear(&axis);
    axis = axis_of(-G_MAXDOUBLE, G_MAXDOUBLE, FALSE, "Q");
    g_assert_true(isfinite(tinker_axis_place(&axis, G_MAXDOUBLE)));
    g_assert_true(isfinite(tinker_axis_place(&axis, 0)));
    tinker_axis_clear(&axis);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/axis/titles", test_titles);
    g_test_add_func("/render/axis/labels", test_labels);
    g_test_add_func("/render/axis/decades", test_decades);
    g_test_add_func("/render/axis/ranges", test_ranges);
    return g_test_run();
}

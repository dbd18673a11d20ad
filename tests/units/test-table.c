/* Tables against closed forms: lines, cubics, integrals of accelerations; and what a file may not hold. */
#include <math.h>
#include <string.h>
#include <unistd.h>

#include <glib/gstdio.h>

#include "units/waveform/table-columns.h"
#include "units/waveform/waveform.h"

static TinkerWaveformEvaluator *evaluator_of(const double *times, const double *values, gsize rows,
                                             TinkerTableKind kind, gboolean smooth)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_table(times, values, rows, kind, &error);
    g_assert_no_error(error);
    return tinker_waveform_evaluator_new(waveform, 1, 1, 0, smooth);
}

static void evaluate(TinkerWaveformEvaluator *evaluator, double inside, double t, double result[3])
{
    tinker_waveform_enter_piece(evaluator, inside);
    tinker_waveform_evaluate(evaluator, t, result);
}

/* Columns have the names of the heading, or none; times may be in any of them. */
static void test_columns(void)
{
    const struct {
        const char *text, *names; /* with a bar behind each */
    } cases[] = {{"# made by hand\nframe,t, \"y [m]\"\n1,0.5,7\n2,1.5,8\n", "frame|t|y [m]|"},
                 {"run,0.5,7\n2,1.5,8\n", "|||"},
                 {"1;2\n", "||"},
                 {"\316\270,\317\204,x\n2,1.5,8\n", "\316\270|\317\204|x|"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        g_autofree char *folder = g_dir_make_tmp("tinker-table-XXXXXX", NULL);
        g_autofree char *path = g_build_filename(folder, "table.csv", NULL);
        g_assert_true(g_file_set_contents(path, cases[i].text, -1, NULL));
        g_autoptr(GPtrArray) names = tinker_table_column_names(path, &error);
        g_assert_no_error(error);
        g_autoptr(GString) all = g_string_new(NULL);
        for (guint k = 0; k < names->len; k++)
            g_string_append_printf(all, "%s|", (const char *)names->pdata[k]);
        g_assert_cmpstr(all->str, ==, cases[i].names);
        if (i == 0) {
            g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(double));
            const double expected[] = {0.5, 1, 1.5, 2};
            g_assert_true(tinker_table_read_column(path, 1, 0, rows, &error));
            g_assert_cmpmem(rows->data, rows->len * sizeof(double), expected, sizeof expected);
        }
        if (i == 3) { /* a heading, whatever its letters */
            g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(double));
            g_assert_true(tinker_table_read_column(path, 1, 2, rows, &error));
            g_assert_cmpuint(rows->len, ==, 2);
        }
        g_unlink(path);
        g_rmdir(folder);
    }
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_table_column_names("/there/is/none.csv", &error));
    g_assert_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE);
}

static void test_linear(void)
{
    const double times[] = {1, 2, 4}, values[] = {10, 20, 0};
    g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(times, values, 3, TINKER_TABLE_VALUE, FALSE);
    const double cases[][5] = {/* inside, t, value, slope, bend */
                               {0, 0.5, 10, 0, 0}, {1.5, 1, 10, 10, 0}, {1.5, 1.25, 12.5, 10, 0}, {1.5, 2, 20, 10, 0},
                               {3, 2, 20, -10, 0}, {3, 3, 10, -10, 0},  {3, 4, 0, -10, 0},        {5, 9, 0, 0, 0}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double result[3];
        evaluate(evaluator, cases[i][0], cases[i][1], result);
        for (int j = 0; j < 3; j++)
            g_assert_cmpfloat(result[j], ==, cases[i][2 + j]);
    }
    g_assert_cmpfloat(tinker_waveform_next_break(evaluator, 0, 10), ==, 1);
    g_assert_cmpfloat(tinker_waveform_next_break(evaluator, 1, 10), ==, 2);
    g_assert_cmpfloat(tinker_waveform_next_break(evaluator, 2, 4), ==, 4);
    g_assert_cmpfloat(tinker_waveform_next_break(evaluator, 2, 3.9), ==, INFINITY);
    g_assert_cmpfloat(tinker_waveform_next_break(evaluator, 4, INFINITY), ==, INFINITY);
}

/* The natural spline through a C2 piecewise cubic with zero end curvature is that function: here s(t) = t^3 - 3 t up to
 * 1 and its mirror image behind, s(2 - t) = s(t), whose curvature is 6 t up to 1. */
static double cubic(double t, int derivative)
{
    const double u = t <= 1 ? t : 2 - t, sign = t <= 1 ? 1 : -1;
    switch (derivative) {
    case 0:
        return u * u * u - 3 * u;
    case 1:
        return sign * (3 * u * u - 3);
    default:
        return 6 * u;
    }
}

static void test_spline_cubic(void)
{
    const double times[] = {0, 0.25, 0.6, 1, 1.5, 2};
    double values[6];
    for (int i = 0; i < 6; i++)
        values[i] = cubic(times[i], 0);
    g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(times, values, 6, TINKER_TABLE_VALUE, TRUE);
    for (double t = 0.01; t < 2; t += 0.03) {
        double result[3];
        evaluate(evaluator, t, t, result);
        for (int j = 0; j < 3; j++)
            g_assert_cmpfloat_with_epsilon(result[j], cubic(t, j), 1e-13);
    }
}

static void test_spline_smooth(void)
{
    g_autoptr(GRand) rand = g_rand_new_with_seed(3);
    double times[40], values[40];
    for (int i = 0; i < 40; i++) {
        times[i] = i == 0 ? -2 : times[i - 1] + g_rand_double_range(rand, 0.1, 1);
        values[i] = g_rand_double_range(rand, -1, 1);
    }
    g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(times, values, 40, TINKER_TABLE_VALUE, TRUE);
    double left[3], right[3];
    for (int i = 1; i + 1 < 40; i++) {
        evaluate(evaluator, (times[i - 1] + times[i]) / 2, times[i], left);
        evaluate(evaluator, (times[i] + times[i + 1]) / 2, times[i], right);
        g_assert_cmpfloat_with_epsilon(left[0], values[i], 1e-14);
        g_assert_cmpfloat_with_epsilon(right[0], values[i], 1e-14);
        g_assert_cmpfloat_with_epsilon(left[1], right[1], 1e-11);
        g_assert_cmpfloat_with_epsilon(left[2], right[2], 1e-10);
    }
    evaluate(evaluator, times[0] + 0.01, times[0], right);
    g_assert_cmpfloat(right[2], ==, 0);
    evaluate(evaluator, times[39] - 0.01, times[39], left);
    g_assert_cmpfloat(left[2], ==, 0);
}

/* a(t) = t - 1 on [1, 3] (linear, so the rows do not matter), then 2 - 2 (t - 3) on [3, 5]; from rest. */
static void test_acceleration(void)
{
    const double times[] = {1, 1.3, 2, 3, 5}, values[] = {0, 0.3, 1, 2, -2};
    g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(times, values, 5, TINKER_TABLE_ACCELERATION, TRUE);
    for (double t = 0.1; t < 8; t += 0.07) {
        const double u = t - 1, w = t - 3, x = t - 5;
        double expected[3] = {0, 0, 0}, result[3];
        if (t >= 5) {
            expected[1] = 2;
            expected[0] = 4.0 / 3 + 4 + 4 - 8.0 / 3 + 2 * x;
        } else if (t >= 3) {
            expected[2] = 2 - 2 * w;
            expected[1] = 2 + 2 * w - w * w;
            expected[0] = 4.0 / 3 + 2 * w + w * w - w * w * w / 3;
        } else if (t >= 1) {
            expected[2] = u;
            expected[1] = u * u / 2;
            expected[0] = u * u * u / 6;
        }
        evaluate(evaluator, t, t, result);
        for (int j = 0; j < 3; j++)
            g_assert_cmpfloat_with_epsilon(result[j], expected[j], 1e-13);
    }
}

static void test_rows_refused(void)
{
    const double repeated[] = {0, 1, 1}, bad[] = {0, NAN, 2}, good[] = {0, 1, 2};
    g_autoptr(GError) order = NULL, number = NULL, none = NULL, many = NULL;
    g_assert_null(tinker_waveform_new_table(repeated, good, 3, TINKER_TABLE_VALUE, &order));
    g_assert_cmpstr(order->message, ==, "row 3: the time 1 must be greater than 1 in the row before");
    g_assert_null(tinker_waveform_new_table(good, bad, 3, TINKER_TABLE_VALUE, &number));
    g_assert_cmpstr(number->message, ==, "row 2: time and value must be finite numbers");
    g_assert_null(tinker_waveform_new_table(good, good, 0, TINKER_TABLE_VALUE, &none));
    g_assert_error(none, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE);
    g_autofree double *large = g_new0(double, 10000001);
    g_assert_null(tinker_waveform_new_table(large, large, 10000001, TINKER_TABLE_VALUE, &many));
    g_assert_cmpstr(many->message, ==, "a table has 1 to 10000000 rows, this one has 10000001");
    const double one = 4;
    g_autoptr(TinkerWaveformEvaluator) single = evaluator_of(&one, &one, 1, TINKER_TABLE_VALUE, TRUE);
    double result[3];
    evaluate(single, 9, 9, result);
    g_assert_cmpfloat(result[0], ==, 4);
}

/* A table read from a file of this content, with column 1 and scale 2. */
static TinkerWaveform *read_content(const char *content, gssize length, GError **error)
{
    g_autofree char *path = NULL;
    const int descriptor = g_file_open_tmp("tinker-table-XXXXXX", &path, NULL);
    g_assert_cmpint(descriptor, >=, 0);
    g_close(descriptor, NULL);
    g_assert_true(g_file_set_contents(path, content, length, NULL));
    TinkerWaveform *waveform = tinker_waveform_new_table_file(path, 1, 2, TINKER_TABLE_VALUE, error);
    g_unlink(path);
    if (error != NULL && *error != NULL) {
        /* the rest of the message is what the test compares; the path changes */
        g_assert_true(g_str_has_prefix((*error)->message, path));
        char *rest = g_strdup((*error)->message + strlen(path));
        g_free((*error)->message);
        (*error)->message = rest;
    }
    return waveform;
}

static void test_file(void)
{
    static const char *const contents[] = {
        "time,value\n0,1\n1,3\n",      "0,1\n1,3",         "# made by hand\n\n\"t (s)\";\"a\"\r\n0;1\r\n\r\n1;3\r\n",
        "\xEF\xBB\xBFt,a\n0,1\n1,3\n", "0 1\n  1   3  \n", "0\t1\t7\n# end\n1\t3\t8\n",
        "0, 1 , x\n 1e0 , 3.0,\n",     "0.0,+1\n1.,.3e1\n"};
    for (gsize i = 0; i < G_N_ELEMENTS(contents); i++) {
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerWaveform) waveform = read_content(contents[i], -1, &error);
        g_assert_no_error(error);
        g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(waveform, 1, 1, 0, FALSE);
        double result[3];
        evaluate(evaluator, 0.5, 0.5, result);
        g_assert_cmpfloat(result[0], ==, 4);
        g_assert_cmpfloat(result[1], ==, 4);
    }
}

static void test_file_refused(void)
{
    static const char *const cases[][2] = {
        {"0,1\n1,3\n1,4\n", ":3:1: the time 1 must be greater than 1 in the row before"},
        {"0,1\n1,x\n", ":2:3: the value must be a number, not \"x\""},
        {"0,1\n1,nan\n", ":2:3: the value must be finite"},
        {"t,a\nu,b\n", ":2:1: the time must be a number, not \"u\""},
        {"0,1\n2\n", ":2:2: the value is missing (column 1)"},
        {"0,1\n2,\n", ":2:3: the value is missing (column 1)"},
        {"0,1e308\n", ":1:3: the scaled value is too large"},
        {"# nothing\n", ":1:1: the file has no rows of numbers"},
        {"", ":0:1: the file has no rows of numbers"},
        {"0,0x10\n", ":1:3: the value must be a number, not \"0x10\""},
        {"0 1\n1 1,5\n", ":2:1: the time must be a number, not \"1 1\""},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        g_assert_null(read_content(cases[i][0], -1, &error));
        g_assert_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE);
        g_assert_cmpstr(error->message, ==, cases[i][1]);
    }
    g_autofree char *long_line = g_strnfill(200000, '1');
    g_autoptr(GError) too_long = NULL, binary = NULL;
    g_assert_null(read_content(long_line, -1, &too_long));
    g_assert_cmpstr(too_long->message, ==, ":1:1: the line is longer than 65534 bytes");
    g_assert_null(read_content("\0\0\xff\n\x01", 5, &binary));
    g_assert_error(binary, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE);

    static const char *const paths[] = {"/", "/dev/zero", "/nonexistent/table.csv"};
    for (gsize i = 0; i < G_N_ELEMENTS(paths); i++) {
        g_autoptr(GError) error = NULL;
        g_assert_null(tinker_waveform_new_table_file(paths[i], 1, 1, TINKER_TABLE_VALUE, &error));
        g_assert_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE);
    }
}

/* A file without an end, nearly: holes take no room on the disk, but lines of it would take hours. */
static void test_file_too_large(void)
{
    g_autofree char *path = NULL;
    const int descriptor = g_file_open_tmp("tinker-table-XXXXXX", &path, NULL);
    g_assert_cmpint(ftruncate(descriptor, G_GINT64_CONSTANT(1) << 40), ==, 0);
    close(descriptor);
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_waveform_new_table_file(path, 1, 1, TINKER_TABLE_VALUE, &error));
    g_assert_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE);
    g_assert_true(g_str_has_suffix(error->message, ": has 1099511627776 bytes, a table has at most 268435456"));
    g_remove(path);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/table/columns", test_columns);
    g_test_add_func("/table/linear", test_linear);
    g_test_add_func("/table/spline-cubic", test_spline_cubic);
    g_test_add_func("/table/spline-smooth", test_spline_smooth);
    g_test_add_func("/table/acceleration", test_acceleration);
    g_test_add_func("/table/rows-refused", test_rows_refused);
    g_test_add_func("/table/file", test_file);
    g_test_add_func("/table/file-refused", test_file_refused);
    g_test_add_func("/table/file-too-large", test_file_too_large);
    return g_test_run();
}

/* Records beyond their memory, columns by name, and the libraries that a scene opens. */
#include "physics-fixture.h"

#include "physics/record/columns.h"
#include "physics/record/record.h"
#include "physics/record/sample-times.h"

#include <math.h>
#include <string.h>

/* --- record --- */

static void fill_row(gsize number, double row[3])
{
    row[0] = (double)number;
    row[1] = sin((double)number);
    row[2] = -0.0;
}

static void append_rows(TinkerRecord *record, gsize from, gsize to)
{
    for (gsize i = from; i < to; i++) {
        double row[3];
        fill_row(i, row);
        g_assert_true(tinker_record_append(record, row, NULL));
    }
}

static void assert_rows(TinkerRecord *record, gsize first, gsize count)
{
    g_autofree double *rows = g_new(double, 3 * count + 1);
    rows[3 * count] = 12345;
    g_assert_true(tinker_record_read(record, first, count, rows, NULL));
    for (gsize i = 0; i < count; i++) {
        double row[3];
        fill_row(first + i, row);
        g_assert_cmpmem(rows + 3 * i, sizeof(row), row, sizeof(row));
    }
    g_assert_cmpfloat(rows[3 * count], ==, 12345);
}

static void test_spilling(void)
{
    static const gsize limits[] = {1, 24 * 7, 24 * 100, 0};
    for (gsize i = 0; i < G_N_ELEMENTS(limits); i++) {
        g_autoptr(TinkerRecord) record = tinker_record_new(3, limits[i]);
        append_rows(record, 0, 1000);
        g_assert_cmpuint(tinker_record_rows(record), ==, 1000);
        assert_rows(record, 0, 1000);
        assert_rows(record, 993, 7);
        append_rows(record, 1000, 1234);
        for (gsize first = 0; first < 1234; first += 61)
            assert_rows(record, first, MIN((gsize)97, 1234 - first));
        assert_rows(record, 500, 0);
    }
}

static void test_cutting(void)
{
    static const gsize cuts[] = {1234, 1001, 995, 700, 3, 0};
    for (gsize i = 0; i < G_N_ELEMENTS(cuts); i++) {
        g_autoptr(TinkerRecord) record = tinker_record_new(3, 24 * 10);
        append_rows(record, 0, 1000);
        tinker_record_cut(record, cuts[i]);
        gsize kept = MIN((gsize)1000, cuts[i]);
        g_assert_cmpuint(tinker_record_rows(record), ==, kept);
        append_rows(record, kept, 1100);
        assert_rows(record, 0, 1100);
    }
}

typedef struct {
    TinkerRecord *record;
    gint done; /* atomic */
} Growing;

static gpointer grow(gpointer data)
{
    Growing *growing = data;
    append_rows(growing->record, 0, 20000);
    g_atomic_int_set(&growing->done, TRUE);
    return NULL;
}

/* Rows are what they are from the moment that they are counted, whether they lie in memory or leave it. */
static void test_read_while_growing(void)
{
    g_autoptr(TinkerRecord) record = tinker_record_new(3, 24 * 100);
    Growing growing = {record, FALSE};
    GThread *thread = g_thread_new("grow", grow, &growing);
    for (gsize i = 0; !g_atomic_int_get(&growing.done); i++) {
        const gsize rows = tinker_record_rows(record), first = rows > 0 ? i * 7919 % rows : 0;
        assert_rows(record, first, MIN((gsize)150, rows - first));
        assert_rows(record, rows - MIN((gsize)50, rows), MIN((gsize)50, rows));
    }
    g_thread_join(thread);
    assert_rows(record, 0, 20000);
}

/* --- times --- */

static void test_times(void)
{
    TinkerSampleTimes tenths = tinker_sample_times(100, 0.1, NULL, 0), odd = tinker_sample_times(1, 0.3, NULL, 0);
    g_assert_cmpint(tenths.count, ==, 1001);
    for (gint64 i = 0; i < 1000; i++) {
        g_autofree char *text = g_strdup_printf("%d.%d", (int)(i / 10), (int)(i % 10));
        g_assert_cmpfloat(tinker_sample_times_at(&tenths, i), ==, g_ascii_strtod(text, NULL));
    }
    g_assert_cmpint(odd.count, ==, 5);
    g_assert_cmpfloat(tinker_sample_times_at(&odd, 3), <, 1);
    g_assert_cmpfloat(tinker_sample_times_at(&odd, 4), ==, 1);
    TinkerSampleTimes none = tinker_sample_times(0, 0.1, NULL, 0), long_run = tinker_sample_times(1e6, 1e-3, NULL, 0);
    g_assert_cmpint(none.count, ==, 1);
    g_assert_cmpint(long_run.count, ==, 1000000001);
    g_assert_cmpfloat(tinker_sample_times_at(&long_run, 123456789), ==, 123456.789);
    g_assert_cmpfloat(tinker_sample_times_at(&long_run, 1000000000), ==, 1e6);
}

/* --- columns --- */

static TinkerScene *two_masses(void)
{
    return physics_scene(NULL, "{'type': 'mass'}, {'type': 'mass', 'name': 'a, b.c', 'position': [2, 0]},"
                               "{'type': 'spring', 'ends': ['Mass 0', 'a, b.c']}, {'type': 'gravity'}");
}

static void assert_column_error(const char *list, const char *message)
{
    g_autoptr(TinkerScene) scene = two_masses();
    g_autoptr(GArray) columns = tinker_columns_new();
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_columns_add_list(columns, scene, list, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME);
    g_assert_cmpstr(error->message, ==, message);
}

static void test_column_errors(void)
{
    assert_column_error("Mass 0.x, Mas 0.y", "column \"Mas 0.y\": the scene has no block \"Mas 0\"; did you mean "
                                             "\"Mass 0\"? (a column is BLOCK.QUANTITY, as in \"Mass 0.x\")");
    assert_column_error("zebra",
                        "column \"zebra\": the scene has no block \"zebra\" (it has Mass 0, a, b.c, Spring 0, "
                        "Gravity 0) (a column is BLOCK.QUANTITY, as in \"Mass 0.x\"; put quotes round a name with "
                        "a space)");
    assert_column_error("Mass 0.colour",
                        "column \"Mass 0.colour\": this block has no quantity \"colour\" (it has x, y, vx, "
                        "vy, ax, ay, speed, kinetic energy, x momentum, y momentum, "
                        "normal force, friction force, contact force, acceleration, path length, distance to BLOCK)");
}

static void assert_columns(const GArray *columns, const char *const *names)
{
    g_assert_cmpuint(columns->len, ==, g_strv_length((char **)names));
    for (guint i = 0; i < columns->len; i++)
        g_assert_cmpstr(g_array_index(columns, TinkerColumn, i).name, ==, names[i]);
}

static void test_columns(void)
{
    g_autoptr(TinkerScene) scene = two_masses();
    g_autoptr(GArray) standard = tinker_columns_default(scene), picked = tinker_columns_new();
    static const char *const names[] = {"Mass 0.x", "Mass 0.y",  "Mass 0.vx", "Mass 0.vy",        "a, b.c.x",
                                        "a, b.c.y", "a, b.c.vx", "a, b.c.vy", "Spring 0.tension", NULL};
    static const char *const chosen[] = {"a, b.c.vx", "Spring 0.energy", "Mass 0.kinetic energy", NULL};
    assert_columns(standard, names);
    g_assert_true(tinker_columns_add_list(picked, scene, "a, b.c.vx,Spring 0.energy, Mass 0.kinetic energy,", NULL));
    assert_columns(picked, chosen);
    g_assert_cmpstr(g_array_index(picked, TinkerColumn, 0).unit, ==, "m/s");
    g_assert_cmpstr(g_array_index(picked, TinkerColumn, 1).unit, ==, "J");
    g_assert_cmpstr(g_array_index(standard, TinkerColumn, 1).title, ==, "Y Position");
}

/* What is recorded in SI is shown in either system of units: the thesis's mass. */
static void assert_shown(double si, TinkerDimension dimension, const char *metric, const char *english)
{
    g_autofree char *left = tinker_quantity_format(si, dimension, NULL, TINKER_UNIT_SYSTEM_SI, 5);
    g_autofree char *right = tinker_quantity_format(si, dimension, NULL, TINKER_UNIT_SYSTEM_ENGLISH, 5);
    g_assert_cmpstr(left, ==, metric);
    g_assert_cmpstr(right, ==, english);
}

static void test_shown_in_both_systems(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.columns = "Mass 0.x, Mass 0.y"}, "{'type': 'mass', 'position': [3.2, 2.4]}");
    static const char *const shown[2][2] = {{"3.20000 m", "10.49869 ft"}, {"2.40000 m", "7.87402 ft"}};
    for (gsize k = 0; k < 2; k++) {
        TinkerDimension dimension = g_array_index(run->columns, TinkerColumn, k).dimension;
        assert_shown(physics_value(run, 0, k), dimension, shown[k][0], shown[k][1]);
    }
    TinkerBlockId block = tinker_scene_find_block(run->scene, "Mass 0");
    const TinkerBlockClass *block_class = tinker_scene_block_class(run->scene, block);
    static const char *const properties[2][3] = {{"mass", "1.00000 kg", "0.06852 slug"},
                                                 {"width", "0.80000 m", "2.62467 ft"}};
    for (gsize k = 0; k < 2; k++) {
        int32_t property = tinker_block_class_property(block_class, properties[k][0]);
        double value = tinker_scene_get(run->scene, block, block_class->first_columns[property]);
        assert_shown(value, block_class->properties[property].dimension, properties[k][1], properties[k][2]);
    }
}

/* --- libraries --- */

/* Must be the first scene of this process: libraries stay open. */
static void test_only_what_is_needed_is_opened(void)
{
    TinkerCatalogue *catalogue = scene_fixture_catalogue();
    g_autoptr(GPtrArray) before = tinker_catalogue_opened(catalogue);
    g_assert_cmpuint(before->len, ==, 0);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.columns = "Mass 0.y"}, "{'type': 'mass'}, {'type': 'gravity'}");
    physics_assert_near("y", physics_last(run, 0), -9.81 / 2, 1e-13);
    g_autoptr(GPtrArray) opened = tinker_catalogue_opened(catalogue);
    g_assert_cmpuint(opened->len, ==, 2);
    g_autofree char *first = g_path_get_basename(g_ptr_array_index(opened, 0));
    g_autofree char *second = g_path_get_basename(g_ptr_array_index(opened, 1));
    g_assert_cmpstr(first, ==, "tinker-mass.so");
    g_assert_cmpstr(second, ==, "tinker-gravity.so");
}

static void add_tests(void)
{
    g_test_add_func("/physics/record/only-what-is-needed-is-opened", test_only_what_is_needed_is_opened);
    g_test_add_func("/physics/record/spilling", test_spilling);
    g_test_add_func("/physics/record/cutting", test_cutting);
    g_test_add_func("/physics/record/read-while-growing", test_read_while_growing);
    g_test_add_func("/physics/record/times", test_times);
    g_test_add_func("/physics/record/column-errors", test_column_errors);
    g_test_add_func("/physics/record/columns", test_columns);
    g_test_add_func("/physics/record/shown-in-both-systems", test_shown_in_both_systems);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

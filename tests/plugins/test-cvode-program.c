/* The method cvode-bdf through the program, and the program without it. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "program.h"

static char *scene_file(const char *folder, const char *text)
{
    g_autoptr(GError) error = NULL;
    char *path = g_build_filename(folder, "scene.tinker.json", NULL);
    g_file_set_contents(path, text, -1, &error);
    g_assert_no_error(error);
    return path;
}

static char *new_folder(void)
{
    g_autoptr(GError) error = NULL;
    char *folder = g_dir_make_tmp("tinker-cvode-XXXXXX", &error);
    g_assert_no_error(error);
    return folder;
}

static const char oscillator_scene[] =
    "{\"tinker\": 1, \"run\": {\"duration\": 2, \"interval\": 0.01, \"method\": \"cvode-bdf\", \"tolerance\": 1e-8},"
    " \"blocks\": [{\"type\": \"support\"}, {\"type\": \"mass\", \"position\": [3, 0]},"
    "  {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100, \"rest_length\": 2}]}";

static void test_program(void)
{
    const char *options[] = {NULL};
    g_autofree char *folder = new_folder(), *scene = scene_file(folder, oscillator_scene);
    g_autoptr(TestSceneRun) run = test_scene_run(scene, options);
    for (gsize row = 0; row < run->record->rows; row++)
        g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, "Mass 0.x"),
                                       2.0 + cos(10.0 * test_table_value(run->record, row, "time")), 1e-5);
    g_remove(scene);
    g_rmdir(folder);
}

/* A chain of rods that is long enough for the sparse path, let go from the horizontal: every rod keeps its length and
 * no energy is lost. */
static void test_many_rods(void)
{
    const int rods = 140;
    g_autoptr(GString) text = g_string_new("{\"tinker\": 1, \"run\": {\"duration\": 1, \"interval\": 0.1, \"method\": "
                                           "\"cvode-bdf\", \"tolerance\": 1e-7}, \"blocks\": [{\"type\": \"gravity\"}, "
                                           "{\"type\": \"support\", \"name\": \"0\"}");
    for (int i = 1; i <= rods; i++)
        g_string_append_printf(text,
                               ", {\"type\": \"mass\", \"name\": \"%d\", \"position\": [%g, 0]}, "
                               "{\"type\": \"rod\", \"ends\": [\"%d\", \"%d\"]}",
                               i, 0.1 * i, i - 1, i);
    g_string_append(text, "]}");
    const char *cvode_options[] = {NULL}, *other_options[] = {"--method", "dop853", "--tolerance", "1e-10", NULL};
    g_autofree char *folder = new_folder(), *scene = scene_file(folder, text->str),
                    *tip = g_strdup_printf("%d.y", rods);
    g_autoptr(TestSceneRun) run = test_scene_run(scene, cvode_options);
    g_autoptr(TestSceneRun) other = test_scene_run(scene, other_options);
    const gsize last = run->record->rows - 1;
    g_assert_cmpfloat_with_epsilon(test_table_value(run->record, last, tip), test_table_value(other->record, last, tip),
                                   1e-3);
    for (int i = 1; i <= rods; i++) {
        g_autofree char *x = g_strdup_printf("%d.x", i), *y = g_strdup_printf("%d.y", i);
        g_autofree char *last_x = g_strdup_printf("%d.x", i - 1), *last_y = g_strdup_printf("%d.y", i - 1);
        double from_x = i > 1 ? test_table_value(run->record, last, last_x) : 0.0;
        double from_y = i > 1 ? test_table_value(run->record, last, last_y) : 0.0;
        double length =
            hypot(test_table_value(run->record, last, x) - from_x, test_table_value(run->record, last, y) - from_y);
        g_assert_cmpfloat_with_epsilon(length, 0.1, 1e-12);
    }
    g_remove(scene);
    g_rmdir(folder);
}

static void copy_file(const char *from, const char *to, int mode)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *bytes = NULL;
    gsize length;
    g_file_get_contents(from, &bytes, &length, &error);
    g_assert_no_error(error);
    g_file_set_contents(to, bytes, (gssize)length, &error);
    g_assert_no_error(error);
    g_assert_cmpint(g_chmod(to, mode), ==, 0);
}

/* The program alone in a folder, with a few blocks and without this plugin: the method is missing, and nothing else. */
static void test_without_plugin(void)
{
    static const char *const blocks[] = {"tinker-mass.so", "tinker-support.so", "tinker-spring.so"};
    g_autofree char *folder = new_folder(), *scene = scene_file(folder, oscillator_scene);
    g_autofree char *program = g_build_filename(folder, "tinker", NULL), *usual = g_strdup(g_getenv("TINKER_PROGRAM"));
    copy_file(usual, program, 0755);
    for (gsize i = 0; i < G_N_ELEMENTS(blocks); i++) {
        g_autofree char *from = g_build_filename(g_getenv("TINKER_TEST_PLUGINS"), blocks[i], NULL);
        g_autofree char *to = g_build_filename(folder, blocks[i], NULL);
        copy_file(from, to, 0755);
    }
    g_autofree char *path = g_strdup(g_getenv("TINKER_PLUGIN_PATH"));
    g_setenv("TINKER_PROGRAM", program, TRUE);
    g_unsetenv("TINKER_PLUGIN_PATH");
    const char *missing[] = {"run", scene, "--plugins", folder, NULL};
    const char *present[] = {"run", scene, "--plugins", folder, "--method", "dop853", NULL};
    g_autoptr(TestProgram) refused = test_program_run(missing);
    g_autoptr(TestProgram) done = test_program_run(present);
    g_setenv("TINKER_PROGRAM", usual, TRUE);
    g_setenv("TINKER_PLUGIN_PATH", path, TRUE);
    g_assert_cmpint(refused->status, !=, 0);
    g_assert_nonnull(strstr(refused->error, "there is no method \"cvode-bdf\""));
    g_assert_nonnull(strstr(refused->error, "plugins"));
    g_assert_cmpstr(done->error, ==, "");
    g_assert_cmpint(done->status, ==, 0);
    for (gsize i = 0; i < G_N_ELEMENTS(blocks); i++) {
        g_autofree char *copy = g_build_filename(folder, blocks[i], NULL);
        g_remove(copy);
    }
    g_remove(program);
    g_remove(scene);
    g_rmdir(folder);
}

/* A mass of 1 kg on a spring of 1e12 N/m, whose length rounds to forces of 1e-4 N, under a load of 1000 (1 - cos 2 pi
 * t) N: at the end it is back at x = 1 m, to what the tolerance allows. (The energies are too small for their balance
 * to tell anything, as the guard says.) */
static void test_rounding_of_stiff_spring(void)
{
    static const char *const tolerances[] = {"1e-6", "1e-8"};
    g_autofree char *scene =
        g_build_filename(g_getenv("TINKER_SOURCES"), "tests", "reference", "D02_stiff_quasistatic.tinker.json", NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++) {
        const char *arguments[] = {"run",  scene,   "--method", "cvode-bdf",   "--no-estimate", "--columns",
                                   "m1.x", "--csv", "-",        "--tolerance", tolerances[i],   NULL};
        g_autoptr(TestProgram) program = test_program_run(arguments);
        if (program->status != 0) g_test_message("%s", program->error);
        g_assert_cmpint(program->status, ==, 0);
        const char *end = strstr(program->output, "\n10,");
        g_assert_nonnull(end);
        g_assert_cmpfloat_with_epsilon(g_ascii_strtod(end + 4, NULL), 1.0, g_ascii_strtod(tolerances[i], NULL));
    }
}

/* Where a damper of 1e12 N s/m holds a length, nobody waits for explicit steps of 1e-12 s: the motion is that on a rod,
 * but for g / 1e12 of its length a second. */
static void test_automatic_where_damped(void)
{
    static const char *const holders[] = {"{\"type\": \"rod\"",
                                          "{\"type\": \"spring\", \"stiffness\": 25, \"ends\": [\"Wall\", \"M\"]}, "
                                          "{\"type\": \"damper\", \"damping\": 1e12"};
    const char *options[] = {NULL};
    double angle[G_N_ELEMENTS(holders)];
    g_autofree char *folder = new_folder();
    for (gsize i = 0; i < G_N_ELEMENTS(holders); i++) {
        g_autofree char *text = g_strdup_printf(
            "{\"tinker\": 1, \"run\": {\"duration\": 2, \"interval\": 1}, \"blocks\": [{\"type\": \"gravity\"}, "
            "{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false}, "
            "{\"type\": \"mass\", \"name\": \"M\", \"position\": [1, -1]}, %s, \"ends\": [\"Wall\", \"M\"]}]}",
            holders[i]);
        g_autofree char *scene = scene_file(folder, text);
        g_autoptr(TestSceneRun) run = test_scene_run(scene, options);
        const gsize last = run->record->rows - 1;
        angle[i] = atan2(test_table_value(run->record, last, "M.x"), -test_table_value(run->record, last, "M.y"));
        g_remove(scene);
    }
    g_assert_cmpfloat_with_epsilon(angle[1], angle[0], 2e-6);
    g_rmdir(folder);
}

/* What the belt, at 1 m/s, gave to the mass on it by the end, at 2 s, in a scene with this mass and spring. */
static double work_of_belt(const char *mass, const char *spring)
{
    const char *options[] = {NULL};
    g_autofree char *text = g_strdup_printf(
        "{\"tinker\": 1, \"run\": {\"duration\": 2, \"interval\": 0.5, \"method\": \"cvode-bdf\", \"tolerance\": 1e-9},"
        " \"blocks\": [{\"type\": \"gravity\", \"acceleration\": 10},"
        " {\"type\": \"support\", \"name\": \"Belt\", \"width\": 100, \"height\": 0, \"static_friction\": 0.5,"
        "  \"dynamic_friction\": 0.5}, {\"type\": \"support-motion\", \"ends\": [\"Belt\"], \"waveform\": "
        "{\"expression\": \"t\"}},"
        " {\"type\": \"mass\", \"name\": \"Mass\", \"height\": 0, %s},"
        " {\"type\": \"spring\", \"ends\": [\"Wall\", \"Mass\"], \"stiffness\": 2, %s]}",
        mass, spring);
    g_autofree char *folder = new_folder(), *scene = scene_file(folder, text);
    g_autoptr(TestSceneRun) run = test_scene_run(scene, options);
    const cJSON *energy = cJSON_GetObjectItem(run->summary, "energy");
    g_assert_cmpfloat(test_summary_number(run, "energy_balance_error"), <, 1e-7);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(run->summary, "warnings")), ==, 0);
    g_remove(scene);
    g_rmdir(folder);
    return cJSON_GetNumberValue(cJSON_GetObjectItem(energy, "support_motion"));
}

/* A mass that sticks to a belt moves evenly, which takes few steps, and the belt works all the while against a spring.
 *
 * Behind it: 1 kg slips at first, pushed by 5 N; x = 2.5 (1 - cos wt) with w^2 = 2 reaches 1 m/s at t1 = asin(1 / 2.5
 * w) / w. Up to then the belt gives 5 N 1 m/s, from there on what the spring stores. Beside it, unstretched at 0.3 m
 * and 0.5 m off the belt: the mass goes along from the start, past the wall, and the belt gives what the spring has
 * more at the end. */
static void test_belt(void)
{
    const double w = sqrt(2), t1 = asin(1 / (2.5 * w)) / w, x1 = 2.5 * (1 - cos(w * t1)), x2 = x1 + 2 - t1;
    double behind = work_of_belt("\"position\": [0, 0]",
                                 "\"rest_length\": 2}, {\"type\": \"support\", \"name\": \"Wall\", \"solid\": false, "
                                 "\"position\": [-2, 0]}");
    g_assert_cmpfloat_with_epsilon(behind, 5 * t1 + x2 * x2 - x1 * x1, 1e-7);
    double from = hypot(0.7, 0.5) - 0.3, to = hypot(1.3, 0.5) - 0.3;
    double beside = work_of_belt("\"position\": [0, 0], \"velocity\": [1, 0]",
                                 "\"rest_length\": 0.3}, {\"type\": \"support\", \"name\": \"Wall\", \"solid\": false, "
                                 "\"position\": [0.7, 0.5]}");
    g_assert_cmpfloat_with_epsilon(beside, to * to - from * from, 1e-7);
}

#define TABLE                                                                                                          \
    "{\"tinker\": 1, \"run\": {\"duration\": 1, \"interval\": 0.1, \"tolerance\": 1e-7}, \"blocks\": "                 \
    "[{\"type\": \"gravity\"}, {\"type\": \"support\", \"name\": \"Top\", \"width\": 20, "

/* Two masses on a rod land on a rough slope, slide down it under a force to and fro, stop at one instant and stick
 * again; two masses on a rod bounce ever less on a floor; a mass on a spring sticks to a table that is shaken. */
static const char *const contact_scenes[] = {
    TABLE
    "\"orientation\": -0.14, \"static_friction\": 0.64, \"dynamic_friction\": 0.55}, {\"type\": \"mass\", \"name\": "
    "\"a\", \"position\": [-0.27, 1.09], \"velocity\": [0.49, -0.33], \"width\": 0.1, \"height\": 0, \"mass\": 0.36}, "
    "{\"type\": \"mass\", \"name\": \"b\", \"position\": [0.27, 1.94], \"velocity\": [0.49, -0.33], \"width\": 0.1, "
    "\"height\": 0.1}, {\"type\": \"rod\", \"ends\": [\"a\", \"b\"]}, {\"type\": \"motor\", \"ends\": [\"b\"], "
    "\"angle\": "
    "1.1, \"waveform\": \"cosine\", \"amplitude\": 7.7, \"frequency\": 9.7, \"phase\": 1.9}]}",
    TABLE
    "\"restitution\": 0.06, \"static_friction\": 0.83, \"dynamic_friction\": 0.7}, {\"type\": \"mass\", \"name\": "
    "\"a\", "
    "\"position\": [-1, 0.91], \"height\": 0}, {\"type\": \"mass\", \"name\": \"b\", \"position\": [-0.31, 1.14], "
    "\"height\": 0}, {\"type\": \"rod\", \"ends\": [\"a\", \"b\"]}]}",
    TABLE
    "\"static_friction\": 1, \"dynamic_friction\": 0.85, \"height\": 0}, {\"type\": \"support-motion\", \"ends\": "
    "[\"Top\"], \"waveform\": {\"expression\": \"0.15*sin(7.6*t)\"}}, {\"type\": \"mass\", \"name\": \"a\", "
    "\"position\": "
    "[0, 0], \"height\": 0}, {\"type\": \"support\", \"name\": \"Wall\", \"position\": [-2.4, 0], \"solid\": false}, "
    "{\"type\": \"spring\", \"ends\": [\"Wall\", \"a\"], \"stiffness\": 30}]}",
};

/* The motion is that of dop853, and the books close; an event costs a start, not thousands of steps. */
static void test_contacts(void)
{
    const char *ours[] = {"--method", "cvode-bdf", NULL}, *theirs[] = {"--method", "dop853", NULL};
    for (gsize i = 0; i < G_N_ELEMENTS(contact_scenes); i++) {
        g_autofree char *folder = new_folder(), *scene = scene_file(folder, contact_scenes[i]);
        g_autoptr(TestSceneRun) run = test_scene_run(scene, ours);
        g_autoptr(TestSceneRun) other = test_scene_run(scene, theirs);
        for (gsize row = 0; row < run->record->rows; row++) {
            g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, "a.x"),
                                           test_table_value(other->record, row, "a.x"), 1e-4);
            g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, "a.y"),
                                           test_table_value(other->record, row, "a.y"), 1e-4);
        }
        g_assert_cmpfloat(test_summary_number(run, "energy_balance_error"), <, 1e-4);
        g_assert_cmpfloat(test_summary_number(run, "steps"), <, 2000);
        g_remove(scene);
        g_rmdir(folder);
    }
}

static void test_shown(void)
{
    const char *arguments[] = {"plugins", "show", "cvode-bdf", NULL}, *list[] = {"plugins", NULL};
    g_autoptr(TestProgram) shown = test_program_run(arguments);
    g_autoptr(TestProgram) listed = test_program_run(list);
    static const char *const parts[] = {"adaptive", "implicit", "SUNDIALS", "org.tinker.cvode-bdf",
                                        "tinker-cvode-bdf.so"};
    g_assert_cmpint(shown->status, ==, 0);
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        g_assert_nonnull(strstr(shown->output, parts[i]));
    g_assert_nonnull(strstr(listed->output, "\ncvode-bdf "));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plugins/cvode/program", test_program);
    g_test_add_func("/plugins/cvode/many-rods", test_many_rods);
    g_test_add_func("/plugins/cvode/rounding-of-stiff-spring", test_rounding_of_stiff_spring);
    g_test_add_func("/plugins/cvode-program/automatic-where-damped", test_automatic_where_damped);
    g_test_add_func("/plugins/cvode/belt", test_belt);
    g_test_add_func("/plugins/cvode/contacts", test_contacts);
    g_test_add_func("/plugins/cvode/shown", test_shown);
    g_test_add_func("/plugins/cvode/without-plugin", test_without_plugin);
    return g_test_run();
}

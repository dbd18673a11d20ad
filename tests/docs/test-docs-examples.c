/* What the documentation teaches: the plugins build with the SDK alone and move a mass as they should, the scenes of
 * the tutorials do what is worked out by hand there. */
#include <glib.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "author.h"
#include "folders.h"
#include "markdown.h"
#include "program.h"

/* 2 kg pushed with (3, 4) N from rest: x = 0.75 t^2, y = t^2, and the power is F . v = 1.5 * 3 t + 2 * 4 t. */
static void check_constant_force(const char *plugin_folder)
{
    g_autofree char *scene = markdown_source_path("docs/examples/constant-force/constant-force.tinker.json");
    const char *options[] = {"--plugins", plugin_folder, "--columns", "Mass 0.x,Mass 0.y,Constant Force 0.power", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(scene, options);
    const TestTable *record = run->record;
    g_assert_cmpuint(record->rows, ==, 21);
    for (gsize row = 0; row < record->rows; row++) {
        const double t = test_table_value(record, row, "time");
        g_assert_cmpfloat_with_epsilon(test_table_value(record, row, "Mass 0.x"), 0.75 * t * t, 1e-12);
        g_assert_cmpfloat_with_epsilon(test_table_value(record, row, "Mass 0.y"), t * t, 1e-12);
        g_assert_cmpfloat_with_epsilon(test_table_value(record, row, "Constant Force 0.power"), 12.5 * t, 1e-11);
    }
}

static void test_example_runs(void)
{
    check_constant_force(g_getenv("TINKER_DOCS_PLUGINS"));
}

static void test_example_states_its_law(void)
{
    g_autofree char *library = g_build_filename(g_getenv("TINKER_DOCS_PLUGINS"), "tinker-constant-force.so", NULL);
    test_author_states_laws(library);
}

static void test_example_is_drawn(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *folder = g_dir_make_tmp("tinker-picture-XXXXXX", &error);
    g_assert_no_error(error);
    g_autofree char *scene = markdown_source_path("docs/examples/constant-force/constant-force.tinker.json");
    g_autofree char *picture = g_build_filename(folder, "picture.svg", NULL);
    const char *arguments[] = {"render", scene, "--plugins", g_getenv("TINKER_DOCS_PLUGINS"), "-o", picture, NULL};
    g_autoptr(TestProgram) program = test_program_run(arguments);
    g_assert_cmpstr(program->error, ==, "");
    g_assert_cmpint(program->status, ==, 0);
    g_autofree char *svg = test_read_file(picture);
    g_assert_nonnull(strstr(svg, "<svg"));
    g_remove(picture);
    g_rmdir(folder);
}

/* The makefile, as the author of a plugin uses it, in a folder of its own. */
static void test_makefile_builds(void)
{
    g_autofree char *folder = test_author_folder();
    g_autofree char *makefile = markdown_source_path("docs/examples/constant-force/Makefile");
    g_autofree char *sources = markdown_source_path("docs/examples/constant-force");
    g_autofree char *search = g_strconcat("VPATH=", sources, NULL);
    const char *make[] = {"make", "-s", "-C", folder, "-f", makefile, search, NULL};
    test_author_run(folder, NULL, make);
    check_constant_force(folder);

    // It is installed where the program looks, wherever XDG_DATA_HOME says that is.
    g_autofree char *data = g_build_filename(folder, "data", NULL);
    g_autofree char *installed = g_build_filename(data, "tinker", "plugins", "tinker-constant-force.so", NULL);
    const char *install[] = {"make", "-s", "-C", folder, "-f", makefile, search, "install", NULL};
    test_author_run(folder, data, install);
    g_assert_true(g_file_test(installed, G_FILE_TEST_IS_REGULAR));
    test_remove_all(folder);
}

/* The largest error of x = 2 + 0.5 e^(-t/5) (cos wt + sin(wt) / 5w), w^2 = 4 - 1/25, with this step. */
static double oscillator_error(const char *plugin_folder, const char *step)
{
    const double omega = sqrt(4.0 - 0.04);
    g_autofree char *scene = markdown_source_path("docs/examples/adams-bashforth/oscillator.tinker.json");
    const char *options[] = {"--plugins", plugin_folder, "--step", step, "--columns", "Mass 0.x", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(scene, options);
    double largest = 0.0;
    g_assert_cmpuint(run->record->rows, ==, 51);
    for (gsize row = 0; row < run->record->rows; row++) {
        const double t = test_table_value(run->record, row, "time");
        const double exact = 2.0 + 0.5 * exp(-0.2 * t) * (cos(omega * t) + 0.2 / omega * sin(omega * t));
        largest = fmax(largest, fabs(test_table_value(run->record, row, "Mass 0.x") - exact));
    }
    return largest;
}

/* The integrator, built as its author does, keeps its order: between its steps, too, as 0.1 s is no multiple of them.
 */
static void test_integrator_builds(void)
{
    static const char *const steps[] = {"0.016", "0.008", "0.004", "0.002"};
    g_autofree char *folder = test_author_folder(), *build = g_build_filename(folder, "build", NULL);
    g_autofree char *sources = markdown_source_path("docs/examples/adams-bashforth");
    const char *setup[] = {"meson", "setup", build, sources, NULL},
               *compile[] = {"meson", "compile", "-C", build, NULL};
    test_author_run(folder, NULL, setup);
    test_author_run(folder, NULL, compile);
    double last = 0.0;
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        const double error = oscillator_error(build, steps[i]);
        g_test_message("step %s s: error %.2e m", steps[i], error);
        if (i > 0) g_assert_cmpfloat_with_epsilon(log2(last / error), 2.0, 0.15);
        last = error;
    }
    test_remove_all(folder);
}

/* The scenes of the tutorial run, but for the one with the mistake. */
static void test_tutorial_runs(void)
{
    static const char *const scenes[] = {"1-falls", "2-hangs", "3-damped"};
    const char *options[] = {NULL};
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        g_autofree char *file = g_strdup_printf("docs/examples/first-scene/%s.tinker.json", scenes[i]);
        g_autofree char *path = markdown_source_path(file);
        g_autoptr(TestSceneRun) run = test_scene_run(path, options);
        g_assert_cmpuint(run->record->rows, >, 100);
    }
}

/* What the tutorials of the window say that their scenes do, by formulas, sample by sample. */
typedef double (*ClosedForm)(double t);

static double of_spring(double t)
{
    return -0.7924 - 0.6076 * cos(5 * t);
}

static double of_shaken_support(double t)
{
    return -0.7924 + 0.05 * 25 / 9 * (sin(4 * t) - 0.8 * sin(5 * t));
}

static double of_resonance(double t)
{
    return -0.7924 + 0.025 * (sin(5 * t) - 5 * t * cos(5 * t));
}

static void test_window_tutorials(void)
{
    static const struct {
        const char *scene;
        ClosedForm y;
    } cases[] = {{"spring-mass-window/3-stretched", of_spring},
                 {"support-motion-window/1-shaken", of_shaken_support},
                 {"support-motion-window/2-resonance", of_resonance}};
    const char *options[] = {"--columns", "Mass 0.y", NULL};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *file = g_strdup_printf("docs/examples/%s.tinker.json", cases[i].scene);
        g_autofree char *path = markdown_source_path(file);
        g_autoptr(TestSceneRun) run = test_scene_run(path, options);
        g_assert_cmpuint(run->record->rows, ==, 1001);
        for (gsize row = 0; row < run->record->rows; row++) {
            const double t = test_table_value(run->record, row, "time");
            g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, "Mass 0.y"), cases[i].y(t), 1e-8);
        }
    }
}

/* Resonance with a damper: by 15 s the own motion is down to e^-7.5 of it. */
static void test_window_tutorial_damped(void)
{
    g_autofree char *path = markdown_source_path("docs/examples/support-motion-window/3-damped.tinker.json");
    const char *options[] = {"--columns", "Mass 0.y", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    double least = INFINITY, most = -INFINITY;
    for (gsize row = 0; row < run->record->rows; row++) {
        const double y = test_table_value(run->record, row, "Mass 0.y");
        if (test_table_value(run->record, row, "time") < 15) continue;
        least = fmin(least, y);
        most = fmax(most, y);
    }
    g_assert_cmpfloat_with_epsilon((most - least) / 2, 0.05 * sqrt(26), 1e-3);
}

/* A block on an incline: what the tutorial works out by hand, until it is over the end after 5 m. */
static void test_incline_tutorial(void)
{
    const double g = 9.81, normal = 2 * g * sqrt(0.75), a = g * (0.5 - 0.3 * sqrt(0.75)), end = sqrt(10 / a);
    g_autofree char *path = markdown_source_path("docs/examples/incline/block-on-incline.tinker.json");
    const char *options[] = {"--columns", "Block.normal force,Block.friction force,Block.acceleration,Block.speed",
                             NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    for (gsize row = 0; row < run->record->rows; row++) {
        const double t = test_table_value(run->record, row, "time");
        const gboolean slides = t < end;
        const struct {
            const char *column;
            double value;
        } columns[] = {{"Block.normal force", slides ? normal : 0},
                       {"Block.friction force", slides ? 0.3 * normal : 0},
                       {"Block.acceleration", slides ? a : g}};
        for (gsize i = 0; i < G_N_ELEMENTS(columns); i++)
            g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, columns[i].column), columns[i].value,
                                           1e-9);
        if (slides) g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, "Block.speed"), a * t, 1e-8);
    }
    g_assert_cmpfloat_with_epsilon(end, 2.06009, 5e-6); /* as the tutorial has it */
}

/* A slider-crank: what the tutorial works out by hand at 0, 90 and 180 degrees of the crank; nothing to warn of. */
static void test_mechanism_tutorial(void)
{
    const double r = 0.5, l = 1.5, w = 10;
    const struct {
        double place, acceleration;
    } expected[] = {{r + l, -r * w * w * (1 + r / l)},
                    {sqrt(l * l - r * r), r * r * w * w / sqrt(l * l - r * r)},
                    {l - r, r * w * w * (1 - r / l)}};
    g_autofree char *path = markdown_source_path("docs/examples/mechanism/slider-crank.tinker.json");
    const char *options[] = {"--at", "0,0.15707963267948966,0.3141592653589793", "--columns",
                             "Piston.x,Piston.ax,Drive.torque", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    g_assert_cmpuint(run->record->rows, ==, G_N_ELEMENTS(expected));
    for (gsize row = 0; row < run->record->rows; row++) {
        g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, "Piston.x"), expected[row].place, 1e-9);
        g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, "Piston.ax"), expected[row].acceleration,
                                       1e-6);
    }
    g_assert_cmpfloat_with_epsilon(test_table_value(run->record, 2, "Drive.torque"), 0, 1e-6);
    const cJSON *warnings = cJSON_GetObjectItemCaseSensitive(run->summary, "warnings");
    g_assert_cmpint(cJSON_GetArraySize(warnings), ==, 0);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/docs-examples/tutorial/runs", test_tutorial_runs);
    g_test_add_func("/docs-examples/tutorial/window", test_window_tutorials);
    g_test_add_func("/docs-examples/tutorial/incline", test_incline_tutorial);
    g_test_add_func("/docs-examples/tutorial/mechanism", test_mechanism_tutorial);
    g_test_add_func("/docs-examples/tutorial/window-damped", test_window_tutorial_damped);
    g_test_add_func("/docs-examples/example/runs", test_example_runs);
    g_test_add_func("/docs-examples/example/states-its-law", test_example_states_its_law);
    g_test_add_func("/docs-examples/example/is-drawn", test_example_is_drawn);
    g_test_add_func("/docs-examples/example/makefile-builds", test_makefile_builds);
    g_test_add_func("/docs-examples/integrator/builds", test_integrator_builds);
    return g_test_run();
}

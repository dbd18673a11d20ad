/* The documentation holds: its listings are the files they name and its outputs what the program prints, its links lead
 * somewhere, and the plugins that it teaches build with the SDK alone and move a mass as they should. */
#include <glib.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "author.h"
#include "markdown.h"
#include "program.h"

static char *source_path(const char *relative)
{
    return g_build_filename(g_getenv("TINKER_SOURCES"), relative, NULL);
}

static void add_piece(GHashTable *pieces, const char *path, const char *text)
{
    GString *whole = g_hash_table_lookup(pieces, path);
    if (whole == NULL) {
        g_hash_table_insert(pieces, g_strdup(path), g_string_new(text));
        return;
    }
    g_string_append_printf(whole, "\n%s", text);
}

static void free_piece(gpointer data)
{
    g_string_free(data, TRUE);
}

/* A file may be shown in pieces, in order; together they must be all of it. */
static guint check_listings(const char *document)
{
    g_autofree char *text = test_read_file(document), *folder = g_path_get_dirname(document);
    g_autoptr(GPtrArray) listings = markdown_listings(text);
    g_autoptr(GHashTable) pieces = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, free_piece);
    for (guint i = 0; i < listings->len; i++) {
        const MarkdownListing *listing = listings->pdata[i];
        if (strcmp(listing->kind, "listing") != 0) continue;
        g_autofree char *path = g_build_filename(folder, listing->argument, NULL);
        add_piece(pieces, path, listing->text);
    }
    GHashTableIter each;
    gpointer path, whole;
    g_hash_table_iter_init(&each, pieces);
    while (g_hash_table_iter_next(&each, &path, &whole)) {
        g_autofree char *file = test_read_file(path);
        if (strcmp(file, ((GString *)whole)->str) != 0) g_test_message("%s does not show %s", document, (char *)path);
        g_assert_cmpstr(file, ==, ((GString *)whole)->str);
    }
    return g_hash_table_size(pieces);
}

static void test_listings(void)
{
    g_autoptr(GPtrArray) documents = markdown_files(g_getenv("TINKER_SOURCES"));
    guint shown = 0;
    for (guint i = 0; i < documents->len; i++)
        shown += check_listings(documents->pdata[i]);
    g_assert_cmpuint(shown, >=, 5);
}

/* Runs the program in the folder that the mark names, as the reader would. */
static void check_output(const char *document, const MarkdownListing *listing)
{
    g_autofree char *beside = g_path_get_dirname(document);
    g_autofree char *folder = g_build_filename(beside, listing->folder, NULL);
    g_assert_cmpint(g_chdir(folder), ==, 0);
    g_autoptr(GError) error = NULL;
    g_auto(GStrv) arguments = NULL;
    g_shell_parse_argv(listing->argument, NULL, &arguments, &error);
    g_assert_no_error(error);
    g_assert_cmpstr(arguments[0], ==, "tinker");
    g_autoptr(TestProgram) program = test_program_run((const char *const *)arguments + 1);
    g_autofree char *printed = g_strconcat(program->output, program->error, NULL);
    g_assert_cmpstr(printed, ==, listing->text);
}

static void test_outputs(void)
{
    g_autoptr(GPtrArray) documents = markdown_files(g_getenv("TINKER_SOURCES"));
    guint seen = 0;
    for (guint i = 0; i < documents->len; i++) {
        g_autofree char *text = test_read_file(documents->pdata[i]);
        g_autoptr(GPtrArray) listings = markdown_listings(text);
        for (guint k = 0; k < listings->len; k++) {
            const MarkdownListing *listing = listings->pdata[k];
            if (strcmp(listing->kind, "output") != 0) continue;
            check_output(documents->pdata[i], listing);
            seen++;
        }
    }
    g_assert_cmpuint(seen, >, 0);
}

static void test_links(void)
{
    g_autoptr(GPtrArray) documents = markdown_files(g_getenv("TINKER_SOURCES"));
    for (guint i = 0; i < documents->len; i++) {
        g_autofree char *text = test_read_file(documents->pdata[i]);
        g_autofree char *folder = g_path_get_dirname(documents->pdata[i]);
        g_autoptr(GPtrArray) links = markdown_links(text);
        for (guint k = 0; k < links->len; k++) {
            g_autofree char *target = g_build_filename(folder, links->pdata[k], NULL);
            if (g_file_test(target, G_FILE_TEST_EXISTS)) continue;
            g_test_message("%s: no file %s", (char *)documents->pdata[i], (char *)links->pdata[k]);
            g_test_fail();
        }
    }
}

/* What a page of a method must tell; that of auto, which is no method of its own, needs no equation, and that of
 * impulse, which is asked for by `contacts`, no picture. */
static void check_method_page(const char *name, const char *page, const char *overview)
{
    static const char *const parts[] = {"\n## Order", "\n## Cost\n", "\n## When to take it", "\n## Source\n"};
    const gboolean chosen = strcmp(name, "auto") == 0 || strcmp(name, "impulse") == 0;
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        if (strstr(page, parts[i]) == NULL) g_test_message("%s: no part%s", name, parts[i]);
        g_assert_nonnull(strstr(page, parts[i]));
    }
    g_autofree char *picture = g_strconcat("(../images/stability-", name, ".png)", NULL);
    g_assert_true(chosen || (strstr(page, picture) != NULL && strstr(page, "\n## Equation\n") != NULL));
    g_autofree char *link = g_strconcat("(../methods/", name, ".md)", NULL);
    g_assert_nonnull(strstr(overview, link));
}

/* The methods that are linked in: the program tells them where it does not know one. (transfer full) */
static GStrv builtin_methods(void)
{
    g_autofree char *scene = source_path("host/scenes/pendulum.tinker.json");
    const char *arguments[] = {"run", scene, "--method", "unheard-of", NULL};
    g_autoptr(TestProgram) program = test_program_run(arguments);
    const char *first = strstr(program->error, "(there are "), *end = strstr(program->error, ", and of plugins");
    g_assert_true(first != NULL && end != NULL);
    first += strlen("(there are ");
    g_autofree char *names = g_strndup(first, (gsize)(end - first));
    return g_strsplit(names, ", ", -1);
}

/* Each method that is linked in has a page, and each page tells of one of them or of a plugin. */
static void test_methods(void)
{
    g_auto(GStrv) names = builtin_methods();
    g_autofree char *overview_path = source_path("docs/reference/methods.md"), *folder = source_path("docs/methods");
    g_autofree char *overview = test_read_file(overview_path);
    for (char **name = names; *name != NULL; name++) {
        g_autofree char *file = g_strconcat(*name, ".md", NULL), *path = g_build_filename(folder, file, NULL);
        if (!g_file_test(path, G_FILE_TEST_EXISTS)) g_test_message("no page %s", path);
        g_assert_true(g_file_test(path, G_FILE_TEST_EXISTS));
    }
    g_autoptr(GError) error = NULL;
    g_autoptr(GDir) pages = g_dir_open(folder, 0, &error);
    g_assert_no_error(error);
    for (const char *file = g_dir_read_name(pages); file != NULL; file = g_dir_read_name(pages)) {
        g_assert_true(g_str_has_suffix(file, ".md"));
        g_autofree char *name = g_strndup(file, strlen(file) - 3), *path = g_build_filename(folder, file, NULL);
        g_autofree char *page = test_read_file(path);
        g_autofree char *plugin = g_strconcat("plugins/", name, NULL), *plugin_folder = source_path(plugin);
        g_assert_true(g_strv_contains((const char *const *)names, name) || g_str_equal(name, "impulse") ||
                      g_file_test(plugin_folder, G_FILE_TEST_IS_DIR));
        check_method_page(name, page, overview);
    }
}

/* 2 kg pushed with (3, 4) N from rest: x = 0.75 t^2, y = t^2, and the power is F . v = 1.5 * 3 t + 2 * 4 t. */
static void check_constant_force(const char *plugin_folder)
{
    g_autofree char *scene = source_path("docs/examples/constant-force/constant-force.tinker.json");
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
    g_autofree char *scene = source_path("docs/examples/constant-force/constant-force.tinker.json");
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
    g_autofree char *makefile = source_path("docs/examples/constant-force/Makefile");
    g_autofree char *sources = source_path("docs/examples/constant-force");
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
    g_autofree char *scene = source_path("docs/examples/adams-bashforth/oscillator.tinker.json");
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
    g_autofree char *sources = source_path("docs/examples/adams-bashforth");
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
        g_autofree char *path = source_path(file);
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
        g_autofree char *path = source_path(file);
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
    g_autofree char *path = source_path("docs/examples/support-motion-window/3-damped.tinker.json");
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
    g_autofree char *path = source_path("docs/examples/incline/block-on-incline.tinker.json");
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
    g_autofree char *path = source_path("docs/examples/mechanism/slider-crank.tinker.json");
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

/* Every bundled scene serves a concept. */
static void test_concepts(void)
{
    static const char suffix[] = ".tinker.json";
    g_autofree char *page_path = source_path("docs/concepts.md"), *folder = source_path("host/scenes");
    g_autofree char *page = test_read_file(page_path);
    g_autoptr(GDir) scenes = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(scenes);
    for (const char *file = g_dir_read_name(scenes); file != NULL; file = g_dir_read_name(scenes)) {
        if (!g_str_has_suffix(file, suffix)) continue;
        g_autofree char *named = g_strdup_printf("`%.*s`", (int)(strlen(file) - strlen(suffix)), file);
        if (strstr(page, named) == NULL) g_test_message("%s is not in docs/concepts.md", named);
        g_assert_nonnull(strstr(page, named));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/docs/listings", test_listings);
    g_test_add_func("/docs/outputs", test_outputs);
    g_test_add_func("/docs/links", test_links);
    g_test_add_func("/docs/methods", test_methods);
    g_test_add_func("/docs/concepts", test_concepts);
    g_test_add_func("/docs/tutorial/runs", test_tutorial_runs);
    g_test_add_func("/docs/tutorial/window", test_window_tutorials);
    g_test_add_func("/docs/tutorial/incline", test_incline_tutorial);
    g_test_add_func("/docs/tutorial/mechanism", test_mechanism_tutorial);
    g_test_add_func("/docs/tutorial/window-damped", test_window_tutorial_damped);
    g_test_add_func("/docs/example/runs", test_example_runs);
    g_test_add_func("/docs/example/states-its-law", test_example_states_its_law);
    g_test_add_func("/docs/example/is-drawn", test_example_is_drawn);
    g_test_add_func("/docs/example/makefile-builds", test_makefile_builds);
    g_test_add_func("/docs/integrator/builds", test_integrator_builds);
    return g_test_run();
}

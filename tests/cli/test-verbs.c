/* Verbs beside run, check and those that draw: what they write, and the help of all. */
#include <string.h>

#include "fixture.h"

static void test_help(CliFixture *fixture, gconstpointer data)
{
    static const char *const verbs[] = {"run",     "graph",   "render",       "animate",           "check",
                                        "convert", "plugins", "plugins show", "plugins describe",  "plugins refused",
                                        "bench",   "plan",    "equations",    "diagram",           "books",
                                        "demo",    "trade",   "plugins new",  "plugins new-bundle"};
    g_autoptr(TestProgram) all = cli_run_well(fixture, "--help");
    for (gsize i = 0; i < G_N_ELEMENTS(verbs); i++) {
        g_autofree char *words = g_strdup_printf("%s --help", verbs[i]);
        g_autofree char *usage = g_strdup_printf("tinker %s", verbs[i]);
        g_autoptr(TestProgram) help = cli_run_well(fixture, words);
        cli_assert_holds(help->output, usage);
        cli_assert_holds(help->output, "Examples:");
        if (strchr(verbs[i], ' ') == NULL) cli_assert_holds(all->output, verbs[i]);
    }
    g_autoptr(TestProgram) version = cli_run_well(fixture, "--version");
    g_assert_true(g_str_has_prefix(version->output, "tinker "));
    g_autoptr(TestProgram) nothing = cli_run_badly(fixture, "", 2);
}

static void test_convert(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) normal = cli_run_well(fixture, "convert @a.json --units SI -o @si.json");
    g_autoptr(TestProgram) english = cli_run_well(fixture, "convert @si.json --units English -o @english.json");
    g_autoptr(TestProgram) back = cli_run_well(fixture, "convert @english.json --units SI -o -");
    g_autofree char *first = cli_read(fixture, "si.json");
    g_autofree char *middle = cli_read(fixture, "english.json");
    g_assert_cmpstr(back->output, ==, first);
    cli_assert_holds(middle, " ft\"");
    cli_assert_holds(middle, " lbf/ft\"");
    g_autoptr(TestProgram) nowhere = cli_run_badly(fixture, "convert @a.json -o @none/b.json", 5);
    g_autoptr(TestProgram) metric = cli_run_badly(fixture, "convert @a.json --units metric", 2);
}

static void test_plugins(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) list = cli_run_well(fixture, "plugins");
    static const char *const types[] = {"mass",           "support", "spring", "damper", "rod", "motor",
                                        "support-motion", "gravity", "wind",   "marker", "rope"};
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        g_autofree char *row = g_strdup_printf("\n%s ", types[i]);
        cli_assert_holds(list->output, row);
    }
    cli_assert_holds(list->output, "tinker-spring.so");
    g_autoptr(TestProgram) show = cli_run_well(fixture, "plugins show spring");
    static const char *const parts[] = {"Spring",    "stiffness", "N/m",      "lbf/ft", "rest_length",
                                        "as placed", "tension",   "line law", "MIT"};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        cli_assert_holds(show->output, parts[i]);
    g_autoptr(TestProgram) mass = cli_run_well(fixture, "plugins show mass");
    static const char *const mass_parts[] = {"\"on\": NAME", "\"along\"", "normal force", "friction force",
                                             "acceleration "};
    for (gsize i = 0; i < G_N_ELEMENTS(mass_parts); i++)
        cli_assert_holds(mass->output, mass_parts[i]);
    g_assert_null(strstr(show->output, "\"on\""));
    cli_assert_holds(list->output, "\nrk4 ");
    g_autoptr(TestProgram) method = cli_run_well(fixture, "plugins show rk4 spring");
    static const char *const method_parts[] = {
        "rk4", "fixed steps, explicit", "2.828", "2.785", "built in", "Kutta", "stiffness"};
    for (gsize i = 0; i < G_N_ELEMENTS(method_parts); i++)
        cli_assert_holds(method->output, method_parts[i]);
    g_autoptr(TestProgram) unknown = cli_run_badly(fixture, "plugins show sprng", 4);
    cli_assert_holds(unknown->error, "did you mean \"spring\"");
    g_autoptr(TestProgram) unknown_method = cli_run_badly(fixture, "plugins show dop583", 4);
    cli_assert_holds(unknown_method->error, "did you mean the method \"dop853\"");
    g_autoptr(TestProgram) verb = cli_run_badly(fixture, "plugins shwo spring", 2);
    cli_assert_holds(verb->error, "did you mean \"show\"");
    g_autoptr(TestProgram) refused = cli_run_well(fixture, "plugins refused --clear");
    cli_assert_holds(refused->output, "forgotten");
}

static void test_describe(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *library = g_build_filename(g_getenv("TINKER_TEST_PLUGINS"), "tinker-spring.so", NULL);
    g_autofree char *words = g_strdup_printf("plugins describe '%s' --output -", library);
    g_autoptr(TestProgram) program = cli_run_well(fixture, words);
    cJSON *manifest = cJSON_Parse(program->output);
    g_assert_nonnull(manifest);
    const cJSON *type = cJSON_GetArrayItem(cJSON_GetObjectItem(manifest, "types"), 0);
    g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(type, "id")), ==, "spring");
    cJSON_Delete(manifest);

    /* beside the library, with its ending exchanged */
    g_autofree char *copy = cli_path(fixture, "copy.so");
    g_autofree char *bytes = NULL;
    gsize length = 0;
    g_assert_true(g_file_get_contents(library, &bytes, &length, NULL));
    g_assert_true(g_file_set_contents(copy, bytes, (gssize)length, NULL));
    g_autoptr(TestProgram) beside = cli_run_well(fixture, "plugins describe @copy.so");
    g_autofree char *path = cli_path(fixture, "copy.manifest.json");
    cJSON_Delete(test_read_json(path));

    g_autofree char *text = cli_write(fixture, "text.so", "not a library");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "plugins describe @text.so", 4);
}

static void test_bench(CliFixture *fixture, gconstpointer data)
{
    static const char *const keys[] = {
        "method", "step", "ns_per_step", "evaluations_per_step", "ns_per_evaluation", "blocks", "steps_timed"};
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program =
        cli_run_well(fixture, "bench @a.json --method rk4 --step 0.002 --seconds 0.02 --json -");
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++)
        if (!cJSON_HasObjectItem(root, keys[i])) g_error("no key %s", keys[i]);
    g_assert_cmpint(cJSON_GetArraySize(root), ==, G_N_ELEMENTS(keys));
    /* the classical method has four stages */
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "evaluations_per_step")), ==, 4);
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "step")), ==, 0.002);
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "blocks")), ==, 3);
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "ns_per_step")), >, 0);
    cJSON_Delete(root);
    g_autoptr(TestProgram) table = cli_run_well(fixture, "bench @a.json --seconds 0.02");
    cli_assert_holds(table->output, "\nverlet ");
    cli_assert_holds(table->output, "\nrk4 ");
    g_autoptr(TestProgram) unknown = cli_run_badly(fixture, "bench @a.json --method rk5", 2);
}

static void test_demo(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = cli_run_well(fixture, "demo --output-folder @demo");
    cli_assert_begins(fixture, "demo/spring-mass.csv", "time [s],");
    cli_assert_begins(fixture, "demo/spring-mass-graph.svg", "<?xml");
    cli_assert_png_size(fixture, "demo/spring-mass-graph.png", 800, 500);
    cli_assert_png_size(fixture, "demo/spring-mass.png", 800, 600);
    g_auto(GStrv) lines = g_strsplit(g_strchomp(program->output), "\n", -1);
    g_assert_cmpuint(g_strv_length(lines), ==, 4);
    /* it swings 9.81 / 25 m about its rest: lowest point 2 - 2 * 0.3924, after half of 2 pi / 5 s */
    g_autofree char *csv = cli_read(fixture, "demo/spring-mass.csv");
    g_autoptr(TestTable) table = test_table_new(csv);
    double lowest = 2;
    for (gsize row = 0; row < table->rows; row++)
        lowest = MIN(lowest, test_table_value(table, row, "Mass 0.y"));
    g_assert_cmpfloat_with_epsilon(lowest, 2 - 2 * 9.81 / 25, 1e-4);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/verbs/help", test_help);
    cli_test_add("/verbs/convert", test_convert);
    cli_test_add("/verbs/plugins", test_plugins);
    cli_test_add("/verbs/describe", test_describe);
    cli_test_add("/verbs/bench", test_bench);
    cli_test_add("/verbs/demo", test_demo);
    return g_test_run();
}

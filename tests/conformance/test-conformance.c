/* The conformance kit: our own libraries and those of the documentation pass, and of a library with one planted fault
 * exactly one rule fails. */
#include <signal.h>
#include <string.h>

#include "program.h"

/* (transfer full) */
static cJSON *check(const char *path, int status)
{
    const char *arguments[] = {"plugins", "check", path, "--format", "json", "--seconds", "4", NULL};
    g_autoptr(TestProgram) program = test_program_run(arguments);
    if (program->status != status) g_test_message("%s%s", program->output, program->error);
    g_assert_cmpint(program->status, ==, status);
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    return root;
}

static const char *text_of(const cJSON *item, const char *key)
{
    return cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(item, key));
}

static double count_of(const cJSON *root, const char *key)
{
    return cJSON_GetNumberValue(cJSON_GetObjectItemCaseSensitive(root, key));
}

static void test_passes(gconstpointer data)
{
    cJSON *root = check(data, 0);
    g_assert_cmpfloat(count_of(root, "passed"), >=, 6);
    const cJSON *item;
    cJSON_ArrayForEach(
        item, cJSON_GetObjectItemCaseSensitive(root, "results")) if (strcmp(text_of(item, "outcome"), "skipped") == 0)
        g_assert_cmpstr(text_of(item, "text"), !=, "");
    cJSON_Delete(root);
}

/* The fault, and what is to be said of it. */
static const struct {
    const char *fault, *rule, *subject, *text;
    gboolean stops_runs; /* so that the rules that need a run fail, too */
} plants[] = {
    {"exports", "symbols", "", "it exports \"another_symbol\""},
    {"undescribed", "declaration", "planted-pull", "property \"stiffness\" has no description"},
    {"same_symbol", "declaration", "planted-pull",
     "properties \"stiffness\" and \"rest_length\" both have the symbol \"k\""},
    {"type_id", "declaration", "Planted Follow", "its id \"Planted Follow\" is not of small letters"},
    {"property_id", "declaration", "planted-follow", "a property's id \"thr ust\" is not of small letters"},
    {"plugin_id", "declaration", "", "the plugin's id is \"planted\"; a reversed domain was expected"},
    {"version", "declaration", "", "the plugin's version is \"one\"; three numbers were expected"},
    {"law_value", "law", "planted-pull", "\"tension\" is "},
    {"law_unit", "law", "planted-pull", "\"e\" of its law is in m, and is declared in m/s"},
    {"law_potential", "law", "planted-pull", "where its potential gives "},
    {"law_text", "law", "planted-pull",
     "its law cannot be read: tension = k*(L - LO) + c*rate: column 8: unknown name \"LO\"; did you mean \"L\"?"},
    {"law_missing", "law", "planted-pull", "its law says nothing of \"tension\""},
    {"blow_value", "law", "planted-knock", "\"impulse\" is "},
    {"blow_missing", "law", "planted-knock", "its law says nothing of \"impulse_y\""},
    {"first", "batches", "planted-pull", "in a slice of 1 from 7 on"},
    {"remembers", "batches", "planted-pull", "when it is called again with the same values"},
    {"nan", "finite", "planted-pull", "\"tension\" of instance 0 is nan at coincident ends"},
    {"quotient", "finite", "planted-pull",
     "\"tension\" of instance 0 is nan at coincident ends and the least of stiffness (stiffness = 0, "},
    {"body_nan", "finite", "planted-gather",
     "force: \"force\" of body 0 is nan at coincident ends (24 instances together, body 0 of "},
    {"scale", "finite", "planted-hold", "scale: \"length\" of instance 0 is -1 at ordinary values, which no length is",
     .stops_runs = TRUE},
    {"exit", "finite", "planted-pull",
     "ended the process in tension at coincident ends (the first of 24 instances has stiffness = "},
    {"ends_well", "finite", "planted-pull", "), with status 77"},
    {"abort", "finite", "planted-pull", "crashed: SIGABRT in tension at coincident ends"},
    {"crash", "finite", "planted-pull", "crashed: SIGSEGV in tension at coincident ends"},
    {"hang", "finite", "planted-pull", "hung: not done within 4 s in tension at coincident ends"},
    {"unbalanced", "momentum", "planted-pair", "the forces sum to"},
    {"blow_unbalanced", "momentum", "planted-clap", "the impulses of its blow sum to"},
    {"moment", "moment", "planted-pair", "the forces have the moment"},
    {"place", "translation", "planted-pair", "with the scene shifted"},
    {"origin", "translation", "planted-pair", "with batch->origin at (6.5, -9.25) m"},
    {"direction", "rotation", "planted-pair", "with the scene turned"},
    {"alone", "coupling", "planted-gather",
     "with nobody else there: it depends on other bodies, so couples_bodies = 1 "},
    {"slope", "energy", "planted-pull", "where the gradient of the energy is"},
    {"gives", "passive", "planted-pull", "what depends on velocity gives"},
    {"sign", "derivatives", "planted-pull", "by_rate of instance 0"},
    {"jacobian", "jacobian", "planted-keep", "row 0: d g / d x of end 1"},
    {"drift", "drift", "planted-keep", "drift of instance 0"},
    {"speed", "motion", "planted-sway", "the x velocity of instance 0"},
    {"form", "linear", "planted-pull", "by the short form"},
    {"distance", "linear", "planted-keep", "by the short form"},
    {"break", "breaks", "planted-pull", "a later time was expected", .stops_runs = TRUE},
    {"constant", "dimensions", "planted-pull", "a constant hides in the law"},
    {"far_nan", "dimensions", "planted-pull", ", but not finite in units of 1 kg, 0.125 m and 1 s (stiffness = "},
    {"quantity_beyond", "memory", "planted-pull", "the quantity \"force\" writes beyond the end of \"values\""},
    {"writes_beyond", "memory", "planted-pull", "tension writes beyond the end of \"tension\""},
    {"writes_before", "memory", "planted-pull", "tension writes before the beginning of \"tension\""},
    {"reads_beyond", "memory", "planted-pull", "tension reads beyond the end of \"rate\""},
    {"writes_input", "memory", "planted-pull", "tension writes to its input \"length\""},
    {"allots", "quiet", "planted-pull", "tension calls malloc"},
    {"prints", "quiet", "planted-pull", "tension calls puts"},
    {"prints_checked", "quiet", "planted-pull", "tension calls printf"},
    {"masks", "process", "planted-pull", "tension changes the umask"},
    {"prepares_umask", "process", "planted-pull", "prepare changes the umask"},
    {"opens_locale", "process", "", "opening it changes the locale"},
    {"ink", "bounds", "planted-pull", "outside its bounds"},
    {"saves", "bounds", "planted-pull", "its drawing calls cairo_save and cairo_restore differently often"},
    {"pushes", "bounds", "planted-pull", "its drawing leaves a group open"},
    {"breaks_cairo", "bounds", "planted-pull", "its drawing leaves cairo in the state \""},
    {"size_nan", "bounds", "planted-pull", "it draws a box with (x, y, width, height, orientation) = ("},
    {"unhittable", "hit", "planted-pull", "finds nothing"},
    {"freedoms", "descriptor", "", "its body has 1 degrees of freedom, 0, 2 or 3 was expected"},
    {"counts", "saved", "planted-pull", "runs to other bits"},
    {"counts_rows", "saved", "planted-hold", "runs to other bits"},
    {"order", "order", "planted-simple", "2 is declared"},
    {"timeless", "order", "planted-simple", "on a driven motion that is not linear"},
    {"overshoots", "steps", "planted-simple", "ends at"},
    {"misreports", "steps", "planted-simple", "reports a step of"},
    {"bold", "limits", "planted-simple",
     "with h omega = 2.25 an undamped oscillator grows, though imaginary_limit is 3"},
    {"endless", "limits", "planted-simple", "real_limit is -1, which says that there is no limit"},
    {"timid", "limits", "planted-simple",
     "with h c / m = 1 a pure damper does not grow, though real_limit is 0.5: the edge of stability lies farther out"},
    {"unprojected", "constrained", "planted-simple", "a pendulum's rod of 0.75 m is off by"},
    {"dense", "steps", "planted-simple", "interpolated at the end of a step"},
};

static char *planted_path(const char *fault)
{
    g_autofree char *name = g_strdup_printf("planted-%s.so", fault);
    return g_build_filename(g_getenv("TINKER_PLANTED"), name, NULL);
}

static gboolean needs_run(const char *rule)
{
    return strcmp(rule, "run") == 0 || strcmp(rule, "saved") == 0;
}

static void test_plant(gconstpointer data)
{
    const gsize number = GPOINTER_TO_SIZE(data);
    g_autofree char *path = planted_path(plants[number].fault);
    cJSON *root = check(path, 4);
    const cJSON *item;
    int failed = 0;
    cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(root, "results"))
    {
        if (strcmp(text_of(item, "outcome"), "failed") != 0) continue;
        g_test_message("%s %s: %s", text_of(item, "subject"), text_of(item, "rule"), text_of(item, "text"));
        if (plants[number].stops_runs && needs_run(text_of(item, "rule"))) continue;
        g_assert_cmpstr(text_of(item, "rule"), ==, plants[number].rule);
        g_assert_cmpstr(text_of(item, "subject"), ==, plants[number].subject);
        if (strstr(text_of(item, "text"), plants[number].text) == NULL)
            g_error("\"%s\" does not say \"%s\"", text_of(item, "text"), plants[number].text);
        g_assert_nonnull(strstr(text_of(item, "repeat"), "--seed 1"));
        g_assert_null(strstr(text_of(item, "text"), "itself"));
        failed++;
    }
    g_assert_cmpint(failed, ==, 1);
    cJSON_Delete(root);
}

/* The museum's plugins that go wrong while they run, and what the first failure says: to the last letter, but for the
 * values of the instance, which stand for "(...)". */
static const struct {
    const char *exhibit, *rule, *text;
} exhibits[] = {
    {"aborts", "batches", "crashed: SIGABRT in force at ordinary values (...)"},
    {"allocates", "quiet", "force calls malloc; the host calls it inside steps"},
    {"crashing-method", "batches", "crashed: SIGSEGV in a step at t = 0 s"},
    {"exits", "batches", "ended the process in force at ordinary values (...), with status 0"},
    {"overflows", "batches", "crashed: SIGSEGV in force at ordinary values (...)"},
    {"segfaults", "batches", "crashed: SIGSEGV in force at ordinary values (...)"},
    {"traps", "batches", "crashed: SIGILL in force at ordinary values (...)"},
    {"writes-out-of-range", "memory", "force writes beyond the end of \"force\""},
};

static void test_exhibit(gconstpointer data)
{
    const gsize number = GPOINTER_TO_SIZE(data);
    g_autofree char *name = g_strdup_printf("%s-exhibit.so", exhibits[number].exhibit);
    g_autofree char *path = g_build_filename(g_getenv("TINKER_EXHIBITS"), name, NULL);
    cJSON *root = check(path, 4);
    const cJSON *item, *first = NULL;
    cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(root, "results"))
    {
        if (strcmp(text_of(item, "outcome"), "failed") != 0) continue;
        if (first == NULL && strcmp(text_of(item, "rule"), "declaration") != 0) first = item;
    }
    g_assert_nonnull(first);
    g_assert_cmpstr(text_of(first, "rule"), ==, exhibits[number].rule);
    g_autoptr(GRegex) values = g_regex_new("\\((end 0 at|[a-z_]+ =) .*\\)", 0, 0, NULL);
    g_autofree char *text = g_regex_replace_literal(values, text_of(first, "text"), -1, 0, "(...)", 0, NULL);
    g_assert_cmpstr(text, ==, exhibits[number].text);
    cJSON_Delete(root);
}

/* The command that a failure names gives the same failure, to the last digit. */
static void test_repeated(void)
{
    g_autofree char *path = planted_path("slope");
    const char *arguments[] = {"plugins", "check",        path,     "--rule", "energy",
                               "--type",  "planted-pull", "--seed", "7",      NULL};
    g_autoptr(TestProgram) one = test_program_run(arguments), other = test_program_run(arguments);
    g_assert_cmpint(one->status, ==, 4);
    g_assert_cmpstr(one->output, ==, other->output);
    g_assert_nonnull(strstr(one->output, "seed 7"));
    arguments[8] = "8";
    g_autoptr(TestProgram) third = test_program_run(arguments);
    g_assert_cmpstr(one->output, !=, third->output);
}

static void test_usage(void)
{
    static const struct {
        const char *arguments[6];
        int status;
        const char *said;
    } rows[] = {
        {{"plugins", "check", "--list"}, 0, "dimensions"},
        {{"plugins", "check"}, 2, "a plugin file is needed"},
        {{"plugins", "check", "/nowhere.so"}, 5, "there is no such file"},
        {{"plugins", "check", "/nowhere.so", "--rule", "energies"}, 2, "energy"},
        {{"plugins", "check", "/etc/passwd"}, 4, "descriptor"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(TestProgram) program = test_program_run(rows[i].arguments);
        g_assert_cmpint(program->status, ==, rows[i].status);
        if (strstr(program->output, rows[i].said) == NULL && strstr(program->error, rows[i].said) == NULL)
            g_error("\"%s%s\" does not say \"%s\"", program->output, program->error, rows[i].said);
    }
    g_autofree char *path = planted_path("none");
    const char *no_type[] = {"plugins", "check", path, "--type", "nothing", NULL};
    g_autoptr(TestProgram) missing = test_program_run(no_type);
    g_assert_cmpint(missing->status, ==, 4);
    const char *tap[] = {"plugins", "check", path, "--format", "tap", NULL};
    g_autoptr(TestProgram) lines = test_program_run(tap);
    g_assert_cmpint(lines->status, ==, 0);
    g_assert_nonnull(strstr(lines->output, "\n1.."));
    g_assert_null(strstr(lines->output, "not ok"));
}

static void be_deaf(gpointer unused)
{
    signal(SIGCHLD, SIG_IGN);
}

/* Who starts the program may have asked not to hear of children that end, and the program inherits that. */
static void test_deaf_parent(void)
{
    g_autofree char *path = planted_path("none"), *output = NULL;
    char *arguments[] = {(char *)g_getenv("TINKER_PROGRAM"), (char *)"plugins", (char *)"check", path, NULL};
    g_autoptr(GError) error = NULL;
    int status = 0;
    g_spawn_sync(NULL, arguments, NULL, G_SPAWN_DEFAULT, be_deaf, NULL, &output, NULL, &status, &error);
    g_assert_no_error(error);
    g_assert_cmpint(status, ==, 0);
    g_assert_null(strstr(output, "hung"));
    g_assert_null(strstr(output, " \n"));
}

/* What resists turning is tried between bodies that turn, whatever values it is given. */
static void test_friction(void)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_TEST_PLUGINS"), "tinker-pin.so", NULL);
    static const char *const rules[] = {"run", "saved"};
    for (int seed = 1; seed <= 4; seed++) {
        for (gsize i = 0; i < G_N_ELEMENTS(rules); i++) {
            g_autofree char *number = g_strdup_printf("%d", seed);
            const char *arguments[] = {"plugins", "check", path, "--rule", rules[i], "--seed", number, NULL};
            g_autoptr(TestProgram) program = test_program_run(arguments);
            g_assert_cmpint(program->status, ==, 0);
            g_assert_nonnull(strstr(program->output, "1 passed, 0 failed, 0 do not apply"));
        }
    }
}

static void add_folder(const char *folder)
{
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(dir);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_prefix(name, "tinker-") || !g_str_has_suffix(name, ".so")) continue;
        g_autofree char *test = g_strdup_printf("/conformance/passes/%s", name);
        g_test_add_data_func_full(test, g_build_filename(folder, name, NULL), test_passes, g_free);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    add_folder(g_getenv("TINKER_TEST_PLUGINS"));
    add_folder(g_getenv("TINKER_DOCS_PLUGINS"));
    add_folder(g_getenv("TINKER_PLANTED"));
    g_test_add_data_func_full("/conformance/passes/none", planted_path("none"), test_passes, g_free);
    for (gsize i = 0; i < G_N_ELEMENTS(plants); i++) {
        g_autofree char *test = g_strdup_printf("/conformance/planted/%s", plants[i].fault);
        g_test_add_data_func(test, GSIZE_TO_POINTER(i), test_plant);
    }
    for (gsize i = 0; i < G_N_ELEMENTS(exhibits); i++) {
        g_autofree char *test = g_strdup_printf("/conformance/museum/%s", exhibits[i].exhibit);
        g_test_add_data_func(test, GSIZE_TO_POINTER(i), test_exhibit);
    }
    g_test_add_func("/conformance/repeated", test_repeated);
    g_test_add_func("/conformance/usage", test_usage);
    g_test_add_func("/conformance/friction", test_friction);
    g_test_add_func("/conformance/deaf-parent", test_deaf_parent);
    return g_test_run();
}

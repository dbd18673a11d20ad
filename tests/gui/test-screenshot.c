/* Pictures of the window: the same bytes every time, another theme is another picture, and errors end as those of
 * `tinker` do. */
#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/wait.h>

static char *folder;

/* `tinker-gui ARGUMENTS...` in a display of its own; answers its exit status. */
static int run(const char *const *arguments, char **errors)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) words = g_ptr_array_new();
    const char *xvfb_run = g_getenv("TINKER_XVFB_RUN");
    if (xvfb_run == NULL || xvfb_run[0] == '\0') g_error("xvfb-run is missing; it is in the package xvfb");
    const char *fixed[] = {xvfb_run, "-a", "-s", "-screen 0 1400x900x24", g_getenv("TINKER_GUI_PROGRAM")};
    for (gsize i = 0; i < G_N_ELEMENTS(fixed); i++)
        g_ptr_array_add(words, (gpointer)fixed[i]);
    for (; *arguments != NULL; arguments++)
        g_ptr_array_add(words, (gpointer)*arguments);
    g_ptr_array_add(words, NULL);
    /* What GTK and fontconfig keep until the end is not ours. */
    g_autofree char *sanitizer =
        g_strconcat(g_getenv("ASAN_OPTIONS") != NULL ? g_getenv("ASAN_OPTIONS") : "", ":detect_leaks=0", NULL);
    g_auto(GStrv) environment = g_environ_setenv(g_get_environ(), "ASAN_OPTIONS", sanitizer, TRUE);
    environment = g_environ_setenv(environment, "GDK_BACKEND", "x11", TRUE);
    environment = g_environ_unsetenv(environment, "WAYLAND_DISPLAY");
    int status = 0;
    g_spawn_sync(NULL, (char **)words->pdata, environment, G_SPAWN_STDOUT_TO_DEV_NULL, NULL, NULL, NULL, errors,
                 &status, &error);
    g_assert_no_error(error);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static char *scene_path(const char *name)
{
    return g_build_filename(g_getenv("TINKER_SCENES"), name, NULL);
}

/* A picture of the spring-mass system at 1.3 s. (transfer full) */
static GBytes *picture(const char *theme, const char *option, const char *value)
{
    g_autofree char *file = g_build_filename(folder, "picture.png", NULL),
                    *scene = scene_path("spring-mass.tinker.json");
    g_autofree char *errors = NULL, *data = NULL;
    const char *const arguments[] = {"--screenshot", file,       "--scene", scene, "--time",   "1.3",
                                     "--size",       "1000x700", "--theme", theme, "--select", "Mass 0",
                                     "--page",       "model",    option,    value, NULL};
    int status = run(arguments, &errors);
    if (status != 0) g_test_message("%s", errors);
    g_assert_cmpint(status, ==, 0);
    gsize length;
    g_assert_true(g_file_get_contents(file, &data, &length, NULL));
    g_unlink(file);
    return g_bytes_new(data, length);
}

static guint32 number_at(GBytes *png, gsize place)
{
    guint32 value;
    memcpy(&value, (const char *)g_bytes_get_data(png, NULL) + place, sizeof value);
    return GUINT32_FROM_BE(value);
}

static void test_same_bytes(void)
{
    g_autoptr(GBytes) first = picture("light", NULL, NULL), second = picture("light", NULL, NULL),
                      dark = picture("dark", NULL, NULL);
    g_assert_cmpmem(g_bytes_get_data(first, NULL), 8, "\x89PNG\r\n\x1a\n", 8);
    g_assert_cmpuint(number_at(first, 16), ==, 1000);
    g_assert_cmpuint(number_at(first, 20), ==, 700);
    g_assert_true(g_bytes_equal(first, second));
    g_assert_false(g_bytes_equal(first, dark));
}

/* What can be done with the window can be done in a small one. */
static void test_small(void)
{
    static const char *const pages[] = {"model", "graphs", "accuracy"};
    g_autofree char *file = g_build_filename(folder, "small.png", NULL), *scene = scene_path("pendulum.tinker.json");
    for (gsize i = 0; i < G_N_ELEMENTS(pages); i++) {
        g_autofree char *errors = NULL, *data = NULL;
        gsize length;
        const char *const arguments[] = {"--screenshot", file,     "--scene", scene, "--size",
                                         "800x500",      "--page", pages[i],  NULL};
        g_assert_cmpint(run(arguments, &errors), ==, 0);
        g_assert_true(g_file_get_contents(file, &data, &length, NULL));
        g_autoptr(GBytes) png = g_bytes_new(data, length);
        g_test_message("%s: %u x %u", pages[i], number_at(png, 16), number_at(png, 20));
        g_assert_cmpuint(number_at(png, 16), ==, 800);
        g_assert_cmpuint(number_at(png, 20), ==, 500);
        g_unlink(file);
    }
}

/* Each option is to be seen. */
static void test_parts(void)
{
    g_autoptr(GBytes) plain = picture("light", NULL, NULL), properties = picture("light", "--panel", "properties");
    g_autoptr(GBytes) start = picture("light", "--panel", "start"), forces = picture("light", "--forces", NULL);
    g_assert_true(g_bytes_equal(plain, properties));
    g_assert_false(g_bytes_equal(plain, start));
    g_assert_false(g_bytes_equal(plain, forces));
    static const char *const over[] = {"--velocity", "--acceleration", "--net-force", "--trail"};
    for (gsize i = 0; i < G_N_ELEMENTS(over); i++) {
        g_autoptr(GBytes) one = picture("light", over[i], NULL), again = picture("light", over[i], NULL);
        g_assert_false(g_bytes_equal(plain, one));
        g_assert_true(g_bytes_equal(again, one));
    }
}

static void test_statuses(void)
{
    g_autofree char *file = g_build_filename(folder, "picture.png", NULL),
                    *scene = scene_path("spring-mass.tinker.json");
    g_autofree char *wrong = g_build_filename(folder, "wrong.tinker.json", NULL);
    g_assert_true(g_file_set_contents(wrong, "{\"tinker\": 1, \"blocks\": 3}", -1, NULL));
    const struct {
        const char *arguments[8];
        int status;
        const char *told;
    } cases[] = {
        {{"--no-such-option"}, 2, "no-such-option"},
        {{"--scene", scene}, 2, "--screenshot"},
        {{"--screenshot", file, "--scene", scene, "--size", "big"}, 2, "1280x800"},
        {{"--screenshot", file, "--theme", "pink"}, 2, "contrast-dark"},
        {{"--screenshot", file, "--scene", scene, "--time", "soon"}, 2, "soon"},
        {{"--screenshot", file, "--scene", scene, "--time", "1e9"}, 2, "--time"},
        {{"--screenshot", file, "--scene", scene, "--select", "Nobody"}, 2, "Nobody"},
        {{"--screenshot", file, "--scene", scene, "--page", "yellow"}, 2, "yellow"},
        {{"--screenshot", file, "--scene", scene, "--panel", "purple"}, 2, "purple"},
        {{"--forces"}, 2, "--screenshot"},
        {{"--trail"}, 2, "--screenshot"},
        {{"--measure"}, 2, "--screenshot"},
        {{"--screenshot", file, "--scene", wrong}, 3, "wrong.tinker.json:1:"},
        {{"--screenshot", file, "--scene", "/nowhere.tinker.json"}, 5, "/nowhere.tinker.json"},
        {{"--screenshot", "/nowhere/at/all.png"}, 5, "/nowhere/at/all.png"},
        {{"--version"}, 0, ""},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *errors = NULL;
        int status = run(cases[i].arguments, &errors);
        g_test_message("%s: %d %s", cases[i].arguments[0], status, errors);
        g_assert_cmpint(status, ==, cases[i].status);
        g_assert_nonnull(strstr(errors, cases[i].told));
        g_assert_false(g_file_test(file, G_FILE_TEST_EXISTS));
    }
    g_unlink(wrong);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    folder = g_dir_make_tmp("tinker-pictures-XXXXXX", NULL);
    g_test_add_func("/gui/screenshot/same-bytes", test_same_bytes);
    g_test_add_func("/gui/screenshot/small", test_small);
    g_test_add_func("/gui/screenshot/parts", test_parts);
    g_test_add_func("/gui/screenshot/statuses", test_statuses);
    int status = g_test_run();
    g_rmdir(folder);
    g_free(folder);
    return status;
}

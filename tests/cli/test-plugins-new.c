/* What `tinker plugins new` and `new-bundle` write is built against the SDK alone, tested by its own tests and run. */
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "author.h"
#include "fixture.h"
#include "folders.h"

static const char *const roles[] = {"line-law", "force-element", "field", "constraint", "joint",
                                    "torque",   "motion",        "body",  "integrator"};

/* Writes a folder below that of the fixture; answers its path. (transfer full) */
static char *write_new(CliFixture *fixture, const char *verb, const char *name, const char *role)
{
    g_autofree char *option = role != NULL ? g_strdup_printf("--role %s", role) : g_strdup("");
    g_autofree char *words = g_strdup_printf("plugins %s %s %s -o @%s", verb, name, option, name);
    g_autoptr(TestProgram) program = cli_run_well(fixture, words);
    g_assert_cmpstr(program->error, ==, "");
    char *folder = cli_path(fixture, name);
    g_autofree char *next = g_strdup_printf("\nNext:\n  cd %s\n  meson setup build && meson test -C build\n", folder);
    cli_assert_holds(program->output, next);
    return folder;
}

/* As the printed next commands say. */
static void build(const char *author, const char *data_home, const char *folder, const char *build_folder)
{
    const char *setup[] = {"meson", "setup", "-Dwerror=true", build_folder, folder, NULL};
    const char *test[] = {"meson", "test", "-C", build_folder, NULL};
    test_author_run(author, data_home, setup);
    test_author_run(author, data_home, test);
}

/* No text is left in which a word should have been put in. */
static void assert_is_filled_in(const char *folder)
{
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        g_autofree char *path = g_build_filename(folder, name, NULL);
        struct stat status;
        g_assert_false(g_str_has_prefix(name, "name.") || g_str_has_suffix(name, "-name.c"));
        if (g_file_test(path, G_FILE_TEST_IS_DIR)) {
            assert_is_filled_in(path);
            continue;
        }
        g_autofree char *text = test_read_file(path);
        if (g_regex_match_simple("@[a-z]+@", text, 0, 0)) g_error("%s has a word to be put in", path);
        g_assert_cmpint(stat(path, &status), ==, 0);
        g_assert_cmpint(status.st_mode & 0111, ==, 0);
    }
}

/* The test that was written can fail: with large steps of the simplest method the closed form is missed. */
static void assert_test_can_fail(const char *build_folder, const char *name, const char *scene)
{
    g_autofree char *file = g_strconcat("test-", name, NULL), *path = g_build_filename(build_folder, file, NULL);
    const char *arguments[] = {path,       g_getenv("TINKER_PROGRAM"), scene,    build_folder,
                               "--method", "semi-implicit-euler",      "--step", "0.05",
                               NULL};
    int wait_status = 0;
    g_autoptr(GError) error = NULL;
    g_spawn_sync(NULL, (char **)arguments, NULL, G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL, NULL, NULL, &wait_status,
                 &error);
    g_assert_no_error(error);
    g_assert_false(g_spawn_check_wait_status(wait_status, NULL));
}

static void test_role(CliFixture *fixture, gconstpointer data)
{
    const char *role = data;
    g_autofree char *name = g_strconcat("my-", role, NULL), *folder = write_new(fixture, "new", name, role);
    g_autofree char *author = test_author_folder(), *build_folder = g_build_filename(author, "build", NULL);
    assert_is_filled_in(folder);
    build(author, NULL, folder, build_folder);

    g_autofree char *scene = g_strdup_printf("%s/%s.tinker.json", folder, name);
    g_autofree char *check = g_strdup_printf("check %s --plugins %s", scene, build_folder);
    g_autofree char *run = g_strdup_printf("run %s --plugins %s", scene, build_folder);
    g_autofree char *picture = g_strdup_printf("render %s --plugins %s -o @picture.svg", scene, build_folder);
    g_autofree char *show = g_strdup_printf("plugins show %s --plugins %s", name, build_folder);
    g_autofree char *describe = g_strdup_printf("plugins describe %s/tinker-%s.so -o @manifest", build_folder, name);
    g_autoptr(TestProgram) checked = cli_run_well(fixture, check);
    g_assert_cmpstr(checked->output, ==, "no mistakes found\n");
    g_autoptr(TestProgram) ran = cli_run_well(fixture, run), drawn = cli_run_well(fixture, picture);
    g_assert_cmpstr(ran->error, ==, "");
    g_assert_cmpstr(drawn->error, ==, "");
    g_autoptr(TestProgram) shown = cli_run_well(fixture, show), described = cli_run_well(fixture, describe);
    cli_assert_holds(shown->output, name);
    g_autofree char *manifest = cli_read(fixture, "manifest"), *id = g_strdup_printf("\"org.example.%s\"", name);
    cli_assert_holds(manifest, id);
    g_autofree char *library = g_strdup_printf("%s/tinker-%s.so", build_folder, name);
    test_author_states_laws(library);
    assert_test_can_fail(build_folder, name, scene);
    test_remove_all(author);
}

/* Built, tested and installed, the bundle is one folder of the user's, found with its blocks and scenes. */
static void test_bundle(CliFixture *fixture, gconstpointer data)
{
    static const char *const scenes[] = {"my-course", "my-course-band", "my-course-drag"};
    g_autofree char *folder = write_new(fixture, "new-bundle", "my-course", NULL), *home = cli_path(fixture, "data");
    g_autofree char *author = test_author_folder(), *build_folder = g_build_filename(author, "build", NULL);
    const char *install[] = {"meson", "install", "-C", build_folder, "--no-rebuild", NULL};
    assert_is_filled_in(folder);
    build(author, home, folder, build_folder);
    test_author_run(author, home, install);

    g_autofree char *usual = g_strdup(g_getenv("XDG_DATA_HOME"));
    g_setenv("XDG_DATA_HOME", home, TRUE); /* what is run from here on has this user folder */
    g_autoptr(TestProgram) list = cli_run_well(fixture, "plugins");
    g_autofree char *bundle = g_strdup_printf("\nbundle \"My Course\": %s/tinker/plugins/my-course\n"
                                              "  A rubber band that hardens, and drag by the square of the speed\n"
                                              "  page.md\n"
                                              "  scenes/my-course-band.tinker.json\n"
                                              "  scenes/my-course-drag.tinker.json\n"
                                              "  scenes/my-course.tinker.json\n",
                                              home);
    cli_assert_holds(list->output, bundle);
    g_assert_cmpstr(list->error, ==, "");
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        g_autofree char *check =
            g_strdup_printf("check %s/tinker/plugins/my-course/scenes/%s.tinker.json", home, scenes[i]);
        g_autofree char *run = g_strdup_printf("run %s", check + strlen("check "));
        g_autoptr(TestProgram) checked = cli_run_well(fixture, check), ran = cli_run_well(fixture, run);
        g_assert_cmpstr(checked->output, ==, "no mistakes found\n");
        g_assert_cmpstr(ran->error, ==, "");
    }
    g_autoptr(TestProgram) shown = cli_run_well(fixture, "plugins show my-course-band my-course-drag");
    cli_assert_holds(shown->output, "My Course Drag (field)");
    g_autoptr(TestProgram) again = cli_run_badly(fixture, "plugins new-bundle my-course -o @again", 2);
    cli_assert_holds(again->error, "the name \"my-course-band\" is taken");
    g_setenv("XDG_DATA_HOME", usual, TRUE);
    test_remove_all(author);
}

static void test_list(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = cli_run_well(fixture, "plugins new");
    for (gsize i = 0; i < G_N_ELEMENTS(roles); i++)
        cli_assert_holds(program->output, roles[i]);
    g_autoptr(TestProgram) named = cli_run_badly(fixture, "plugins new my-spring -o @my-spring", 2);
    g_assert_cmpstr(named->output, ==, program->output);
    g_assert_cmpstr(named->error, ==, "tinker: plugins new: --role is missing, and nothing was written\n");
    g_autofree char *folder = cli_path(fixture, "my-spring");
    g_assert_false(g_file_test(folder, G_FILE_TEST_EXISTS));
}

/* The words, the exit status and the message, in which "@" stands for the folder and a slash. */
static void expect_error(CliFixture *fixture, const char *words, int status, const char *message)
{
    g_autoptr(TestProgram) program = cli_run_badly(fixture, words, status);
    g_auto(GStrv) parts = g_strsplit(message, "@", -1);
    g_autofree char *place = g_strconcat(fixture->folder, "/", NULL), *full = g_strjoinv(place, parts);
    g_autofree char *line = g_strdup_printf("tinker: %s\n", full);
    g_assert_cmpstr(program->error, ==, line);
    g_assert_cmpstr(program->output, ==, "");
}

#define NOT_A_NAME(name)                                                                                               \
    "the name \"" name "\" is not one of at most 40 lower-case letters, digits and single hyphens between them, with " \
    "a letter first (as \"rubber-band\")"

static void test_names(CliFixture *fixture, gconstpointer data)
{
    static const char *const bad[][2] = {
        {"Band", NOT_A_NAME("Band")},       {"2band", NOT_A_NAME("2band")}, {"band-", NOT_A_NAME("band-")},
        {"../band", NOT_A_NAME("../band")}, {"a--b", NOT_A_NAME("a--b")},   {"bänd", NOT_A_NAME("bänd")},
        {"a_b", NOT_A_NAME("a_b")},         {"''", NOT_A_NAME("")},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autofree char *words = g_strdup_printf("plugins new %s --role field -o @new", bad[i][0]);
        g_autofree char *bundle = g_strdup_printf("plugins new-bundle %s -o @new", bad[i][0]);
        expect_error(fixture, words, 2, bad[i][1]);
        expect_error(fixture, bundle, 2, bad[i][1]);
    }
    expect_error(fixture, "plugins new rk4 --role integrator -o @new", 2,
                 "the name \"rk4\" is taken: a built-in method has it (choose another)");
    g_autofree char *taken = g_strdup_printf("the name \"spring\" is taken: the plugin \"%s/tinker-spring.so\" has it "
                                             "(choose another)",
                                             g_getenv("TINKER_TEST_PLUGINS"));
    expect_error(fixture, "plugins new spring --role line-law -o @new", 2, taken);
    g_autofree char *folder = cli_path(fixture, "new");
    g_assert_false(g_file_test(folder, G_FILE_TEST_EXISTS));
}

static void test_usage(CliFixture *fixture, gconstpointer data)
{
    expect_error(fixture, "plugins new my-band --role line-lw -o @new", 2,
                 "--role \"line-lw\": there is no such role (did you mean \"line-law\"?); the roles are line-law, "
                 "force-element, field, constraint, joint, torque, motion, body, integrator");
    expect_error(fixture, "plugins new --role field", 2,
                 "plugins new: the name is missing, as in tinker plugins new rubber-band --role field");
}

static void test_folders(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *there = cli_path(fixture, "there"), *kept = cli_write(fixture, "file", "kept");
    g_assert_cmpint(g_mkdir(there, 0755), ==, 0);
    expect_error(fixture, "plugins new my-band --role line-law -o @there", 5,
                 "@there: exists already, and nothing is overwritten (choose another name, or another folder with "
                 "--output)");
    expect_error(fixture, "plugins new-bundle my-course -o @file", 5,
                 "@file: exists already, and nothing is overwritten (choose another name, or another folder with "
                 "--output)");
    expect_error(fixture, "plugins new my-band --role line-law -o @none/band", 5,
                 "@none/band: cannot be made: the folder @none does not exist");
    expect_error(fixture, "plugins new my-band --role line-law -o @file/band", 5,
                 "@file/band: cannot be made: Not a directory");
    g_assert_cmpint(g_rmdir(there), ==, 0); /* it is empty still */
    g_autofree char *text = test_read_file(kept);
    g_assert_cmpstr(text, ==, "kept");
}

/* Root may write where others may not. */
static void test_unwritable(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *locked = cli_path(fixture, "locked");
    g_assert_cmpint(g_mkdir(locked, 0555), ==, 0);
    if (access(locked, W_OK) == 0) {
        g_test_skip("this user may write to every folder");
        return;
    }
    expect_error(fixture, "plugins new my-band --role line-law -o @locked/band", 5,
                 "@locked/band: cannot be made: Permission denied");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(roles); i++) {
        g_autofree char *path = g_strconcat("/cli/plugins-new/role/", roles[i], NULL);
        g_test_add(path, CliFixture, roles[i], cli_fixture_set_up, test_role, cli_fixture_tear_down);
    }
    cli_test_add("/cli/plugins-new/bundle", test_bundle);
    cli_test_add("/cli/plugins-new/list", test_list);
    cli_test_add("/cli/plugins-new/names", test_names);
    cli_test_add("/cli/plugins-new/usage", test_usage);
    cli_test_add("/cli/plugins-new/folders", test_folders);
    cli_test_add("/cli/plugins-new/unwritable", test_unwritable);
    return g_test_run();
}

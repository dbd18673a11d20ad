/* The files of a command: none that it reads is written to, no two outputs go to one, and what cannot be written as a
 * whole is told. What could have been lost is compared byte by byte. */
#include <glib/gstdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fixture.h"

#define TABLE "0,0\n1,0.5\n2,1\n"

/* A mass on a spring, driven by a table in the file NAME. */
static void write_driven(const CliFixture *fixture, const char *name)
{
    g_autofree char *scene = g_strdup_printf(
        "{\"tinker\": 1, \"run\": {\"duration\": 0.2, \"interval\": 0.1}, \"blocks\": [\n"
        " {\"type\": \"support\"}, {\"type\": \"mass\", \"position\": [3, 0]},\n"
        " {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100, \"rest_length\": 3},\n"
        " {\"type\": \"motor\", \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": \"%s\"}}],\n"
        " \"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"x\"}]}\n",
        name);
    g_free(cli_write(fixture, "driven.json", scene));
    g_free(cli_write(fixture, name, TABLE));
}

static void assert_same_text(const CliFixture *fixture, const char *name, const char *text)
{
    g_autofree char *now = cli_read(fixture, name);
    g_assert_cmpstr(now, ==, text);
}

/* Every verb with an output, and every one of its outputs: TABLE stands for the table's file. */
static void test_table(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *words, *table;
    } commands[] = {
        {"run @driven.json --csv @TABLE", "motion.csv"},
        {"run @driven.json --json @TABLE", "motion.csv"},
        {"graph @driven.json -o @TABLE", "motion.csv"},
        {"graph @driven.json -o @TABLE", "motion.svg"},
        {"render @driven.json -o @TABLE", "motion.png"},
        {"animate @driven.json -o @TABLE --size 32x32", "motion.gif"},
        {"animate @driven.json -o @motion.png --size 32x32", "motion-0002.png"},
        {"plan @driven.json --json @TABLE", "motion.csv"},
        {"trade @driven.json --csv @TABLE --seconds 1", "motion.csv"},
        {"trade @driven.json -o @TABLE --seconds 1", "motion.pdf"},
        {"modes @driven.json --json @TABLE", "motion.csv"},
        {"modes @driven.json -o @motion.png", "motion-1.png"},
        {"modes @driven.json --response 'Motor 0' 'Mass 0.x' -o @TABLE", "motion.csv"},
        {"bench @driven.json --json @TABLE --seconds 0.01", "motion.csv"},
        {"convert @driven.json -o @TABLE", "motion.csv"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        g_autoptr(GString) words = g_string_new(commands[i].words);
        g_autofree char *path = cli_path(fixture, commands[i].table);
        g_string_replace(words, "TABLE", commands[i].table, 0);
        write_driven(fixture, commands[i].table);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words->str, 2);
        cli_assert_holds(program->error, "a table that the scene reads");
        cli_assert_holds(program->error, path);
        assert_same_text(fixture, commands[i].table, TABLE);
        g_unlink(path);
    }
}

/* By whatever name the file is called. */
static void test_other_names(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *table = cli_path(fixture, "motion.csv"), *soft = cli_path(fixture, "soft.csv"),
                    *hard = cli_path(fixture, "hard.csv"), *folder = cli_path(fixture, "elsewhere");
    write_driven(fixture, "motion.csv");
    g_assert_cmpint(symlink("motion.csv", soft), ==, 0);
    g_assert_cmpint(link(table, hard), ==, 0);
    g_assert_cmpint(symlink(fixture->folder, folder), ==, 0);
    static const char *const names[] = {"@soft.csv", "@hard.csv", "@elsewhere/motion.csv", "@./motion.csv"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        g_autofree char *words = g_strconcat("run @driven.json --csv ", names[i], NULL);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words, 2);
        cli_assert_holds(program->error, table);
        assert_same_text(fixture, "motion.csv", TABLE);
    }
}

/* A table of a block whose plugin is missing is kept for when it is there. */
static void test_table_of_missing_type(CliFixture *fixture, gconstpointer data)
{
    g_free(cli_write(fixture, "missing.json",
                     "{\"tinker\": 1, \"blocks\": [{\"type\": \"shaker\", \"ends\": [[0, 0]], \"motion\": {\"table\": "
                     "\"motion.csv\"}}]}"));
    g_free(cli_write(fixture, "motion.csv", TABLE));
    g_autoptr(TestProgram) program = cli_run_badly(fixture, "convert @missing.json -o @motion.csv", 2);
    assert_same_text(fixture, "motion.csv", TABLE);
}

static gboolean exists(const CliFixture *fixture, const char *name)
{
    g_autofree char *path = cli_path(fixture, name);
    return g_file_test(path, G_FILE_TEST_EXISTS);
}

/* Two outputs in one file: also where it is not there yet, and a link would lead to it. Nothing is begun. */
static void test_two_outputs(CliFixture *fixture, gconstpointer data)
{
    g_free(cli_write(fixture, "fall.json", FREE_FALL));
    g_autofree char *link = cli_path(fixture, "link");
    g_assert_cmpint(symlink("new", link), ==, 0);
    static const char *const commands[] = {
        "run @fall.json --csv @new --json @new",          "run @fall.json --csv @new --json @./new",
        "run @fall.json --csv @link --json @new",         "run @fall.json --csv @new --json @link",
        "modes @fall.json --json @new-1.png -o @new.png",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, commands[i], 2);
        cli_assert_holds(program->error, "--json ");
        cli_assert_holds(program->error, i < 4 ? "--csv " : "--output ");
        cli_assert_holds(program->error, "is the same file as");
        g_assert_false(exists(fixture, "new"));
        g_assert_false(exists(fixture, "new-1.png"));
    }
    g_autoptr(TestProgram) apart = cli_run_well(fixture, "run @fall.json --csv @new --json @newer");
    g_assert_true(exists(fixture, "newer"));
}

/* What is no regular file takes any number of outputs; a scene may be converted in its place. */
static void test_allowed(CliFixture *fixture, gconstpointer data)
{
    g_free(cli_write(fixture, "fall.json", FREE_FALL));
    g_autoptr(TestProgram) nowhere = cli_run_well(fixture, "run @fall.json --csv /dev/null --json /dev/null");
    g_autoptr(TestProgram) before = cli_run_well(fixture, "run @fall.json --csv -");
    g_autoptr(TestProgram) tidied = cli_run_well(fixture, "convert @fall.json -o @fall.json");
    g_autoptr(TestProgram) after = cli_run_well(fixture, "run @fall.json --csv -");
    g_assert_cmpstr(before->output, ==, after->output);
}

/* Runs a command in the folder under a shell. Answers the exit status. */
static int run_in_shell(const CliFixture *fixture, const char *command, char **error)
{
    const char *words[] = {"/bin/sh", "-c", command, NULL};
    int status = 0;
    g_assert_true(g_spawn_sync(fixture->folder, (char **)words, NULL, G_SPAWN_STDOUT_TO_DEV_NULL, NULL, NULL, NULL,
                               error, &status, NULL));
    g_assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

/* What the shell puts in the place of a stream is a file like another. */
static void test_streams(CliFixture *fixture, gconstpointer data)
{
    static const char *const commands[] = {
        "\"$TINKER_PROGRAM\" run fall.json --csv both > both",
        "\"$TINKER_PROGRAM\" run fall.json --csv - >> fall.json",
        "\"$TINKER_PROGRAM\" run - --json fall.json < fall.json",
    };
    g_free(cli_write(fixture, "fall.json", FREE_FALL));
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        g_autofree char *error = NULL;
        g_assert_cmpint(run_in_shell(fixture, commands[i], &error), ==, 2);
        cli_assert_holds(error, i == 0 ? "standard output" : "the scene itself");
        assert_same_text(fixture, "fall.json", FREE_FALL);
    }
}

/* A limit of the size of files is told as a full disk is. A record holds the first rows of the whole one then, all of
 * them whole; what is replaced as a whole is as it was, and nothing else is left. */
static void test_size_limit(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *words, *output;
    } commands[] = {
        {"run fall.json --interval 0.0005 --csv out.csv", "out.csv"},
        {"graph fall.json -o out.png", "out.png"},
        {"animate fall.json -o out.png --size 640x480", "out-0001.png"},
        {"convert many.json -o out.json", "out.json"},
    };
    g_autoptr(GString) many = g_string_new("{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}");
    for (int i = 0; i < 200; i++)
        g_string_append(many, ", {\"type\": \"mass\"}");
    g_string_append(many, "]}");
    g_free(cli_write(fixture, "many.json", many->str));
    g_free(cli_write(fixture, "fall.json", FREE_FALL));
    g_autoptr(TestProgram) whole = cli_run_well(fixture, "run @fall.json --interval 0.0005 --csv -");
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        g_autofree char *error = NULL;
        g_autofree char *command = g_strdup_printf("ulimit -f 2; exec \"$TINKER_PROGRAM\" %s", commands[i].words);
        g_free(cli_write(fixture, commands[i].output, "old"));
        g_assert_cmpint(run_in_shell(fixture, command, &error), ==, 5);
        cli_assert_holds(error, "out");
        g_autofree char *now = cli_read(fixture, commands[i].output);
        if (i == 0) {
            cli_assert_holds(error, "File too large");
            g_assert_cmpuint(strlen(now), >, 0);
            g_assert_cmpint(now[strlen(now) - 1], ==, '\n');
            g_assert_true(g_str_has_prefix(whole->output, now));
        } else {
            g_assert_cmpstr(now, ==, "old");
        }
        g_autofree char *path = cli_path(fixture, commands[i].output);
        g_unlink(path);
        g_autoptr(GDir) dir = g_dir_open(fixture->folder, 0, NULL);
        for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir))
            g_assert_true(g_str_equal(name, "many.json") || g_str_equal(name, "fall.json"));
    }
}

/* A plugin's library is not the place for its manifest. */
static void test_library(CliFixture *fixture, gconstpointer data)
{
    g_free(cli_write(fixture, "library.so", "no library"));
    g_free(cli_write(fixture, "library.manifest.json", "{}"));
    g_autoptr(TestProgram) program = cli_run(fixture, "plugins describe @library.so -o @library.so");
    g_assert_cmpint(program->status, ==, 2);
    assert_same_text(fixture, "library.so", "no library");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/files/table", test_table);
    cli_test_add("/cli/files/other-names", test_other_names);
    cli_test_add("/cli/files/table-of-missing-type", test_table_of_missing_type);
    cli_test_add("/cli/files/two-outputs", test_two_outputs);
    cli_test_add("/cli/files/allowed", test_allowed);
    cli_test_add("/cli/files/streams", test_streams);
    cli_test_add("/cli/files/size-limit", test_size_limit);
    cli_test_add("/cli/files/library", test_library);
    return g_test_run();
}

/* Runs the program with its output caught. Records and summaries go through files in a folder of their own, because the
 * two could not share standard output. */
#include "program.h"

#include <glib/gstdio.h>
#include <string.h>
#include <sys/wait.h>

/* Seventeen digits, so that what is sampled is the very time that was asked for. */
static char *join_times(const double *times, gsize count)
{
    GString *list = g_string_new(NULL);
    for (gsize i = 0; i < count; i++) {
        char text[G_ASCII_DTOSTR_BUF_SIZE];
        g_string_append_printf(list, "%s%s", i > 0 ? "," : "", g_ascii_dtostr(text, sizeof text, times[i]));
    }
    return g_string_free(list, FALSE);
}

TestProgram *test_program_run(const char *const *arguments)
{
    const char *path = g_getenv("TINKER_PROGRAM");
    g_assert_nonnull(path);
    g_autoptr(GPtrArray) words = g_ptr_array_new();
    g_ptr_array_add(words, (gpointer)path);
    for (; *arguments != NULL; arguments++)
        g_ptr_array_add(words, (gpointer)*arguments);
    g_ptr_array_add(words, NULL);

    TestProgram *program = g_new0(TestProgram, 1);
    g_autoptr(GError) error = NULL;
    int wait_status = 0;
    g_spawn_sync(NULL, (char **)words->pdata, NULL, G_SPAWN_DEFAULT, NULL, NULL, &program->output, &program->error,
                 &wait_status, &error);
    g_assert_no_error(error);
    program->status = WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : -1;
    program->signal = WIFSIGNALED(wait_status) ? WTERMSIG(wait_status) : 0;
    return program;
}

void test_program_free(TestProgram *program)
{
    g_free(program->output);
    g_free(program->error);
    g_free(program);
}

TestSceneRun *test_scene_run(const char *path, const char *const *options)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *folder = g_dir_make_tmp("tinker-run-XXXXXX", &error);
    g_assert_no_error(error);
    g_autofree char *csv = g_build_filename(folder, "record.csv", NULL);
    g_autofree char *json = g_build_filename(folder, "summary.json", NULL);

    g_autoptr(GPtrArray) arguments = g_ptr_array_new();
    const char *fixed[] = {"run", path, "--csv", csv, "--json", json};
    for (gsize i = 0; i < G_N_ELEMENTS(fixed); i++)
        g_ptr_array_add(arguments, (gpointer)fixed[i]);
    for (; *options != NULL; options++)
        g_ptr_array_add(arguments, (gpointer)*options);
    g_ptr_array_add(arguments, NULL);
    g_autoptr(TestProgram) program = test_program_run((const char *const *)arguments->pdata);
    if (program->status != 0) g_test_message("%s", program->error);
    g_assert_cmpint(program->status, ==, 0);

    TestSceneRun *run = g_new0(TestSceneRun, 1);
    g_autofree char *text = test_read_file(csv);
    run->record = test_table_new(text);
    run->summary = test_read_json(json);
    g_remove(csv);
    g_remove(json);
    g_rmdir(folder);
    return run;
}

void test_scene_run_free(TestSceneRun *run)
{
    test_table_free(run->record);
    cJSON_Delete(run->summary);
    g_free(run);
}

TestSceneRun *test_scene_run_at(const char *path, const double *times, gsize count, const char *tolerance)
{
    g_autofree char *list = join_times(times, count);
    const char *options[] = {"--at", list, "--method", "auto", "--tolerance", tolerance, NULL};
    return test_scene_run(path, options);
}

double test_summary_number(const TestSceneRun *run, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(run->summary, key);
    if (!cJSON_IsNumber(item)) g_error("the summary has no number \"%s\"", key);
    return item->valuedouble;
}

void test_pretend_program(const char *folder, const char *name, const char *script)
{
    g_autofree char *programs = g_build_filename(folder, "programs", NULL);
    g_autofree char *program = g_build_filename(programs, name, NULL);
    g_assert_cmpint(g_mkdir(programs, 0700), ==, 0);
    if (script != NULL) {
        g_assert_true(g_file_set_contents(program, script, -1, NULL));
        g_assert_cmpint(g_chmod(program, 0700), ==, 0);
    }
    g_setenv("PATH", programs, TRUE);
}

char *test_read_file(const char *path)
{
    g_autoptr(GError) error = NULL;
    char *text = NULL;
    g_file_get_contents(path, &text, NULL, &error);
    g_assert_no_error(error);
    return text;
}

cJSON *test_read_json(const char *path)
{
    g_autofree char *text = test_read_file(path);
    cJSON *root = cJSON_Parse(text);
    if (root == NULL) g_error("%s is not JSON", path);
    return root;
}

/* record.h, which every plugin made by `tinker plugins new` reads its records with: here of a program that writes what
 * it is told to. */
#include "record.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <stdlib.h>

/* The record that a program "writes", in a folder of its own. */
static Record record_of(const char *text, char **program)
{
    g_autofree char *folder = g_dir_make_tmp("tinker-record-XXXXXX", NULL);
    *program = g_build_filename(folder, "program", NULL);
    g_autofree char *script = g_strdup_printf("#!/bin/sh\ncat <<'END'\n%sEND\n", text);
    g_assert_true(g_file_set_contents_full(*program, script, -1, G_FILE_SET_CONTENTS_NONE, 0700, NULL));
    const char *arguments[] = {"test", *program, "scene", "folder"};
    return record_run(4, (char **)arguments, "a");
}

static void remove_program(char *program)
{
    g_autofree char *folder = g_path_get_dirname(program);
    g_remove(program);
    g_rmdir(folder);
    g_free(program);
}

static void test_rows(void)
{
    char *program;
    Record record = record_of("time,a,b\n0,1,-2\n0.5,1e3,nan\n", &program);
    g_assert_cmpint(record_next(&record), ==, 1);
    g_assert_cmpfloat(record.value[0], ==, 0);
    g_assert_cmpfloat(record.value[1], ==, 1);
    g_assert_cmpfloat(record.value[2], ==, -2);
    g_assert_cmpint(record_next(&record), ==, 1);
    g_assert_cmpfloat(record.value[1], ==, 1000);
    g_assert_cmpint(record_next(&record), ==, 0);
    g_assert_cmpint(record.rows, ==, 2);
    g_assert_cmpint(record_finish(&record), ==, 0);
    remove_program(program);
}

static void test_most_columns(void)
{
    char *program;
    Record record = record_of("time,a,b,c,d,e,f,g\n0,1,2,3,4,5,6,7\n", &program);
    g_assert_cmpint(record_next(&record), ==, 1);
    g_assert_cmpfloat(record.value[7], ==, 7);
    g_assert_cmpint(record_finish(&record), ==, 0);
    remove_program(program);
}

static char *program_of_exit;

static void remove_program_of_exit(void)
{
    remove_program(program_of_exit);
}

/* More columns than it reads are no row of fewer. It ends the test. */
static void read_too_many(void)
{
    atexit(remove_program_of_exit);
    (void)record_of("time,a,b,c,d,e,f,g,h\n0,1,2,3,4,5,6,7,8\n", &program_of_exit);
}

static void test_too_many(void)
{
    g_test_trap_subprocess("/sdk/record/too-many/subprocess", 0, G_TEST_SUBPROCESS_DEFAULT);
    g_test_trap_assert_failed();
    g_test_trap_assert_stderr(
        "the record has 9 columns or more, at most 8 are read: raise RECORD_MOST_COLUMNS in record.h\n");
}

/* A run that is to be believed up to some time says so below the rows; a crash may cut a row off. Neither is a row. */
static void test_no_rows(void)
{
    static const char *const lines[] = {"# invalid from t = 0.5\n", "0.5\n", "0.5,1,2\n", "\n", "0.5,\n"};
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++) {
        char *program;
        g_autofree char *text = g_strconcat("time,a\n0,1\n", lines[i], NULL);
        Record record = record_of(text, &program);
        g_assert_cmpint(record_next(&record), ==, 1);
        g_assert_cmpint(record_next(&record), ==, 0);
        g_assert_cmpint(record.rows, ==, 1);
        g_assert_cmpint(record_finish(&record), ==, 1);
        remove_program(program);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/sdk/record/rows", test_rows);
    g_test_add_func("/sdk/record/most-columns", test_most_columns);
    g_test_add_func("/sdk/record/too-many", test_too_many);
    g_test_add_func("/sdk/record/too-many/subprocess", read_too_many);
    g_test_add_func("/sdk/record/no-rows", test_no_rows);
    return g_test_run();
}

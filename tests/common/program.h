/* Running `tinker` from a test, and what it wrote. The program's path is in TINKER_PROGRAM. */
#ifndef TEST_PROGRAM_H
#define TEST_PROGRAM_H

#include <cjson/cJSON.h>
#include <glib.h>

#include "table.h"

typedef struct {
    int status;   /* exit status; -1 where a signal ended it */
    int signal;   /* that signal; else 0 */
    char *output; /* standard output */
    char *error;  /* standard error */
} TestProgram;

/* Runs it with these arguments (ended by NULL, without the program's name) and waits. (transfer full) */
TestProgram *test_program_run(const char *const *arguments);
void test_program_free(TestProgram *program);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TestProgram, test_program_free)

/* A finished run of a scene: its record and its summary. */
typedef struct {
    TestTable *record;
    cJSON *summary;
} TestSceneRun;

/* `tinker run PATH options...`; fails the test with the program's message where that does not exit with 0. (transfer
 * full) */
TestSceneRun *test_scene_run(const char *path, const char *const *options);
void test_scene_run_free(TestSceneRun *run);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TestSceneRun, test_scene_run_free)

/* Runs a scene with a sample at each of these times, and a tolerance. (transfer full) */
TestSceneRun *test_scene_run_at(const char *path, const double *times, gsize count, const char *tolerance);

/* A number of the summary; fails the test where there is none of that name. */
double test_summary_number(const TestSceneRun *run, const char *key);

/* From now on PATH is a folder made in `folder`, with nothing in it but this script under the name of a program; NULL:
 * not even that. */
void test_pretend_program(const char *folder, const char *name, const char *script);

/* A file's text. Fails the test where it cannot be read. (transfer full) */
char *test_read_file(const char *path);
cJSON *test_read_json(const char *path);

#endif

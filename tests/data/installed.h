/* The files of the desktop, installed as a package would be made, and the desktop's own tools to look at them. */
#ifndef TEST_INSTALLED_H
#define TEST_INSTALLED_H

#include <glib.h>

/* Installs what has the tags `desktop` and `i18n` into a temporary folder, and lets `update-mime-database` read it. */
void test_installed_set_up(void);
/* Deletes that folder. */
void test_installed_tear_down(void);

/* A path within the installed data folder (`share`), as "applications/x.desktop". (transfer full) */
char *test_installed_path(const char *relative);
/* A file of `share`. Fails the test where it is not there. (transfer full) */
char *test_installed_text(const char *relative);

/* Runs a tool with these arguments (ended by NULL), which finds the installed data beside that of the system, and gives
 * its exit status and, where `output` is not NULL, what it wrote to standard output and standard error. (transfer full)
 */
int test_tool_run(const char *const *arguments, char **output);
/* Runs a tool as test_tool_run() does, and fails the test with what it wrote unless the status is 0. (transfer full) */
char *test_tool_output(const char *const *arguments);

#endif

/* A plugin's author at work: a folder with the SDK as it will be installed, and tools that find it. */
#ifndef TEST_AUTHOR_H
#define TEST_AUTHOR_H

#include <glib.h>

/* A new folder with the staged SDK, TINKER_SDK_PACKAGE and the headers of TINKER_SOURCES, and the program of
 * TINKER_PROGRAM in `bin`. (transfer full) */
char *test_author_folder(void);

/* Runs a tool; pkg-config finds the SDK of the folder, and the PATH its program. It has to end well and to say nothing
 * on standard error. `data_home` is XDG_DATA_HOME; NULL: as it is. It works in the folder: where it starts, meson takes
 * a .ninja_deps for that of the build it sets up. */
void test_author_run(const char *folder, const char *data_home, const char *const *arguments);

/* Holds a library to the rules of the contract, and to stating the law of each of its blocks that has one. */
void test_author_states_laws(const char *library);

#endif

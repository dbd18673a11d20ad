/* What the tests of plugins share: a temporary place with folders for libraries, and catalogues over it. */
#ifndef TINKER_TESTS_PLUGIN_FIXTURE_H
#define TINKER_TESTS_PLUGIN_FIXTURE_H

#include "plugin/catalogue/catalogue.h"

/* A test's own place. Every test of plugins starts with one, so that none sees the user's plugins or cache. */
typedef struct {
    char *root;
    char *first, *second, *installed; /* folders for libraries */
    char *cache;                      /* folder, not made */
    char *probe_program;
    char *probe_log;                /* a line for each probe */
    const char *folders[3];         /* first, second, NULL: for the options */
    TinkerCatalogueOptions options; /* first and second on the command line, the probe stub, a generous time limit */
} Place;

void place_set_up(Place *place, gconstpointer data);
void place_tear_down(Place *place, gconstpointer data);

/* Adds a test that gets a place. */
#define add_place_test(path, function) g_test_add(path, Place, NULL, place_set_up, function, place_tear_down)

/* Path of a module that was built for the tests. (transfer full) */
char *built_module(const char *name);

/* Copies a module into a folder under a new name and answers its path. The copy has a time of its own. (transfer full)
 */
char *install_module(const char *module, const char *folder, const char *name);

/* Writes a file of a folder; answers its path. (transfer full) */
char *install_text(const char *text, const char *folder, const char *name);

/* The manifest of a library, made in a child process by the probe stub. (transfer full) */
char *describe(const char *path);

/* How often the probe has been started. */
guint probe_count(const Place *place);

/* The entry of the library with this path, which must be there. Valid until the library is identified again. */
const TinkerLibraryEntry *entry_of(TinkerCatalogue *catalogue, const char *path);

/* How many a list of the catalogue has; frees it. */
guint count_of(GPtrArray *list);

/* Fails the test unless the text of this number is the one. */
void expect_text(GPtrArray *texts, guint number, const char *text);

/* Sets a file's time of last change, in ns since 1970. */
void set_mtime(const char *path, gint64 mtime_ns);

/* Whether one of the warnings is just this text. */
gboolean has_warning(TinkerCatalogue *catalogue, const char *text);

#endif

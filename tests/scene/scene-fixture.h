/* What the tests of scenes share: a catalogue of the real blocks and of one that has every kind of property, and
 * reading and writing of texts. A test program serves as its own probe. */
#ifndef TEST_SCENE_FIXTURE_H
#define TEST_SCENE_FIXTURE_H

#include "scene/read/scene-json.h"

/* Replaces g_test_init and g_test_run; answers the exit status. `add_tests` registers the tests. */
int scene_fixture_main(int argc, char **argv, void (*add_tests)(void));

/* Replaces g_test_init and g_test_run, with the test plugins of another folder, which is relative to the folder of
 * built tests. */
int scene_fixture_main_with(int argc, char **argv, const char *plugins, void (*add_tests)(void));

TinkerCatalogue *scene_fixture_catalogue(void);
const TinkerBlockClass *scene_fixture_class(const char *type);

/* Reads a scene that must be good, with no more than warnings. (transfer full) */
TinkerScene *scene_fixture_read(const char *text);

/* Reads a good scene with these lines as `blocks`. (transfer full) */
TinkerScene *scene_fixture_read_blocks(const char *blocks);

/* All findings, a line each, "LINE:COLUMN: [warning: ]message". (transfer full) */
char *scene_fixture_findings(const char *text, gssize length, const char *path);

/* A scene with a bit of everything. */
extern const char scene_fixture_example[];

#endif

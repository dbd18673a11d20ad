/* What the tests of the window's parts without widgets share: a document on the real blocks. */
#ifndef TEST_GUI_FIXTURE_H
#define TEST_GUI_FIXTURE_H

#include "player.h"

/* Replaces g_test_init and g_test_run; answers the exit status. `add_tests` registers the tests. */
int gui_fixture_main(int argc, char **argv, void (*add_tests)(void));

/* The catalogue of this build's plugins; lives as long as the program. */
TinkerCatalogue *gui_fixture_catalogue(void);

/* A document with these members of a scene ("\"blocks\": [...]"), which must be good. (transfer full) */
TinkerDocument *gui_fixture_document(const char *members);

TinkerBlockId gui_fixture_block(TinkerDocument *document, const char *name);

/* Sets a property in a step of its own, as an entry of the panel does. */
void gui_fixture_set(TinkerDocument *document, const char *block, const char *property, double x, double y);

/* The scene as it would be saved. (transfer full) */
char *gui_fixture_text(TinkerDocument *document);

#endif

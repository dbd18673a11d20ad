/* What the tests of documents share: a catalogue of the installed blocks, folders of their own, a document to edit. */
#ifndef TEST_FILES_FIXTURE_H
#define TEST_FILES_FIXTURE_H

#include "gui/document/document.h"

/* Replaces g_test_init and g_test_run, in a state folder that nobody else has. Where the program is called as `PROGRAM
 * child WORD`, it does `child` instead (may be NULL) and ends. */
int files_fixture_main(int argc, char **argv, void (*add_tests)(void), void (*child)(const char *word));

TinkerCatalogue *files_fixture_catalogue(void);

/* A folder of this run; everything in it goes when the run ends. (transfer full) */
char *files_fixture_folder(void);
/* The path of a new file of this name in a new folder, with this text. (transfer full) */
char *files_fixture_file(const char *name, const char *text);

/* A scene with two blocks that are connected by a third. */
extern const char files_fixture_scene[];

/* A document that holds it, without a path. (transfer full) */
TinkerDocument *files_fixture_document(void);

/* One edit, as one step: renames the first block. */
void files_fixture_rename(TinkerDocument *document, const char *name);
/* What the first block is called. */
const char *files_fixture_first_name(TinkerDocument *document);

#endif

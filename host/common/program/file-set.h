/* The files of one command: those that it reads and those that it writes. A file that is to be written must have no
 * other part in the command: a record over the table that drives the scene, or two outputs in one file, would lose what
 * they hold.
 *
 * Two names mean one file where both lead to it, through links, too: by device and inode where there is a file, else by
 * its folder's and its name there. Regular files only: pipes and devices, such as /dev/null, can be written to by
 * several. */
#ifndef TINKER_HOST_FILE_SET_H
#define TINKER_HOST_FILE_SET_H

#include "scene/store/scene.h"

typedef struct _TinkerFileSet TinkerFileSet;

/* (transfer full) */
TinkerFileSet *tinker_file_set_new(void);
void tinker_file_set_free(TinkerFileSet *files);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFileSet, tinker_file_set_free)

/* Adds a scene's file, which may be "-", standard input. */
void tinker_file_set_add_scene(TinkerFileSet *files, const char *path);
/* Adds a plugin's library that is open or read. */
void tinker_file_set_add_library(TinkerFileSet *files, const char *path);
/* Adds what a scene reads beside its own file: the tables in the folder of the file `base` (NULL: the scene has none),
 * and the opened libraries. */
void tinker_file_set_add_sources(TinkerFileSet *files, TinkerScene *scene, const char *base);

/* Adds an output, which may be "-", standard output. `option` is how it was asked for ("--csv"); NULL: the path says
 * it. TINKER_CLI_ERROR_USAGE with both names where one that was added before is the same file, or standard output as
 * well. */
gboolean tinker_file_set_add_output(TinkerFileSet *files, const char *option, const char *path, GError **error);

#endif

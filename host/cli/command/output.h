/* Outputs: a file by its name, or standard output as "-". */
#ifndef TINKER_CLI_OUTPUT_H
#define TINKER_CLI_OUTPUT_H

#include <stdio.h>

#include "common/program/file-set.h"

/* An output as it was asked for. */
typedef struct {
    const char *option; /* "--csv"; NULL ends a list */
    const char *path;   /* NULL: it was not asked for */
} TinkerAskedOutput;

/* Adds outputs to the files that a command reads; called before any of them is opened. TINKER_CLI_ERROR_USAGE where one
 * is such a file, or another output, or the file that the shell has put in the place of standard output. */
gboolean tinker_outputs_add(TinkerFileSet *files, const TinkerAskedOutput *outputs, GError **error);

typedef struct {
    FILE *file;     /* NULL: none is open */
    int descriptor; /* of the same */
    char *name;     /* as messages call it; owned */
    int reason;     /* errno of the first tinker_output_lines that failed; 0: none */
} TinkerOutput;

/* Opens a file for writing; "-" is standard output. It has been added to the command's files.
 * TINKER_CLI_ERROR_FILE where it cannot be written. */
gboolean tinker_output_open(TinkerOutput *output, const char *path, GError **error);

/* Writes out what is buffered and closes; nothing where none is open. TINKER_CLI_ERROR_FILE where that, or any write
 * before it, failed. */
gboolean tinker_output_close(TinkerOutput *output, GError **error);

/* Writes whole lines, of which the file then holds only whole ones (files/write-lines.h). For an output that nothing
 * else is written to. What goes wrong is told by tinker_output_check and tinker_output_close; after that nothing more
 * is written. */
void tinker_output_lines(TinkerOutput *output, const char *text, gsize size);

/* Sets TINKER_CLI_ERROR_FILE if a write has failed. */
gboolean tinker_output_check(const TinkerOutput *output, GError **error);

/* Closes without a word: the way out after another error. */
void tinker_output_clear(TinkerOutput *output);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerOutput, tinker_output_clear)

gboolean tinker_is_standard_stream(const char *path);

/* Checks before long work that a file of this name can be written, without changing one that is there. */
gboolean tinker_output_is_writable(const char *path, GError **error);

#endif

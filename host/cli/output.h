/* Outputs: a file by its name, or standard output as "-". */
#ifndef TINKER_CLI_OUTPUT_H
#define TINKER_CLI_OUTPUT_H

#include <glib.h>
#include <stdio.h>

typedef struct {
    FILE *file; /* NULL: none is open */
    char *name; /* as messages call it; owned */
    int reason; /* errno of the first write that was seen to fail; 0: none */
} TinkerOutput;

/* Opens a file for writing; "-" is standard output. `input` (may be NULL) is a file that must not be overwritten: the
 * scene. TINKER_CLI_ERROR_FILE where it cannot be written. */
gboolean tinker_output_open(TinkerOutput *output, const char *path, const char *input, GError **error);

/* Writes out what is buffered and closes; nothing where none is open. TINKER_CLI_ERROR_FILE where that, or any write
 * before it, failed. */
gboolean tinker_output_close(TinkerOutput *output, GError **error);

/* Writes text, and out what is buffered; what goes wrong is told by tinker_output_check and tinker_output_close. */
void tinker_output_flush(TinkerOutput *output, const char *text, gsize size);

/* Sets TINKER_CLI_ERROR_FILE if a write has failed. */
gboolean tinker_output_check(const TinkerOutput *output, GError **error);

/* Closes without a word: the way out after another error. */
void tinker_output_clear(TinkerOutput *output);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerOutput, tinker_output_clear)

gboolean tinker_is_standard_stream(const char *path);

/* Checks before long work that a file of this name can be written, without changing one that is there. */
gboolean tinker_output_is_writable(const char *path, GError **error);

#endif

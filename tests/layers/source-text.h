/* What the tests of the layers read out of a source file: its includes and its string literals. */
#ifndef TEST_SOURCE_TEXT_H
#define TEST_SOURCE_TEXT_H

#include <glib.h>

/* All .c and .h files under a folder, as paths relative to it; sorted. (transfer full) */
GPtrArray *source_files(const char *folder);

/* The file's text without comments, line structure kept. (transfer full) */
char *source_without_comments(const char *path);

/* What the text includes: "<glib.h>" or "\"scene/scene.h\"", with the brackets or quotes; of char *. (transfer full) */
GPtrArray *source_includes(const char *text);

/* The contents of its string literals, as written, but for those of include lines; of char *. (transfer full) */
GPtrArray *source_literals(const char *text);

/* What a program that reads binaries says of one of them; fails the test where it fails. `arguments` end with NULL, the
 * first of them is the program. (transfer full) */
char *source_output_of(const char *const *arguments);

/* Whether a text begins with one of these, the last of which is NULL. */
gboolean source_begins_with_one_of(const char *text, const char *const *beginnings);

#endif

/* Writing a file as a whole: a reader, a crash or a full disk sees the old file or the new one, never a part. */
#ifndef TINKER_CORE_REPLACE_FILE_H
#define TINKER_CORE_REPLACE_FILE_H

#include <glib.h>

/* Makes the file, or puts it in the place of the one that is there, once it has reached the disk. A link stays a link:
 * the file that it leads to is replaced. One that is replaced keeps its permissions; a new one has `mode`, as in
 * open(2). What is no regular file, a pipe or a device, is written into. On failure nothing is left, and what was there
 * is as it was. Errors: G_FILE_ERROR, whose message is the reason alone ("No space left on device"). */
gboolean tinker_replace_file(const char *path, const char *bytes, gsize length, int mode, GError **error);

#endif

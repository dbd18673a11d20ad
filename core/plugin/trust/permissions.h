/* Who could have changed a library. */
#ifndef TINKER_PLUGIN_PERMISSIONS_H
#define TINKER_PLUGIN_PERMISSIONS_H

#include "plugin/trust/plugin-error.h"

/* Refuses a file that others than root, this user and the owner of this program can write to: by owner, by everybody,
 * by a group that has other members, or by an access control list that names any. All folders above it likewise, and
 * where symbolic links are on the way, all places that they lead to, and who owns the links. `path` is absolute. */
gboolean tinker_permissions_check(const char *path, GError **error);

/* The text of a regular file of at most so many bytes that passes that check. NULL with an error otherwise.
 * (transfer full) */
char *tinker_read_trusted(const char *path, gsize most_bytes, GError **error);

#endif

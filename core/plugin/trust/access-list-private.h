/* Access control lists (POSIX.1e, draft 17): users and groups, named one by one, who may do to a file what its mode
 * does not tell. */
#ifndef TINKER_PLUGIN_ACCESS_LIST_PRIVATE_H
#define TINKER_PLUGIN_ACCESS_LIST_PRIVATE_H

#include <glib.h>
#include <sys/stat.h>

/* Refuses a file or folder that a group or, by its list, a named user or group may write to, of whom we do not trust
 * everybody. `what` names it in the message. Its owner and everybody are not looked at: the mode tells of them. */
gboolean tinker_access_list_check(const char *path, const struct stat *status, const char *what, GError **error);

#endif

/* The accounts of the system: whom we trust, and who else is in a group. */
#ifndef TINKER_PLUGIN_ACCOUNTS_PRIVATE_H
#define TINKER_PLUGIN_ACCOUNTS_PRIVATE_H

#include <glib.h>
#include <sys/types.h>

/* Root, this user and the owner of this program. */
gboolean tinker_account_is_trusted(uid_t user);

/* The owner of this program. */
uid_t tinker_account_of_program(void);

/* The name of a member of the group whom we do not trust, or words that say that the members are not known; NULL where
 * there is none. Any thread. (transfer full) */
char *tinker_account_in_group(gid_t group);

#endif

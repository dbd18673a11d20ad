/* Members of a group are those in its list, and those whose own group it is, who stand in no list: to know them all
 * accounts have to be gone through. That is done once. */
#include "plugin/trust/accounts-private.h"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

static GMutex mutex;           /* getgrgid and getpwent answer static memory */
static GHashTable *own_groups; /* group to the name of the first account that we do not trust and whose own it is */

uid_t tinker_account_of_program(void)
{
    struct stat status;
    return stat("/proc/self/exe", &status) == 0 ? status.st_uid : geteuid();
}

gboolean tinker_account_is_trusted(uid_t user)
{
    return user == 0 || user == geteuid() || user == tinker_account_of_program();
}

/* Called with the mutex held, as what follows. */
static char *by_list(gid_t group)
{
    const struct group *entry = getgrgid(group);
    if (entry == NULL) return g_strdup("members that are not known");
    // The list is copied: looking up a user may overwrite it.
    g_auto(GStrv) members = g_strdupv(entry->gr_mem);
    for (char **member = members; *member != NULL; member++) {
        const struct passwd *user = getpwnam(*member);
        if (user != NULL && !tinker_account_is_trusted(user->pw_uid)) return g_strdup(*member);
    }
    return NULL;
}

static void go_through_accounts(void)
{
    own_groups = g_hash_table_new_full(NULL, NULL, NULL, g_free);
    setpwent();
    for (const struct passwd *user = getpwent(); user != NULL; user = getpwent()) {
        gpointer group = GUINT_TO_POINTER(user->pw_gid);
        if (!tinker_account_is_trusted(user->pw_uid) && !g_hash_table_contains(own_groups, group))
            g_hash_table_insert(own_groups, group, g_strdup(user->pw_name));
    }
    endpwent();
}

static char *by_own_group(gid_t group)
{
    if (own_groups == NULL) go_through_accounts();
    return g_strdup(g_hash_table_lookup(own_groups, GUINT_TO_POINTER(group)));
}

char *tinker_account_in_group(gid_t group)
{
    g_mutex_lock(&mutex);
    char *found = by_list(group);
    if (found == NULL) found = by_own_group(group);
    g_mutex_unlock(&mutex);
    return found;
}

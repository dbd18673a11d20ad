/* Linux keeps the list in an extended attribute, little-endian: a version, then entries of kind, permissions and
 * number. Where there is one, the mode's bits of the group are its mask: the most that a named user, a named group or
 * the owning group may do. Without the bit to write, none of them may. */
#include "plugin/trust/access-list-private.h"

#include <errno.h>
#include <linux/posix_acl.h>
#include <linux/posix_acl_xattr.h>
#include <string.h>
#include <sys/xattr.h>

#include "plugin/trust/accounts-private.h"
#include "plugin/trust/refuse.h"

#define ATTRIBUTE  "system.posix_acl_access"
#define MOST_BYTES 65536 /* of an attribute, by the kernel */

static gboolean check_group(gid_t group, const char *what, unsigned mode, GError **error)
{
    g_autofree char *member = tinker_account_in_group(group);
    if (member == NULL) return TRUE;
    return tinker_refuse(error, "%s can be written by the group %u, which has other members (%s; mode %04o)", what,
                         group, member, mode);
}

static gboolean check_user(uid_t user, const char *what, unsigned mode, GError **error)
{
    if (tinker_account_is_trusted(user)) return TRUE;
    return tinker_refuse(error, "%s can be written by the user %u, whom its access control list names (mode %04o)",
                         what, user, mode);
}

static gboolean check_entry(const struct posix_acl_xattr_entry *entry, const struct stat *status, const char *what,
                            GError **error)
{
    const unsigned mode = status->st_mode & 07777;
    const guint32 number = GUINT32_FROM_LE(entry->e_id);
    if ((GUINT16_FROM_LE(entry->e_perm) & ACL_WRITE) == 0) return TRUE;
    switch (GUINT16_FROM_LE(entry->e_tag)) {
    case ACL_USER:
        return check_user(number, what, mode, error);
    case ACL_GROUP:
        return check_group(number, what, mode, error);
    case ACL_GROUP_OBJ:
        return check_group(status->st_gid, what, mode, error);
    default:
        return TRUE; // owner, everybody, mask
    }
}

/* The attribute's bytes; NULL without an error where there is no list, or the file system knows of none. (transfer
 * full) */
static char *read_list(const char *path, gsize *length, const char *what, GError **error)
{
    g_autofree char *bytes = g_malloc(MOST_BYTES);
    const ssize_t got = getxattr(path, ATTRIBUTE, bytes, MOST_BYTES);
    if (got >= 0) {
        *length = (gsize)got;
        return g_steal_pointer(&bytes);
    }
    if (errno != ENODATA && errno != EOPNOTSUPP)
        tinker_fail_file(error, "the access control list of %s cannot be read: %s", what, g_strerror(errno));
    return NULL;
}

gboolean tinker_access_list_check(const char *path, const struct stat *status, const char *what, GError **error)
{
    if ((status->st_mode & S_IWGRP) == 0) return TRUE;
    g_autoptr(GError) unread = NULL;
    gsize length;
    g_autofree char *bytes = read_list(path, &length, what, &unread);
    if (unread != NULL) {
        g_propagate_error(error, g_steal_pointer(&unread));
        return FALSE;
    }
    if (bytes == NULL) return check_group(status->st_gid, what, status->st_mode & 07777, error);

    struct posix_acl_xattr_header header = {0};
    memcpy(&header, bytes, MIN(length, sizeof header));
    if (GUINT32_FROM_LE(header.a_version) != POSIX_ACL_XATTR_VERSION)
        return tinker_refuse(error, "%s has an access control list of version %u, %d is known", what,
                             GUINT32_FROM_LE(header.a_version), POSIX_ACL_XATTR_VERSION);
    struct posix_acl_xattr_entry entry;
    for (gsize at = sizeof header; at + sizeof entry <= length; at += sizeof entry) {
        memcpy(&entry, bytes + at, sizeof entry);
        if (!check_entry(&entry, status, what, error)) return FALSE;
    }
    return TRUE;
}

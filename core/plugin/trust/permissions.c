/* Permissions of a library, of its folder, and of all folders and links on the way to it. */
#include "plugin/trust/permissions.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "plugin/trust/access-list-private.h"
#include "plugin/trust/accounts-private.h"
#include "plugin/trust/refuse.h"

#define MOST_LINKS 40 /* as the system */

static gboolean check_owner(uid_t owner, const char *what, GError **error)
{
    return tinker_account_is_trusted(owner) ||
           tinker_refuse(error,
                         "%s belongs to the user %u, not to root, to you (%u) or to the owner of this program (%u)",
                         what, owner, geteuid(), tinker_account_of_program());
}

static gboolean check_one(const char *path, const char *what, GError **error)
{
    struct stat status;
    if (stat(path, &status) != 0) return tinker_fail_file(error, "%s cannot be read: %s", what, g_strerror(errno));
    const unsigned mode = status.st_mode & 07777;
    if (!check_owner(status.st_uid, what, error)) return FALSE;
    if ((mode & S_IWOTH) != 0)
        return tinker_refuse(error, "%s can be written by everybody (mode %04o); only its owner may", what, mode);
    return tinker_access_list_check(path, &status, what, error);
}

/* Who may write to a folder above can put another folder in the place of the library's. A sticky bit prevents that. */
static gboolean check_above(const char *folder, GError **error)
{
    g_autofree char *above = g_path_get_dirname(folder);
    if (strcmp(above, folder) == 0) return TRUE;
    struct stat status;
    g_autofree char *what = g_strdup_printf("the folder \"%s\" above it", above);
    const gboolean sticky =
        stat(above, &status) == 0 && (status.st_mode & S_ISVTX) != 0 && tinker_account_is_trusted(status.st_uid);
    return (sticky || check_one(above, what, error)) && check_above(above, error);
}

static gboolean check_with_folders(const char *path, GError **error)
{
    g_autofree char *folder = g_path_get_dirname(path);
    return check_one(path, "it", error) && check_one(folder, "its folder", error) && check_above(folder, error);
}

/* The first link on the way to an absolute path, and what of the path is behind it; NULL: there is none. Steps back
 * ("..") are taken from what is there. (transfer full) */
static char *first_link(const char *path, const char **rest)
{
    g_autoptr(GString) way = g_string_new(NULL);
    for (const char *from = path; *from != '\0'; from = *rest) {
        from += strspn(from, "/");
        const gsize length = strcspn(from, "/");
        *rest = from + length;
        if (length == 0 || (length == 1 && from[0] == '.')) continue;
        if (length == 2 && strncmp(from, "..", 2) == 0) {
            const char *last = strrchr(way->str, '/');
            g_string_truncate(way, last != NULL ? (gsize)(last - way->str) : 0);
            continue;
        }
        g_string_append_c(way, '/');
        g_string_append_len(way, from, (gssize)length);
        struct stat status;
        if (lstat(way->str, &status) == 0 && S_ISLNK(status.st_mode)) return g_strdup(way->str);
    }
    return NULL;
}

/* Checks the link, with what is left of the way behind it, and answers the path with this link followed; NULL with an
 * error. (transfer full) */
static char *follow(const char *link, const char *rest, GError **error)
{
    struct stat status;
    g_autoptr(GError) unread = NULL;
    g_autofree char *what = g_strdup_printf("the link \"%s\" on the way to it", link);
    g_autofree char *target = g_file_read_link(link, &unread), *folder = g_path_get_dirname(link);
    if (target == NULL || lstat(link, &status) != 0) {
        tinker_fail_file(error, "%s cannot be read: %s", what, unread != NULL ? unread->message : g_strerror(errno));
        return NULL;
    }
    // In a folder with a sticky bit, the owner of a link can let it lead elsewhere.
    if (!check_owner(status.st_uid, what, error)) return NULL;
    return target[0] == '/' ? g_strconcat(target, rest, NULL) : g_strconcat(folder, "/", target, rest, NULL);
}

gboolean tinker_permissions_check(const char *path, GError **error)
{
    g_autofree char *at = g_strdup(path);
    for (int links = 0; links <= MOST_LINKS; links++) {
        const char *rest = NULL;
        if (!check_with_folders(at, error)) {
            if (links > 0) g_prefix_error(error, "it leads to \"%s\": ", at);
            return FALSE;
        }
        g_autofree char *link = first_link(at, &rest);
        if (link == NULL) return TRUE;
        char *next = follow(link, rest, error);
        if (next == NULL) return FALSE;
        g_free(at);
        at = next;
    }
    return tinker_fail_file(error, "it cannot be read: %s", g_strerror(ELOOP));
}

char *tinker_read_trusted(const char *path, gsize most_bytes, GError **error)
{
    struct stat status;
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0 || fstat(file, &status) != 0) {
        tinker_fail_file(error, "it cannot be read: %s", g_strerror(errno));
        if (file >= 0) close(file);
        return NULL;
    }
    char *text = NULL;
    if (!S_ISREG(status.st_mode)) {
        tinker_refuse(error, "it is not a regular file");
    } else if ((guint64)status.st_size > most_bytes) {
        tinker_refuse(error, "it has %" G_GINT64_FORMAT " bytes, at most %zu are read", (gint64)status.st_size,
                      most_bytes);
    } else if (tinker_permissions_check(path, error)) {
        text = g_malloc0((gsize)status.st_size + 1);
        if (read(file, text, (gsize)status.st_size) != status.st_size) {
            g_clear_pointer(&text, g_free);
            tinker_fail_file(error, "it cannot be read as a whole");
        }
    }
    close(file);
    return text;
}

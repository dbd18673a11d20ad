/* Beside its place, to the disk, and then renamed. The functions answer 0 or the errno of what failed. */
#include "files/replace-file.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "files/unfinished.h"

static int write_all(int file, const char *bytes, gsize length)
{
    while (length > 0) {
        const gssize written = write(file, bytes, length);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes += written;
        length -= (gsize)written;
    }
    return 0;
}

/* Closes it, which may be when the system finds that there is no room. */
static int end_file(int file, int reason)
{
    const gboolean closed = close(file) == 0;
    return reason == 0 && !closed ? errno : reason;
}

static int write_into(const char *path, const char *bytes, gsize length)
{
    const int file = g_open(path, O_WRONLY | O_CLOEXEC, 0);
    return file < 0 ? errno : end_file(file, write_all(file, bytes, length));
}

/* Through another descriptor than the lock's, so that the file can be closed before it gets its name. */
static int write_to_disk(const TinkerUnfinished *unfinished, const char *bytes, gsize length, const GStatBuf *replaced)
{
    const int file = fcntl(unfinished->file, F_DUPFD_CLOEXEC, 0);
    if (file < 0) return errno;
    if (replaced != NULL) (void)fchmod(file, replaced->st_mode & 07777);
    int reason = write_all(file, bytes, length);
    if (reason == 0 && fsync(file) != 0) reason = errno;
    return end_file(file, reason);
}

static int replace(const char *place, const char *bytes, gsize length, int mode, const GStatBuf *replaced)
{
    g_autofree char *folder = g_path_get_dirname(place);
    g_auto(TinkerUnfinished) unfinished = {NULL, -1};
    tinker_unfinished_clean(folder);
    if (!tinker_unfinished_file(&unfinished, folder, "", mode)) return errno;
    const int reason = write_to_disk(&unfinished, bytes, length, replaced);
    if (reason != 0) return reason;
    return tinker_unfinished_finish(&unfinished, place) ? 0 : errno;
}

gboolean tinker_replace_file(const char *path, const char *bytes, gsize length, int mode, GError **error)
{
    char *real = realpath(path, NULL);
    const char *place = real != NULL ? real : path;
    GStatBuf status;
    const gboolean exists = g_stat(place, &status) == 0;
    const int reason = exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)
                           ? write_into(place, bytes, length)
                           : replace(place, bytes, length, mode, exists ? &status : NULL);
    free(real);
    if (reason == 0) return TRUE;
    g_set_error_literal(error, G_FILE_ERROR, (int)g_file_error_from_errno(reason), g_strerror(reason));
    return FALSE;
}

/* Thin covers of the system's calls. */
#include "files/file-lock.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <sys/file.h>

gboolean tinker_file_lock(int file, gboolean wait)
{
    int result;
    do
        result = flock(file, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
    while (result != 0 && errno == EINTR);
    return result == 0;
}

gboolean tinker_file_is_at(int file, const char *path)
{
    GStatBuf named, opened;
    return g_lstat(path, &named) == 0 && fstat(file, &opened) == 0 && named.st_dev == opened.st_dev &&
           named.st_ino == opened.st_ino;
}

/* Locks on files, which tell whether the process that holds one is alive: they end with it, however it ends. They hold
 * between all processes of a machine, also where those have process numbers of their own, as in containers. */
#ifndef TINKER_CORE_FILE_LOCK_H
#define TINKER_CORE_FILE_LOCK_H

#include <glib.h>

/* Locks what a descriptor has open (flock(2)); waits for another process that holds it, or answers FALSE at once. FALSE
 * with errno, EWOULDBLOCK where another process holds it; another one where the file system has no locks. */
gboolean tinker_file_lock(int file, gboolean wait);

/* Whether what the descriptor has open is still under this name: whoever finds a file before it is locked may remove
 * it. */
gboolean tinker_file_is_at(int file, const char *path);

#endif

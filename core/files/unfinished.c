/* Between making a file and locking it somebody else may take it for a dead one and remove it: so it is looked for
 * again once it is locked, and made anew where it is gone. */
#include "files/unfinished.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#include "files/file-lock.h"

#define PREFIX  ".tinker-part-"
#define LETTERS 6 /* of g_mkstemp and its like */

/* Making ----------------------------------------------------------------------------------------------------------- */

static void forget(TinkerUnfinished *unfinished)
{
    const int reason = errno;
    if (unfinished->file >= 0) close(unfinished->file);
    g_clear_pointer(&unfinished->path, g_free);
    unfinished->file = -1;
    errno = reason;
}

static int make_file(char *path, int mode)
{
    return g_mkstemp_full(path, O_RDWR | O_CLOEXEC, mode);
}

static int make_folder(char *path, int mode)
{
    return g_mkdtemp_full(path, mode) != NULL ? g_open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0) : -1;
}

static gboolean make(TinkerUnfinished *unfinished, const char *folder, const char *ending, int mode,
                     int (*maker)(char *path, int mode))
{
    g_autofree char *name = g_strconcat(PREFIX "XXXXXX", ending, NULL);
    for (;;) {
        *unfinished = (TinkerUnfinished){g_build_filename(folder, name, NULL), -1};
        unfinished->file = maker(unfinished->path, mode);
        if (unfinished->file < 0) {
            forget(unfinished);
            return FALSE;
        }
        // Without locks nobody removes it, either.
        (void)tinker_file_lock(unfinished->file, TRUE);
        if (tinker_file_is_at(unfinished->file, unfinished->path)) return TRUE;
        forget(unfinished);
    }
}

gboolean tinker_unfinished_file(TinkerUnfinished *unfinished, const char *folder, const char *ending, int mode)
{
    return make(unfinished, folder, ending, mode, make_file);
}

gboolean tinker_unfinished_folder(TinkerUnfinished *unfinished, const char *folder)
{
    return make(unfinished, folder, "", 0700, make_folder);
}

gboolean tinker_unfinished_finish(TinkerUnfinished *unfinished, const char *place)
{
    if (g_rename(unfinished->path, place) != 0) return FALSE;
    forget(unfinished);
    return TRUE;
}

/* Removing --------------------------------------------------------------------------------------------------------- */

static void remove_folder(const char *path)
{
    g_autoptr(GDir) dir = g_dir_open(path, 0, NULL);
    for (const char *name = dir != NULL ? g_dir_read_name(dir) : NULL; name != NULL; name = g_dir_read_name(dir)) {
        g_autofree char *file = g_build_filename(path, name, NULL);
        g_unlink(file);
    }
    g_rmdir(path);
}

static void remove_path(const char *path)
{
    if (g_unlink(path) != 0 && (errno == EISDIR || errno == EPERM)) remove_folder(path);
}

void tinker_unfinished_clear(TinkerUnfinished *unfinished)
{
    if (unfinished->path == NULL) return;
    remove_path(unfinished->path);
    forget(unfinished);
}

/* PREFIX, the letters, and nothing or an ending. */
static gboolean is_name(const char *name)
{
    if (!g_str_has_prefix(name, PREFIX)) return FALSE;
    const char *letters = name + strlen(PREFIX);
    for (int i = 0; i < LETTERS; i++)
        if (!g_ascii_isalnum(letters[i])) return FALSE;
    return letters[LETTERS] == '\0' || letters[LETTERS] == '.';
}

static void remove_dead(const char *path)
{
    GStatBuf status;
    TinkerUnfinished found = {g_strdup(path), g_open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0)};
    const gboolean is_own = found.file >= 0 && fstat(found.file, &status) == 0 && status.st_uid == geteuid() &&
                            (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode));
    if (is_own && tinker_file_lock(found.file, FALSE) && tinker_file_is_at(found.file, path)) remove_path(path);
    forget(&found);
}

void tinker_unfinished_clean(const char *folder)
{
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *name = dir != NULL ? g_dir_read_name(dir) : NULL; name != NULL; name = g_dir_read_name(dir)) {
        if (!is_name(name)) continue;
        g_autofree char *path = g_build_filename(folder, name, NULL);
        remove_dead(path);
    }
}

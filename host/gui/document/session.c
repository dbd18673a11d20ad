/* The lock lies in a file of its own, which is neither moved nor replaced as the copies are. */
#include "gui/document/session.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#include "files/file-lock.h"

static int lock = -1;

const char *tinker_session_name(void)
{
    static char *name;
    if (name == NULL) name = g_uuid_string_random();
    return name;
}

char *tinker_session_of_file(const char *file)
{
    g_autofree char *name = g_path_get_basename(file);
    name[strcspn(name, ".")] = '\0';
    /* the name itself has hyphens, and a file of ours a number behind the last one */
    char *number = strrchr(name, '-');
    if (number != NULL && strlen(number) < 12) *number = '\0';
    return g_steal_pointer(&name);
}

char *tinker_session_folder(void)
{
    return g_build_filename(g_get_user_state_dir(), "tinker", "autosave", NULL);
}

static char *lock_path(const char *name)
{
    g_autofree char *folder = tinker_session_folder();
    return g_strdup_printf("%s/%s" TINKER_SESSION_LOCK, folder, name);
}

/* Holding ---------------------------------------------------------------------------------------------------------- */

static void close_lock(void)
{
    if (lock >= 0) close(lock);
    lock = -1;
}

/* Somebody who tidies up may find it before it is locked. */
static gboolean make_lock(const char *path)
{
    do {
        close_lock();
        lock = g_open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (lock < 0) return FALSE;
        (void)tinker_file_lock(lock, TRUE);
    } while (!tinker_file_is_at(lock, path));
    return TRUE;
}

gboolean tinker_session_hold(GError **error)
{
    g_autofree char *folder = tinker_session_folder(), *path = lock_path(tinker_session_name());
    /* the user may have removed the folder meanwhile */
    if (lock >= 0 && tinker_file_is_at(lock, path)) return TRUE;
    const char *failed = g_mkdir_with_parents(folder, 0700) != 0 ? folder : !make_lock(path) ? path : NULL;
    if (failed == NULL) return TRUE;
    const int reason = errno;
    g_set_error(error, G_FILE_ERROR, (int)g_file_error_from_errno(reason), "%s: %s", failed, g_strerror(reason));
    return FALSE;
}

static gboolean has_files(const char *name)
{
    g_autofree char *folder = tinker_session_folder(), *beginning = g_strconcat(name, "-", NULL);
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *file = dir != NULL ? g_dir_read_name(dir) : NULL; file != NULL; file = g_dir_read_name(dir))
        if (g_str_has_prefix(file, beginning)) return TRUE;
    return FALSE;
}

void tinker_session_release(void)
{
    if (lock < 0 || has_files(tinker_session_name())) return;
    g_autofree char *path = lock_path(tinker_session_name());
    g_unlink(path);
    close_lock();
}

/* Others ----------------------------------------------------------------------------------------------------------- */

/* Its lock, where nobody else holds it; -1: somebody does, or there is none. */
static int take_lock(const char *path, gboolean *held)
{
    const int file = g_open(path, O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0);
    *held = file >= 0 && !tinker_file_lock(file, FALSE) && errno == EWOULDBLOCK;
    if (file >= 0 && *held) close(file);
    return *held ? -1 : file;
}

gboolean tinker_session_is_alive(const char *name)
{
    if (strcmp(name, tinker_session_name()) == 0) return TRUE;
    g_autofree char *path = lock_path(name);
    gboolean held;
    const int file = take_lock(path, &held);
    if (file >= 0) close(file);
    return held;
}

static void purge(const char *name)
{
    g_autofree char *path = lock_path(name);
    gboolean held;
    const int file = take_lock(path, &held);
    if (file >= 0 && !has_files(name)) g_unlink(path);
    if (file >= 0) close(file);
}

void tinker_session_purge(void)
{
    g_autofree char *folder = tinker_session_folder();
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *file = dir != NULL ? g_dir_read_name(dir) : NULL; file != NULL; file = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(file, TINKER_SESSION_LOCK)) continue;
        g_autofree char *name = g_strndup(file, strlen(file) - strlen(TINKER_SESSION_LOCK));
        if (strcmp(name, tinker_session_name()) != 0) purge(name);
    }
}

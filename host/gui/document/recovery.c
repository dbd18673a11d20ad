/* Files are moved, never copied, so that of several processes that find the same one only one gets it. */
#include "gui/document/recovery.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>
#include <string.h>
#include <utime.h>

#include "files/unfinished.h"
#include "gui/document/autosave.h"
#include "gui/document/session.h"
#include "plugin/call/crash.h"

#define CRASH_NOTE   ".crash" /* of a session: NAME.crash */
#define KEPT_SECONDS ((gint64)7 * 24 * 3600)

static void recovery_free(gpointer data)
{
    TinkerRecovery *recovery = data;
    g_free(recovery->stem);
    g_free(recovery->name);
    g_free(recovery->blame);
    g_free(recovery->writer);
    g_free(recovery->origin.path);
    g_free(recovery->origin.base);
    g_free(recovery->origin.checksum);
    g_free(recovery);
}

char *tinker_recovery_discarded_folder(void)
{
    return g_build_filename(g_get_user_state_dir(), "tinker", "autosave-discarded", NULL);
}

/* Who was to blame ------------------------------------------------------------------------------------------------- */

static char *crash_note(const char *session)
{
    g_autofree char *folder = tinker_session_folder();
    return g_strdup_printf("%s/%s" CRASH_NOTE, folder, session);
}

void tinker_recovery_note_crashes(void)
{
    g_autofree char *path = crash_note(tinker_session_name());
    tinker_crash_set_note(path);
}

/* The message without the program's name before it; NULL where there is none. (transfer full) */
static char *read_crash_note(const char *session)
{
    g_autofree char *path = crash_note(session), *text = NULL;
    if (!g_file_get_contents(path, &text, NULL, NULL)) return NULL;
    const char *message = strstr(text, ": ");
    if (message == NULL || !g_utf8_validate(text, -1, NULL)) return NULL;
    return g_strchomp(g_strdup(message + 2));
}

static void remove_crash_note(const char *session)
{
    g_autofree char *path = crash_note(session);
    g_unlink(path);
}

/* NULL where the run has not ended. (transfer full) */
static char *take_note(const char *file)
{
    g_autofree char *session = tinker_session_of_file(file);
    if (tinker_session_is_alive(session)) return NULL;
    char *text = read_crash_note(session);
    remove_crash_note(session);
    return text;
}

char *tinker_recovery_take_blame(void)
{
    g_autofree char *folder = tinker_session_folder();
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    char *last = NULL;
    if (dir == NULL) return NULL;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(name, CRASH_NOTE)) continue;
        g_autofree char *text = take_note(name);
        if (text == NULL) continue;
        g_free(last);
        last = g_steal_pointer(&text);
    }
    return last;
}

/* The list --------------------------------------------------------------------------------------------------------- */

static gint64 time_of_file(const char *stem)
{
    g_autofree char *path = g_strconcat(stem, TINKER_AUTOSAVE_ENDING, NULL);
    GStatBuf status;
    return g_stat(path, &status) == 0 ? (gint64)status.st_mtime : 0;
}

static char *text_of(GKeyFile *info, const char *key)
{
    return g_key_file_get_string(info, TINKER_AUTOSAVE_GROUP, key, NULL);
}

/* A companion that cannot be read tells nothing; then the name of the file has to do. */
static TinkerRecovery *recovery_new(const char *stem, GKeyFile *info)
{
    TinkerRecovery *recovery = g_new0(TinkerRecovery, 1);
    recovery->stem = g_strdup(stem);
    recovery->origin = (TinkerDocumentOrigin){text_of(info, "path"), text_of(info, "base"), text_of(info, "checksum")};
    recovery->name = text_of(info, "name");
    if (recovery->name == NULL) recovery->name = g_strdup(_("Untitled"));
    recovery->time = g_key_file_get_int64(info, TINKER_AUTOSAVE_GROUP, "time", NULL);
    if (recovery->time <= 0) recovery->time = time_of_file(stem);
    recovery->writer = text_of(info, "session");
    if (recovery->writer == NULL) recovery->writer = tinker_session_of_file(stem);
    recovery->blame = read_crash_note(recovery->writer);
    return recovery;
}

static gint latest_first(gconstpointer a, gconstpointer b)
{
    const TinkerRecovery *left = *(TinkerRecovery *const *)a, *right = *(TinkerRecovery *const *)b;
    if (left->time != right->time) return left->time < right->time ? 1 : -1;
    return strcmp(left->stem, right->stem);
}

GPtrArray *tinker_recovery_list(void)
{
    GPtrArray *list = g_ptr_array_new_with_free_func(recovery_free);
    g_autofree char *folder = tinker_session_folder();
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    if (dir == NULL) return list;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(name, TINKER_AUTOSAVE_ENDING)) continue;
        g_autofree char *short_name = g_strndup(name, strlen(name) - strlen(TINKER_AUTOSAVE_ENDING));
        g_autofree char *stem = g_build_filename(folder, short_name, NULL);
        g_autofree char *info_path = g_strconcat(stem, TINKER_AUTOSAVE_INFO, NULL);
        g_autoptr(GKeyFile) info = g_key_file_new();
        g_key_file_load_from_file(info, info_path, G_KEY_FILE_NONE, NULL);
        // The name tells who has the file now; the companion says who wrote it, which differs where it has been taken
        // over.
        g_autofree char *owner = tinker_session_of_file(stem);
        if (!tinker_session_is_alive(owner)) g_ptr_array_add(list, recovery_new(stem, info));
    }
    g_ptr_array_sort(list, latest_first);
    return list;
}

/* Moving ----------------------------------------------------------------------------------------------------------- */

static int move_one(const char *from, const char *to, const char *ending)
{
    g_autofree char *source = g_strconcat(from, ending, NULL), *target = g_strconcat(to, ending, NULL);
    return g_rename(source, target);
}

/* The companion first: a copy is never without one. */
static gboolean move_both(TinkerRecovery *recovery, const char *to, GError **error)
{
    move_one(recovery->stem, to, TINKER_AUTOSAVE_INFO);
    if (move_one(recovery->stem, to, TINKER_AUTOSAVE_ENDING) != 0) {
        int code = errno;
        g_set_error(error, G_FILE_ERROR, (int)g_file_error_from_errno(code), _("“%s” cannot be taken over: %s"),
                    recovery->name, g_strerror(code));
        move_one(to, recovery->stem, TINKER_AUTOSAVE_INFO);
        return FALSE;
    }
    g_free(recovery->stem);
    recovery->stem = g_strdup(to);
    return TRUE;
}

gboolean tinker_recovery_open(TinkerRecovery *recovery, TinkerDocument *document, GError **error)
{
    g_autofree char *last = g_strdup(recovery->stem), *own = tinker_autosave_new_stem(), *text = NULL;
    gsize length;
    if (!tinker_session_hold(error) || !move_both(recovery, own, error)) return FALSE;
    g_autofree char *path = g_strconcat(own, TINKER_AUTOSAVE_ENDING, NULL);
    if (g_file_get_contents(path, &text, &length, error) &&
        tinker_document_recover(document, text, length, &recovery->origin, error))
        return TRUE;
    move_both(recovery, last, NULL);
    return FALSE;
}

void tinker_recovery_remove(TinkerRecovery *recovery)
{
    const char *const endings[] = {TINKER_AUTOSAVE_ENDING, TINKER_AUTOSAVE_INFO};
    for (gsize i = 0; i < G_N_ELEMENTS(endings); i++) {
        g_autofree char *path = g_strconcat(recovery->stem, endings[i], NULL);
        g_unlink(path);
    }
    remove_crash_note(recovery->writer);
    tinker_session_release();
}

gboolean tinker_recovery_discard(TinkerRecovery *recovery, GError **error)
{
    g_autofree char *folder = tinker_recovery_discarded_folder(), *name = g_path_get_basename(recovery->stem);
    g_autofree char *to = g_strdup_printf("%s/%s-%" G_GINT64_FORMAT, folder, name, g_get_real_time() / G_USEC_PER_SEC);
    g_mkdir_with_parents(folder, 0700);
    if (!move_both(recovery, to, error)) return FALSE;
    g_autofree char *path = g_strconcat(to, TINKER_AUTOSAVE_ENDING, NULL);
    remove_crash_note(recovery->writer);
    g_utime(path, NULL); /* the 7 days count from now */
    return TRUE;
}

static void purge(const char *folder, const char *ending)
{
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    if (dir == NULL) return;
    gint64 now = g_get_real_time() / G_USEC_PER_SEC;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(name, ending)) continue;
        g_autofree char *path = g_build_filename(folder, name, NULL);
        GStatBuf status;
        if (g_stat(path, &status) == 0 && now - (gint64)status.st_mtime > KEPT_SECONDS) g_unlink(path);
    }
}

void tinker_recovery_purge(void)
{
    g_autofree char *discarded = tinker_recovery_discarded_folder(), *folder = tinker_session_folder();
    purge(discarded, "");
    purge(folder, CRASH_NOTE);
    tinker_unfinished_clean(folder);
    tinker_session_purge();
}

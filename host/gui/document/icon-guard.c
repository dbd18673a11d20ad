/* A mark is a key file; its name is made of what the library's file is, so that another version is tried again. */
#include "gui/document/icon-guard.h"

#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>

#include "gui/document/session.h"

#define GROUP "icon"

static char *marks_folder(void)
{
    return g_build_filename(g_get_user_state_dir(), "tinker", "icons", NULL);
}

/* NULL where there is no such library. (transfer full) */
static char *mark_path(const char *library, const char *type)
{
    GStatBuf status;
    if (g_stat(library, &status) != 0) return NULL;
    g_autofree char *identity = g_strdup_printf("%s\n%s\n%jd\n%jd.%09ld", type, library, (intmax_t)status.st_size,
                                                (intmax_t)status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
    g_autofree char *folder = marks_folder(), *name = g_compute_checksum_for_string(G_CHECKSUM_SHA256, identity, -1);
    return g_build_filename(folder, name, NULL);
}

/* Whether the run that left the mark has ended. */
static gboolean is_left_behind(GKeyFile *mark)
{
    g_autofree char *session = g_key_file_get_string(mark, GROUP, "session", NULL);
    return session == NULL || !tinker_session_is_alive(session);
}

static gboolean is_left_out(const char *path)
{
    g_autoptr(GKeyFile) mark = g_key_file_new();
    return g_key_file_load_from_file(mark, path, G_KEY_FILE_NONE, NULL) && is_left_behind(mark);
}

/* Where it cannot be written, there is no guard. The session's lock tells other runs that this one is alive. */
static void leave_mark(const char *path, const TinkerBlockClass *block_class)
{
    g_autoptr(GKeyFile) mark = g_key_file_new();
    g_autofree char *folder = marks_folder();
    g_key_file_set_string(mark, GROUP, "type", block_class->type->id);
    g_key_file_set_string(mark, GROUP, "library", block_class->path);
    g_key_file_set_string(mark, GROUP, "session", tinker_session_name());
    if (tinker_session_hold(NULL) && g_mkdir_with_parents(folder, 0700) == 0) g_key_file_save_to_file(mark, path, NULL);
}

/* FALSE where it is left out. */
static gboolean paint_first(cairo_t *cairo, const TinkerBlockClass *block_class, double width, double height,
                            const TinkerTheme *theme)
{
    g_autofree char *path = mark_path(block_class->path, block_class->type->id);
    if (path != NULL && is_left_out(path)) return FALSE;
    if (path != NULL) leave_mark(path, block_class);
    tinker_paint_block_icon(cairo, block_class, width, height, theme);
    if (path != NULL) g_unlink(path);
    tinker_session_release();
    return TRUE;
}

void tinker_guarded_icon_paint(cairo_t *cairo, const TinkerBlockClass *block_class, double width, double height,
                               const TinkerTheme *theme)
{
    static GHashTable
        *shown; /* "LIBRARY\nTYPE" to whether it is drawn: what was found in this run holds for all of it */
    if (shown == NULL) shown = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    g_autofree char *key = g_strconcat(block_class->path, "\n", block_class->type->id, NULL);
    void *drawn;
    if (g_hash_table_lookup_extended(shown, key, NULL, &drawn)) {
        if (GPOINTER_TO_INT(drawn)) tinker_paint_block_icon(cairo, block_class, width, height, theme);
        return;
    }
    const gboolean is_drawn = paint_first(cairo, block_class, width, height, theme);
    g_hash_table_insert(shown, g_steal_pointer(&key), GINT_TO_POINTER(is_drawn));
}

static void remove_mark(void *path)
{
    g_unlink(path);
}

/* NULL where the mark is of no use any more. (transfer full) */
static TinkerNotice *notice_of(const char *path)
{
    g_autoptr(GKeyFile) mark = g_key_file_new();
    if (!g_key_file_load_from_file(mark, path, G_KEY_FILE_NONE, NULL)) return NULL;
    g_autofree char *type = g_key_file_get_string(mark, GROUP, "type", NULL);
    g_autofree char *library = g_key_file_get_string(mark, GROUP, "library", NULL);
    g_autofree char *now = type != NULL && library != NULL ? mark_path(library, type) : NULL;
    if (g_strcmp0(now, path) != 0) {
        g_unlink(path);
        return NULL;
    }
    if (!is_left_behind(mark)) return NULL;
    g_autofree char *text = g_strdup_printf(
        _("The icon of the block type %s is left out: the program ended while its plugin %s drew it."), type, library);
    return tinker_notice_new(TINKER_NOTICE_WARNING, text, _("Draw Again at the Next Start"), remove_mark,
                             g_strdup(path), g_free);
}

GPtrArray *tinker_guarded_icon_notices(void)
{
    GPtrArray *notices = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
    g_autofree char *folder = marks_folder();
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *name = dir != NULL ? g_dir_read_name(dir) : NULL; name != NULL; name = g_dir_read_name(dir)) {
        g_autofree char *path = g_build_filename(folder, name, NULL);
        TinkerNotice *notice = notice_of(path);
        if (notice != NULL) g_ptr_array_add(notices, notice);
    }
    return notices;
}

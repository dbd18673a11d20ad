/* The companion is written before the copy, and removed after it, so that a copy is never without one. */
#include "gui/document/autosave.h"

#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>
#include <string.h>

#include "files/replace-file.h"
#include "gui/document/session.h"

#define DEFAULT_SECONDS 30.0
#define LEAST_SECONDS   0.02

struct _TinkerAutosave {
    GObject parent_instance;
    TinkerDocument *document;
    char *stem; /* of both files */
    guint timer;
    gboolean has_file, failing;
    gboolean written;         /* there is a copy of the scene ... */
    guint64 written_revision; /* ... as it was then */
};

G_DEFINE_FINAL_TYPE(TinkerAutosave, tinker_autosave, G_TYPE_OBJECT)

enum { FAILED, WORKING, SIGNALS };
static guint signals[SIGNALS];

/* Names ------------------------------------------------------------------------------------------------------------ */

char *tinker_autosave_new_stem(void)
{
    static int number;
    g_autofree char *folder = tinker_session_folder();
    return g_strdup_printf("%s/%s-%d", folder, tinker_session_name(), ++number);
}

/* Writing ---------------------------------------------------------------------------------------------------------- */

static void set_text(GKeyFile *info, const char *key, const char *text)
{
    if (text != NULL) g_key_file_set_string(info, TINKER_AUTOSAVE_GROUP, key, text);
}

static char *text_of_info(TinkerDocument *document)
{
    g_autoptr(GKeyFile) info = g_key_file_new();
    g_autofree char *name = tinker_document_name(document);
    set_text(info, "name", name);
    set_text(info, "path", tinker_document_path(document));
    set_text(info, "base", tinker_document_base(document));
    set_text(info, "checksum", tinker_document_checksum(document));
    g_key_file_set_int64(info, TINKER_AUTOSAVE_GROUP, "time", g_get_real_time() / G_USEC_PER_SEC);
    set_text(info, "session", tinker_session_name());
    return g_key_file_to_data(info, NULL, NULL);
}

static gboolean write_one(const char *stem, const char *ending, const char *text, GError **error)
{
    g_autofree char *path = g_strconcat(stem, ending, NULL);
    if (tinker_replace_file(path, text, strlen(text), 0600, error)) return TRUE;
    g_prefix_error(error, "%s: ", path);
    return FALSE;
}

static gboolean write_both(TinkerAutosave *autosave, GError **error)
{
    g_autofree char *info = text_of_info(autosave->document);
    g_autofree char *text = tinker_scene_to_text(tinker_document_scene(autosave->document), TINKER_WRITE_SI);
    return tinker_session_hold(error) && write_one(autosave->stem, TINKER_AUTOSAVE_INFO, info, error) &&
           write_one(autosave->stem, TINKER_AUTOSAVE_ENDING, text, error);
}

static void tell_failure(TinkerAutosave *autosave, const GError *error)
{
    if (autosave->failing) return;
    autosave->failing = TRUE;
    g_signal_emit(autosave, signals[FAILED], 0, error->message);
}

static void tell_success(TinkerAutosave *autosave)
{
    if (!autosave->failing) return;
    autosave->failing = FALSE;
    g_signal_emit(autosave, signals[WORKING], 0);
}

gboolean tinker_autosave_now(TinkerAutosave *autosave)
{
    g_autoptr(GError) error = NULL;
    guint64 revision = tinker_history_revision(tinker_document_history(autosave->document));
    if (!tinker_document_is_modified(autosave->document)) return TRUE;
    if (autosave->written && autosave->written_revision == revision) return TRUE;
    autosave->has_file = TRUE;
    if (!write_both(autosave, &error)) {
        tell_failure(autosave, error);
        return FALSE;
    }
    autosave->written = TRUE;
    autosave->written_revision = revision;
    tell_success(autosave);
    return TRUE;
}

static gboolean on_timer(gpointer autosave)
{
    tinker_autosave_now(autosave);
    return G_SOURCE_CONTINUE;
}

static double seconds_between(void)
{
    const char *text = g_getenv("TINKER_AUTOSAVE_SECONDS");
    double seconds = text != NULL ? g_ascii_strtod(text, NULL) : 0;
    return seconds > 0 && seconds < 1e6 ? MAX(seconds, LEAST_SECONDS) : DEFAULT_SECONDS;
}

/* The document's file ---------------------------------------------------------------------------------------------- */

static void remove_one(const char *stem, const char *ending)
{
    g_autofree char *path = g_strconcat(stem, ending, NULL);
    g_unlink(path);
}

void tinker_autosave_forget(TinkerAutosave *autosave)
{
    g_clear_handle_id(&autosave->timer, g_source_remove);
    autosave->written = FALSE;
    if (!autosave->has_file) return;
    remove_one(autosave->stem, TINKER_AUTOSAVE_ENDING);
    remove_one(autosave->stem, TINKER_AUTOSAVE_INFO);
    tinker_session_release();
    autosave->has_file = FALSE;
}

static void on_file_changed(TinkerAutosave *autosave)
{
    if (!tinker_document_is_modified(autosave->document))
        tinker_autosave_forget(autosave);
    else if (autosave->timer == 0)
        autosave->timer = g_timeout_add((guint)(1000 * seconds_between()), on_timer, autosave);
}

/* The history of another scene counts anew. */
static void on_replaced(TinkerAutosave *autosave)
{
    autosave->written = FALSE;
}

/* The object ------------------------------------------------------------------------------------------------------- */

static void tinker_autosave_dispose(GObject *object)
{
    TinkerAutosave *autosave = TINKER_AUTOSAVE(object);
    g_clear_handle_id(&autosave->timer, g_source_remove);
    g_clear_object(&autosave->document);
    G_OBJECT_CLASS(tinker_autosave_parent_class)->dispose(object);
}

static void tinker_autosave_finalize(GObject *object)
{
    g_free(TINKER_AUTOSAVE(object)->stem);
    G_OBJECT_CLASS(tinker_autosave_parent_class)->finalize(object);
}

static void tinker_autosave_class_init(TinkerAutosaveClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_autosave_dispose;
    G_OBJECT_CLASS(class)->finalize = tinker_autosave_finalize;
    signals[FAILED] = g_signal_new("failed", TINKER_TYPE_AUTOSAVE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                                   1, G_TYPE_STRING);
    signals[WORKING] =
        g_signal_new("working", TINKER_TYPE_AUTOSAVE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_autosave_init(TinkerAutosave *autosave)
{
    autosave->stem = tinker_autosave_new_stem();
}

TinkerAutosave *tinker_autosave_new(TinkerDocument *document)
{
    TinkerAutosave *autosave = g_object_new(TINKER_TYPE_AUTOSAVE, NULL);
    autosave->document = g_object_ref(document);
    g_signal_connect_object(document, "file-changed", G_CALLBACK(on_file_changed), autosave, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), autosave, G_CONNECT_SWAPPED);
    on_file_changed(autosave);
    return autosave;
}

/* The document keeps the selection valid: whatever removes a block, it is no longer selected afterwards. */
#include "gui/document/document.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/joined.h"
#include "gui/document/carry-tables.h"
#include "gui/text/translate.h"

struct _TinkerDocument {
    GObject parent_instance;
    TinkerCatalogue *catalogue;
    TinkerScene *scene;
    TinkerHistory *history;
    TinkerDocumentOrigin origin;
    gboolean recovered; /* counts as modified until it is saved */
    GArray *selection;  /* of TinkerBlockId */
    TinkerPointed pointed;
};

G_DEFINE_FINAL_TYPE(TinkerDocument, tinker_document, G_TYPE_OBJECT)

enum { CHANGED, REPLACED, SELECTION_CHANGED, FILE_CHANGED, INTERRUPTED, POINTED_CHANGED, SIGNALS };
static guint signals[SIGNALS];

static void emit(TinkerDocument *document, int signal)
{
    g_signal_emit(document, signals[signal], 0);
}

static void clear_origin(TinkerDocumentOrigin *origin)
{
    g_free(origin->path);
    g_free(origin->base);
    g_free(origin->checksum);
}

static void tinker_document_finalize(GObject *object)
{
    TinkerDocument *document = TINKER_DOCUMENT(object);
    tinker_history_free(document->history);
    tinker_scene_free(document->scene);
    clear_origin(&document->origin);
    g_array_unref(document->selection);
    G_OBJECT_CLASS(tinker_document_parent_class)->finalize(object);
}

static void tinker_document_class_init(TinkerDocumentClass *class)
{
    static const char *const names[SIGNALS] = {"changed",      "replaced",    "selection-changed",
                                               "file-changed", "interrupted", "pointed-changed"};
    G_OBJECT_CLASS(class)->finalize = tinker_document_finalize;
    for (int i = 0; i < SIGNALS; i++)
        signals[i] =
            g_signal_new(names[i], TINKER_TYPE_DOCUMENT, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_document_init(TinkerDocument *document)
{
    document->selection = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    document->pointed = tinker_pointed_block(TINKER_NO_BLOCK);
}

TinkerDocument *tinker_document_new(TinkerCatalogue *catalogue)
{
    TinkerDocument *document = g_object_new(TINKER_TYPE_DOCUMENT, NULL);
    document->catalogue = catalogue;
    document->scene = tinker_scene_new(catalogue);
    document->history = tinker_history_new(document->scene);
    return document;
}

TinkerCatalogue *tinker_document_catalogue(TinkerDocument *document)
{
    return document->catalogue;
}

TinkerScene *tinker_document_scene(TinkerDocument *document)
{
    return document->scene;
}

TinkerHistory *tinker_document_history(TinkerDocument *document)
{
    return document->history;
}

/* Files ------------------------------------------------------------------------------------------------------------ */

static TinkerDocumentOrigin copy_origin(const TinkerDocumentOrigin *origin)
{
    return (TinkerDocumentOrigin){g_strdup(origin->path), g_strdup(origin->base), g_strdup(origin->checksum)};
}

/* Any of the new texts may be one of the last. */
static void set_origin(TinkerDocument *document, const TinkerDocumentOrigin *origin)
{
    TinkerDocumentOrigin last = document->origin;
    document->origin = copy_origin(origin);
    clear_origin(&last);
}

/* NULL where there is no such file. (transfer full) */
static char *checksum_of_file(const char *path)
{
    g_autofree char *text = NULL;
    gsize length;
    if (!g_file_get_contents(path, &text, &length, NULL)) return NULL;
    return g_compute_checksum_for_data(G_CHECKSUM_SHA256, (const guchar *)text, length);
}

/* Goes on with another scene. (transfer full) */
static void replace(TinkerDocument *document, TinkerScene *scene, const TinkerDocumentOrigin *origin,
                    gboolean recovered)
{
    tinker_document_interrupt(document);
    TinkerScene *last = document->scene;
    tinker_history_free(document->history);
    document->scene = scene;
    document->history = tinker_history_new(scene);
    document->recovered = recovered;
    set_origin(document, origin);
    g_array_set_size(document->selection, 0);
    emit(document, REPLACED);
    tinker_scene_free(last);
    emit(document, SELECTION_CHANGED);
    tinker_document_point(document, tinker_pointed_block(TINKER_NO_BLOCK));
    emit(document, CHANGED);
    emit(document, FILE_CHANGED);
}

gboolean tinker_document_start(TinkerDocument *document, const char *text, gsize length, const char *path,
                               GError **error)
{
    TinkerScene *scene = tinker_scene_read_text(document->catalogue, text, length, path, NULL, error);
    if (scene == NULL) return FALSE;
    replace(document, scene, &(TinkerDocumentOrigin){.base = (char *)path}, FALSE);
    return TRUE;
}

gboolean tinker_document_open(TinkerDocument *document, const char *path, GPtrArray *findings, GError **error)
{
    g_autofree char *checksum = checksum_of_file(path);
    TinkerScene *scene = tinker_scene_read_file(document->catalogue, path, findings, error);
    if (scene == NULL) return FALSE;
    replace(document, scene, &(TinkerDocumentOrigin){(char *)path, (char *)path, checksum}, FALSE);
    return TRUE;
}

gboolean tinker_document_recover(TinkerDocument *document, const char *text, gsize length,
                                 const TinkerDocumentOrigin *origin, GError **error)
{
    TinkerScene *scene = tinker_scene_read_text(document->catalogue, text, length, origin->base, NULL, error);
    if (scene == NULL) return FALSE;
    replace(document, scene, origin, TRUE);
    return TRUE;
}

TinkerFileSet *tinker_document_files(TinkerDocument *document)
{
    TinkerFileSet *files = tinker_file_set_new();
    if (document->origin.path != NULL) tinker_file_set_add_scene(files, document->origin.path);
    tinker_file_set_add_sources(files, document->scene, document->origin.base);
    return files;
}

/* The scene's own file may be written, but not a table that it reads. */
static gboolean check_output(TinkerDocument *document, const char *path, GError **error)
{
    g_autoptr(TinkerFileSet) files = tinker_file_set_new();
    tinker_file_set_add_sources(files, document->scene, document->origin.base);
    return tinker_file_set_add_output(files, NULL, path, error);
}

gboolean tinker_document_save(TinkerDocument *document, const char *path, GError **error)
{
    tinker_document_interrupt(document);
    if (!check_output(document, path, error)) return FALSE;
    if (document->origin.base != NULL && !carry_tables(document->scene, document->origin.base, path, error))
        return FALSE;
    if (!tinker_scene_write_file(document->scene, path, TINKER_WRITE_SI, error)) return FALSE;
    g_autofree char *checksum = checksum_of_file(path);
    set_origin(document, &(TinkerDocumentOrigin){(char *)path, (char *)path, checksum});
    document->recovered = FALSE;
    tinker_history_mark_saved(document->history);
    emit(document, FILE_CHANGED);
    return TRUE;
}

const char *tinker_document_path(TinkerDocument *document)
{
    return document->origin.path;
}

const char *tinker_document_base(TinkerDocument *document)
{
    return document->origin.base;
}

const char *tinker_document_checksum(TinkerDocument *document)
{
    return document->origin.checksum;
}

/* A file that is gone holds nothing that could be overwritten. */
gboolean tinker_document_changed_on_disk(TinkerDocument *document)
{
    if (document->origin.path == NULL) return FALSE;
    g_autofree char *now = checksum_of_file(document->origin.path);
    return now != NULL && g_strcmp0(now, document->origin.checksum) != 0;
}

char *tinker_document_name(TinkerDocument *document)
{
    const TinkerSceneHead *head = tinker_scene_head(document->scene);
    if (head->title[0] != '\0') return g_strdup(tinker_translate_title(head->title, head->description));
    return document->origin.path != NULL ? g_path_get_basename(document->origin.path) : g_strdup(_("Untitled"));
}

gboolean tinker_document_is_modified(TinkerDocument *document)
{
    return document->recovered || !tinker_history_is_saved(document->history);
}

gboolean tinker_document_is_empty(TinkerDocument *document)
{
    for (int32_t place = 0; place < tinker_scene_block_count(document->scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(document->scene, place);
        const TinkerBlockClass *block_class = tinker_scene_block_class(document->scene, block);
        if (block_class == NULL || block_class->meanings[TINKER_MEANING_POSITION] >= 0) return FALSE;
        if (tinker_scene_end_count(document->scene, block) > 0) return FALSE;
    }
    return TRUE;
}

/* Editing ---------------------------------------------------------------------------------------------------------- */

static void drop_removed(TinkerDocument *document)
{
    const guint selected = document->selection->len;
    guint kept = 0;
    for (guint i = 0; i < selected; i++) {
        const TinkerBlockId block = g_array_index(document->selection, TinkerBlockId, i);
        if (tinker_scene_has_block(document->scene, block))
            g_array_index(document->selection, TinkerBlockId, kept++) = block;
    }
    g_array_set_size(document->selection, kept);
    if (kept < selected) emit(document, SELECTION_CHANGED);
}

void tinker_document_touch(TinkerDocument *document)
{
    drop_removed(document);
    emit(document, CHANGED);
    emit(document, FILE_CHANGED);
}

void tinker_document_interrupt(TinkerDocument *document)
{
    if (tinker_history_is_open(document->history)) emit(document, INTERRUPTED);
}

void tinker_document_begin(TinkerDocument *document, const char *title, const char *merge)
{
    tinker_document_interrupt(document);
    tinker_history_begin(document->history, title, merge);
}

void tinker_document_end(TinkerDocument *document)
{
    tinker_history_end(document->history);
    tinker_document_touch(document);
}

void tinker_document_abort(TinkerDocument *document)
{
    tinker_history_abort(document->history);
    tinker_document_touch(document);
}

/* A change that is under way is given up instead. */
static void step_in_history(TinkerDocument *document, void (*step)(TinkerHistory *history))
{
    if (tinker_history_is_open(document->history)) {
        tinker_document_interrupt(document);
        return;
    }
    step(document->history);
    tinker_document_touch(document);
}

void tinker_document_undo(TinkerDocument *document)
{
    step_in_history(document, tinker_history_undo);
}

void tinker_document_redo(TinkerDocument *document)
{
    step_in_history(document, tinker_history_redo);
}

void tinker_document_place(TinkerDocument *document, TinkerBlockId block, const double place[2], double reach)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(document->scene, block);
    int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    if (position >= 0) tinker_history_set(document->history, block, position, place, NULL);
    int32_t ends = tinker_scene_end_count(document->scene, block);
    for (int32_t end = 0; end < ends; end++) {
        if (tinker_scene_end(document->scene, block, end).block != TINKER_NO_BLOCK) continue;
        double along = ends < 2 ? 0 : reach * (2.0 * end / (ends - 1) - 1);
        TinkerSceneEnd detached = {TINKER_NO_BLOCK, place[0] + along, place[1]};
        tinker_history_set_end(document->history, block, end, detached, NULL);
    }
}

void tinker_document_remove_selected(TinkerDocument *document)
{
    tinker_document_interrupt(document);
    guint count = document->selection->len;
    if (count == 0) return;
    TinkerBlockId first = g_array_index(document->selection, TinkerBlockId, 0);
    g_autofree char *title = count == 1
                                 ? g_strdup_printf(_("Delete %s"), tinker_scene_block_name(document->scene, first))
                                 : g_strdup_printf(_("Delete %u Blocks"), count);
    tinker_document_begin(document, title, NULL);
    tinker_history_remove_blocks(document->history, (const TinkerBlockId *)(gpointer)document->selection->data, count);
    tinker_document_end(document);
}

void tinker_document_order_selected(TinkerDocument *document, gboolean in_front)
{
    tinker_document_interrupt(document);
    const guint count = document->selection->len;
    if (count == 0) return;
    TinkerBlockId first = g_array_index(document->selection, TinkerBlockId, 0);
    const char *name = tinker_scene_block_name(document->scene, first);
    g_autofree char *title =
        count > 1  ? g_strdup_printf(in_front ? _("Bring %u Blocks to Front") : _("Send %u Blocks to Back"), count)
        : in_front ? g_strdup_printf(_("Bring %s to Front"), name)
                   : g_strdup_printf(_("Send %s to Back"), name);
    tinker_document_begin(document, title, NULL);
    tinker_history_order_blocks(document->history, (const TinkerBlockId *)(gpointer)document->selection->data, count,
                                in_front);
    tinker_document_end(document);
}

/* Whether a block lies on one that is selected, too, and moves with that. */
static gboolean is_taken_along(TinkerDocument *document, TinkerBlockId block, GHashTable *selected)
{
    TinkerBlockId plate;
    double along;
    return tinker_scene_lies_on(document->scene, block, &plate, &along) &&
           g_hash_table_contains(selected, GINT_TO_POINTER(plate));
}

static void move_block(TinkerDocument *document, TinkerBlockId block, GHashTable *selected, double dx, double dy)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(document->scene, block);
    if (block_class == NULL) return;
    int32_t column = tinker_block_class_meaning_column(block_class, TINKER_MEANING_POSITION);
    if (column >= 0 && !is_taken_along(document, block, selected)) {
        double place[2] = {tinker_scene_get(document->scene, block, column) + dx,
                           tinker_scene_get(document->scene, block, column + 1) + dy};
        tinker_history_set(document->history, block, block_class->meanings[TINKER_MEANING_POSITION], place, NULL);
    }
    for (int32_t i = 0; i < tinker_scene_end_count(document->scene, block); i++) {
        TinkerSceneEnd end = tinker_scene_end(document->scene, block, i);
        if (end.block != TINKER_NO_BLOCK) continue;
        end.x += dx;
        end.y += dy;
        tinker_history_set_end(document->history, block, i, end, NULL);
    }
}

void tinker_document_shift_selected(TinkerDocument *document, double dx, double dy)
{
    g_autoptr(GHashTable) selected = g_hash_table_new(NULL, NULL);
    for (guint i = 0; i < document->selection->len; i++)
        g_hash_table_add(selected, GINT_TO_POINTER(g_array_index(document->selection, TinkerBlockId, i)));
    for (guint i = 0; i < document->selection->len; i++)
        move_block(document, g_array_index(document->selection, TinkerBlockId, i), selected, dx, dy);
}

void tinker_document_move_selected(TinkerDocument *document, double dx, double dy, const char *merge)
{
    if (document->selection->len == 0) return;
    const TinkerBlockId block = tinker_document_selected(document);
    const TinkerPlacement before = tinker_placement_of(document->scene, block);
    tinker_document_begin(document, _("Move"), merge);
    tinker_document_shift_selected(document, dx, dy);
    if (block != TINKER_NO_BLOCK) tinker_joined_follow(document->history, document->scene, &before, NULL);
    tinker_document_end(document);
}

/* Selection -------------------------------------------------------------------------------------------------------- */

const TinkerBlockId *tinker_document_selection(TinkerDocument *document, int *count)
{
    *count = (int)document->selection->len;
    return (const TinkerBlockId *)(gpointer)document->selection->data;
}

TinkerBlockId tinker_document_selected(TinkerDocument *document)
{
    return document->selection->len == 1 ? g_array_index(document->selection, TinkerBlockId, 0) : TINKER_NO_BLOCK;
}

gboolean tinker_document_is_selected(TinkerDocument *document, TinkerBlockId block)
{
    for (guint i = 0; i < document->selection->len; i++)
        if (g_array_index(document->selection, TinkerBlockId, i) == block) return TRUE;
    return FALSE;
}

void tinker_document_select(TinkerDocument *document, TinkerBlockId block)
{
    tinker_document_select_all_of(document, &block, block != TINKER_NO_BLOCK);
}

void tinker_document_select_all_of(TinkerDocument *document, const TinkerBlockId *blocks, int count)
{
    gboolean same = (int)document->selection->len == count;
    for (int i = 0; same && i < count; i++)
        same = g_array_index(document->selection, TinkerBlockId, i) == blocks[i];
    if (same) return;
    g_array_set_size(document->selection, 0);
    if (count > 0) g_array_append_vals(document->selection, blocks, (guint)count);
    emit(document, SELECTION_CHANGED);
}

/* It may have been removed since. */
const TinkerPointed *tinker_document_pointed(TinkerDocument *document)
{
    if (!tinker_scene_has_block(document->scene, document->pointed.block))
        document->pointed = tinker_pointed_block(TINKER_NO_BLOCK);
    return &document->pointed;
}

void tinker_document_point(TinkerDocument *document, TinkerPointed what)
{
    if (tinker_pointed_same(&document->pointed, &what)) return;
    document->pointed = what;
    emit(document, POINTED_CHANGED);
}

void tinker_document_point_away(TinkerDocument *document, TinkerPointed from)
{
    if (tinker_pointed_same(&document->pointed, &from))
        tinker_document_point(document, tinker_pointed_block(TINKER_NO_BLOCK));
}

void tinker_document_toggle(TinkerDocument *document, TinkerBlockId block)
{
    guint i = 0;
    while (i < document->selection->len && g_array_index(document->selection, TinkerBlockId, i) != block)
        i++;
    if (i < document->selection->len)
        g_array_remove_index(document->selection, i);
    else
        g_array_append_val(document->selection, block);
    emit(document, SELECTION_CHANGED);
}

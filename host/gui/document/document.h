/* A document: what one window edits. A scene, its history, its file, and which of its blocks are selected. No widget.
 *
 * Changes go through the history, between tinker_document_begin and tinker_document_end. Signals:
 *   "changed"            the scene is another than before: an edit, undo, redo, or another scene altogether
 *   "replaced"           another scene altogether, before "changed": forget everything that came from the last one
 *   "selection-changed"
 *   "pointed-changed"    something else is pointed at, or nothing any more
 *   "file-changed"       the path, or whether there is something to save
 *   "interrupted"        something else is to be done in the middle of a step: who keeps it open aborts it
 */
#ifndef TINKER_GUI_DOCUMENT_H
#define TINKER_GUI_DOCUMENT_H

#include <gio/gio.h>

#include "common/overlay/pointed.h"
#include "common/program/file-set.h"
#include "scene/history/history.h"
#include "scene/read/scene-json.h"

#define TINKER_TYPE_DOCUMENT (tinker_document_get_type())
G_DECLARE_FINAL_TYPE(TinkerDocument, tinker_document, TINKER, DOCUMENT, GObject)

/* With an empty scene. The catalogue is borrowed and outlives it. (transfer full) */
TinkerDocument *tinker_document_new(TinkerCatalogue *catalogue);

TinkerCatalogue *tinker_document_catalogue(TinkerDocument *document);
/* Both are the document's, and are others after "replaced". */
TinkerScene *tinker_document_scene(TinkerDocument *document);
TinkerHistory *tinker_document_history(TinkerDocument *document);

/* Files ------------------------------------------------------------------------------------------------------------ */

/* A scene that has never been saved, read from text: `path` (may be NULL) is a file whose folder holds its tables. */
gboolean tinker_document_start(TinkerDocument *document, const char *text, gsize length, const char *path,
                               GError **error);

/* Opens a file; warnings of the reader are added to `findings` (of TinkerFinding *, may be NULL). On failure the
 * document stays as it was. */
gboolean tinker_document_open(TinkerDocument *document, const char *path, GPtrArray *findings, GError **error);

/* Saves atomically, and goes on with that path. Tables that the scene reads go along into another folder; none is
 * overwritten. */
gboolean tinker_document_save(TinkerDocument *document, const char *path, GError **error);

/* NULL for a scene that has never been saved. */
const char *tinker_document_path(TinkerDocument *document);
/* The file whose folder holds the scene's tables: its own, or the one it was started from. NULL: none. */
const char *tinker_document_base(TinkerDocument *document);
/* What the file held when it was read or written last (a checksum); NULL where there was none. */
const char *tinker_document_checksum(TinkerDocument *document);
/* Whether somebody else has written the file since. */
gboolean tinker_document_changed_on_disk(TinkerDocument *document);

/* Its own file, where it has one, and what its scene reads: none of them is for something else to be written to.
 * (transfer full) */
TinkerFileSet *tinker_document_files(TinkerDocument *document);

/* What the title bar calls it: the scene's title, which of a bundled scene is translated, else the file's name, else
 * "Untitled". (transfer full) */
char *tinker_document_name(TinkerDocument *document);
gboolean tinker_document_is_modified(TinkerDocument *document);

/* What a scene was that was being edited when the program ended. All may be NULL. */
typedef struct {
    char *path, *base, *checksum; /* as the functions above give them */
} TinkerDocumentOrigin;

/* Goes on with a scene that was not saved: it counts as modified. On failure the document stays as it was. */
gboolean tinker_document_recover(TinkerDocument *document, const char *text, gsize length,
                                 const TinkerDocumentOrigin *origin, GError **error);

/* Whether there is nothing in the scene that has a place on the canvas. */
gboolean tinker_document_is_empty(TinkerDocument *document);

/* Editing ---------------------------------------------------------------------------------------------------------- */

/* One step for undo; steps do not nest: one that is open is interrupted. `merge` as in history.h. */
void tinker_document_begin(TinkerDocument *document, const char *title, const char *merge);
void tinker_document_end(TinkerDocument *document);
void tinker_document_abort(TinkerDocument *document);
/* Tells that the scene has changed where somebody else (a drag) keeps the step. */
void tinker_document_touch(TinkerDocument *document);

/* Has whoever keeps a step open (a drag) abort it; for those who change the scene through its history. */
void tinker_document_interrupt(TinkerDocument *document);

/* In the middle of a step, both take that back and no more. */
void tinker_document_undo(TinkerDocument *document);
void tinker_document_redo(TinkerDocument *document);

/* Inside a step: puts a block's centre at `place` (m), or the middle of its free ends, which lie `reach` (m) to the
 * left and right. */
void tinker_document_place(TinkerDocument *document, TinkerBlockId block, const double place[2], double reach);

/* Removes what is selected. */
void tinker_document_remove_selected(TinkerDocument *document);

/* Draws what is selected after all other blocks, or before them. */
void tinker_document_order_selected(TinkerDocument *document, gboolean in_front);

/* Moves what is selected, bodies and detached ends, by (dx, dy) m: inside a step, and as one. `merge` as in history.h.
 */
void tinker_document_shift_selected(TinkerDocument *document, double dx, double dy);
void tinker_document_move_selected(TinkerDocument *document, double dx, double dy, const char *merge);

/* Selection -------------------------------------------------------------------------------------------------------- */

/* In the order in which they were selected. Borrowed, valid until the selection changes. */
const TinkerBlockId *tinker_document_selection(TinkerDocument *document, int *count);
/* The one block that is selected, or TINKER_NO_BLOCK where there are none or several. */
TinkerBlockId tinker_document_selected(TinkerDocument *document);
gboolean tinker_document_is_selected(TinkerDocument *document, TinkerBlockId block);

/* Selects one block alone; TINKER_NO_BLOCK: none. */
void tinker_document_select(TinkerDocument *document, TinkerBlockId block);
/* Selects these blocks alone. */
void tinker_document_select_all_of(TinkerDocument *document, const TinkerBlockId *blocks, int count);
/* What is pointed at somewhere, whose counterparts in other views light up; of TINKER_NO_BLOCK where nothing is.
 * Borrowed, valid until "pointed-changed". */
const TinkerPointed *tinker_document_pointed(TinkerDocument *document);
void tinker_document_point(TinkerDocument *document, TinkerPointed what);
/* This is pointed at no more: something else may be by now. */
void tinker_document_point_away(TinkerDocument *document, TinkerPointed from);

/* Adds it to the selection, or takes it out. */
void tinker_document_toggle(TinkerDocument *document, TinkerBlockId block);

#endif

/* Autosave: a copy of what one document has not saved, for the case that the program does not end properly. No widget.
 *
 * The copy is SESSION-N.tinker.json in the folder of tinker_session_folder(), with a companion SESSION-N.info that
 * tells what it is a copy of (recovery.h reads both); SESSION is the name of this run (session.h). It is written every
 * 30 s (TINKER_AUTOSAVE_SECONDS) while there is something new to save, and removed as soon as nothing is unsaved.
 * Signals: "failed"    (char *message) the copy cannot be written; told once, until it can be again "working"   it can
 * be again
 */
#ifndef TINKER_GUI_AUTOSAVE_H
#define TINKER_GUI_AUTOSAVE_H

#include "gui/document/document.h"

#define TINKER_TYPE_AUTOSAVE (tinker_autosave_get_type())
G_DECLARE_FINAL_TYPE(TinkerAutosave, tinker_autosave, TINKER, AUTOSAVE, GObject)

#define TINKER_AUTOSAVE_ENDING ".tinker.json"
#define TINKER_AUTOSAVE_INFO   ".info"
#define TINKER_AUTOSAVE_GROUP  "autosave" /* of the companion, a key file */

/* Takes a reference of the document. When it is freed it stops, and leaves its file: tinker_autosave_forget removes it.
 * (transfer full) */
TinkerAutosave *tinker_autosave_new(TinkerDocument *document);

/* Writes at once what is not saved and not written yet. FALSE where that fails. */
gboolean tinker_autosave_now(TinkerAutosave *autosave);

/* The user does not want what is unsaved: removes the copy. */
void tinker_autosave_forget(TinkerAutosave *autosave);

/* A name in the folder, without an ending, that no other file of this or another run has. (transfer full) */
char *tinker_autosave_new_stem(void);

#endif

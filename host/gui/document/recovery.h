/* Recovery: what processes left behind that did not end properly. No widget. */
#ifndef TINKER_GUI_RECOVERY_H
#define TINKER_GUI_RECOVERY_H

#include "gui/document/document.h"

/* A scene that nobody saved. */
typedef struct {
    char *stem;   /* of its two files; see autosave.h */
    char *name;   /* what the title bar called it */
    char *blame;  /* what the handler of crashes said, which names the plugin at fault; NULL: nothing is known */
    char *writer; /* name of the session that wrote it (session.h) */
    gint64 time;  /* s since 1970: when it was written */
    TinkerDocumentOrigin origin;
} TinkerRecovery;

/* Has a crash of this process leave its message for the next start, beside the copies. */
void tinker_recovery_note_crashes(void);

/* What the handler of crashes said of a process that left no scene behind, as where all was saved; told once. NULL:
 * nothing. (transfer full) */
char *tinker_recovery_take_blame(void);

/* All of runs that have ended, the latest first; of TinkerRecovery *, which it frees. (transfer full) */
GPtrArray *tinker_recovery_list(void);

/* Takes it over from all other processes, and goes on with it in a document. On failure both stay as they were. */
gboolean tinker_recovery_open(TinkerRecovery *recovery, TinkerDocument *document, GError **error);
/* Removes what was opened, once the document's own copy is written. */
void tinker_recovery_remove(TinkerRecovery *recovery);

/* Takes it out of the list; kept for 7 days in a folder beside, "autosave-discarded". */
gboolean tinker_recovery_discard(TinkerRecovery *recovery, GError **error);

/* Removes what was discarded, and notes of crashes, more than 7 days ago; and what runs that have ended left of their
 * locks and of copies that were not whole yet. */
void tinker_recovery_purge(void);

/* (transfer full) */
char *tinker_recovery_discarded_folder(void);

#endif

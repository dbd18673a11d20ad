/* A session: one run of the program, as the files call it that it leaves in the folder of tinker_session_folder(). Its
 * name is one that no other run has or had, on this machine or another: process numbers come again, after a restart as
 * in containers.
 *
 * As long as it has files there it holds a lock on NAME.lock, so that other runs leave them alone (files/file-lock.h).
 */
#ifndef TINKER_GUI_SESSION_H
#define TINKER_GUI_SESSION_H

#include <glib.h>

#define TINKER_SESSION_LOCK ".lock"

/* (transfer full) */
char *tinker_session_folder(void);

/* Of this run. Static. */
const char *tinker_session_name(void);

/* The name in that of a file "NAME-N" with whatever ending, or "NAME.crash". (transfer full) */
char *tinker_session_of_file(const char *file);

/* Takes the lock, and makes the folder; to be called before any file is written there. */
gboolean tinker_session_hold(GError **error);
/* Lets it go where this run has no file there any more. */
void tinker_session_release(void);

/* Whether that run has not ended. Where there are no locks it cannot be told: FALSE, rather than that work is never
 * found. */
gboolean tinker_session_is_alive(const char *name);

/* Removes the locks of runs that have ended and have no other file there. */
void tinker_session_purge(void);

#endif

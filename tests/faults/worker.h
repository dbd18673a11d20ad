/* What the worker does beside the program itself. Each answers an exit status of the program's kind, and says on
 * standard error what went wrong. */
#ifndef TEST_FAULT_WORKER_H
#define TEST_FAULT_WORKER_H

#include <glib.h>

/* Prints the error; answers the status for files that cannot be read or written. */
int worker_failed(const GError *error);

/* Changes a scene and writes the copy that is kept of unsaved work, in the user's state folder. */
int worker_autosave(void);

#endif

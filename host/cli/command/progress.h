/* One line on standard error that tells how far long work has come. It appears only on a terminal, and only when the
 * work has taken a second; it is erased at the end. */
#ifndef TINKER_CLI_PROGRESS_H
#define TINKER_CLI_PROGRESS_H

#include <glib.h>

typedef struct {
    const char *what; /* "running", static */
    gint64 started;   /* microseconds */
    gint64 shown;     /* likewise: the last time the line was written; 0: never */
    gboolean terminal;
} TinkerProgress;

TinkerProgress tinker_progress_start(const char *what);

/* `done` of `whole`, in any unit. Cheap: may be called often. */
void tinker_progress_update(TinkerProgress *progress, double done, double whole);
void tinker_progress_end(TinkerProgress *progress);

/* TinkerRunOptions.progress and .cancelled, with a TinkerProgress as their data. */
void tinker_progress_of_run(double t, double duration, void *data);
gboolean tinker_progress_interrupted(void *data);

/* From now on the first Ctrl-C (SIGINT) is remembered instead of ending the process; a second one ends it. One before
 * is forgotten. */
void tinker_progress_catch_interrupt(void);

#endif

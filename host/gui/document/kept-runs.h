/* Runs that are kept to be compared with the present one: what they recorded, and the scene that they are of. Signal:
 * "changed". No widget. */
#ifndef TINKER_GUI_KEPT_RUNS_H
#define TINKER_GUI_KEPT_RUNS_H

#include <glib-object.h>

#include "gui/document/recording.h"

#define TINKER_MOST_KEPT 8

#define TINKER_TYPE_KEPT_RUNS (tinker_kept_runs_get_type())
G_DECLARE_FINAL_TYPE(TinkerKeptRuns, tinker_kept_runs, TINKER, KEPT_RUNS, GObject)

typedef struct {
    guint id;            /* never given again */
    char *name;          /* which no other has */
    gboolean is_counted; /* "Run 1": nothing tells yet what it is beside another one */
    gboolean shown;
    int number;         /* from 0, which no other has: for a colour */
    TinkerScene *scene; /* as it was */
    TinkerRecording recording;
    TinkerFrame *frame; /* of that scene; NULL where a motion fails */
} TinkerKeptRun;

/* (transfer full) */
TinkerKeptRuns *tinker_kept_runs_new(void);

/* How many, and one of them, the oldest first. Borrowed until one is taken away. */
guint tinker_kept_runs_count(TinkerKeptRuns *runs);
TinkerKeptRun *tinker_kept_runs_at(TinkerKeptRuns *runs, guint place);

/* Keeps what is recorded of a scene, which is copied; `shown` is the frame that has shown it (may be NULL), whose spans
 * are the kept one's. Its name says what was changed since the one kept before, "Spring 0: K 50 N/m", or is "Run 1";
 * one of such a name is now named by what was changed since, "Spring 0: K 25 N/m". A name that another run has gets a
 * number, "Spring 0: K 25 N/m (2)". FALSE where there are as many as can be. */
gboolean tinker_kept_runs_add(TinkerKeptRuns *runs, TinkerScene *scene, const TinkerRecording *recording,
                              const TinkerFrame *shown);
void tinker_kept_runs_remove(TinkerKeptRuns *runs, guint place);
void tinker_kept_runs_remove_all(TinkerKeptRuns *runs);
/* Whether one of them is of this run. */
gboolean tinker_kept_runs_have(TinkerKeptRuns *runs, const TinkerRunTask *task);
/* A blank name changes nothing, and one that another run has gets a number. */
void tinker_kept_runs_rename(TinkerKeptRuns *runs, guint place, const char *name);
void tinker_kept_runs_show(TinkerKeptRuns *runs, guint place, gboolean shown);

/* What the present run is called beside them: "Spring 0: K 50 N/m, now", by what was changed since the last one.
 * (transfer full) */
char *tinker_kept_runs_present_name(TinkerKeptRuns *runs, TinkerScene *scene);

/* What one of the runs is called beside the present scene: its name, or what was changed since in place of its number.
 * (transfer full) */
char *tinker_kept_runs_name_beside(TinkerKeptRuns *runs, const TinkerKeptRun *run, TinkerScene *scene);

/* The frame of a run at a time (s). NULL where it is hidden, or not recorded so far. Borrowed. */
TinkerFrame *tinker_kept_run_frame(TinkerKeptRun *run, double time);

#endif

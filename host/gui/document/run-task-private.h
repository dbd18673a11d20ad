/* A task, which the thread that records (run-recorder.c) and its owner (run-task.c) share. The record guards itself;
 * the mutex is held only to note or to ask how far the run is, so that nobody waits for the other's work. */
#ifndef TINKER_GUI_RUN_TASK_PRIVATE_H
#define TINKER_GUI_RUN_TASK_PRIVATE_H

#include "gui/document/run-task.h"

#include "measure/until.h"
#include "physics/record/record.h"

#define RUN_TASK_STATE     6                  /* doubles of a body in a row: x, y, vx, vy, orientation, rate */
#define RUN_TASK_IN_MEMORY ((gsize)256 << 20) /* bytes of samples and events together; beyond, temporary files */
#define RUN_TASK_OF_EVENTS (RUN_TASK_IN_MEMORY / 4)

/* Rows that the thread appends and others read. */
typedef struct {
    TinkerRecord *record; /* which guards itself: the pointer alone is meant */
    GArray *times;        /* of double, one a row that may be read */
} RunTaskRows;

/* What a run recorded: its samples, and the columns at events, of which a row is the time, the columns just before it,
 * and those just behind it. */
typedef struct {
    RunTaskRows samples, events;
} RunTaskRecord;

struct _TinkerRunTask {
    gatomicrefcount references;
    TinkerScene *scene;
    double start;
    GArray *columns; /* of TinkerColumn */
    GArray *bodies;  /* of TinkerBlockId */
    GArray *wound;   /* of TinkerBlockId: whose lengths are recorded */
    gint cancelled;  /* atomic */
    gboolean estimate;

    GMutex mutex; /* of what follows */
    RunTaskRecord record;
    TinkerRunStatus status;
    GError *error;
    GPtrArray *warnings; /* of TinkerWarning * */
    GPtrArray *events;   /* of TinkerRunEvent *, in order */
    GArray *bands;       /* of double: rows of a time (s) and how far each column may be off until then */

    /* The thread's own. */
    double *row;
    double *event_row;
    RunTaskRecord next; /* of a further try, until it is over; empty in the first */
    TinkerUntil *until;
    int stopped_by;    /* number of that condition; -1 */
    gint64 rate_began; /* us */
    double rate_from;  /* s */
    double next_bands; /* s: when the next are noted */
};

/* (transfer full) */
TinkerRunEvent *run_task_event_new(double time, const char *text);

/* Doubles in a row: the time, the bodies, the lengths, the columns. */
gsize run_task_row_width(const TinkerRunTask *task);

/* Empty, for the rows of this task; and freed, unless it is empty already. */
void run_task_record_init(const TinkerRunTask *task, RunTaskRecord *record);
void run_task_record_clear(RunTaskRecord *record);

/* Doubles in a row of an event: the time, the columns just before it, and those just behind it. */
gsize run_task_event_width(const TinkerRunTask *task);

#endif

/* A run in a thread of its own, which records as far ahead as it can. No widget.
 *
 * Where the scene asks for an accuracy, the run may be made again: the samples of the first try are there to be read
 * until those of the last one take their place, all at once.
 *
 * The thread works on a scene of its own; everything here may be called from the main thread at any time. A row of the
 * record is a sample: the bodies' states, the lengths of what is wound on them, and the values of the columns. */
#ifndef TINKER_GUI_RUN_TASK_H
#define TINKER_GUI_RUN_TASK_H

#include "gui/document/run-lane.h"
#include "physics/run/simulation.h"

typedef struct _TinkerRunTask TinkerRunTask;

/* What is known of a run that is under way or over. */
typedef struct {
    gboolean finished; /* nothing more will come */
    double reached;    /* s: time of the last sample */
    gsize rows;        /* samples so far */
    gboolean looks;    /* for a while already, for where the conditions of the scene stop it; nothing is recorded yet */
    double looked;     /* s: up to where */
    guint replaced;    /* how often all samples gave way to those of a tighter run, as an accuracy asked for it */
    double rate;       /* s of motion a second of work, lately */
    char method[32];   /* empty until it is known */
    gboolean adaptive; /* whether `step` or `tolerance` counts */
    double step, tolerance;
    double error_estimate, energy_balance_error, constraint_error; /* relative; the first is NAN without one */
    gboolean estimate_due;                 /* it goes without an estimate of its error, which a later run will give */
    double predictable_until, valid_until; /* s */
} TinkerRunStatus;

/* Something that happened in a run. */
typedef struct {
    double time; /* s */
    char *text;  /* "Mass 0 leaves the end of Support 0" */
} TinkerRunEvent;
void tinker_run_event_free(TinkerRunEvent *event);

/* A quantity of a block, by its number in the block's class. */
typedef struct {
    TinkerBlockId block;
    int32_t quantity;
} TinkerQuantity;

/* A lane for runs of which only the newest counts. (transfer full) */
TinkerRunLane *tinker_run_task_lane(void);

/* Starts a run in the lane, whose first sample is called `start` (s); those in the lane before it have been stopped or
 * freed. `scene` is the task's from now on; `columns`, of TinkerQuantity, are to be recorded (copied). With `estimate`
 * a companion estimates its error, which takes as long again or longer; without, of many samples only some are
 * recorded, and these are the same, unless the scene asks for an accuracy. (transfer full) */
TinkerRunTask *tinker_run_task_new(TinkerRunLane *lane, TinkerScene *scene, double start, const GArray *columns,
                                   gboolean estimate);

/* Nothing more is wanted of it than what it has recorded. Does not wait. */
void tinker_run_task_stop(TinkerRunTask *task);

/* It is freed by whoever lets go of it last; a thread that still runs goes on until it is stopped. Does not wait. */
TinkerRunTask *tinker_run_task_ref(TinkerRunTask *task);
void tinker_run_task_unref(TinkerRunTask *task);

TinkerRunStatus tinker_run_task_status(TinkerRunTask *task);
/* Why it failed, or NULL; and what it warned of (of TinkerWarning *). (transfer full) */
GError *tinker_run_task_error(TinkerRunTask *task);
GPtrArray *tinker_run_task_warnings(TinkerRunTask *task);

/* How many events are known; and appends a copy of those before `until` (s), in order, to an array of TinkerRunEvent *
 * that owns them. */
guint tinker_run_task_event_count(TinkerRunTask *task);
void tinker_run_task_add_events(TinkerRunTask *task, double until, GPtrArray *to);

/* The bodies of a row, in order, what is wound, and the columns. Borrowed; fixed from the start. */
const TinkerBlockId *tinker_run_task_bodies(TinkerRunTask *task, int *count);
const TinkerBlockId *tinker_run_task_wound(TinkerRunTask *task, int *count);
/* Place of a column in a row; -1 where it is not recorded. */
int tinker_run_task_column(TinkerRunTask *task, TinkerQuantity quantity);

/* Reads one sample: its time, the bodies' states, and (where it is not NULL) how long (m) is what is wound. */
gboolean tinker_run_task_read(TinkerRunTask *task, gsize row, double *time, TinkerBodySample *bodies, double *lengths);

/* Column of a row, or straight between it and the next one, or an event between them, at a time after it. FALSE where
 * there is no such row. */
gboolean tinker_run_task_value(TinkerRunTask *task, gsize row, int column, double time, double *value);

/* How far a column may be off until a time (s), by the companion, in the column's unit: what is known is known of a few
 * times in a run, and grows from each to the next. FALSE where it is not known, or not yet. */
gboolean tinker_run_task_band(TinkerRunTask *task, int column, double until, double *band);

/* The last row that is not later than `time`, if there is any. */
gboolean tinker_run_task_find(TinkerRunTask *task, double time, gsize *row);

/* Appends the column's values, and their times, of the rows from `next` on that are not later than `until`, to arrays
 * of double, and moves `next` behind them; where `event` is not NULL, also of the events from that one on, each twice
 * at its time, just before it and just behind it. No more than a frame has time for: FALSE where the rest is left for
 * another call. */
gboolean tinker_run_task_series(TinkerRunTask *task, int column, gsize *next, gsize *event, double until, GArray *times,
                                GArray *values);

#endif

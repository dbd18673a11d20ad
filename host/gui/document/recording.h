/* What was recorded of a scene: a row of segments. Each is a run, and counts from its start to that of the next. There
 * is more than one only where a property was changed on the way. No widget. */
#ifndef TINKER_GUI_RECORDING_H
#define TINKER_GUI_RECORDING_H

#include "gui/document/run-task.h"
#include "scene/frame/frame.h"

typedef struct {
    TinkerRunTask *task;
    double start; /* s */
    gboolean failure_told;
    guint replaced;        /* as in the task's status when it was looked at last */
    gboolean cut;          /* its run was ended before its time, as nobody looked on */
    TinkerRunTask *checks; /* the same run once more, with an estimate of its error, until that is over; NULL. Owned */
    TinkerScene *scene; /* that it is the run of, where that is not the document's: of a record that was changed on the
                         * way. Owned */
} TinkerSegment;

typedef struct {
    GArray *segments; /* of TinkerSegment */
    guint generation; /* another one whenever what was recorded is no longer true */
} TinkerRecording;

/* Empty. */
void tinker_recording_init(TinkerRecording *recording);
/* Lets go of its runs without stopping them, and frees what it holds. */
void tinker_recording_clear(TinkerRecording *recording);

/* Forgets all, whose runs are stopped. */
void tinker_recording_forget(TinkerRecording *recording);
/* Adds a run, which is the recording's from now on. */
void tinker_recording_add(TinkerRecording *recording, TinkerRunTask *task, double start);
/* Takes over the runs of another recording, which holds them as well: what is recorded stays when that one forgets it.
 */
void tinker_recording_share(TinkerRecording *recording, const TinkerRecording *other);

/* NULL where there is none. Borrowed until a segment is added or taken away, as all. */
TinkerSegment *tinker_recording_last(const TinkerRecording *recording);
/* The one that shows this time: of one that begins there and has recorded nothing yet, the start is the last sample of
 * the one before it. */
TinkerSegment *tinker_recording_at(const TinkerRecording *recording, double time);
/* Whether what is being recorded has yet to come to this time, as a run that was made anew while a late time is shown.
 */
gboolean tinker_recording_awaits(const TinkerRecording *recording, double time);
/* s: where a segment gives way to the next; INFINITY. */
double tinker_recording_end(const TinkerRecording *recording, guint number);

/* The generation, which is another one where a run was made again for an accuracy, and has other samples now. */
guint tinker_recording_generation(TinkerRecording *recording);

/* Puts everything where a sample has it. */
gboolean tinker_recording_place_sample(TinkerFrame *frame, TinkerRunTask *task, gsize row);
/* Puts everything where the record has it at a time, straight between two samples; where the time is awaited, all stays
 * where it is. FALSE where a motion fails. */
gboolean tinker_recording_place(const TinkerRecording *recording, TinkerFrame *frame, double time);

/* Appends what has been recorded of a quantity since the last call with this cursor (zeroed at first; begin anew, with
 * empty arrays, when the generation changes), to arrays of double: of a long record a portion, and the cursor says that
 * it is behind. FALSE where the quantity is not recorded. */
typedef struct {
    guint segment;
    gsize row;
    gsize event;
    gboolean at_events; /* set by who reads: each event between two samples is handed out, too, twice at its time: just
                         * before it and just behind it */
    gboolean behind;    /* there is more at once */
} TinkerSeriesCursor;
gboolean tinker_recording_series(const TinkerRecording *recording, TinkerQuantity quantity, TinkerSeriesCursor *cursor,
                                 GArray *times, GArray *values);

/* How far a quantity may be off until a time (s), in SI, by the errors of all runs up to then. FALSE where one of them
 * is not known. */
gboolean tinker_recording_band(const TinkerRecording *recording, TinkerQuantity quantity, double until, double *band);

/* The bodies in one sample. */
typedef void (*TinkerBodiesFunc)(double time, const TinkerBlockId *bodies, const TinkerBodySample *samples, int count,
                                 void *data);

/* Hands out the samples recorded since the last call with this cursor (zeroed at first; begin anew when the generation
 * changes), in order of time: of a long record a portion, and the cursor says that it is behind. */
void tinker_recording_visit(const TinkerRecording *recording, TinkerSeriesCursor *cursor, TinkerBodiesFunc visit,
                            void *data);
/* Hands out the last sample that is not later than a time. FALSE where there is none. */
gboolean tinker_recording_visit_at(const TinkerRecording *recording, double time, TinkerBodiesFunc visit, void *data);

#endif

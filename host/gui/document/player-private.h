/* What the files of the player share. */
#ifndef TINKER_GUI_PLAYER_PRIVATE_H
#define TINKER_GUI_PLAYER_PRIVATE_H

#include "gui/document/player.h"

#include "gui/document/recording.h"

struct _TinkerPlayer {
    GObject parent_instance;
    TinkerDocument *document;
    TinkerPlayerState state;
    double time, speed, pace;
    gboolean trial; /* edits are those of a hand that tries */
    gint64 anew_us; /* when a run was begun anew */
    double step_to; /* s: as soon as this is recorded it is shown, and time stands still; NAN while it plays freely */
    TinkerRunLane *lane;
    TinkerRecording recording;
    TinkerTimeSpan *span;
    TinkerKeptRuns *kept;
    TinkerScene *ran; /* the scene as the last segment has it; NULL where there is none */
    TinkerFrame *frame;
    guint path_segment; /* where in the record the frame's paths end: everything before this row of this segment */
    gsize path_row;     /* is noted */
    guint span_segment; /* and up to where its spans are those of the record */
    gsize span_row;
    gboolean spans_grew; /* when samples were noted last */
    guint span_timer;    /* until more samples are noted; 0 */
    GArray *asked;       /* of TinkerQuantity: asked for in vain */
    GPtrArray *events;   /* of TinkerRunEvent *: of this generation, when there were so many in all tasks */
    guint events_generation, events_counted;
};

enum { PLAYER_STATE_CHANGED, PLAYER_MOVED, PLAYER_REWOUND, PLAYER_FAILED, PLAYER_SIGNALS };
extern guint player_signals[PLAYER_SIGNALS];

/* player-frame.c: state, record, and the scene as it is shown */
void player_set_state(TinkerPlayer *player, TinkerPlayerState state);
/* FALSE, with the block that is at fault, where the scene has a placeholder or a detached end. */
gboolean player_can_run(TinkerPlayer *player, TinkerBlockId *culprit, GError **error);
TinkerSegment *player_segment(TinkerPlayer *player, guint number);
void player_forget_record(TinkerPlayer *player);
/* A run of this scene (transfer full) from a time on, in a thread, with or without an estimate of its error. (transfer
 * full) */
TinkerRunTask *player_new_task(TinkerPlayer *player, TinkerScene *scene, double start, gboolean estimate);
/* Records this scene (transfer full) from a time on, as the last segment; in a trial without an estimate. */
void player_add_segment(TinkerPlayer *player, TinkerScene *scene, double start);
void player_record_from_start(TinkerPlayer *player);
/* What is still being recorded is recorded no further, unless a kept run is to have all of it. */
void player_end_recording(TinkerPlayer *player);
/* Records what was ended so once more and to its end: the samples up to there are the same again. */
void player_resume_recording(TinkerPlayer *player);
/* The frame as it is at the time shown; made anew where the scene is another. */
void player_update_frame(TinkerPlayer *player);
void player_renew_frame(TinkerPlayer *player);
/* What the frame notes of the record is noted anew: paths from the start of this segment on, spans from that of the
 * run, as what has been longest may be in what is no longer true. */
void player_note_anew(TinkerPlayer *player, guint segment);
/* Tells that the time shown is another. */
void player_moved(TinkerPlayer *player);

/* player-edits.c: handlers of the document's signals */
void player_on_changed(TinkerPlayer *player);
void player_on_replaced(TinkerPlayer *player);

#endif

/* The player: runs a document's scene and plays the record back at a pace. No widget.
 *
 * A thread records ahead (run-task.h), play-back reads the record: how often one looks never changes the motion. An
 * edit of what may change on the way (a stiffness) goes on from here with the new value; any other that changes the
 * motion rewinds to the start. Signals: "state-changed" "moved"             the time, or what the frame shows "rewound"
 * an edit took the player back to the start "failed"            (char *message) the run ended with an error; what was
 * recorded up to then is kept
 */
#ifndef TINKER_GUI_PLAYER_H
#define TINKER_GUI_PLAYER_H

#include "gui/document/document.h"
#include "gui/document/kept-runs.h"
#include "gui/document/time-span.h"

#define TINKER_TYPE_PLAYER (tinker_player_get_type())
G_DECLARE_FINAL_TYPE(TinkerPlayer, tinker_player, TINKER, PLAYER, GObject)

typedef enum {
    TINKER_PLAYER_SETUP,   /* at the start, where nothing has been recorded, or gone back to */
    TINKER_PLAYER_PLAYING, /* time goes on */
    TINKER_PLAYER_PAUSED,  /* somewhere in the record */
} TinkerPlayerState;

/* Takes a reference of the document. (transfer full) */
TinkerPlayer *tinker_player_new(TinkerDocument *document);

TinkerPlayerState tinker_player_state(TinkerPlayer *player);
double tinker_player_time(TinkerPlayer *player);     /* s: what is shown */
double tinker_player_reached(TinkerPlayer *player);  /* s: as far as the record goes */
double tinker_player_duration(TinkerPlayer *player); /* s: as far as it will go */

/* s of motion a second, 1 at first. */
double tinker_player_speed(TinkerPlayer *player);
void tinker_player_set_speed(TinkerPlayer *player, double speed);
/* The pace that was really kept lately, over the speed: below 1 where the run is slower than its play-back. */
double tinker_player_pace(TinkerPlayer *player);

/* Runs that are kept to be compared with this one. Borrowed. */
TinkerKeptRuns *tinker_player_kept(TinkerPlayer *player);
/* Keeps what is recorded now. FALSE where nothing is, or as many are kept as can be. */
gboolean tinker_player_keep(TinkerPlayer *player);

/* What graphs over time show of it. Borrowed. */
TinkerTimeSpan *tinker_player_span(TinkerPlayer *player);

/* Plays from here on; at the end, from the start. Where the scene cannot run: FALSE with an error that says why, and
 * `culprit` is the block that is to blame, or TINKER_NO_BLOCK. */
gboolean tinker_player_play(TinkerPlayer *player, TinkerBlockId *culprit, GError **error);
void tinker_player_pause(TinkerPlayer *player);
/* Goes on by one sample (`forward`) or back by one and pauses there: at once, or when it has been recorded. */
gboolean tinker_player_step(TinkerPlayer *player, gboolean forward, TinkerBlockId *culprit, GError **error);
/* Makes the run anew from the start, of the scene as it is, and shows it where time stands as soon as that is recorded.
 * FALSE where the scene cannot run. */
gboolean tinker_player_run_anew(TinkerPlayer *player);
/* s: from when on the run is that of the scene as it is, where that was changed on the way; else NAN. */
double tinker_player_changed_at(TinkerPlayer *player);
/* Goes to a time, not beyond what is recorded; goes on playing if it does. */
void tinker_player_seek(TinkerPlayer *player, double time);
/* Goes to a time from the start to the end of the run and pauses there: at once, or when it has been recorded. */
gboolean tinker_player_go_to(TinkerPlayer *player, double time, TinkerBlockId *culprit, GError **error);
/* Ends the run and forgets what it has recorded; back to the start. */
void tinker_player_give_up(TinkerPlayer *player);
/* Back to the start. A run that is under way ends, unless it is kept. What was recorded stays to be read until an edit
 * changes the motion or a new run begins, as the next one to play or to step from here is. */
void tinker_player_reset(TinkerPlayer *player);
/* The same because somebody wants to edit the start: tells so. */
void tinker_player_rewind(TinkerPlayer *player);

/* Between these two, an edit that changes the motion is of a hand that tries: the run is made anew from the start and
 * the time stays, also where nothing had been run; a scene that plays goes on from that time. */
void tinker_player_begin_trial(TinkerPlayer *player);
void tinker_player_end_trial(TinkerPlayer *player);
/* Where the last run went without an estimate of its error, as those of a trial do: makes it once more with one, which
 * then takes its place. TRUE as long as that is under way; to be called again and again until it is not. */
gboolean tinker_player_estimate(TinkerPlayer *player);
/* Tells "moved" again, as the record goes on while time stands still. */
void tinker_player_refresh(TinkerPlayer *player);

/* As many real seconds have passed: moves on where it is playing, and looks after the run. */
void tinker_player_advance(TinkerPlayer *player, double seconds);

/* Records until `time` and waits for it; for pictures. FALSE where the run fails before. */
gboolean tinker_player_wait(TinkerPlayer *player, double time, GError **error);

/* What is to be drawn: the scene at the present time. NULL where a motion fails at the start. Borrowed, valid until the
 * document changes. */
TinkerFrame *tinker_player_frame(TinkerPlayer *player);

/* Puts another frame of the scene where the record has it at a time. FALSE where that is not recorded. */
gboolean tinker_player_place(TinkerPlayer *player, TinkerFrame *frame, double time);

/* A scene whose start is the sample that is shown now, or the one before, `behind` (s) ago; NULL where it cannot go on
 * from there. (transfer full) */
TinkerScene *tinker_player_scene_now(TinkerPlayer *player, double *behind);

/* A copy of the scene whose run shows this moment, and when (s) that run starts: another one, and later than 0, where
 * something was changed on the way. (transfer full) */
TinkerScene *tinker_player_scene_shown(TinkerPlayer *player, double *start);

/* What a quantity is now, SI. FALSE where it is not recorded. */
gboolean tinker_player_value(TinkerPlayer *player, TinkerBlockId block, int32_t quantity, double *value);

/* How the run went so far. FALSE where there is none. */
gboolean tinker_player_status(TinkerPlayer *player, TinkerRunStatus *status);
/* What the run warned of, of TinkerWarning *. (transfer full) */
GPtrArray *tinker_player_warnings(TinkerPlayer *player);

/* What has happened in the run, of TinkerRunEvent *, in order of time: the same array as before where there is nothing
 * new. Borrowed; keep a reference for what is to outlive the next call. */
GPtrArray *tinker_player_events(TinkerPlayer *player);

/* A number that changes whenever what was recorded is no longer true. */
guint tinker_player_generation(TinkerPlayer *player);
/* As tinker_recording_series; what is not recorded will be from the next run on. */
gboolean tinker_player_series(TinkerPlayer *player, TinkerQuantity quantity, TinkerSeriesCursor *cursor, GArray *times,
                              GArray *values);

/* As tinker_recording_band. */
gboolean tinker_player_band(TinkerPlayer *player, TinkerQuantity quantity, double until, double *band);

/* As tinker_recording_visit; and of the sample that is shown now, as tinker_recording_visit_at. */
void tinker_player_visit(TinkerPlayer *player, TinkerSeriesCursor *cursor, TinkerBodiesFunc visit, void *data);
gboolean tinker_player_visit_now(TinkerPlayer *player, TinkerBodiesFunc visit, void *data);

#endif

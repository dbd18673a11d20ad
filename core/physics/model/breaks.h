/* Poles, and switching without end: what of a model's waveforms and blocks no run can follow. */
#ifndef TINKER_CORE_BREAKS_H
#define TINKER_CORE_BREAKS_H

#include "physics/model/model.h"
#include "scene/frame/batch.h"

/* The first pole of a waveform (units/waveform/waveform-pole.h) in what the last search for a break went through;
 * INFINITY for none. */
double tinker_model_next_pole(const TinkerModel *model, TinkerBlockId *block);

/* Pieces in a row that are so short that a run would never end. */
typedef struct {
    int count;
} TinkerBreakCrowd;

/* Counts the piece from t to `next` of a run to `end`: TRUE where there have been too many. */
gboolean tinker_break_crowd_add(TinkerBreakCrowd *crowd, double t, double next, double end);

/* What is then to be said. (transfer full) */
char *tinker_break_crowd_text(TinkerModel *model, double t, double next);

/* Whether a run of `duration` (s) comes to an end of what switches: waveforms and blocks that do so faster than time
 * can resolve, over and over, are told with the block's name (TINKER_MODEL_ERROR_SCENE). Looks at the first few
 * thousand switches. */
gboolean tinker_model_check_breaks(TinkerModel *model, double duration, GError **error);

/* The next time after t, not after the horizon, at which a derivative of anything jumps; INFINITY for none. */
double tinker_model_next_break(TinkerModel *model, double t, double horizon);
/* Enters the piece from `from` to `to` (infinite: without end), which contains `inside`. */
void tinker_model_enter_piece(TinkerModel *model, double from, double inside, double to);

/* Whether some block gives blows, at whatever time: these may come from anywhere. */
gboolean tinker_model_is_struck(const TinkerModel *model);

#endif

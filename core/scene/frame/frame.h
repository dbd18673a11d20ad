/* A frame: where every block is and what its columns hold at one instant. Drawing and hit tests go by it.
 *
 * A frame of a scene that has not been run shows it as placed at t = 0, with every support where its motion has it
 * then.
 */
#ifndef TINKER_CORE_FRAME_H
#define TINKER_CORE_FRAME_H

#include "scene/frame/motions.h"
#include "scene/store/scene.h"

#include <tinker/instance.h>

typedef struct _TinkerFrame TinkerFrame;

/* The scene as placed. The scene is borrowed and must not change as long as the frame lives. NULL where a plugin's
 * motion fails. (transfer full) */
TinkerFrame *tinker_frame_new(TinkerScene *scene, GError **error);
void tinker_frame_free(TinkerFrame *frame);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFrame, tinker_frame_free)

TinkerScene *tinker_frame_scene(const TinkerFrame *frame);
double tinker_frame_time(const TinkerFrame *frame);

/* t; or, where what t alone switches does so there, the time next to it at which an expression is on the side that
 * holds from t on. Set the time after this call, which moves the search for breaks. */
double tinker_frame_time_behind(TinkerFrame *frame, double t);
/* Goes to time t: waveform columns are evaluated there, and supports stand where their motions have them. Bodies that
 * can move stay where they are until tinker_frame_place moves them. */
gboolean tinker_frame_set_time(TinkerFrame *frame, double t, GError **error);

/* Puts a body that can move somewhere; how long what is wound is, is not known then until it is told. */
void tinker_frame_place(TinkerFrame *frame, TinkerBlockId block, double x, double y, double orientation);

/* Shows a body that has no turn of its own turned by so much (rad) about its centre, where all its ends are. */
void tinker_frame_lay(TinkerFrame *frame, TinkerBlockId block, double orientation);

/* The blocks that are wound on bodies, and how long (m) what is off the body of one of them is now, with what of it is
 * slack: it depends on the way of the run up to here, which the places do not tell. NAN: not known. What is told of a
 * block that is not wound, or that the frame does not have, is passed over. */
const TinkerBlockId *tinker_frame_wound(const TinkerFrame *frame, int32_t *count);
void tinker_frame_set_length(TinkerFrame *frame, TinkerBlockId block, double length);
double tinker_frame_length(const TinkerFrame *frame, TinkerBlockId block);

/* Whether any block leaves a path (TINKER_LEAVES_PATH). */
gboolean tinker_frame_leaves_paths(const TinkerFrame *frame);

/* Notes where the blocks that leave a path are now; a time that is not later than the last one noted adds nothing.
 * Instances show what was noted up to the frame's time. */
void tinker_frame_note_paths(TinkerFrame *frame);

/* Whether any block has a span (TINKER_HAS_SPAN); notes how far the ends of those are apart now, which instances show
 * from then on whatever the time, and answers whether any was never so far; notes what was noted of another frame,
 * whose scene is that one's or a copy; and forgets all that was noted, for another run. */
gboolean tinker_frame_has_spans(const TinkerFrame *frame);
gboolean tinker_frame_note_spans(TinkerFrame *frame);
void tinker_frame_note_spans_of(TinkerFrame *frame, const TinkerFrame *other);
void tinker_frame_forget_spans(TinkerFrame *frame);

/* Where a block's centre is; NAN for a block that has neither place nor ends. */
void tinker_frame_centre(const TinkerFrame *frame, TinkerBlockId block, double *x, double *y, double *orientation);

/* How motions move a block now; NULL where none does. Borrowed until the next time is set. */
const TinkerPlace *tinker_frame_motion(const TinkerFrame *frame, TinkerBlockId block);

/* A place of the world in the block's own axes, from its centre, and back. */
void tinker_frame_to_own(const TinkerFrame *frame, TinkerBlockId block, const double place[2], double own[2]);
void tinker_frame_to_world(const TinkerFrame *frame, TinkerBlockId block, const double own[2], double place[2]);

/* One block as drawing and editing see it; connectors between the same two places stand side by side. Borrowed memory:
 * valid until the next call with the same frame or until it changes. FALSE for a placeholder, of which only name and
 * centre (where its text tells one) are filled. */
gboolean tinker_frame_instance(TinkerFrame *frame, TinkerBlockId block, TinkerInstance *instance);

/* Sets the size of symbols (m) that instances report from now on: whoever draws the frame sets that of the style, so
 * that what is hit is what was drawn. 0, the default: unknown. */
void tinker_frame_set_symbol_size(TinkerFrame *frame, double symbol_size);

/* A column of a block now: the snapshot's value, "as placed" lengths resolved from the ends at t = 0. */
double tinker_frame_column(const TinkerFrame *frame, TinkerBlockId block, int32_t column);

/* The column that has a meaning (TINKER_MEANING_...), by component; `otherwise` where the block has none such. */
double tinker_frame_meaning(const TinkerFrame *frame, TinkerBlockId block, int32_t meaning, int32_t component,
                            double otherwise);

/* Where an end is, connectors side by side not moved apart. */
void tinker_frame_end(const TinkerFrame *frame, TinkerSceneEnd end, double place[2]);

#endif

/* Where bodies have been: their paths, with marks at equal times, so that speed can be read from how far the marks are
 * apart; and the bodies themselves at these times, as a stroboscope shows them. */
#ifndef TINKER_HOST_MOTION_TRAIL_H
#define TINKER_HOST_MOTION_TRAIL_H

#include "render/picture/painter.h"

typedef struct _TinkerMotionTrail TinkerMotionTrail;

/* The time between marks, where nobody says: 1, 2 or 5 times a power of ten of a second, of which eight to twenty fit
 * into the duration (s). */
double tinker_motion_trail_spacing(double duration);

/* Of all bodies of the scene that can move. `every` (s, more than 0): the time between marks. (transfer full) */
TinkerMotionTrail *tinker_motion_trail_new(TinkerScene *scene, double every);
void tinker_motion_trail_free(TinkerMotionTrail *trail);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerMotionTrail, tinker_motion_trail_free)

/* The bodies, whose poses are noted in this order. Borrowed. */
const TinkerBlockId *tinker_motion_trail_bodies(const TinkerMotionTrail *trail, int *count);
double tinker_motion_trail_every(const TinkerMotionTrail *trail);
/* s: of the latest pose; -1 where there is none. */
double tinker_motion_trail_reached(const TinkerMotionTrail *trail);

/* Notes where the bodies are at a time later than all before: x, y (m) and orientation (rad) of each. */
void tinker_motion_trail_note(TinkerMotionTrail *trail, double time, const double *poses);
/* Notes where they are in a frame. */
void tinker_motion_trail_note_frame(TinkerMotionTrail *trail, const TinkerFrame *frame);
/* Forgets all. */
void tinker_motion_trail_clear(TinkerMotionTrail *trail);

/* Draws paths and marks up to a time, for `only` (may be NULL) the bodies that it answers TRUE for. In canvas units. */
typedef gboolean (*TinkerTrailFilter)(TinkerBlockId body, void *data);
void tinker_motion_trail_draw(const TinkerMotionTrail *trail, cairo_t *cairo, const TinkerView *view,
                              const TinkerTheme *theme, double until, TinkerTrailFilter only, void *data);

/* Draws the bodies as they were at every mark, pale. `frame`, one of the scene's for this alone, is moved about. */
void tinker_motion_trail_draw_ghosts(const TinkerMotionTrail *trail, cairo_t *cairo, const TinkerView *view,
                                     const TinkerTheme *theme, TinkerFrame *frame);

/* Widens a box (m) by the bodies at every mark and by their paths; `frame` as above. */
void tinker_motion_trail_widen(const TinkerMotionTrail *trail, TinkerFrame *frame, double box[4]);

#endif

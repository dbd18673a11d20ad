/* Forces, and what they add up to, as arrows over a drawn scene, with a key. */
#ifndef TINKER_HOST_FORCE_ARROWS_H
#define TINKER_HOST_FORCE_ARROWS_H

#include <cairo.h>

#include "common/overlay/motion-vectors.h"
#include "common/overlay/pointed.h"
#include "physics/run/acting-forces.h"
#include "render/draw/theme.h"
#include "render/draw/view.h"
#include "render/picture/arrows.h"

/* Everything is borrowed. */
typedef struct {
    TinkerScene *scene;
    TinkerFrame *frame;     /* as it is drawn, whose small bodies labels keep clear of; NULL: they do not */
    const GArray *acting;   /* of TinkerActingForce: all that are to be shown */
    const GArray *at_start; /* likewise, of the start of the run, whose scale the arrows have unless they outgrow it;
                               NULL: their own */
    double pixels;          /* canvas units per N, of net forces too; 0: not known yet */
    const GArray *vectors;  /* of TinkerMotionVector, to be shown beside them; NULL: none */
    double vector_pixels[TINKER_VECTOR_KINDS]; /* canvas units per m/s and m/s^2; 0: not known yet */
    const double *greatest;   /* of the kinds over the run, SI, whose scale the vectors have; NULL: their own */
    const GPtrArray *texts;   /* of TinkerWrittenText: what labels keep clear of; NULL: nothing */
    const char *marks;        /* for the key: the time between marks of paths; NULL: there are none */
    const TinkerPointed *lit; /* whose forces stand out from others, where any are shown; NULL: nobody's */
    GArray *spots;            /* of TinkerSpot: receives where what was drawn; NULL: nobody asks */
} TinkerForceArrows;

/* What a kind of arrow is called, in a word. */
const char *tinker_force_arrow_word(TinkerArrowKind kind);

/* Whether a force pushes on the body that it acts on: its arrow ends where it acts, and stands outside of the body. Of
 * a frame where bodies are. */
gboolean tinker_force_arrow_pushes(const TinkerFrame *frame, TinkerBlockId on, const double point[2],
                                   const double force[2]);

/* Whether one of them is not 0. */
gboolean tinker_force_arrows_any(const GArray *acting);

/* N: that of the strongest of them. */
double tinker_force_arrows_greatest(const GArray *acting);

/* Whether the longest arrow is longer than half of the picture at so many canvas units per N, so that a scale that was
 * chosen for other forces is none for these. */
gboolean tinker_force_arrows_outgrow(const GArray *acting, const TinkerView *view, double pixels);

/* Canvas units per N, so that the longest arrow is well seen; `previous` as in arrows.h. */
double tinker_force_arrows_scale(const GArray *acting, const TinkerView *view, double previous);

/* Draws the arrows and the key; what has no scale is left out. */
void tinker_force_arrows_draw(const TinkerForceArrows *forces, cairo_t *cairo, const TinkerView *view,
                              const TinkerTheme *theme);

/* Whether it acts on a body that can move; takes those out that do not. */
gboolean tinker_force_acts_on_moving(TinkerScene *scene, const TinkerActingForce *force);
void tinker_force_arrows_keep_moving(TinkerScene *scene, GArray *acting);

/* What TinkerPaintOptions.over takes, with TinkerForceArrows as its data: chooses the scale where it is not known. */
void tinker_force_arrows_over(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data);

#endif

/* Forces as arrows over a drawn scene, with a key. */
#ifndef TINKER_HOST_FORCE_ARROWS_H
#define TINKER_HOST_FORCE_ARROWS_H

#include <cairo.h>

#include "physics/run/acting-forces.h"
#include "render/draw/theme.h"
#include "render/draw/view.h"
#include "render/picture/arrows.h"

/* Everything is borrowed. */
typedef struct {
    TinkerScene *scene;
    const GArray *acting;   /* of TinkerActingForce: all that are to be shown */
    const GArray *at_start; /* likewise, of the start of the run, whose scale the arrows have; NULL: their own */
    double pixels;          /* canvas units per N; 0: not known yet */
    TinkerBlockId lit;      /* whose forces stand out from others, where any are shown; TINKER_NO_BLOCK: nobody's */
} TinkerForceArrows;

/* What a kind of arrow is called, in a word. */
const char *tinker_force_arrow_word(TinkerArrowKind kind);

/* Whether one of them is not 0. */
gboolean tinker_force_arrows_any(const GArray *acting);

/* Canvas units per N, so that the longest arrow is well seen; `previous` as in arrows.h. */
double tinker_force_arrows_scale(const GArray *acting, const TinkerView *view, double previous);

/* Draws the arrows and the key; nothing where the scale is not known. */
void tinker_force_arrows_draw(const TinkerForceArrows *forces, cairo_t *cairo, const TinkerView *view,
                              const TinkerTheme *theme);

/* Whether it acts on a body that can move; takes those out that do not. */
gboolean tinker_force_acts_on_moving(TinkerScene *scene, const TinkerActingForce *force);
void tinker_force_arrows_keep_moving(TinkerScene *scene, GArray *acting);

/* What TinkerPaintOptions.over takes, with TinkerForceArrows as its data: chooses the scale where it is not known. */
void tinker_force_arrows_over(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data);

#endif

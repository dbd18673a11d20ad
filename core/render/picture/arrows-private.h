/* For tests of arrows. */
#ifndef TINKER_RENDER_ARROWS_PRIVATE_H
#define TINKER_RENDER_ARROWS_PRIVATE_H

#include "render/picture/arrows.h"

/* tinker_arrows_draw that appends what it wrote (TinkerWrittenText) to an array. */
void tinker_arrows_draw_noting(cairo_t *cairo, const TinkerView *view, const TinkerForceArrow *arrows, gsize count,
                               const TinkerArrowOptions *options, GPtrArray *written);

#endif

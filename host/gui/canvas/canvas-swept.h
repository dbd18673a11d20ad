/* Where things are drawn on the way of a run: what is laid over the canvas keeps clear of it. */
#ifndef TINKER_GUI_CANVAS_SWEPT_H
#define TINKER_GUI_CANVAS_SWEPT_H

#include "gui/document/player.h"
#include "render/draw/view.h"

/* The world boxes (double[4]: least x and y, greatest x and y) that drawings take at some times of what is recorded,
 * where that is not about where they are now; so many at most that whoever looks for room among them has an answer at
 * once. Empty where nothing is recorded. (transfer full) */
GArray *tinker_swept_boxes(TinkerPlayer *player, const TinkerView *view);

#endif

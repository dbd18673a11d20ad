/* Where things are drawn on the way of a run: what is laid over the canvas keeps clear of it. */
#ifndef TINKER_GUI_CANVAS_SWEPT_H
#define TINKER_GUI_CANVAS_SWEPT_H

#include "gui/document/player.h"
#include "render/draw/view.h"

/* The way that was looked up last, and of what: moving the view costs nothing. Zeroed at first. */
typedef struct {
    GArray *boxes; /* of double[4], in the world; NULL */
    guint64 revision;
    guint generation;
    double reached, scale;
    guint looked; /* how often the record was gone through */
} TinkerSwept;

void tinker_swept_clear(TinkerSwept *swept);

/* The world boxes (double[4]: least x and y, greatest x and y) that the drawings of what moves take at some times of
 * what is recorded of this document; so many at most that whoever looks for room among them has an answer at once.
 * Empty where nothing is recorded. They are looked up anew where scene, record or scale are others; while a run goes
 * on, where there is a good deal more of it. Borrowed until the next call. */
const GArray *tinker_swept_boxes(TinkerSwept *swept, TinkerDocument *document, TinkerPlayer *player,
                                 const TinkerView *view);

#endif

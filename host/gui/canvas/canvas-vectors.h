/* What the canvas knows of the motion of bodies beside the forces on them: how they move now, what was greatest in the
 * run, and where they have been. */
#ifndef TINKER_GUI_CANVAS_VECTORS_H
#define TINKER_GUI_CANVAS_VECTORS_H

#include "common/overlay/motion-trail.h"
#include "common/overlay/motion-vectors.h"
#include "gui/document/player.h"

typedef struct _CanvasVectors CanvasVectors;

/* (transfer full) */
CanvasVectors *canvas_vectors_new(void);
void canvas_vectors_free(CanvasVectors *vectors);

/* Takes in what has been recorded since the last call. */
void canvas_vectors_update(CanvasVectors *vectors, TinkerDocument *document, TinkerPlayer *player);

/* The vectors of the present time, of TinkerMotionVector: those of the bodies that are selected, or of all where none
 * is. `acting`: all forces. Borrowed, valid until the next call. */
const GArray *canvas_vectors_now(CanvasVectors *vectors, TinkerDocument *document, TinkerPlayer *player,
                                 const TinkerVectorChoice *choice, const GArray *acting);

/* The greatest of a kind in what is recorded and was shown, SI. */
double canvas_vectors_greatest(const CanvasVectors *vectors, TinkerVectorKind kind);

/* The trail of what is recorded; NULL where nothing is. Borrowed. */
const TinkerMotionTrail *canvas_vectors_trail(const CanvasVectors *vectors);

/* Whether a body is one whose motion is shown. */
gboolean canvas_vectors_shows(TinkerDocument *document, TinkerBlockId body);

#endif

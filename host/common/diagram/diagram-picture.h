/* Free-body and kinetic diagrams as pictures: the bodies alone, every force at its point with its source and size, and
 * beside an equals sign what the forces make, mass times acceleration; below, the same in numbers. */
#ifndef TINKER_HOST_DIAGRAM_PICTURE_H
#define TINKER_HOST_DIAGRAM_PICTURE_H

#include <cairo.h>

#include "common/overlay/pointed.h"
#include "equations/balance/diagram.h"
#include "render/draw/theme.h"
#include "scene/frame/frame.h"

typedef enum { TINKER_DIAGRAM_BOTH, TINKER_DIAGRAM_FREE_BODY, TINKER_DIAGRAM_KINETIC } TinkerDiagramKind;

/* Everything is borrowed. */
typedef struct {
    TinkerFrame *frame; /* of the scene, at the state */
    const TinkerDiagram *diagram;
    const TinkerBlockId *blocks; /* that it is of, ended by TINKER_NO_BLOCK */
    TinkerDiagramKind kind;
    const TinkerTheme *theme;
    const TinkerPointed *lit; /* whose arrows stand out from others, where there are any; NULL: nobody's */
    GArray
        *spots; /* of TinkerSpot: receives where forces and torques are, in the order of the list; NULL: nobody asks */
} TinkerDiagramPicture;

/* The force that a term of a body's equation, or an arrow of its diagram, stands for. */
TinkerPointed tinker_diagram_pointed(TinkerBlockId from, TinkerBlockId on, TinkerTermKind kind);

/* A frame at a state, as a picture wants it. (transfer full) */
TinkerFrame *tinker_diagram_frame(TinkerScene *scene, const TinkerModelState *state, GError **error);

/* Draws it over all of width and height; `data` is a TinkerDiagramPicture. */
void tinker_diagram_draw(cairo_t *cairo, double width, double height, void *data);

#endif

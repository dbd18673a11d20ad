/* The forces that the canvas shows as arrows, how bodies move and where they have been: of the bodies that are
 * selected, or of all that can move. Beside them stands how long arrows are drawn, and what the colours mean. */
#ifndef TINKER_GUI_CANVAS_FORCES_H
#define TINKER_GUI_CANVAS_FORCES_H

#include <cairo.h>

#include "common/overlay/motion-vectors.h"
#include "gui/document/player.h"
#include "render/draw/theme.h"
#include "render/draw/view.h"

typedef struct _CanvasForces CanvasForces;

/* (transfer full) */
CanvasForces *canvas_forces_new(void);
void canvas_forces_free(CanvasForces *forces);

/* How long arrows are is chosen anew, for another scene. */
void canvas_forces_forget(CanvasForces *forces);

/* How they are drawn. */
typedef struct {
    const TinkerTheme *theme;
    double factor;              /* how much longer than usual arrows are */
    const TinkerPointed *lit;   /* whose forces are looked at; NULL: nobody's more than others' */
    gboolean others;            /* with bodies selected, those that these exert on others are shown, too */
    gboolean forces;            /* single forces are shown, */
    gboolean trails;            /* and where bodies have been, */
    TinkerVectorChoice vectors; /* and these of them */
    const GPtrArray *texts;     /* of TinkerWrittenText: what labels keep clear of */
} CanvasForcesLook;

/* Draws those of the present time. Where working them out takes long, arrows of a little earlier are drawn while it
 * plays. A scene that cannot run has none. */
void canvas_forces_draw(CanvasForces *forces, cairo_t *cairo, TinkerDocument *document, TinkerPlayer *player,
                        const TinkerView *view, const CanvasForcesLook *look);

/* The arrows and labels that were drawn last (canvas units). Element: TinkerSpot. Borrowed until the next drawing. */
const GArray *canvas_forces_spots(const CanvasForces *forces);

#endif

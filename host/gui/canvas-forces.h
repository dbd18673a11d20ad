/* The forces that the canvas shows as arrows: on the bodies that are selected, or on all that can move. */
#ifndef TINKER_GUI_CANVAS_FORCES_H
#define TINKER_GUI_CANVAS_FORCES_H

#include <cairo.h>

#include "player.h"
#include "render/theme.h"
#include "render/view.h"

typedef struct _CanvasForces CanvasForces;

/* (transfer full) */
CanvasForces *canvas_forces_new(void);
void canvas_forces_free(CanvasForces *forces);

/* Draws those of the present time. Where working them out takes long, arrows of a little earlier are drawn while it plays. A
 * scene that cannot run has none. */
void canvas_forces_draw(CanvasForces *forces, cairo_t *cairo, TinkerDocument *document, TinkerPlayer *player,
                        const TinkerView *view, const TinkerTheme *theme);

#endif

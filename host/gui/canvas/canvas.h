/* The canvas: the scene as the player has it, to look at and to edit with pointer and keys. */
#ifndef TINKER_GUI_CANVAS_H
#define TINKER_GUI_CANVAS_H

#include <gtk/gtk.h>

#include "edit/drag.h"
#include "gui/document/player.h"
#include "render/picture/painter.h"

#define TINKER_TYPE_CANVAS (tinker_canvas_get_type())
G_DECLARE_FINAL_TYPE(TinkerCanvas, tinker_canvas, TINKER, CANVAS, GtkWidget)

/* Shows this document as the player has it. Takes references. */
void tinker_canvas_set_player(TinkerCanvas *canvas, TinkerDocument *document, TinkerPlayer *player);

/* What is shown beside the blocks. Properties "show-labels", "show-forces", "show-local-origins", "show-grid"; "large":
 * all that is drawn is larger, for those who sit at the back. */

/* A widget that lies over the top of the canvas, as high as it is: marks at the edge keep below it. Borrowed; NULL:
 * there is none. */
void tinker_canvas_set_cover(TinkerCanvas *canvas, GtkWidget *cover);

/* How much of it that covers, from the top on (widget units); "view-changed" tells of another one. */
double tinker_canvas_covered(TinkerCanvas *canvas);

/* It has got another place or height: a scene that is shown wholly is shown below it, if it would cover some of that.
 */
void tinker_canvas_cover_placed(TinkerCanvas *canvas);

/* The signal "panels" (GArray *boxes) asks for what else lies over it, of double[4]: least and greatest x and y, widget
 * units. Names and labels keep clear of that; who has moved some of it has the canvas drawn again. */

/* Marks these blocks as those that something is wrong with; ids of blocks that are gone are passed over. Copied. */
void tinker_canvas_set_marked(TinkerCanvas *canvas, const TinkerBlockId *blocks, int count);

/* The signal "menu" (double x, double y, widget units) asks for the menu of what is selected. */

/* The signal "dropped" (TinkerBlockId block, double reach, m): a drag of it has ended, and is part of the history. */

/* What drawings of blocks did that they must not do, of const char *; told by the signal "faults". (transfer container)
 */
GList *tinker_canvas_faults(TinkerCanvas *canvas);

/* The view in widget coordinates. The signal "view-changed" tells of another one. */
const TinkerView *tinker_canvas_view(TinkerCanvas *canvas);

/* Zooms about the middle; fits everything into the window; shows as many m from left to right as the scene says. */
void tinker_canvas_zoom(TinkerCanvas *canvas, double factor);
void tinker_canvas_fit(TinkerCanvas *canvas);
/* Whether it shows all that was fitted into it, whatever its size; not once somebody has looked elsewhere. */
gboolean tinker_canvas_is_fitted(TinkerCanvas *canvas);
/* Draws arrows of forces longer by this factor than they are now. */
void tinker_canvas_scale_forces(TinkerCanvas *canvas, double factor);
void tinker_canvas_show_width(TinkerCanvas *canvas);
/* As a scene is shown when it is opened. */
void tinker_canvas_show_first(TinkerCanvas *canvas);

/* A new block of a class on its way from the palette, as one step for undo: _move with a point in widget coordinates
 * shows it there (or takes it away, outside of the canvas), _drop leaves it there, _cancel takes it away. */
/* The handle of the selected block that the pointer is on, or none, and where in the world (m) the pointer is. */
TinkerHit tinker_canvas_handle(TinkerCanvas *canvas, double place[2]);

void tinker_canvas_place_move(TinkerCanvas *canvas, const TinkerBlockClass *block_class, double x, double y);
TinkerBlockId tinker_canvas_place_drop(TinkerCanvas *canvas);
void tinker_canvas_place_cancel(TinkerCanvas *canvas);

/* Puts a new block where there is room; its ends onto the blocks that are selected, where they take them. */
TinkerBlockId tinker_canvas_add(TinkerCanvas *canvas, const TinkerBlockClass *block_class);

/* Shows a frame over the scene, or none (NULL), until it is told another one: for what is no motion of the run. The
 * frame is borrowed until then; where it has moved, this is called again. */
void tinker_canvas_show_over(TinkerCanvas *canvas, TinkerFrame *frame);

/* Draws what it shows for white paper, without selection and marks, as large as it is in the window. */
void tinker_canvas_draw_for_paper(TinkerCanvas *canvas, cairo_t *cairo);

#endif

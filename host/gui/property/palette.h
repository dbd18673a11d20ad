/* The palette: the installed blocks by category, to be put on the canvas by a click or by dragging. */
#ifndef TINKER_GUI_PALETTE_H
#define TINKER_GUI_PALETTE_H

#include "gui/canvas/canvas.h"

#define TINKER_TYPE_PALETTE (tinker_palette_get_type())
G_DECLARE_FINAL_TYPE(TinkerPalette, tinker_palette, TINKER, PALETTE, GtkWidget)

/* Shows what the catalogue has; blocks go to this canvas. The catalogue is borrowed. */
void tinker_palette_set_canvas(TinkerPalette *palette, TinkerCatalogue *catalogue, TinkerCanvas *canvas);

/* Gives the focus to the block that was placed last, before that to the first one. */
void tinker_palette_focus(TinkerPalette *palette);

/* Symbols alone, with their names in tooltips, where the window is narrow. */
void tinker_palette_set_compact(TinkerPalette *palette, gboolean compact);

#endif

/* Icons of blocks, for a palette: each drawn by the block itself. */
#ifndef TINKER_CORE_ICON_H
#define TINKER_CORE_ICON_H

#include <cairo.h>

#include "plugin/catalogue/catalogue.h"
#include "render/draw/theme.h"

/* Draws the picture that a class brings along (icon_path), else one block of it, as it is with its default properties,
 * into the rectangle (0, 0, width, height) of the context, on whatever is there. 48 by 32 is enough to tell blocks
 * apart. The drawing fills the rectangle as far as its proportions let it and never leaves it. */
void tinker_paint_block_icon(cairo_t *cairo, const TinkerBlockClass *block_class, double width, double height,
                             const TinkerTheme *theme);

#endif

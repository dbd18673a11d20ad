/* Notes on the canvas: lines of text with formulas in them. */
#ifndef TINKER_RENDER_NOTE_H
#define TINKER_RENDER_NOTE_H

#include <cairo.h>
#include <tinker/render.h>

/* As TinkerStyle.note: the style of a picture has it from here, as the rooms before this one set no formulas. What is
 * no formula is written as it is. */
void tinker_note_draw(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x, double y, double height,
                      const char *text);

#endif

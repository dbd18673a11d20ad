/* The style that blocks draw with: the host's side of tinker/render.h.
 *
 * The painter makes one for every picture. Whoever draws something of his own over a scene (arrows of forces, a ghost
 * of what is being placed) makes one too and uses the same helpers. */
#ifndef TINKER_CORE_STYLE_H
#define TINKER_CORE_STYLE_H

#include <cairo.h>

#include "render/draw/text.h"
#include "render/draw/theme.h"
#include "render/draw/view.h"

/* A style, and what its text helper writes with. Must not be moved once it is begun. */
typedef struct {
    TinkerStyle style;
    TinkerTextPen pen;
} TinkerStyleBrush;

/* Canvas units of an ordinary line and of labels. */
#define TINKER_STYLE_LINE 1.6
#define TINKER_STYLE_TEXT 12.0

/* Prepares a style for drawing on `cairo`, whose own units are the view's canvas units. `symbol` is the size of coils
 * and arrow heads in m. Nothing is selected. */
void tinker_style_begin(TinkerStyleBrush *brush, cairo_t *cairo, const TinkerTheme *theme, const TinkerView *view,
                        double symbol);
/* Frees what the style's texts needed. */
void tinker_style_end(TinkerStyleBrush *brush);

/* Makes the context's units m with y up, as helpers and blocks expect it; undo it with cairo_restore. */
void tinker_style_enter_world(const TinkerStyle *style, cairo_t *cairo);

/* The symbol size (m) that suits a view where blocks are about `typical` m large (0: unknown). */
double tinker_style_symbol(double scale, double typical);

#endif

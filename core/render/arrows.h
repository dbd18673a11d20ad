/* Arrows of forces over a picture of a scene: a free-body diagram where the bodies are. */
#ifndef TINKER_CORE_ARROWS_H
#define TINKER_CORE_ARROWS_H

#include <cairo.h>

#include "render/theme.h"
#include "render/view.h"

/* One force. */
typedef struct {
    double x, y;       /* m: where it acts, in the world; the arrow starts there */
    double fx, fy;     /* N */
    const char *label; /* UTF-8, beside the arrow's head: "Spring 0 12.3 N". NULL: none. Borrowed */
    int colour;        /* number of one of the theme's curve colours, which go round */
} TinkerForceArrow;

typedef struct {
    const TinkerTheme *theme;
    double scale; /* m per N */
    const double (
        *taken)[4]; /* boxes of the canvas (least and greatest x and y) that labels keep clear of; may be NULL */
    int taken_count;
} TinkerArrowOptions;

/* A round scale (m per N; 1, 2 or 5 times a power of ten) at which the longest arrow is about a tenth of the view's longer
 * side. `previous` (0: none) is answered as long as it is within a factor of 3 of that, so that arrows of forces that
 * change do not jump. Forces that are 0 or not finite do not count. */
double tinker_arrows_scale(const TinkerForceArrow *arrows, gsize count, const TinkerView *view, double previous);

/* Draws the arrows and then their labels, those of the greatest forces first. A label stands by the head of its arrow and
 * inside the picture; one that could only stand on another is left out. Arrows that start together and point the same way
 * are drawn side by side. What is too short to be seen, not finite or out of the picture is passed over. The context's own
 * units are the view's canvas units. */
void tinker_arrows_draw(cairo_t *cairo, const TinkerView *view, const TinkerForceArrow *arrows, gsize count,
                        const TinkerArrowOptions *options);

#endif

/* What a block's drawing leaves behind. A drawing is code of a plugin, which is handed the picture's cairo context: it
 * must leave it as it was. An error of a context cannot be taken back, and an open group or a state too many would
 * swallow or shift all that is drawn later, so the host draws with a context that it can throw away. */
#ifndef TINKER_RENDER_DRAW_WATCH_H
#define TINKER_RENDER_DRAW_WATCH_H

#include <cairo.h>
#include <glib.h>

/* Another context on what `cairo` draws on, as it is now: its transform, clip and antialiasing. Whatever becomes of it
 * does nothing to `cairo`. (transfer full) */
cairo_t *tinker_context_new(cairo_t *cairo);

typedef struct {
    cairo_surface_t *target;
    cairo_matrix_t matrix;
    double mark;
} TinkerDrawWatch;

/* Saves the context's state, and clears its path, before a block draws. */
void tinker_draw_watch_begin(TinkerDrawWatch *watch, cairo_t *cairo);

/* Restores it after that. NULL where it is as it was, else what the drawing did to it, which continues "it"; then the
 * context is of no use any more. (transfer full) */
char *tinker_draw_watch_end(const TinkerDrawWatch *watch, cairo_t *cairo);

#endif

/* The painter: draws a whole scene, each block by its own render interface. */
#ifndef TINKER_CORE_PAINTER_H
#define TINKER_CORE_PAINTER_H

#include <cairo.h>

#include "render/draw/paint-memory.h"
#include "render/draw/theme.h"
#include "render/draw/view.h"
#include "scene/frame/frame.h"

typedef struct {
    const TinkerTheme *theme;
    gboolean show_grid;
    gboolean show_labels; /* names beside bodies and, where there is room, connectors */
    gboolean show_local_origins;
    gboolean show_time; /* "t = 1.25 s" in a corner */
    gboolean show_title;
    const TinkerBlockId *only; /* of blocks with a place these alone, ended by TINKER_NO_BLOCK, and nothing beside them;
                                  NULL: all */
    TinkerBlockId highlighted; /* or TINKER_NO_BLOCK */
    const TinkerBlockId *selected;
    int selected_count;
    gboolean quick;            /* for a window: edges in coarser shades, at less than half the cost */
    TinkerPaintMemory *memory; /* that all pictures of a film or a window share: each takes less time, and a name stays
                                  on its side of its body. NULL: every picture is made by itself */
    /* Called when all is drawn, in canvas units: for what else is to be in the picture, such as forces and their key in
     * the lower left corner, which the time leaves free; and `under` when the grid is, for what lies beneath. NULL:
     * nothing. */
    void (*over)(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data);
    void (*under)(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data);
    void *over_data;  /* of the two */
    GPtrArray *texts; /* receives what is written (TinkerWrittenText), for `over` to keep clear of; names keep clear of
                       * what is in it before, such as panels of a window over the picture. NULL: not wanted */
    GHashTable *faults; /* block class to text (owned): what drawings did to the context that they must not do, with the
                         * block's name, once a class. NULL: it is not told */
} TinkerPaintOptions;

/* The light theme, grid and labels on, time and title off, nothing selected. */
TinkerPaintOptions tinker_paint_options_default(void);

/* Widens a box (least x and y, greatest x and y) to hold another as well. */
void tinker_painter_unite(double box[4], const double other[4]);

/* The world box that shows everything in the frame, drawings' bounds included; of a plate that is far longer than all
 * else as much as lies about that. */
void tinker_painter_bounds(TinkerFrame *frame, double box[4]);

/* The world boxes of the drawings in a view, of double[4] as above, in drawing order; fields have none. The frame's
 * symbol size becomes that of the view. (transfer full) */
GArray *tinker_painter_boxes(TinkerFrame *frame, const TinkerView *view);

/* The world box of one block's drawing in a view; FALSE where it has none. */
gboolean tinker_painter_box(TinkerFrame *frame, TinkerBlockId block, const TinkerView *view, double box[4]);

/* What the fields in the upper left corner of a view take of it, with their names: its right and lower edge (canvas
 * units); 0 and 0 where there are none. */
void tinker_painter_fields_reach(TinkerFrame *frame, const TinkerView *view, double reach[2]);

/* The size of symbols (m) that the painter draws this frame with at a scale (canvas units per m). */
double tinker_painter_symbol_size(TinkerFrame *frame, double scale);

/* Draws background, grid, all blocks by layer and drawing order, placeholders as labelled boxes. The context's own
 * transform stays as it was. The frame's symbol size becomes that of the drawing. */
void tinker_paint_scene(cairo_t *cairo, TinkerFrame *frame, const TinkerView *view, const TinkerPaintOptions *options);

/* The block without a place in the world (a field) whose arrow the painter shows at this point of the canvas, or
 * TINKER_NO_BLOCK. */
TinkerBlockId tinker_painter_field_at(TinkerFrame *frame, const TinkerView *view, double canvas_x, double canvas_y);

/* Draws a frame to a file: the ending of `path` says what (.png, .svg, .pdf); "-" is not taken. `box` NULL: the frame's
 * bounds. width, height in pixels (points). */
gboolean tinker_paint_to_file(TinkerFrame *frame, const double box[4], int width, int height,
                              const TinkerPaintOptions *options, const char *path, GError **error);

#endif

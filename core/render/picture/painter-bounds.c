/* Where on the world blocks are drawn: the box of each, and of all of them. */
#include <math.h>

#include "render/picture/note.h"
#include "render/picture/painter-private.h"

#define LEAST_BOUNDS 5.0 /* of a typical block */

void tinker_painter_unite(double box[4], const double other[4])
{
    box[0] = fmin(box[0], other[0]);
    box[1] = fmin(box[1], other[1]);
    box[2] = fmax(box[2], other[2]);
    box[3] = fmax(box[3], other[3]);
}

/* Widens a box so that a lone block does not fill the picture. */
static void make_room(double box[4], double least)
{
    double room = (least - fmax(box[2] - box[0], box[3] - box[1])) / 2;
    if (room <= 0) return;
    tinker_painter_unite(box, (double[]){box[0] - room, box[1] - room, box[2] + room, box[3] + room});
}

/* What boxes are measured with: a style of this view, on a context that keeps nothing. */
typedef struct {
    TinkerStyleBrush brush;
    cairo_surface_t *surface;
    cairo_t *cairo;
} Measure;

static void measure_begin(Measure *measure, TinkerFrame *frame, const TinkerView *view)
{
    const double symbol = tinker_style_symbol(view->scale, tinker_frame_typical_size(frame));
    measure->surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    measure->cairo = cairo_create(measure->surface);
    tinker_frame_set_symbol_size(frame, symbol);
    tinker_style_begin(&measure->brush, measure->cairo, tinker_theme_find("light"), view, symbol);
    measure->brush.style.note = tinker_note_draw;
}

static void measure_end(Measure *measure)
{
    tinker_style_end(&measure->brush);
    cairo_destroy(measure->cairo);
    cairo_surface_destroy(measure->surface);
}

static gboolean measure_block(const Measure *measure, TinkerFrame *frame, TinkerBlockId block, double box[4])
{
    TinkerPiece piece;
    tinker_piece_init(&piece, frame, block);
    return piece.kind != TINKER_PIECE_FIELD && tinker_piece_box(&piece, &measure->brush.style, box);
}

GArray *tinker_painter_boxes(TinkerFrame *frame, const TinkerView *view)
{
    GArray *boxes = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    TinkerScene *scene = tinker_frame_scene(frame);
    Measure measure;
    measure_begin(&measure, frame, view);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        double own[4];
        if (measure_block(&measure, frame, tinker_scene_block_at(scene, place), own))
            g_array_append_vals(boxes, own, 1);
    }
    measure_end(&measure);
    return boxes;
}

gboolean tinker_painter_box(TinkerFrame *frame, TinkerBlockId block, const TinkerView *view, double box[4])
{
    Measure measure;
    measure_begin(&measure, frame, view);
    const gboolean has_box = measure_block(&measure, frame, block, box);
    measure_end(&measure);
    return has_box;
}

/* The box of all drawings in this view; where there are none, the box of an empty canvas. */
static void bounds_in(TinkerFrame *frame, const TinkerView *view, double box[4])
{
    g_autoptr(GArray) boxes = tinker_painter_boxes(frame, view);
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
    for (guint i = 0; i < boxes->len; i++)
        tinker_painter_unite(box, (const double *)(gpointer)boxes->data + 4 * (gsize)i);
    if (box[0] <= box[2]) {
        make_room(box, LEAST_BOUNDS * tinker_frame_typical_size(frame));
        return;
    }
    double half = tinker_scene_head(tinker_frame_scene(frame))->canvas_width / 2;
    if (!(half > 0) || !isfinite(half)) half = 5;
    box[0] = box[1] = -half;
    box[2] = box[3] = half;
}

void tinker_painter_bounds(TinkerFrame *frame, double box[4])
{
    /* Marks are as large on the canvas whatever the view, and the view follows from the box: the first round takes
     * marks without size, the second those of the view that shows the first box on a canvas of ordinary size. */
    TinkerView view = {.scale = 1e6, .width = 800, .height = 600};
    for (int round = 0; round < 2; round++) {
        bounds_in(frame, &view, box);
        view = tinker_view_fit(box, view.width, view.height, TINKER_PICTURE_MARGIN * view.height);
    }
}

/* Where on the world blocks are drawn: the box of each, and of all of them. */
#include <math.h>
#include <string.h>

#include "render/picture/note.h"
#include "render/picture/painter-private.h"
#include "scene/frame/tops.h"

#define LEAST_BOUNDS 5.0 /* of a typical block */
#define MOST_REACH   3.0 /* of what is there beside plates: how much of a long plate is shown */

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

static gboolean is_plate(TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    return block_class != NULL && tinker_class_has_top(block_class);
}

/* A floor of a kilometre is no reason to show the ball on it as a dot: of a plate that is longer than the scene says to
 * be wide, and than a few times what else there is, as much is shown as lies about that. */
static void unite_plate(double box[4], const double plate[4], const double others[4], double canvas_width)
{
    const double extent = fmax(others[2] - others[0], others[3] - others[1]);
    const double most = fmax(canvas_width, MOST_REACH * extent);
    double shown[4];
    for (int k = 0; k < 2; k++) {
        const double middle = (others[k] + others[k + 2]) / 2;
        const gboolean is_long = plate[k + 2] - plate[k] > most;
        /* One that lies to a side of all else is shown from its nearer end on. */
        shown[k] = is_long ? CLAMP(middle - most / 2, plate[k], plate[k + 2] - most) : plate[k];
        shown[k + 2] = is_long ? shown[k] + most : plate[k + 2];
    }
    tinker_painter_unite(box, shown);
}

/* The box of all drawings in this view; where there are none, the box of an empty canvas. */
static void bounds_in(TinkerFrame *frame, const TinkerView *view, double box[4])
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const double canvas_width = tinker_scene_head(scene)->canvas_width;
    g_autoptr(GArray) plates = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    double others[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    Measure measure;
    measure_begin(&measure, frame, view);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        double own[4];
        if (!measure_block(&measure, frame, block, own)) continue;
        if (is_plate(frame, block))
            g_array_append_vals(plates, own, 1);
        else
            tinker_painter_unite(others, own);
    }
    measure_end(&measure);
    memcpy(box, others, sizeof others);
    const gboolean alone = others[0] > others[2];
    for (guint i = 0; i < plates->len; i++) {
        const double *plate = (const double *)(gpointer)plates->data + 4 * (gsize)i;
        if (alone)
            tinker_painter_unite(box, plate);
        else
            unite_plate(box, plate, others, canvas_width);
    }
    if (box[0] <= box[2]) {
        make_room(box, LEAST_BOUNDS * tinker_frame_typical_size(frame));
        return;
    }
    double half = canvas_width / 2;
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

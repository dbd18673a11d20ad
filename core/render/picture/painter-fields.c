/* Fields have no place in the world. The painter gives each a slot in the upper left corner of the canvas, as wide as
 * its drawing or its name, and moves the instance's point there; drawings stand on one line, names in a row beneath it.
 * Their size belongs to the canvas: it does not change when the view is zoomed. */
#include "render/picture/painter-private.h"

#include <math.h>

#define INSET            12.0 /* canvas units from the canvas's corner and between slots */
#define LEAST_SLOT       36.0
#define GREATEST_DRAWING (10 * LEAST_SLOT)
#define NAME_LIMIT       120.0
#define NAME_GAP         4.0

typedef struct {
    TinkerBlockId block;
    double box[4]; /* of the drawing about its own point, canvas units with y down */
    double left, width;
} Slot;

/* The slots in drawing order, and the line that all drawings stand on. */
typedef struct {
    GArray *slots;
    double base;
    double name_height;
} Slots;

static TinkerText name_of(const TinkerPicture *picture, TinkerBlockId block)
{
    const char *name = tinker_scene_block_name(tinker_frame_scene(picture->frame), block);
    return (TinkerText){.text = name, .size = TINKER_STYLE_TEXT, .limit = NAME_LIMIT, .anchor_x = 0.5};
}

/* The ink of the drawing, which a recording context measures: the declared bounds may be generous. A drawing without
 * ink, or a huge one, gets an empty slot. */
static void drawing_box(TinkerPiece piece, const TinkerStyle *style, double box[4])
{
    cairo_surface_t *ink = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cairo = cairo_create(ink);
    double unit = tinker_style_unit(style), half = LEAST_SLOT / 2, x, y, width, height;
    /* Helpers draw what is visible: here that is about the origin, wherever the picture's view is. */
    TinkerStyle around = *style;
    around.view[0] = around.view[1] = -GREATEST_DRAWING * unit;
    around.view[2] = around.view[3] = GREATEST_DRAWING * unit;
    piece.instance.x = piece.instance.y = 0;
    piece.instance.symbol_size = style->symbol_size;
    cairo_scale(cairo, 1 / unit, -1 / unit);
    g_free(tinker_piece_draw(&piece, cairo, &around));
    cairo_recording_surface_ink_extents(ink, &x, &y, &width, &height);
    cairo_destroy(cairo);
    cairo_surface_destroy(ink);
    gboolean usable = width > 0 && height > 0 && fmax(fabs(x), fabs(y)) + fmax(width, height) < GREATEST_DRAWING;
    box[0] = usable ? x : -half;
    box[1] = usable ? y : -half;
    box[2] = usable ? x + width : half;
    box[3] = usable ? y + height : half;
}

/* Measures every field; one that has no room any more is left out. */
static Slots find_slots(TinkerPicture *picture)
{
    Slots found = {.slots = g_array_new(FALSE, FALSE, sizeof(Slot))};
    const double top = picture->view->covered + INSET;
    TinkerScene *scene = tinker_frame_scene(picture->frame);
    double left = INSET;
    found.base = top + LEAST_SLOT;
    for (int32_t place = 0; place < picture->block_count; place++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, tinker_scene_block_at(scene, place));
        if (piece.kind != TINKER_PIECE_FIELD) continue;
        Slot slot = {.block = piece.block, .left = left};
        drawing_box(piece, &picture->brush.style, slot.box);
        slot.width = fmax(slot.box[2] - slot.box[0], LEAST_SLOT);
        if (picture->options->show_labels) {
            double width;
            TinkerText name = name_of(picture, piece.block);
            tinker_text_measure(&picture->brush.pen, &name, &width, &found.name_height);
            slot.width = fmax(slot.width, width);
        }
        if (left > INSET && left + slot.width > picture->view->width) break;
        left += slot.width + INSET;
        found.base = fmax(found.base, top + slot.box[3] - slot.box[1]);
        g_array_append_val(found.slots, slot);
    }
    return found;
}

static void draw_slot(TinkerPicture *picture, const Slot *slot, double base)
{
    TinkerStyle *style = &picture->brush.style;
    double middle = slot->left + slot->width / 2;
    TinkerPiece piece;
    tinker_piece_init(&piece, picture->frame, slot->block);
    tinker_view_to_world(picture->view, middle - (slot->box[0] + slot->box[2]) / 2, base - slot->box[3],
                         &piece.instance.x, &piece.instance.y);
    piece.instance.symbol_size = style->symbol_size;
    style->state = tinker_picture_state(picture, &piece);
    tinker_style_enter_world(style, picture->cairo);
    tinker_picture_draw_piece(picture, &piece);
    cairo_restore(picture->cairo);
    if (!picture->options->show_labels) return;
    const double *c = picture->options->theme->colours[TINKER_COLOUR_TEXT];
    TinkerText name = name_of(picture, slot->block);
    cairo_set_source_rgba(picture->cairo, c[0], c[1], c[2], c[3]);
    tinker_text_draw(&picture->brush.pen, picture->cairo, &name, middle, base + NAME_GAP);
}

/* The picture with a style of its own for fields. */
static TinkerPicture *begin_corner(TinkerPicture *corner, cairo_t *cairo, TinkerFrame *frame, const TinkerView *view,
                                   const TinkerPaintOptions *options)
{
    *corner = (TinkerPicture){.cairo = cairo, .frame = frame, .view = view, .options = options};
    corner->block_count = tinker_scene_block_count(tinker_frame_scene(frame));
    tinker_style_begin(&corner->brush, cairo, options->theme, view, tinker_style_symbol(view->scale, 0));
    return corner;
}

void tinker_picture_draw_fields(TinkerPicture *picture, double corner_box[4])
{
    TinkerPicture corner;
    begin_corner(&corner, picture->cairo, picture->frame, picture->view, picture->options);
    corner.brush.pen.written = picture->brush.pen.written;
    corner.brush.pen.memory = picture->brush.pen.memory;
    corner.selected = picture->selected;
    corner.caller = picture->caller;
    Slots found = find_slots(&corner);
    for (guint i = 0; i < found.slots->len; i++) {
        const Slot *slot = &g_array_index(found.slots, Slot, i);
        draw_slot(&corner, slot, found.base);
        corner_box[2] = slot->left + slot->width;
        corner_box[3] = found.base + NAME_GAP + found.name_height;
    }
    picture->cairo = corner.cairo; /* it may have been made anew */
    g_array_unref(found.slots);
    tinker_style_end(&corner.brush);
}

/* Begins a corner on a context without a picture, which is enough for measuring. */
static Slots measure(TinkerPicture *corner, TinkerFrame *frame, const TinkerView *view,
                     const TinkerPaintOptions *options)
{
    cairo_surface_t *surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cairo = cairo_create(surface);
    Slots found = find_slots(begin_corner(corner, cairo, frame, view, options));
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    tinker_style_end(&corner->brush);
    return found;
}

void tinker_fields_corner(TinkerFrame *frame, const TinkerView *view, const TinkerPaintOptions *options,
                          double corner_box[4])
{
    TinkerPicture corner;
    Slots found = measure(&corner, frame, view, options);
    if (found.slots->len > 0) {
        const Slot *last = &g_array_index(found.slots, Slot, found.slots->len - 1);
        corner_box[2] = last->left + last->width;
        corner_box[3] = found.base + NAME_GAP + found.name_height;
    }
    g_array_unref(found.slots);
}

void tinker_painter_fields_reach(TinkerFrame *frame, const TinkerView *view, double reach[2])
{
    const TinkerPaintOptions options = tinker_paint_options_default();
    double corner[4] = {0};
    tinker_fields_corner(frame, view, &options, corner);
    reach[0] = corner[2];
    reach[1] = corner[3];
}

TinkerBlockId tinker_painter_field_at(TinkerFrame *frame, const TinkerView *view, double canvas_x, double canvas_y)
{
    TinkerPaintOptions options = tinker_paint_options_default();
    TinkerPicture corner;
    Slots found = measure(&corner, frame, view, &options);
    TinkerBlockId hit = TINKER_NO_BLOCK;
    double bottom = found.base + NAME_GAP + found.name_height;
    for (guint i = 0; i < found.slots->len && canvas_y >= view->covered + INSET && canvas_y <= bottom; i++) {
        const Slot *slot = &g_array_index(found.slots, Slot, i);
        if (canvas_x >= slot->left && canvas_x <= slot->left + slot->width) hit = slot->block;
    }
    g_array_unref(found.slots);
    return hit;
}

/* The painter twice: first with a theme whose colours are nearly the background's, then with one without a background.
 */
#include "render/picture/ghost.h"

#include <math.h>
#include <string.h>

#include "render/draw/surface.h"
#include "render/picture/painter-private.h"

/* How much of a colour is left in grey. */
#define LEFT_OF_COLOUR 0.26
/* Of the picture's lesser side. */
#define MARGIN       0.08
#define CAPTION_SIZE 15.0
#define CAPTION_ROOM 34.0

typedef struct {
    const TinkerGhost *ghost;
    const TinkerPaintOptions *options;
} GhostPicture;

static TinkerTheme faded(const TinkerTheme *theme)
{
    TinkerTheme copy = *theme;
    for (int i = 0; i < TINKER_COLOUR_COUNT; i++) {
        double *colour = copy.colours[i];
        double grey = 0.3 * colour[0] + 0.59 * colour[1] + 0.11 * colour[2];
        for (int k = 0; k < 3; k++)
            colour[k] = theme->background[k] + LEFT_OF_COLOUR * (grey - theme->background[k]);
    }
    /* what stands in the corner is drawn once, in colour */
    copy.colours[TINKER_COLOUR_FIELD][3] = copy.colours[TINKER_COLOUR_TEXT][3] = 0;
    return copy;
}

static void unite_bounds(const TinkerGhost *ghost, double box[4])
{
    double other[4];
    tinker_painter_bounds(ghost->from, box);
    tinker_painter_bounds(ghost->to, other);
    tinker_painter_unite(box, other);
}

/* Below what stands in the corner, above the caption. */
static TinkerView choose_view(const GhostPicture *picture, double width, double height)
{
    double box[4], corner[4] = {0}, beneath = picture->ghost->caption != NULL ? CAPTION_ROOM : 0;
    TinkerView view = {.scale = 1, .width = width, .height = height};
    unite_bounds(picture->ghost, box);
    tinker_fields_corner(picture->ghost->to, &view, picture->options, corner);
    double above = fmin(corner[3], height / 3), side = fmin(corner[2], width / 3),
           margin = MARGIN * fmin(width, height);
    TinkerView below = tinker_view_fit(box, width, fmax(height - above - beneath, 1), margin);
    TinkerView right = tinker_view_fit(box, fmax(width - side, 1), fmax(height - beneath, 1), margin);
    gboolean choose_right = right.scale > below.scale;
    view = choose_right ? right : below;
    tinker_view_pan(&view, choose_right ? side : 0, choose_right ? 0 : above);
    view.width = width;
    view.height = height;
    return view;
}

static void draw_arrows(cairo_t *cairo, const GhostPicture *picture, const TinkerView *view)
{
    const TinkerGhost *ghost = picture->ghost;
    TinkerScene *scene = tinker_frame_scene(ghost->to);
    TinkerStyleBrush brush;
    double symbol = tinker_painter_symbol_size(ghost->to, view->scale);
    tinker_style_begin(&brush, cairo, picture->options->theme, view, symbol);
    tinker_style_enter_world(&brush.style, cairo);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        TinkerPiece piece;
        double x, y, angle, to_x, to_y;
        tinker_piece_init(&piece, ghost->to, block);
        if (piece.kind != TINKER_PIECE_BODY) continue;
        tinker_frame_centre(ghost->from, block, &x, &y, &angle);
        tinker_frame_centre(ghost->to, block, &to_x, &to_y, &angle);
        if (hypot(to_x - x, to_y - y) * view->scale < 1) continue;
        brush.style.arrow(&brush.style, cairo, TINKER_COLOUR_MOTION, x, y, to_x, to_y);
    }
    cairo_restore(cairo);
    tinker_style_end(&brush);
}

static void draw_caption(cairo_t *cairo, const GhostPicture *picture, double width, double height)
{
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerText text = {.text = picture->ghost->caption,
                       .size = CAPTION_SIZE,
                       .bold = TRUE,
                       .limit = 0.95 * width,
                       .anchor_x = 0.5,
                       .anchor_y = 0.5};
    const double *colour = picture->options->theme->colours[TINKER_COLOUR_TEXT];
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
    tinker_text_draw(&pen, cairo, &text, width / 2, height - CAPTION_ROOM / 2);
    tinker_text_pen_clear(&pen);
}

static void draw_ghost(cairo_t *cairo, double width, double height, gpointer data)
{
    const GhostPicture *picture = data;
    TinkerView view = choose_view(picture, width, height);
    TinkerPaintOptions options = *picture->options;
    TinkerTheme behind = faded(options.theme), before = *options.theme;
    options.theme = &behind;
    options.show_labels = FALSE;
    tinker_paint_scene(cairo, picture->ghost->from, &view, &options);
    before.background[3] = 0;
    options = *picture->options;
    options.theme = &before;
    options.show_grid = FALSE;
    tinker_paint_scene(cairo, picture->ghost->to, &view, &options);
    if (picture->ghost->arrows) draw_arrows(cairo, picture, &view);
    if (picture->ghost->caption != NULL) draw_caption(cairo, picture, width, height);
}

gboolean tinker_ghost_to_file(const TinkerGhost *ghost, int width, int height, const TinkerPaintOptions *options,
                              const char *path, GError **error)
{
    GhostPicture picture = {ghost, options};
    return tinker_surface_to_file(draw_ghost, &picture, width, height, path, error);
}

/* A picture is background, grid, the blocks layer by layer, marks of the selection, and on top what belongs to the
 * canvas and not to the world: fields, names, title and time. */
#include "render/picture/painter-private.h"

#include <math.h>
#include <string.h>

#include "render/draw/draw-watch.h"
#include "render/draw/paint-memory-content.h"
#include "render/picture/note.h"

#define GRID_UNITS   24.0 /* canvas units between grid lines, at least */
#define CORNER       12.0
#define TITLE_SIZE   15.0
#define TIME_SIZE    13.0
#define HANDLE_UNITS 7.0
#define DOT_UNITS    6.0 /* the size of a body that is smaller on the canvas */
#define MOST_HANDLES 128
#define ORIGIN_ARM   0.8 /* of the symbol size: axes of a local origin */

static void set_colour(cairo_t *cairo, const double colour[4])
{
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
}

/* Background and grid ---------------------------------------------------------------------------------------------- */

static void draw_background(const TinkerPicture *picture)
{
    set_colour(picture->cairo, picture->options->theme->background);
    cairo_rectangle(picture->cairo, 0, 0, picture->view->width, picture->view->height);
    cairo_fill(picture->cairo);
}

/* Every fifth line is darker; which ones those are belongs to the world, not to the view. */
static void draw_grid_lines(const TinkerPicture *picture, double spacing, gboolean fifth)
{
    const TinkerView *view = picture->view;
    double left, top, right, bottom, x, y;
    tinker_view_to_world(view, 0, 0, &left, &top);
    tinker_view_to_world(view, view->width, view->height, &right, &bottom);
    for (double i = ceil(left / spacing); i <= floor(right / spacing); i++) {
        if ((fmod(i, 5) == 0) != fifth) continue;
        tinker_view_to_canvas(view, i * spacing, 0, &x, &y);
        cairo_move_to(picture->cairo, floor(x) + 0.5, 0);
        cairo_line_to(picture->cairo, floor(x) + 0.5, view->height);
    }
    for (double i = ceil(bottom / spacing); i <= floor(top / spacing); i++) {
        if ((fmod(i, 5) == 0) != fifth) continue;
        tinker_view_to_canvas(view, 0, i * spacing, &x, &y);
        cairo_move_to(picture->cairo, 0, floor(y) + 0.5);
        cairo_line_to(picture->cairo, view->width, floor(y) + 0.5);
    }
    cairo_stroke(picture->cairo);
}

static void draw_grid(const TinkerPicture *picture)
{
    const double *grid = picture->options->theme->grid;
    double spacing = tinker_view_grid(picture->view, GRID_UNITS);
    /* So far away that grid lines are no different numbers, there is none. */
    double farthest = fmax(fabs(picture->view->origin_x), fabs(picture->view->origin_y));
    if (!(farthest < 1e12)) return;
    cairo_set_line_width(picture->cairo, 1);
    cairo_set_source_rgba(picture->cairo, grid[0], grid[1], grid[2], 0.55 * grid[3]);
    draw_grid_lines(picture, spacing, FALSE);
    set_colour(picture->cairo, grid);
    draw_grid_lines(picture, spacing, TRUE);
}

/* Blocks ----------------------------------------------------------------------------------------------------------- */

static void mark_selected(TinkerPicture *picture)
{
    const TinkerPaintOptions *options = picture->options;
    picture->id_limit = tinker_scene_id_limit(tinker_frame_scene(picture->frame));
    picture->selected = g_new0(guint8, MAX(picture->id_limit, 1));
    for (int i = 0; i < options->selected_count; i++)
        if (options->selected[i] >= 0 && options->selected[i] < picture->id_limit)
            picture->selected[options->selected[i]] = 1;
}

static gboolean is_visible(const TinkerPicture *picture, const TinkerPiece *piece)
{
    const double *view = picture->brush.style.view;
    double box[4];
    return tinker_piece_box(piece, &picture->brush.style, box) && box[0] <= view[2] && box[2] >= view[0] &&
           box[1] <= view[3] && box[3] >= view[1];
}

static gboolean is_wanted(const TinkerPicture *picture, TinkerBlockId block)
{
    const TinkerBlockId *each = picture->options->only;
    while (each != NULL && *each != TINKER_NO_BLOCK && *each != block)
        each++;
    return each == NULL || *each == block;
}

/* Looks every block up once: what is out of sight is not looked at again. */
static void find_visible(TinkerPicture *picture)
{
    TinkerScene *scene = tinker_frame_scene(picture->frame);
    for (int layer = 0; layer < TINKER_LAYERS; layer++)
        picture->visible[layer] = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    picture->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    picture->connectors = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < picture->block_count; place++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, tinker_scene_block_at(scene, place));
        if (piece.kind == TINKER_PIECE_FIELD || !is_wanted(picture, piece.block) || !is_visible(picture, &piece))
            continue;
        g_array_append_val(picture->visible[tinker_frame_layer(picture->frame, piece.block)], piece.block);
        if (piece.kind != TINKER_PIECE_CONNECTOR)
            g_array_append_val(picture->bodies, piece.block);
        else if (!tinker_block_class_is_shown_elsewhere(piece.block_class))
            g_array_append_val(picture->connectors, piece.block);
    }
}

static void forget_visible(TinkerPicture *picture)
{
    for (int layer = 0; layer < TINKER_LAYERS; layer++)
        g_array_unref(picture->visible[layer]);
    g_array_unref(picture->bodies);
    g_array_unref(picture->connectors);
}

static void draw_layer(TinkerPicture *picture, const GArray *blocks)
{
    TinkerStyle *style = &picture->brush.style;
    for (guint i = 0; i < blocks->len; i++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, g_array_index(blocks, TinkerBlockId, i));
        style->state = tinker_picture_state(picture, &piece);
        tinker_picture_draw_piece(picture, &piece);
    }
    style->state = 0;
}

/* Bodies that would be too small to be seen have a dot beneath them. */
static void draw_dots(TinkerPicture *picture)
{
    TinkerStyle *style = &picture->brush.style;
    const double least = DOT_UNITS * tinker_style_unit(style), margin = 2 * tinker_drawing_margin(style);
    if (tinker_picture_is_crowded(picture)) return;
    for (guint i = 0; i < picture->bodies->len; i++) {
        TinkerPiece piece;
        double box[4];
        tinker_piece_init(&piece, picture->frame, g_array_index(picture->bodies, TinkerBlockId, i));
        if (piece.kind != TINKER_PIECE_BODY || !(fmax(piece.width, piece.height) < least)) continue;
        if (!tinker_piece_box(&piece, style, box) || fmax(box[2] - box[0], box[3] - box[1]) - margin > least) continue;
        style->state = tinker_picture_state(picture, &piece);
        style->circle(style, picture->cairo, TINKER_COLOUR_BODY_EDGE, TINKER_COLOUR_BODY_EDGE, piece.instance.x,
                      piece.instance.y, least / 2);
    }
    style->state = 0;
}

/* Marks of the selection and of local origins ---------------------------------------------------------------------- */

/* Handles change the scene as placed; while it is shown at another time, they would be anywhere. */
static void draw_handles(TinkerPicture *picture)
{
    if (tinker_frame_time(picture->frame) != 0) return;
    const TinkerStyle *style = &picture->brush.style;
    double half = HANDLE_UNITS / 2 * tinker_style_unit(style);
    for (int i = 0; i < picture->options->selected_count; i++) {
        TinkerBlockId block = picture->options->selected[i];
        if (!tinker_scene_has_block(tinker_frame_scene(picture->frame), block)) continue;
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, block);
        if (!piece.block_class || !piece.block_class->edit || !piece.block_class->edit->handles) continue;
        TinkerHandle handles[MOST_HANDLES];
        const TinkerEdit *edit = piece.block_class->edit;
        int32_t count = TINKER_CALL_INSTANCE(piece.block_class, "handles", &piece.instance,
                                             edit->handles(&piece.instance, handles, MOST_HANDLES));
        for (int32_t n = 0; n < MIN(count, MOST_HANDLES); n++)
            style->box(style, picture->cairo, TINKER_COLOUR_SELECTED, TINKER_COLOUR_BODY_EDGE, handles[n].x,
                       handles[n].y, 2 * half, 2 * half, 0);
    }
}

/* Small axes where a body's coordinates are measured from, and the offset from there to its centre. */
static void draw_local_origin(TinkerPicture *picture, const TinkerPiece *piece)
{
    TinkerStyle *style = &picture->brush.style;
    int32_t column = tinker_block_class_meaning_column(piece->block_class, TINKER_MEANING_LOCAL_ORIGIN);
    if (column < 0) return;
    double x = piece->instance.columns[column], y = piece->instance.columns[column + 1];
    double arm = ORIGIN_ARM * style->symbol_size;
    /* The dashed line of the offset is drawn as what is detached is: grey. */
    style->state = TINKER_STATE_DETACHED;
    if (hypot(piece->instance.x - x, piece->instance.y - y) > 1e-9)
        style->line(style, picture->cairo, TINKER_COLOUR_DETACHED, x, y, piece->instance.x, piece->instance.y);
    style->state = 0;
    style->line(style, picture->cairo, TINKER_COLOUR_BODY_EDGE, x, y, x + arm, y);
    style->line(style, picture->cairo, TINKER_COLOUR_BODY_EDGE, x, y, x, y + arm);
}

static void draw_local_origins(TinkerPicture *picture)
{
    TinkerScene *scene = tinker_frame_scene(picture->frame);
    for (int32_t place = 0; place < picture->block_count; place++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, tinker_scene_block_at(scene, place));
        if (piece.kind == TINKER_PIECE_BODY) draw_local_origin(picture, &piece);
    }
}

/* The canvas's own
 * ----------------------------------------------------------------------------------------------------- */

/* Writes a text and answers the box it takes. */
static void write_text(TinkerPicture *picture, const TinkerText *text, double x, double y, double box[4])
{
    double width, height;
    tinker_text_measure(&picture->brush.pen, text, &width, &height);
    box[0] = x - text->anchor_x * width;
    box[1] = y - text->anchor_y * height;
    box[2] = box[0] + width;
    box[3] = box[1] + height;
    set_colour(picture->cairo, picture->options->theme->colours[TINKER_COLOUR_TEXT]);
    tinker_text_draw(&picture->brush.pen, picture->cairo, text, x, y);
}

TinkerText tinker_picture_title(TinkerFrame *frame, double width, double left)
{
    const char *title = tinker_scene_head(tinker_frame_scene(frame))->title;
    double room = width - 2 * fmax(left + CORNER, CORNER);
    return (TinkerText){
        .text = title, .size = TITLE_SIZE, .bold = TRUE, .limit = fmax(room, width / 4), .lines = 2, .anchor_x = 0.5};
}

static void draw_time(TinkerPicture *picture, double box[4])
{
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(number, sizeof number, "%.2f", tinker_frame_time(picture->frame));
    g_autoptr(GString) words = g_string_new("t = ");
    tinker_text_append_number(words, number);
    g_string_append(words, " s");
    const gboolean at_right = picture->options->over != NULL; /* the left corner is for the key */
    const double x = at_right ? picture->view->width - CORNER : CORNER;
    TinkerText text = {.text = words->str, .size = TIME_SIZE, .anchor_x = at_right, .anchor_y = 1, .passing = TRUE};
    write_text(picture, &text, x, picture->view->height - CORNER, box);
}

/* What belongs to the canvas: fields, title and time, then names where there is room beside them. */
static void draw_canvas(TinkerPicture *picture)
{
    const guint panels = picture->panels;
    g_autofree double(*taken)[4] = g_malloc0((panels + 3) * sizeof *taken);
    const double width = picture->view->width;
    for (guint i = 0; i < panels; i++)
        memcpy(taken[3 + i], ((TinkerWrittenText *)g_ptr_array_index(picture->options->texts, i))->box, sizeof *taken);
    if (picture->options->only == NULL) tinker_picture_draw_fields(picture, taken[0]);
    TinkerText title = tinker_picture_title(picture->frame, width, taken[0][2]);
    if (picture->options->show_title) write_text(picture, &title, width / 2, CORNER, taken[1]);
    if (picture->options->show_time) draw_time(picture, taken[2]);
    if (picture->options->show_labels) tinker_picture_draw_labels(picture, taken, (int)panels + 3);
}

static void draw_world(TinkerPicture *picture)
{
    tinker_style_enter_world(&picture->brush.style, picture->cairo);
    draw_dots(picture);
    for (int layer = 0; layer < TINKER_LAYERS; layer++)
        draw_layer(picture, picture->visible[layer]);
    if (picture->options->show_local_origins) draw_local_origins(picture);
    draw_handles(picture);
    cairo_restore(picture->cairo);
}

void tinker_paint_scene_noting(cairo_t *cairo, TinkerFrame *frame, const TinkerView *view,
                               const TinkerPaintOptions *options, GPtrArray *written)
{
    TinkerPicture picture = {.caller = cairo, .frame = frame, .view = view, .options = options};
    picture.block_count = tinker_scene_block_count(tinker_frame_scene(frame));
    picture.panels = options->texts != NULL ? options->texts->len : 0;
    double symbol = tinker_painter_symbol_size(frame, view->scale);
    tinker_frame_set_symbol_size(frame, symbol);
    tinker_style_begin(&picture.brush, cairo, options->theme, view, symbol);
    picture.brush.style.note = tinker_note_draw;
    picture.brush.pen.written = written != NULL ? written : options->texts;
    picture.brush.pen.memory = tinker_paint_memory_texts(options->memory);
    /* what is drawn on our own contexts, the ones made anew, too, goes by the caller's */
    const cairo_antialias_t antialias = cairo_get_antialias(cairo);
    if (options->quick || tinker_style_is_tiny(&picture.brush.style)) cairo_set_antialias(cairo, CAIRO_ANTIALIAS_FAST);
    picture.cairo = tinker_context_new(cairo);
    mark_selected(&picture);
    find_visible(&picture);
    draw_background(&picture);
    if (options->show_grid) draw_grid(&picture);
    if (options->under != NULL) options->under(picture.cairo, view, options->theme, options->over_data);
    draw_world(&picture);
    draw_canvas(&picture);
    if (options->over != NULL) options->over(picture.cairo, view, options->theme, options->over_data);
    cairo_destroy(picture.cairo);
    cairo_set_antialias(cairo, antialias);
    forget_visible(&picture);
    g_free(picture.selected);
    tinker_style_end(&picture.brush);
}

double tinker_painter_symbol_size(TinkerFrame *frame, double scale)
{
    return tinker_style_symbol(scale, tinker_frame_typical_size(frame));
}

void tinker_paint_scene(cairo_t *cairo, TinkerFrame *frame, const TinkerView *view, const TinkerPaintOptions *options)
{
    tinker_paint_scene_noting(cairo, frame, view, options, NULL);
}

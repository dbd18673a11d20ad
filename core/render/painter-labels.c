/* Names beside bodies. The map of what is drawn is filled from the pieces' geometry; a name tries places around its body,
 * near ones first, and takes the one that covers least. A name that would cover another name is left out, unless its
 * block is selected. */
#include "render/painter-private.h"

#include <math.h>

#include <tinker/shapes.h>

#include "render/occupancy-private.h"

#define CELL          4.0 /* canvas units */
#define GAP           5.0 /* between a body and its name */
#define MOST_LABELS   300
#define LEAST_SYMBOL  5.0 /* canvas units: in a scene drawn smaller, names are left out */
#define NAME_LIMIT    160.0
#define FARTHEST_STEP 3
#define KEEPS         1.0 /* what a name may cover of a drawing before it leaves its place in a film */

typedef struct {
    TinkerPicture *picture;
    TinkerOccupancy map;
    int written;
} Labels;

/* Half the declared box of a drawing, canvas units, without the room for marks that declared boxes have. */
static void half_box(const Labels *labels, const TinkerPiece *piece, double *half_x, double *half_y)
{
    const TinkerStyle *style = &labels->picture->brush.style;
    double box[4], scale = labels->picture->view->scale;
    *half_x = *half_y = INFINITY;
    if (!tinker_piece_box(piece, style, box)) return;
    double margin = tinker_drawing_margin(style), least = style->symbol_size / 2;
    *half_x = fmax((box[2] - box[0]) / 2 - margin, least) * scale;
    *half_y = fmax((box[3] - box[1]) / 2 - margin, least) * scale;
}

/* Whether the drawing is far smaller than the declared size of its body (a support that is a mere anchor). */
static gboolean is_drawn_small(const Labels *labels, const TinkerPiece *piece)
{
    double half_x, half_y;
    half_box(labels, piece, &half_x, &half_y);
    return fmax(half_x, half_y) < 0.3 * fmax(piece->width, piece->height) * labels->picture->view->scale;
}

/* Takes the strip of a body along its longer side, a connector's along its line, any other drawing's box. */
static void take_piece(Labels *labels, const TinkerPiece *piece)
{
    const TinkerView *view = labels->picture->view;
    const TinkerInstance *instance = &piece->instance;
    double x1, y1, x2, y2, symbol = labels->picture->brush.style.symbol_size * view->scale;
    if (piece->kind == TINKER_PIECE_CONNECTOR && instance->ends >= 2) {
        for (int32_t i = 1; i < instance->ends; i++) {
            tinker_view_to_canvas(view, instance->end[i - 1].x, instance->end[i - 1].y, &x1, &y1);
            tinker_view_to_canvas(view, instance->end[i].x, instance->end[i].y, &x2, &y2);
            tinker_occupancy_take_line(&labels->map, x1, y1, x2, y2, symbol, TINKER_TAKEN_BY_DRAWING);
        }
    } else if (piece->kind == TINKER_PIECE_BODY && fmax(piece->width, piece->height) > 0 &&
               !is_drawn_small(labels, piece)) {
        gboolean wide = piece->width >= piece->height;
        double angle = instance->orientation + (wide ? 0 : G_PI / 2);
        double thin = fmin(piece->width, piece->height) * view->scale + symbol / 2;
        double half = fmax(fmax(piece->width, piece->height) * view->scale - thin, 0) / 2;
        tinker_view_to_canvas(view, instance->x, instance->y, &x1, &y1);
        double dx = half * cos(angle), dy = -half * sin(angle);
        tinker_occupancy_take_line(&labels->map, x1 - dx, y1 - dy, x1 + dx, y1 + dy, thin, TINKER_TAKEN_BY_DRAWING);
    } else {
        double box[4];
        if (!tinker_piece_box(piece, &labels->picture->brush.style, box)) return;
        tinker_view_to_canvas(view, box[0], box[3], &x1, &y1);
        tinker_view_to_canvas(view, box[2], box[1], &x2, &y2);
        tinker_occupancy_take_box(&labels->map, (double[]){x1, y1, x2, y2}, TINKER_TAKEN_BY_DRAWING);
    }
}

/* How far it is from a body's centre to its edge in this direction of the canvas. */
static double reach_of(const Labels *labels, const TinkerPiece *piece, double direction)
{
    double scale = labels->picture->view->scale;
    double half_width = piece->width * scale / 2, half_height = piece->height * scale / 2;
    double dot = 0.5 * labels->picture->brush.style.symbol_size * scale;
    /* y is down on the canvas: a turn to the left is negative. */
    double angle = direction + piece->instance.orientation;
    double c = fabs(cos(angle)), s = fabs(sin(angle));
    double reach = fmin(c > 1e-9 ? half_width / c : INFINITY, s > 1e-9 ? half_height / s : INFINITY);
    if (is_drawn_small(labels, piece)) {
        half_box(labels, piece, &half_width, &half_height);
        reach = fmax(half_width, half_height);
    }
    return fmax(isfinite(reach) ? reach : 0, dot);
}

/* The place, number `i` of 8 around the body and a step outwards: the name's box, and the cost of its being there. */
static double place_cost(const Labels *labels, const TinkerPiece *piece, int i, int step, double width, double height,
                         double box[4])
{
    /* Above, below, right, left, then the corners; y down. */
    static const double directions[8][2] = {{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    double across = directions[i][0], down = directions[i][1];
    double x, y, reach = reach_of(labels, piece, atan2(down, across)) + GAP + 2.5 * GAP * step;
    double norm = hypot(across, down);
    tinker_view_to_canvas(labels->picture->view, piece->instance.x, piece->instance.y, &x, &y);
    x += across / norm * reach;
    y += down / norm * reach;
    box[0] = x + (across - 1) / 2 * width;
    box[1] = y + (down - 1) / 2 * height;
    box[2] = box[0] + width;
    box[3] = box[1] + height;
    double drawing = tinker_occupancy_share(&labels->map, box, TINKER_TAKEN_BY_DRAWING);
    double text = tinker_occupancy_share(&labels->map, box, TINKER_TAKEN_BY_TEXT);
    return 10 * text + drawing + 0.001 * i + 0.01 * step;
}

static void write_name(Labels *labels, const TinkerPiece *piece, gboolean wanted)
{
    TinkerPicture *picture = labels->picture;
    TinkerText name = {.text = tinker_scene_block_name(tinker_frame_scene(picture->frame), piece->block),
                       .size = TINKER_STYLE_TEXT,
                       .limit = NAME_LIMIT};
    double width, height, best[4] = {0}, least = INFINITY;
    signed char *kept = picture->options->label_places, chosen = 0;
    tinker_text_measure(&picture->brush.pen, &name, &width, &height);
    for (int step = 0; step <= FARTHEST_STEP; step++)
        for (int i = 0; i < 8; i++) {
            signed char number = (signed char)(1 + i + 8 * step);
            double box[4], cost = place_cost(labels, piece, i, step, width, height, box);
            if (kept != NULL && kept[piece->block] == number) cost -= KEEPS;
            if (cost >= least) continue;
            least = cost;
            chosen = number;
            for (int side = 0; side < 4; side++)
                best[side] = box[side];
        }
    if (kept != NULL) kept[piece->block] = chosen;
    gboolean covers_text = tinker_occupancy_share(&labels->map, best, TINKER_TAKEN_BY_TEXT) > 0;
    if (covers_text && !wanted) return;
    if (tinker_occupancy_share(&labels->map, best, TINKER_TAKEN_BY_DRAWING) > 0) {
        const double *ground = picture->options->theme->background;
        cairo_set_source_rgba(picture->cairo, ground[0], ground[1], ground[2], 0.75);
        cairo_rectangle(picture->cairo, best[0] - 2, best[1], width + 4, height);
        cairo_fill(picture->cairo);
    }
    const double *c = picture->options->theme->colours[TINKER_COLOUR_TEXT];
    cairo_set_source_rgba(picture->cairo, c[0], c[1], c[2], c[3]);
    tinker_text_draw(&picture->brush.pen, picture->cairo, &name, best[0], best[1]);
    tinker_occupancy_take_box(&labels->map, best, TINKER_TAKEN_BY_TEXT);
    labels->written++;
}

/* Names of the chosen blocks come first, then all others. */
static void write_names(Labels *labels, gboolean chosen)
{
    TinkerPicture *picture = labels->picture;
    TinkerScene *scene = tinker_frame_scene(picture->frame);
    for (int32_t place = 0; place < picture->block_count && labels->written < MOST_LABELS; place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, block);
        if (piece.kind != TINKER_PIECE_BODY && piece.kind != TINKER_PIECE_UNKNOWN) continue;
        if ((tinker_picture_state(picture, &piece) != 0) != chosen) continue;
        double x, y;
        tinker_view_to_canvas(picture->view, piece.instance.x, piece.instance.y, &x, &y);
        if (x >= 0 && y >= 0 && x <= picture->view->width && y <= picture->view->height)
            write_name(labels, &piece, chosen);
    }
}

void tinker_picture_draw_labels(TinkerPicture *picture, double (*taken)[4], int taken_count)
{
    const TinkerView *view = picture->view;
    gboolean small = picture->brush.style.symbol_size * view->scale < LEAST_SYMBOL;
    if (small && picture->options->selected_count == 0) return;
    Labels labels = {.picture = picture};
    TinkerScene *scene = tinker_frame_scene(picture->frame);
    tinker_occupancy_init(&labels.map, 0, 0, view->width, view->height, CELL);
    for (int i = 0; i < taken_count; i++)
        tinker_occupancy_take_box(&labels.map, taken[i], TINKER_TAKEN_BY_TEXT);
    for (int32_t place = 0; place < picture->block_count; place++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, tinker_scene_block_at(scene, place));
        if (piece.kind != TINKER_PIECE_FIELD) take_piece(&labels, &piece);
    }
    write_names(&labels, TRUE);
    if (!small) write_names(&labels, FALSE);
    tinker_occupancy_clear(&labels.map);
}

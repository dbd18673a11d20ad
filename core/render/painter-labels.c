/* Names beside bodies. The map of what is drawn is filled from the pieces' geometry; a name tries places around its body,
 * near ones first, and takes the one that covers least. A name that would cover another name is left out, unless its
 * block is selected. */
#include "render/painter-private.h"

#include <math.h>
#include <string.h>

#include <tinker/shapes.h>

#include "render/occupancy-private.h"
#include "render/paint-memory-private.h"

#define CELL         4.0    /* canvas units */
#define GAP          5.0    /* between a body and its name */
#define LABEL_ROOM   3000.0 /* square canvas units for each body in sight: where there is less, names would cover all */
#define LEAST_SYMBOL 5.0    /* canvas units: in a scene drawn smaller, */
#define FEW          12     /* bodies have names, but no more than these */
#define NAME_LIMIT   160.0
#define DIRECTIONS   8
#define PLACES       (4 * DIRECTIONS) /* a name tries: four steps outwards in each direction */
#define KEEPS        1.0              /* what a name may cover of a drawing before it leaves its place in a film */

typedef struct {
    TinkerPicture *picture;
    TinkerOccupancy map;
    signed char *places; /* by block id: 1 + the place in the picture before; or NULL */
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

/* A body whose name is being placed: what is the same for all its places. */
typedef struct {
    const TinkerPiece *piece;
    double x, y;                    /* canvas units */
    double half_width, half_height; /* canvas units, of the body or of its drawing */
    double round;                   /* the drawing is far smaller than the body: its reach in any direction; else 0 */
    double dot;                     /* reach in any direction, at least */
    double name_width, name_height;
} Named;

static Named named_of(const Labels *labels, const TinkerPiece *piece)
{
    double scale = labels->picture->view->scale, half_x, half_y;
    Named named = {.piece = piece,
                   .half_width = piece->width * scale / 2,
                   .half_height = piece->height * scale / 2,
                   .dot = 0.5 * labels->picture->brush.style.symbol_size * scale};
    tinker_view_to_canvas(labels->picture->view, piece->instance.x, piece->instance.y, &named.x, &named.y);
    if (is_drawn_small(labels, piece)) {
        half_box(labels, piece, &half_x, &half_y);
        named.round = fmax(half_x, half_y);
    }
    return named;
}

/* How far it is from a body's centre to its edge in this direction of the canvas. */
static double reach_of(const Named *named, double direction)
{
    /* y is down on the canvas: a turn to the left is negative. */
    double angle = direction + named->piece->instance.orientation;
    double c = fabs(cos(angle)), s = fabs(sin(angle));
    double reach = fmin(c > 1e-9 ? named->half_width / c : INFINITY, s > 1e-9 ? named->half_height / s : INFINITY);
    if (named->round > 0) reach = named->round;
    return fmax(isfinite(reach) ? reach : 0, named->dot);
}

/* What a place costs where nothing is in the way: near ones are better, and above is better than below. */
static double free_cost(int number)
{
    return 0.001 * (number % DIRECTIONS) + 0.01 * (number / DIRECTIONS);
}

/* A place, number `number % DIRECTIONS` around the body and some steps outwards: the name's box, and the cost of its being
 * there. */
static double place_cost(const Labels *labels, const Named *named, int number, double box[4])
{
    /* Above, below, right, left, then the corners; y down. */
    static const double directions[DIRECTIONS][2] = {{0, -1}, {0, 1},   {1, 0}, {-1, 0},
                                                     {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    double across = directions[number % DIRECTIONS][0], down = directions[number % DIRECTIONS][1];
    double step = number / DIRECTIONS, norm = hypot(across, down);
    double reach = reach_of(named, atan2(down, across)) + GAP + 2.5 * GAP * step;
    box[0] = named->x + across / norm * reach + (across - 1) / 2 * named->name_width;
    box[1] = named->y + down / norm * reach + (down - 1) / 2 * named->name_height;
    box[2] = box[0] + named->name_width;
    box[3] = box[1] + named->name_height;
    double drawing = tinker_occupancy_share(&labels->map, box, TINKER_TAKEN_BY_DRAWING);
    double text = tinker_occupancy_share(&labels->map, box, TINKER_TAKEN_BY_TEXT);
    return 10 * text + drawing + free_cost(number);
}

/* The cheapest place; the one of the picture before, `kept`, stays unless something has come into its way. */
static int choose_place(const Labels *labels, const Named *named, int kept, double best[4])
{
    int chosen = 0;
    double least = INFINITY;
    if (kept >= 0) {
        least = place_cost(labels, named, kept, best) - KEEPS;
        chosen = kept;
    }
    /* What follows costs more than a place that is free. */
    for (int number = 0; number < PLACES && least > free_cost(number); number++) {
        double box[4];
        if (number == kept) continue;
        double cost = place_cost(labels, named, number, box);
        if (cost >= least) continue;
        least = cost;
        chosen = number;
        memcpy(best, box, sizeof box);
    }
    return chosen;
}

static void write_name(Labels *labels, const TinkerPiece *piece, gboolean wanted)
{
    TinkerPicture *picture = labels->picture;
    TinkerText name = {.text = tinker_scene_block_name(tinker_frame_scene(picture->frame), piece->block),
                       .size = TINKER_STYLE_TEXT,
                       .limit = NAME_LIMIT};
    Named named = named_of(labels, piece);
    double best[4];
    signed char *kept = labels->places;
    tinker_text_measure(&picture->brush.pen, &name, &named.name_width, &named.name_height);
    int chosen = choose_place(labels, &named, kept != NULL ? kept[piece->block] - 1 : -1, best);
    if (kept != NULL) kept[piece->block] = (signed char)(1 + chosen);
    gboolean covers_text = tinker_occupancy_share(&labels->map, best, TINKER_TAKEN_BY_TEXT) > 0;
    if (covers_text && !wanted) return;
    if (tinker_occupancy_share(&labels->map, best, TINKER_TAKEN_BY_DRAWING) > 0) {
        const double *ground = picture->options->theme->background;
        cairo_set_source_rgba(picture->cairo, ground[0], ground[1], ground[2], 0.75);
        cairo_rectangle(picture->cairo, best[0] - 2, best[1], named.name_width + 4, named.name_height);
        cairo_fill(picture->cairo);
    }
    const double *c = picture->options->theme->colours[TINKER_COLOUR_TEXT];
    cairo_set_source_rgba(picture->cairo, c[0], c[1], c[2], c[3]);
    tinker_text_draw(&picture->brush.pen, picture->cairo, &name, best[0], best[1]);
    tinker_occupancy_take_box(&labels->map, best, TINKER_TAKEN_BY_TEXT);
}

static void take_layer(Labels *labels, const GArray *blocks)
{
    for (guint i = 0; i < blocks->len; i++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, labels->picture->frame, g_array_index(blocks, TinkerBlockId, i));
        take_piece(labels, &piece);
    }
}

/* Names of the chosen blocks come first, then all others. */
static void write_names(Labels *labels, gboolean chosen)
{
    TinkerPicture *picture = labels->picture;
    const TinkerPaintOptions *options = picture->options;
    if (chosen && options->selected_count == 0 && options->highlighted == TINKER_NO_BLOCK) return;
    for (guint i = 0; i < picture->bodies->len; i++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, g_array_index(picture->bodies, TinkerBlockId, i));
        if ((tinker_picture_state(picture, &piece) != 0) != chosen) continue;
        double x, y;
        tinker_view_to_canvas(picture->view, piece.instance.x, piece.instance.y, &x, &y);
        if (x >= 0 && y >= 0 && x <= picture->view->width && y <= picture->view->height)
            write_name(labels, &piece, chosen);
    }
}

gboolean tinker_picture_is_crowded(const TinkerPicture *picture)
{
    return picture->bodies->len * LABEL_ROOM > picture->view->width * picture->view->height;
}

void tinker_picture_draw_labels(TinkerPicture *picture, double (*taken)[4], int taken_count)
{
    const TinkerView *view = picture->view;
    gboolean small = picture->brush.style.symbol_size * view->scale < LEAST_SYMBOL;
    gboolean crowded = tinker_picture_is_crowded(picture) || (small && picture->bodies->len > FEW);
    if (crowded && picture->options->selected_count == 0) return;
    TinkerScene *scene = tinker_frame_scene(picture->frame);
    Labels labels = {.picture = picture};
    labels.places = tinker_paint_memory_places(picture->options->memory, tinker_scene_id_limit(scene));
    tinker_occupancy_init(&labels.map, 0, 0, view->width, view->height, CELL);
    for (int i = 0; i < taken_count; i++)
        tinker_occupancy_take_box(&labels.map, taken[i], TINKER_TAKEN_BY_TEXT);
    for (int layer = 0; layer < TINKER_PICTURE_LAYERS; layer++)
        take_layer(&labels, picture->visible[layer]);
    write_names(&labels, TRUE);
    if (!crowded) write_names(&labels, FALSE);
    tinker_occupancy_clear(&labels.map);
}

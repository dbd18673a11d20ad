/* A body has places in eight directions, four steps outwards each, and farther ones with a line that leads to it; a
 * connector on both sides of its longest piece, in the middle of it and a third from either end; one with a single end
 * in the eight directions, close by. */
#include "render/picture/label-places-private.h"

#include <math.h>
#include <string.h>

#include <tinker/shapes.h>

#define GAP         5.0 /* canvas units between a drawing and its name */
#define STEP        (2.5 * GAP)
#define DIRECTIONS  8
#define BODY_STEPS  4
#define FAR_STEPS   6 /* behind those, each as long as two */
#define LINE_PARTS  3 /* points along a connector, */
#define LINE_PLACES (2 * LINE_PARTS)
#define LINE_STEPS  2
#define CLEAR       6.0 /* canvas units on each side of the name of a connector */

/* Half the declared box of a drawing, canvas units, without the room for marks that declared boxes have. */
static void half_box(const TinkerPicture *picture, const TinkerPiece *piece, double *half_x, double *half_y)
{
    const TinkerStyle *style = &picture->brush.style;
    double box[4], scale = picture->view->scale;
    *half_x = *half_y = INFINITY;
    if (!tinker_piece_box(piece, style, box)) return;
    double margin = tinker_drawing_margin(style), least = style->symbol_size / 2;
    *half_x = fmax((box[2] - box[0]) / 2 - margin, least) * scale;
    *half_y = fmax((box[3] - box[1]) / 2 - margin, least) * scale;
}

gboolean tinker_piece_is_drawn_small(const TinkerPicture *picture, const TinkerPiece *piece)
{
    double half_x, half_y;
    half_box(picture, piece, &half_x, &half_y);
    return fmax(half_x, half_y) < 0.3 * fmax(piece->width, piece->height) * picture->view->scale;
}

/* What declares neither width nor height, as a disc or a plate, is as large as its drawing. FALSE where there is none.
 */
static gboolean init_drawing(TinkerNamed *named, const TinkerPicture *picture, const TinkerPiece *piece)
{
    double box[4];
    if (!tinker_piece_box(piece, &picture->brush.style, box)) return FALSE;
    tinker_view_to_canvas(picture->view, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2, &named->x, &named->y);
    half_box(picture, piece, &named->half_width, &named->half_height);
    return TRUE;
}

static void init_body(TinkerNamed *named, const TinkerPicture *picture, const TinkerPiece *piece)
{
    if (fmax(piece->width, piece->height) <= 0 && init_drawing(named, picture, piece)) return;
    double scale = picture->view->scale, half_x, half_y;
    named->half_width = piece->width * scale / 2;
    named->half_height = piece->height * scale / 2;
    named->orientation = piece->instance.orientation;
    tinker_view_to_canvas(picture->view, piece->instance.x, piece->instance.y, &named->x, &named->y);
    if (!tinker_piece_is_drawn_small(picture, piece)) return;
    half_box(picture, piece, &half_x, &half_y);
    named->round = fmax(half_x, half_y);
}

static double length_of(const double line[4])
{
    return hypot(line[2] - line[0], line[3] - line[1]);
}

/* The longest piece between two ends of a connector. */
static void init_line(TinkerNamed *named, const TinkerPicture *picture, const TinkerPiece *piece)
{
    const TinkerInstance *instance = &piece->instance;
    named->is_line = TRUE;
    named->thickness = picture->brush.style.symbol_size * picture->view->scale;
    for (int32_t i = 1; i < instance->ends; i++) {
        double line[4];
        tinker_view_to_canvas(picture->view, instance->end[i - 1].x, instance->end[i - 1].y, &line[0], &line[1]);
        tinker_view_to_canvas(picture->view, instance->end[i].x, instance->end[i].y, &line[2], &line[3]);
        if (length_of(line) > length_of(named->line)) memcpy(named->line, line, sizeof line);
    }
}

gboolean tinker_named_init(TinkerNamed *named, const TinkerPicture *picture, const TinkerPiece *piece)
{
    *named = (TinkerNamed){.is_connector = piece->kind == TINKER_PIECE_CONNECTOR,
                           .dot = 0.5 * picture->brush.style.symbol_size * picture->view->scale};
    if (!named->is_connector) {
        init_body(named, picture, piece);
        return TRUE;
    }
    if (piece->instance.ends >= 2) {
        init_line(named, picture, piece);
        return isfinite(length_of(named->line));
    }
    double box[4];
    if (!tinker_piece_box(piece, &picture->brush.style, box)) return FALSE;
    tinker_view_to_canvas(picture->view, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2, &named->x, &named->y);
    named->half_width = (box[2] - box[0]) / 2 * picture->view->scale;
    named->half_height = (box[3] - box[1]) / 2 * picture->view->scale;
    return TRUE;
}

int tinker_named_places(const TinkerNamed *named)
{
    if (!named->is_line) return (named->is_connector ? 1 : BODY_STEPS + FAR_STEPS) * DIRECTIONS;
    return length_of(named->line) >= named->name_width ? LINE_STEPS * LINE_PLACES : 0;
}

double tinker_named_free_cost(const TinkerNamed *named, int number)
{
    int round = named->is_line ? LINE_PLACES : DIRECTIONS;
    return 0.001 * (number % round) + 0.01 * (number / round);
}

gboolean tinker_named_is_far(const TinkerNamed *named, int number)
{
    return !named->is_connector && number / DIRECTIONS >= BODY_STEPS;
}

/* How far it is from a body's centre to its edge in this direction of the canvas. */
static double reach_of(const TinkerNamed *named, double direction)
{
    /* y is down on the canvas: a turn to the left is negative. */
    double angle = direction + named->orientation;
    double c = fabs(cos(angle)), s = fabs(sin(angle));
    double reach = fmin(c > 1e-9 ? named->half_width / c : INFINITY, s > 1e-9 ? named->half_height / s : INFINITY);
    if (named->round > 0) reach = named->round;
    return fmax(isfinite(reach) ? reach : 0, named->dot);
}

/* Place `number % DIRECTIONS` around the body, some steps outwards. */
static void place_beside_body(const TinkerNamed *named, int number, double box[4])
{
    /* Above, below, right, left, then the corners; y down. */
    static const double directions[DIRECTIONS][2] = {{0, -1}, {0, 1},   {1, 0}, {-1, 0},
                                                     {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    double across = directions[number % DIRECTIONS][0], down = directions[number % DIRECTIONS][1];
    double norm = hypot(across, down);
    const int steps = number / DIRECTIONS + MAX(number / DIRECTIONS - BODY_STEPS + 1, 0);
    double reach = reach_of(named, atan2(down, across)) + GAP + STEP * steps;
    box[0] = named->x + across / norm * reach + (across - 1) / 2 * named->name_width;
    box[1] = named->y + down / norm * reach + (down - 1) / 2 * named->name_height;
}

void tinker_named_leader(const TinkerNamed *named, const double box[4], double line[4])
{
    line[2] = CLAMP(named->x, box[0], box[2]);
    line[3] = CLAMP(named->y, box[1], box[3]);
    const double x = line[2] - named->x, y = line[3] - named->y, length = fmax(hypot(x, y), 1e-9);
    const double reach = fmin(reach_of(named, atan2(y, x)), length);
    line[0] = named->x + x / length * reach;
    line[1] = named->y + y / length * reach;
}

/* Across the connector, to the side that a place is on: of two that follow each other the first is above it (to the
 * right of one that is upright), the other beneath. */
static void side_of(const TinkerNamed *named, int number, double *across, double *down)
{
    const double *line = named->line;
    double length = length_of(line), x = (line[3] - line[1]) / length, y = (line[0] - line[2]) / length;
    gboolean is_above = y < -1e-9 || (fabs(y) <= 1e-9 && x > 0);
    double side = is_above == (number % 2 == 0) ? 1 : -1;
    *across = side * x;
    *down = side * y;
}

/* The strip of a connector is taken in boxes, which reach out farther where the line is oblique; and so does the name.
 */
static void place_along_line(const TinkerNamed *named, int number, double box[4])
{
    static const double parts[LINE_PARTS] = {1.0 / 2, 1.0 / 3, 2.0 / 3};
    const double *line = named->line;
    double across, down, part = parts[number % LINE_PLACES / 2];
    side_of(named, number, &across, &down);
    double reach = (named->thickness + named->name_width) / 2 * fabs(across) +
                   (named->thickness + named->name_height) / 2 * fabs(down) + GAP + STEP * (number / LINE_PLACES);
    box[0] = line[0] + part * (line[2] - line[0]) + across * reach - named->name_width / 2;
    box[1] = line[1] + part * (line[3] - line[1]) + down * reach - named->name_height / 2;
}

void tinker_named_place(const TinkerNamed *named, int number, double box[4])
{
    if (named->is_line)
        place_along_line(named, number, box);
    else
        place_beside_body(named, number, box);
    box[2] = box[0] + named->name_width;
    box[3] = box[1] + named->name_height;
}

/* The name's box, larger by CLEAR on all sides, and so much farther out that it is no nearer to its own connector. */
void tinker_named_clearance(const TinkerNamed *named, int number, double box[4])
{
    double across, down;
    tinker_named_place(named, number, box);
    if (!named->is_line) return;
    side_of(named, number, &across, &down);
    double out = CLEAR * (fabs(across) + fabs(down));
    for (int i = 0; i < 4; i++)
        box[i] += out * (i % 2 ? down : across) + (i < 2 ? -CLEAR : CLEAR);
}

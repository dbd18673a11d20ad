/* Names beside bodies and connectors. The map of what is drawn is filled from the pieces' geometry; a name tries the
 * places of its block, near ones first, and takes the one that covers least. A body's name that would cover another
 * name, or much of a drawing, is left out, unless its block is selected; bodies come first, since springs and rods are
 * told by what they join. A connector's is left out where it would cover anything, and that of one with a single end,
 * whose arrow mostly lies upon other symbols, unless it is selected. */
#include <math.h>
#include <string.h>

#include "render/draw/occupancy.h"
#include "render/draw/paint-memory-content.h"
#include "render/picture/label-places-private.h"

#define CELL            4.0    /* canvas units */
#define LABEL_ROOM      3000.0 /* square canvas units for each name in sight: where there is less, names would cover all */
#define ALL_ROOM        3 /* times that for each name where connectors have theirs, too: nets would be full of names */
#define LEAST_SYMBOL    5.0 /* canvas units: in a scene drawn smaller, */
#define FEW             12  /* bodies have names, but no more than these */
#define NAME_LIMIT      160.0
#define LEADER          0.75 /* width of the line to a name that is far off, */
#define CROSSES         5.0  /* and what it costs that it goes through another name, or beneath a panel */
#define KEEPS           1.0  /* what a name may cover of a drawing before it leaves its place in a film */
#define COVERS          0.25 /* and the most that one covers of drawings in a place that is new to it */
#define KEEPS_CONNECTOR 0.3  /* and that of a connector, before it is left out */

typedef struct {
    TinkerPicture *picture;
    TinkerOccupancy map;
    signed char *places; /* by block id: 1 + the place in the picture before; or NULL */
} Labels;

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
               !tinker_piece_is_drawn_small(labels->picture, piece)) {
        gboolean wide = piece->width >= piece->height;
        double angle = instance->orientation + (wide ? 0 : G_PI / 2);
        double thin = fmin(piece->width, piece->height) * view->scale + symbol / 2;
        double half = fmax(fmax(piece->width, piece->height) * view->scale - thin, 0) / 2;
        tinker_view_to_canvas(view, instance->x, instance->y, &x1, &y1);
        double dx = half * cos(angle), dy = -half * sin(angle);
        tinker_occupancy_take_line(&labels->map, x1 - dx, y1 - dy, x1 + dx, y1 + dy, thin, TINKER_TAKEN_BY_DRAWING);
    } else {
        const TinkerStyle *style = &labels->picture->brush.style;
        const gboolean is_body = piece->kind == TINKER_PIECE_BODY && fmax(piece->width, piece->height) <= 0;
        const double margin = is_body ? tinker_drawing_margin(style) : 0; /* room for marks, of which it has none */
        double box[4];
        if (!tinker_piece_box(piece, style, box)) return;
        if (fmin(box[2] - box[0], box[3] - box[1]) > 2 * margin)
            for (int side = 0; side < 4; side++)
                box[side] += side < 2 ? margin : -margin;
        tinker_view_to_canvas(view, box[0], box[3], &x1, &y1);
        tinker_view_to_canvas(view, box[2], box[1], &x2, &y2);
        tinker_occupancy_take_box(&labels->map, (double[]){x1, y1, x2, y2}, TINKER_TAKEN_BY_DRAWING);
    }
}

/* How much of a drawing the name covers in a place, and whose box that is. */
static double covered_by(const Labels *labels, const TinkerNamed *named, int number, double box[4])
{
    double clear[4];
    tinker_named_place(named, number, box);
    tinker_named_clearance(named, number, clear);
    return fmax(tinker_occupancy_share(&labels->map, box, TINKER_TAKEN_BY_DRAWING),
                tinker_occupancy_share(&labels->map, clear, TINKER_TAKEN_BY_DRAWING));
}

/* Whether the line that leads to a far name in this box goes through what is written. */
static gboolean leader_crosses(const Labels *labels, const TinkerNamed *named, const double box[4])
{
    double line[4];
    tinker_named_leader(named, box, line);
    const int steps = (int)fmin(ceil(hypot(line[2] - line[0], line[3] - line[1]) / CELL), 100);
    for (int i = 0; i < steps; i++) {
        const double t = (i + 0.5) / steps, x = line[0] + t * (line[2] - line[0]),
                     y = line[1] + t * (line[3] - line[1]);
        if (tinker_occupancy_share(&labels->map, (double[]){x, y, x, y}, TINKER_TAKEN_BY_TEXT) > 0) return TRUE;
    }
    return FALSE;
}

/* What it costs that a name stands in a place, whose box is filled in. */
static double place_cost(const Labels *labels, const TinkerNamed *named, int number, double box[4])
{
    double drawing = covered_by(labels, named, number, box);
    double text = tinker_occupancy_share(&labels->map, box, TINKER_TAKEN_BY_TEXT);
    double crosses = tinker_named_is_far(named, number) && leader_crosses(labels, named, box) ? CROSSES : 0;
    return 10 * text + drawing + crosses + tinker_named_free_cost(named, number);
}

/* What a name may cover of drawings before it leaves its place. A far one is a makeshift: it is left as soon as there
 * is room beside the body, which then is kept. */
static double keeps(const TinkerNamed *named, int place)
{
    if (named->is_connector) return KEEPS_CONNECTOR;
    return tinker_named_is_far(named, place) ? 0 : KEEPS;
}

/* The cheapest of the places, of which there is one; the one of the picture before, `kept`, stays unless something has
 * come into its way. */
static int choose_place(const Labels *labels, const TinkerNamed *named, int kept, double best[4])
{
    int chosen = 0, places = tinker_named_places(named);
    double least = INFINITY;
    if (kept >= 0 && kept < places) {
        least = place_cost(labels, named, kept, best) - keeps(named, kept);
        chosen = kept;
    }
    /* What follows costs more than a place that is free. */
    for (int number = 0; number < places && least > tinker_named_free_cost(named, number); number++) {
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

/* Whether a name is written in the place that was chosen for it. */
static gboolean may_stand(const Labels *labels, const TinkerNamed *named, int chosen, int kept, gboolean wanted)
{
    double box[4], covers = covered_by(labels, named, chosen, box);
    gboolean covers_text = tinker_occupancy_share(&labels->map, box, TINKER_TAKEN_BY_TEXT) > 0;
    if (!named->is_connector) return wanted || (!covers_text && (chosen == kept || covers <= COVERS));
    if (wanted || covers_text) return !covers_text;
    return named->is_line && covers <= (chosen == kept ? KEEPS_CONNECTOR : 0);
}

/* Other names keep clear of it as well. */
static void draw_leader(Labels *labels, const TinkerNamed *named, const double box[4])
{
    cairo_t *cairo = labels->picture->cairo;
    double line[4];
    tinker_named_leader(named, box, line);
    tinker_occupancy_take_line(&labels->map, line[0], line[1], line[2], line[3], LEADER, TINKER_TAKEN_BY_TEXT);
    cairo_move_to(cairo, line[0], line[1]);
    cairo_line_to(cairo, line[2], line[3]);
    cairo_set_line_width(cairo, LEADER);
    cairo_stroke(cairo);
}

static void write_name(Labels *labels, const TinkerPiece *piece, gboolean wanted)
{
    TinkerPicture *picture = labels->picture;
    TinkerText name = {.text = tinker_scene_block_name(tinker_frame_scene(picture->frame), piece->block),
                       .size = TINKER_STYLE_TEXT,
                       .limit = NAME_LIMIT};
    TinkerNamed named;
    double best[4];
    if (!tinker_named_init(&named, picture, piece)) return;
    tinker_text_measure(&picture->brush.pen, &name, &named.name_width, &named.name_height);
    signed char *place = labels->places != NULL ? &labels->places[piece->block] : NULL;
    int kept = place != NULL ? *place - 1 : -1;
    int chosen = tinker_named_places(&named) > 0 ? choose_place(labels, &named, kept, best) : -1;
    gboolean stands = chosen >= 0 && may_stand(labels, &named, chosen, kept, wanted);
    /* What a name may cover where it was does not hold where it was not. */
    if (place != NULL) *place = (signed char)(stands ? 1 + chosen : 0);
    if (!stands) return;
    if (tinker_occupancy_share(&labels->map, best, TINKER_TAKEN_BY_DRAWING) > 0) {
        const double *ground = picture->options->theme->background;
        cairo_set_source_rgba(picture->cairo, ground[0], ground[1], ground[2], 0.75);
        cairo_rectangle(picture->cairo, best[0] - 2, best[1], named.name_width + 4, named.name_height);
        cairo_fill(picture->cairo);
    }
    const double *c = picture->options->theme->colours[TINKER_COLOUR_TEXT];
    cairo_set_source_rgba(picture->cairo, c[0], c[1], c[2], c[3]);
    if (tinker_named_is_far(&named, chosen)) draw_leader(labels, &named, best);
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

/* What has no part in the physics, as a note or a dimension, is read itself: a name beside it, or across it, is for who
 * has chosen it. */
static gboolean speaks_for_itself(const TinkerPiece *piece)
{
    return piece->block_class != NULL && piece->block_class->physics == NULL;
}

static void write_names(Labels *labels, const GArray *blocks, gboolean chosen)
{
    TinkerPicture *picture = labels->picture;
    const TinkerPaintOptions *options = picture->options;
    if (chosen && options->selected_count == 0 && options->highlighted == TINKER_NO_BLOCK) return;
    for (guint i = 0; i < blocks->len; i++) {
        TinkerPiece piece;
        tinker_piece_init(&piece, picture->frame, g_array_index(blocks, TinkerBlockId, i));
        uint32_t state = tinker_picture_state(picture, &piece);
        if (((state & (TINKER_STATE_SELECTED | TINKER_STATE_HIGHLIGHTED)) != 0) != chosen) continue;
        if (!chosen && speaks_for_itself(&piece)) continue;
        double x, y;
        tinker_view_to_canvas(picture->view, piece.instance.x, piece.instance.y, &x, &y);
        gboolean is_here = x >= 0 && y >= 0 && x <= picture->view->width && y <= picture->view->height;
        if (is_here || piece.kind == TINKER_PIECE_CONNECTOR) write_name(labels, &piece, chosen);
    }
}

static gboolean has_room_for(const TinkerPicture *picture, guint names)
{
    return names * LABEL_ROOM <= picture->view->width * picture->view->height;
}

gboolean tinker_picture_is_crowded(const TinkerPicture *picture)
{
    return !has_room_for(picture, picture->bodies->len);
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
    for (int layer = 0; layer < TINKER_LAYERS; layer++)
        take_layer(&labels, picture->visible[layer]);
    write_names(&labels, picture->bodies, TRUE);
    write_names(&labels, picture->connectors, TRUE);
    if (!crowded) write_names(&labels, picture->bodies, FALSE);
    guint all = picture->bodies->len + picture->connectors->len;
    if (has_room_for(picture, ALL_ROOM * all) && !(small && all > FEW))
        write_names(&labels, picture->connectors, FALSE);
    tinker_occupancy_clear(&labels.map);
}

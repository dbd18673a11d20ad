/* Labels of arrows find their places as names do: on a map of what is taken, a label tries places around the head of
 * its arrow, the one straight ahead first, and takes the one that covers least. */
#include "render/picture/arrows-diagram-private.h"

#include <math.h>
#include <string.h>

/* Canvas units. */
#define HEAD        4.0 /* half the width of a head */
#define GAP         6.0 /* between a head and its label */
#define STEP        9.0
#define PLATE       2.0 /* around a label */
#define BAR         3.0 /* before it: a bar of the arrow's colour, */
#define BAR_GAP     4.0 /* and a gap */
#define MARGIN      3.0 /* between labels and the picture's edge */
#define CELL        4.0
#define LABEL_LIMIT 260.0

#define DIRECTIONS  16
#define STEPS       5
#define PLATE_ALPHA 0.86
#define TURN_COST   0.02
#define STEP_COST   0.05
#define ROOMY       5 /* what covering a drawing costs where there is room */

/* Canvas units, of the thin line from a label to the head that it belongs to. */
#define LEADER    0.8
#define FAR_AWAY  20.0 /* labels that are farther from it have one, */
#define TAKEN_FOR 0.8  /* and those that are nearer to another head, by this factor */

static void take_places(ArrowDiagram *diagram)
{
    const TinkerView *view = diagram->view;
    double x1, y1, x2, y2;
    tinker_occupancy_init(&diagram->map, 0, 0, view->width, view->height, CELL);
    for (int i = 0; i < diagram->options->taken_count; i++)
        tinker_occupancy_take_box(&diagram->map, diagram->options->taken[i], TINKER_TAKEN_BY_TEXT);
    for (int i = 0; i < diagram->options->drawn_count; i++)
        tinker_occupancy_take_box(&diagram->map, diagram->options->drawn[i], TINKER_TAKEN_BY_DRAWING);
    for (guint i = 0; i < diagram->shafts->len; i++) {
        const ArrowShaft *shaft = &g_array_index(diagram->shafts, ArrowShaft, i);
        tinker_view_to_canvas(view, shaft->x1, shaft->y1, &x1, &y1);
        tinker_view_to_canvas(view, shaft->x2, shaft->y2, &x2, &y2);
        tinker_occupancy_take_line(&diagram->map, x1, y1, x2, y2, CELL, TINKER_TAKEN_BY_DRAWING);
        tinker_occupancy_take_box(&diagram->map, (double[]){x2 - HEAD, y2 - HEAD, x2 + HEAD, y2 + HEAD},
                                  TINKER_TAKEN_BY_DRAWING);
    }
}

/* Moves a span of this width so that it lies between the edges. */
static double keep_inside(double from, double width, double edge)
{
    return fmax(fmin(from, edge - MARGIN - width), MARGIN);
}

/* Where the label of an arrow belongs, canvas units. */
static void label_end(const ArrowDiagram *diagram, const ArrowShaft *shaft, double at[2])
{
    const gboolean at_start = (shaft->arrow->look & TINKER_ARROW_PUSHES) != 0;
    tinker_view_to_canvas(diagram->view, at_start ? shaft->x1 : shaft->x2, at_start ? shaft->y1 : shaft->y2, &at[0],
                          &at[1]);
}

/* The place, number `turn` of those around the head and a step outwards, moved into the picture: the label's box, and
 * the cost of its being there. */
static double place_cost(const ArrowDiagram *diagram, const ArrowShaft *shaft, int turn, int step, const double size[2],
                         double box[4])
{
    const gboolean at_start = (shaft->arrow->look & TINKER_ARROW_PUSHES) != 0;
    double end[2], ahead = atan2(shaft->y1 - shaft->y2, shaft->x2 - shaft->x1) + (at_start ? G_PI : 0);
    double angle = ahead + (turn % 2 ? 1 : -1) * ((turn + 1) / 2) * 2 * G_PI / DIRECTIONS;
    double across = cos(angle), down = sin(angle), gap = GAP + STEP * step;
    double reach = fmin((size[0] / 2 + gap) / fabs(across), (size[1] / 2 + gap) / fabs(down));
    label_end(diagram, shaft, end);
    box[0] = keep_inside(end[0] + reach * across - size[0] / 2, size[0], diagram->view->width);
    box[1] = keep_inside(end[1] + reach * down - size[1] / 2, size[1], diagram->view->height);
    box[2] = box[0] + size[0];
    box[3] = box[1] + size[1];
    double drawing = tinker_occupancy_share(&diagram->map, box, TINKER_TAKEN_BY_DRAWING);
    double text = tinker_occupancy_share(&diagram->map, box, TINKER_TAKEN_BY_TEXT);
    return 10 * text + (diagram->options->roomy ? ROOMY : 1) * drawing + TURN_COST * ((turn + 1) / 2) +
           STEP_COST * step;
}

/* The label's ground, and the bar that says by its colour which arrow it belongs to. */
static void draw_plate(ArrowDiagram *diagram, const ArrowShaft *shaft, const double box[4])
{
    const double *ground = diagram->options->theme->background, *colour = arrows_colour_of(diagram, shaft);
    double height = box[3] - box[1];
    cairo_set_source_rgba(diagram->cairo, ground[0], ground[1], ground[2], PLATE_ALPHA);
    cairo_rectangle(diagram->cairo, box[0] - PLATE, box[1], box[2] - box[0] + 2 * PLATE, height);
    cairo_fill(diagram->cairo);
    cairo_set_source_rgba(diagram->cairo, colour[0], colour[1], colour[2], colour[3]);
    cairo_rectangle(diagram->cairo, box[0], box[1] + 0.15 * height, BAR, 0.7 * height);
    cairo_fill(diagram->cairo);
}

/* The best of the places around the head. */
static void find_near_place(const ArrowDiagram *diagram, const ArrowShaft *shaft, const double size[2], double best[4])
{
    double least = INFINITY;
    for (int step = 0; step < STEPS; step++)
        for (int turn = 0; turn < DIRECTIONS; turn++) {
            double box[4], cost = place_cost(diagram, shaft, turn, step, size, box);
            if (cost >= least) continue;
            least = cost;
            memcpy(best, box, 4 * sizeof *best);
        }
}

static gboolean is_free(const ArrowDiagram *diagram, const double box[4], guint8 of)
{
    return tinker_occupancy_share(&diagram->map, box, of) == 0;
}

static double distance_to(const double box[4], const double at[2])
{
    return hypot(fmax(fmax(box[0] - at[0], at[0] - box[2]), 0), fmax(fmax(box[1] - at[1], at[1] - box[3]), 0));
}

/* Whether no label stands between a box and the head that it belongs to. */
static gboolean is_seen_from(const ArrowDiagram *diagram, const double box[4], const double end[2])
{
    const double x = CLAMP(end[0], box[0], box[2]) - end[0], y = CLAMP(end[1], box[1], box[3]) - end[1];
    const int parts = (int)(hypot(x, y) / CELL);
    for (int i = 1; i < parts; i++) {
        const double at[2] = {end[0] + x * i / parts, end[1] + y * i / parts};
        const double around[4] = {at[0] - LEADER, at[1] - LEADER, at[0] + LEADER, at[1] + LEADER};
        if (!is_free(diagram, around, TINKER_TAKEN_BY_TEXT)) return FALSE;
    }
    return TRUE;
}

/* The place, free of these, that is nearest to the head, of those that are seen from there if there are any; `best`
 * stays where there is none within reach. */
static void find_free_place(const ArrowDiagram *diagram, const ArrowShaft *shaft, const double size[2], guint8 of,
                            double best[4])
{
    const TinkerView *view = diagram->view;
    double end[2], least = INFINITY;
    gboolean any_seen = FALSE;
    label_end(diagram, shaft, end);
    const double reach = diagram->options->reach > 0 ? diagram->options->reach : INFINITY;
    const double bottom = fmin(view->height - MARGIN, end[1] + reach + size[1]);
    const double right = fmin(view->width - MARGIN, end[0] + reach + size[0]);
    for (double top = fmax(MARGIN, end[1] - reach - size[1]); top + size[1] <= bottom; top += CELL)
        for (double left = fmax(MARGIN, end[0] - reach - size[0]); left + size[0] <= right; left += CELL) {
            const double box[4] = {left, top, left + size[0], top + size[1]};
            const double off = distance_to(box, end);
            if (off > reach || (any_seen && off >= least) || !is_free(diagram, box, of)) continue;
            const gboolean seen = is_seen_from(diagram, box, end);
            if (seen == any_seen ? off >= least : any_seen) continue;
            any_seen = seen;
            least = off;
            memcpy(best, box, sizeof box);
        }
}

/* Whether it is not plain whose label a box is: it is far off, or nearer to the end of another arrow. */
static gboolean needs_leader(const ArrowDiagram *diagram, const ArrowShaft *shaft, const double box[4])
{
    double end[2];
    label_end(diagram, shaft, end);
    const double own = distance_to(box, end);
    gboolean needed = own > FAR_AWAY;
    for (guint i = 0; i < diagram->shafts->len && !needed; i++) {
        const ArrowShaft *other = &g_array_index(diagram->shafts, ArrowShaft, i);
        if (other == shaft) continue;
        label_end(diagram, other, end);
        needed = distance_to(box, end) < TAKEN_FOR * own;
    }
    return needed;
}

static void draw_leader(ArrowDiagram *diagram, const ArrowShaft *shaft, const double box[4])
{
    double end[2];
    label_end(diagram, shaft, end);
    const double from[2] = {CLAMP(end[0], box[0], box[2]), CLAMP(end[1], box[1], box[3])};
    const double *colour = arrows_colour_of(diagram, shaft);
    cairo_set_source_rgba(diagram->cairo, colour[0], colour[1], colour[2], colour[3]);
    cairo_set_line_width(diagram->cairo, LEADER);
    cairo_move_to(diagram->cairo, from[0], from[1]);
    cairo_line_to(diagram->cairo, end[0], end[1]);
    cairo_stroke(diagram->cairo);
    tinker_occupancy_take_line(&diagram->map, from[0], from[1], end[0], end[1], CELL, TINKER_TAKEN_BY_DRAWING);
}

static void write_label(ArrowDiagram *diagram, ArrowShaft *shaft)
{
    const double room = diagram->view->width - 2 * MARGIN - BAR - BAR_GAP;
    TinkerText label = {.text = shaft->arrow->label,
                        .size = TINKER_STYLE_TEXT,
                        .limit = fmax(fmin(LABEL_LIMIT * (diagram->options->roomy ? 2 : 1), room), 1),
                        .keeps_end = TRUE};
    double size[2], best[4] = {0};
    tinker_text_measure(&diagram->brush.pen, &label, &size[0], &size[1]);
    size[0] += BAR + BAR_GAP;
    find_near_place(diagram, shaft, size, best);
    if (diagram->options->roomy && !is_free(diagram, best, TINKER_TAKEN_BY_TEXT | TINKER_TAKEN_BY_DRAWING))
        find_free_place(diagram, shaft, size, TINKER_TAKEN_BY_TEXT | TINKER_TAKEN_BY_DRAWING, best);
    if (diagram->options->roomy && !is_free(diagram, best, TINKER_TAKEN_BY_TEXT))
        find_free_place(diagram, shaft, size, TINKER_TAKEN_BY_TEXT, best);
    if (!is_free(diagram, best, TINKER_TAKEN_BY_TEXT)) return;
    draw_plate(diagram, shaft, best);
    if (diagram->options->roomy && needs_leader(diagram, shaft, best)) draw_leader(diagram, shaft, best);
    const double *ink = diagram->options->theme->colours[TINKER_COLOUR_TEXT];
    cairo_set_source_rgba(diagram->cairo, ink[0], ink[1], ink[2], ink[3]);
    tinker_text_draw(&diagram->brush.pen, diagram->cairo, &label, best[0] + BAR + BAR_GAP, best[1]);
    tinker_occupancy_take_box(&diagram->map, best, TINKER_TAKEN_BY_TEXT);
    memcpy(shaft->label, best, sizeof shaft->label);
}

void arrows_write_labels(ArrowDiagram *diagram)
{
    int written = 0;
    take_places(diagram);
    for (guint i = 0; i < diagram->shafts->len && written < ARROWS_MOST_LABELS; i++) {
        ArrowShaft *shaft = &g_array_index(diagram->shafts, ArrowShaft, i);
        if (shaft->arrow->label == NULL || shaft->arrow->label[0] == '\0') continue;
        write_label(diagram, shaft);
        written++;
    }
    tinker_occupancy_clear(&diagram->map);
}

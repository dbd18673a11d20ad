/* Arrows are drawn with the helper that blocks draw theirs with, each first with a halo of the background, so that it
 * stands out from what it lies over. Labels find their places as names do: on a map of what is taken, a label tries
 * places around the head of its arrow, the one straight ahead first, and takes the one that covers least. */
#include "render/picture/arrows-private.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "render/draw/occupancy.h"
#include "render/draw/strokes.h"

#define SHARE_OF_VIEW 0.1
#define KEEPS         3.0 /* the factor by which a scale may be off before it changes */

/* Canvas units. */
#define SYMBOL       14.0 /* what heads are measured by */
#define HEAD         4.0  /* half the width of a head */
#define LEAST_LENGTH 3.0
#define BESIDE       7.0 /* between arrows that would lie on each other */
#define TOGETHER     2.0 /* starts so near to each other are one */
#define GAP          6.0 /* between a head and its label */
#define STEP         9.0
#define PLATE        2.0 /* around a label */
#define BAR          3.0 /* before it: a bar of the arrow's colour, */
#define BAR_GAP      4.0 /* and a gap */
#define MARGIN       3.0 /* between labels and the picture's edge */
#define CELL         4.0
#define LABEL_LIMIT  260.0

#define HEAD_SHARE  0.8   /* symbols are no larger than this share of the arrow's length */
#define SAME_WAY    0.995 /* cosine */
#define DIRECTIONS  16
#define STEPS       5
#define MOST_LABELS 300
#define PLATE_ALPHA 0.86
#define FADED_ALPHA 0.3
#define BREAK       5.0 /* canvas units: half the width of the gap in a broken shaft */
#define BREAK_ARM   5.0 /* half the length of the strokes at its ends */
#define RING        3.0 /* its radius */
#define TURN_COST   0.02
#define STEP_COST   0.05
#define ROOMY       5 /* what covering a drawing costs where there is room */

/* An arrow in the picture, m. */
typedef struct {
    const TinkerForceArrow *arrow;
    double x1, y1, x2, y2;
} Shaft;

typedef struct {
    cairo_t *cairo;
    const TinkerView *view;
    const TinkerArrowOptions *options;
    TinkerStyleBrush brush;
    GArray *shafts; /* of Shaft, the strongest first */
    TinkerOccupancy map;
} Diagram;

/* Scale ------------------------------------------------------------------------------------------------------------ */

static double strength_of(const TinkerForceArrow *arrow)
{
    double strength = hypot(arrow->fx, arrow->fy);
    return isfinite(strength) ? strength : 0;
}

/* The nearest of 1, 2, 5 times a power of ten, by ratio. */
static double round_number(double wanted)
{
    static const double mantissas[] = {1, 2, 5, 10};
    double decade = pow(10, floor(log10(wanted))), best = decade;
    for (gsize i = 1; i < G_N_ELEMENTS(mantissas); i++)
        if (fabs(log(mantissas[i] * decade / wanted)) < fabs(log(best / wanted))) best = mantissas[i] * decade;
    return best;
}

double tinker_arrows_scale(const TinkerForceArrow *arrows, gsize count, const TinkerView *view, double previous)
{
    double most = 0, wanted = SHARE_OF_VIEW * fmax(view->width, view->height) / view->scale;
    gboolean has_previous = previous > 0 && isfinite(previous);
    for (gsize i = 0; i < count; i++)
        most = fmax(most, strength_of(&arrows[i]));
    if (most > 0) wanted /= most;
    if (!(wanted > DBL_MIN) || !isfinite(wanted)) return has_previous ? previous : 1;
    if (has_previous && (most == 0 || fabs(log(previous / wanted)) <= log(KEEPS))) return previous;
    return round_number(wanted);
}

/* Arrows ----------------------------------------------------------------------------------------------------------- */

/* How many of the arrows so far it would lie on. */
static int count_beneath(const Diagram *diagram, const Shaft *shaft)
{
    double unit = 1 / diagram->view->scale, dx = shaft->x2 - shaft->x1, dy = shaft->y2 - shaft->y1;
    int count = 0;
    for (guint i = 0; i < diagram->shafts->len && i < MOST_LABELS; i++) {
        const Shaft *other = &g_array_index(diagram->shafts, Shaft, i);
        double ox = other->x2 - other->x1, oy = other->y2 - other->y1;
        if (hypot(other->arrow->x - shaft->arrow->x, other->arrow->y - shaft->arrow->y) > TOGETHER * unit) continue;
        if (dx * ox + dy * oy >= SAME_WAY * hypot(dx, dy) * hypot(ox, oy)) count++;
    }
    return count;
}

/* To one side, to the other, farther to the first. */
static void move_beside(const Diagram *diagram, Shaft *shaft)
{
    int beneath = count_beneath(diagram, shaft);
    double dx = shaft->x2 - shaft->x1, dy = shaft->y2 - shaft->y1, length = hypot(dx, dy);
    double off = (beneath + 1) / 2 * (beneath % 2 ? BESIDE : -BESIDE) / (diagram->view->scale * length);
    shaft->x1 += off * dy;
    shaft->x2 += off * dy;
    shaft->y1 -= off * dx;
    shaft->y2 -= off * dx;
}

static int stronger_first(const void *left, const void *right)
{
    const TinkerForceArrow *l = *(const TinkerForceArrow *const *)left, *r = *(const TinkerForceArrow *const *)right;
    double by = strength_of(r) - strength_of(l);
    if (by != 0) return by > 0 ? 1 : -1;
    return l < r ? -1 : l > r;
}

/* Cut to what is visible and a little more, where a head does not show. */
static gboolean clip(const Diagram *diagram, Shaft *shaft)
{
    const double line[4] = {shaft->x1, shaft->y1, shaft->x2, shaft->y2};
    double from, to, length = hypot(line[2] - line[0], line[3] - line[1]);
    TinkerStyle headless = diagram->brush.style;
    headless.symbol_size = 0;
    if (!tinker_style_finite(line, 4) || !(length * diagram->view->scale >= LEAST_LENGTH) || !isfinite(length) ||
        !tinker_style_clip(&headless, line, &from, &to) || !tinker_style_clip(&diagram->brush.style, line, &from, &to))
        return FALSE;
    double ux = (line[2] - line[0]) / length, uy = (line[3] - line[1]) / length;
    shaft->x1 = line[0] + from * ux;
    shaft->y1 = line[1] + from * uy;
    shaft->x2 = line[0] + to * ux;
    shaft->y2 = line[1] + to * uy;
    return TRUE;
}

static void find_shafts(Diagram *diagram, const TinkerForceArrow *arrows, gsize count)
{
    g_autoptr(GPtrArray) sorted = g_ptr_array_sized_new((guint)count);
    for (gsize i = 0; i < count; i++)
        if (strength_of(&arrows[i]) > 0) g_ptr_array_add(sorted, (gpointer)&arrows[i]);
    g_ptr_array_sort(sorted, stronger_first);
    diagram->shafts = g_array_sized_new(FALSE, FALSE, sizeof(Shaft), sorted->len);
    for (guint i = 0; i < sorted->len; i++) {
        const TinkerForceArrow *arrow = g_ptr_array_index(sorted, i);
        double scale = diagram->options->scale;
        Shaft shaft = {arrow, arrow->x, arrow->y, arrow->x + scale * arrow->fx, arrow->y + scale * arrow->fy};
        if (!clip(diagram, &shaft)) continue;
        move_beside(diagram, &shaft);
        g_array_append_val(diagram->shafts, shaft);
    }
}

static const double *colour_of(const Diagram *diagram, const Shaft *shaft)
{
    return tinker_arrow_colour(diagram->options->theme, shaft->arrow->kind);
}

/* Two slanted strokes with a gap between them, across the middle of the shaft. */
static void draw_break(const Diagram *diagram, const Shaft *shaft)
{
    const double *ground = diagram->options->theme->background, *colour = colour_of(diagram, shaft);
    const double unit = 1 / diagram->view->scale, length = hypot(shaft->x2 - shaft->x1, shaft->y2 - shaft->y1);
    const double ux = (shaft->x2 - shaft->x1) / length, uy = (shaft->y2 - shaft->y1) / length;
    const double middle[] = {(shaft->x1 + shaft->x2) / 2, (shaft->y1 + shaft->y2) / 2};
    const double arm[] = {BREAK_ARM * unit * (0.5 * ux - uy), BREAK_ARM * unit * (0.5 * uy + ux)};
    cairo_t *cairo = diagram->cairo;
    for (int pass = 0; pass < 2; pass++) {
        const double *ink = pass == 0 ? ground : colour;
        for (int side = -1; side <= 1; side += 2) {
            const double x = middle[0] + side * BREAK / 2 * unit * ux, y = middle[1] + side * BREAK / 2 * unit * uy;
            cairo_move_to(cairo, x - arm[0], y - arm[1]);
            cairo_line_to(cairo, x + arm[0], y + arm[1]);
        }
        cairo_set_source_rgba(cairo, ink[0], ink[1], ink[2], ink[3]);
        cairo_set_line_width(cairo, (pass == 0 ? 1.5 * BREAK : 1.6) * unit);
        cairo_stroke(cairo);
    }
}

static void draw_ring(const Diagram *diagram, const Shaft *shaft)
{
    const double *ground = diagram->options->theme->background, *colour = colour_of(diagram, shaft);
    cairo_t *cairo = diagram->cairo;
    cairo_arc(cairo, shaft->x1, shaft->y1, RING / diagram->view->scale, 0, 2 * G_PI);
    cairo_set_source_rgba(cairo, ground[0], ground[1], ground[2], ground[3]);
    cairo_fill_preserve(cairo);
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
    cairo_set_line_width(cairo, 1.6 / diagram->view->scale);
    cairo_stroke(cairo);
}

/* What is not looked at has little of its colour. */
static void set_shaft_colour(const Diagram *diagram, const Shaft *shaft, TinkerStyle *style)
{
    const double *colour = colour_of(diagram, shaft), *ground = diagram->options->theme->background;
    const double share = shaft->arrow->look & TINKER_ARROW_FADED ? FADED_ALPHA : 1;
    double *to = style->colours[TINKER_COLOUR_FORCE];
    for (int k = 0; k < 3; k++)
        to[k] = ground[k] + share * (colour[k] - ground[k]);
    to[3] = colour[3];
}

static void draw_shafts(Diagram *diagram, gboolean halo)
{
    TinkerStyle style = diagram->brush.style;
    const TinkerTheme *theme = diagram->options->theme;
    style.state = halo ? TINKER_STATE_HIGHLIGHTED : 0;
    memcpy(style.colours[TINKER_COLOUR_HIGHLIGHTED], theme->background, sizeof(theme->background));
    for (guint i = 0; i < diagram->shafts->len; i++) {
        const Shaft *shaft = &g_array_index(diagram->shafts, Shaft, i);
        set_shaft_colour(diagram, shaft, &style);
        double length = hypot(shaft->x2 - shaft->x1, shaft->y2 - shaft->y1);
        style.symbol_size = fmin(diagram->brush.style.symbol_size, HEAD_SHARE * length);
        style.arrow(&style, diagram->cairo, TINKER_COLOUR_FORCE, shaft->x1, shaft->y1, shaft->x2, shaft->y2);
        if (!halo && (shaft->arrow->look & TINKER_ARROW_BROKEN)) draw_break(diagram, shaft);
        if (!halo && (shaft->arrow->look & TINKER_ARROW_STUB)) draw_ring(diagram, shaft);
    }
}

/* Labels ----------------------------------------------------------------------------------------------------------- */

static void take_places(Diagram *diagram)
{
    const TinkerView *view = diagram->view;
    double x1, y1, x2, y2;
    tinker_occupancy_init(&diagram->map, 0, 0, view->width, view->height, CELL);
    for (int i = 0; i < diagram->options->taken_count; i++)
        tinker_occupancy_take_box(&diagram->map, diagram->options->taken[i], TINKER_TAKEN_BY_TEXT);
    for (int i = 0; i < diagram->options->drawn_count; i++)
        tinker_occupancy_take_box(&diagram->map, diagram->options->drawn[i], TINKER_TAKEN_BY_DRAWING);
    for (guint i = 0; i < diagram->shafts->len; i++) {
        const Shaft *shaft = &g_array_index(diagram->shafts, Shaft, i);
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

/* The place, number `turn` of those around the head and a step outwards, moved into the picture: the label's box, and
 * the cost of its being there. */
static double place_cost(const Diagram *diagram, const Shaft *shaft, int turn, int step, const double size[2],
                         double box[4])
{
    const gboolean at_start = (shaft->arrow->look & TINKER_ARROW_PUSHES) != 0;
    double x, y, ahead = atan2(shaft->y1 - shaft->y2, shaft->x2 - shaft->x1) + (at_start ? G_PI : 0);
    double angle = ahead + (turn % 2 ? 1 : -1) * ((turn + 1) / 2) * 2 * G_PI / DIRECTIONS;
    double across = cos(angle), down = sin(angle), gap = GAP + STEP * step;
    double reach = fmin((size[0] / 2 + gap) / fabs(across), (size[1] / 2 + gap) / fabs(down));
    tinker_view_to_canvas(diagram->view, at_start ? shaft->x1 : shaft->x2, at_start ? shaft->y1 : shaft->y2, &x, &y);
    box[0] = keep_inside(x + reach * across - size[0] / 2, size[0], diagram->view->width);
    box[1] = keep_inside(y + reach * down - size[1] / 2, size[1], diagram->view->height);
    box[2] = box[0] + size[0];
    box[3] = box[1] + size[1];
    double drawing = tinker_occupancy_share(&diagram->map, box, TINKER_TAKEN_BY_DRAWING);
    double text = tinker_occupancy_share(&diagram->map, box, TINKER_TAKEN_BY_TEXT);
    return 10 * text + (diagram->options->roomy ? ROOMY : 1) * drawing + TURN_COST * ((turn + 1) / 2) +
           STEP_COST * step;
}

/* The label's ground, and the bar that says by its colour which arrow it belongs to. */
static void draw_plate(Diagram *diagram, const Shaft *shaft, const double box[4])
{
    const double *ground = diagram->options->theme->background, *colour = colour_of(diagram, shaft);
    double height = box[3] - box[1];
    cairo_set_source_rgba(diagram->cairo, ground[0], ground[1], ground[2], PLATE_ALPHA);
    cairo_rectangle(diagram->cairo, box[0] - PLATE, box[1], box[2] - box[0] + 2 * PLATE, height);
    cairo_fill(diagram->cairo);
    cairo_set_source_rgba(diagram->cairo, colour[0], colour[1], colour[2], colour[3]);
    cairo_rectangle(diagram->cairo, box[0], box[1] + 0.15 * height, BAR, 0.7 * height);
    cairo_fill(diagram->cairo);
}

/* The best of the places around the head. */
static void find_near_place(const Diagram *diagram, const Shaft *shaft, const double size[2], double best[4])
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

static gboolean is_free(const Diagram *diagram, const double box[4], guint8 of)
{
    return tinker_occupancy_share(&diagram->map, box, of) == 0;
}

/* The free place in all of the picture that is nearest to the head; `best` stays where there is none. */
static void find_free_place(const Diagram *diagram, const Shaft *shaft, const double size[2], double best[4])
{
    const gboolean at_start = (shaft->arrow->look & TINKER_ARROW_PUSHES) != 0;
    const TinkerView *view = diagram->view;
    double x, y, least = INFINITY;
    tinker_view_to_canvas(view, at_start ? shaft->x1 : shaft->x2, at_start ? shaft->y1 : shaft->y2, &x, &y);
    for (double top = MARGIN; top + size[1] <= view->height - MARGIN; top += CELL)
        for (double left = MARGIN; left + size[0] <= view->width - MARGIN; left += CELL) {
            const double box[4] = {left, top, left + size[0], top + size[1]};
            const double off = hypot(fmax(fmax(left - x, x - box[2]), 0), fmax(fmax(top - y, y - box[3]), 0));
            if (off >= least || !is_free(diagram, box, TINKER_TAKEN_BY_TEXT | TINKER_TAKEN_BY_DRAWING)) continue;
            least = off;
            memcpy(best, box, sizeof box);
        }
}

static void write_label(Diagram *diagram, const Shaft *shaft)
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
        find_free_place(diagram, shaft, size, best);
    if (!is_free(diagram, best, TINKER_TAKEN_BY_TEXT)) return;
    draw_plate(diagram, shaft, best);
    const double *ink = diagram->options->theme->colours[TINKER_COLOUR_TEXT];
    cairo_set_source_rgba(diagram->cairo, ink[0], ink[1], ink[2], ink[3]);
    tinker_text_draw(&diagram->brush.pen, diagram->cairo, &label, best[0] + BAR + BAR_GAP, best[1]);
    tinker_occupancy_take_box(&diagram->map, best, TINKER_TAKEN_BY_TEXT);
}

static void write_labels(Diagram *diagram)
{
    int written = 0;
    take_places(diagram);
    for (guint i = 0; i < diagram->shafts->len && written < MOST_LABELS; i++) {
        const Shaft *shaft = &g_array_index(diagram->shafts, Shaft, i);
        if (shaft->arrow->label == NULL || shaft->arrow->label[0] == '\0') continue;
        write_label(diagram, shaft);
        written++;
    }
    tinker_occupancy_clear(&diagram->map);
}

/* All -------------------------------------------------------------------------------------------------------------- */

void tinker_arrows_draw_noting(cairo_t *cairo, const TinkerView *view, const TinkerForceArrow *arrows, gsize count,
                               const TinkerArrowOptions *options, GPtrArray *written)
{
    Diagram diagram = {.cairo = cairo, .view = view, .options = options};
    tinker_style_begin(&diagram.brush, cairo, options->theme, view, SYMBOL / view->scale);
    diagram.brush.pen.written = written;
    find_shafts(&diagram, arrows, count);
    tinker_style_enter_world(&diagram.brush.style, cairo);
    draw_shafts(&diagram, TRUE);
    draw_shafts(&diagram, FALSE);
    cairo_restore(cairo);
    cairo_save(cairo);
    write_labels(&diagram);
    cairo_restore(cairo);
    g_array_unref(diagram.shafts);
    tinker_style_end(&diagram.brush);
}

void tinker_arrows_draw(cairo_t *cairo, const TinkerView *view, const TinkerForceArrow *arrows, gsize count,
                        const TinkerArrowOptions *options)
{
    tinker_arrows_draw_noting(cairo, view, arrows, count, options, NULL);
}

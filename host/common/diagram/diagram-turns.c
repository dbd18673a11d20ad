/* Torques as turning arrows about the middle of the body, one inside the other, and their labels one below the other.
 */
#include <math.h>
#include <string.h>

#include "common/diagram/diagram-picture-private.h"

#define TURN_SHARE   0.2 /* of the lesser side, the radius of the innermost */
#define TURN_HEAD    8.0 /* canvas units */
#define ARROW_PIECES 40  /* that an arrow is looked at in */
#define LEAST_NAME   3   /* letters that are left of a name that is cut */

/* An arc about a place, open below, with a head at its end: counter-clockwise for what is positive. */
static void draw_turn(cairo_t *cairo, const double at[2], double radius, double torque, const double *colour)
{
    const double way = torque > 0 ? -1 : 1; /* angles of the canvas grow clockwise */
    const double from = torque > 0 ? 0.25 * G_PI : 0.75 * G_PI, to = from + way * 1.5 * G_PI;
    const double x = at[0] + radius * cos(to), y = at[1] + radius * sin(to);
    const double ux = -way * sin(to), uy = way * cos(to);
    cairo_new_path(cairo);
    diagram_set_colour(cairo, colour);
    cairo_set_line_width(cairo, 2);
    (way > 0 ? cairo_arc : cairo_arc_negative)(cairo, at[0], at[1], radius, from, to);
    cairo_stroke(cairo);
    cairo_move_to(cairo, x + TURN_HEAD * ux, y + TURN_HEAD * uy);
    cairo_line_to(cairo, x - 0.5 * TURN_HEAD * uy, y + 0.5 * TURN_HEAD * ux);
    cairo_line_to(cairo, x + 0.5 * TURN_HEAD * uy, y - 0.5 * TURN_HEAD * ux);
    cairo_close_path(cairo);
    cairo_fill(cairo);
}

/* What stands at a torque: its name, and its value unless a list has that. (transfer full) */
static char *turn_label_of(const DiagramDrawing *drawing, const char *name, double torque)
{
    if (drawing->brief) return g_strdup(name);
    g_autofree char *value = diagram_torque_text(drawing, fabs(torque));
    return g_strdup_printf("%s  %s", name, value);
}

/* What stands at a torque in so much room: of what is too long the name is cut, never the value. With numbers the list
 * has it. */
static char *turn_label_in(DiagramDrawing *drawing, const char *name, double torque, double room)
{
    char *label = turn_label_of(drawing, name, torque);
    for (glong letters = g_utf8_strlen(name, -1) - 1; diagram_text_width(drawing, label, FALSE) > room; letters--) {
        g_free(label);
        if (drawing->numbered) return g_strdup(name);
        if (letters < LEAST_NAME) return diagram_torque_text(drawing, fabs(torque));
        g_autofree char *begin = g_utf8_substring(name, 0, letters), *cut = g_strconcat(begin, "…", NULL);
        label = turn_label_of(drawing, cut, torque);
    }
    return label;
}

/* Whether an arrow passes through a box of the canvas. */
static gboolean is_crossed(const DiagramPart *part, const double box[4])
{
    for (guint i = 0; i < part->arrows->len; i++) {
        const TinkerForceArrow *arrow = &g_array_index(part->arrows, TinkerForceArrow, i);
        for (int k = 0; k <= ARROW_PIECES; k++) {
            const double share = (double)k / ARROW_PIECES;
            double x, y;
            tinker_view_to_canvas(part->view, diagram_arrow_start(arrow, 0) + share * arrow->fx,
                                  diagram_arrow_start(arrow, 1) + share * arrow->fy, &x, &y);
            if (x > box[0] && x < box[2] && y > box[1] && y < box[3]) return TRUE;
        }
    }
    return FALSE;
}

/* A torque's name, or the number that stands for it. (transfer full) */
static char *turn_name(const DiagramDrawing *drawing, guint i)
{
    const TinkerDiagramForce *torque = &g_array_index(drawing->torques, TinkerDiagramForce, i);
    return drawing->numbered ? g_strdup_printf("%u", drawing->forces->len + i + 1)
                             : g_strdup(tinker_scene_block_name(drawing->scene, torque->from));
}

/* How long the longest label of a torque is in so much room (canvas units). */
static double widest_label(const DiagramPart *part, double room)
{
    DiagramDrawing *drawing = part->drawing;
    double widest = 0;
    for (guint i = 0; i < drawing->torques->len; i++) {
        g_autofree char *name = turn_name(drawing, i);
        g_autofree char *label =
            turn_label_in(drawing, name, g_array_index(drawing->torques, TinkerDiagramForce, i).torque, room);
        widest = fmax(widest, diagram_text_width(drawing, label, FALSE));
    }
    return widest;
}

/* How far (canvas units, downwards) labels at the right of the arcs, half as high as this, make way for arrows. */
static double way_of(const DiagramPart *part, double beside, double middle, double half)
{
    static const double steps[] = {0, 1, -1, 2, -2, 3, -3};
    const double room = fmax(part->view->width - beside - TURN_HEAD, 1), width = widest_label(part, room);
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        const double way = steps[i] * 0.8 * DIAGRAM_ROW, y = middle + way;
        const double box[] = {beside - TURN_HEAD, y - half - TURN_HEAD / 2, beside + width + TURN_HEAD,
                              y + half + TURN_HEAD / 2};
        if (!is_crossed(part, box)) return way;
    }
    return 0;
}

/* Moves a box of the canvas to the side, within the part, where no arrow crosses it. FALSE: nowhere. */
static gboolean make_way(const DiagramPart *part, double box[4])
{
    const double half = (box[2] - box[0]) / 2 + 0.5 * TURN_HEAD, steps[] = {0, half, -half};
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        const double moved[] = {box[0] + steps[i], box[1], box[2] + steps[i], box[3]};
        if (moved[0] < 0 || moved[2] > part->view->width || is_crossed(part, moved)) continue;
        memcpy(box, moved, sizeof moved);
        return TRUE;
    }
    return FALSE;
}

/* The box of the resultant's label, whose top is at `y`: with its value, or without where that would be crossed. */
static void place_resultant(const DiagramPart *part, DiagramTurns *turns, double y)
{
    for (int bare = 0; bare < 2; bare++) {
        g_autofree char *label =
            bare ? g_strdup("I α") : turn_label_of(part->drawing, "I α", part->drawing->picture->diagram->turning);
        const double half = diagram_text_width(part->drawing, label, FALSE) / 2 + 0.5 * TURN_HEAD;
        const double box[] = {turns->at[0] - half, y, turns->at[0] + half, y + DIAGRAM_ROW};
        turns->bare = bare;
        memcpy(turns->labels, box, sizeof box);
        if (make_way(part, turns->labels)) return;
    }
}

DiagramTurns diagram_turns(const DiagramPart *part, gboolean kinetic)
{
    const TinkerDiagram *diagram = part->drawing->picture->diagram;
    DiagramTurns turns = {.least = TURN_SHARE * fmin(part->drawing->lesser, 3 * DIAGRAM_MOST_BODY),
                          .count = !kinetic                       ? part->drawing->torques->len
                                   : diagram_has_turning(diagram) ? 1
                                                                  : 0};
    tinker_view_to_canvas(part->view, diagram->centre[0], diagram->centre[1], &turns.at[0], &turns.at[1]);
    const double half = 0.5 * DIAGRAM_ROW * turns.count, least = turns.least;
    const double beside = turns.at[0] + least + DIAGRAM_TURN_STEP * turns.count;
    const double middle = turns.at[1] + (kinetic ? 0 : way_of(part, beside, turns.at[1], half));
    /* below, where the arc is open, or above where the resultant points there */
    const double above = turns.at[1] - least - 1.5 * DIAGRAM_ROW;
    const double y = diagram->kinetic[1] < 0 && above > DIAGRAM_HEADING ? above : turns.at[1] + least;
    const double box[] = {beside, middle - half, part->view->width, middle + half};
    if (turns.count > 0 && !kinetic) memcpy(turns.labels, box, sizeof box);
    if (turns.count > 0 && kinetic) place_resultant(part, &turns, y);
    return turns;
}

void diagram_draw_turns(const DiagramPart *part, const DiagramTurns *turns, gboolean kinetic)
{
    DiagramDrawing *drawing = part->drawing;
    const TinkerTheme *theme = drawing->picture->theme;
    if (kinetic && turns->count > 0) {
        draw_turn(drawing->cairo, turns->at, turns->least, drawing->picture->diagram->turning,
                  tinker_arrow_colour(theme, TINKER_ARROW_MOTION));
        g_autofree char *label =
            turns->bare ? g_strdup("I α") : turn_label_of(drawing, "I α", drawing->picture->diagram->turning);
        diagram_write(drawing, (TinkerText){.text = label, .size = DIAGRAM_TEXT, .anchor_x = 0.5},
                      (turns->labels[0] + turns->labels[2]) / 2, turns->labels[1]);
    }
    for (guint i = 0; !kinetic && i < turns->count; i++) {
        const TinkerDiagramForce *torque = &g_array_index(drawing->torques, TinkerDiagramForce, i);
        g_autofree char *name = turn_name(drawing, i);
        const double room = fmax(turns->labels[2] - turns->labels[0] - TURN_HEAD, 1);
        g_autofree char *text = turn_label_in(drawing, name, torque->torque, room);
        const TinkerText label = {.text = text, .size = DIAGRAM_TEXT};
        draw_turn(drawing->cairo, turns->at, turns->least + DIAGRAM_TURN_STEP * i, torque->torque,
                  tinker_arrow_colour(theme, diagram_arrow_kind(torque->kind)));
        diagram_write(drawing, label, turns->labels[0] + 0.5 * TURN_HEAD, turns->labels[1] + DIAGRAM_ROW * i);
    }
}

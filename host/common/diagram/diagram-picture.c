/* The bodies are drawn by the painter, the arrows by what draws them on the canvas as well. Here is what a diagram
 * adds: where on the paper things stand, one scale for all arrows, and arrows that would lie on each other moved apart.
 */
#include "common/diagram/diagram-picture-private.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "common/diagram/diagram-scale.h"
#include "render/picture/painter.h"

/* Canvas units. */
#define TITLE       15.0
#define HEADING     20.0
#define EQUALS      26.0 /* the size of the sign between the diagrams, */
#define ASIDE       18.0 /* and half of the room for it */
#define BESIDE      10.0 /* between arrows that would lie on each other */
#define MOST_BODY   110.0
#define MOST_ARROW  200.0
#define LEAST_ARROW 4.0   /* shorter ones could not be seen */
#define NARROW_PART 330.0 /* of the paper: below it arrows have numbers in place of names, as the list has, */
#define LEAST_PART  170.0 /* and below this no values */

#define TURN_SHARE   0.2 /* of the same, the radius of a turning arrow */
#define TURN_STEP    8.0 /* between two of them */
#define TURN_HEAD    8.0
#define TURN_LABEL   110.0 /* about as long as a label of an arc is */
#define ARROW_PIECES 40    /* that an arrow is looked at in */

#define BODY_SHARE  0.24 /* of the lesser side of its part of the paper, for one body; */
#define WIDE_SHARE  0.42 /* for several */
#define ARROW_SHARE 0.36
#define FREE_SHARE  0.58 /* of the width, for the free-body diagram where both are drawn */

/* The bodies ---------------------------------------------------------------------------------------------------------
 */

/* The world box of what the diagram is of. */
static void find_box(const DiagramDrawing *drawing, double box[4])
{
    const TinkerView view = {.scale = 1e6, .width = 800, .height = 600};
    double own[4];
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
    for (const TinkerBlockId *block = drawing->picture->blocks; *block >= 0; block++)
        if (tinker_painter_box(drawing->picture->frame, *block, &view, own)) {
            box[0] = fmin(box[0], own[0]);
            box[1] = fmin(box[1], own[1]);
            box[2] = fmax(box[2], own[2]);
            box[3] = fmax(box[3], own[3]);
        }
    if (box[0] <= box[2]) return;
    for (int side = 0; side < 4; side++)
        box[side] = drawing->picture->diagram->centre[side % 2];
}

/* Of a support that is far longer than what acts on it, the part about the forces. */
static void cut_box(const DiagramDrawing *drawing, double box[4])
{
    const TinkerDiagram *diagram = drawing->picture->diagram;
    if (diagram->moves || drawing->forces->len == 0) return;
    double about[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (guint i = 0; i < drawing->forces->len; i++) {
        const double *point = g_array_index(drawing->forces, TinkerDiagramForce, i).point;
        for (int axis = 0; axis < 2; axis++) {
            about[axis] = fmin(about[axis], point[axis]);
            about[axis + 2] = fmax(about[axis + 2], point[axis]);
        }
    }
    const double thin = fmin(box[2] - box[0], box[3] - box[1]);
    const double room = fmax(4 * thin, 0.3 * fmax(about[2] - about[0], about[3] - about[1]));
    for (int axis = 0; axis < 2; axis++) {
        box[axis] = fmax(box[axis], about[axis] - room);
        box[axis + 2] = fmin(box[axis + 2], about[axis + 2] + room);
    }
}

/* The boxes of the bodies in a part of the paper, of double[4]. (transfer full) */
static GArray *drawn_boxes(const DiagramDrawing *drawing, const TinkerView *view)
{
    GArray *boxes = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    for (const TinkerBlockId *block = drawing->picture->blocks; *block >= 0; block++) {
        double world[4], box[4];
        if (!tinker_painter_box(drawing->picture->frame, *block, view, world)) continue;
        tinker_view_to_canvas(view, world[0], world[3], &box[0], &box[1]);
        tinker_view_to_canvas(view, world[2], world[1], &box[2], &box[3]);
        g_array_append_vals(boxes, box, 1);
    }
    return boxes;
}

/* The bodies in the middle of a part of the paper, small enough that the arrows have room around them. */
static TinkerView view_of(const DiagramDrawing *drawing, double width, double height)
{
    const double lesser = drawing->lesser;
    double box[4];
    find_box(drawing, box);
    cut_box(drawing, box);
    const gboolean several = drawing->picture->blocks[0] >= 0 && drawing->picture->blocks[1] >= 0;
    const double share = several ? WIDE_SHARE : BODY_SHARE;
    const double room = several ? share * lesser : fmin(share * lesser, MOST_BODY);
    const double extent = fmax(fmax(box[2] - box[0], box[3] - box[1]), 1e-9);
    const double scale = room / extent;
    return (TinkerView){.scale = scale,
                        .origin_x = width / 2 - scale * (box[0] + box[2]) / 2,
                        .origin_y = height / 2 + scale * (box[1] + box[3]) / 2,
                        .width = width,
                        .height = height};
}

static void draw_bodies(DiagramDrawing *drawing, const TinkerView *view)
{
    TinkerTheme theme = *drawing->picture->theme;
    TinkerPaintOptions options = tinker_paint_options_default();
    theme.background[3] = 0;
    options.theme = &theme;
    options.only = drawing->picture->blocks;
    options.show_grid = options.show_labels = FALSE;
    tinker_paint_scene(drawing->cairo, drawing->picture->frame, view, &options);
}

/* Arrows -------------------------------------------------------------------------------------------------------------
 */

/* Of one part of the paper, in its canvas units, whose arrows are TinkerForceArrow with a scale of 1 canvas unit. */
typedef struct {
    DiagramDrawing *drawing;
    const TinkerView *view;
    double longest;   /* canvas units */
    GArray *arrows;   /* of TinkerForceArrow */
    GPtrArray *texts; /* labels */
} Part;

/* Whether two arrows lie on one line and over each other. */
static gboolean lie_together(const TinkerForceArrow *a, const TinkerForceArrow *b, double beside)
{
    const double length = hypot(a->fx, a->fy), other = hypot(b->fx, b->fy);
    const double ux = a->fx / length, uy = a->fy / length;
    if (fabs(ux * b->fy - uy * b->fx) > 0.12 * other) return FALSE;
    if (fabs(ux * (b->y - a->y) - uy * (b->x - a->x)) > 0.9 * beside) return FALSE;
    const double from = ux * (b->x - a->x) + uy * (b->y - a->y), to = from + ux * b->fx + uy * b->fy;
    return fmax(from, to) > 1e-6 * length && fmin(from, to) < length * (1 - 1e-6);
}

static void move_apart(const Part *part, TinkerForceArrow *arrow)
{
    static const double steps[] = {0, 1, -1, 2, -2, 3, -3, 4, -4};
    const double length = hypot(arrow->fx, arrow->fy), beside = BESIDE / part->view->scale;
    const double x = arrow->x, y = arrow->y;
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        gboolean alone = TRUE;
        arrow->x = x + steps[i] * beside * arrow->fy / length;
        arrow->y = y - steps[i] * beside * arrow->fx / length;
        for (guint k = 0; k < part->arrows->len && alone; k++)
            alone = !lie_together(&g_array_index(part->arrows, TinkerForceArrow, k), arrow, beside);
        if (alone) return;
    }
    arrow->x = x;
    arrow->y = y;
}

/* What pushes ends where it acts: its arrow stands outside of the body. */
static gboolean pushes(const DiagramDrawing *drawing, const TinkerDiagramForce *force)
{
    double x, y, orientation;
    tinker_frame_centre(drawing->picture->frame, force->on, &x, &y, &orientation);
    const double inward = force->force[0] * (x - force->point[0]) + force->force[1] * (y - force->point[1]);
    return inward > 0.3 * diagram_strength(force->force) * hypot(x - force->point[0], y - force->point[1]);
}

/* Adds an arrow of this force, which takes the label over. */
static void add_arrow(Part *part, const double point[2], const double force[2], gboolean to_point, TinkerArrowKind kind,
                      gboolean faded, char *label)
{
    const DiagramDrawing *drawing = part->drawing;
    const double size = diagram_strength(force), unit = 1 / part->view->scale;
    const double to_scale = fmin(fmax(size / drawing->size, 1 / TINKER_DIAGRAM_RATIO), 1) * part->longest;
    const double shown = fmax(to_scale, LEAST_ARROW) * unit;
    TinkerForceArrow arrow = {.x = point[0],
                              .y = point[1],
                              .fx = force[0] / size * shown,
                              .fy = force[1] / size * shown,
                              .label = label,
                              .kind = kind};
    if (to_point) {
        arrow.look |= TINKER_ARROW_PUSHES;
        arrow.x -= arrow.fx;
        arrow.y -= arrow.fy;
    }
    if (diagram_is_broken(drawing, size)) arrow.look |= TINKER_ARROW_BROKEN;
    if (diagram_is_stub(drawing, size)) arrow.look |= TINKER_ARROW_STUB;
    if (faded) arrow.look |= TINKER_ARROW_FADED;
    move_apart(part, &arrow);
    g_ptr_array_add(part->texts, label);
    g_array_append_val(part->arrows, arrow);
}

/* What stands at an arrow: all of it, or as much as there is room for. (transfer full) */
static char *label_of(const Part *part, const char *name, const double force[2])
{
    if (part->drawing->brief) return g_strdup(name);
    g_autofree char *value = diagram_force_text(part->drawing, diagram_strength(force));
    return g_strdup_printf("%s  %s", name, value);
}

static void add_forces(Part *part)
{
    const DiagramDrawing *drawing = part->drawing;
    for (guint i = 0; i < drawing->forces->len; i++) {
        const TinkerDiagramForce *force = &g_array_index(drawing->forces, TinkerDiagramForce, i);
        const TinkerBlockId lit = drawing->picture->lit;
        g_autofree char *name = drawing->numbered ? g_strdup_printf("%u", i + 1) : diagram_force_name(drawing, force);
        add_arrow(part, force->point, force->force, pushes(drawing, force), diagram_arrow_kind(force->kind),
                  lit != TINKER_NO_BLOCK && lit != force->from, label_of(part, name, force->force));
    }
}

static void add_resultant(Part *part)
{
    const TinkerDiagram *diagram = part->drawing->picture->diagram;
    add_arrow(part, diagram->centre, diagram->kinetic, FALSE, TINKER_ARROW_MOTION, FALSE,
              label_of(part, "m a", diagram->kinetic));
}

/* Turning arrows -----------------------------------------------------------------------------------------------------
 */

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

/* What stands at one; see label_of. (transfer full) */
static char *turn_label_of(const DiagramDrawing *drawing, const char *name, double torque)
{
    if (drawing->brief) return g_strdup(name);
    g_autofree char *value = diagram_torque_text(drawing, fabs(torque));
    return g_strdup_printf("%s  %s", name, value);
}

#define LEAST_NAME 3 /* letters that are left of a name that is cut */

/* The same in so much room: of what is too long the name is cut, never the value. With numbers the list has it. */
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

/* Where they stand: the middle of the body, the radius of the innermost, and the box that their labels take. */
typedef struct {
    double at[2], least, labels[4];
    guint count;
} Turns;

/* Whether an arrow passes through a box of the canvas. */
static gboolean is_crossed(const Part *part, const double box[4])
{
    for (guint i = 0; i < part->arrows->len; i++) {
        const TinkerForceArrow *arrow = &g_array_index(part->arrows, TinkerForceArrow, i);
        for (int k = 0; k <= ARROW_PIECES; k++) {
            const double share = (double)k / ARROW_PIECES;
            double x, y;
            tinker_view_to_canvas(part->view, arrow->x + share * arrow->fx, arrow->y + share * arrow->fy, &x, &y);
            if (x > box[0] && x < box[2] && y > box[1] && y < box[3]) return TRUE;
        }
    }
    return FALSE;
}

/* How far (canvas units, downwards) labels at the right of the arcs, half as high as this, make way for arrows. */
static double way_of(const Part *part, double beside, double middle, double half)
{
    static const double steps[] = {0, 1, -1, 2, -2, 3, -3};
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        const double way = steps[i] * 0.8 * DIAGRAM_ROW, y = middle + way;
        const double box[] = {beside - TURN_HEAD, y - half - TURN_HEAD / 2, beside + TURN_LABEL,
                              y + half + TURN_HEAD / 2};
        if (!is_crossed(part, box)) return way;
    }
    return 0;
}

static Turns turns_of(const Part *part, gboolean kinetic)
{
    const TinkerDiagram *diagram = part->drawing->picture->diagram;
    Turns turns = {.least = TURN_SHARE * fmin(part->drawing->lesser, 3 * MOST_BODY),
                   .count = !kinetic                       ? part->drawing->torques->len
                            : diagram_has_turning(diagram) ? 1
                                                           : 0};
    tinker_view_to_canvas(part->view, diagram->centre[0], diagram->centre[1], &turns.at[0], &turns.at[1]);
    const double half = 0.5 * DIAGRAM_ROW * turns.count, least = turns.least;
    const double half_label = (part->drawing->brief ? 1 : 3) * DIAGRAM_ROW;
    const double beside = turns.at[0] + least + TURN_STEP * turns.count;
    const double middle = turns.at[1] + (kinetic ? 0 : way_of(part, beside, turns.at[1], half));
    /* below, where the arc is open, or above where the resultant points there */
    const double above = turns.at[1] - least - 1.5 * DIAGRAM_ROW;
    const double y = diagram->kinetic[1] < 0 && above > HEADING ? above : turns.at[1] + least;
    const double boxes[2][4] = {{beside, middle - half, part->view->width, middle + half},
                                {turns.at[0] - half_label, y, turns.at[0] + half_label, y + DIAGRAM_ROW}};
    if (turns.count > 0) memcpy(turns.labels, boxes[kinetic], sizeof turns.labels);
    return turns;
}

/* One inside the other, and their labels one below the other. */
static void draw_torques(const Part *part, const Turns *turns, gboolean kinetic)
{
    DiagramDrawing *drawing = part->drawing;
    const TinkerTheme *theme = drawing->picture->theme;
    if (kinetic && turns->count > 0) {
        draw_turn(drawing->cairo, turns->at, turns->least, drawing->picture->diagram->turning,
                  tinker_arrow_colour(theme, TINKER_ARROW_MOTION));
        g_autofree char *label = turn_label_of(drawing, "I α", drawing->picture->diagram->turning);
        diagram_write(drawing, (TinkerText){.text = label, .size = DIAGRAM_TEXT, .anchor_x = 0.5}, turns->at[0],
                      turns->labels[1]);
    }
    for (guint i = 0; !kinetic && i < turns->count; i++) {
        const TinkerDiagramForce *torque = &g_array_index(drawing->torques, TinkerDiagramForce, i);
        g_autofree char *number = g_strdup_printf("%u", drawing->forces->len + i + 1);
        const char *name = drawing->numbered ? number : tinker_scene_block_name(drawing->scene, torque->from);
        const double room = fmax(turns->labels[2] - turns->labels[0] - TURN_HEAD, 1);
        g_autofree char *text = turn_label_in(drawing, name, torque->torque, room);
        const TinkerText label = {.text = text, .size = DIAGRAM_TEXT};
        draw_turn(drawing->cairo, turns->at, turns->least + TURN_STEP * i, torque->torque,
                  tinker_arrow_colour(theme, diagram_arrow_kind(torque->kind)));
        diagram_write(drawing, label, turns->labels[0] + 0.5 * TURN_HEAD, turns->labels[1] + DIAGRAM_ROW * i);
    }
}

static void draw_part(DiagramDrawing *drawing, const double place[4], const char *heading, gboolean kinetic)
{
    const double width = place[2] - place[0], height = place[3] - place[1];
    const TinkerView view = view_of(drawing, width, height);
    const TinkerDiagram *diagram = drawing->picture->diagram;
    Part part = {.drawing = drawing,
                 .view = &view,
                 .longest = fmin(ARROW_SHARE * drawing->lesser, MOST_ARROW),
                 .arrows = g_array_new(FALSE, TRUE, sizeof(TinkerForceArrow)),
                 .texts = g_ptr_array_new_with_free_func(g_free)};
    if (!kinetic) add_forces(&part);
    if (kinetic && diagram_has_resultant(diagram)) add_resultant(&part);
    const Turns turns = turns_of(&part, kinetic);
    double taken[2][4] = {{0, 0, width, HEADING}};
    memcpy(taken[1], turns.labels, sizeof taken[1]);
    g_autoptr(GArray) drawn = drawn_boxes(drawing, &view);
    const double reach = turns.least + TURN_STEP * turns.count;
    const double arcs[] = {turns.at[0] - reach, turns.at[1] - reach, turns.at[0] + reach, turns.at[1] + reach};
    if (turns.count > 0) g_array_append_vals(drawn, arcs, 1);
    const TinkerArrowOptions options = {.theme = drawing->picture->theme,
                                        .scale = 1,
                                        .taken = (const double(*)[4])taken,
                                        .taken_count = turns.count > 0 ? 2 : 1,
                                        .drawn = (const double(*)[4])(gpointer)drawn->data,
                                        .drawn_count = (int)drawn->len,
                                        .roomy = TRUE};
    cairo_save(drawing->cairo);
    cairo_rectangle(drawing->cairo, place[0], place[1], width, height);
    cairo_clip(drawing->cairo);
    cairo_translate(drawing->cairo, place[0], place[1]);
    draw_bodies(drawing, &view);
    tinker_arrows_draw(drawing->cairo, &view, (const TinkerForceArrow *)(gpointer)part.arrows->data, part.arrows->len,
                       &options);
    draw_torques(&part, &turns, kinetic);
    diagram_write(drawing, (TinkerText){.text = heading, .size = DIAGRAM_TEXT, .bold = TRUE, .anchor_x = 0.5},
                  width / 2, 0);
    if (kinetic && !diagram_has_resultant(diagram) && !diagram_has_turning(diagram))
        diagram_write(drawing, (TinkerText){.text = _("m a = 0"), .size = DIAGRAM_TEXT, .anchor_x = 0.5}, width / 2,
                      height / 2 + fmin(BODY_SHARE * drawing->lesser, MOST_BODY) / 2 + DIAGRAM_EDGE);
    cairo_restore(drawing->cairo);
    g_array_unref(part.arrows);
    g_ptr_array_unref(part.texts);
}

/* All ----------------------------------------------------------------------------------------------------------------
 */

/* "Bob,  m = 2 kg,  t = 0.5 s"; in little room without the mass. */
static char *title_of(const DiagramDrawing *drawing, gboolean with_mass)
{
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME, kilograms = TINKER_DIMENSION_MASS;
    const TinkerDiagram *diagram = drawing->picture->diagram;
    g_autoptr(GString) names = g_string_new(NULL);
    for (const TinkerBlockId *block = drawing->picture->blocks; *block >= 0; block++)
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "",
                               tinker_scene_block_name(drawing->scene, *block));
    g_autofree char *time = diagram_quantity(drawing, diagram->time, seconds);
    g_autofree char *mass = diagram_quantity(drawing, diagram->mass, kilograms);
    return diagram->moves && with_mass ? g_strdup_printf("%s,  m = %s,  t = %s", names->str, mass, time)
                                       : g_strdup_printf("%s,  t = %s", names->str, time);
}

static double width_of(DiagramDrawing *drawing, const char *text, double size)
{
    const TinkerText one = {.text = text, .size = size, .bold = TRUE};
    double width, height;
    tinker_text_measure(&drawing->pen, &one, &width, &height);
    return width;
}

static void draw_title(DiagramDrawing *drawing, double width)
{
    g_autofree char *whole = title_of(drawing, TRUE), *brief = title_of(drawing, FALSE);
    const double room = fmax(width - 2 * DIAGRAM_EDGE, 1);
    const TinkerText title = {.text = width_of(drawing, whole, TITLE) <= room ? whole : brief,
                              .size = TITLE,
                              .bold = TRUE,
                              .keeps_end = TRUE,
                              .limit = room};
    diagram_write(drawing, title, DIAGRAM_EDGE, DIAGRAM_EDGE / 2);
}

void tinker_diagram_draw(cairo_t *cairo, double width, double height, void *data)
{
    const TinkerDiagramPicture *picture = data;
    DiagramDrawing drawing;
    diagram_begin(&drawing, picture, cairo);
    diagram_set_colour(cairo, picture->theme->background);
    cairo_paint(cairo);
    const double top = DIAGRAM_EDGE + TITLE + DIAGRAM_EDGE;
    const gboolean both = picture->kind == TINKER_DIAGRAM_BOTH && picture->diagram->moves;
    const double middle = both ? FREE_SHARE * width : picture->kind == TINKER_DIAGRAM_KINETIC ? 0 : width;
    const double aside = both ? ASIDE : 0;
    const double first = (middle > 0 ? middle : width) - aside; /* how wide the part is that is drawn first */
    drawing.numbered = first < NARROW_PART;
    drawing.brief = first < LEAST_PART;
    const double list = diagram_list_height(&drawing, width) + DIAGRAM_EDGE, bottom = fmax(height - list, height / 2);
    drawing.lesser = fmin(bottom - top, both ? width - middle - aside : width);
    const char *free_body = _("Free-body diagram"), *kinetic = _("Kinetic diagram");
    if (both && width_of(&drawing, kinetic, DIAGRAM_TEXT) > width - middle - aside) {
        free_body = _("Forces");
        kinetic = "m a";
    }
    draw_title(&drawing, width);
    if (middle > 0) draw_part(&drawing, (double[]){0, top, middle - aside, bottom}, free_body, FALSE);
    if (middle < width) draw_part(&drawing, (double[]){middle + aside, top, width, bottom}, kinetic, TRUE);
    if (both)
        diagram_write(&drawing, (TinkerText){.text = "=", .size = EQUALS, .anchor_x = 0.5, .anchor_y = 0.5}, middle,
                      (top + bottom) / 2);
    diagram_draw_list(&drawing, (double[]){0, bottom, width, height});
    diagram_end(&drawing);
}

TinkerFrame *tinker_diagram_frame(TinkerScene *scene, const TinkerModelState *state, GError **error)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    if (frame == NULL || !tinker_frame_set_time(frame, state->time, error)) return NULL;
    for (guint i = 0; i < state->bodies->len; i++) {
        const TinkerBodyState *body = &g_array_index(state->bodies, TinkerBodyState, i);
        double x, y, orientation;
        tinker_frame_centre(frame, body->block, &x, &y, &orientation);
        if (!isnan(body->at.orientation)) orientation = body->at.orientation;
        tinker_frame_place(frame, body->block, body->at.x, body->at.y, orientation);
    }
    return g_steal_pointer(&frame);
}

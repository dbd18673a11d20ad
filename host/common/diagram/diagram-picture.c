/* A diagram on its paper: the title, its parts beside each other, each with the bodies and their arrows, and the list
 * below. */
#include "common/diagram/diagram-picture-private.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

/* Canvas units. */
#define TITLE       15.0
#define EQUALS      26.0 /* the size of the sign between the diagrams, */
#define ASIDE       18.0 /* and half of the room for it */
#define MOST_ARROW  200.0
#define NARROW_PART 330.0 /* of the paper: below it arrows have numbers in place of names, as the list has, */
#define LEAST_PART  170.0 /* and below this no values */

#define ARROW_SHARE 0.36 /* of the lesser side of its part of the paper */
#define FREE_SHARE  0.58 /* of the width, for the free-body diagram where both are drawn */
#define WIDE_ARROWS                                                                                                    \
    1.25 /* of the width of a part, which arrows go across from its middle, to the height that they want */

static void draw_part(DiagramDrawing *drawing, const double place[4], const char *heading, gboolean kinetic)
{
    const double width = place[2] - place[0], height = place[3] - place[1];
    const TinkerView view = diagram_view(drawing, width, height);
    const TinkerDiagram *diagram = drawing->picture->diagram;
    DiagramPart part = {.drawing = drawing,
                        .view = &view,
                        .longest = fmin(ARROW_SHARE * drawing->lesser, MOST_ARROW),
                        .arrows = g_array_new(FALSE, TRUE, sizeof(TinkerForceArrow)),
                        .texts = g_ptr_array_new_with_free_func(g_free)};
    if (!kinetic) diagram_add_forces(&part);
    if (kinetic && diagram_has_resultant(diagram)) diagram_add_resultant(&part);
    const DiagramTurns turns = diagram_turns(&part, kinetic);
    double taken[2][4] = {{0, 0, width, DIAGRAM_HEADING}};
    memcpy(taken[1], turns.labels, sizeof taken[1]);
    g_autoptr(GArray) drawn = diagram_drawn_boxes(drawing, &view);
    const double reach = turns.least + DIAGRAM_TURN_STEP * turns.count;
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    const gboolean tells = !kinetic && drawing->picture->spots != NULL;
    const double arcs[] = {turns.at[0] - reach, turns.at[1] - reach, turns.at[0] + reach, turns.at[1] + reach};
    if (turns.count > 0) g_array_append_vals(drawn, arcs, 1);
    const TinkerArrowOptions options = {.theme = drawing->picture->theme,
                                        .scale = 1,
                                        .taken = (const double(*)[4])taken,
                                        .taken_count = turns.count > 0 ? 2 : 1,
                                        .drawn = (const double(*)[4])(gpointer)drawn->data,
                                        .drawn_count = (int)drawn->len,
                                        .roomy = TRUE,
                                        .places = tells ? places : NULL};
    cairo_save(drawing->cairo);
    cairo_rectangle(drawing->cairo, place[0], place[1], width, height);
    cairo_clip(drawing->cairo);
    cairo_translate(drawing->cairo, place[0], place[1]);
    diagram_draw_bodies(drawing, &view);
    tinker_arrows_draw(drawing->cairo, &view, (const TinkerForceArrow *)(gpointer)part.arrows->data, part.arrows->len,
                       &options);
    if (tells) diagram_add_spots(&part, places, place);
    diagram_draw_turns(&part, &turns, kinetic);
    diagram_write(drawing, (TinkerText){.text = heading, .size = DIAGRAM_TEXT, .bold = TRUE, .anchor_x = 0.5},
                  width / 2, 0);
    if (kinetic && !diagram_has_resultant(diagram) && !diagram_has_turning(diagram))
        diagram_write(drawing, (TinkerText){.text = _("m a = 0"), .size = DIAGRAM_TEXT, .anchor_x = 0.5}, width / 2,
                      height / 2 + diagram_body_room(drawing) / 2 + DIAGRAM_EDGE);
    cairo_restore(drawing->cairo);
    g_array_unref(part.arrows);
    g_ptr_array_unref(part.texts);
}

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

static void draw_title(DiagramDrawing *drawing, double width)
{
    g_autofree char *whole = title_of(drawing, TRUE), *brief = title_of(drawing, FALSE);
    const double room = fmax(width - 2 * DIAGRAM_EDGE, 1);
    const TinkerText as_whole = {.text = whole, .size = TITLE, .bold = TRUE};
    const TinkerText title = {.text = tinker_text_width(&drawing->pen, &as_whole) <= room ? whole : brief,
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
    drawing.lesser = fmin(bottom - top, WIDE_ARROWS * (both ? width - middle - aside : width));
    const char *free_body = _("Free-body diagram"), *kinetic = _("Kinetic diagram");
    if (both && diagram_text_width(&drawing, kinetic, TRUE) > width - middle - aside) {
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

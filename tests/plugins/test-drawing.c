/* Drawings: which colours, where, and whether all stays in the bounds that the block declares. */
#include <math.h>
#include <string.h>

#include "drawing-stage.h"

static void test_connector(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    stage_draw(&stage);
    const char *helper = strcmp(data, "spring") == 0 ? "coil" : strcmp(data, "rod") == 0 ? "bar" : "dashpot";
    stage_assert_line(stage_note(&stage, helper, 0), 1, 2, 4, 6);
    g_assert_cmpint(stage_note(&stage, "end_mark", 0)->edge, ==, 1);
    g_assert_cmpint(stage_note(&stage, "end_mark", 1)->edge, ==, 0);
    g_assert_cmpfloat(stage_note(&stage, "end_mark", 1)->x1, ==, 4);
    stage.ends[1] = stage.ends[0];
    stage_draw(&stage);
}

/* From (1, 2) 3 m towards (4, 6), which are 5 m away: the plate stands at (2.8, 4.4), and a shorter one where the other
 * end is, which it meets as soon as the bumper is as long as that. */
static void test_bumper(void)
{
    Stage stage;
    stage_init(&stage, "bumper");
    stage_set(&stage, "length", 3);
    stage_draw(&stage);
    const Note *plate = stage_note(&stage, "line", 0), *pushes = stage_note(&stage, "line", 1);
    stage_assert_line(stage_note(&stage, "coil", 0), 1, 2, 2.8, 4.4);
    g_assert_cmpfloat_with_epsilon((plate->x1 + plate->x2) / 2, 2.8, 1e-12);
    g_assert_cmpfloat_with_epsilon((pushes->x1 + pushes->x2) / 2, 4, 1e-12);
    g_assert_cmpfloat_with_epsilon((pushes->y1 + pushes->y2) / 2, 6, 1e-12);
    g_assert_cmpfloat_with_epsilon(3 * (pushes->x2 - pushes->x1) + 4 * (pushes->y2 - pushes->y1), 0, 1e-12);
    g_assert_cmpfloat(hypot(pushes->x2 - pushes->x1, pushes->y2 - pushes->y1), <,
                      hypot(plate->x2 - plate->x1, plate->y2 - plate->y1));
    stage_set(&stage, "length", 6);
    stage_draw(&stage);
    g_assert_cmpint(stage_notes(&stage, "line"), ==, 1);
    g_assert_cmpfloat_with_epsilon((stage_note(&stage, "line", 0)->x1 + stage_note(&stage, "line", 0)->x2) / 2, 4,
                                   1e-12);
}

/* Over two wheels, up, across and down: strands touch the wheels on the outside, from a radius below each mass's line
 * to one above the wheels, and what lies on a wheel is as far from its centre as that is large. */
static void test_rope(void)
{
    const double radius = 0.5 * SYMBOL;
    Stage stage;
    stage_init(&stage, "rope");
    stage.instance.ends = 4;
    const TinkerEnd ends[4] = {{-1, -3, 1, 0, 0}, {-1, 0, 1, 0, 0}, {2, 0, 1, 0, 0}, {2, -4, 0, 0, 0}};
    memcpy(stage.ends, ends, sizeof ends);
    stage_set(&stage, "length", 10);
    stage_draw(&stage);
    for (int wheel = 0; wheel < 2; wheel++) {
        g_assert_cmpfloat(stage_note(&stage, "circle", wheel)->x1, ==, wheel == 0 ? -1 : 2);
        g_assert_cmpfloat(stage_note(&stage, "circle", wheel)->number, ==, radius);
    }
    const Note *up = stage_note(&stage, "line", 0);
    g_assert_cmpfloat(up->x1, ==, -1);
    g_assert_cmpfloat(up->y1, ==, -3);
    g_assert_cmpfloat(up->x2, <, -1);
    g_assert_cmpint(up->colour, ==, TINKER_COLOUR_CONNECTOR);
    for (int i = 0; i < stage.recorder.count; i++) {
        const Note *line = &stage.recorder.notes[i];
        if (strcmp(line->helper, "line") != 0) continue;
        /* nowhere does the rope cut into a wheel, but for the chords of its arcs */
        for (int wheel = 0; wheel < 2; wheel++) {
            const double x = wheel == 0 ? -1 : 2;
            g_assert_cmpfloat(tinker_segment_distance(x, 0, line->x1, line->y1, line->x2, line->y2), >, 0.98 * radius);
        }
    }
    /* the middle strand is the common tangent above */
    stage_assert_line(stage_note(&stage, "line", 13), -1, radius, 2, radius);
    stage_set(&stage, "length", 10.1);
    stage_draw(&stage);
    g_assert_cmpint(stage_note(&stage, "line", 0)->colour, ==, TINKER_COLOUR_COMPRESSED);
}

/* On a wheel of radius 3 about (1, 2), of which (4, 6) is 5 away: 4 m are free. Longer, it hangs from where it leaves
 * the wheel; where its length is not known it is drawn straight. */
static void test_cord(void)
{
    Stage stage;
    stage_init(&stage, "cord");
    stage_set(&stage, "radius", 3);
    const double lengths[] = {4, NAN, 5};
    for (size_t i = 0; i < G_N_ELEMENTS(lengths); i++) {
        stage_set(&stage, "length", lengths[i]);
        stage_draw(&stage);
        const Note *free = stage_note(&stage, i < 2 ? "line" : "polyline", i < 2 ? 0 : 1);
        stage_assert_line(free, 1 + 3 * -0.28, 2 + 3 * 0.96, 4, 6);
        g_assert_cmpint(free->colour, ==, i < 2 ? TINKER_COLOUR_CONNECTOR : TINKER_COLOUR_COMPRESSED);
    }
}

/* A ring about its end; behind it the path, which goes on to where it is now. */
static void test_marker(void)
{
    const double path[6] = {-7, 3, 2, 8, 1, 5};
    Stage stage;
    stage_init(&stage, "marker");
    stage_draw(&stage);
    g_assert_cmpfloat(stage_note(&stage, "circle", 0)->x1, ==, 1);
    g_assert_cmpfloat(stage_note(&stage, "circle", 0)->y1, ==, 2);
    g_assert_cmpint(stage_note(&stage, "circle", 0)->colour, ==, -1);
    g_assert_cmpint(stage.recorder.count, ==, 6); /* with four ticks, and the mark of its end */
    stage.instance.path = path;
    stage.instance.path_count = 3;
    stage_draw(&stage);
    g_assert_cmpfloat(stage_note(&stage, "polyline", 0)->number, ==, 3);
    stage_assert_line(stage_note(&stage, "polyline", 0), -7, 3, 1, 5);
    stage_assert_line(stage_note(&stage, "polyline", 1), 1, 5, 1, 2);
}

/* Red, black, blue; black within a millionth of the rest length. The spring is 5 m long. */
static void test_spring_colours(void)
{
    static const struct {
        double rest_length;
        int32_t colour;
    } rows[] = {{6, TINKER_COLOUR_COMPRESSED},
                {5 * (1 + 2e-6), TINKER_COLOUR_COMPRESSED},
                {5 * (1 + 0.5e-6), TINKER_COLOUR_CONNECTOR},
                {5, TINKER_COLOUR_CONNECTOR},
                {5 * (1 - 0.5e-6), TINKER_COLOUR_CONNECTOR},
                {5 * (1 - 2e-6), TINKER_COLOUR_STRETCHED},
                {4, TINKER_COLOUR_STRETCHED},
                {0, TINKER_COLOUR_STRETCHED}};
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        Stage stage;
        stage_init(&stage, "spring");
        stage_set(&stage, "rest_length", rows[i].rest_length);
        stage_draw(&stage);
        g_assert_cmpint(stage_note(&stage, "coil", 0)->colour, ==, rows[i].colour);
        g_assert_cmpfloat(stage_note(&stage, "coil", 0)->number, ==, rows[i].rest_length);
    }
}

static void test_mass(void)
{
    Stage stage;
    stage_init(&stage, "mass");
    stage.instance.orientation = 0.7;
    stage_draw(&stage);
    const Note *drawn = stage_note(&stage, "box", 0);
    stage_assert_line(drawn, 1, 2, 0.8, 0.8);
    g_assert_cmpint(drawn->colour, ==, TINKER_COLOUR_BODY);
    g_assert_cmpint(drawn->edge, ==, TINKER_COLOUR_BODY_EDGE);
    g_assert_cmpfloat(drawn->number, ==, 0.7);
    stage_set(&stage, "width", 0);
    stage_set(&stage, "height", 0);
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "box", 0), 1, 2, 0, 0);
}

/* The solid line is the top, the hatching on its right-hand side, which is inside the slab. */
static void test_support(void)
{
    Stage stage;
    stage_init(&stage, "support");
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "line", 0), -1, 2.2, 3, 2.2);
    stage_assert_line(stage_note(&stage, "hatch", 0), -1, 2.2, 3, 2.2);
    stage.instance.orientation = PI; /* a ceiling: the top faces down, the hatching lies above */
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "line", 0), 3, 1.8, -1, 1.8);
    stage.instance.orientation = 0.6;
    stage_draw(&stage);
    stage_set(&stage, "solid", 0);
    stage_draw(&stage);
    g_assert_cmpint(stage_note(&stage, "circle", 0)->edge, ==, TINKER_COLOUR_BODY_EDGE);
    g_assert_cmpfloat(stage_note(&stage, "line", 0)->x1, ==, 1);
    stage_set(&stage, "width", 0);
    stage_set(&stage, "height", 0);
    stage_draw(&stage);
    stage_set(&stage, "solid", 1);
    stage_draw(&stage);
}

/* From the body along the force; it turns round with the sign, and is as long as the force is large. */
static void test_motor(void)
{
    Stage stage;
    stage_init(&stage, "motor");
    stage_set(&stage, "amplitude", 4);
    stage_set(&stage, "waveform", 4);
    stage_draw(&stage);
    const Note full = *stage_note(&stage, "arrow", 0);
    g_assert_cmpint(full.colour, ==, TINKER_COLOUR_FORCE);
    stage_assert_line(&full, 1, 2, full.x2, 2);
    g_assert_cmpfloat(full.x2, >, 1);
    stage_set(&stage, "waveform", -2);
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "arrow", 0), 1, 2, 1 - (full.x2 - 1) / 2, 2);
    stage_set(&stage, "angle", PI / 2);
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "arrow", 0), 1, 2, 1, 2 - (full.x2 - 1) / 2);
    stage_set(&stage, "waveform", 400); /* an expression goes beyond the amplitude: the arrow does not */
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "arrow", 0), 1, 2, 1, 2 + (full.x2 - 1));
    stage_set(&stage, "waveform", 0); /* no force, no head, but something to be seen */
    stage_draw(&stage);
    g_assert_cmpfloat(stage_note(&stage, "line", 0)->y2, >, 2);
    stage_set(&stage, "amplitude", 0);
    stage_draw(&stage);
}

static void test_support_motion(void)
{
    Stage stage;
    stage_init(&stage, "support-motion");
    stage_set(&stage, "angle", PI / 2);
    stage_draw(&stage);
    const Note *down = stage_note(&stage, "arrow", 0), *up = stage_note(&stage, "arrow", 1);
    g_assert_cmpint(up->colour, ==, TINKER_COLOUR_MOTION);
    g_assert_cmpfloat(up->x2, ==, 1);
    g_assert_cmpfloat(up->y2, >, 2);
    g_assert_cmpfloat_with_epsilon(up->y2 - 2, 2 - down->y2, 1e-14);
}

static void test_fields(void)
{
    Stage stage;
    stage_init(&stage, "gravity");
    stage_draw(&stage);
    const Note *arrow_down = stage_note(&stage, "arrow", 0);
    g_assert_cmpfloat(arrow_down->x1, ==, arrow_down->x2);
    g_assert_cmpfloat(arrow_down->y2, <, arrow_down->y1);
    g_assert_cmpint(arrow_down->colour, ==, TINKER_COLOUR_FIELD);
    g_assert_cmpfloat(stage_note(&stage, "text", 0)->number, ==, 1);
    stage_set(&stage, "angle", 0.9);
    stage_draw(&stage);
    stage_init(&stage, "wind");
    stage_draw(&stage);
    stage_note(&stage, "circle", 0);
    for (int k = 0; k < 12; k++) {
        const int32_t column = block_column(block_open("wind"), "velocity");
        stage.columns[column] = 5 * cos(k * PI / 6);
        stage.columns[column + 1] = 5 * sin(k * PI / 6);
        stage_draw(&stage);
        const Note *middle = stage_note(&stage, "arrow", 1);
        g_assert_cmpfloat_with_epsilon(middle->x2 - middle->x1, 2 * SYMBOL * cos(k * PI / 6), 1e-14);
        g_assert_cmpfloat_with_epsilon(middle->y2 - middle->y1, 2 * SYMBOL * sin(k * PI / 6), 1e-14);
        stage_note(&stage, "arrow", 2);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_data_func("/plugins/drawing/spring", "spring", test_connector);
    g_test_add_data_func("/plugins/drawing/damper", "damper", test_connector);
    g_test_add_data_func("/plugins/drawing/rod", "rod", test_connector);
    g_test_add_func("/plugins/drawing/spring/colours", test_spring_colours);
    g_test_add_func("/plugins/drawing/mass", test_mass);
    g_test_add_func("/plugins/drawing/support", test_support);
    g_test_add_func("/plugins/drawing/motor", test_motor);
    g_test_add_func("/plugins/drawing/bumper", test_bumper);
    g_test_add_func("/plugins/drawing/rope", test_rope);
    g_test_add_func("/plugins/drawing/cord", test_cord);
    g_test_add_func("/plugins/drawing/marker", test_marker);
    g_test_add_func("/plugins/drawing/support-motion", test_support_motion);
    g_test_add_func("/plugins/drawing/fields", test_fields);
    return g_test_run();
}

/* Drawings of joints: where their symbols are, and gears measured tooth by tooth. */
#include <math.h>

#include "drawing-stage.h"

/* The symbol of what ties turning is about this place, and nothing is drawn to where its ends are. */
static void assert_symbol_at(const Stage *stage, double x, double y)
{
    g_assert_cmpint(stage_notes(stage, "end_mark"), ==, 0);
    for (int i = 0; i < stage->recorder.count; i++) {
        const Note *drawn = &stage->recorder.notes[i];
        g_assert_cmpfloat(hypot(drawn->x1 - x, drawn->y1 - y), <=, 2 * SYMBOL);
        g_assert_cmpfloat(hypot(drawn->x2 - x, drawn->y2 - y), <=, 2 * SYMBOL);
    }
}

/* At the first end, or at the end on what stands; the line between ends that lie 5 m apart is there only while it is
 * selected, or one is loose. */
static void test_turns(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    stage.ends[1].attached = 1;
    stage.instance.x = 2.5;
    stage.instance.y = 4;
    stage_draw(&stage);
    assert_symbol_at(&stage, 1, 2);
    stage.ends[1].attached = TINKER_ATTACHED_TO_SUPPORT;
    stage_draw(&stage);
    assert_symbol_at(&stage, 4, 6);
    stage.state = TINKER_STATE_SELECTED;
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "line", 0), 1, 2, 4, 6);
    stage.state = 0;
    stage.ends[0].attached = 0;
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "line", 0), 1, 2, 4, 6);
    g_assert_cmpint(stage_note(&stage, "end_mark", 0)->edge, ==, 0);
}

/* Whether the arrow of a drive goes counter-clockwise about its place. */
static int goes_left(const Stage *stage, double x, double y)
{
    const Note *head = stage_note(stage, "arrow", 0);
    return (head->x1 - x) * (head->y2 - y) - (head->y1 - y) * (head->x2 - x) > 0;
}

/* The arrow is that of what moves, whichever end that is. */
static void test_drive_arrow(void)
{
    Stage stage;
    stage_init(&stage, "drive");
    stage.ends[1].attached = 1;
    stage_set(&stage, "speed", 3);
    stage.ends[1].attached = TINKER_ATTACHED_TO_SUPPORT;
    stage_draw(&stage);
    g_assert_true(goes_left(&stage, 4, 6));
    stage.ends[0].attached = TINKER_ATTACHED_TO_SUPPORT;
    stage.ends[1].attached = 1;
    stage_draw(&stage);
    g_assert_false(goes_left(&stage, 1, 2));
}

/* Gears ------------------------------------------------------------------------------------------------------------ */

/* How far a wheel's outline, drawn about (x, y), is out in a direction: 1 where it has a tooth, -1 in a gap. */
static int tooth_at(const Note *outline, double x, double y, double angle, double radius)
{
    for (int k = 0; k + 1 < (int)outline->number; k++) {
        const double *p = outline->points + 2 * k;
        const double from = atan2(p[1] - y, p[0] - x), to = atan2(p[3] - y, p[2] - x);
        const double way = remainder(to - from, 2 * PI), at = remainder(angle - from, 2 * PI);
        if (at < 0 || at > way) continue;
        const double share = at / way;
        return hypot(p[0] + share * (p[2] - p[0]) - x, p[1] + share * (p[3] - p[1]) - y) > radius ? 1 : -1;
    }
    g_error("no line of the outline lies at %g", angle);
}

/* Changes from gap to tooth, once round. */
static int teeth_of(const Note *outline, double x, double y, double radius)
{
    int teeth = 0;
    for (int k = 0; k + 1 < (int)outline->number; k++) {
        const double *p = outline->points + 2 * k;
        teeth += hypot(p[0] - x, p[1] - y) < radius && hypot(p[2] - x, p[3] - y) > radius;
    }
    return teeth;
}

/* The radius about which the outline goes, from its least and greatest. */
static double pitch_radius(const Note *outline, double x, double y)
{
    double least = INFINITY, most = 0;
    for (int k = 0; k < (int)outline->number; k++) {
        const double out = hypot(outline->points[2 * k] - x, outline->points[2 * k + 1] - y);
        least = fmin(least, out);
        most = fmax(most, out);
    }
    return 0.5 * (least + most);
}

typedef struct {
    double ratio;
    int internal;
    double turned; /* of the first wheel, rad */
} GearCase;

/* Wheels at (1, 2) and (4, 6), 5 m apart: radii in the ratio, whose sum, or of internal wheels difference, is 5 m;
 * numbers of teeth in it too, so that one pitch fits both; and on either side of the place where the pitch circles
 * touch, where one wheel has a tooth the other one has a gap, or inside a ring the same. */
static void check_gear(const GearCase *gear)
{
    Stage stage;
    stage_init(&stage, "gear");
    stage.instance.ends = 2;
    stage_set(&stage, "ratio", gear->ratio);
    stage_set(&stage, "internal", gear->internal);
    stage.ends[0].angle = gear->turned;
    stage.ends[1].angle = (gear->internal ? gear->ratio : -gear->ratio) * gear->turned;
    stage_draw(&stage);
    const Note *first = stage_note(&stage, "polyline", 0), *second = stage_note(&stage, "polyline", 1);
    const double r1 = pitch_radius(first, 1, 2), r2 = pitch_radius(second, 4, 6);
    g_assert_cmpfloat_with_epsilon(r1 / r2, gear->ratio, 1e-12);
    g_assert_cmpfloat_with_epsilon(gear->internal ? fabs(r1 - r2) : r1 + r2, 5, 1e-12);
    const int n1 = teeth_of(first, 1, 2, r1), n2 = teeth_of(second, 4, 6, r2);
    g_assert_cmpint(MIN(n1, n2), >=, 8);
    g_assert_cmpfloat_with_epsilon(n1 * r2, n2 * r1, 1e-12 * n1 * r2);
    const double way = atan2(4, 3); /* from the first to the second, and to where they touch */
    const double touch = gear->internal && r1 < r2 ? way + PI : way;
    for (int k = -7; k <= 7; k++) {
        if (k == 0) continue;                                      /* there edges may lie */
        const double along = (k + 0.01) / 16.0 * 2 * PI * r1 / n1; /* of the pitch, to the left seen from the first */
        const double at1 = touch + along / r1;
        const double at2 = gear->internal ? touch + along / r2 : touch + PI - along / r2;
        const int one = tooth_at(first, 1, 2, at1, r1), other = tooth_at(second, 4, 6, at2, r2);
        if ((gear->internal ? one : -one) != other)
            g_error("ratio %g, internal %d, turned %g: at %d/16 of a pitch %d and %d", gear->ratio, gear->internal,
                    gear->turned, k, one, other);
    }
}

static void test_gear(void)
{
    static const GearCase cases[] = {{1, 0, 0},    {2, 0, 0.3},   {0.5, 0, -1.7}, {1.5, 0, 0.9},  {0.375, 0, 2.2},
                                     {0.25, 1, 0}, {0.4, 1, 1.1}, {3, 1, -0.6},   {2.5, 1, 4.045}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        check_gear(&cases[i]);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_data_func("/plugins/drawing/drive", "drive", test_turns);
    g_test_add_data_func("/plugins/drawing/torsional-spring", "torsional-spring", test_turns);
    g_test_add_data_func("/plugins/drawing/torsional-damper", "torsional-damper", test_turns);
    g_test_add_func("/plugins/drawing/drive/arrow", test_drive_arrow);
    g_test_add_func("/plugins/drawing/gear", test_gear);
    return g_test_run();
}

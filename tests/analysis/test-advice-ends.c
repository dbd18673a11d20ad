/* Advice about ends: those that are loose, the wrong way round, or on what they do nothing to. */
#include <math.h>
#include <string.h>

#include "advice-checks.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"

/* Two masses, a box of half width 0.2 about x = 3.2 and a point, and a spring whose second end is loose at (x, 0). */
static StartFixture *with_loose_end(double x)
{
    g_autofree char *blocks =
        g_strdup_printf("{'type': 'support', 'name': 'Far', 'position': [0, 0]},"
                        "{'type': 'mass', 'name': 'Near', 'position': [3.2, 0], 'width': 0.4},"
                        "{'type': 'mass', 'name': 'Point', 'position': [2.7, 0.4], 'width': 0, 'height': 0},"
                        "{'type': 'spring', 'ends': ['Far', [%g, 0]]}",
                        x);
    return start_fixture_new(blocks);
}

static void test_detached_end(void)
{
    g_autoptr(StartFixture) f = with_loose_end(2.8);
    advice_assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Spring 0", "end 2", "Connect it to Near");
    g_autoptr(StartFixture) g = with_loose_end(3.1);
    advice_repair(g);
    g_assert_cmpint(tinker_scene_end(g->scene, start_fixture_block(g, "Spring 0"), 1).block, ==,
                    start_fixture_block(g, "Near"));
    g_autoptr(StartFixture) h = with_loose_end(1e3);
    advice_assert_only(h, TINKER_ADVICE_DETACHED_END, TRUE, "Spring 0", "end 2", NULL);
    g_autoptr(GPtrArray) all = tinker_advice_new(h->scene);
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_advice_repair(h->history, h->scene, g_ptr_array_index(all, 0), &error));
    start_fixture_assert_untouched(h);
}

/* A loose end of a pin is connected where it lies, not to the centre. */
static void test_loose_pin(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'support'}, {'type': 'bar', 'position': [0.5, 0]},"
                                                  "{'type': 'pin', 'ends': ['Support 0', [0, 0]]}");
    advice_assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Pin 0", "is not connected", "Connect it to Bar 0");
    advice_repair(f);
    const TinkerSceneEnd end = tinker_scene_end(f->scene, start_fixture_block(f, "Pin 0"), 1);
    g_assert_cmpfloat(end.x, ==, -0.5);
}

/* What it is connected to lies under it, and above what else does: a drive of a crank with its other end over bearing,
 * coupler and rod gets the bearing, which is drawn above them; nothing is offered that lies 0.3 m away, on a canvas of
 * 10 m. A disc is as large as its radius. */
static void test_loose_end_finds_what_is_under_it(void)
{
    static const char *const blocks =
        "{'type': 'support', 'name': 'Bearing', 'solid': false, 'width': 0.3, 'height': 0.2},"
        "{'type': 'bar', 'name': 'Coupler', 'position': [0, 0.03], 'width': 0.1},"
        "{'type': 'bar', 'name': 'Crank', 'position': [0.5, 0], 'width': 0.1},"
        "{'type': 'disc', 'name': 'Wheel', 'position': [3, 0], 'radius': 1},"
        "{'type': 'drive', 'ends': ['Crank', [%g, %g]]}";
    static const struct {
        double x, y;
        const char *repair;
    } cases[] = {{0, 0.02, "Connect it to Bearing"}, {0.3, 0.04, "Connect it to Coupler"},
                 {0.3, 0.38, "Add a support there"}, {2.4, 0.7, "Connect it to Wheel"},
                 {2.2, 0.9, "Connect it to Wheel"},  {2.2, 1.1, "Add a support there"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = g_strdup_printf(blocks, cases[i].x, cases[i].y);
        g_autoptr(StartFixture) f = start_fixture_new(text);
        advice_assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Drive 0", "is not connected", cases[i].repair);
    }
}

/* A loose end over a long plate stays where it was drawn, far from the plate's centre; at a pivot it goes to that. */
static void test_loose_end_at_a_support(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support', 'width': 8}, {'type': 'mass', 'position': [0, 2]},"
                          "{'type': 'spring', 'ends': ['Mass 0', [-3, 0.4]]}");
    advice_repair(f);
    const TinkerSceneEnd plate = tinker_scene_end(f->scene, start_fixture_block(f, "Spring 0"), 1);
    g_assert_cmpint(plate.block, ==, start_fixture_block(f, "Support 0"));
    physics_assert_near("x", plate.x, -3, 1e-12);
    physics_assert_near("y", plate.y, 0.4, 1e-12);
    g_autoptr(StartFixture) g =
        start_fixture_new("{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 2]},"
                          "{'type': 'spring', 'ends': ['Mass 0', [0, 0.3]]}");
    advice_repair(g);
    const TinkerSceneEnd pivot = tinker_scene_end(g->scene, start_fixture_block(g, "Spring 0"), 1);
    g_assert_cmpint(pivot.block, ==, start_fixture_block(g, "Support 0"));
    g_assert_true(pivot.x == 0 && pivot.y == 0);
}

/* A pendulum's pin without anything to hold on to gets a pivot where it is; a spring that hangs from nothing, too. */
static void test_support_is_added(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'bar', 'position': [0.5, 2]},"
                          "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [-0.5, 0]}, [0, 2]]}");
    advice_assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Pin 0", "is not connected", "Add a support there");
    advice_repair(f);
    const TinkerSceneEnd end = tinker_scene_end(f->scene, start_fixture_block(f, "Pin 0"), 1);
    g_assert_cmpint(end.block, ==, start_fixture_block(f, "Support 0"));
    physics_assert_near("x", start_fixture_get(f, "Support 0", TINKER_MEANING_POSITION, 0), 0, 0);
    physics_assert_near("y", start_fixture_get(f, "Support 0", TINKER_MEANING_POSITION, 1), 2, 0);
    physics_assert_near("solid", start_fixture_get(f, "Support 0", TINKER_MEANING_SOLID, 0), 0, 0);
    g_autoptr(GPtrArray) rest = tinker_advice_new(f->scene);
    g_assert_cmpuint(rest->len, ==, 0);
}

/* A cord from a mass to a disc is the wrong way round; swapped, the scene compiles. With a radius of its own it is as
 * meant. */
static void test_wound_ends(void)
{
    static const char *const blocks =
        "{'type': 'disc', 'position': [0, 0], 'name': 'Wheel'}, {'type': 'mass', 'name': 'M', 'position': "
        "[0, -2]}, {'type': 'cord', 'name': 'Line', 'ends': ['M', 'Wheel']%s}";
    g_autofree char *wrong = g_strdup_printf(blocks, ""), *meant = g_strdup_printf(blocks, ", 'radius': 0.1");
    g_autoptr(StartFixture) f = start_fixture_new(wrong);
    advice_assert_only(f, TINKER_ADVICE_WOUND_ENDS, TRUE, "Line", "M is not round", "Swap its ends");
    advice_repair(f);
    const TinkerBlockId line = start_fixture_block(f, "Line");
    g_assert_cmpint(tinker_scene_end(f->scene, line, 0).block, ==, start_fixture_block(f, "Wheel"));
    g_assert_cmpint(tinker_scene_end(f->scene, line, 1).block, ==, start_fixture_block(f, "M"));
    g_autoptr(StartFixture) g = start_fixture_new(meant);
    g_autoptr(GPtrArray) none = tinker_advice_new(g->scene);
    for (guint i = 0; i < none->len; i++)
        g_assert_cmpint(((const TinkerAdvice *)g_ptr_array_index(none, i))->kind, !=, TINKER_ADVICE_WOUND_ENDS);
}

/* A rope over the centre of a disc does not run round it, which the picture would have one think; an eye on its rim, a
 * support and a bar are no wheels. */
static void test_small_wheel(void)
{
    static const char *const blocks =
        "{'type': 'support', 'name': 'Hook', 'position': [0, 3], 'solid': false},"
        "{'type': 'disc', 'name': 'Wheel', 'position': [2, 3]}, {'type': 'bar', 'name': 'Bar', 'position': [5, 3]},"
        "{'type': 'mass', 'name': 'A', 'position': [-1, 0]}, {'type': 'mass', 'name': 'B', 'position': [8, 0]},"
        "{'type': 'rope', 'name': 'Line', 'ends': ['A', 'Hook', %s, 'Bar', 'B']}";
    g_autofree char *centre = g_strdup_printf(blocks, "'Wheel'");
    g_autofree char *rim = g_strdup_printf(blocks, "{'block': 'Wheel', 'at': [0, 0.4]}");
    g_autoptr(StartFixture) f = start_fixture_new(centre);
    advice_assert_only(f, TINKER_ADVICE_SMALL_WHEEL, FALSE, "Line", "small wheel at the centre of Wheel", NULL);
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, NULL);
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 1);
    g_assert_cmpstr(tinker_warnings_text(tinker_model_warnings(model), 0), ==,
                    advice_only(all, TINKER_ADVICE_SMALL_WHEEL)->message);
    g_autoptr(StartFixture) g = start_fixture_new(rim);
    g_autoptr(GPtrArray) none = tinker_advice_new(g->scene);
    g_assert_cmpuint(none->len, ==, 0);
}

/* What acts on angles alone does nothing to a mass, and between two ends of one disc; a support and a second disc are
 * turned against. */
static void test_idle_turns(void)
{
    static const char *const blocks =
        "{'type': 'mass', 'name': 'M', 'position': [0, 3]}, {'type': 'disc', 'position': [0, 0], 'name': "
        "'D'}, {'type': 'disc', 'name': 'E', 'position': [3, 0]}, {'type': 'support', "
        "'name': 'S', 'position': [0, -3]}, {'type': '%s', 'name': 'By', 'ends': %s}";
    static const struct {
        const char *type, *ends, *part;
    } cases[] = {
        {"torque", "['M']", "By: it acts on angles alone, and M is a point"},
        {"torsional-spring", "['D', 'M']", "By: it acts on angles alone, and M is a point"},
        {"torsional-damper", "['M', 'S']", "By: it acts on angles alone, and M is a point"},
        {"gear", "['D', 'D']", "By: two of its ends are on D"},
        {"torsional-spring", "['E', {'block': 'E', 'at': [0.1, 0]}]", "By: two of its ends are on E"},
        {"torque", "['D', 'S']", NULL},
        {"torsional-spring", "['D', 'E']", NULL},
        {"gear", "['D', 'E', 'S']", NULL},
        {"spring", "['M', 'D']", NULL},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = g_strdup_printf(blocks, cases[i].type, cases[i].ends);
        g_autoptr(StartFixture) f = start_fixture_new(text);
        if (cases[i].part != NULL) advice_assert_only(f, TINKER_ADVICE_IDLE_TURN, FALSE, "By", cases[i].part, NULL);
        g_autoptr(TinkerModel) model = tinker_model_new(f->scene, NULL);
        g_assert_nonnull(model);
        g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
        g_assert_cmpuint(tinker_model_warnings(model)->len, ==, cases[i].part != NULL);
        g_assert_cmpuint(all->len, ==, cases[i].part != NULL);
        if (cases[i].part != NULL)
            g_assert_cmpstr(tinker_warnings_text(tinker_model_warnings(model), 0), ==,
                            advice_only(all, TINKER_ADVICE_IDLE_TURN)->message);
    }
}

static void add_tests(void)
{
    g_test_add_func("/advice-ends/detached-end", test_detached_end);
    g_test_add_func("/advice-ends/loose-pin", test_loose_pin);
    g_test_add_func("/advice-ends/loose-end-under", test_loose_end_finds_what_is_under_it);
    g_test_add_func("/advice-ends/loose-end-at-a-support", test_loose_end_at_a_support);
    g_test_add_func("/advice-ends/support-is-added", test_support_is_added);
    g_test_add_func("/advice-ends/wound-ends", test_wound_ends);
    g_test_add_func("/advice-ends/small-wheel", test_small_wheel);
    g_test_add_func("/advice-ends/idle-turns", test_idle_turns);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

/* What a hand on one coefficient of friction does to the other: what slides holds no better than what rests. */
#include "gui-fixture.h"

#include "gui/instrument/hand.h"
#include "scene/store/quantities.h"

typedef struct {
    GuiFixture *base;
    TinkerHand *hand;
} Fixture;

static Fixture *fixture_new(void)
{
    Fixture *fixture = g_new0(Fixture, 1);
    fixture->base = gui_fixture_new("");
    fixture->hand = tinker_hand_new(fixture->base->document, fixture->base->player);
    gui_fixture_start_scene(fixture->base, "'run': {'duration': 0.1}, 'blocks': [{'type': 'support', 'name': 'Floor', "
                                           "'static_friction': 0.3, 'dynamic_friction': 0.2}, {'type': 'mass', "
                                           "'name': 'M', 'position': [0, 3]}]");
    return fixture;
}

static void fixture_free(Fixture *fixture)
{
    tinker_hand_free(fixture->hand);
    gui_fixture_free(fixture->base);
    g_free(fixture);
}
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Fixture, fixture_free)

static double friction(GuiFixture *fixture, const char *name)
{
    TinkerScene *scene = tinker_document_scene(fixture->document);
    const TinkerBlockId floor = gui_fixture_block(fixture, "Floor");
    TinkerNumber number;
    g_assert_true(tinker_scene_find_number(scene, floor, name, &number));
    return tinker_scene_get(scene, floor, number.column);
}

static gboolean has_taken(void *data)
{
    Fixture *fixture = data;
    double wanted;
    const TinkerBlockId floor = gui_fixture_block(fixture->base, "Floor");
    return !tinker_hand_wanted(fixture->hand, floor, "dynamic_friction", &wanted) &&
           !tinker_hand_wanted(fixture->hand, floor, "static_friction", &wanted);
}

static void turn_friction(Fixture *fixture, const char *name, double to)
{
    tinker_hand_set(fixture->hand, gui_fixture_block(fixture->base, "Floor"), name, to);
    g_assert_true(gui_fixture_wait(has_taken, fixture));
    g_assert_cmpstr(tinker_hand_problem(fixture->hand), ==, NULL);
    g_assert_cmpfloat(friction(fixture->base, name), ==, to);
}

/* What slides holds no better than what rests: the other coefficient goes along where it has to, and comes back. */
static void test_friction_together(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    turn_friction(fixture, "dynamic_friction", 0.5);
    g_assert_cmpfloat(friction(fixture->base, "static_friction"), ==, 0.5);
    turn_friction(fixture, "dynamic_friction", 0.25);
    g_assert_cmpfloat(friction(fixture->base, "static_friction"), ==, 0.3);
    turn_friction(fixture, "static_friction", 0.1);
    g_assert_cmpfloat(friction(fixture->base, "dynamic_friction"), ==, 0.1);
    tinker_document_undo(fixture->base->document);
    g_assert_cmpfloat(friction(fixture->base, "dynamic_friction"), ==, 0.25);
    g_assert_cmpfloat(friction(fixture->base, "static_friction"), ==, 0.3);
}

static void check_carried(Fixture *fixture, const char *name, double before, double now)
{
    TinkerCarried carried;
    const gboolean is_carried =
        tinker_hand_carried(fixture->hand, gui_fixture_block(fixture->base, "Floor"), name, &carried);
    g_assert_cmpint(is_carried, ==, before != now);
    if (!is_carried) return;
    g_assert_cmpfloat(carried.before, ==, before);
    g_assert_cmpfloat(carried.now, ==, now);
}

/* A hand that takes the control a second time brings back what went along the first time, and it is told meanwhile; but
 * what was set in between by something else is the new place to come back to. */
static void test_friction_comes_back(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    turn_friction(fixture, "dynamic_friction", 0.25);
    check_carried(fixture, "dynamic_friction", 0.3, 0.3);
    turn_friction(fixture, "dynamic_friction", 0.5);
    check_carried(fixture, "dynamic_friction", 0.3, 0.5);
    check_carried(fixture, "static_friction", 0, 0);
    tinker_hand_let_go(fixture->hand);
    turn_friction(fixture, "dynamic_friction", 0.4);
    check_carried(fixture, "dynamic_friction", 0.3, 0.4);
    tinker_hand_let_go(fixture->hand);
    turn_friction(fixture, "dynamic_friction", 0.1);
    check_carried(fixture, "dynamic_friction", 0.3, 0.3);
    g_assert_cmpfloat(friction(fixture->base, "static_friction"), ==, 0.3);
    tinker_document_undo(fixture->base->document);
    g_assert_cmpfloat(friction(fixture->base, "static_friction"), ==, 0.4);
    tinker_hand_let_go(fixture->hand);
    turn_friction(fixture, "dynamic_friction", 0.2);
    g_assert_cmpfloat(friction(fixture->base, "static_friction"), ==, 0.4);
}

static void add_tests(void)
{
    g_test_add_func("/gui/hand-friction/together", test_friction_together);
    g_test_add_func("/gui/hand-friction/comes-back", test_friction_comes_back);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

/* The range and the step that a new control has: round numbers in the unit that is shown, about the value. */
#include "gui-fixture.h"

#include <math.h>

#include "gui/instrument/instrument-edit.h"

#define BLOCKS                                                                                                         \
    "{'type': 'support', 'name': 'Floor', 'orientation': '30 deg', 'static_friction': 0.35, 'dynamic_friction': 0.2}," \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1], 'mass': 1.7, 'velocity': [0, 2.345]},"                          \
    "{'type': 'spring', 'name': 'K', 'ends': ['Floor', 'M'], 'stiffness': 25}"

static const TinkerSceneInstrument *add(GuiFixture *fixture, const char *block, const char *name)
{
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_control_add(fixture->document, gui_fixture_block(fixture, block), name,
                                     &(TinkerInstrumentPlace){0}, &error));
    g_assert_no_error(error);
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(fixture->document));
    return g_ptr_array_index(all, all->len - 1);
}

static void test_round_steps(void)
{
    static const struct {
        const char *block, *name;
        double from, to, step;
    } cases[] = {{"K", "stiffness", 0, 50, 0.5},
                 {"M", "mass", 0.18, 3.4, 0.02}, /* which is greater than 0 */
                 {"M", "velocity.y", 0, 4.7, 0.05},
                 {"Floor", "static_friction", 0, 0.7, 0.005},
                 {"Floor", "orientation", 0, 60 * G_PI / 180, 0.5 * G_PI / 180}};
    g_autoptr(GuiFixture) fixture = gui_fixture_new(BLOCKS);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        const TinkerSceneInstrument *control = add(fixture, cases[i].block, cases[i].name);
        g_test_message("%s: %.12g to %.12g by %.12g", cases[i].name, control->from, control->to, control->step);
        g_assert_cmpfloat_with_epsilon(control->from, cases[i].from, 1e-12);
        g_assert_cmpfloat_with_epsilon(control->to, cases[i].to, 1e-12);
        g_assert_cmpfloat_with_epsilon(control->step, cases[i].step, 1e-14);
    }
}

/* A control is called as the row of its number is, with the heading of that, which says that it is of the start. */
static void test_titles(void)
{
    static const char *const cases[][3] = {{"M", "mass", "M: Mass"},
                                           {"M", "position.x", "M: Global Position X"},
                                           {"M", "velocity.y", "M: Initial Velocity Vy"},
                                           {"K", "stiffness", "K: K"}};
    g_autoptr(GuiFixture) fixture = gui_fixture_new(BLOCKS);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        const TinkerSceneInstrument *control = add(fixture, cases[i][0], cases[i][1]);
        g_autofree char *title = tinker_instrument_title(tinker_document_scene(fixture->document), control);
        g_assert_cmpstr(title, ==, cases[i][2]);
    }
}

static void add_tests(void)
{
    g_test_add_func("/gui/instrument-edit/round-steps", test_round_steps);
    g_test_add_func("/gui/instrument-edit/titles", test_titles);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

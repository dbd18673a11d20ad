/* Start conditions in the window: words, values as typed, one undo step that goes back to the start, and the menu. */
#include "gui/start/start-offer.h"

#include <math.h>
#include <string.h>

#include "gui-fixture.h"

#define SPRING                                                                                                         \
    "{'type': 'gravity'}, {'type': 'support', 'position': [0, 2]},"                                                    \
    "{'type': 'mass', 'position': [0, 0]},"                                                                            \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1.5, 'stiffness': 50}"

static const TinkerDimension length_dimension = TINKER_DIMENSION_LENGTH, angle_dimension = TINKER_DIMENSION_ANGLE;

static void test_words(void)
{
    static const char *const rows[][2] = {{"Released from equilibrium", "Released from Equilibrium"},
                                          {"At rest", "At Rest"},
                                          {"Rest length as drawn", "Rest Length as Drawn"},
                                          {"Placed on Support 0", "Placed on Support 0"},
                                          {"", ""}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *text = tinker_start_button_text(rows[i][0]);
        g_assert_cmpstr(text, ==, rows[i][1]);
    }
}

/* An inch is 0.0254 m and a foot 12 of them, by definition. */
static void test_values(void)
{
    static const struct {
        TinkerUnitSystem system;
        gboolean angle;
        const char *text;
        double si;
    } rows[] = {
        {TINKER_UNIT_SYSTEM_SI, FALSE, "0.05", 0.05},
        {TINKER_UNIT_SYSTEM_SI, FALSE, " 12 in ", 0.3048},
        {TINKER_UNIT_SYSTEM_SI, FALSE, "-2", -2},
        {TINKER_UNIT_SYSTEM_SI, FALSE, "1e-3 ", 1e-3},
        {TINKER_UNIT_SYSTEM_ENGLISH, FALSE, "2", 0.6096},
        {TINKER_UNIT_SYSTEM_ENGLISH, FALSE, "2 m", 2},
        {TINKER_UNIT_SYSTEM_SI, TRUE, "30", G_PI / 6},
        {TINKER_UNIT_SYSTEM_SI, TRUE, "0.5 rad", 0.5},
        {TINKER_UNIT_SYSTEM_ENGLISH, TRUE, "-90", -G_PI / 2},
    };
    static const char *const wrong[] = {"", " ", "five", "3 kg", "1 2", "inf", "nan", "0x10", "1e999", "5 m m", "5,5"};
    g_autoptr(GuiFixture) f = gui_fixture_new(SPRING);
    TinkerScene *scene = tinker_document_scene(f->document);
    TinkerStartOption option = {0};
    double si = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(GError) error = NULL;
        tinker_scene_head(scene)->units = rows[i].system;
        option.dimension = rows[i].angle ? angle_dimension : length_dimension;
        g_assert_true(tinker_start_value_parse(scene, &option, rows[i].text, &si, &error));
        g_assert_no_error(error);
        g_assert_cmpfloat_with_epsilon(si, rows[i].si, 1e-15);
        /* what is shown reads back as what it shows */
        option.value = si;
        g_autofree char *shown = tinker_start_value_text(scene, &option, FALSE);
        g_assert_true(tinker_start_value_parse(scene, &option, shown, &si, NULL));
        g_assert_cmpfloat_with_epsilon(si, rows[i].si, 1e-5);
    }
    option.dimension = length_dimension;
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autoptr(GError) error = NULL;
        g_assert_false(tinker_start_value_parse(scene, &option, wrong[i], &si, &error));
        g_assert_true(error != NULL && error->domain == TINKER_UNITS_ERROR);
        g_assert_null(strstr(error->message, "column"));
    }
    g_autoptr(GError) comma = NULL;
    g_assert_false(tinker_start_value_parse(scene, &option, "0,2 m", &si, &comma));
    g_assert_nonnull(strstr(comma->message, "with a point"));
}

static void count(guint *counter)
{
    ++*counter;
}

static double height_of(GuiFixture *f, const char *name)
{
    return gui_fixture_get(f, name, TINKER_MEANING_POSITION, 1);
}

/* Beneath (0, 2) on 1.5 m and 0.25 m more: at y = 0.25. While a run is shown, that goes back to its start. */
static void test_applying(void)
{
    g_autoptr(GuiFixture) f = gui_fixture_new(SPRING);
    g_autoptr(GError) error = NULL;
    guint changed = 0;
    TinkerBlockId culprit;
    g_assert_true(tinker_player_step(f->player, TRUE, &culprit, &error));
    g_assert_true(tinker_player_wait(f->player, 0.01, &error));
    tinker_player_advance(f->player, 0);
    g_assert_cmpfloat(tinker_player_time(f->player), >, 0);
    g_signal_connect_swapped(f->document, "changed", G_CALLBACK(count), &changed);
    TinkerBlockId mass = gui_fixture_block(f, "Mass 0"), spring = gui_fixture_block(f, "Spring 0");
    g_autoptr(GPtrArray) options = tinker_start_options_new(tinker_document_scene(f->document), mass);
    const TinkerStartOption *stretched = tinker_start_find(options, TINKER_START_STRETCHED, spring);
    g_assert_nonnull(stretched);
    g_assert_null(tinker_start_find(options, TINKER_START_STRETCHED, mass));
    g_assert_false(tinker_start_do(f->document, f->player, stretched, -3, &error));
    g_assert_nonnull(error);
    g_assert_cmpuint(changed, ==, 0);
    g_assert_cmpfloat(tinker_player_time(f->player), >, 0);
    g_clear_error(&error);
    g_assert_true(tinker_start_do(f->document, f->player, stretched, 0.25, &error));
    g_assert_no_error(error);
    g_assert_cmpuint(changed, >, 0);
    g_assert_cmpfloat_with_epsilon(height_of(f, "Mass 0"), 0.25, 1e-14);
    g_assert_cmpfloat(tinker_player_time(f->player), ==, 0);
    g_assert_cmpint(tinker_player_state(f->player), ==, TINKER_PLAYER_SETUP);
    tinker_document_undo(f->document);
    g_assert_cmpfloat(height_of(f, "Mass 0"), ==, 0);
    g_assert_null(tinker_history_can_undo(tinker_document_history(f->document)));
}

/* Every item is the action with a target that is offered without a value. */
static void test_menu(void)
{
    g_autoptr(GuiFixture) f = gui_fixture_new(SPRING);
    g_assert_null(tinker_start_menu_new(f->document));
    tinker_document_select(f->document, gui_fixture_block(f, "Gravity 0"));
    g_assert_null(tinker_start_menu_new(f->document));
    TinkerBlockId mass = gui_fixture_block(f, "Mass 0");
    tinker_document_select(f->document, mass);
    g_autoptr(GMenuModel) menu = tinker_start_menu_new(f->document);
    g_autoptr(GPtrArray) options = tinker_start_options_new(tinker_document_scene(f->document), mass);
    gboolean rest = FALSE;
    g_assert_nonnull(menu);
    for (int i = 0; i < g_menu_model_get_n_items(menu); i++) {
        g_autofree char *action = NULL, *label = NULL;
        gint32 kind, other;
        g_assert_true(g_menu_model_get_item_attribute(menu, i, "action", "s", &action));
        g_assert_true(g_menu_model_get_item_attribute(menu, i, "label", "s", &label));
        g_assert_true(g_menu_model_get_item_attribute(menu, i, "target", "(ii)", &kind, &other));
        g_assert_cmpstr(action, ==, "win.start");
        const TinkerStartOption *option = tinker_start_find(options, (TinkerStartKind)kind, other);
        g_assert_nonnull(option);
        g_assert_false(option->asks);
        rest |= strcmp(label, "Released from Equilibrium") == 0;
    }
    g_assert_true(rest);
    tinker_document_toggle(f->document, gui_fixture_block(f, "Spring 0"));
    g_assert_null(tinker_start_menu_new(f->document));
}

static void add_tests(void)
{
    g_test_add_func("/start-offer/words", test_words);
    g_test_add_func("/start-offer/values", test_values);
    g_test_add_func("/start-offer/applying", test_applying);
    g_test_add_func("/start-offer/menu", test_menu);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

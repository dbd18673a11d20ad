/* The property list: what a student reads, in both unit systems, and in which order. */
#include <string.h>

#include "panel-fixture.h"

/* The strings of the thesis's figures, for one mass in both systems. */
static void test_thesis_strings(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS);
    panel_select(fixture, "Mass 0");
    panel_assert_shown(fixture, "Appearance", "Name", "Mass 0");
    panel_assert_shown(fixture, "Global Position", "X", "3.20000 m");
    panel_assert_shown(fixture, "Global Position", "Y", "2.40000 m");
    panel_assert_shown(fixture, "Initial Velocity", "Vx", "0.00000 m/s");
    panel_assert_shown(fixture, "Initial Velocity", "Vy", "0.00000 m/s");
    panel_assert_shown(fixture, "Offset (Local Coordinates)", "X", "0.00000 m");
    panel_assert_shown(fixture, "Properties", "Mass", "1.00000 kg");
    panel_assert_shown(fixture, "Properties", "Orientation", "0.00000 deg");
    panel_assert_shown(fixture, "Size", "Height", "0.80000 m");
    panel_assert_shown(fixture, "Size", "Width", "0.80000 m");

    g_autofree char *before = gui_fixture_text(fixture);
    panel_go_english(fixture);
    panel_assert_undoes(fixture, before);
    panel_select(fixture, "Mass 0");
    panel_assert_shown(fixture, "Global Position", "X", "10.49869 ft");
    panel_assert_shown(fixture, "Global Position", "Y", "7.87402 ft");
    panel_assert_shown(fixture, "Properties", "Mass", "0.06852 slug");
    panel_assert_shown(fixture, "Size", "Height", "2.62467 ft");
    panel_assert_shown(fixture, "Size", "Width", "2.62467 ft");
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "position", 0), ==, 3.2);
}

static void test_motor_strings(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new(ONE_MASS ",{'type': 'motor', 'name': 'Motor 0', 'ends': ['Mass 0']}");
    panel_select(fixture, "Motor 0");
    panel_assert_shown(fixture, "Force", "Amplitude", "1.00000 N");
    panel_assert_shown(fixture, "Force", "Angle", "0.00000 deg");
    panel_assert_shown(fixture, "Force", "Frequency", "1.00000 rad/s");
    g_autoptr(TinkerPropertyRow) type = panel_find_row(fixture, "Force", "Type");
    g_assert_cmpstr(type->choices[type->chosen], ==, "Cosine");
}

static void test_support_strings(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_SUPPORT);
    panel_select(fixture, "Support 0");
    panel_assert_shown(fixture, "Appearance", "Name", "Support 0");
    panel_assert_shown(fixture, "Friction", "Dynamic coefficient", "0.50000");
    panel_assert_shown(fixture, "Friction", "Static coefficient", "0.50000");
    panel_assert_shown(fixture, "Global Position", "Y", "4.00000 m");
    panel_assert_shown(fixture, "Properties", "Orientation", "0.00000 deg");
    panel_assert_shown(fixture, "Size", "Height", "0.40000 m");
    panel_assert_shown(fixture, "Size", "Width", "4.00000 m");
}

static void test_spring_strings(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new("{'type': 'mass', 'name': 'Mass 0', 'position': [0, 2]}," ONE_SUPPORT "," ONE_SPRING);
    panel_select(fixture, "Spring 0");
    panel_assert_shown(fixture, "Spring Properties", "K", "25.00000 N/m");
    panel_assert_shown(fixture, "Spring Properties", "Length", "2.00000 m");
    panel_assert_shown(fixture, "Spring Properties", "Undeformed Length", "2.00000 m");
    panel_assert_sensitive(fixture, "Spring Properties", "Length", FALSE);
    panel_assert_sensitive(fixture, "Spring Properties", "K", TRUE);
    panel_assert_shown(fixture, "Connections", "End 1", "Support 0");
    panel_assert_shown(fixture, "Connections", "End 2", "Mass 0");
    panel_go_english(fixture);
    panel_select(fixture, "Spring 0");
    panel_assert_shown(fixture, "Spring Properties", "Length", "6.56168 ft");
    panel_assert_shown(fixture, "Spring Properties", "K", "1.71304 lbf/ft"); /* 25 * 0.3048 / 4.4482216152605 */
}

/* What five decimals do not show, or a field does not hold. */
static void test_exponents(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'mass', 'position': [1e-14, 0.0012], 'mass': 1e-7, "
                                                    "'velocity': [-0.00012345678, 12345678901]}");
    panel_select(fixture, "Mass 0");
    panel_assert_shown(fixture, "Global Position", "X", "0.00000 m");
    panel_assert_shown(fixture, "Global Position", "Y", "0.00120 m");
    panel_assert_shown(fixture, "Properties", "Mass", "1e-07 kg");
    panel_assert_shown(fixture, "Initial Velocity", "Vx", "-0.000123457 m/s");
    panel_assert_shown(fixture, "Initial Velocity", "Vy", "1.23457e+10 m/s");
}

/* Where that is wished, the zeros behind the last digit that counts are left out; all else is as it was. */
static void test_trimmed(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new(ONE_MASS ",{'type': 'mass', 'name': 'Far', 'position': [-100, 0.12345],"
                                 "'velocity': [1e-14, -0.5]}," ONE_SUPPORT "," ONE_SPRING);
    fixture->trims = TRUE;
    panel_select(fixture, "Mass 0");
    panel_assert_shown(fixture, "Global Position", "X", "3.2 m");
    panel_assert_shown(fixture, "Initial Velocity", "Vx", "0 m/s");
    panel_assert_shown(fixture, "Properties", "Mass", "1 kg");
    panel_assert_shown(fixture, "Properties", "Orientation", "0 deg");
    panel_select(fixture, "Far");
    panel_assert_shown(fixture, "Global Position", "X", "-100 m");
    panel_assert_shown(fixture, "Global Position", "Y", "0.12345 m");
    panel_assert_shown(fixture, "Initial Velocity", "Vx", "0 m/s");
    panel_assert_shown(fixture, "Initial Velocity", "Vy", "-0.5 m/s");
    /* What is not shown stays as it is when the shown is entered again. */
    g_autoptr(TinkerPropertyRow) row = panel_find_row(fixture, "Initial Velocity", "Vx");
    g_assert_true(tinker_property_row_set(fixture->document, row, "0 m/s", NULL));
    g_assert_cmpfloat(panel_stored(fixture, "Far", "velocity", 0), ==, 1e-14);
    panel_select(fixture, "Spring 0");
    panel_assert_shown(fixture, "Spring Properties", "K", "25 N/m");
    panel_select_nothing(fixture);
    panel_assert_shown(fixture, "Run", "Duration", "10 s");
    panel_go_english(fixture);
    panel_select(fixture, "Mass 0");
    panel_assert_shown(fixture, "Global Position", "X", "10.49869 ft");
    panel_assert_shown(fixture, "Properties", "Mass", "0.06852 slug");
}

static void test_order(void)
{
    static const char *const selections[] = {"Mass 0", "Support 0", "Spring 0", NULL, NULL};
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING);
    for (gsize i = 0; i < 4; i++) {
        if (selections[i] != NULL)
            panel_select(fixture, selections[i]);
        else
            panel_select_nothing(fixture);
        g_autoptr(GPtrArray) rows = tinker_property_list_new(fixture->document, fixture->player, FALSE);
        g_autoptr(GHashTable) ids = g_hash_table_new(g_str_hash, g_str_equal);
        g_assert_cmpuint(rows->len, >, 4);
        for (guint k = 0; k < rows->len; k++) {
            const TinkerPropertyRow *row = g_ptr_array_index(rows, k), *last = k > 0 ? rows->pdata[k - 1] : row;
            int by_group = strcmp(last->group, row->group);
            g_assert_cmpint(by_group, <=, 0);
            if (by_group == 0) g_assert_cmpint(strcmp(last->title, row->title), <=, 0);
            g_assert_true(g_hash_table_add(ids, row->id));
        }
    }
}

static void test_every_kind(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'every-kind', 'name': 'E'}");
    panel_select(fixture, "E");
    g_autoptr(GPtrArray) rows = tinker_property_list_new(fixture->document, fixture->player, FALSE);
    gboolean seen[TINKER_ROW_READING + 1] = {FALSE};
    for (guint i = 0; i < rows->len; i++) {
        const TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        g_autofree char *before = gui_fixture_text(fixture);
        seen[row->kind] = TRUE;
        if (row->choose == NULL) continue;
        g_assert_true(tinker_property_row_choose(fixture->document, row, 1 - MIN(row->chosen, 1), NULL));
        g_autofree char *after = gui_fixture_text(fixture);
        g_assert_cmpstr(after, !=, before);
        tinker_document_undo(fixture->document);
        g_autofree char *undone = gui_fixture_text(fixture);
        g_assert_cmpstr(undone, ==, before);
    }
    g_assert_true(seen[TINKER_ROW_NUMBER] && seen[TINKER_ROW_TEXT] && seen[TINKER_ROW_CHOICE] &&
                  seen[TINKER_ROW_SWITCH]);
}

/* Vectors with the same labels in one group are told apart by their own titles; components stay together in their
 * order. */
static void test_vectors(void)
{
    static const char *const titles[] = {"Centre X", "Centre Y", "Moment Along", "Moment Across", "Point X",
                                         "Point Y",  "Radius",   "X Pull",       "Y pull"};
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'vectors', 'name': 'V', 'centre': [1, 2]}");
    panel_select(fixture, "V");
    g_autoptr(GPtrArray) rows = tinker_property_list_new(fixture->document, fixture->player, FALSE);
    guint shown = 0;
    for (guint i = 0; i < rows->len; i++) {
        const TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        if (!g_str_equal(row->group, "Guide")) continue;
        g_assert_cmpuint(shown, <, G_N_ELEMENTS(titles));
        g_assert_cmpstr(row->title, ==, titles[shown++]);
    }
    g_assert_cmpuint(shown, ==, G_N_ELEMENTS(titles));
    panel_assert_shown(fixture, "Guide", "Centre X", "1.00000 m");
    panel_assert_shown(fixture, "Guide", "Centre Y", "2.00000 m");
    panel_assert_shown(fixture, "Its Places", "X", "0.00000 m"); /* the heading has the title */
    panel_type(fixture, "Guide", "Moment Across", "3");
    g_assert_cmpfloat(panel_stored(fixture, "V", "moment", 1), ==, 3);
    g_assert_cmpfloat(panel_stored(fixture, "V", "moment", 0), ==, 0);
}

/* Numbers of the one block that is selected can have a control, and are named as that names them. */
static void test_controls(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING);
    static const struct {
        const char *block, *group, *title, *control;
    } rows[] = {{"Mass 0", "Properties", "Mass", "mass"},
                {"Mass 0", "Initial Velocity", "Vx", "velocity.x"},
                {"Mass 0", "Appearance", "Name", NULL},
                {"Spring 0", "Spring Properties", "K", "stiffness"},
                {"Spring 0", "Spring Properties", "Length", NULL}}; /* which follows from where it is */
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        panel_select(fixture, rows[i].block);
        g_autoptr(TinkerPropertyRow) row = panel_find_row(fixture, rows[i].group, rows[i].title);
        g_assert_nonnull(row);
        g_assert_cmpstr(row->control, ==, rows[i].control);
    }
}

/* A mass in free fall for half a second, by its closed form; before the run nothing is said of it. */
static void test_now(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'gravity', 'name': 'Gravity'}," ONE_MASS "," ONE_SUPPORT
                                                    "," ONE_SPRING ", {'type': 'mass', 'name': 'Free'}");
    panel_select(fixture, "Free");
    g_autoptr(TinkerPropertyRow) none = panel_find_row(fixture, "Now", "Y Position");
    g_assert_null(none);
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_player_play(fixture->player, &culprit, &error));
    g_assert_true(tinker_player_wait(fixture->player, 0.5, &error));
    tinker_player_pause(fixture->player);
    tinker_player_seek(fixture->player, 0.5);
    panel_assert_shown(fixture, "Now", "Y Position", "-1.226 m");
    panel_assert_shown(fixture, "Now", "Y Velocity", "-4.905 m/s");
    panel_assert_shown(fixture, "Global Position", "Y", "0.00000 m");
    g_autoptr(TinkerPropertyRow) reading = panel_find_row(fixture, "Now", "Speed");
    g_assert_null(reading->set);

    /* The spring's length is that of the present too. */
    panel_select(fixture, "Spring 0");
    g_autoptr(TinkerPropertyRow) length = panel_find_row(fixture, "Spring Properties", "Length"),
                                 now = panel_find_row(fixture, "Now", "Length");
    g_assert_cmpfloat_with_epsilon(g_ascii_strtod(length->text, NULL), g_ascii_strtod(now->text, NULL), 5e-4);
    g_assert_cmpstr(length->text, !=, "3.57771 m"); /* hypot(3.2, 1.6), as placed */
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-list/exponents", test_exponents);
    g_test_add_func("/gui/property-list/thesis-strings", test_thesis_strings);
    g_test_add_func("/gui/property-list/motor-strings", test_motor_strings);
    g_test_add_func("/gui/property-list/support-strings", test_support_strings);
    g_test_add_func("/gui/property-list/spring-strings", test_spring_strings);
    g_test_add_func("/gui/property-list/trimmed", test_trimmed);
    g_test_add_func("/gui/property-list/order", test_order);
    g_test_add_func("/gui/property-list/every-kind", test_every_kind);
    g_test_add_func("/gui/property-list/vectors", test_vectors);
    g_test_add_func("/gui/property-list/now", test_now);
    g_test_add_func("/gui/property-list/controls", test_controls);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

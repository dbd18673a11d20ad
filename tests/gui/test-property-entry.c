/* What a student types into the property list: numbers with their units, names, for one block, for several and for the
 * scene; and what is refused. */
#include <math.h>
#include <string.h>

#include "panel-fixture.h"

static void test_units(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS);
    panel_select(fixture, "Mass 0");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_type(fixture, "Global Position", "X", "12 in");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "position", 0), 0.3048, 1e-15);
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "position", 1), ==, 2.4);
    panel_assert_shown(fixture, "Global Position", "X", "0.30480 m");
    panel_assert_undoes(fixture, before);

    /* A plain number is in the unit that is shown. */
    panel_type(fixture, "Properties", "Orientation", " 90 ");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "orientation", 0), asin(1.0), 1e-15);
    panel_type(fixture, "Properties", "Mass", "2.5");
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "mass", 0), ==, 2.5);
    panel_go_english(fixture);
    panel_select(fixture, "Mass 0");
    panel_type(fixture, "Global Position", "Y", "10");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "position", 1), 3.048, 1e-15);
    panel_assert_shown(fixture, "Global Position", "Y", "10.00000 ft");
    panel_type(fixture, "Properties", "Mass", "1");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "mass", 0), 14.593902937206364, 1e-12);
    panel_type(fixture, "Properties", "Mass", "3 kg");
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "mass", 0), ==, 3);
}

/* A formula stands for its number, in the unit that is shown or in one behind it; the number is kept. */
static void test_formula(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS "," ONE_SUPPORT);
    panel_select(fixture, "Mass 0");
    panel_type(fixture, "Properties", "Mass", "2*9.81");
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "mass", 0), ==, 19.62);
    panel_assert_shown(fixture, "Properties", "Mass", "19.62000 kg");
    panel_type(fixture, "Global Position", "X", "sqrt(2)");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "position", 0), G_SQRT2, 1e-15);
    panel_type(fixture, "Global Position", "X", "5/4 cm");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "position", 0), 0.0125, 1e-15);
    /* a sum of quantities, with and without blanks */
    static const struct {
        const char *text;
        double metres;
    } sums[] = {{"6.13 m-3 m", 3.13}, {"6.13 m - 3 m", 3.13},  {"1 m+1 ft", 1.3048}, {"2e-3 m-1e-3 m", 1e-3},
                {"-1 m-(1+1) m", -3}, {"1 m + 2 m - 4 m", -1}, {"5-3 m+2 m", 4},     {"1 m^2/m-.5 m", 0.5},
                {"2 N-m/N-1 m", 1},   {"2*3 m-1 m", 5}};
    for (gsize i = 0; i < G_N_ELEMENTS(sums); i++) {
        panel_type(fixture, "Global Position", "X", sums[i].text);
        g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "position", 0), sums[i].metres, 1e-14);
    }
    panel_assert_refused(fixture, "Global Position", "X", "6 m-3", PARTS("unit"));
    panel_assert_refused(fixture, "Global Position", "X", "6 m-3 kg", PARTS("unit"));
    panel_assert_refused(fixture, "Properties", "Mass", "3 kg-4 kg", PARTS("greater than 0 kg", "-1 kg"));
    panel_type(fixture, "Properties", "Orientation", "180/4");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "orientation", 0), G_PI_4, 1e-15);
    panel_assert_refused(fixture, "Properties", "Mass", "2*t", PARTS("2*t", "no number"));
    panel_assert_refused(fixture, "Properties", "Mass", "sqrt(-1)", PARTS("no number"));
    panel_assert_refused(fixture, "Properties", "Mass", "2*", PARTS("expected"));
    panel_assert_refused(fixture, "Properties", "Mass", "2*3 in", PARTS("mass", "length", "6 in"));
    panel_assert_refused(fixture, "Properties", "Mass", "1-2", PARTS("greater than 0 kg", "-1 kg"));
}

/* Text that is left as it is shown changes nothing, although it has fewer digits than the value. */
static void test_unchanged(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'mass', 'name': 'A', 'position': [0.123456789, 0]}");
    panel_select(fixture, "A");
    panel_type(fixture, "Global Position", "X", "0.12346 m");
    g_assert_cmpfloat(panel_stored(fixture, "A", "position", 0), ==, 0.123456789);
    g_assert_null(tinker_history_can_undo(tinker_document_history(fixture->document)));
}

static void test_refused(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS "," ONE_SUPPORT);
    panel_select(fixture, "Mass 0");
    panel_assert_refused(fixture, "Properties", "Mass", "12 in", PARTS("mass", "length", "12 in"));
    panel_assert_refused(fixture, "Properties", "Mass", "-1", PARTS("Mass", "greater than 0 kg", "-1 kg"));
    panel_assert_refused(fixture, "Properties", "Mass", "0 kg", PARTS("greater than 0 kg"));
    panel_assert_refused(fixture, "Properties", "Mass", "heavy", PARTS("number"));
    panel_assert_refused(fixture, "Properties", "Mass", "", PARTS("number"));
    panel_assert_refused(fixture, "Properties", "Mass", "1,5", PARTS("point"));
    panel_assert_refused(fixture, "Properties", "Mass", "1e999", PARTS("range"));
    panel_assert_refused(fixture, "Properties", "Mass", "3 kgs", PARTS("kgs", "did you mean"));
    panel_assert_refused(fixture, "Size", "Width", "-0.1 m", PARTS("Width", "at least 0 m", "-0.1 m"));
    panel_assert_refused(fixture, "Size", "Width", "\xff", PARTS("UTF-8"));
    panel_assert_refused(fixture, "Appearance", "Name", "Support 0", PARTS("Support 0", "already"));
    panel_assert_refused(fixture, "Appearance", "Name", " ", PARTS("name"));
    panel_select(fixture, "Support 0");
    panel_assert_refused(fixture, "Properties", "Restitution", "1.5", PARTS("at most 1", "1.5"));
    panel_go_english(fixture);
    panel_select(fixture, "Mass 0");
    panel_assert_refused(fixture, "Properties", "Mass", "-1", PARTS("greater than 0 slug", "-1 slug"));
    panel_select_nothing(fixture);
    panel_assert_refused(fixture, "Run", "Duration", "0", PARTS("Duration", "greater than 0 s"));
    panel_assert_refused(fixture, "Canvas", "Grid", "-1 ft", PARTS("greater than 0"));
}

/* A number that a typed law names stays as it was typed, whatever its unit. */
static void test_numbers_of_laws(void)
{
    static const char *const texts[] = {"1 ft", "3 kg/m", "2 lbf/ft", "1e3", "3.0"};
    g_autoptr(GuiFixture) fixture = gui_fixture_new(
        ONE_MASS ",{'type': 'law-force', 'name': 'Law', 'ends': ['Mass 0'], 'force_x': '-a*x', 'a': '5 N/m'}");
    panel_select(fixture, "Law");
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        g_autofree char *before = gui_fixture_text(fixture), *member = g_strdup_printf("\"a\": \"%s\"", texts[i]);
        panel_type(fixture, "Numbers", "a", texts[i]);
        panel_assert_shown(fixture, "Numbers", "a", texts[i]);
        g_autofree char *after = gui_fixture_text(fixture);
        if (strstr(after, member) == NULL) g_error("%s is not in %s", member, after);
        tinker_document_undo(fixture->document);
        g_autofree char *undone = gui_fixture_text(fixture);
        g_assert_cmpstr(undone, ==, before);
        tinker_document_redo(fixture->document);
        panel_assert_shown(fixture, "Numbers", "a", texts[i]);
    }
}

static void test_name(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS);
    panel_select(fixture, "Mass 0");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_type(fixture, "Appearance", "Name", "Bob");
    g_assert_cmpint(gui_fixture_block(fixture, "Bob"), ==, tinker_document_selected(fixture->document));
    panel_assert_undoes(fixture, before);
}

/* Any text is taken or refused; none harms the scene. */
static void test_any_text(void)
{
    static const char *const bits[] = {"1", "-",  ".", "e", "9", " ",   "m",   "/",
                                       "^", "ft", "°", ",", "(", "nan", "inf", "0x"};
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING);
    static const char *const names[] = {"Mass 0", "Support 0", "Spring 0"};
    for (int round = 0; round < 300; round++) {
        g_autoptr(GString) text = g_string_new(NULL);
        for (int i = g_test_rand_int_range(0, 7); i > 0; i--)
            g_string_append(text, bits[g_test_rand_int_range(0, G_N_ELEMENTS(bits))]);
        TinkerBlockId block = tinker_scene_block_at(tinker_document_scene(fixture->document), round % 3);
        tinker_document_select(fixture->document, block);
        g_autoptr(GPtrArray) rows = tinker_property_list_new(fixture->document, fixture->player, FALSE);
        TinkerPropertyRow *row = rows->pdata[g_test_rand_int_range(0, (gint32)rows->len)];
        g_autoptr(GError) error = NULL;
        if (row->set == NULL) continue;
        gboolean taken = tinker_property_row_set(fixture->document, row, text->str, &error);
        g_assert_true(taken == (error == NULL));
    }
    g_autofree char *written = gui_fixture_text(fixture);
    g_autoptr(TinkerScene) again = scene_fixture_read(written);
    g_assert_cmpint(tinker_scene_block_count(again), ==, G_N_ELEMENTS(names));
}

/* A block of a type that nobody provides can still be renamed. */
static void test_placeholder(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'nobody', 'name': 'P', 'ratio': 2}");
    panel_select(fixture, "P");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_assert_shown(fixture, "Appearance", "Type", "nobody (not installed)");
    panel_type(fixture, "Appearance", "Name", "Q");
    panel_assert_undoes(fixture, before);
}

static void test_several(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new("{'type': 'mass', 'name': 'A', 'position': [1, 2], 'mass': 1},"
                        "{'type': 'mass', 'name': 'B', 'position': [3, 2], 'mass': 2}," ONE_SUPPORT);
    const TinkerBlockId both[] = {gui_fixture_block(fixture, "A"), gui_fixture_block(fixture, "B"),
                                  gui_fixture_block(fixture, "Support 0")};
    tinker_document_select_all_of(fixture->document, both, 2);
    g_autofree char *before = gui_fixture_text(fixture);
    g_autoptr(TinkerPropertyRow) x = panel_find_row(fixture, "Global Position", "X"),
                                 name = panel_find_row(fixture, "Appearance", "Name");
    g_assert_true(x->mixed);
    g_assert_cmpstr(x->text, ==, "");
    g_assert_null(name);
    panel_assert_shown(fixture, "Global Position", "Y", "2.00000 m");
    panel_type(fixture, "Properties", "Mass", "5 kg");
    g_assert_cmpfloat(panel_stored(fixture, "A", "mass", 0), ==, 5);
    g_assert_cmpfloat(panel_stored(fixture, "B", "mass", 0), ==, 5);
    panel_assert_undoes(fixture, before);
    panel_type(fixture, "Global Position", "X", "0");
    g_assert_cmpfloat(panel_stored(fixture, "B", "position", 0), ==, 0);
    g_assert_cmpfloat(panel_stored(fixture, "B", "position", 1), ==, 2);

    tinker_document_select_all_of(fixture->document, both, 3);
    g_autoptr(GPtrArray) rows = tinker_property_list_new(fixture->document, fixture->player, FALSE);
    g_autofree char *heading = tinker_property_list_heading(fixture->document);
    g_assert_cmpuint(rows->len, ==, 0);
    g_assert_cmpstr(heading, ==, "3 Blocks");
}

/* Of several supports each keeps its static coefficient, where that is not below the dynamic one that is typed for all.
 */
static void test_friction_of_several(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'support', 'name': 'A', 'static_friction': 0.9},"
                                                    "{'type': 'support', 'name': 'B', 'static_friction': 0.6}");
    const TinkerBlockId both[] = {gui_fixture_block(fixture, "A"), gui_fixture_block(fixture, "B")};
    tinker_document_select_all_of(fixture->document, both, 2);
    panel_type(fixture, "Friction", "Dynamic coefficient", "0.8");
    g_assert_cmpfloat(panel_stored(fixture, "A", "static_friction", 0), ==, 0.9);
    g_assert_cmpfloat(panel_stored(fixture, "B", "static_friction", 0), ==, 0.8);
    tinker_document_undo(fixture->document);
    g_assert_cmpfloat(panel_stored(fixture, "B", "static_friction", 0), ==, 0.6);
    g_assert_cmpfloat(panel_stored(fixture, "A", "dynamic_friction", 0), ==, 0.5);
}

static void test_scene(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS);
    panel_select_nothing(fixture);
    TinkerSceneHead *head = tinker_scene_head(tinker_document_scene(fixture->document));
    g_autofree char *before = gui_fixture_text(fixture);
    panel_type(fixture, "Scene", "Title", "Pendulum");
    g_assert_cmpstr(head->title, ==, "Pendulum");
    panel_assert_undoes(fixture, before);
    panel_type(fixture, "Run", "Duration", "2 min");
    g_assert_cmpfloat(head->run.duration, ==, 120);
    panel_type(fixture, "Run", "Stop When", " {Mass 0.y} = 1; event(impact) ");
    g_assert_cmpstr(head->run.until, ==, "{Mass 0.y} = 1; event(impact)");
    panel_assert_refused(fixture, "Run", "Stop When", "{Mass 0.q} = 1", PARTS("{Mass 0.q}", "Mass 0 has no quantity"));
    panel_assert_refused(fixture, "Run", "Stop When", "event(impct)",
                         PARTS("event(impct)", "did you mean \"impact\"?"));
    panel_type(fixture, "Run", "Stop When", "");
    g_assert_cmpstr(head->run.until, ==, "");
    panel_type(fixture, "Computation", "Tolerance", "1e-6");
    g_assert_cmpfloat(head->run.tolerance, ==, 1e-6);
    panel_assert_shown(fixture, "Computation", "Tolerance", "1e-06");
    panel_assert_shown(fixture, "Computation", "Accuracy", "");
    panel_type(fixture, "Computation", "Accuracy", "1e-5");
    g_assert_cmpfloat(head->run.accuracy, ==, 1e-5);
    panel_assert_shown(fixture, "Computation", "Accuracy", "1e-05");
    panel_assert_sensitive(fixture, "Computation", "Tolerance", FALSE); /* chosen for the accuracy */
    panel_type(fixture, "Computation", "Accuracy", " ");
    g_assert_cmpfloat(head->run.accuracy, ==, 0);
    panel_assert_sensitive(fixture, "Computation", "Tolerance", TRUE);
    panel_choose(fixture, "Computation", "Contacts", "Impulses");
    g_assert_cmpstr(head->run.contacts, ==, "impulse");
    panel_choose(fixture, "Computation", "Method", "Classical Runge-Kutta, order 4");
    g_assert_cmpstr(head->run.method, ==, "rk4");
    panel_assert_sensitive(fixture, "Computation", "Step", TRUE);
    panel_assert_sensitive(fixture, "Computation", "Tolerance", FALSE);
    panel_go_english(fixture);
    panel_type(fixture, "Canvas", "Width", "30");
    g_assert_cmpfloat_with_epsilon(head->canvas_width, 9.144, 1e-12);
}

/* The law of impact is a choice; impulses know Newton's alone, whichever of the two is chosen last. */
static void test_impact_law(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS);
    panel_select_nothing(fixture);
    const TinkerSceneHead *head = tinker_scene_head(tinker_document_scene(fixture->document));
    panel_choose(fixture, "Computation", "Law of Impact", "One After the Other");
    g_assert_cmpstr(head->run.impact_law, ==, "sequential");
    panel_assert_refused(fixture, "Computation", "Contacts", "Impulses", PARTS("impulses", "Newton"));
    g_assert_cmpstr(head->run.contacts, ==, "events");
    panel_choose(fixture, "Computation", "Law of Impact", "Poisson");
    g_assert_cmpstr(head->run.impact_law, ==, "poisson");
    panel_choose(fixture, "Computation", "Law of Impact", "Newton");
    panel_choose(fixture, "Computation", "Contacts", "Impulses");
    panel_assert_refused(fixture, "Computation", "Law of Impact", "Poisson", PARTS("impulses", "Newton"));
    g_assert_cmpstr(head->run.impact_law, ==, "newton");
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-list/placeholder", test_placeholder);
    g_test_add_func("/gui/property-list/units", test_units);
    g_test_add_func("/gui/property-list/formula", test_formula);
    g_test_add_func("/gui/property-list/unchanged", test_unchanged);
    g_test_add_func("/gui/property-list/refused", test_refused);
    g_test_add_func("/gui/property-list/numbers-of-laws", test_numbers_of_laws);
    g_test_add_func("/gui/property-list/name", test_name);
    g_test_add_func("/gui/property-list/any-text", test_any_text);
    g_test_add_func("/gui/property-list/several", test_several);
    g_test_add_func("/gui/property-list/friction-of-several", test_friction_of_several);
    g_test_add_func("/gui/property-list/scene", test_scene);
    g_test_add_func("/gui/property-list/impact-law", test_impact_law);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

/* What is recorded of large scenes: little, but what is looked at, and nothing twice. */
#include "gui/document/recorded-quantities.h"

#include "gui-fixture.h"

static guint count_of(const GArray *columns, TinkerQuantity wanted)
{
    guint count = 0;
    for (guint i = 0; i < columns->len; i++) {
        const TinkerQuantity *column = &g_array_index(columns, TinkerQuantity, i);
        count += column->block == wanted.block && column->quantity == wanted.quantity;
    }
    return count;
}

/* As many masses; their first is in a graph. */
static GuiFixture *masses(int count)
{
    GuiFixture *fixture = gui_fixture_new("");
    g_autoptr(GString) members = g_string_new("'graphs': [{'block': 'M0', 'quantity': 'y'}], 'blocks': [");
    for (int i = 0; i < count; i++)
        g_string_append_printf(members, "%s{'type': 'mass', 'name': 'M%d'}", i > 0 ? ", " : "", i);
    g_string_append_c(members, ']');
    gui_fixture_start_scene(fixture, members->str);
    return fixture;
}

static int32_t quantities_of_a_mass(void)
{
    return scene_fixture_class("mass")->quantity_count;
}

static void test_small(void)
{
    g_autoptr(GuiFixture) fixture = masses(3);
    g_autoptr(GArray) asked = g_array_new(FALSE, FALSE, sizeof(TinkerQuantity));
    g_autoptr(GArray) columns = tinker_recorded_quantities(fixture->document, asked, FALSE);
    g_assert_cmpuint(columns->len, ==, 3 * (guint)quantities_of_a_mass() + TINKER_SCENE_QUANTITIES);
}

static void test_large(void)
{
    const int count = 4001;
    g_autoptr(GuiFixture) fixture = masses(count);
    g_autoptr(GArray) asked = g_array_new(FALSE, FALSE, sizeof(TinkerQuantity));
    TinkerQuantity graphed = {gui_fixture_block(fixture, "M0"),
                              tinker_block_class_quantity(scene_fixture_class("mass"), "y")};
    TinkerQuantity wanted = {gui_fixture_block(fixture, "M7"), 1}, gone = {count + 5, 0};
    const TinkerQuantity all[] = {graphed, wanted, gone, wanted, graphed};
    g_array_append_vals(asked, all, G_N_ELEMENTS(all));
    g_autoptr(GArray) columns = tinker_recorded_quantities(fixture->document, asked, FALSE);
    g_assert_cmpuint(columns->len, ==, 2);
    g_assert_cmpuint(count_of(columns, graphed), ==, 1);
    g_assert_cmpuint(count_of(columns, wanted), ==, 1);

    tinker_document_select(fixture->document, graphed.block);
    g_autoptr(GArray) selected = tinker_recorded_quantities(fixture->document, asked, FALSE);
    g_assert_cmpuint(selected->len, ==, (guint)quantities_of_a_mass() + 1);
    g_assert_cmpuint(count_of(selected, graphed), ==, 1);

    g_autofree TinkerBlockId *blocks = g_new(TinkerBlockId, count);
    for (int i = 0; i < count; i++)
        blocks[i] = tinker_scene_block_at(tinker_document_scene(fixture->document), i);
    tinker_document_select_all_of(fixture->document, blocks, count);
    g_autoptr(GArray) everything = tinker_recorded_quantities(fixture->document, asked, FALSE);
    g_assert_cmpuint(everything->len, <, 4100);
    g_assert_cmpuint(count_of(everything, wanted), ==, 1);
}

/* A brief run goes without the energies of the scene, until they were asked for. */
static void test_brief(void)
{
    g_autoptr(GuiFixture) fixture = masses(3);
    g_autoptr(GArray) asked = g_array_new(FALSE, FALSE, sizeof(TinkerQuantity));
    const TinkerQuantity energy = {TINKER_NO_BLOCK, TINKER_SCENE_DAMPERS};
    g_autoptr(GArray) without = tinker_recorded_quantities(fixture->document, asked, TRUE);
    g_assert_cmpuint(without->len, ==, 3 * (guint)quantities_of_a_mass());
    g_array_append_val(asked, energy);
    g_autoptr(GArray) with = tinker_recorded_quantities(fixture->document, asked, TRUE);
    g_assert_cmpuint(with->len, ==, without->len + 1);
    g_assert_cmpuint(count_of(with, energy), ==, 1);
}

static void add_tests(void)
{
    g_test_add_func("/recorded-quantities/brief", test_brief);
    g_test_add_func("/recorded-quantities/small", test_small);
    g_test_add_func("/recorded-quantities/large", test_large);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}

/* Older and newer hosts with older and newer plugins, all real binaries. This test is compiled twice: with the present
 * headers and this host, and with the headers of the next minor version and a host that is compiled with them. Each
 * opens the plugin of both. */
#include "fixture.h"

#if defined(TINKER_NEXT)
#define PRESENT_MINOR (TINKER_ABI_MINOR - 1)
/* What a newer host reads of a member that the plugin's headers may not have had. */
#define EXPECT_MORE(object, there)                                                                                     \
    for (int k = 0; k < 3; k++)                                                                                        \
        g_assert_cmpfloat((object)->next_member[k], ==, (there) ? 7 + k : 0);
#else
#define PRESENT_MINOR TINKER_ABI_MINOR
#define EXPECT_MORE(object, there)
#endif

static void expect_declared(const TinkerBlockClass *block_class, gboolean newer)
{
    g_assert_cmpint(block_class->plugin->abi_minor, ==, PRESENT_MINOR + (newer ? 1 : 0));
    g_assert_cmpuint(block_class->plugin->struct_size, ==, sizeof(TinkerPlugin));
    EXPECT_MORE(block_class->plugin, newer)
    EXPECT_MORE(block_class->type, newer)
    g_assert_cmpint(block_class->property_count, ==, 2);
    g_assert_cmpstr(block_class->properties[0].id, ==, "first");
    g_assert_cmpstr(block_class->properties[1].id, ==, "second");
    g_assert_cmpint(block_class->quantity_count, ==, 2);
    g_assert_cmpstr(block_class->quantities[1].id, ==, "two");
    for (int i = 0; i < 2; i++) {
        g_assert_cmpuint(block_class->properties[i].struct_size, ==, sizeof(TinkerPropertyType));
        g_assert_cmpfloat(block_class->properties[i].default_value[0], ==, 1.5 + i);
        g_assert_null(block_class->properties[i].phase);
        EXPECT_MORE(&block_class->properties[i], newer)
        EXPECT_MORE(&block_class->quantities[i], newer)
    }
    EXPECT_MORE(block_class->physics, newer)
    EXPECT_MORE(block_class->physics->line_law, newer)
    EXPECT_MORE(block_class->graph, newer)
    EXPECT_MORE(block_class->render, newer)
    g_assert_cmpint(block_class->render->layer, ==, 2);
    g_assert_null(block_class->render->bounds);
    g_assert_null(block_class->edit);
}

/* The host's structs go to the plugin, and what it works out comes back. */
static void expect_works(const TinkerBlockClass *block_class)
{
    const double stiffness[] = {10, 20}, rest[] = {1, 2}, length[] = {1.5, 1.75}, rate[] = {0, 0};
    const double *const columns[] = {stiffness, rest};
    double tension[2], values[2], accelerations[] = {0.5, -0.5};
    TinkerBatch batch = {.struct_size = sizeof batch, .count = 2, .ends = 2, .columns = columns};
    g_assert_cmpint(block_class->physics->line_law->tension(&batch, length, rate, tension), ==, TINKER_OK);
    g_assert_cmpfloat(tension[0], ==, 5);
    g_assert_cmpfloat(tension[1], ==, -5);
    const TinkerGraphInput input = {.struct_size = sizeof input, .accelerations = accelerations};
    g_assert_cmpint(block_class->graph->values(&batch, &input, 1, values), ==, TINKER_OK);
    g_assert_cmpfloat(values[0], ==, 1.5);
    g_assert_cmpfloat(values[1], ==, 0.5);
}

static void expect_method(TinkerCatalogue *catalogue, const char *id, int32_t order, gboolean newer)
{
    g_autoptr(GError) error = NULL;
    const TinkerIntegrator *method = tinker_catalogue_integrator(catalogue, id, &error);
    g_assert_no_error(error);
    g_assert_cmpuint(method->struct_size, ==, sizeof(TinkerIntegrator));
    g_assert_cmpint(method->order, ==, order);
    EXPECT_MORE(method, newer)
    const double mass = 1;
    const TinkerSystem system = {.struct_size = sizeof system, .mass = &mass};
    const TinkerIntegratorOptions options = {.struct_size = sizeof options};
    void *stepper = method->create(&system, &options);
    g_assert_true(stepper == &mass);
    TinkerState state = {0};
    TinkerStepReport report = {.struct_size = sizeof report};
    g_assert_cmpint(method->step(stepper, &state, 0.5, &report), ==, TINKER_OK);
    g_assert_cmpfloat(state.t, ==, 0.5);
    g_assert_cmpfloat(report.step, ==, 0.25);
    method->destroy(stepper);
}

static void check(Place *place, const char *module, gboolean newer)
{
    place->options.probe_program = g_test_get_filename(G_TEST_BUILT, GROWTH_PROBE, NULL);
    g_autofree char *path = install_module(module, place->first, "growth.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpstr(entry_of(catalogue, path)->refused, ==, NULL);
    for (int i = 0; i < 2; i++) {
        g_autofree char *type = g_strdup_printf("%s-%c", newer ? "next" : "present", 'a' + i);
        g_autoptr(GError) error = NULL;
        const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, type, &error);
        g_assert_no_error(error);
        expect_declared(block_class, newer);
        expect_works(block_class);
    }
    expect_method(catalogue, newer ? "next-slow" : "present-slow", 1, newer);
    expect_method(catalogue, newer ? "next-fast" : "present-fast", 4, newer);
}

static void test_older(Place *place, gconstpointer data)
{
    check(place, "growth-present", FALSE);
}

static void test_newer(Place *place, gconstpointer data)
{
    check(place, "growth-next", TRUE);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    add_place_test("/plugin/growth/plugin-of-present-headers", test_older);
    add_place_test("/plugin/growth/plugin-of-next-headers", test_newer);
    return g_test_run();
}

/* Plugins of older and newer headers with this host, as real binaries. */
#include <string.h>

#include "fixture.h"

static const TinkerBlockClass *open_class(const Place *place, const char *module, const char *type)
{
    g_autofree char *path = install_module(module, place->first, "plugin.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, type, &error);
    g_assert_no_error(error);
    return block_class;
}

/* What older headers did not have reads as unset, whatever stands in memory there. */
static void test_old_header(Place *place, gconstpointer data)
{
    const TinkerBlockClass *old = open_class(place, "old", "old");
    g_assert_cmpint(old->property_count, ==, 2);
    const TinkerPropertyType *second = &old->properties[1];
    g_assert_cmpuint(second->struct_size, ==, sizeof(TinkerPropertyType));
    g_assert_cmpstr(second->id, ==, "second");
    g_assert_cmpstr(second->title, ==, "Second");
    g_assert_cmpstr(second->group, ==, "");
    g_assert_null(second->symbol);
    g_assert_cmpuint(second->flags, ==, 0);
    g_assert_cmpint(second->panel, ==, -1);
    g_assert_null(second->choices);
    g_assert_null(second->amplitude);
    g_assert_cmpint(old->first_columns[1], ==, 1);
    g_assert_cmpint(old->column_count, ==, 3);

    g_assert_cmpint(old->quantity_count, ==, 1);
    g_assert_cmpstr(old->quantities[0].id, ==, "tension");
    g_assert_cmpstr(old->quantities[0].title, ==, "tension");
    g_assert_cmpint(old->quantities[0].dimension.mass, ==, 0);

    g_assert_nonnull(old->physics->line_law->tension);
    g_assert_null(old->physics->line_law->derivatives);
    g_assert_null(old->physics->line_law->next_break);
    g_assert_null(old->physics->force_element);
    g_assert_null(old->physics->prepare);
    g_assert_nonnull(old->render->draw);
    g_assert_cmpint(old->render->layer, ==, 2);
    g_assert_null(old->render->bounds);
    g_assert_null(old->edit);
    g_assert_null(old->units);
}

/* What newer headers add is passed over, and longer strides are followed. */
static void test_new_header(Place *place, gconstpointer data)
{
    const TinkerBlockClass *new = open_class(place, "new", "new");
    g_assert_cmpint(new->property_count, ==, 2);
    g_assert_cmpstr(new->properties[1].id, ==, "second");
    g_assert_cmpfloat(new->properties[1].default_value[0], ==, 2.5);
    g_assert_cmpuint(new->properties[1].struct_size, ==, sizeof(TinkerPropertyType));
    g_assert_cmpint(new->quantity_count, ==, 2);
    g_assert_cmpstr(new->quantities[1].id, ==, "two");
    g_assert_nonnull(new->physics->field->force);
    g_assert_cmpuint(new->physics->field->struct_size, ==, sizeof(TinkerField));
    g_assert_nonnull(new->graph->values);
    g_assert_cmpuint(new->plugin->struct_size, ==, sizeof(TinkerPlugin));
}

/* The call goes through to the plugin's own function. */
static void test_call(Place *place, gconstpointer data)
{
    const TinkerBlockClass *pull = open_class(place, "good", "pull");
    const double stiffness[] = {10, 20}, rest[] = {1, 2};
    const double *const columns[] = {stiffness, rest};
    const double length[] = {1.5, 1.75}, rate[] = {0, 0};
    double tension[2];
    TinkerBatch batch = {.struct_size = sizeof batch, .count = 2, .ends = 2, .columns = columns};
    g_assert_cmpint(pull->physics->line_law->tension(&batch, length, rate, tension), ==, TINKER_OK);
    g_assert_cmpfloat(tension[0], ==, 5);
    g_assert_cmpfloat(tension[1], ==, -5);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    add_place_test("/plugin/compatibility/old-header", test_old_header);
    add_place_test("/plugin/compatibility/new-header", test_new_header);
    add_place_test("/plugin/compatibility/call", test_call);
    return g_test_run();
}

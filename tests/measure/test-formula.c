/* Expressions of quantities, against the quantities that they should be, and their dimensions. */
#include <math.h>
#include <string.h>

#include "measure/formula.h"
#include "physics-fixture.h"
#include "physics/record/columns.h"

#define BLOCKS                                                                                                         \
    "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 2, 'position': [3, 1], 'velocity': [0.5, -2]},"     \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 30}"

static TinkerFormula *formula_of(TinkerScene *scene, GArray *columns, const char *text)
{
    g_autoptr(GError) error = NULL;
    TinkerFormula *formula = tinker_formula_new(scene, text, columns, &error);
    g_assert_no_error(error);
    return formula;
}

/* Each pair is the same thing, said in two ways, all along a run. Rest lengths are as placed. */
static void test_values(void)
{
    static const char *const pairs[][2] = {
        {"0.5*{Mass 0.mass}*({Mass 0.vx}^2 + {Mass 0.vy}^2)", "{Mass 0.kinetic energy}"},
        {"0.5*{Spring 0.stiffness}*({Spring 0.length} - {Spring 0.rest_length})^2", "{Scene.stored energy}"},
        {"{Spring 0.stiffness}*{Spring 0.extension}", "{Spring 0.tension}"},
        {"sqrt({Mass 0.x}^2 + {Mass 0.y}^2)", "{Support 0.distance to Mass 0}"},
        {"{Mass 0.position.x} - {Mass 0.velocity.y}", "5"},
        {"if({Mass 0.x} < 0, -{Mass 0.x}, {Mass 0.x}) + t", "abs({Mass 0.x}) + t"},
    };
    g_autoptr(TinkerScene) scene = physics_scene(NULL, BLOCKS);
    g_autoptr(GArray) columns = tinker_columns_new();
    g_autoptr(GString) names = g_string_new(NULL);
    g_autoptr(GPtrArray) formulas = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_formula_free);
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(pairs); i++)
        g_ptr_array_add(formulas, formula_of(scene, columns, pairs[i / 2][i % 2]));
    for (guint c = 0; c < columns->len; c++)
        g_string_append_printf(names, "%s%s", c > 0 ? "," : "", g_array_index(columns, TinkerColumn, c).name);
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 3, .columns = names->str}, BLOCKS);
    for (gsize s = 0; s < physics_samples(run); s++) {
        g_autofree double *row = g_new(double, columns->len);
        for (guint c = 0; c < columns->len; c++)
            row[c] = physics_value(run, s, c);
        for (gsize i = 0; i < G_N_ELEMENTS(pairs); i++)
            physics_assert_near(
                pairs[i][0], tinker_formula_value(g_ptr_array_index(formulas, 2 * i), physics_time(run, s), row),
                tinker_formula_value(g_ptr_array_index(formulas, 2 * i + 1), physics_time(run, s), row), 1e-12);
    }
}

static void test_dimensions(void)
{
    const struct {
        const char *text, *unit; /* NULL: none comes out */
    } cases[] = {
        {"0.5*{Mass 0.mass}*{Mass 0.vx}^2", "J"}, {"{Spring 0.tension}/{Spring 0.stiffness}", "m"},
        {"{Mass 0.x} + {Mass 0.vx}", NULL},       {"{Mass 0.x} + t*{Mass 0.vx}", "m"},
        {"{Spring 0.length} - 2", NULL},          {"sqrt({Mass 0.x})", NULL},
    };
    g_autoptr(TinkerScene) scene = physics_scene(NULL, BLOCKS);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GArray) columns = tinker_columns_new();
        g_autoptr(TinkerFormula) formula = formula_of(scene, columns, cases[i].text);
        TinkerDimension dimension;
        g_autofree char *why = NULL;
        gboolean known = tinker_formula_dimension(formula, &dimension, &why);
        g_assert_cmpstr(known ? tinker_unit_si_symbol(dimension) : NULL, ==, cases[i].unit);
        g_assert_true(known == (why == NULL));
    }
}

/* The product rule, to first order. */
static void test_band(void)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, BLOCKS);
    g_autoptr(GArray) columns = tinker_columns_new();
    g_autoptr(TinkerFormula) formula = formula_of(scene, columns, "{Mass 0.x}*{Mass 0.y} + t");
    const double row[2] = {3, -4}, bands[2] = {1e-6, 2e-6};
    g_assert_cmpuint(columns->len, ==, 2);
    physics_assert_near("band", tinker_formula_band(formula, 7, row, bands), 4e-6 + 6e-6, 1e-14);
}

/* A torque and an energy have one dimension: what a formula is made of tells which it is, where it does. */
static void test_torques(void)
{
    static const char blocks[] =
        "{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"A\", \"solid\": false},"
        "{\"type\": \"torque\", \"name\": \"M\", \"ends\": [\"A\", \"Axle\"], \"amplitude\": 7}";
    static const char *const units[][2] = {
        {"{M.torque}", "N·m"},
        {"-2*{M.torque}/3", "N·m"},
        {"{M.torque} + abs({M.amplitude})", "N·m"},
        {"{A.kinetic energy}", "J"},
        {"if({A.angle} < 1, {M.torque}, 0)", "N·m"},
        {"{M.torque} + {A.kinetic energy}", NULL},
        {"{M.torque}*{A.angle}", NULL},
        {"{A.mass}*9.81*{A.x}/{A.x}", NULL},
    };
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    for (gsize i = 0; i < G_N_ELEMENTS(units); i++) {
        g_autoptr(GArray) columns = tinker_columns_new();
        g_autoptr(TinkerFormula) formula = formula_of(scene, columns, units[i][0]);
        g_assert_cmpstr(tinker_formula_unit(formula, TINKER_UNIT_SYSTEM_SI), ==, units[i][1]);
    }
}

static void test_mistakes(void)
{
    const struct {
        const char *text, *says;
    } bad[] = {
        {"Mass 0.y - 1", "unknown name \"Mass\" (a quantity of a block stands in braces, as in {Mass 0.x}"},
        {"y", "stands in braces"},
        {"2*{Mass 0.x", "column 3: \"{\" is not closed"},
        {"{Mass 0}", "column 1: {Mass 0}: there is no block"},
        {"1 + {Mass 0.speeed}",
         "column 5: {Mass 0.speeed}: Mass 0 has no quantity or property \"speeed\"; did you mean "
         "\"speed\"?"},
        {"{Mass 0.x} {Mass 0.y}", "column 12"},
    };
    g_autoptr(TinkerScene) scene = physics_scene(NULL, BLOCKS);
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autoptr(GArray) columns = tinker_columns_new();
        g_autoptr(GError) error = NULL;
        g_assert_null(tinker_formula_new(scene, bad[i].text, columns, &error));
        if (strstr(error->message, bad[i].says) == NULL) g_error("%s", error->message);
    }
}

static void add_tests(void)
{
    g_test_add_func("/measure/formula/values", test_values);
    g_test_add_func("/measure/formula/dimensions", test_dimensions);
    g_test_add_func("/measure/formula/band", test_band);
    g_test_add_func("/measure/formula/torques", test_torques);
    g_test_add_func("/measure/formula/mistakes", test_mistakes);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

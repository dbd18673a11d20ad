/* The plan's choice of methods and steps, which rests on counts and rates at the start. */
#include <math.h>
#include <string.h>

#include "plan-checks.h"

/* A stiff spring that holds still carries nothing: its step must be stable, and need not resolve it. */
static void test_still_stiffness(void)
{
    const char *scene =
        "{'type': 'support'}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2.5, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1, 'rest_length': 0.5},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1e6, 'rest_length': 1.5}";
    TinkerRunOptions options = planned_options("newmark", 0.02, 1e-3, 10);
    g_auto(Planned) planned = planned_new(scene, &options);
    g_assert_cmpuint(planned.plan->warnings->len, ==, 0);
    options.method = "rk4";
    g_auto(Planned) explicit = planned_new(scene, &options);
    planned_assert_warns(explicit.plan, "it will diverge");
}

/* A mass between two compressed springs leaves the line at sqrt((2 F / L) / m). */
static void test_sideways(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned = planned_new(
        "{'type': 'support'}, {'type': 'support', 'position': [2, 0]}, {'type': 'mass', 'position': [1, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 50, 'rest_length': 1.2},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Support 1'], 'stiffness': 50, 'rest_length': 1.2}",
        &options);
    g_assert_false(planned_island(&planned, 0)->straight);
    g_assert_cmpfloat(fabs(planned_island(&planned, 0)->sideways_growth / sqrt(20) - 1), <, 1e-6);
    g_assert_cmpfloat(fabs(planned_island(&planned, 0)->growth_max / sqrt(20) - 1), <, 1e-6);
    planned_assert_warns(planned.plan, "straight motion is unstable");
}

/* Fifty unit masses on springs of 1e2 and 1e8 N/m in turns, dampers of 2 % beside them, pairs let go on a ramp. */
static char *stiff_chain(void)
{
    GString *text = g_string_new("{'type': 'support'}");
    for (int i = 0; i < 50; i++) {
        g_string_append_printf(text, ",{'type': 'mass', 'position': [%.17g, 0]}", i + 1 + (i / 2 + 1) / 25.0);
        g_autofree char *from = i == 0 ? g_strdup("Support 0") : g_strdup_printf("Mass %d", i - 1);
        double stiffness = i & 1 ? 1e8 : 1e2;
        g_string_append_printf(text,
                               ",{'type': 'spring', 'ends': ['%s', 'Mass %d'], 'stiffness': %g, 'rest_length': 1},"
                               "{'type': 'damper', 'ends': ['%s', 'Mass %d'], 'damping': %.17g}",
                               from, i, stiffness, from, i, 0.02 * sqrt(stiffness));
    }
    return g_string_free(text, FALSE);
}

/* By counts: steps that stability forces on an explicit method are far more than an implicit one needs at a loose
 * tolerance, while a tight one is for the exact method. Both times the same, as nothing looks at a clock. */
static void test_stiff_chain(void)
{
    g_autofree char *text = stiff_chain();
    TinkerRunOptions loose = planned_options("auto", 0.01, 1e-4, 10), tight = planned_options("auto", 0.01, 1e-10, 10);
    g_auto(Planned) first = planned_new(text, &loose);
    g_auto(Planned) second = planned_new(text, &loose);
    g_auto(Planned) exact = planned_new(text, &tight);
    const TinkerIslandPlan *chosen = planned_island(&first, 0), *again = planned_island(&second, 0);
    g_assert_cmpstr(chosen->choice.method->id, ==, "newmark");
    g_assert_true(chosen->choice.method == again->choice.method && chosen->choice.step == again->choice.step);
    g_assert_cmpfloat(chosen->operations, ==, again->operations);
    g_assert_cmpfloat(chosen->choice.step, >, 1e-3);
    g_assert_cmpfloat(chosen->choice.step, <, 0.1);
    g_assert_cmpstr(planned_island(&exact, 0)->choice.method->id, ==, "exact");
    g_assert_cmpfloat(chosen->operations, <, 0.2 * planned_island(&exact, 0)->operations);
}

/* Its places at the end meet the tolerance: against the exact method. */
static void test_stiff_chain_meets_tolerance(void)
{
    g_autofree char *text = stiff_chain();
    const char *columns = "Mass 0.x, Mass 9.x, Mass 24.x, Mass 40.x, Mass 49.x";
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .tolerance = 1e-4, .duration = 10, .columns = columns}, "%s", text);
    g_autoptr(PhysicsRun) truth =
        physics_run(&(PhysicsOptions){.method = "exact", .duration = 10, .columns = columns}, "%s", text);
    for (gsize column = 0; column < 5; column++)
        physics_assert_near("place", physics_last(run, column), physics_last(truth, column), 1e-4);
}

/* Air that slows a falling mass is motion itself: no step may be so large that it is not resolved. Against the closed
 * form y = -(m g / c) t + (m / c)^2 g (1 - exp(-c t / m)). */
static void test_falling_in_air(void)
{
    const double m = 5, c = 0.1, t = 3, g = 9.81, decay = c / m;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .duration = t, .columns = "Mass 0.y"},
                    "{'type': 'gravity'}, {'type': 'wind', 'drag': 0.1}, {'type': 'mass', 'mass': 5}");
    physics_assert_near("y", physics_last(run, 0), g / decay * (-expm1(-decay * t) / decay - t), 1e-7);
}

/* A damper so strong that its steps are those of stability: a loose tolerance saves none, and would lose the energy
 * that the damper takes. */
static void test_strong_damper(void)
{
    const char *scene =
        "{'type': 'mass', 'position': [0, 0], 'velocity': [0, 1]}, {'type': 'mass', 'position': [1, 0.5]},"
        "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 1e5}";
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-2, 1);
    g_auto(Planned) planned = planned_new(scene, &options);
    g_assert_cmpfloat(planned_island(&planned, 0)->choice.tolerance, <, 1e-3);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .tolerance = 1e-2, .duration = 1}, "%s", scene);
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-3);
}

static void test_smooth(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 10);
    g_auto(Planned) planned =
        planned_new("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}",
                    &options);
    g_assert_cmpstr(planned_island(&planned, 0)->choice.method->id, ==, "dop853");
    g_assert_cmpfloat(planned_island(&planned, 0)->choice.tolerance, ==, 1e-9);
    g_assert_cmpfloat(planned_island(&planned, 0)->choice.step, ==, 0);
    g_assert_nonnull(strstr(planned_island(&planned, 0)->reason, "not stiff"));
}

/* A plugin's method, the midpoint one, has its limit beside the others where it is chosen: with damping alone 2 m / c.
 * Where its name is mistyped it is meant. */
static void test_plugin_method(void)
{
    const char *blocks = "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 2, 'position': [1, 0]},"
                         "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 8}";
    TinkerRunOptions options = planned_options("midpoint", 0.01, 1e-9, 1);
    g_auto(Planned) planned = planned_new(blocks, &options);
    g_autoptr(GPtrArray) methods = tinker_plan_limited_methods(planned_island(&planned, 0));
    const TinkerIntegrator *method = g_ptr_array_index(methods, methods->len - 1);
    g_assert_cmpstr(method->id, ==, "midpoint");
    physics_assert_near("limit", tinker_plan_stable_step(planned_island(&planned, 0), method), 2 * 2.0 / 8, 1e-6);
    options.method = "rk4";
    g_auto(Planned) other = planned_new(blocks, &options);
    g_autoptr(GPtrArray) builtin = tinker_plan_limited_methods(planned_island(&other, 0));
    g_assert_cmpuint(builtin->len, ==, methods->len - 1);
    options.method = "midpiont";
    g_auto(Planned) mistyped = planned_new(blocks, &options);
    g_assert_error(mistyped.error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD);
    g_assert_nonnull(strstr(mistyped.error->message, "there is no method \"midpiont\"; did you mean \"midpoint\"?"));
    g_assert_nonnull(strstr(mistyped.error->message, ", and of plugins "));
}

/* A pendulum on a ring about a place is that on one about a support there: the same method, forecast and number of
 * steps. */
static void test_ring(void)
{
    static const char *const blocks[] = {
        "{'type': 'gravity'}, {'type': 'mass', 'mass': 2, 'position': [3, 0]},"
        "{'type': 'ring', 'ends': ['Mass 0'], 'radius': 3}",
        "{'type': 'gravity'}, {'type': 'mass', 'mass': 2, 'position': [3, 0]}, {'type': 'support', 'solid': false},"
        "{'type': 'ring', 'ends': ['Mass 0', 'Support 0'], 'radius': 3}"};
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-12, 4);
    g_auto(Planned) place = planned_new(blocks[0], &options);
    g_auto(Planned) support = planned_new(blocks[1], &options);
    g_assert_cmpstr(planned_island(&place, 0)->choice.method->id, ==, planned_island(&support, 0)->choice.method->id);
    physics_assert_near("operations", planned_island(&place, 0)->operations / planned_island(&support, 0)->operations,
                        1, 0.02);
    const PhysicsOptions running = {.duration = 4, .columns = "Mass 0.x, Mass 0.vx"};
    g_autoptr(PhysicsRun) one = physics_run(&running, "%s", blocks[0]);
    g_autoptr(PhysicsRun) two = physics_run(&running, "%s", blocks[1]);
    physics_assert_near("steps", (double)one->summary->steps / (double)two->summary->steps, 1, 0.05);
    for (gsize i = 0; i < physics_samples(one); i++)
        physics_assert_near("x", physics_value(one, i, 0), physics_value(two, i, 0), 1e-9);
}

/* Operations an evaluation that are expected of a line of bars, each joint with a pin and this. */
static double joined_by(const char *beside)
{
    g_autoptr(GString) blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}");
    for (int i = 0; i < 60; i++)
        g_string_append_printf(blocks, ", {'type': 'bar', 'position': [%g, 0]}", i + 0.5);
    g_string_append(blocks, ", {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}");
    for (int i = 1; i < 60; i++) {
        const char *const types[] = {"'pin'", beside};
        for (int k = 0; k < (beside != NULL ? 2 : 1); k++)
            g_string_append_printf(blocks,
                                   ", {'type': %s, 'ends': [{'block': 'Bar %d', 'at': [0.5, 0]},"
                                   " {'block': 'Bar %d', 'at': [-0.5, 0]}]}",
                                   types[k], i - 1, i);
    }
    TinkerRunOptions options = planned_options("rk4", 0.01, 1e-9, 1);
    g_auto(Planned) planned = planned_new(blocks->str, &options);
    g_assert_no_error(planned.error);
    return planned_island(&planned, 0)->operations / planned_island(&planned, 0)->evaluations;
}

/* Two pins in one hole are solved as one is, along the chain. A slot beside a pin says nothing new, either, but its
 * rows depend on the pin's together, which takes several rounds of a general factor. */
static void test_dependent_rows(void)
{
    const double once = joined_by(NULL), twice = joined_by("'pin'"), slot = joined_by("'slot', 'angle': 1");
    g_assert_cmpfloat(twice, >, once);
    g_assert_cmpfloat(twice, <=, 2 * once);
    g_assert_cmpfloat(slot, >, 3 * twice);
}

static void add_tests(void)
{
    g_test_add_func("/physics/plan-choice/still-stiffness", test_still_stiffness);
    g_test_add_func("/physics/plan-choice/sideways", test_sideways);
    g_test_add_func("/physics/plan-choice/stiff-chain", test_stiff_chain);
    g_test_add_func("/physics/plan-choice/stiff-chain-meets-tolerance", test_stiff_chain_meets_tolerance);
    g_test_add_func("/physics/plan-choice/falling-in-air", test_falling_in_air);
    g_test_add_func("/physics/plan-choice/strong-damper", test_strong_damper);
    g_test_add_func("/physics/plan-choice/plugin-method", test_plugin_method);
    g_test_add_func("/physics/plan-choice/ring", test_ring);
    g_test_add_func("/physics/plan-choice/dependent-rows", test_dependent_rows);
    g_test_add_func("/physics/plan-choice/smooth", test_smooth);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

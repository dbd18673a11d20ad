/* What a plan tells: islands, redundancy, what is left out, and warnings exactly where they belong. */
#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "physics/system/method-call.h"
#include "plan-checks.h"

#define OSCILLATOR(name, y, stiffness)                                                                                 \
    "{'type': 'mass', 'name': '" name "', 'position': [2, " y "]},"                                                    \
    "{'type': 'spring', 'ends': [{'block': 'Support 0', 'at': [0, " y "]}, '" name "'], 'stiffness': " stiffness       \
    ", 'rest_length': 1.9}"

static void test_islands(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 10);
    g_auto(Planned) planned = planned_new("{'type': 'support'}," OSCILLATOR("A", "0", "100") "," OSCILLATOR(
                                              "B", "1", "400") ", {'type': 'mass', 'name': 'C', 'position': [5, 5]}",
                                          &options);
    g_assert_cmpuint(planned.plan->islands->len, ==, 3);
    g_assert_cmpfloat(fabs(planned_island(&planned, 0)->omega_max - 10), <, 1e-11);
    g_assert_cmpfloat(fabs(planned_island(&planned, 1)->omega_max - 20), <, 1e-11);
    g_assert_cmpfloat(planned_island(&planned, 2)->omega_max, ==, 0);
    g_assert_cmpuint(planned_island(&planned, 0)->blocks->len, ==, 2);
    g_assert_cmpuint(planned_island(&planned, 2)->blocks->len, ==, 1);
    g_assert_true(planned_island(&planned, 0)->linear && planned_island(&planned, 0)->straight);
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++)
        if (tinker_method_is_fixed_explicit(*each))
            g_assert_cmpfloat(tinker_plan_stable_step(planned_island(&planned, 2), *each), ==, INFINITY);
    planned_assert_holds(planned.plan->modelled, "3 islands");
}

/* A double pendulum that is let go level: gravity pulls along no rod, so that nothing brings it back at first. */
static void test_level(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned =
        planned_new("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0.7, -5e-17]},"
                    "{'type': 'mass', 'position': [1.1, -8e-17]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                    "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                    &options);
    g_assert_cmpfloat(planned_island(&planned, 0)->omega_max, ==, 0);
}

/* Three parallel rods between two bars: any one of them follows from the others; the last is named. */
static void test_redundant(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned =
        planned_new("{'type': 'gravity'}, {'type': 'support'}, {'type': 'support', 'position': [1, 0]},"
                    "{'type': 'support', 'position': [2, 0]},"
                    "{'type': 'mass', 'position': [0.3, -1]}, {'type': 'mass', 'position': [1.3, -1]},"
                    "{'type': 'mass', 'position': [2.3, -1]},"
                    "{'type': 'rod', 'name': 'Bar', 'ends': ['Mass 0', 'Mass 1']},"
                    "{'type': 'rod', 'name': 'Second bar', 'ends': ['Mass 1', 'Mass 2']},"
                    "{'type': 'rod', 'name': 'Left', 'ends': ['Support 0', 'Mass 0']},"
                    "{'type': 'rod', 'name': 'Middle', 'ends': ['Support 1', 'Mass 1']},"
                    "{'type': 'rod', 'name': 'Right', 'ends': ['Support 2', 'Mass 2']},"
                    "{'type': 'rod', 'name': 'Long bar', 'ends': ['Mass 0', 'Mass 2']}",
                    &options);
    g_assert_cmpuint(planned.plan->redundant->len, ==, 1);
    g_assert_cmpstr(g_ptr_array_index(planned.plan->redundant, 0), ==, "Long bar");
    g_assert_cmpint(planned_island(&planned, 0)->redundant_rows, ==, 1);
    g_assert_cmpint(planned_island(&planned, 0)->degrees_of_freedom, ==, 1);
    planned_assert_holds(planned.plan->modelled, "redundant: Long bar");
}

/* A bar of three masses: the long rod follows from the others, and what lies between is named. */
static void test_straight_bar(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned =
        planned_new("{'type': 'mass', 'name': 'A'}, {'type': 'mass', 'name': 'B', 'position': [1, 0]},"
                    "{'type': 'mass', 'name': 'C', 'position': [3, 0]}, {'type': 'rod', 'ends': ['A', 'B']},"
                    "{'type': 'rod', 'ends': ['B', 'C']},"
                    "{'type': 'rod', 'name': 'Long', 'ends': ['A', 'C']}",
                    &options);
    g_assert_cmpint(planned_island(&planned, 0)->degrees_of_freedom, ==, 3);
    planned_assert_holds(planned.plan->modelled, "redundant: Long");
    planned_assert_holds(planned.plan->modelled, "straight bars: B kept in line");
}

/* A mass alone: everything else is left out, and said to be. */
static void test_bare(void)
{
    TinkerRunOptions options = planned_options("rk4", 0.01, 1e-9, 1);
    g_auto(Planned) bare = planned_new("{'type': 'mass'}", &options);
    static const char *const out[] = {"rotation", "gravity", "air",     "constraint", "contact",
                                      "supports", "damping", "driving", "connectors"};
    for (gsize i = 0; i < G_N_ELEMENTS(out); i++)
        planned_assert_holds(bare.plan->left_out, out[i]);
    g_assert_cmpint(planned_count_holding(bare.plan->left_out, "error estimate"), ==, 0);
    g_assert_cmpuint(bare.plan->warnings->len, ==, 0);
    options.estimate = FALSE;
    g_auto(Planned) full = planned_new(
        "{'type': 'gravity'}, {'type': 'wind', 'drag': 1}, {'type': 'support', 'solid': false}, {'type': 'mass', "
        "'position': [0, -2]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 1},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': 'cosine', 'amplitude': 0.25, 'frequency': 2}",
        &options);
    static const char *const in[] = {"gravity", "air", "constraint", "motion of supports", "damping", "connectors"};
    for (gsize i = 0; i < G_N_ELEMENTS(in); i++)
        g_assert_cmpint(planned_count_holding(full.plan->left_out, in[i]), ==, 0);
    planned_assert_holds(full.plan->left_out, "contact");
    planned_assert_holds(full.plan->left_out, "error estimate");
    planned_assert_holds(full.plan->modelled, "starts displaced by (0.25, 0) m");
    planned_assert_holds(full.plan->modelled, "9.81 m/s");
}

/* Blows leave out the friction of pins, where there is any. */
static void test_rubbing_pin(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    for (int rubs = 0; rubs < 2; rubs++) {
        g_autofree char *blocks =
            g_strdup_printf("{'type': 'support', 'solid': false}, {'type': 'disc', 'position': [0, 0], 'solid': false},"
                            "{'type': 'pin', 'ends': ['Support 0', 'Disc 0'], 'friction_radius': 0.1, 'friction': %g}",
                            0.3 * rubs);
        g_auto(Planned) planned = planned_new(blocks, &options);
        g_assert_cmpint(planned_count_holding(planned.plan->left_out, "friction of pins in blows"), ==, rubs);
    }
}

/* A rope over the middle of a disc does not turn it; one over a support leaves nothing out. */
static void test_wheel_under_a_rope(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    for (int heavy = 0; heavy < 2; heavy++) {
        g_autofree char *blocks =
            g_strdup_printf("{'type': 'support', 'solid': false}, {'type': 'disc', 'position': [0, 0], 'solid': false},"
                            "{'type': 'mass', 'position': [-1, -2]}, {'type': 'mass', 'position': [1, -2]},"
                            "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                            "{'type': 'rope', 'ends': ['Mass 0', '%s', 'Mass 1']}",
                            heavy ? "Disc 0" : "Support 0");
        g_auto(Planned) planned = planned_new(blocks, &options);
        g_assert_cmpint(planned_count_holding(planned.plan->left_out, "Rope 0 slides over Disc 0"), ==, heavy);
    }
}

/* A gear ties angles alone, which a weld, that holds places as well, does not. */
static void test_gears(void)
{
    static const char *const ties[] = {"gear", "weld"};
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    for (gsize i = 0; i < G_N_ELEMENTS(ties); i++) {
        g_autofree char *blocks = g_strdup_printf("{'type': 'support'}, {'type': 'disc', 'position': [0, 0]},"
                                                  "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                                                  "{'type': '%s', 'name': 'Tie', 'ends': ['Support 0', 'Disc 0']}",
                                                  ties[i]);
        g_auto(Planned) planned = planned_new(blocks, &options);
        g_assert_cmpint(planned_count_holding(planned.plan->left_out, "forces on bearings by Tie"), ==, i == 0);
    }
}

/* Of two bodies at least it is told that nothing holds them apart, whether they could meet or not. */
static void test_bodies_pass(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    g_auto(Planned) one = planned_new("{'type': 'gravity'}, {'type': 'mass'}", &options);
    g_assert_cmpint(planned_count_holding(one.plan->left_out, "pass through each other"), ==, 0);
    g_auto(Planned) two =
        planned_new("{'type': 'gravity'}, {'type': 'mass'}, {'type': 'mass', 'position': [90, 0]}", &options);
    g_assert_cmpint(planned_count_holding(two.plan->left_out, "contact between bodies: they pass through each other"),
                    ==, 1);
}

/* A box on a box, on a smooth floor: the two rub on each other. */
static void test_rough_bodies(void)
{
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    static const struct {
        double friction;
        int told;
    } cases[] = {{0.8, 0}, {0, 1}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *blocks = g_strdup_printf(
            "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], 'width': 40, 'static_friction': 0,"
            "'dynamic_friction': 0}, {'type': 'box', 'width': 6, 'height': 0.2, 'position': [0, 0.1], "
            "'static_friction': "
            "%g, 'dynamic_friction': %g}, {'type': 'box', 'width': 0.6, 'height': 0.6, 'position': [0, 0.5]}",
            cases[i].friction, cases[i].friction);
        g_auto(Planned) planned = planned_new(blocks, &options);
        g_assert_cmpint(planned_count_holding(planned.plan->left_out, "every solid side is smooth"), ==, cases[i].told);
        g_assert_cmpint(planned_count_holding(planned.plan->left_out, "no block takes energy"), ==, cases[i].told);
    }
}

/* Contact is modelled where a body could meet a solid side, and its forces only where something touches. That no
 * support has a solid side is not said of bodies that meet. */
static void test_contact(void)
{
    static const char *const scene = "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], %s},"
                                     "{'type': 'mass', 'position': [0, %g]}";
    TinkerRunOptions options = planned_options("auto", 0.01, 1e-9, 1);
    g_autofree char *above = g_strdup_printf(scene, "'solid': true", 2.0);
    g_auto(Planned) falls = planned_new(above, &options);
    planned_assert_holds(falls.plan->modelled, "contact of 1 body with 1 solid side, with friction");
    planned_assert_holds(falls.plan->left_out, "nothing touches at the start");
    g_assert_cmpstr(planned_island(&falls, 0)->choice.method->id, ==, "exact");
    g_autofree char *smooth = g_strdup_printf(scene, "'static_friction': 0, 'dynamic_friction': 0", 0.4);
    g_auto(Planned) rests = planned_new(smooth, &options);
    planned_assert_holds(rests.plan->left_out, "every solid side is smooth");
    g_assert_cmpint(planned_count_holding(rests.plan->left_out, "nothing touches"), ==, 0);
    g_assert_cmpstr(planned_island(&rests, 0)->choice.method->id, !=, "exact");
    g_autofree char *open = g_strdup_printf(scene, "'solid': false", 0.4);
    g_auto(Planned) passes = planned_new(open, &options);
    planned_assert_holds(passes.plan->left_out, "nothing has a solid side");
    g_auto(Planned) alone =
        planned_new("{'type': 'disc', 'position': [0, 0]}, {'type': 'disc', 'position': [2, 0]}", &options);
    planned_assert_holds(alone.plan->modelled, "contact among 2 bodies that meet");
    planned_assert_holds(alone.plan->left_out, "contact with supports: none has a solid side");
    g_assert_cmpint(planned_count_holding(alone.plan->left_out, "contact and friction"), ==, 0);
}

/* omega = 10: rk4 is stable up to 0.2828 s. Above it the warning names the limit; where h omega is above 0.5 the step
 * is stable and wrong; below that nothing is said. Implicit methods have no limit, but resolve no more. */
static void test_warnings(void)
{
    static const struct {
        const char *method;
        double step;
        const char *text; /* NULL: no warning */
    } cases[] = {
        {"rk4", 0.284, "rk4 is stable up to a step of 0.283 s"},
        {"rk4", 0.282, "steps a period"},
        {"rk4", 0.051, "steps a period"},
        {"rk4", 0.049, NULL},
        {"verlet", 0.201, "verlet is stable up to a step of 0.2 s"},
        {"verlet", 0.199, "steps a period"},
        {"semi-implicit-euler", 0.201, "semi-implicit-euler is stable up to a step of 0.2 s"},
        {"newmark", 0.3, "steps a period"},
        {"newmark", 0.049, NULL},
        {"dop853", 100, NULL},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        TinkerRunOptions options = planned_options(cases[i].method, cases[i].step, 1e-6, 100);
        g_auto(Planned) planned = planned_new("{'type': 'support'}," OSCILLATOR("A", "0", "100"), &options);
        g_assert_cmpuint(planned.plan->warnings->len, ==, cases[i].text != NULL);
        if (cases[i].text != NULL) planned_assert_warns(planned.plan, cases[i].text);
        /* a run says the same before it starts */
        g_autoptr(GPtrArray) warnings = tinker_warnings_new();
        TinkerChoice choice;
        g_assert_true(
            tinker_plan_choose(g_ptr_array_index(planned.islands, 0), &options, &choice, warnings, &planned.error));
        g_assert_cmpuint(warnings->len, ==, planned.plan->warnings->len);
        g_assert_cmpstr(choice.method->id, ==, cases[i].method);
        if (warnings->len > 0)
            g_assert_cmpstr(tinker_warnings_text(warnings, 0), ==, tinker_warnings_text(planned.plan->warnings, 0));
    }
}

static void test_refused(void)
{
    TinkerRunOptions options = planned_options("rk5", 0.01, 1e-9, 1);
    g_auto(Planned) unknown = planned_new("{'type': 'mass'}", &options);
    g_assert_error(unknown.error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD);
    options.method = "exact";
    g_auto(Planned) nonlinear =
        planned_new("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}",
                    &options);
    g_assert_error(nonlinear.error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD);
    g_assert_nonnull(strstr(nonlinear.error->message, "Mass 0"));
}

static void add_tests(void)
{
    g_test_add_func("/physics/plan/gears", test_gears);
    g_test_add_func("/physics/plan/islands", test_islands);
    g_test_add_func("/physics/plan/level", test_level);
    g_test_add_func("/physics/plan/redundant", test_redundant);
    g_test_add_func("/physics/plan/straight-bar", test_straight_bar);
    g_test_add_func("/physics/plan/bare", test_bare);
    g_test_add_func("/physics/plan/rough-bodies", test_rough_bodies);
    g_test_add_func("/physics/plan/contact", test_contact);
    g_test_add_func("/physics/plan/bodies-pass", test_bodies_pass);
    g_test_add_func("/physics/plan/rubbing-pin", test_rubbing_pin);
    g_test_add_func("/physics/plan/wheel-under-a-rope", test_wheel_under_a_rope);
    g_test_add_func("/physics/plan/warnings", test_warnings);
    g_test_add_func("/physics/plan/refused", test_refused);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

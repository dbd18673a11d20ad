/* The plan: islands, redundancy, what is left out, warnings exactly where they belong, and choices that rest on counts.
 */
#include "physics-fixture.h"

#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/system/method-call.h"

typedef struct {
    TinkerScene *scene;
    TinkerModel *model;
    GPtrArray *islands;
    TinkerPlan *plan; /* NULL where it was refused */
    GError *error;
} Planned;

static void planned_clear(Planned *planned)
{
    tinker_plan_free(planned->plan);
    g_ptr_array_unref(planned->islands);
    tinker_model_free(planned->model);
    tinker_scene_free(planned->scene);
    g_clear_error(&planned->error);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Planned, planned_clear)

static TinkerRunOptions options_of(const char *method, double step, double tolerance, double duration)
{
    return (TinkerRunOptions){.duration = duration,
                              .interval = 0.01 * duration,
                              .method = method,
                              .step = step,
                              .tolerance = tolerance,
                              .spectral_radius = 0.8,
                              .estimate = TRUE};
}

static Planned plan(const char *blocks, const TinkerRunOptions *options)
{
    g_autoptr(GError) error = NULL;
    Planned planned = {.scene = physics_scene(NULL, blocks)};
    planned.model = tinker_model_new(planned.scene, &error);
    if (planned.model != NULL) planned.islands = tinker_islands_new(planned.model, &error);
    if (planned.islands == NULL) g_error("%s", error->message);
    planned.plan = tinker_plan_new(planned.model, planned.islands, options, &planned.error);
    return planned;
}

static const TinkerIslandPlan *island(const Planned *planned, guint number)
{
    g_assert_cmpuint(number, <, planned->plan->islands->len);
    return g_ptr_array_index(planned->plan->islands, number);
}

/* How many of the sentences hold a text. */
static int count_holding(const GPtrArray *sentences, const char *text)
{
    int count = 0;
    for (guint i = 0; i < sentences->len; i++)
        count += strstr(g_ptr_array_index(sentences, i), text) != NULL;
    return count;
}

static void assert_holds(const GPtrArray *sentences, const char *text)
{
    if (count_holding(sentences, text) == 1) return;
    for (guint i = 0; i < sentences->len; i++)
        g_test_message("%s", (const char *)g_ptr_array_index(sentences, i));
    g_test_fail_printf("\"%s\" is in %d sentences, not in one", text, count_holding(sentences, text));
}

#define OSCILLATOR(name, y, stiffness)                                                                                 \
    "{'type': 'mass', 'name': '" name "', 'position': [2, " y "]},"                                                    \
    "{'type': 'spring', 'ends': [{'block': 'Support 0', 'at': [0, " y "]}, '" name "'], 'stiffness': " stiffness       \
    ", 'rest_length': 1.9}"

static void test_islands(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 10);
    g_auto(Planned) planned = plan("{'type': 'support'}," OSCILLATOR("A", "0", "100") "," OSCILLATOR(
                                       "B", "1", "400") ", {'type': 'mass', 'name': 'C', 'position': [5, 5]}",
                                   &options);
    g_assert_cmpuint(planned.plan->islands->len, ==, 3);
    g_assert_cmpfloat(fabs(island(&planned, 0)->omega_max - 10), <, 1e-11);
    g_assert_cmpfloat(fabs(island(&planned, 1)->omega_max - 20), <, 1e-11);
    g_assert_cmpfloat(island(&planned, 2)->omega_max, ==, 0);
    g_assert_cmpuint(island(&planned, 0)->blocks->len, ==, 2);
    g_assert_cmpuint(island(&planned, 2)->blocks->len, ==, 1);
    g_assert_true(island(&planned, 0)->linear && island(&planned, 0)->straight);
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++)
        if (tinker_method_is_fixed_explicit(*each))
            g_assert_cmpfloat(tinker_plan_stable_step(island(&planned, 2), *each), ==, INFINITY);
    assert_holds(planned.plan->modelled, "3 islands");
}

/* A double pendulum that is let go level: gravity pulls along no rod, so that nothing brings it back at first. */
static void test_level(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned =
        plan("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0.7, -5e-17]},"
             "{'type': 'mass', 'position': [1.1, -8e-17]},"
             "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
             "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
             &options);
    g_assert_cmpfloat(island(&planned, 0)->omega_max, ==, 0);
}

/* Three parallel rods between two bars: any one of them follows from the others; the last is named. */
static void test_redundant(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned = plan("{'type': 'gravity'}, {'type': 'support'}, {'type': 'support', 'position': [1, 0]},"
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
    g_assert_cmpint(island(&planned, 0)->redundant_rows, ==, 1);
    g_assert_cmpint(island(&planned, 0)->degrees_of_freedom, ==, 1);
    assert_holds(planned.plan->modelled, "redundant: Long bar");
}

/* A bar of three masses: the long rod follows from the others, and what lies between is named. */
static void test_straight_bar(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned =
        plan("{'type': 'mass', 'name': 'A'}, {'type': 'mass', 'name': 'B', 'position': [1, 0]},"
             "{'type': 'mass', 'name': 'C', 'position': [3, 0]}, {'type': 'rod', 'ends': ['A', 'B']},"
             "{'type': 'rod', 'ends': ['B', 'C']},"
             "{'type': 'rod', 'name': 'Long', 'ends': ['A', 'C']}",
             &options);
    g_assert_cmpint(island(&planned, 0)->degrees_of_freedom, ==, 3);
    assert_holds(planned.plan->modelled, "redundant: Long");
    assert_holds(planned.plan->modelled, "straight bars: B kept in line");
}

/* A mass alone: everything else is left out, and said to be. */
static void test_bare(void)
{
    TinkerRunOptions options = options_of("rk4", 0.01, 1e-9, 1);
    g_auto(Planned) bare = plan("{'type': 'mass'}", &options);
    static const char *const out[] = {"rotation", "gravity", "air",     "constraint", "contact",
                                      "supports", "damping", "driving", "connectors"};
    for (gsize i = 0; i < G_N_ELEMENTS(out); i++)
        assert_holds(bare.plan->left_out, out[i]);
    g_assert_cmpint(count_holding(bare.plan->left_out, "error estimate"), ==, 0);
    g_assert_cmpuint(bare.plan->warnings->len, ==, 0);
    options.estimate = FALSE;
    g_auto(Planned) full = plan(
        "{'type': 'gravity'}, {'type': 'wind', 'drag': 1}, {'type': 'support', 'solid': false}, {'type': 'mass', "
        "'position': [0, -2]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 1},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': 'cosine', 'amplitude': 0.25, 'frequency': 2}",
        &options);
    static const char *const in[] = {"gravity", "air", "constraint", "motion of supports", "damping", "connectors"};
    for (gsize i = 0; i < G_N_ELEMENTS(in); i++)
        g_assert_cmpint(count_holding(full.plan->left_out, in[i]), ==, 0);
    assert_holds(full.plan->left_out, "contact");
    assert_holds(full.plan->left_out, "error estimate");
    assert_holds(full.plan->modelled, "starts displaced by (0.25, 0) m");
    assert_holds(full.plan->modelled, "9.81 m/s");
}

/* Blows leave out the friction of pins, where there is any. */
static void test_rubbing_pin(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    for (int rubs = 0; rubs < 2; rubs++) {
        g_autofree char *blocks =
            g_strdup_printf("{'type': 'support', 'solid': false}, {'type': 'disc', 'solid': false},"
                            "{'type': 'pin', 'ends': ['Support 0', 'Disc 0'], 'friction_radius': 0.1, 'friction': %g}",
                            0.3 * rubs);
        g_auto(Planned) planned = plan(blocks, &options);
        g_assert_cmpint(count_holding(planned.plan->left_out, "friction of pins in blows"), ==, rubs);
    }
}

/* A rope over the middle of a disc does not turn it; one over a support leaves nothing out. */
static void test_wheel_under_a_rope(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    for (int heavy = 0; heavy < 2; heavy++) {
        g_autofree char *blocks =
            g_strdup_printf("{'type': 'support', 'solid': false}, {'type': 'disc', 'solid': false},"
                            "{'type': 'mass', 'position': [-1, -2]}, {'type': 'mass', 'position': [1, -2]},"
                            "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                            "{'type': 'rope', 'ends': ['Mass 0', '%s', 'Mass 1']}",
                            heavy ? "Disc 0" : "Support 0");
        g_auto(Planned) planned = plan(blocks, &options);
        g_assert_cmpint(count_holding(planned.plan->left_out, "Rope 0 slides over Disc 0"), ==, heavy);
    }
}

/* Of two bodies at least it is told that nothing holds them apart, whether they could meet or not. */
static void test_bodies_pass(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    g_auto(Planned) one = plan("{'type': 'gravity'}, {'type': 'mass'}", &options);
    g_assert_cmpint(count_holding(one.plan->left_out, "pass through each other"), ==, 0);
    g_auto(Planned) two =
        plan("{'type': 'gravity'}, {'type': 'mass'}, {'type': 'mass', 'position': [90, 0]}", &options);
    g_assert_cmpint(count_holding(two.plan->left_out, "contact between bodies: they pass through each other"), ==, 1);
}

/* Contact is modelled where a body could meet a solid side, and its forces only where something touches. That no
 * support has a solid side is not said of bodies that meet. */
static void test_contact(void)
{
    static const char *const scene = "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], %s},"
                                     "{'type': 'mass', 'position': [0, %g]}";
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    g_autofree char *above = g_strdup_printf(scene, "'solid': true", 2.0);
    g_auto(Planned) falls = plan(above, &options);
    assert_holds(falls.plan->modelled, "contact of 1 body with 1 solid side, with friction");
    assert_holds(falls.plan->left_out, "nothing touches at the start");
    g_assert_cmpstr(island(&falls, 0)->choice.method->id, ==, "exact");
    g_autofree char *smooth = g_strdup_printf(scene, "'static_friction': 0, 'dynamic_friction': 0", 0.4);
    g_auto(Planned) rests = plan(smooth, &options);
    assert_holds(rests.plan->left_out, "every solid side is smooth");
    g_assert_cmpint(count_holding(rests.plan->left_out, "nothing touches"), ==, 0);
    g_assert_cmpstr(island(&rests, 0)->choice.method->id, !=, "exact");
    g_autofree char *open = g_strdup_printf(scene, "'solid': false", 0.4);
    g_auto(Planned) passes = plan(open, &options);
    assert_holds(passes.plan->left_out, "nothing has a solid side");
    g_auto(Planned) alone = plan("{'type': 'disc'}, {'type': 'disc', 'position': [2, 0]}", &options);
    assert_holds(alone.plan->modelled, "contact among 2 bodies that meet");
    assert_holds(alone.plan->left_out, "contact with supports: none has a solid side");
    g_assert_cmpint(count_holding(alone.plan->left_out, "contact and friction"), ==, 0);
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
        TinkerRunOptions options = options_of(cases[i].method, cases[i].step, 1e-6, 100);
        g_auto(Planned) planned = plan("{'type': 'support'}," OSCILLATOR("A", "0", "100"), &options);
        g_assert_cmpuint(planned.plan->warnings->len, ==, cases[i].text != NULL);
        if (cases[i].text != NULL) assert_holds(planned.plan->warnings, cases[i].text);
        /* a run says the same before it starts */
        g_autoptr(GPtrArray) warnings = g_ptr_array_new_with_free_func(g_free);
        TinkerChoice choice;
        g_assert_true(
            tinker_plan_choose(g_ptr_array_index(planned.islands, 0), &options, &choice, warnings, &planned.error));
        g_assert_cmpuint(warnings->len, ==, planned.plan->warnings->len);
        g_assert_cmpstr(choice.method->id, ==, cases[i].method);
        if (warnings->len > 0) g_assert_cmpstr(warnings->pdata[0], ==, planned.plan->warnings->pdata[0]);
    }
}

/* A stiff spring that holds still carries nothing: its step must be stable, and need not resolve it. */
static void test_still_stiffness(void)
{
    const char *scene =
        "{'type': 'support'}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2.5, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1, 'rest_length': 0.5},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1e6, 'rest_length': 1.5}";
    TinkerRunOptions options = options_of("newmark", 0.02, 1e-3, 10);
    g_auto(Planned) planned = plan(scene, &options);
    g_assert_cmpuint(planned.plan->warnings->len, ==, 0);
    options.method = "rk4";
    g_auto(Planned) explicit = plan(scene, &options);
    assert_holds(explicit.plan->warnings, "it will diverge");
}

/* A mass between two compressed springs leaves the line at sqrt((2 F / L) / m). */
static void test_sideways(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 1);
    g_auto(Planned) planned =
        plan("{'type': 'support'}, {'type': 'support', 'position': [2, 0]}, {'type': 'mass', 'position': [1, 0]},"
             "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 50, 'rest_length': 1.2},"
             "{'type': 'spring', 'ends': ['Mass 0', 'Support 1'], 'stiffness': 50, 'rest_length': 1.2}",
             &options);
    g_assert_false(island(&planned, 0)->straight);
    g_assert_cmpfloat(fabs(island(&planned, 0)->sideways_growth / sqrt(20) - 1), <, 1e-6);
    g_assert_cmpfloat(fabs(island(&planned, 0)->growth_max / sqrt(20) - 1), <, 1e-6);
    assert_holds(planned.plan->warnings, "straight motion is unstable");
}

static void test_refused(void)
{
    TinkerRunOptions options = options_of("rk5", 0.01, 1e-9, 1);
    g_auto(Planned) unknown = plan("{'type': 'mass'}", &options);
    g_assert_error(unknown.error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD);
    options.method = "exact";
    g_auto(Planned) nonlinear = plan("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                                     "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}",
                                     &options);
    g_assert_error(nonlinear.error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD);
    g_assert_nonnull(strstr(nonlinear.error->message, "Mass 0"));
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
    TinkerRunOptions loose = options_of("auto", 0.01, 1e-4, 10), tight = options_of("auto", 0.01, 1e-10, 10);
    g_auto(Planned) first = plan(text, &loose);
    g_auto(Planned) second = plan(text, &loose);
    g_auto(Planned) exact = plan(text, &tight);
    const TinkerIslandPlan *chosen = island(&first, 0), *again = island(&second, 0);
    g_assert_cmpstr(chosen->choice.method->id, ==, "newmark");
    g_assert_true(chosen->choice.method == again->choice.method && chosen->choice.step == again->choice.step);
    g_assert_cmpfloat(chosen->operations, ==, again->operations);
    g_assert_cmpfloat(chosen->choice.step, >, 1e-3);
    g_assert_cmpfloat(chosen->choice.step, <, 0.1);
    g_assert_cmpstr(island(&exact, 0)->choice.method->id, ==, "exact");
    g_assert_cmpfloat(chosen->operations, <, 0.2 * island(&exact, 0)->operations);
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
    TinkerRunOptions options = options_of("auto", 0.01, 1e-2, 1);
    g_auto(Planned) planned = plan(scene, &options);
    g_assert_cmpfloat(island(&planned, 0)->choice.tolerance, <, 1e-3);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .tolerance = 1e-2, .duration = 1}, "%s", scene);
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-3);
}

static void test_smooth(void)
{
    TinkerRunOptions options = options_of("auto", 0.01, 1e-9, 10);
    g_auto(Planned) planned = plan("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                                   "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}",
                                   &options);
    g_assert_cmpstr(island(&planned, 0)->choice.method->id, ==, "dop853");
    g_assert_cmpfloat(island(&planned, 0)->choice.tolerance, ==, 1e-9);
    g_assert_cmpfloat(island(&planned, 0)->choice.step, ==, 0);
    g_assert_nonnull(strstr(island(&planned, 0)->reason, "not stiff"));
}

/* A plugin's method, the midpoint one, has its limit beside the others where it is chosen: with damping alone 2 m / c.
 * Where its name is mistyped it is meant. */
static void test_plugin_method(void)
{
    const char *blocks = "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 2, 'position': [1, 0]},"
                         "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 8}";
    TinkerRunOptions options = options_of("midpoint", 0.01, 1e-9, 1);
    g_auto(Planned) planned = plan(blocks, &options);
    g_autoptr(GPtrArray) methods = tinker_plan_limited_methods(island(&planned, 0));
    const TinkerIntegrator *method = g_ptr_array_index(methods, methods->len - 1);
    g_assert_cmpstr(method->id, ==, "midpoint");
    physics_assert_near("limit", tinker_plan_stable_step(island(&planned, 0), method), 2 * 2.0 / 8, 1e-6);
    options.method = "rk4";
    g_auto(Planned) other = plan(blocks, &options);
    g_autoptr(GPtrArray) builtin = tinker_plan_limited_methods(island(&other, 0));
    g_assert_cmpuint(builtin->len, ==, methods->len - 1);
    options.method = "midpiont";
    g_auto(Planned) mistyped = plan(blocks, &options);
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
    TinkerRunOptions options = options_of("auto", 0.01, 1e-12, 4);
    g_auto(Planned) place = plan(blocks[0], &options);
    g_auto(Planned) support = plan(blocks[1], &options);
    g_assert_cmpstr(island(&place, 0)->choice.method->id, ==, island(&support, 0)->choice.method->id);
    physics_assert_near("operations", island(&place, 0)->operations / island(&support, 0)->operations, 1, 0.02);
    const PhysicsOptions running = {.duration = 4, .columns = "Mass 0.x, Mass 0.vx"};
    g_autoptr(PhysicsRun) one = physics_run(&running, "%s", blocks[0]);
    g_autoptr(PhysicsRun) two = physics_run(&running, "%s", blocks[1]);
    physics_assert_near("steps", (double)one->summary->steps / (double)two->summary->steps, 1, 0.05);
    for (gsize i = 0; i < physics_samples(one); i++)
        physics_assert_near("x", physics_value(one, i, 0), physics_value(two, i, 0), 1e-9);
}

static void add_tests(void)
{
    g_test_add_func("/physics/plan/islands", test_islands);
    g_test_add_func("/physics/plan/level", test_level);
    g_test_add_func("/physics/plan/redundant", test_redundant);
    g_test_add_func("/physics/plan/straight-bar", test_straight_bar);
    g_test_add_func("/physics/plan/bare", test_bare);
    g_test_add_func("/physics/plan/contact", test_contact);
    g_test_add_func("/physics/plan/bodies-pass", test_bodies_pass);
    g_test_add_func("/physics/plan/rubbing-pin", test_rubbing_pin);
    g_test_add_func("/physics/plan/wheel-under-a-rope", test_wheel_under_a_rope);
    g_test_add_func("/physics/plan/warnings", test_warnings);
    g_test_add_func("/physics/plan/still-stiffness", test_still_stiffness);
    g_test_add_func("/physics/plan/sideways", test_sideways);
    g_test_add_func("/physics/plan/refused", test_refused);
    g_test_add_func("/physics/plan/stiff-chain", test_stiff_chain);
    g_test_add_func("/physics/plan/stiff-chain-meets-tolerance", test_stiff_chain_meets_tolerance);
    g_test_add_func("/physics/plan/falling-in-air", test_falling_in_air);
    g_test_add_func("/physics/plan/strong-damper", test_strong_damper);
    g_test_add_func("/physics/plan/plugin-method", test_plugin_method);
    g_test_add_func("/physics/plan/ring", test_ring);
    g_test_add_func("/physics/plan/smooth", test_smooth);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

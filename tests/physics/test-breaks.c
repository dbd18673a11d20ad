/* Breaks: what switches within a run is neither missed nor smeared. */
#include "physics-fixture.h"

#include "numerics/integrators.h"

#include <math.h>

static const char pulse_scene[] = "{'type': 'mass', 'mass': 2}, {'type': 'motor', 'ends': ['Mass 0'],"
                                  " 'waveform': {'expression': '300*pulse(t, 5, 5.01)'}}";

/* 300 N for 10 ms give 2 kg a speed of 1.5 m/s, after 5 s of rest. */
static void assert_pulse_felt(const PhysicsRun *run)
{
    double state[4];
    physics_state(run, "Mass 0", state);
    physics_assert_near("vx", state[2], 1.5, 1e-12);
    physics_assert_near("vy", state[3], 0, 0);
}

static void test_pulse_adaptive(void)
{
    for (int digits = 3; digits <= 12; digits++) {
        static const char *const methods[] = {"dop853", "dopri5", "auto"};
        for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
            g_autoptr(PhysicsRun) run =
                physics_run(&(PhysicsOptions){.method = methods[m], .duration = 10, .tolerance = pow(10, -digits)},
                            "%s", pulse_scene);
            assert_pulse_felt(run);
        }
    }
}

static void test_pulse_fixed_steps(void)
{
    static const double steps[] = {0.01, 0.03, 0.07, 0.3, 1.0 / 3, 3, 7};
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        if ((*method)->flags & TINKER_INTEGRATOR_ADAPTIVE) continue;
        for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
            g_autoptr(PhysicsRun) run = physics_run(
                &(PhysicsOptions){.method = (*method)->id, .duration = 10, .step = steps[i]}, "%s", pulse_scene);
            assert_pulse_felt(run);
        }
    }
}

/* A pulse so short that only a search for breaks can find it, and one behind it. */
static void test_two_short_pulses(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1000, .tolerance = 1e-6},
                    "{'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'],"
                    " 'waveform': {'expression': '1e6*pulse(t, 500, 500.000001) - 1e6*pulse(t, 700, 700.000001)'}}");
    double state[4];
    physics_state(run, "Mass 0", state);
    /* The width of the pulses is that of their decimal times as doubles, to an ulp of 700. */
    physics_assert_near("x", state[0], 200, 200 * 3e-7);
    physics_assert_near("vx", state[2], 0, 3e-7);
}

/* sign(sin t) as a force: the velocity is the triangle wave. */
static void test_square_wave(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "rk4", .step = 0.25, .duration = 20, .interval = 0.5, .columns = "Mass 0.vx"},
        "{'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': 'square(t)'}}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double phase = fmod(physics_time(run, i), 2 * G_PI);
        physics_assert_near("vx", physics_value(run, i, 0), phase < G_PI ? phase : 2 * G_PI - phase, 1e-12);
    }
}

/* A sample on a break shows the state behind it, at the start, within the run and at its end. */
static void test_samples_on_breaks(void)
{
    static const char scene[] = "{'type': 'mass', 'mass': 2}, {'type': 'motor', 'ends': ['Mass 0'],"
                                " 'waveform': {'expression': '4*step(t - %g)'}}";
    static const double jumps[] = {0, 1, 2};
    for (gsize j = 0; j < G_N_ELEMENTS(jumps); j++) {
        g_autofree char *blocks = g_strdup_printf(scene, jumps[j]);
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 2, .interval = 0.5, .columns = "Motor 0.force, Mass 0.ax, Mass 0.vx"}, "%s",
            blocks);
        g_assert_cmpuint(physics_samples(run), ==, 5);
        for (gsize i = 0; i < physics_samples(run); i++) {
            double t = physics_time(run, i);
            g_autofree char *what = g_strdup_printf("force at %g s, with a jump at %g s,", t, jumps[j]);
            physics_assert_near(what, physics_value(run, i, 0), t >= jumps[j] ? 4 : 0, 0);
            physics_assert_near("ax", physics_value(run, i, 1), t >= jumps[j] ? 2 : 0, 0);
            physics_assert_near("vx", physics_value(run, i, 2), t >= jumps[j] ? 2 * (t - jumps[j]) : 0, 1e-14);
        }
    }
}

/* Breaks keep a method's order: the same scene with a jump at a time that no step meets, closed form by pieces. */
static double jump_error(double step)
{
    const double jump = sqrt(0.5), w = 5;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "rk4", .step = step, .duration = 2},
                    "{'type': 'support', 'position': [-1, 0]}, {'type': 'mass'},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1},"
                    "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '25*step(t - sqrt(0.5))'}}");
    double state[4];
    physics_state(run, "Mass 0", state);
    return hypot(state[0] - (1 - cos(w * (2 - jump))), (state[2] - w * sin(w * (2 - jump))) / w);
}

static void test_order_across_a_jump(void)
{
    double order = log2(jump_error(0.02) / jump_error(0.01));
    physics_assert_near("order", order, 4, 0.15);
}

static void add_tests(void)
{
    g_test_add_func("/physics/breaks/pulse-adaptive", test_pulse_adaptive);
    g_test_add_func("/physics/breaks/pulse-fixed-steps", test_pulse_fixed_steps);
    g_test_add_func("/physics/breaks/two-short-pulses", test_two_short_pulses);
    g_test_add_func("/physics/breaks/square-wave", test_square_wave);
    g_test_add_func("/physics/breaks/samples-on-breaks", test_samples_on_breaks);
    g_test_add_func("/physics/breaks/order-across-a-jump", test_order_across_a_jump);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

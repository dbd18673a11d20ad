/* Breaks: what switches within a run is neither missed nor smeared. */
#include "physics-fixture.h"

#include "numerics/methods/integrators.h"
#include "physics/model/breaks.h"
#include "physics/model/model.h"

#include <math.h>
#include <string.h>

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

#define DRIVEN                                                                                                         \
    "{'type': 'mass'}, {'type': 'motor', 'name': 'Drive', 'ends': ['Mass 0'], 'waveform': {'expression': '%s'}}"

/* No method steps across a pole, whatever its order and sign: 1/(t - 1) has no integral across 1. */
static void test_poles(void)
{
    static const struct {
        const char *text, *place;
    } poles[] = {{"1/(t-1)", "t = 1 s"},
                 {"1/(t-1)^2", "t = 1 s"},
                 {"1e-9/(t-1)", "t = 1 s"},
                 {"1 + log((t-1)^2)", "t = 1 s"},
                 {"sqrt(1-t)", "t = 1 s"},
                 {"tan(t)", "t = 1.570796327 s"},
                 {"2/(if(t<1.5, t, 9)-1)", "t = 1 s"}};
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++) {
        if ((*each)->flags & TINKER_INTEGRATOR_LINEAR) continue; /* takes no such waveform */
        for (gsize i = 0; i < G_N_ELEMENTS(poles); i++) {
            PhysicsOptions options = {.method = (*each)->id, .step = 0.03, .duration = 3, .interval = 0.7};
            g_autoptr(PhysicsRun) run = physics_try(&options, DRIVEN, poles[i].text);
            physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "Drive: at ", poles[i].place, NULL);
            g_assert_cmpfloat(run->summary->simulated_s, <=, 1.5708);
            g_assert_cmpfloat(run->summary->simulated_s, >, 0.9);
        }
        PhysicsOptions options = {.method = (*each)->id, .step = 0.03, .duration = 3};
        g_autoptr(PhysicsRun) regular = physics_run(&options, DRIVEN, "1/(1+t^2) + sin(t-1.2345678)/(t-1.2345678)");
        g_assert_cmpfloat(regular->summary->simulated_s, ==, 3);
    }
}

/* What switches faster than a run can follow is told before the run, and ends it. */
/* What a scene that switches without end is told, by a run and before one. */
static void assert_endless(PhysicsRun *run, const char *block)
{
    physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, block, ": from t = ", "it switches every ", NULL);
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_model_check_breaks(run->model, 3, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE);
    g_assert_true(g_str_has_prefix(error->message, block));
}

static void test_endless_switching(void)
{
    static const char *const endless[] = {"floor(1e15*t)", "mod(t, 1e-12)", "floor(1e17*t)", "square(1e13*t)"};
    for (gsize i = 0; i < G_N_ELEMENTS(endless); i++) {
        PhysicsOptions options = {.method = i % 2 == 0 ? "rk4" : "dop853", .duration = 3};
        g_autoptr(PhysicsRun) run = physics_try(&options, DRIVEN, endless[i]);
        assert_endless(run, "Drive");
    }
    static const double intervals[] = {1e-12, 1e-17, 0};
    for (gsize i = 0; i < G_N_ELEMENTS(intervals); i++) {
        g_autoptr(PhysicsRun) run =
            physics_try(&(PhysicsOptions){.method = "rk4", .duration = 3},
                        "{'type': 'mass'}, {'type': 'ticking', 'name': 'Clock', 'interval': %g}", intervals[i]);
        assert_endless(run, "Clock");
    }
    /* many switches, and short ones, have an end */
    static const char *const fine[] = {"square(3000*t)", "pulse(t, 1, 1 + 1e-12)"};
    for (gsize i = 0; i < G_N_ELEMENTS(fine); i++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = "rk4", .duration = 3}, DRIVEN, fine[i]);
        g_autoptr(GError) error = NULL;
        tinker_model_check_breaks(run->model, 3, &error);
        g_assert_no_error(error);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/breaks/pulse-adaptive", test_pulse_adaptive);
    g_test_add_func("/physics/breaks/pulse-fixed-steps", test_pulse_fixed_steps);
    g_test_add_func("/physics/breaks/two-short-pulses", test_two_short_pulses);
    g_test_add_func("/physics/breaks/square-wave", test_square_wave);
    g_test_add_func("/physics/breaks/samples-on-breaks", test_samples_on_breaks);
    g_test_add_func("/physics/breaks/poles", test_poles);
    g_test_add_func("/physics/breaks/endless-switching", test_endless_switching);
    g_test_add_func("/physics/breaks/order-across-a-jump", test_order_across_a_jump);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

/* Long runs whose energy is held: how their phase goes against Jacobi's elliptic functions, that the energy stays, and
 * which runs are not of that kind. */
#include "physics-fixture.h"

#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "test-systems.h"

#include <math.h>

#define GRAVITY "{'type': 'gravity', 'acceleration': 9.81}"
#define SUPPORT "{'type': 'support', 'solid': false}"
/* 170 degrees from hanging on a rod of 2 m. */
#define HIGH "{'type': 'mass', 'position': [0.34729635533386066, 1.969615506024416]}"
#define ROD  "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}"
/* A weight that swings and stretches its spring; nothing of it is constrained. */
#define SPRING_PENDULUM                                                                                                \
    SUPPORT "," GRAVITY ",{'type': 'mass', 'position': [1.2, -0.4]},"                                                  \
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 40}"

/* The largest of the errors of places, by the 4 m of the swing, and of speeds, by the greatest. */
static double pendulum_error(const PhysicsRun *run, double duration)
{
    Pendulum pendulum;
    pendulum_init(&pendulum, 2, 9.81, 170 * G_PI / 180, 0);
    double state[4], q[2], v[2], fastest = 2 * sqrt(9.81 * 2) * sin(85 * G_PI / 180);
    physics_state(run, "Mass 0", state);
    pendulum_exact(&pendulum, duration, q, v);
    return fmax(hypot(state[0] - q[0], state[1] - q[1]) / 4, hypot(state[2] - v[0], state[3] - v[1]) / fastest);
}

/* As much as 300 swings at a tolerance of 1e-9 miss by themselves is 1e-4: the energy has drifted. */
static void test_phase(void)
{
    const double duration = 2000.5;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .duration = duration, .interval = 500, .tolerance = 1e-9},
                    SUPPORT "," GRAVITY "," HIGH "," ROD);
    g_assert_cmpstr(run->summary->method, ==, "dop853");
    physics_assert_near("the pendulum", pendulum_error(run, duration), 0, 2e-6);
    g_assert_cmpfloat(run->summary->constraint_position_error, <=, 1e-14);
    g_assert_cmpfloat(run->summary->constraint_velocity_error, <=, 1e-13);
}

/* An accuracy is met by the first try, and the estimate is not below the truth. */
static void test_accuracy(void)
{
    const double duration = 3000.5;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = duration, .interval = 100, .accuracy = 1e-6, .estimate = TRUE},
        SUPPORT "," GRAVITY "," HIGH "," ROD);
    double error = pendulum_error(run, duration);
    g_assert_cmpuint(run->summary->tries->len, ==, 1);
    physics_assert_near("the pendulum", error, 0, 1e-6);
    g_assert_cmpfloat(error, <=, run->summary->error_estimate);
}

/* Energy (J) of a mass of 1 kg on the spring, by hand. */
static double spring_energy(const double state[4])
{
    double stretch = hypot(state[0], state[1]) - 1;
    return 0.5 * (state[2] * state[2] + state[3] * state[3]) + 9.81 * state[1] + 20 * stretch * stretch;
}

/* Without a rod, and with each sample where it is looked at: a loose tolerance loses some 1e-3 of it. */
static void test_energy(void)
{
    double state[4], start[4] = {1.2, -0.4, 0, 0};
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 3000, .interval = 1000, .tolerance = 1e-6}, SPRING_PENDULUM);
    physics_state(run, "Mass 0", state);
    physics_assert_near("the energy", spring_energy(state), spring_energy(start), 1e-12 * 40);
}

/* What an island's run is chosen to be. */
static TinkerChoice choice_of(const char *method, double duration, const char *blocks)
{
    TinkerChoice choice;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, NULL);
    g_autoptr(GPtrArray) islands = tinker_islands_for(model, FALSE, NULL);
    g_autoptr(GPtrArray) warnings = tinker_warnings_new();
    TinkerRunOptions options = {
        .duration = duration, .interval = 1, .method = method, .step = 0.01, .tolerance = 1e-9, .spectral_radius = 0.8};
    g_assert_true(tinker_plan_choose(g_ptr_array_index(islands, 0), &options, &choice, warnings, NULL));
    return choice;
}

static void test_where(void)
{
    static const char *const pendulum = SUPPORT "," GRAVITY "," HIGH "," ROD;
    static const char *const others[] = {
        SUPPORT "," GRAVITY "," HIGH "," ROD ",{'type': 'wind', 'drag': 0.001}",
        SUPPORT "," GRAVITY "," HIGH "," ROD ",{'type': 'motor', 'ends': ['Mass 0'], 'frequency': 1}",
        SUPPORT "," GRAVITY "," HIGH "," ROD
                ",{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1, 'frequency': 3}",
        SPRING_PENDULUM ",{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 0.01}",
        "{'type': 'support'}," GRAVITY "," HIGH "," ROD, /* its solid side may be met */
    };
    g_assert_true(choice_of("auto", 1e4, pendulum).holds_energy);
    g_assert_true(choice_of("auto", 1e4, SPRING_PENDULUM).holds_energy);
    g_assert_false(choice_of("auto", 10, pendulum).holds_energy);    /* short */
    g_assert_false(choice_of("dop853", 1e4, pendulum).holds_energy); /* that method and no other */
    for (gsize i = 0; i < G_N_ELEMENTS(others); i++)
        g_assert_false(choice_of("auto", 1e4, others[i]).holds_energy);
}

static void add_tests(void)
{
    g_test_add_func("/hold-energy/phase", test_phase);
    g_test_add_func("/hold-energy/accuracy", test_accuracy);
    g_test_add_func("/hold-energy/energy", test_energy);
    g_test_add_func("/hold-energy/where", test_where);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

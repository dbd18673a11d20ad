/* Plugins that fail in the middle of a run: it stops at once, names block, callback and time, and keeps what it had. */
#include "physics-fixture.h"
#include "physics/model/model.h"

#include <math.h>
#include <string.h>

enum {
    MODE_NAN,
    MODE_INFINITE,
    MODE_FAILS,
    MODE_FAILS_SILENTLY,
    MODE_WALL,
    MODE_NEVER,
    MODE_NONE,
    MODE_NO_STATUS,
    MODE_NAN_ENERGY,
    MODE_INFINITE_ENERGY
};

/* The middle one of three is at fault. */
static PhysicsRun *with_fault(const char *method, int mode)
{
    return physics_try(
        &(PhysicsOptions){.method = method,
                          .duration = 3,
                          .interval = 0.125,
                          .step = 0.125,
                          .tolerance = 1e-6,
                          .columns = "Mass 0.x, Mass 1.x"},
        "{'type': 'mass', 'velocity': [1, 0]}, {'type': 'mass', 'position': [0, 1]},"
        "{'type': 'faulty', 'ends': ['Mass 1'], 'mode': 6}, {'type': 'faulty', 'ends': ['Mass 0'], 'mode': %d},"
        "{'type': 'faulty', 'ends': ['Mass 1'], 'mode': 6}",
        mode);
}

static void test_fault(gconstpointer data)
{
    static const char *const methods[] = {"rk4", "verlet", "semi-implicit-euler", "dopri5", "dop853"};
    static const char *const words[] = {"is not a number", "is not a number", "the fuse has blown (put in a new one)",
                                        ""};
    int mode = GPOINTER_TO_INT(data);
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = with_fault(methods[m], mode);
        const char *who = mode == MODE_FAILS_SILENTLY ? ": its force at t = " : "Faulty 1: its force at t = ";
        physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "Faulty", who, words[mode], NULL);
        /* A method that looks at the start of its steps alone notices a step later. */
        g_assert_cmpfloat(run->summary->simulated_s, <=, 1.125);
        g_assert_cmpuint(physics_samples(run), >, 0);
        for (gsize i = 0; i < physics_samples(run); i++)
            physics_assert_near("x", physics_value(run, i, 0), physics_time(run, i), 1e-14);
    }
}

/* An energy that is none is the block's fault, and no method's. */
static void test_energy(void)
{
    static const char *const methods[] = {"rk4", "verlet", "dop853"};
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(methods); i++) {
        g_autoptr(PhysicsRun) run = with_fault(methods[i / 2], i % 2 ? MODE_INFINITE_ENERGY : MODE_NAN_ENERGY);
        physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "Faulty 1: its energy at t = ",
                               "is not a number (block type faulty of the plugin org.example.test.faulty)", NULL);
        g_assert_null(strstr(run->error->message, "diverged"));
        g_assert_cmpfloat(run->summary->valid_until, <=, 1);
    }
}

/* Samples up to the fault are all there. */
static void test_samples_before_a_fault(void)
{
    g_autoptr(PhysicsRun) run = with_fault("rk4", MODE_NAN);
    g_assert_cmpuint(physics_samples(run), ==, 9);
    g_assert_cmpfloat(run->summary->simulated_s, ==, 1);
    g_assert_cmpfloat(run->summary->valid_until, ==, 1);
}

/* A plugin that cannot tell its force behind a wall asks for smaller steps, and gets them: the mass turns back at the
 * place where v^2 / 2 = -ln(1 - x). */
static void test_smaller_steps(void)
{
    for (int digits = 2; digits <= 10; digits += 2) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .duration = 3, .interval = 0.01, .tolerance = pow(10, -digits), .columns = "Mass 0.x, Mass 0.vx"},
            "{'type': 'mass', 'velocity': [4, 0]}, {'type': 'faulty', 'ends': ['Mass 0'], 'mode': 4}");
        double farthest = 0;
        for (gsize i = 0; i < physics_samples(run); i++) {
            g_assert_cmpfloat(physics_value(run, i, 0), <, 1);
            farthest = fmax(farthest, physics_value(run, i, 0));
        }
        if (digits < 10) continue;
        physics_assert_near("vx", physics_last(run, 1), -sqrt(16 + 2 * log1p(-physics_last(run, 0))), 1e-6);
        g_assert_cmpfloat(farthest, >, 0.999);
        g_assert_cmpfloat(farthest, <, 1 - exp(-8));
    }
}

/* A fixed step cannot become smaller: the run ends with the plugin's reason. Nor can one that is never small
 * enough, whose plugin gives none. */
static void test_steps_that_cannot_shrink(void)
{
    g_autoptr(PhysicsRun) fixed =
        physics_try(&(PhysicsOptions){.method = "rk4", .step = 0.1},
                    "{'type': 'mass', 'velocity': [40, 0]}, {'type': 'faulty', 'ends': ['Mass 0'], 'mode': 4}");
    physics_assert_refused(fixed, TINKER_MODEL_ERROR_RUN, "the run stopped at t = 0 s: Faulty 0: its force at t = ",
                           "nobody knows what is behind the wall", NULL);
    g_autoptr(PhysicsRun) never = with_fault("dop853", MODE_NEVER);
    physics_assert_refused(never, TINKER_MODEL_ERROR_RUN, "the run stopped at t = 1 s: ", NULL);
    g_assert_null(strstr(never->error->message, "s: ;"));
}

/* An answer that is no status ends the run as a failure does: nobody tries smaller steps for it. */
static void test_no_status(void)
{
    static const char *const methods[] = {"rk4", "dopri5", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) fails = with_fault(methods[m], MODE_FAILS_SILENTLY);
        g_autoptr(PhysicsRun) other = with_fault(methods[m], MODE_NO_STATUS);
        physics_assert_refused(other, TINKER_MODEL_ERROR_RUN, ": its force at t = ", NULL);
        g_assert_cmpint(other->summary->evaluations, ==, fails->summary->evaluations);
    }
}

/* With a rod in the scene the start is evaluated while compiling: the same fault there has a reason as well. */
static void test_fault_at_the_start(void)
{
    g_autoptr(PhysicsRun) run =
        physics_try(&(PhysicsOptions){0}, "{'type': 'support'}, {'type': 'mass', 'position': [2, 0]},"
                                          "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                                          "{'type': 'faulty', 'ends': ['Mass 0'], 'mode': 4}");
    g_assert_nonnull(run->error);
    g_assert_nonnull(strstr(run->error->message, "nobody knows what is behind the wall"));
}

static void add_tests(void)
{
    g_test_add_data_func("/physics/faults/nan", GINT_TO_POINTER(MODE_NAN), test_fault);
    g_test_add_data_func("/physics/faults/infinite", GINT_TO_POINTER(MODE_INFINITE), test_fault);
    g_test_add_data_func("/physics/faults/fails", GINT_TO_POINTER(MODE_FAILS), test_fault);
    g_test_add_data_func("/physics/faults/fails-silently", GINT_TO_POINTER(MODE_FAILS_SILENTLY), test_fault);
    g_test_add_func("/physics/faults/no-status", test_no_status);
    g_test_add_func("/physics/faults/energy", test_energy);
    g_test_add_func("/physics/faults/samples-before-a-fault", test_samples_before_a_fault);
    g_test_add_func("/physics/faults/smaller-steps", test_smaller_steps);
    g_test_add_func("/physics/faults/steps-that-cannot-shrink", test_steps_that_cannot_shrink);
    g_test_add_func("/physics/faults/fault-at-the-start", test_fault_at_the_start);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

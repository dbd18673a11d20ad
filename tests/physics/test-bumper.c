/* A bumper against the solution of the spring and damper that it is while it pushes. */
#include "contact-checks.h"

#include <math.h>

/* A mass of 1 kg that comes at v from where the bumper begins. */
typedef struct {
    double v, omega, decay, damped; /* m/s, rad/s, 1/s, rad/s */
} Blow;

static Blow blow_of(double v, double stiffness, double damping)
{
    Blow blow = {v, sqrt(stiffness), 0.5 * damping, 0};
    blow.damped = sqrt(blow.omega * blow.omega - blow.decay * blow.decay);
    return blow;
}

static double speed(double t, const Blow *blow)
{
    const double a = blow->damped * t;
    return blow->v * exp(-blow->decay * t) * (cos(a) - blow->decay / blow->damped * sin(a));
}

static double push(double t, const void *data)
{
    const Blow *blow = data;
    const double x = blow->v / blow->damped * exp(-blow->decay * t) * sin(blow->damped * t);
    return blow->omega * blow->omega * x + 2 * blow->decay * speed(t, blow);
}

/* It leaves when nothing is left of the push, while the bumper is still shorter than its length. */
static void test_rebound(void)
{
    static const double dampings[] = {0, 4, 16};
    for (gsize i = 0; i < G_N_ELEMENTS(dampings); i++) {
        const Blow blow = blow_of(2, 400, dampings[i]);
        const double over = contact_bisect(0.25 * G_PI / blow.damped, 1.01 * G_PI / blow.damped, push, &blow);
        const double rebound = speed(over, &blow);
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 2, .tolerance = 1e-11, .columns = "Mass 0.vx, Mass 0.x, Bumper 0.force"},
            "{'type': 'support', 'position': [3, 0], 'solid': false},"
            "{'type': 'mass', 'velocity': [2, 0]},"
            "{'type': 'bumper', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 400, 'damping': %g, 'length': 1}",
            dampings[i]);
        physics_assert_near("rebound", physics_last(run, 0), rebound, 1e-8);
        const double x = 2 + blow.v / blow.damped * exp(-blow.decay * over) * sin(blow.damped * over);
        physics_assert_near("place", physics_last(run, 1), x + rebound * (1 - over), 1e-8);
        physics_assert_near("never pulls", physics_last(run, 2), 0, 0);
        physics_assert_near("what its damper took", run->summary->books[TINKER_BOOK_DAMPERS],
                            0.5 * (rebound * rebound - 4), 1e-7);
        physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, 1e-8);
    }
}

/* Placed at its length, a mass at rest on it from above sinks by m g / k and swings to twice that. */
static void test_as_placed(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = G_PI / sqrt(1000), .columns = "Mass 0.y, Mass 0.vy"},
                    CONTACT_WEIGHT "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 1]},"
                                   "{'type': 'bumper', 'ends': ['Support 0', 'Mass 0']}");
    physics_assert_near("lowest", physics_last(run, 0), 1 - 2 * CONTACT_GRAVITY / 1000, 1e-10);
    physics_assert_near("turns", physics_last(run, 1), 0, 1e-9);
}

static void add_tests(void)
{
    g_test_add_func("/physics/bumper/rebound", test_rebound);
    g_test_add_func("/physics/bumper/as-placed", test_as_placed);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

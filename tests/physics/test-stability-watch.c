/* A motion that becomes stiffer than it began is told of, once; one that does not is not. */
#include "physics-fixture.h"

#include <string.h>

static guint warnings_about(const PhysicsRun *run, const char *word)
{
    guint count = 0;
    for (guint i = 0; i < run->summary->warnings->len; i++)
        if (strstr(tinker_warnings_text(run->summary->warnings, i), word) != NULL) count++;
    return count;
}

/* A heavy mass is thrown outwards and draws out two springs, T = k d^3 with d the stretch, whose stiffness 3 k d^2
 * grows; a light one hangs between them. At a stretch of 3 m each they hold it with 540 N/m: 735 rad/s, 3.8 ms for rk4.
 */
static PhysicsRun *thrown(double step)
{
    return physics_try(
        &(PhysicsOptions){.method = "rk4", .step = step, .duration = 5, .interval = 0.5, .columns = "Mass 0.x"},
        "{'type': 'support'}, {'type': 'mass', 'mass': 1e4, 'position': [1.01, 0], 'velocity': [2, 0]},"
        "{'type': 'mass', 'mass': 1e-3, 'position': [1.005, 0.3]},"
        "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1, 'length': 1},"
        "{'type': 'cubic', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 10, 'length': 0.29},"
        "{'type': 'cubic', 'ends': ['Support 0', 'Mass 1'], 'stiffness': 10, 'length': 1.04}");
}

static void test_stiffening(void)
{
    g_autoptr(PhysicsRun) run = thrown(0.004);
    for (guint i = 0; i < run->summary->warnings->len; i++)
        g_test_message("%s", tinker_warnings_text(run->summary->warnings, i));
    if (run->error != NULL) g_test_message("%s", run->error->message);
    g_assert_cmpuint(warnings_about(run, "is stable up to a step of about"), ==, 1);
    g_assert_cmpuint(warnings_about(run, "has become stiffer"), ==, 1);
}

static void test_fine_steps(void)
{
    g_autoptr(PhysicsRun) run = thrown(0.0002);
    g_assert_cmpuint(warnings_about(run, "stable up to"), ==, 0);
}

static void add_tests(void)
{
    g_test_add_func("/physics/stability-watch/stiffening", test_stiffening);
    g_test_add_func("/physics/stability-watch/fine-steps", test_fine_steps);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

/* A load that statics does not divide: how it is shared is of where things lie, not of how they came there. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

/* A box and a mass on a rod are thrown onto a rough slope and come to rest. Both corners of the box rub, and the rod
 * may pull or push: by other tolerances the last of hundreds of events is another one, and all is held alike. */
static void test_tied_on_a_slope(void)
{
    static const double tolerances[] = {1e-9, 1e-10, 1e-11, 1e-12};
    double first[2];
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = "dop853",
                              .tolerance = tolerances[i],
                              .duration = 1.5,
                              .columns = "Rod 0.tension, Mass 0.friction force, Box 0.vx"},
            CONTACT_WEIGHT "{'type': 'support', 'position': [0, -0.1], 'width': 60, 'height': 0.2, 'orientation': 0.15,"
                           " 'restitution': 0.4, 'static_friction': 0.24, 'dynamic_friction': 0.2},"
                           "{'type': 'box', 'mass': 2, 'width': 0.6, 'height': 0.2, 'position': [0, 0.25],"
                           " 'velocity': [-0.5279095475713476, 0]},"
                           "{'type': 'mass', 'position': [0.5, 0.863989428866474]},"
                           "{'type': 'rod', 'ends': ['Box 0', 'Mass 0']}");
        physics_assert_near("the speed", physics_last(run, 2), 0, 1e-12);
        for (gsize k = 0; i == 0 && k < 2; k++)
            first[k] = physics_last(run, k);
        for (gsize k = 0; k < 2; k++)
            physics_assert_near("as with another tolerance", physics_last(run, k), first[k], 1e-6);
    }
}

/* A disc lies in a groove of two slopes of 45 degrees; a torque grows until it turns there, at
 * sqrt(2) mu R m g / (1 + mu^2). Until then nothing moves but by rounding, which is no speed: nothing parts or strikes,
 * however often the share of the load changes on the way. */
static void test_twisted_in_a_groove(void)
{
    static const struct {
        const char *method;
        double step;
    } cases[] = {{"verlet", 1e-2},  {"verlet", 1e-3}, {"verlet6", 1e-2},
                 {"newmark", 1e-2}, {"rk4", 1e-2},    {"dopri5", 0}};
    const double friction = 0.3, rate = 5, weight = 2 * CONTACT_GRAVITY;
    const double slips = sqrt(2) * friction * 0.5 * weight / (1 + friction * friction) / rate;
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .method = cases[i].method, .step = cases[i].step, .duration = 1, .columns = "Disc 0.angle"},
            CONTACT_WEIGHT
            "{'type': 'support', 'orientation': '-45 deg', 'width': 10, 'height': 0, 'dynamic_friction': 0.3,"
            "'static_friction': 0.3, 'position': [-%.17g, %.17g]},"
            "{'type': 'support', 'orientation': '45 deg', 'width': 10, 'height': 0, 'dynamic_friction': 0.3,"
            "'static_friction': 0.3, 'position': [%.17g, %.17g]},"
            "{'type': 'disc', 'mass': 2, 'radius': 0.5, 'position': [0, %.17g]},"
            "{'type': 'torque', 'ends': ['Disc 0'], 'waveform': {'expression': '5*t'}}",
            sqrt(8), sqrt(8), sqrt(8), sqrt(8), sqrt(0.5));
        contact_assert_count(run, "take-off", 0);
        contact_assert_count(run, "impact", 0);
        contact_assert_count(run, "rest", 0);
        contact_assert_event(run, "slip", "Disc 0, Support 0", slips, 1e-9);
        contact_assert_event(run, "slip", "Disc 0, Support 1", slips, 1e-9);
        g_assert_cmpuint(run->summary->warnings->len, ==, 0);
        /* both rub with what they bear, which takes the torque at the slip: what is left of 5 t turns it */
        physics_assert_near("turns", physics_last(run, 0), rate * pow(1 - slips, 3) / 6 / 0.25,
                            fmax(cases[i].step * cases[i].step, 1e-8));
    }
}

/* A box that a slider guides strikes another flush and pushes it along a rough table: friction between the two may bear
 * some of the pushed one's weight, and so much less of that rubs on the table. The motion hangs on a share that the
 * laws leave open: the run says so, and takes the same one whatever rounding came before. The second time all is
 * mirrored. */
static const char guided[] =
    CONTACT_WEIGHT "{'type': 'support', 'position': [0, 1], 'width': 0.1, 'height': 0.1, 'solid': false},"
                   "{'type': 'disc', 'mass': 1, 'radius': 0.2, 'position': [0, 1], 'solid': false},"
                   "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                   "{'type': 'box', 'mass': 1, 'width': 0.5, 'height': 0.2, 'position': [0, 0.5],"
                   " 'velocity': [%.17g, 0]},"
                   "{'type': 'support', 'position': [0, 0.5], 'width': 0.1, 'height': 0.1, 'solid': false},"
                   "{'type': 'slider', 'ends': ['Support 1', 'Box 0']},"
                   "{'type': 'rack', 'ends': ['Disc 0', 'Box 0'], 'radius': 0.2},"
                   "{'type': 'torque', 'ends': ['Disc 0'], 'amplitude': %.17g, 'frequency': 4},"
                   "{'type': 'box', 'mass': 0.6, 'width': 0.2, 'height': 0.2, 'position': [%.17g, 0.51]},"
                   "{'type': 'support', 'position': [%.17g, 0.36], 'width': 2, 'height': 0.1,"
                   " 'static_friction': 0.24, 'dynamic_friction': 0.2}";

static PhysicsRun *run_guided(double tolerance, double side)
{
    g_autofree char *scene = g_strdup_printf(guided, side * 1.0, side * 1.7, side * 0.51, side * 0.8);
    return physics_run(&(PhysicsOptions){.method = "dop853",
                                         .tolerance = tolerance,
                                         .duration = 1.2,
                                         .columns = "Box 0.x, Box 0.vx, Box 1.x, Box 1.vx"},
                       "%s", scene);
}

static void test_guided_push(void)
{
    static const double tolerances[] = {1e-9, 1e-10, 1e-11, 1e-12};
    double first[4];
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(tolerances); i++) {
        const double side = i % 2 == 0 ? 1 : -1;
        g_autoptr(PhysicsRun) run = run_guided(tolerances[i / 2], side);
        gboolean said = FALSE;
        for (guint k = 0; k < run->summary->warnings->len; k++)
            said |= strstr(tinker_warnings_text(run->summary->warnings, k), "share a load") != NULL;
        g_assert_true(said);
        for (gsize k = 0; i == 0 && k < G_N_ELEMENTS(first); k++)
            first[k] = physics_last(run, k);
        for (gsize k = 0; k < G_N_ELEMENTS(first); k++)
            physics_assert_near("as the first time", side * physics_last(run, k), first[k], 1e-6);
    }
}

static void add_tests(void)
{
    g_test_add_func("/contact-share/twisted-in-a-groove", test_twisted_in_a_groove);
    g_test_add_func("/contact-share/guided-push", test_guided_push);
    g_test_add_func("/contact-share/tied-on-a-slope", test_tied_on_a_slope);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

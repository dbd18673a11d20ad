/* Bodies that lean on one another with friction: forces that grow beyond all bounds, and loads that nothing divides. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

/* A light box is caught between a plate that cannot yield and a heavy box that rolls over it. Its friction wedges: the
 * forces grow as a power of the time that is left, and an impulse ends it. Impulses step by step, which know no forces,
 * converge to the same motion. */
static void test_grows_beyond_bounds(void)
{
    static const char *const blocks = CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 3}, {'type': 'plate', 'mass': 0.047706419181337757, 'position': [-0.12123753735986487, "
        "0.20824763398465782], 'corners': [[-0.33169697247781615, -0.20824763398465773], [0.33169697247781615, "
        "-0.20824763398465773], [0.21723624790437485, 0.2393584731178004], [-0.21723624790437485, "
        "0.2393584731178004]]}, {'type': 'box', 'name': 'Light', 'mass': 0.034209093444719257, 'width': "
        "0.4792963481756185, 'height': 0.5171999126144271, 'position': [-0.14179869305577597, 0.80016748281177663], "
        "'orientation': -0.75412818652027003, 'velocity': [-0.22273300863634821, 0.0015031433686202014], "
        "'angular_velocity': 0.63175669254248712}, {'type': 'box', 'name': 'Heavy', 'mass': 3.9600838742137774, "
        "'width': 0.30327694493006552, 'height': 0.55290286431225288, 'position': [-0.070291979538304517, "
        "1.2910305966315847], 'orientation': 0.91072995148915425, 'velocity': [0.79457352664786463, "
        "-1.4675928852193689], 'angular_velocity': 13.291832353928454}";
    PhysicsOptions options = {.method = "dop853", .tolerance = 1e-11, .duration = 0.03};
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
    contact_assert_count(run, "jam", 1);
    g_assert_cmpfloat(run->summary->energy_balance_error, <=, 1e-9);
    contact_check_converges(blocks, "Heavy.x, Heavy.y, Light.x, Light.y", 0.03, 1e-3, 10);
}

/* Discs in a pyramid, which a spring draws askew: the load has many shares, and with which of them contacts slip is
 * none of the choices that the motion leaves open. The run comes to its end, and its books close. */
static void test_pyramid(void)
{
    PhysicsOptions options = {.method = "dop853", .tolerance = 1e-9, .duration = 1, .columns = "Disc 10.x"};
    g_autoptr(GString) blocks = g_string_new(CONTACT_WEIGHT CONTACT_FLOOR
                                             ", 'width': 20, 'static_friction': 0.5237, 'dynamic_friction': 0.5237}");
    int number = 0;
    for (int row = 4; row >= 1; row--)
        for (int i = 0; i < row; i++)
            g_string_append_printf(blocks,
                                   ", {'type': 'disc', 'name': 'Disc %d', 'radius': 0.3, 'position': [%.17g, %.17g]}",
                                   ++number, (i - (row - 1) / 2.0) * 0.6, 0.3 + (4 - row) * 0.3 * sqrt(3));
    g_string_append(blocks, ", {'type': 'support', 'name': 'Hook', 'solid': false, 'position': [0.0317, 4.8588]},"
                            "{'type': 'spring', 'ends': ['Hook', 'Disc 10'], 'stiffness': 20, 'rest_length': 3.0819}");
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    g_assert_cmpfloat(run->summary->energy_balance_error, <=, 1e-9);
    g_assert_cmpfloat(run->summary->books[TINKER_BOOK_FRICTION], <=, 0);
}

/* Boxes in a pyramid, into which a heavy disc flies: two stand side by side without a force between them, while all
 * beneath and above them slide. What presses there is undetermined, the friction of that is not nothing, and so one
 * share of the load parts the two and another pushes them together. The run comes to its end, and its books close. */
static void test_struck_pyramid(void)
{
    PhysicsOptions options = {
        .method = "dop853", .tolerance = 1e-9, .duration = 0.6, .interval = 0.01, .columns = "Ball.x"};
    g_autoptr(GString) blocks = g_string_new(CONTACT_WEIGHT "{'type': 'support', 'position': [0.8, -0.2], 'width': 8,"
                                                            " 'height': 0.4, 'static_friction': 0.5,"
                                                            " 'dynamic_friction': 0.4}");
    for (int row = 4; row >= 1; row--)
        for (int i = 0; i < row; i++)
            g_string_append_printf(blocks, ", {'type': 'box', 'width': 0.4, 'height': 0.4, 'position': [%.2f, %.1f]}",
                                   1 + 0.46 * (i - (row - 1) / 2.0), 0.2 + 0.4 * (4 - row));
    g_string_append(blocks, ", {'type': 'disc', 'name': 'Ball', 'mass': 4, 'radius': 0.25, 'position': [-2.6, 0.7],"
                            " 'velocity': [6, 3], 'restitution': 0.3}");
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    g_assert_cmpfloat(run->summary->energy_balance_error, <=, 1e-9);
    g_assert_cmpfloat(run->summary->books[TINKER_BOOK_FRICTION], <=, 0);
}

/* A stack that is set down askew: what has come clear of a box by 1e-8 m within a millisecond is not drawn back to it
 * at once, which would push others of the stack into one another. The run goes on, and its books close. */
static void test_askew(void)
{
    PhysicsOptions options = {.method = "dop853", .tolerance = 1e-9, .duration = 0.002};
    g_autoptr(PhysicsRun) run = physics_run(
        &options, CONTACT_WEIGHT
        "{'type': 'support', 'name': 'Floor', 'position': [0.0, -0.1], 'width': 20, 'height': 0.2, "
        "'static_friction': 0.1, 'dynamic_friction': 0.08, 'restitution': 0.5}, {'type': 'box', 'mass': 0.38, "
        "'width': 0.55, 'height': 0.45, 'position': [-0.059, 0.225], 'angular_velocity': -0.23, "
        "'restitution': 0}, {'type': 'box', 'mass': 2.267, 'width': 0.79, 'height': 0.66, 'position': [0.0, "
        "0.78], 'restitution': 0}, {'type': 'box', 'mass': 0.344, 'width': 0.61, 'height': 0.73, 'position': "
        "[-0.244, 1.475], 'static_friction': 0.8, 'dynamic_friction': 0.64}, {'type': 'box', 'mass': 0.529, "
        "'width': 0.77, 'height': 0.22, 'position': [-0.199, 1.95]}, {'type': 'box', 'mass': 0.337, 'width': "
        "0.79, 'height': 0.52, 'position': [-0.148, 2.32]}, {'type': 'box', 'mass': 3.491, 'width': 0.66, "
        "'height': 0.73, 'position': [-0.073, 2.945], 'static_friction': 0.3, 'dynamic_friction': 0.3}, "
        "{'type': 'box', 'mass': 1.017, 'width': 0.57, 'height': 0.6, 'position': [-0.242, 3.61]}, {'type': "
        "'disc', 'mass': 0.647, 'radius': 0.43, 'position': [-0.068, 4.34], 'static_friction': 0.3, "
        "'dynamic_friction': 0.24, 'rolling_resistance': 0.009}, {'type': 'box', 'mass': 0.497, 'width': "
        "0.34, 'height': 0.67, 'position': [0.169, 5.105], 'static_friction': 1.0, 'dynamic_friction': 0.8, "
        "'restitution': 0}, {'type': 'box', 'mass': 1.182, 'width': 0.44, 'height': 0.35, 'position': [0.0, "
        "5.615]}");
    g_assert_cmpfloat(run->summary->energy_balance_error, <=, 1e-9);
}

/* A light box between a heavy one and a wall: both come to rest at the wall by infinitely many blows within a finite
 * time. They lie on the floor all the while, so that nothing leaves an end; that the end of the floor, far away, is in
 * line with their lower edges does not make it touch them. */
static void test_rattles_to_rest(void)
{
    PhysicsOptions options = {
        .method = "dop853", .tolerance = 1e-9, .duration = 5, .columns = "Heavy.x, Heavy.y, Heavy.angle, Light.x"};
    g_autoptr(PhysicsRun) run =
        physics_run(&options, CONTACT_WEIGHT
                    "{'type': 'support', 'position': [0, -0.1], 'width': 20, 'height': 0.2, 'static_friction': 0,"
                    " 'dynamic_friction': 0, 'restitution': 0}, {'type': 'support', 'position': [3, 3], 'width': 8,"
                    " 'height': 0.2, 'orientation': 1.5707963267948966, 'static_friction': 0, 'dynamic_friction': 0,"
                    " 'restitution': 0.5}, {'type': 'box', 'name': 'Heavy', 'mass': 100, 'width': 1, 'height': 1,"
                    " 'position': [0, 0.5], 'velocity': [1, 0], 'static_friction': 0, 'dynamic_friction': 0,"
                    " 'restitution': 0.5}, {'type': 'box', 'name': 'Light', 'mass': 0.1, 'width': 0.5, 'height': 1,"
                    " 'position': [2, 0.5], 'static_friction': 0, 'dynamic_friction': 0, 'restitution': 0.5}");
    contact_assert_count(run, "end", 0);
    contact_assert_count(run, "take-off", 0);
    physics_assert_near("heavy", physics_last(run, 0), 2.9 - 0.5 - 0.5, 1e-9);
    physics_assert_near("lies", physics_last(run, 1), 0.5, 1e-9);
    physics_assert_near("level", physics_last(run, 2), 0, 1e-9);
    physics_assert_near("light", physics_last(run, 3), 2.9 - 0.25, 1e-9);
    contact_assert_taken(run, 0, 50, 1e-9);
}

/* A disc between a floor that rises and a wall that leans over it by 60 degrees: both push it out of the nip as long as
 * their forces can point outwards, mu < tan(30 degrees); else nothing can move, and the run says what is wedged. */
static void test_nip(void)
{
    const double radius = 0.2, lean = G_PI / 3, limit = tan(lean / 2);
    for (int k = 0; k < 4; k++) {
        const double friction = limit + (k % 2 == 0 ? -1e-6 : 1e-6), rise = k < 2 ? 0.2 * 0.09 : 0.3 * 0.3;
        g_autoptr(PhysicsRun) run =
            physics_try(&(PhysicsOptions){.duration = 0.3, .columns = "Disc 0.x"},
                        CONTACT_WEIGHT
                        "{'type': 'support', 'position': [5, 0], 'width': 10.2, 'height': 0, 'dynamic_friction': %.17g,"
                        " 'static_friction': %.17g},"
                        "{'type': 'support', 'position': [%.17g, %.17g], 'width': 10.2, 'height': 0,"
                        " 'orientation': '240 deg', 'dynamic_friction': %.17g, 'static_friction': %.17g},"
                        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'expression': '%s'},"
                        " 'angle': '90 deg'},"
                        "{'type': 'disc', 'mass': 1, 'radius': %.17g, 'position': [%.17g, %.17g]}",
                        friction, friction, 5 * cos(lean), 5 * sin(lean), friction, friction,
                        k < 2 ? "0.2*t^2" : "0.3*t", radius, radius / tan(lean / 2), radius);
        if (k % 2 == 0)
            physics_assert_near("out of the nip", physics_last(run, 0), radius / tan(lean / 2) + rise / tan(lean),
                                1e-9);
        else
            physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "Disc 0 is wedged", "friction", NULL);
    }
}

/* A rod drives a disc into a wall, while the floor that it lies on gives way: that fails, but not because the floor
 * closes on the disc. */
static void test_recedes(void)
{
    g_autoptr(PhysicsRun) run = physics_try(
        &(PhysicsOptions){.duration = 0.5}, CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 10}, {'type': 'support', 'name': 'Wall', 'position': [1, 0], 'orientation': '90 deg', 'width': 4},"
        "{'type': 'support', 'name': 'Hand', 'position': [-1, 0.2], 'solid': false}, {'type': 'disc', 'radius': 0.2,"
        " 'position': [0.5, 0.2]}, {'type': 'rod', 'ends': ['Hand', 'Disc 0']},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'expression': '-t^2/2'}, 'angle': '90 deg'},"
        "{'type': 'support-motion', 'ends': ['Hand'], 'waveform': {'expression': 't'}}");
    physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "laws of impact", NULL);
    g_assert_null(strstr(run->error->message, "wedged"));
}

static void add_tests(void)
{
    g_test_add_func("/contact-wedged/grows-beyond-bounds", test_grows_beyond_bounds);
    g_test_add_func("/contact-wedged/pyramid", test_pyramid);
    g_test_add_func("/contact-wedged/struck-pyramid", test_struck_pyramid);
    g_test_add_func("/contact-wedged/askew", test_askew);
    g_test_add_func("/contact-wedged/nip", test_nip);
    g_test_add_func("/contact-wedged/recedes", test_recedes);
    g_test_add_func("/contact-wedged/rattles-to-rest", test_rattles_to_rest);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

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

/* s: from a fall of h to a push of k m on 1 kg and back to where it fell from. With x how far it is pushed,
 * x'' = g - omega^2 x from x = 0 at v: it is 0 again where tan(omega t / 2) = -v omega / g. */
static double bounce(double h, double stiffness)
{
    const double omega = sqrt(stiffness), v = sqrt(2 * CONTACT_GRAVITY * h);
    return 2 * v / CONTACT_GRAVITY + 2 / omega * (G_PI - atan(v * omega / CONTACT_GRAVITY));
}

/* Steps grow in flight, and are not to pass over what is met behind it: a bumper, or a cord that becomes long enough.
 */
static void test_flights(void)
{
    static const char *const methods[] = {"dop853", "dopri5"};
    static const struct {
        const char *block;
        double y, h; /* m: it falls from, so far */
    } kinds[] = {
        {"{'type': 'bumper', 'ends': ['Support 0', 'Mass 0'], 'length': 1}", 2, 1},
        {"{'type': 'law-connector', 'ends': ['Support 0', 'Mass 0'], 'tension': '1000*ramp(L - 1)'}", -0.2, 0.8},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(methods) * G_N_ELEMENTS(kinds); i++) {
        const gsize kind = i / G_N_ELEMENTS(methods);
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 5 * bounce(kinds[kind].h, 1000),
                                          .method = methods[i % G_N_ELEMENTS(methods)],
                                          .columns = "Mass 0.y, Mass 0.vy"},
                        CONTACT_WEIGHT "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, %g]}, %s",
                        kinds[kind].y, kinds[kind].block);
        physics_assert_near("height", physics_last(run, 0), kinds[kind].y, 1e-7);
        physics_assert_near("turns", physics_last(run, 1), 0, 1e-6);
    }
}

/* A bar that turns evenly about its middle, and what its end meets throws back as fast. */
static void test_turning(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 2, .tolerance = 1e-11, .columns = "Bar 0.angular velocity, Bumper 0.force"},
        "{'type': 'support', 'solid': false}, {'type': 'bar', 'position': [0, 0], 'length': 2, 'angular_velocity': 2},"
        "{'type': 'pin', 'ends': ['Support 0', 'Bar 0']},"
        "{'type': 'support', 'position': [0, 2], 'solid': false},"
        "{'type': 'bumper', 'ends': ['Support 1', {'block': 'Bar 0', 'at': [1, 0]}], 'length': 1.2}");
    physics_assert_near("turns back", physics_last(run, 0), -2, 1e-8);
    physics_assert_near("lets go", physics_last(run, 1), 0, 0);
}

/* A rod holds the distance just within the range of what acts beyond it, or before it: the swing is that of the rod
 * alone, in as many steps. */
static void test_held_within(void)
{
    static const char *const laws[] = {
        "'law-connector', 'ends': ['Support 0', 'Mass 0'], 'tension': '1000*ramp(L - %.17g)'",
        "'bumper', 'ends': ['Support 0', 'Mass 0'], 'length': %.17g"};
    static const double rooms[] = {0, 1e-12, 1e-9, 1e-7, 1e-4};
    for (gsize i = 0; i < G_N_ELEMENTS(laws) * G_N_ELEMENTS(rooms); i++) {
        const gboolean beyond = i % 2 == 0;
        const double room = rooms[i / G_N_ELEMENTS(laws)], angle = 0.7, end = beyond ? 1 + room : 1 - room;
        GString *law = g_string_new("");
        g_string_append_printf(law, "%s", laws[i % G_N_ELEMENTS(laws)]);
        g_autofree char *number = g_strdup_printf("%.17g", end);
        g_string_replace(law, "%.17g", number, 1);
        g_autofree char *text = g_string_free(law, FALSE);
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 10, .tolerance = 1e-9, .columns = "Mass 0.x, Mass 0.y"},
            "{'type': 'support', 'position': [3, 2], 'solid': false}, {'type': 'mass', 'position': [%.17g, %.17g],"
            " 'velocity': [%.17g, %.17g]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': %s}",
            3 + cos(angle), 2 + sin(angle), -sin(angle), cos(angle), text);
        physics_assert_near("x", physics_last(run, 0), 3 + cos(angle + 10), 1e-6);
        physics_assert_near("y", physics_last(run, 1), 2 + sin(angle + 10), 1e-6);
        g_assert_cmpint(run->summary->steps, <, 100);
    }
}

/* m: where a mass of 1 kg on a cord of 1 m, across which it flies off with v, is farthest: both its energy and r^2 w =
 * v stay. */
static double stretch(double r, const void *data)
{
    const double v = *(const double *)data;
    return 0.5 * v * v * (1 - 1 / (r * r)) - 500 * (r - 1) * (r - 1);
}

#define CORD                                                                                                           \
    "{'type': 'support', 'solid': false}, {'type': 'law-connector', 'ends': ['Support 0', 'Mass 0'],"                  \
    " 'tension': '1000*ramp(L - 1)'}, "

static const char *const both[] = {"dop853", "dopri5"};

/* Off across the cord from where it begins to pull: its length grows with the square of time. */
static void test_across(void)
{
    const double v = 2, farthest = contact_bisect(1.001, 1.1, stretch, &v);
    for (gsize i = 0; i < G_N_ELEMENTS(both); i++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 3,
                                                                  .interval = 1e-3,
                                                                  .method = both[i],
                                                                  .tolerance = 1e-10,
                                                                  .columns = "Mass 0.x, Mass 0.y"},
                                                CORD "{'type': 'mass', 'position': [1, 0], 'velocity': [0, %g]}", v);
        double most = 0;
        for (gsize k = 0; k < physics_samples(run); k++)
            most = fmax(most, hypot(physics_value(run, k, 0), physics_value(run, k, 1)));
        physics_assert_near("farthest", most, farthest, 1e-5);
    }
}

/* Let go level with its end, and at the top of a circle on which weight alone keeps it at first: its length grows with
 * the fourth power of time. The energy stays. */
static void test_slowly_across(void)
{
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(both); i++) {
        const gboolean level = i % 2 == 0;
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 2,
                                          .interval = 1e-2,
                                          .method = both[i / 2],
                                          .tolerance = 1e-10,
                                          .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy"},
                        CONTACT_WEIGHT CORD "{'type': 'mass', 'position': [%d, %d], 'velocity': [%.17g, 0]}", level,
                        !level, level ? 0 : sqrt(CONTACT_GRAVITY));
        const double energy = level ? 0 : 1.5 * CONTACT_GRAVITY;
        for (gsize k = 0; k < physics_samples(run); k++) {
            const double x = physics_value(run, k, 0), y = physics_value(run, k, 1);
            const double v = hypot(physics_value(run, k, 2), physics_value(run, k, 3));
            const double longer = fmax(hypot(x, y) - 1, 0);
            physics_assert_near("energy", 0.5 * v * v + CONTACT_GRAVITY * y + 500 * longer * longer, energy, 1e-7);
        }
    }
}

/* A mass that slides and slows down comes to the bumper before a box at rest, whose friction its damper overcomes at
 * once: that force is there from one place on, which no step comes to exactly. */
static void test_box_gives_way(void)
{
    const double v = 1.33, slowing = 0.2 * CONTACT_GRAVITY, gap = 0.1535;
    const double met = (v - sqrt(v * v - 2 * slowing * gap)) / slowing;
    for (int digits = 4; digits <= 11; digits++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .method = "dop853", .tolerance = pow(10, -digits), .duration = 0.5, .columns = "Mass 0.vx, Box 0.vx"},
            CONTACT_WEIGHT "{'type': 'support', 'position': [0, -0.1], 'width': 60, 'height': 0.2,"
                           " 'static_friction': 0.24, 'dynamic_friction': 0.2},"
                           "{'type': 'mass', 'width': 0.2, 'height': 0.2, 'position': [0, 0.1], 'velocity': [1.33, 0]},"
                           "{'type': 'box', 'mass': 2, 'width': 0.2, 'height': 0.2, 'position': [0.6, 0.1]},"
                           "{'type': 'bumper', 'ends': ['Mass 0', 'Box 0'], 'stiffness': 1500, 'damping': 5,"
                           " 'length': 0.4465}");
        const double off = fmax(1e-9, 0.2 * pow(10, -digits) / (v - slowing * met));
        const TinkerEvent *slips = g_ptr_array_index(run->summary->events, 0);
        g_assert_cmpstr(slips->kind, ==, "slip");
        physics_assert_near("gives way", slips->time, met, off);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/bumper/box-gives-way", test_box_gives_way);
    g_test_add_func("/physics/bumper/held-within", test_held_within);
    g_test_add_func("/physics/bumper/across", test_across);
    g_test_add_func("/physics/bumper/slowly-across", test_slowly_across);
    g_test_add_func("/physics/bumper/flights", test_flights);
    g_test_add_func("/physics/bumper/turning", test_turning);
    g_test_add_func("/physics/bumper/rebound", test_rebound);
    g_test_add_func("/physics/bumper/as-placed", test_as_placed);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

/* Supports that move: their velocity counts at impacts and for friction, their acceleration for what presses and holds.
 */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* A lift: what presses is m (g + a). */
static void test_lift(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1.5,
                                                 "Mass 0.y, Mass 0.normal force, Support 0.normal "
                                                 "force, Mass 0.vy, Mass 0.ay");
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                                "}, " CONTACT_POINT ", 'mass': 3},"
                                                "{'type': 'support-motion', 'ends': ['Support 0'], 'angle': '90 deg', "
                                                "'waveform': {'expression': 't^2 - t^3/2'}}");
        for (gsize k = 0; k < physics_samples(run); k++) {
            double t = physics_time(run, k), a = 2 - 3 * t;
            physics_assert_near("y", physics_value(run, k, 0), t * t - t * t * t / 2, 1e-11);
            physics_assert_near("normal force", physics_value(run, k, 1), 3 * (g + a), 1e-9);
            physics_assert_near("normal force on the floor", physics_value(run, k, 2), 3 * (g + a), 1e-9);
            physics_assert_near("vy", physics_value(run, k, 3), 2 * t - 1.5 * t * t, 1e-10);
            physics_assert_near("ay", physics_value(run, k, 4), a, 1e-9);
        }
        contact_assert_taken(run, 0, 0, 1e-12);
        contact_assert_count(run, "take-off", 0);
    }
}

/* A platform sinks by 5 t^3, faster than the mass can fall from t = g / 30 on; from 0.6 s on it sinks evenly and the
 * mass lands on it. */
static void test_platform_drops_away(void)
{
    const double off = g / 30, y0 = -5 * off * off * off, v0 = -15 * off * off;
    /* y0 + v0 s - g s^2 / 2 = -1.08 - 5.4 (off + s - 0.6) */
    double b = v0 + 5.4, c = y0 + 1.08 + 5.4 * (off - 0.6), s = (b + sqrt(b * b + 2 * g * c)) / g, landing = off + s;
    g_assert_cmpfloat(landing, >, 0.6);
    double hit = v0 - g * s + 5.4;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1.3, "Mass 0.y, Mass 0.vy, Mass 0.normal force");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                        "}, " CONTACT_POINT ", 'mass': 2},"
                        "{'type': 'support-motion', 'ends': ['Support 0'], 'angle': '90 deg', 'waveform': "
                        "{'expression': '-5*min(t, 0.6)^3 - 5.4*ramp(t - 0.6)'}}");
        double bound = contact_methods[i].polynomial;
        for (gsize k = 0; k < physics_samples(run); k++) {
            double t = physics_time(run, k), fall = t - off, y = -5 * t * t * t, v = -15 * t * t,
                   force = 2 * (g - 30 * t);
            if (t > off) {
                y = y0 + v0 * fall - g / 2 * fall * fall;
                v = v0 - g * fall;
                force = 0;
            }
            if (t > landing) {
                y = -1.08 - 5.4 * (t - 0.6);
                v = -5.4;
                force = 2 * g;
            }
            physics_assert_near("y", physics_value(run, k, 0), y, bound);
            physics_assert_near("vy", physics_value(run, k, 1), v, bound);
            physics_assert_near("normal force", physics_value(run, k, 2), force, 1e-8);
        }
        contact_assert_event(run, "take-off", "Mass 0, Support 0", off, 1e-10);
        contact_assert_event(run, "rest", "Mass 0, Support 0", landing, bound);
        contact_assert_taken(run, 0, hit * hit, 30 * bound);
    }
}

/* A table of 0.05 sin(20 t) throws the mass off where its acceleration downwards passes g, and catches it again. */
typedef struct {
    double off, y, v;
} Flight;

static double above_table(double t, const void *data)
{
    const Flight *flight = data;
    double s = t - flight->off;
    return flight->y + flight->v * s - g / 2 * s * s - 0.05 * sin(20 * t);
}

static void test_shaking_table_throws(void)
{
    Flight flight = {.off = asin(g / 20) / 20};
    flight.y = 0.05 * sin(20 * flight.off);
    flight.v = cos(20 * flight.off);
    double landing = contact_bisect(flight.off + 0.05, 0.3, above_table, &flight);
    double hit = flight.v - g * (landing - flight.off) - cos(20 * landing);
    double at[] = {0.02, 0.1, 0.2, landing + 0.002};
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1, "Mass 0.y, Mass 0.vy, Mass 0.normal force");
        options.at = at;
        options.at_count = G_N_ELEMENTS(at);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                        "}, " CONTACT_POINT ", 'velocity': [0, 1]},"
                        "{'type': 'support-motion', 'ends': ['Support 0'], 'angle': '90 deg', 'amplitude': 0.05, "
                        "'frequency': 20}");
        double bound = contact_methods[i].polynomial;
        for (gsize k = 0; k < G_N_ELEMENTS(at); k++) {
            double t = at[k], y = 0.05 * sin(20 * t);
            if (k == 1 || k == 2) y += above_table(t, &flight);
            physics_assert_near("y", physics_value(run, k, 0), y, bound);
        }
        physics_assert_near("normal force", physics_value(run, 0, 2), g - 20 * sin(0.4), 1e-9);
        physics_assert_near("vy", physics_value(run, 3, 1), cos(20 * at[3]), bound);
        contact_assert_event(run, "take-off", NULL, flight.off, 1e-10);
        contact_assert_event(run, "rest", NULL, landing, bound);
        contact_assert_taken(run, 0, hit * hit / 2, 10 * bound);
    }
}

/* --- friction --- */

static PhysicsRun *on_shaking_table(const ContactMethod *method, double duration, const char *friction, double v)
{
    PhysicsOptions options = contact_options(method, duration, "Mass 0.x, Mass 0.vx, Mass 0.friction force");
    return physics_run(&options,
                       CONTACT_WEIGHT CONTACT_FLOOR
                       ", %s}, " CONTACT_POINT ", 'mass': 2, 'velocity': [%g, 0]}, {'type': 'support-motion', 'ends': "
                       "['Support 0'], 'amplitude': 0.04, 'frequency': 10}",
                       friction, v);
}

/* 0.04 sin(10 t) accelerates at up to 4 m/s^2, less than 0.41 g: the mass is carried along for good. */
static void test_carried_along(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) run =
            on_shaking_table(&contact_methods[i], 10.05, "'static_friction': 0.41, 'dynamic_friction': 0.2", 0.4);
        for (gsize k = 0; k < physics_samples(run); k++) {
            double t = physics_time(run, k);
            physics_assert_near("x", physics_value(run, k, 0), 0.04 * sin(10 * t), 1e-11);
            physics_assert_near("vx", physics_value(run, k, 1), 0.4 * cos(10 * t), 1e-10);
            physics_assert_near("friction", physics_value(run, k, 2), -8 * sin(10 * t), 1e-9);
        }
        contact_assert_count(run, "slip", 0);
        contact_assert_taken(run, 0, 0, 1e-12);
    }
}

/* With a static coefficient of 0.3 it slips where 4 sin(10 t) passes 0.3 g, and then slides with 0.2. */
static void test_slips_on_a_shaking_table(void)
{
    const double onset = asin(0.3 * g / 4) / 10, x0 = 0.04 * sin(10 * onset), v0 = 0.4 * cos(10 * onset), end = 0.22;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) run =
            on_shaking_table(&contact_methods[i], end, "'static_friction': 0.3, 'dynamic_friction': 0.2", 0.4);
        double s = end - onset, a = -0.2 * g, bound = contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", (double[]){x0 + v0 * s + a / 2 * s * s, 0, v0 + a * s, 0}, bound);
        contact_assert_event(run, "slip", "Mass 0, Support 0", onset, 1e-10);
        contact_assert_count(run, "stick", 0);
        double slid = x0 + v0 * s + a / 2 * s * s - 0.04 * sin(10 * end);
        physics_assert_near("friction", physics_last(run, 2), -0.2 * 2 * g, 1e-9);
        /* the table swings: what is taken is no polynomial of time */
        contact_assert_taken(run, 0.2 * 2 * g * slid, 0, contact_methods[i].smooth);
    }
}

/* A belt at 2 m/s takes the mass along: both slower and faster ones reach its speed after |v - 2| / (friction g). */
static void check_belt(double v)
{
    const double friction = 0.25, speed = 2, duration = 3;
    double sliding = fabs(speed - v) / (friction * g), a = copysign(friction * g, speed - v);
    double x = v * sliding + a / 2 * sliding * sliding + speed * (duration - sliding);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, "Mass 0.friction force");
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT CONTACT_FLOOR
                        ", 'width': 40, 'static_friction': 0.3, 'dynamic_friction': 0.25}, " CONTACT_POINT
                        ", 'mass': 4, 'velocity': [%g, 0]}, {'type': 'support-motion', 'ends': "
                        "['Support 0'], 'waveform': {'expression': '2*t'}}",
                        v);
        double bound = contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", (double[]){x, 0, speed, 0}, bound);
        contact_assert_event(run, "stick", NULL, sliding, bound);
        physics_assert_near("friction", physics_value(run, 1, 0), 4 * a, 1e-9);
        physics_assert_near("friction of what is carried", physics_last(run, 0), 0, 1e-9);
        contact_assert_taken(run, 2 * (speed - v) * (speed - v), 0, 50 * bound);
    }
}

static void test_belt(void)
{
    check_belt(0);
    check_belt(-1);
    check_belt(5);
}

/* A belt that speeds up evenly at `a`: what is at rest on it at first goes along up to friction g, else falls behind.
 */
static void test_belt_speeds_up(void)
{
    static const double rates[] = {2.9, 3.1};
    for (gsize r = 0; r < 2; r++) {
        PhysicsOptions options = contact_options(&contact_methods[0], 2, NULL);
        double most = 0.3 * g, a = rates[r] <= most ? rates[r] : 0.2 * g;
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT CONTACT_FLOOR
                        ", 'width': 40, 'static_friction': 0.3, 'dynamic_friction': 0.2}, " CONTACT_POINT
                        "}, {'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'expression': "
                        "'%.17g*t^2'}}",
                        rates[r] / 2);
        contact_assert_state(run, "Mass 0", (double[]){2 * a, 0, 2 * a, 0}, 1e-10);
        contact_assert_taken(run, r == 0 ? 0 : 0.2 * g * 2 * (rates[r] - a), 0, 1e-9);
    }
}

/* --- inclines that accelerate sideways --- */

/* The plate, at `angle`, accelerates by `a` towards the side that its top faces. Along the top, relative to it, the
 * mass accelerates by a cos - g sin, held back by friction of what presses, m (g cos + a sin). */
static void check_incline(double angle, double a, double friction, double duration)
{
    double drive = a * cos(angle) - g * sin(angle), press = g * cos(angle) + a * sin(angle);
    double relative = fabs(drive) <= friction * press + 1e-12 ? 0 : drive - copysign(friction * press, drive);
    double force = relative != 0 ? -copysign(friction * press, drive) : -drive;
    g_autofree char *more = g_strdup_printf("'static_friction': %g, 'dynamic_friction': %g", friction, friction);
    g_autofree char *plate = contact_plate(0, 0, angle, 100, more);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options =
            contact_options(&contact_methods[i], duration, "Mass 0.normal force, Mass 0.friction force");
        g_autoptr(PhysicsRun) run = physics_run(
            &options,
            CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'mass': 2}, {'type': 'support-motion', 'ends': ['Support 0'],"
                           "'waveform': {'expression': '-%.17g*t^2'}}",
            plate, a / 2);
        double way = relative / 2 * duration * duration, v = relative * duration;
        contact_assert_state(run, "Mass 0",
                             (double[]){way * cos(angle) - a / 2 * duration * duration, way * sin(angle),
                                        v * cos(angle) - a * duration, v * sin(angle)},
                             relative == 0 && friction > 0 ? 1e-9 : 2 * contact_methods[i].polynomial);
        physics_assert_near("normal force", physics_last(run, 0), 2 * press, 1e-9);
        physics_assert_near("friction force", physics_last(run, 1), 2 * force, 1e-9);
        contact_assert_taken(run, fabs(2 * force * way), 0, 100 * contact_methods[i].polynomial);
    }
}

static void test_inclines_accelerate(void)
{
    const double angle = 35 * G_PI / 180, balance = g * tan(angle);
    check_incline(angle, balance, 0, 1);
    check_incline(angle, 0.5 * balance, 0, 1);
    check_incline(angle, 1.6 * balance, 0, 1);
    check_incline(angle, 0.5 * balance, 0.1, 1);
    check_incline(angle, 1.6 * balance, 0.1, 1);
    check_incline(angle, 0.5 * balance, 0.4, 1);
    check_incline(angle, 1.6 * balance, 0.4, 1);
}

/* --- impacts --- */

/* A plate without weight around it comes at the mass: after the impact the mass is as fast as restitution has it. */
static void test_plate_hits(void)
{
    PhysicsOptions options = contact_options(&contact_methods[0], 2, NULL);
    g_autoptr(PhysicsRun) run = physics_run(
        &options, CONTACT_FLOOR
        ", 'width': 20, 'restitution': 0.4, 'static_friction': 0.2, 'dynamic_friction': 0.2}, " CONTACT_POINT
        ", 'position': [0, 3], 'velocity': [-1, 0]},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'angle': '90 deg', 'waveform': "
        "{'expression': '3*t'}}, {'type': 'support-motion', 'ends': ['Support 0'], 'waveform': "
        "{'expression': 't'}}");
    /* relative: 3 m/s across, 2 m/s along; friction gives 0.2 * 1.4 * 3 along */
    contact_assert_state(run, "Mass 0", (double[]){-1 - 1 + 0.84, 3 + 4.2, -1 + 0.84, 4.2}, 1e-11);
    contact_assert_event(run, "impact", NULL, 1, 1e-12);
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-moving/lift", test_lift);
    g_test_add_func("/physics/contact-moving/platform-drops-away", test_platform_drops_away);
    g_test_add_func("/physics/contact-moving/shaking-table-throws", test_shaking_table_throws);
    g_test_add_func("/physics/contact-moving/carried-along", test_carried_along);
    g_test_add_func("/physics/contact-moving/slips-on-a-shaking-table", test_slips_on_a_shaking_table);
    g_test_add_func("/physics/contact-moving/belt", test_belt);
    g_test_add_func("/physics/contact-moving/belt-speeds-up", test_belt_speeds_up);
    g_test_add_func("/physics/contact-moving/inclines-accelerate", test_inclines_accelerate);
    g_test_add_func("/physics/contact-moving/plate-hits", test_plate_hits);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

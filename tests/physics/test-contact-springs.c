/* Contact together with springs: oscillations that friction ends, that a wall throws back, and that lift off. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* --- friction oscillator --- */

/* 2 kg on 80 N/m. Each half swing is a cosine about a centre that friction moves to the side it pushes to, so that the
 * amplitude falls by 2 friction m g / k; the static coefficient ends it. */
typedef struct {
    double w, first, shift, holds;
    int swings; /* the half swings until it stays */
} Sliding;

static Sliding sliding_of(double first, double at_rest, double moving)
{
    const double m = 2, k = 80;
    Sliding s = {.w = sqrt(k / m), .first = first, .shift = moving * m * g / k, .holds = at_rest * m * g / k};
    while (first - 2 * s.shift * s.swings > s.holds)
        s.swings++;
    return s;
}

static double turn(const Sliding *s, int n)
{
    return (n % 2 == 0 ? 1 : -1) * (s->first - 2 * n * s->shift);
}

static double sliding_place(double t, const void *data)
{
    const Sliding *s = data;
    int n = (int)floor(t * s->w / G_PI);
    if (n >= s->swings) return turn(s, s->swings);
    double sign = n % 2 == 0 ? 1 : -1, amplitude = s->first - 2 * n * s->shift - s->shift;
    return sign * (s->shift + amplitude * cos(s->w * t - n * G_PI));
}

static PhysicsRun *slide(const PhysicsOptions *options, double first, double at_rest, double moving)
{
    return physics_run(options,
                       CONTACT_WEIGHT CONTACT_FLOOR
                       ", 'width': 20, 'static_friction': %g, 'dynamic_friction': %g},"
                       "{'type': 'support', 'position': [-2, 0], 'solid': false}," CONTACT_POINT
                       ", 'mass': 2, 'position': [%.17g, 0]},"
                       "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 80, "
                       "'rest_length': 2}",
                       at_rest, moving, first);
}

static void check_friction_oscillator(double first, double at_rest, double moving)
{
    Sliding s = sliding_of(first, at_rest, moving);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 4.4, "Mass 0.x, Mass 0.friction force");
        options.interval = 0.11;
        g_autoptr(PhysicsRun) run = slide(&options, first, at_rest, moving);
        double bound = contact_methods[i].smooth;
        physics_assert_follows(run, 0, sliding_place, &s, bound);
        for (int n = 1; n < s.swings; n++)
            contact_assert_event(run, "reversal", "Mass 0, Support 0", n * G_PI / s.w, contact_methods[i].smooth);
        contact_assert_event(run, "stick", "Mass 0, Support 0", s.swings * G_PI / s.w, contact_methods[i].smooth);
        double end = turn(&s, s.swings);
        physics_assert_near("what holds", physics_last(run, 1), 80 * end, 80 * bound);
        contact_assert_taken(run, 40 * (first * first - end * end), 0, 80 * bound);
    }
    PhysicsOptions tight = contact_options(&contact_methods[0], 4.4, NULL);
    g_autoptr(PhysicsRun) run = slide(&tight, first, at_rest, moving);
    for (int n = 1; n < s.swings; n++)
        contact_assert_event(run, "reversal", NULL, n * G_PI / s.w, 1e-10);
    contact_assert_event(run, "stick", NULL, s.swings * G_PI / s.w, 1e-10);
    contact_assert_count(run, "reversal", s.swings - 1);
}

static void test_friction_oscillator(void)
{
    check_friction_oscillator(0.5, 0.3, 0.2);
    check_friction_oscillator(0.5, 0.2, 0.2);
    check_friction_oscillator(1.4, 0.35, 0.35);
    g_assert_cmpint(sliding_of(0.5, 0.3, 0.2).swings, ==, 5);
}

/* Less stretch than friction holds: it stays where it is, to the bit. */
static void test_never_starts(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 5, NULL);
        g_autoptr(PhysicsRun) run = slide(&options, 0.999 * 0.3 * 2 * g / 80, 0.3, 0.2);
        contact_assert_state(run, "Mass 0", (double[]){0.999 * 0.3 * 2 * g / 80, 0, 0, 0}, 1e-15);
    }
}

/* --- against a wall --- */

/* A wall where the spring is free: half swings of equal length, each e times the one before. */
static void bouncing(double t, double e, double state[4])
{
    const double w = 5, amplitude = 0.7;
    double size = amplitude * pow(e, floor(w * t / G_PI + 0.5)), towards = cos(w * t) > 0 ? 1 : -1;
    state[0] = -size * fabs(cos(w * t));
    state[2] = towards * size * w * sin(w * t);
    state[1] = state[3] = 0;
}

static PhysicsRun *bounce(const PhysicsOptions *options, double e)
{
    g_autofree char *more = g_strdup_printf(CONTACT_SMOOTH ", 'restitution': %g", e);
    g_autofree char *wall = contact_plate(0, 0, G_PI / 2, 4, more);
    return physics_run(
        options,
        "%s, {'type': 'support', 'position': [-2, 0], 'solid': false}," CONTACT_POINT
        ", 'position': [-0.7, 0]}, {'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'rest_length': 2}",
        wall);
}

static void test_against_a_wall(void)
{
    static const double restitutions[] = {1, 0.7};
    for (gsize r = 0; r < G_N_ELEMENTS(restitutions); r++) {
        double e = restitutions[r], state[4];
        bouncing(3, e, state);
        for (gsize i = 0; i < CONTACT_METHODS; i++) {
            PhysicsOptions options = contact_options(&contact_methods[i], 3, NULL);
            g_autoptr(PhysicsRun) run = bounce(&options, e);
            contact_assert_state(run, "Mass 0", state, 10 * contact_methods[i].smooth);
            contact_assert_count(run, "impact", 5);
            contact_assert_taken(run, 0, 12.5 * 0.49 * (1 - pow(e, 10)), 30 * contact_methods[i].smooth);
        }
        PhysicsOptions tight = contact_options(&contact_methods[0], 3, NULL);
        g_autoptr(PhysicsRun) run = bounce(&tight, e);
        for (int n = 0; n < 5; n++)
            contact_assert_event(run, "impact", "Mass 0, Support 0", (n + 0.5) * G_PI / 5, 1e-10);
    }
}

/* --- orders --- */

typedef struct {
    const char *method;
    int order;
    double step;
} Order;

static const Order orders[] = {
    {"semi-implicit-euler", 1, 0.002},
    {"verlet", 2, 0.01},
    {"newmark", 2, 0.01},
    {"rk4", 4, 0.02},
    {"verlet6", 6, 0.06},
};

static double error_of(const Order *order, double step, gboolean sliding)
{
    PhysicsOptions options = {.method = order->method, .step = step, .duration = 2.2};
    g_autoptr(PhysicsRun) run = sliding ? slide(&options, 1.4, 0.35, 0.35) : bounce(&options, 0.9);
    double now[4], truth[4];
    physics_state(run, "Mass 0", now);
    bouncing(2.2, 0.9, truth);
    Sliding s = sliding_of(1.4, 0.35, 0.35);
    if (sliding) truth[0] = sliding_place(2.2, &s);
    return fabs(now[0] - truth[0]);
}

/* Events do not cost a method its order: over four halvings of the step the error falls as fast as in smooth motion.
 * One pair of steps could cross zero by chance, so the largest of three near ones counts. */
static void test_orders(void)
{
    static const double nearby[] = {1, 0.93, 0.87};
    for (gsize i = 0; i < G_N_ELEMENTS(orders); i++) {
        for (int sliding = 0; sliding < 2; sliding++) {
            double coarse = 0, fine = 0;
            for (gsize k = 0; k < G_N_ELEMENTS(nearby); k++) {
                coarse = fmax(coarse, error_of(&orders[i], orders[i].step * nearby[k], sliding));
                fine = fmax(fine, error_of(&orders[i], orders[i].step * nearby[k] / 4, sliding));
            }
            double order = log2(coarse / fmax(fine, 1e-13)) / 2;
            g_test_message("%s, %s: errors %.2e and %.2e, order %.2f", orders[i].method,
                           sliding ? "sliding" : "bouncing", coarse, fine, order);
            if (fine > 1e-12 && order < orders[i].order - 0.4)
                g_test_fail_printf("%s is of order %.2f, not %d, where it %s", orders[i].method, order, orders[i].order,
                                   sliding ? "slides" : "bounces");
        }
    }
}

/* --- lifting off --- */

/* A spring whose upper end rises at 0.5 m/s lifts the mass off once it bears the weight: then a free oscillation about
 * a place that rises. */
static void test_lifted_by_a_spring(void)
{
    const double k = 50, m = 2, rise = 0.5;
    double off = m * g / k / rise, w = sqrt(k / m), duration = off + 0.8, s = duration - off;
    double state[4] = {0, rise * (s - sin(w * s) / w), 0, rise * (1 - cos(w * s))};
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, "Mass 0.normal force");
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT CONTACT_FLOOR
            "}, {'type': 'support', 'position': [0, 1], 'solid': false}," CONTACT_POINT
            ", 'mass': 2}, {'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 50, 'rest_length': 1},"
            "{'type': 'support-motion', 'ends': ['Support 1'], 'angle': '90 deg', 'waveform': {'expression': "
            "'0.5*t'}}");
        contact_assert_state(run, "Mass 0", state, contact_methods[i].smooth);
        contact_assert_event(run, "take-off", "Mass 0, Support 0", off, 1e-10);
        for (gsize n = 0; n < 5; n++)
            physics_assert_near("normal force", physics_value(run, n, 0),
                                fmax(0, m * g - k * rise * physics_time(run, n)), 1e-9);
        contact_assert_taken(run, 0, 0, 1e-12);
    }
}

/* One mass upon another, a compressed spring between: released, the upper one rises and pulls the lower one off the
 * floor where the spring's tension is its weight. Then the centre of mass flies and the two oscillate about it. */
static void test_jumps(void)
{
    const double lower = 1, upper = 2, k = 400, amplitude = 0.2, flight = 0.07;
    double w = sqrt(k / upper), middle = 1 - upper * g / k;
    double off = acos(-(lower + upper) * g / k / amplitude) / w, v = amplitude * w * sin(w * off);
    double stretch = lower * g / k, both = lower + upper, fast = sqrt(k * both / (lower * upper));
    double centre = upper / both * (1 + stretch) + upper / both * v * flight - g / 2 * flight * flight;
    double rate = upper / both * v - g * flight;
    double r = stretch * cos(fast * flight) + v / fast * sin(fast * flight);
    double r_rate = v * cos(fast * flight) - stretch * fast * sin(fast * flight);
    double low = centre - upper / both * (1 + r);
    g_assert_cmpfloat(low, >, 0);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], off + flight, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT CONTACT_FLOOR "}, " CONTACT_POINT "}, " CONTACT_POINT
                                                     ", 'mass': 2, 'position': [0, %.17g]}, {'type': 'spring', 'ends': "
                                                     "['Mass 0', 'Mass 1'], 'stiffness': 400, 'rest_length': 1}",
                        middle - amplitude);
        double bound = 10 * contact_methods[i].smooth;
        contact_assert_state(run, "Mass 0", (double[]){0, low, 0, rate - upper / both * r_rate}, bound);
        contact_assert_state(run, "Mass 1", (double[]){0, low + 1 + r, 0, rate + lower / both * r_rate}, bound);
        contact_assert_event(run, "take-off", "Mass 0, Support 0", off, i < 2 ? 1e-10 : bound);
        contact_assert_taken(run, 0, 0, 1e-12);
    }
}

/* A belt at v takes a mass along against a spring up to mu m g / k, at t1 = mu m g / (k v). With one coefficient for
 * both it has no force left there and v, so that it swings on by v sin(w s) / w, and touches the belt's speed once a
 * period without being taken along: slipping begins with the second power of time, of which an order of 1 knows
 * nothing. */
static void test_slips_from_a_belt(void)
{
    static const struct {
        const char *method;
        double step, bound;
    } cases[] = {{"semi-implicit-euler", 0.003, 3e-2},
                 {"semi-implicit-euler", 0.0005, 5e-3},
                 {"verlet", 0.003, 1e-4},
                 {"rk4", 0.003, 1e-8},
                 {"newmark", 0.003, 1e-4},
                 {"dop853", 0, 1e-8}};
    const double v = 0.6, k = 20, m = 0.75, friction = 0.6 * m * CONTACT_GRAVITY, t1 = friction / (k * v);
    const double w = sqrt(k / m), end = t1 + 0.7 * 2 * G_PI / w;
    const double truth[] = {friction / k + v / w * sin(w * (end - t1)), 0, v * cos(w * (end - t1)), 0};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        const PhysicsOptions options = {.method = cases[i].method, .step = cases[i].step, .duration = end};
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT CONTACT_FLOOR
            ", 'width': 100, 'static_friction': 0.6, 'dynamic_friction': 0.6}, " CONTACT_POINT
            ", 'mass': 0.75, 'velocity': [0.6, 0]}, {'type': 'support', 'position': [-2, 0], 'solid': false},"
            "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'expression': '0.6*t'}},"
            "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 20}");
        contact_assert_state(run, "Mass 0", truth, cases[i].bound);
        contact_assert_event(run, "slip", NULL, t1, 1e-2);
        contact_assert_count(run, "slip", 1);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-springs/friction-oscillator", test_friction_oscillator);
    g_test_add_func("/physics/contact-springs/never-starts", test_never_starts);
    g_test_add_func("/physics/contact-springs/against-a-wall", test_against_a_wall);
    g_test_add_func("/physics/contact-springs/orders", test_orders);
    g_test_add_func("/physics/contact-springs/lifted-by-a-spring", test_lifted_by_a_spring);
    g_test_add_func("/physics/contact-springs/jumps", test_jumps);
    g_test_add_func("/physics/contact-springs/slips-from-a-belt", test_slips_from_a_belt);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

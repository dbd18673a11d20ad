/* How a run may begin: in contact exactly or within rounding, apart, overlapping, and moving there already. */
#include "contact-checks.h"
#include "physics/model/model.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

static PhysicsRun *start(gsize method, double duration, const char *floor, double y, double vx, double vy)
{
    PhysicsOptions options = contact_options(&contact_methods[method], duration, "Mass 0.y, Mass 0.normal force");
    return physics_run(&options,
                       CONTACT_WEIGHT CONTACT_FLOOR
                       "%s}, {'type': 'mass', 'mass': 2, 'position': [0, %.17g], 'velocity': "
                       "[%.17g, %.17g]}",
                       floor, y, vx, vy);
}

/* Within 1e-9 m it is in contact from the start, without any impact. */
static void test_in_contact(void)
{
    static const double off[] = {0, 1e-16, -1e-16, 1e-12, -1e-12, 0.9e-9, -0.9e-9};
    for (gsize k = 0; k < G_N_ELEMENTS(off); k++) {
        for (gsize i = 0; i < CONTACT_METHODS; i++) {
            g_autoptr(PhysicsRun) run = start(i, 2, "", 0.4 + off[k], 0, 0);
            contact_assert_state(run, "Mass 0", (double[]){0, 0.4, 0, 0}, fabs(off[k]) + 1e-15);
            for (gsize s = 0; s < physics_samples(run); s++)
                physics_assert_near("normal force", physics_value(run, s, 1), 2 * g, 1e-9);
            physics_assert_near("friction's book", run->summary->books[TINKER_BOOK_FRICTION], 0, 0);
            physics_assert_near("contacts' book", run->summary->books[TINKER_BOOK_CONTACTS], 0, 0);
            /* of what a nanometre gives, 2e-8 J, the last bits of 8 J are a share of 1e-7 */
            physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, 1e-6);
        }
    }
}

/* Deeper than that it passes as from behind, without any force. A little above, it falls that little. */
static void test_nearly_in_contact(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) below = start(i, 1, "", 0.4 - 1e-6, 0, 0);
        contact_assert_state(below, "Mass 0", (double[]){0, 0.4 - 1e-6 - g / 2, 0, -g}, contact_methods[i].polynomial);
        for (gsize s = 0; s < physics_samples(below); s++)
            physics_assert_near("normal force", physics_value(below, s, 1), 0, 0);
        g_autoptr(PhysicsRun) above = start(i, 1, "", 0.4 + 1e-6, 0, 0);
        contact_assert_state(above, "Mass 0", (double[]){0, 0.4, 0, 0}, 1e-12);
        contact_assert_event(above, "rest", NULL, sqrt(2e-6 / g), i < 6 ? 1e-12 : 1e-4);
    }
}

/* Touching and going up: a throw from the floor. */
static void test_leaving(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) run = start(i, 0.3, "", 0.4, 0, 3);
        double bound = contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", (double[]){0, 0.4 + 0.9 - g / 2 * 0.09, 0, 3 - g * 0.3}, bound);
        contact_assert_count(run, "impact", 0);
        contact_assert_taken(run, 0, 0, 1e-12);
        g_autoptr(PhysicsRun) whole = start(i, 1, "", 0.4, 0, 3);
        contact_assert_event(whole, "rest", NULL, 6 / g, bound);
        contact_assert_taken(whole, 0, 9, 20 * bound);
        g_autoptr(PhysicsRun) low = start(i, 0.3, "", 0.4 - 0.9e-9, 0, 3);
        contact_assert_state(low, "Mass 0", (double[]){0, 0.4 + 0.9 - g / 2 * 0.09, 0, 3 - g * 0.3}, bound + 1e-9);
    }
}

/* Touching and going down: an impact at once. */
static void test_hitting(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) stops = start(i, 1, "", 0.4, 0, -3);
        contact_assert_state(stops, "Mass 0", (double[]){0, 0.4, 0, 0}, 1e-12);
        contact_assert_event(stops, "rest", "Mass 0, Support 0", 0, 0);
        contact_assert_taken(stops, 0, 9, 1e-11);
        g_autoptr(PhysicsRun) returns = start(i, 0.2, ", 'restitution': 0.5", 0.4, 0, -3);
        contact_assert_state(returns, "Mass 0", (double[]){0, 0.4 + 0.3 - g / 2 * 0.04, 0, 1.5 - 0.2 * g},
                             contact_methods[i].polynomial);
        contact_assert_event(returns, "impact", "Mass 0, Support 0", 0, 0);
        contact_assert_taken(returns, 0, 9 - 2.25, 1e-11);
    }
}

/* On a slope between the two friction angles: what creeps by less than 1e-9 of the scale sticks, what moves goes on. */
static void test_creeping(void)
{
    const double angle = 25 * G_PI / 180;
    static const double speeds[] = {0, 1e-12, -1e-12};
    g_autofree char *plate = contact_plate(0, 0, angle, 50, "'static_friction': 0.6, 'dynamic_friction': 0.3");
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        for (gsize k = 0; k < G_N_ELEMENTS(speeds); k++) {
            PhysicsOptions options = contact_options(&contact_methods[i], 5, NULL);
            g_autoptr(PhysicsRun) run =
                physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'velocity': [%.17g, %.17g]}", plate,
                            speeds[k] * cos(angle), speeds[k] * sin(angle));
            contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
        }
    }
}

/* On slopes of any angle, placed as well as doubles can: it neither falls through nor hops. */
static void test_on_any_slope(void)
{
    for (int degrees = -89; degrees <= 89; degrees += 2) {
        double angle = degrees * G_PI / 180, normal[2] = {-sin(angle), cos(angle)},
               tangent[2] = {cos(angle), sin(angle)};
        double at[2], middle[2] = {3.1, -1.7}, height = 0.8, way = -g / 2 * sin(angle), state[4];
        for (int k = 0; k < 2; k++) {
            at[k] = middle[k] + height / 2 * normal[k] + 0.3 * tangent[k];
            state[k] = at[k] + way * tangent[k];
            state[2 + k] = 2 * way * tangent[k];
        }
        g_autofree char *plate = contact_plate(middle[0], middle[1], angle, 40, CONTACT_SMOOTH);
        gsize i = (gsize)(degrees + 89) / 2 % 6;
        PhysicsOptions options = contact_options(&contact_methods[i], 1, "Mass 0.normal force");
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT "%s, {'type': 'mass', 'position': [%.17g, %.17g]}", plate, at[0], at[1]);
        contact_assert_state(run, "Mass 0", state, 1e-10);
        for (gsize s = 0; s < physics_samples(run); s++)
            physics_assert_near("normal force", physics_value(run, s, 0), g * cos(angle), 1e-9);
        contact_assert_taken(run, 0, 0, 1e-11);
    }
}

/* On a support that moves at the start: what is at rest beside it does not rest on it. */
static void test_on_a_moving_support(void)
{
    PhysicsOptions options = contact_options(&contact_methods[0], 0.5, NULL);
    static const char motion[] = "{'type': 'support-motion', 'ends': ['Support 0'], 'angle': '90 deg', 'waveform': "
                                 "{'expression': '0.5 %s 2*t'}}";
    g_autofree char *up = g_strdup_printf(motion, "+"), *down = g_strdup_printf(motion, "-");
    g_autoptr(PhysicsRun) lifted =
        physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR "}, " CONTACT_POINT ", 'position': [0, 0.5]}, %s", up);
    contact_assert_state(lifted, "Mass 0", (double[]){0, 1.5, 0, 2}, 1e-12);
    g_autoptr(PhysicsRun) left =
        physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR "}, " CONTACT_POINT ", 'position': [0, 0.5]}, %s", down);
    /* it falls and meets the support, which sinks at 2 m/s, after 4 / g */
    contact_assert_event(left, "rest", NULL, 4 / g, 1e-10);
    contact_assert_state(left, "Mass 0", (double[]){0, -0.5, 0, -2}, 1e-12);
}

/* At the start A parts from the floor with 1 m/s while B comes down on it with 3 m/s. Each blow turns an approach u
 * into e u between 1 kg and 1 kg, or a floor: the first sample is behind all of them, B on A, A on the floor, A on B.
 */
static void test_parting_while_struck(void)
{
    static const double restitutions[] = {0.3, 0.5, 0.9};
    for (gsize r = 0; r < G_N_ELEMENTS(restitutions); r++) {
        const double e = restitutions[r];
        double a = 1, b = -3;
        while (b < a || a < 0) {
            const double mean = (a + b) / 2, apart = e * (a - b) / 2;
            if (b < a) a = mean - apart, b = mean + apart;
            if (a < 0) a = -e * a;
        }
        for (gsize i = 0; i < CONTACT_METHODS; i++) {
            PhysicsOptions options = contact_options(&contact_methods[i], 0.01, "Mass 0.vy, Mass 1.vy");
            g_autoptr(PhysicsRun) run = physics_run(
                &options,
                CONTACT_FLOOR ", 'restitution': %.17g}, {'type': 'mass', 'collides': true, 'restitution': %.17g,"
                              " 'position': [0, 0.4], 'velocity': [0, 1]}, {'type': 'mass', 'collides': true,"
                              " 'restitution': %.17g, 'position': [0, 1.2], 'velocity': [0, -3]}",
                e, e, e);
            physics_assert_near("A", physics_value(run, 0, 0), a, 1e-14);
            physics_assert_near("B", physics_value(run, 0, 1), b, 1e-14);
        }
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-starts/in-contact", test_in_contact);
    g_test_add_func("/physics/contact-starts/nearly-in-contact", test_nearly_in_contact);
    g_test_add_func("/physics/contact-starts/leaving", test_leaving);
    g_test_add_func("/physics/contact-starts/hitting", test_hitting);
    g_test_add_func("/physics/contact-starts/creeping", test_creeping);
    g_test_add_func("/physics/contact-starts/on-any-slope", test_on_any_slope);
    g_test_add_func("/physics/contact-starts/on-a-moving-support", test_on_a_moving_support);
    g_test_add_func("/physics/contact-starts/parting-while-struck", test_parting_while_struck);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

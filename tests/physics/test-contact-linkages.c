/* Linkages whose masses slide along supports or stick to them: what rods hold, presses. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* --- a ladder --- */

/* Two equal masses at the ends of a rod of 1 m, one along the wall, one along the floor: theta'' = g sin theta, theta
 * from the upright. The wall's force, m g sin theta (3 cos theta - 2 cos theta0), ends at cos theta = 2/3 cos theta0.
 */
static void on_the_wall(double t, const double *y, double *rate, const void *data)
{
    rate[0] = y[1];
    rate[1] = g * sin(y[0]);
}

/* Then the middle keeps its speed along the floor: T = m (cos^2 / 4 + sin^2 / 2) theta'^2 beside it. */
static void off_the_wall(double t, const double *y, double *rate, const void *data)
{
    double s = sin(y[0]), c = cos(y[0]);
    rate[0] = y[1];
    rate[1] = (g * s - 0.5 * s * c * y[1] * y[1]) / (0.5 * c * c + s * s);
}

static const double ladder_start = G_PI / 6;

static void ladder_at(double t, double y[2])
{
    y[0] = ladder_start;
    y[1] = 0;
    physics_rk4(2, y, 0, t, 4000, on_the_wall, NULL);
}

static double ladder_presses(double t, const void *data)
{
    double y[2];
    ladder_at(t, y);
    return 3 * cos(y[0]) - 2 * cos(ladder_start);
}

static PhysicsRun *ladder(const ContactMethod *method, double duration)
{
    PhysicsOptions options = contact_options(method, duration, "Mass 0.normal force, Mass 1.normal force");
    g_autofree char *wall = contact_plate(0, 1, -G_PI / 2, 4, CONTACT_SMOOTH);
    return physics_run(&options,
                       CONTACT_WEIGHT "%s, " CONTACT_FLOOR ", " CONTACT_SMOOTH "}," CONTACT_POINT
                                      ", 'position': [0, %.17g]}, " CONTACT_POINT
                                      ", 'position': [%.17g, 0]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                       wall, cos(ladder_start), sin(ladder_start));
}

static void test_ladder(void)
{
    double off = contact_bisect(0.1, 1, ladder_presses, NULL), early = 0.7 * off, y[2];
    ladder_at(early, y);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) run = ladder(&contact_methods[i], early);
        double bound = contact_methods[i].smooth, c = cos(y[0]), s = sin(y[0]);
        contact_assert_state(run, "Mass 0", (double[]){0, c, 0, -s * y[1]}, 2 * bound);
        contact_assert_state(run, "Mass 1", (double[]){s, 0, c * y[1], 0}, 2 * bound);
        physics_assert_near("the wall's force", physics_last(run, 0), g * s * (3 * c - 2 * cos(ladder_start)),
                            40 * bound);
        physics_assert_near("the floor's force", physics_last(run, 1), g * (2 - s * s) - c * y[1] * y[1], 40 * bound);
    }
    ladder_at(off, y);
    double middle = sin(y[0]) / 2, speed = cos(y[0]) * y[1] / 2, later = 0.12;
    physics_rk4(2, y, 0, later, 4000, off_the_wall, NULL);
    g_assert_cmpfloat(y[0], <, G_PI / 2);
    middle += speed * later;
    double c = cos(y[0]), s = sin(y[0]);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) run = ladder(&contact_methods[i], off + later);
        double bound = 10 * contact_methods[i].smooth;
        contact_assert_event(run, "take-off", "Mass 0, Support 0", off, i < 2 ? 1e-10 : bound);
        contact_assert_state(run, "Mass 0", (double[]){middle - s / 2, c, speed - c / 2 * y[1], -s * y[1]}, bound);
        contact_assert_state(run, "Mass 1", (double[]){middle + s / 2, 0, speed + c / 2 * y[1], 0}, bound);
        contact_assert_taken(run, 0, 0, 1e-10);
    }
}

/* --- friction --- */

/* What sticks at the end of a rod is the pivot of an upturned pendulum. */
static void test_pivot_that_sticks(void)
{
    const double end = 0.8;
    double y[2] = {0.1, 0};
    physics_rk4(2, y, 0, end, 4000, on_the_wall, NULL);
    double c = cos(y[0]), s = sin(y[0]), push = g * c - y[1] * y[1];
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], end,
                                                 "Mass 0.normal force, Mass 0.friction force, Rod "
                                                 "0.tension");
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT CONTACT_FLOOR
                        ", 'static_friction': 5, 'dynamic_friction': 5}, " CONTACT_POINT ", 'mass': 10}, " CONTACT_POINT
                        ", 'position': [%.17g, %.17g]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                        sin(0.1), cos(0.1));
        double bound = 10 * contact_methods[i].smooth;
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
        contact_assert_state(run, "Mass 1", (double[]){s, c, c * y[1], -s * y[1]}, bound);
        physics_assert_near("normal force", physics_last(run, 0), 10 * g + push * c, 20 * bound);
        physics_assert_near("friction", physics_last(run, 1), push * s, 20 * bound);
        physics_assert_near("tension", physics_last(run, 2), -push, 20 * bound);
        contact_assert_taken(run, 0, 0, 1e-12);
    }
}

/* A slider on a rough floor, drawn by a crank pin on a circle of 0.1 m: where it is follows from the pin alone;
 * friction shows in the forces, and in what it takes. */
enum { CRANK_RATE = 3 };

typedef struct {
    double x, v, a, press, tension;
} Slider;

static Slider slider_at(double t)
{
    const double r = 0.1, l = 0.3, w = CRANK_RATE, m = 0.5, friction = 0.3;
    double c = cos(w * t), s = sin(w * t), q = sqrt(l * l - r * r * s * s), q1 = -r * r * w * s * c / q;
    Slider slider = {.x = r * c + q, .v = -r * w * s + q1};
    slider.a = -r * w * w * c - r * r * w * (w * (c * c - s * s) / q - s * c * q1 / (q * q));
    double along[2] = {(r * c - slider.x) / l, r * s / l}, against = slider.v < 0 ? 1 : -1;
    /* m a = T ux + against friction N and N = m g - T uy */
    slider.tension = (m * slider.a - against * friction * m * g) / (along[0] - against * friction * along[1]);
    slider.press = m * g - slider.tension * along[1];
    return slider;
}

/* What friction takes up to t, by Simpson's rule within each half turn. */
static double crank_friction(double t)
{
    double taken = 0, half = G_PI / CRANK_RATE;
    for (double from = 0; from < t; from += half) {
        double to = fmin(t, from + half);
        const int n = 2000;
        for (int i = 0; i <= n; i++) {
            Slider s = slider_at(from + (to - from) * i / n);
            taken += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * (to - from) / n / 3 * 0.3 * s.press * fabs(s.v);
        }
    }
    return taken;
}

static void test_slider_crank(void)
{
    const double duration = 2.5;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options =
            contact_options(&contact_methods[i], duration, "Mass 0.x, Mass 0.vx, Mass 0.normal force, Rod 0.tension");
        options.interval = 0.17;
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT CONTACT_FLOOR
            ", 'static_friction': 0.3, 'dynamic_friction': 0.3}, {'type': 'support', "
            "'solid': false}, " CONTACT_POINT ", 'mass': 0.5, 'position': [0.4, 0]}, {'type': 'rod', 'ends': ['Support "
            "1', 'Mass 0'], 'length': 0.3}, {'type': 'support-motion', 'ends': ['Support "
            "1'], 'waveform': {'expression': '0.1*cos(3*t)'}}, {'type': 'support-motion', "
            "'ends': ['Support 1'], 'angle': '90 deg', 'waveform': {'expression': "
            "'0.1*sin(3*t)'}}");
        double bound = contact_methods[i].smooth;
        for (gsize k = 1; k < physics_samples(run); k++) {
            Slider s = slider_at(physics_time(run, k));
            physics_assert_near("x", physics_value(run, k, 0), s.x, bound);
            physics_assert_near("vx", physics_value(run, k, 1), s.v, bound);
            physics_assert_near("normal force", physics_value(run, k, 2), s.press, 10 * bound);
            physics_assert_near("tension", physics_value(run, k, 3), s.tension, 10 * bound);
        }
        for (int n = 1; n <= 2; n++)
            contact_assert_event(run, "reversal", NULL, n * G_PI / CRANK_RATE, i < 2 ? 1e-10 : bound);
        contact_assert_count(run, "stick", 0);
        contact_assert_taken(run, crank_friction(duration), 0, 10 * bound);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-linkages/ladder", test_ladder);
    g_test_add_func("/physics/contact-linkages/pivot-that-sticks", test_pivot_that_sticks);
    g_test_add_func("/physics/contact-linkages/slider-crank", test_slider_crank);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

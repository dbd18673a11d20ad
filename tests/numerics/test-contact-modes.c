/* Forces of closed contacts, which stick, slide or open, and jams, where no forces exist, against closed forms, their
 * laws and a search through all that contacts can do. */
#include <math.h>
#include <string.h>

#include "contact-law-checks.h"

/* A block on a slope: holds up to atan(static friction), then slips with the dynamic one. */
static void test_slope(void)
{
    for (int32_t degree = -80; degree <= 80; degree++) {
        double slope = degree * G_PI / 180, mass = 2.5, g = 9.81, dynamic = 0.4;
        ContactCase block = {.count = 1, .delassus = {1 / mass, 0, 0, 1 / mass}, .friction = {0.6}};
        block.before[0] = -g * cos(slope);
        block.before[1] = -g * sin(slope);
        TinkerContactMode mode;
        double f[2];
        g_assert_cmpint(contact_laws_of_modes(&block, &dynamic, &mode, f), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpfloat_with_epsilon(f[0], mass * g * cos(slope), 1e-14);
        if (fabs(tan(slope)) <= 0.6) {
            g_assert_cmpint(mode, ==, TINKER_CONTACT_STICK);
            g_assert_cmpfloat_with_epsilon(f[1], mass * g * sin(slope), 1e-14);
        } else
            g_assert_cmpint(mode, ==, degree > 0 ? TINKER_CONTACT_SLIP_BACKWARD : TINKER_CONTACT_SLIP_FORWARD);
        block.sliding[0] = 1; /* rubs though it might hold */
        g_assert_cmpint(contact_laws_of_modes(&block, &dynamic, &mode, f), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpint(mode, ==, TINKER_CONTACT_SLIP_FORWARD);
    }
    /* at the angle of friction it holds, but for what is rounding; lifted, it opens; weightless, it stays closed */
    double mu = 0.75, f[2];
    ContactCase block = {.count = 1, .delassus = {1, 0, 0, 1}, .friction = {0.75}, .before = {-4 * 0.2, -3 * 0.2}};
    TinkerContactMode mode;
    contact_laws_of_modes(&block, &mu, &mode, f);
    g_assert_cmpint(mode, ==, TINKER_CONTACT_STICK);
    block.before[0] = 1e-3;
    contact_laws_of_modes(&block, &mu, &mode, f);
    g_assert_cmpint(mode, ==, TINKER_CONTACT_OPEN);
    block.before[0] = 1e-14;
    block.before[1] = -1e-14;
    contact_laws_of_modes(&block, &mu, &mode, f);
    g_assert_cmpint(mode, ==, TINKER_CONTACT_STICK);
}

/* A point in a groove whose sides rise at `angle`, held twice over; pulled sideways, too. */
static void test_groove(void)
{
    for (int32_t degree = 5; degree <= 85; degree += 5)
        for (int32_t pull = -20; pull <= 20; pull++) {
            double angle = degree * G_PI / 180, dynamic[2] = {0.3, 0.3}, load[2] = {0.5 * pull, -9.81}, f[4];
            double directions[4][2] = {{sin(angle), cos(angle)},
                                       {cos(angle), -sin(angle)},
                                       {-sin(angle), cos(angle)},
                                       {cos(angle), sin(angle)}};
            ContactCase mass = {.count = 2, .friction = {0.5, 0.5}};
            TinkerContactMode modes[2];
            for (int32_t i = 0; i < 4; i++) {
                mass.before[i] = directions[i][0] * load[0] + directions[i][1] * load[1];
                for (int32_t j = 0; j < 4; j++)
                    mass.delassus[i * 4 + j] =
                        directions[i][0] * directions[j][0] + directions[i][1] * directions[j][1];
            }
            g_assert_cmpint(contact_laws_of_modes(&mass, dynamic, modes, f), ==, TINKER_CONTACT_SOLVED);
            /* with both normals and no friction it would rest: then it rests */
            if (fabs(load[0]) < 9.81 * tan(angle)) {
                double sum[2] = {load[0], load[1]};
                for (int32_t i = 0; i < 8; i++)
                    sum[i % 2] += f[i / 2] * directions[i / 2][i % 2];
                g_assert_cmpfloat_with_epsilon(sum[0], 0, 1e-12);
                g_assert_cmpfloat_with_epsilon(sum[1], 0, 1e-12);
            }
        }
}

/* Several smooth contacts hold a mass along one direction: each bears as much as any other, but for rounding, of
 * which softened laws make 1e6 times as much. */
static void test_even_shares(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(11);
    for (int32_t round = 0; round < 400; round++) {
        const double mass = g_rand_double_range(random, 0.1, 10), dynamic[CASE_CONTACTS] = {0};
        ContactCase held = {.count = g_rand_int_range(random, 2, CASE_CONTACTS + 1)};
        TinkerContactMode modes[CASE_CONTACTS];
        double f[CASE_WIDTH];
        for (int32_t i = 0; i < held.count; i++) {
            held.before[2 * i] = -9.81 * (1 + g_rand_double_range(random, -4e-16, 4e-16));
            for (int32_t k = 0; k < held.count; k++)
                held.delassus[2 * i * 2 * held.count + 2 * k] = 1 / mass;
        }
        g_assert_cmpint(contact_laws_of_modes(&held, dynamic, modes, f), ==, TINKER_CONTACT_SOLVED);
        for (int32_t i = 0; i < held.count; i++) {
            g_assert_cmpint(modes[i], !=, TINKER_CONTACT_OPEN);
            g_assert_cmpfloat_with_epsilon(f[2 * i], mass * 9.81 / held.count, 1e-6 * mass);
        }
    }
}

/* None slides: there is a solution, whatever the bodies. Some slide: if and only if the search finds one. */
static void test_random_modes(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(5);
    int32_t none = 0;
    for (int32_t round = 0; round < 12000; round++) {
        ContactCase bodies;
        int32_t count = g_rand_int_range(random, 1, 5);
        gboolean slide = round % 2;
        contact_case_fill(&bodies, random, count, 2 * count + g_rand_int_range(random, -1, 3), FALSE, 2);
        double dynamic[CASE_CONTACTS], f[CASE_WIDTH];
        TinkerContactMode modes[CASE_CONTACTS];
        for (int32_t k = 0; k < count; k++) {
            bodies.friction[k] = g_rand_double_range(random, 0, 2);
            dynamic[k] = slide ? bodies.friction[k] : bodies.friction[k] * g_rand_double_range(random, 0, 1);
            if (slide) bodies.sliding[k] = (int8_t)g_rand_int_range(random, -1, 2);
        }
        TinkerContactResult result = contact_laws_of_modes(&bodies, dynamic, modes, f);
        gboolean exists = !slide || contact_case_has_solution(&bodies);
        g_assert_cmpint(result, ==, exists ? TINKER_CONTACT_SOLVED : TINKER_CONTACT_NO_ACCELERATION);
        none += !exists;
    }
    g_assert_cmpint(none, >, 100);
}

static void test_degenerate_modes(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(6);
    for (int32_t round = 0; round < 6000; round++) {
        ContactCase bodies;
        int32_t count = g_rand_int_range(random, 1, 7);
        contact_case_fill(&bodies, random, count, g_rand_int_range(random, 1, 2 * count + 1), TRUE, 0);
        double dynamic[CASE_CONTACTS], f[CASE_WIDTH];
        TinkerContactMode modes[CASE_CONTACTS];
        for (int32_t k = 0; k < count; k++) {
            bodies.friction[k] = 0.5 * g_rand_int_range(random, 0, 4);
            dynamic[k] = bodies.friction[k] * 0.5;
            if (bodies.friction[k] == 0) bodies.sliding[k] = (int8_t)g_rand_int_range(random, -1, 2);
        }
        g_assert_cmpint(contact_laws_of_modes(&bodies, dynamic, modes, f), ==, TINKER_CONTACT_SOLVED);
    }
}

/* Painleve's rod, of length 2 and mass 1, its lower end at the left, slides with sign `sliding`. */
static void fill_rod(double angle, double friction, int8_t sliding, double rate, ContactCase *rod)
{
    double s = sin(angle), c = cos(angle), w[4] = {1 + 3 * c * c, -3 * s * c, -3 * s * c, 1 + 3 * s * s};
    *rod = (ContactCase){.count = 1, .friction = {friction}, .sliding = {sliding}};
    memcpy(rod->delassus, w, sizeof w);
    rod->before[0] = -9.81 + rate * rate * s;
    rod->before[1] = rate * rate * c;
}

/* Without paradox below a friction of 4/3; else it jams where 1 + 3 cos^2 <= 3 friction sin cos and nothing lifts the
 * end. */
static void test_painleve(void)
{
    int32_t jams = 0;
    for (int32_t degree = 1; degree < 90; degree++)
        for (int32_t tenths = 0; tenths < 30; tenths++)
            for (int32_t rate = 0; rate <= 4; rate += 4) {
                ContactCase rod;
                double angle = degree * G_PI / 180, friction = 0.1 * tenths, f[2], p[2], u[2] = {0, -2};
                fill_rod(angle, friction, -1, rate, &rod);
                double inertia = rod.delassus[0] + friction * rod.delassus[1], a_n = rod.before[0];
                TinkerContactMode mode;
                TinkerContactResult result = contact_laws_of_modes(&rod, rod.friction, &mode, f);
                gboolean jam = inertia <= 0 && a_n < 0;
                g_assert_cmpint(result, ==, jam ? TINKER_CONTACT_NO_ACCELERATION : TINKER_CONTACT_SOLVED);
                if (friction < 4.0 / 3) g_assert_false(jam);
                if (!jam) {
                    g_assert_cmpfloat_with_epsilon(f[0], a_n < 0 ? -a_n / inertia : 0, 1e-13 * (1 + f[0] / inertia));
                    continue;
                }
                jams++;
                TinkerClosedContacts closed = {1,    rod.delassus, rod.before, rod.sliding, rod.friction, rod.friction,
                                               1e-13};
                g_assert_cmpint(tinker_contact_jam(&closed, u, p), ==, TINKER_CONTACT_SOLVED);
                /* it comes to rest: W p = -u */
                double determinant = rod.delassus[0] * rod.delassus[3] - rod.delassus[1] * rod.delassus[1];
                g_assert_cmpfloat_with_epsilon(p[0], rod.delassus[1] * u[1] / determinant, 1e-13);
                g_assert_cmpfloat_with_epsilon(p[1], -rod.delassus[0] * u[1] / determinant, 1e-13);
                g_assert_cmpfloat(fabs(p[1]), <=, friction * p[0]);
            }
    g_assert_cmpint(jams, >, 200);
}

/* Of several contacts, wherever no forces exist: an impulse that is one, keeps the laws of impact without restitution
 * and takes energy. What is taken to be at rest may move a little: the blow before left it so. */
static void test_random_jams(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(7);
    int32_t jams = 0;
    for (int32_t round = 0; round < 12000; round++) {
        ContactCase bodies;
        int32_t count = g_rand_int_range(random, 1, 5);
        contact_case_fill(&bodies, random, count, 2 * count + 1, FALSE, 2);
        double f[CASE_WIDTH], p[CASE_WIDTH], u[CASE_WIDTH], after[CASE_WIDTH], rounding[CASE_WIDTH], most = 0;
        double seen[CASE_WIDTH] = {0};
        TinkerContactMode modes[CASE_CONTACTS];
        for (int32_t k = 0; k < count; k++) {
            bodies.friction[k] = g_rand_double_range(random, 0, 3);
            u[2 * k] = 0;
            u[2 * k + 1] = g_rand_int_range(random, 0, 4) ? g_rand_double_range(random, -1, 1) : 0;
            bodies.sliding[k] = (int8_t)((u[2 * k + 1] > 0) - (u[2 * k + 1] < 0));
            seen[2 * k + 1] = bodies.sliding[k] != 0 ? u[2 * k + 1] : round % 2 == 0 ? 1e-5 : -1e-5;
        }
        TinkerClosedContacts closed = {count,           bodies.delassus, bodies.before, bodies.sliding,
                                       bodies.friction, bodies.friction, 1e-13};
        if (tinker_contact_modes(&closed, modes, f) == TINKER_CONTACT_SOLVED) continue;
        jams++;
        g_assert_cmpint(tinker_contact_jam(&closed, seen, p), ==, TINKER_CONTACT_SOLVED);
        memcpy(bodies.before, u, sizeof u);
        contact_case_after(&bodies, p, after, rounding);
        for (int32_t k = 0; k < count; k++) {
            int32_t n = 2 * k, t = n + 1;
            most = MAX(most, p[n]);
            g_assert_cmpfloat(p[n], >=, 0);
            g_assert_cmpfloat(after[n], >=, -10 * rounding[n]);
            if (p[n] > 0) g_assert_cmpfloat(after[n], <=, 10 * rounding[n]);
            g_assert_cmpfloat(fabs(p[t]), <=, bodies.friction[k] * p[n]);
            if (fabs(after[t]) > 10 * rounding[t])
                g_assert_cmpfloat_with_epsilon(p[t], -copysign(bodies.friction[k] * p[n], after[t]),
                                               1e-14 + 1e-12 * p[n]);
        }
        g_assert_cmpfloat(most, >, 1e-9);
        g_assert_cmpfloat(contact_laws_energy_gained(&bodies, p), <, 0);
    }
    g_assert_cmpint(jams, >, 500);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/contact-laws/modes/slope", test_slope);
    g_test_add_func("/contact-laws/modes/groove", test_groove);
    g_test_add_func("/contact-laws/modes/even-shares", test_even_shares);
    g_test_add_func("/contact-laws/modes/random", test_random_modes);
    g_test_add_func("/contact-laws/modes/degenerate", test_degenerate_modes);
    g_test_add_func("/contact-laws/painleve", test_painleve);
    g_test_add_func("/contact-laws/jams", test_random_jams);
    return g_test_run();
}

/* Impacts, forces and jams of contacts against closed forms, the laws themselves, and a search through all that
 * contacts can do. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "contact-case.h"
#include "numerics/contact/contact-laws.h"

static void impact_laws(const ContactCase *bodies, const double *least, double *p)
{
    TinkerImpact impact = {bodies->count, bodies->delassus, bodies->before, NULL, bodies->friction, least};
    double after[CASE_WIDTH], rounding[CASE_WIDTH];
    g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
    contact_case_after(bodies, p, after, rounding);
    for (int32_t k = 0; k < bodies->count; k++) {
        int32_t n = 2 * k, t = n + 1;
        g_assert_cmpfloat(p[n], >=, 0);
        g_assert_cmpfloat(after[n] - least[k], >=, -rounding[n]);
        if (p[n] > 0) g_assert_cmpfloat(after[n] - least[k], <=, rounding[n]);
        g_assert_cmpfloat(fabs(p[t]), <=, bodies->friction[k] * p[n]);
        if (fabs(after[t]) > rounding[t])
            g_assert_cmpfloat_with_epsilon(p[t], -copysign(bodies->friction[k] * p[n], after[t]), 1e-15 + 1e-13 * p[n]);
    }
}

/* m (1 + a^2) for a body hit off its centre: W = [1 + a^2, a b; a b, 1 + b^2] / m. */
static void off_centre(double mass, double a, double b, double *w)
{
    w[0] = (1 + a * a) / mass;
    w[1] = w[2] = a * b / mass;
    w[3] = (1 + b * b) / mass;
}

static void test_single_impact(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(1);
    for (int32_t round = 0; round < 20000; round++) {
        double w[4], u[2], p[2], mass = pow(10, g_rand_double_range(random, -9, 9)),
                                 e = g_rand_double_range(random, 0, 1);
        double friction = round % 3 == 0 ? 0 : g_rand_double_range(random, 0, 0.5),
               speed = pow(10, g_rand_double_range(random, -12, 6));
        off_centre(mass, 0, round % 2 ? 0 : 1, w);
        u[0] = -speed * g_rand_double_range(random, 0.1, 1);
        u[1] = speed * g_rand_double_range(random, -1, 1);
        if (round % 7 == 0) e = round % 2;
        TinkerImpact impact = {1, w, u, &e, &friction, NULL};
        g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpfloat_with_epsilon(u[0] + w[0] * p[0], -e * u[0], 4 * DBL_EPSILON * fabs(u[0]));
        double holding = -u[1] / w[3], most = friction * p[0];
        if (fabs(holding) <= most)
            g_assert_cmpfloat(p[1], ==, holding);
        else
            g_assert_cmpfloat(p[1], ==, copysign(most, holding));
    }
    /* what parts is left alone; so is what nothing can move */
    double w[4] = {1, 0, 0, 1}, p[2], u[2] = {1, -3}, still[4] = {0}, closing[2] = {-1, 0}, half = 0.5;
    TinkerImpact parting = {1, w, u, &half, &half, NULL}, fixed = {1, still, closing, &half, &half, NULL};
    g_assert_cmpint(tinker_impact_solve(&parting, p), ==, TINKER_CONTACT_SOLVED);
    g_assert_true(p[0] == 0 && p[1] == 0);
    g_assert_cmpint(tinker_impact_solve(&fixed, p), ==, TINKER_CONTACT_NO_ACCELERATION);
}

/* Coupled directions: stick where its impulse lies in the cone, else sliding that goes the way it says. */
static void test_coupled_impact(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(2);
    for (int32_t round = 0; round < 20000; round++) {
        ContactCase bodies = {.count = 1};
        double p[2], zero = 0;
        off_centre(1, g_rand_double_range(random, -3, 3), g_rand_double_range(random, -3, 3), bodies.delassus);
        bodies.friction[0] = g_rand_double_range(random, 0, 3);
        bodies.before[0] = -g_rand_double_range(random, 0, 1);
        bodies.before[1] = g_rand_double_range(random, -1, 1);
        impact_laws(&bodies, &zero, p);
    }
}

/* What an impact adds to the energy, as a share of the sum of the terms without their signs. */
static double energy_gained(const ContactCase *bodies, const double *p)
{
    int32_t width = 2 * bodies->count;
    long double gained = 0, total = 0;
    for (int32_t i = 0; i < width; i++) {
        gained += (long double)p[i] * bodies->before[i];
        total += fabsl((long double)p[i] * bodies->before[i]);
        for (int32_t j = 0; j < width; j++) {
            long double term = 0.5L * p[i] * bodies->delassus[i * width + j] * p[j];
            gained += term;
            total += fabsl(term);
        }
    }
    return total > 0 ? (double)(gained / total) : 0;
}

/* The laws hold with one common share of the restitution, which is less than 1 only where no energy is lost. */
static void test_random_impacts(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(3);
    int32_t held_back = 0;
    for (int32_t round = 0; round < 12000; round++) {
        ContactCase bodies;
        int32_t count = g_rand_int_range(random, 1, 5);
        contact_case_fill(&bodies, random, count, 2 * count + g_rand_int_range(random, 0, 3), FALSE, round % 3 * 3);
        double e[CASE_CONTACTS], p[CASE_WIDTH], again[CASE_WIDTH], after[CASE_WIDTH], rounding[CASE_WIDTH], share = 1;
        double least[CASE_CONTACTS];
        for (int32_t k = 0; k < count; k++) {
            bodies.friction[k] = k % 3 == 2 ? 0 : g_rand_double_range(random, 0, 2);
            e[k] = round % 5 == 0 ? 1 : g_rand_double_range(random, 0, 1);
        }
        TinkerImpact impact = {count, bodies.delassus, bodies.before, e, bodies.friction, NULL};
        g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
        contact_case_after(&bodies, p, after, rounding);
        g_assert_cmpfloat(energy_gained(&bodies, p), <=, 1e-14);
        double finest = 1e-4; /* the share is read where rounding blurs it least */
        for (int32_t k = 0; k < count; k++) {
            double rebound = -e[k] * bodies.before[2 * k], blur = rounding[2 * k] / rebound;
            if (!(p[2 * k] > 0 && rebound > 0 && blur < finest)) continue;
            finest = blur;
            share = after[2 * k] / rebound;
        }
        if (share < 1 - 10 * finest) { /* a little more would gain: smoothly, or by a leap where contacts wedge */
            held_back++;
            for (int32_t k = 0; k < count; k++)
                least[k] = bodies.before[2 * k] < 0 ? -(share + 1e-6 + 10 * finest) * e[k] * bodies.before[2 * k] : 0;
            impact_laws(&bodies, least, again);
            g_assert_cmpfloat(energy_gained(&bodies, again), >, -1e-9);
        } else
            share = 1;
        for (int32_t k = 0; k < count; k++)
            least[k] = bodies.before[2 * k] < 0 ? -share * e[k] * bodies.before[2 * k] : 0;
        impact_laws(&bodies, least, again);
        for (int32_t k = 0; k < count; k++)
            if (p[2 * k] > 0)
                g_assert_cmpfloat_with_epsilon(after[2 * k], least[k], rounding[2 * k] + finest * fabs(least[k]));
    }
    g_assert_cmpint(held_back, >, 50);
}

/* Kane's paradox: a double pendulum of rods strikes a floor with friction; Newton's restitution gains energy there. */
static void test_kane(void)
{
    int32_t held_back = 0;
    for (int32_t round = 0; round < 400; round++) {
        /* rods of length 1 and mass 1 from a pivot, angles from the vertical; tip velocity J (w1, w2) */
        double a = G_PI / 9, b = G_PI / 6, c = cos(b - a) / 2, determinant = 4.0 / 9 - c * c;
        const double inverse[4] = {1 / 3.0 / determinant, -c / determinant, -c / determinant, 4 / 3.0 / determinant};
        double jacobian[2][2] = {{sin(a), sin(b)}, {cos(a), cos(b)}};
        const double rates[2] = {-0.1 - 0.01 * (round % 20), -0.2 + 0.02 * (round / 20)};
        ContactCase bodies = {.count = 1, .friction = {0.5}};
        for (int32_t i = 0; i < 2; i++) {
            bodies.before[i] = jacobian[i][0] * rates[0] + jacobian[i][1] * rates[1];
            for (int32_t j = 0; j < 2; j++)
                for (int32_t k = 0; k < 4; k++)
                    bodies.delassus[i * 2 + j] += jacobian[i][k / 2] * inverse[k] * jacobian[j][k % 2];
        }
        double e = 0.7, p[2], after[2], rounding[2];
        TinkerImpact impact = {1, bodies.delassus, bodies.before, &e, bodies.friction, NULL};
        g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
        contact_case_after(&bodies, p, after, rounding);
        g_assert_cmpfloat(energy_gained(&bodies, p), <=, 1e-14);
        if (bodies.before[0] < 0 && after[0] < -e * bodies.before[0] - 1e-9) {
            held_back++;
            g_assert_cmpfloat_with_epsilon(energy_gained(&bodies, p), 0, 1e-12);
        }
    }
    g_assert_cmpint(held_back, >, 10);
}

/* Bodies apart from one another do as each would alone, to rounding, however their masses and speeds differ. */
static void test_scales(void)
{
    static const double masses[4] = {1e-9, 1, 1e9, 1e3}, speeds[4] = {1e4, 1e-3, 1, 1e-4};
    ContactCase bodies = {.count = 4};
    double e[4] = {0.5, 1, 0, 0.25}, p[8];
    for (int32_t k = 0; k < 4; k++) {
        double w[4], *at = bodies.delassus + 2 * k * 9;
        off_centre(masses[k], 0.5, 0.25, w);
        at[0] = w[0];
        at[1] = at[8] = w[1];
        at[9] = w[3];
        bodies.before[2 * k] = -speeds[k];
        bodies.before[2 * k + 1] = k * speeds[k];
        bodies.friction[k] = 0.2 * k;
    }
    TinkerImpact impact = {4, bodies.delassus, bodies.before, e, bodies.friction, NULL};
    g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
    for (int32_t k = 0; k < 4; k++) {
        double w[4], alone[2];
        off_centre(masses[k], 0.5, 0.25, w);
        TinkerImpact single = {1, w, bodies.before + 2 * k, e + k, bodies.friction + k, NULL};
        g_assert_cmpint(tinker_impact_solve(&single, alone), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpfloat_with_epsilon(p[2 * k], alone[0], 1e-15 * alone[0]);
        g_assert_cmpfloat_with_epsilon(p[2 * k + 1], alone[1], 1e-15 * alone[0]);
    }
}

/* Whole numbers, low rank: redundant contacts and ties. */
static void test_degenerate_impacts(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(4);
    for (int32_t round = 0; round < 6000; round++) {
        ContactCase bodies;
        int32_t count = g_rand_int_range(random, 1, 7);
        double least[CASE_CONTACTS] = {0}, p[CASE_WIDTH];
        contact_case_fill(&bodies, random, count, g_rand_int_range(random, 1, 2 * count + 1), TRUE, 0);
        for (int32_t k = 0; k < count; k++) {
            bodies.friction[k] = 0.5 * g_rand_int_range(random, 0, 4);
            /* a normal direction that nothing moves along is no contact */
            bodies.delassus[2 * k * (2 * count + 1)] += bodies.delassus[2 * k * (2 * count + 1)] == 0;
        }
        impact_laws(&bodies, least, p);
    }
}

/* What came out of tinker_contact_modes keeps the laws. */
static TinkerContactResult modes_laws(const ContactCase *bodies, const double *dynamic, TinkerContactMode *modes,
                                      double *f)
{
    TinkerClosedContacts closed = {bodies->count,    bodies->delassus, bodies->before, bodies->sliding,
                                   bodies->friction, dynamic,          1e-13};
    TinkerContactResult result = tinker_contact_modes(&closed, modes, f);
    if (result != TINKER_CONTACT_SOLVED) return result;
    double a[CASE_WIDTH], rounding[CASE_WIDTH];
    contact_case_after(bodies, f, a, rounding);
    for (int32_t k = 0; k < bodies->count; k++) {
        int32_t n = 2 * k, t = n + 1;
        double noise = 1e-13 + 2 * rounding[t], rub = dynamic[k] * f[n];
        g_assert_cmpfloat(f[n], >=, 0);
        g_assert_cmpfloat(a[n], >=, -1e-13 - 2 * rounding[n]);
        if (modes[k] == TINKER_CONTACT_OPEN) {
            g_assert_true(f[n] == 0 && f[t] == 0);
            continue;
        }
        g_assert_cmpfloat(a[n], <=, 1e-13 + 2 * rounding[n]);
        if (modes[k] == TINKER_CONTACT_STICK) {
            g_assert_cmpint(bodies->sliding[k], ==, 0);
            g_assert_cmpfloat(fabs(a[t]), <=, noise);
            g_assert_cmpfloat(fabs(f[t]), <=, bodies->friction[k] * f[n] * (1 + 4e-16));
        } else {
            double sign = modes[k] == TINKER_CONTACT_SLIP_FORWARD ? 1 : -1;
            g_assert_cmpfloat_with_epsilon(f[t], -sign * rub, 1e-15 + 1e-13 * rub);
            if (bodies->sliding[k] != 0)
                g_assert_cmpint((int)sign, ==, bodies->sliding[k]);
            else
                g_assert_cmpfloat(sign * a[t], >=, -noise);
        }
    }
    return result;
}

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
        g_assert_cmpint(modes_laws(&block, &dynamic, &mode, f), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpfloat_with_epsilon(f[0], mass * g * cos(slope), 1e-14);
        if (fabs(tan(slope)) <= 0.6) {
            g_assert_cmpint(mode, ==, TINKER_CONTACT_STICK);
            g_assert_cmpfloat_with_epsilon(f[1], mass * g * sin(slope), 1e-14);
        } else
            g_assert_cmpint(mode, ==, degree > 0 ? TINKER_CONTACT_SLIP_BACKWARD : TINKER_CONTACT_SLIP_FORWARD);
        block.sliding[0] = 1; /* rubs though it might hold */
        g_assert_cmpint(modes_laws(&block, &dynamic, &mode, f), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpint(mode, ==, TINKER_CONTACT_SLIP_FORWARD);
    }
    /* at the angle of friction it holds, but for what is rounding; lifted, it opens; weightless, it stays closed */
    double mu = 0.75, f[2];
    ContactCase block = {.count = 1, .delassus = {1, 0, 0, 1}, .friction = {0.75}, .before = {-4 * 0.2, -3 * 0.2}};
    TinkerContactMode mode;
    modes_laws(&block, &mu, &mode, f);
    g_assert_cmpint(mode, ==, TINKER_CONTACT_STICK);
    block.before[0] = 1e-3;
    modes_laws(&block, &mu, &mode, f);
    g_assert_cmpint(mode, ==, TINKER_CONTACT_OPEN);
    block.before[0] = 1e-14;
    block.before[1] = -1e-14;
    modes_laws(&block, &mu, &mode, f);
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
            g_assert_cmpint(modes_laws(&mass, dynamic, modes, f), ==, TINKER_CONTACT_SOLVED);
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
        TinkerContactResult result = modes_laws(&bodies, dynamic, modes, f);
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
        g_assert_cmpint(modes_laws(&bodies, dynamic, modes, f), ==, TINKER_CONTACT_SOLVED);
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
                TinkerContactResult result = modes_laws(&rod, rod.friction, &mode, f);
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
 * and takes energy. */
static void test_random_jams(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(7);
    int32_t jams = 0;
    for (int32_t round = 0; round < 12000; round++) {
        ContactCase bodies;
        int32_t count = g_rand_int_range(random, 1, 5);
        contact_case_fill(&bodies, random, count, 2 * count + 1, FALSE, 2);
        double f[CASE_WIDTH], p[CASE_WIDTH], u[CASE_WIDTH], after[CASE_WIDTH], rounding[CASE_WIDTH], most = 0;
        TinkerContactMode modes[CASE_CONTACTS];
        for (int32_t k = 0; k < count; k++) {
            bodies.friction[k] = g_rand_double_range(random, 0, 3);
            u[2 * k] = 0;
            u[2 * k + 1] = g_rand_int_range(random, 0, 4) ? g_rand_double_range(random, -1, 1) : 0;
            bodies.sliding[k] = (int8_t)((u[2 * k + 1] > 0) - (u[2 * k + 1] < 0));
        }
        TinkerClosedContacts closed = {count,           bodies.delassus, bodies.before, bodies.sliding,
                                       bodies.friction, bodies.friction, 1e-13};
        if (tinker_contact_modes(&closed, modes, f) == TINKER_CONTACT_SOLVED) continue;
        jams++;
        g_assert_cmpint(tinker_contact_jam(&closed, u, p), ==, TINKER_CONTACT_SOLVED);
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
        g_assert_cmpfloat(energy_gained(&bodies, p), <, 0);
    }
    g_assert_cmpint(jams, >, 500);
}

/* Ten contacts on one tangle of bodies, in a third of the rounds with fewer freedoms than directions. */
static void test_many(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(8);
    for (int32_t round = 0; round < 300; round++) {
        ContactCase bodies;
        contact_case_fill(&bodies, random, 10, round % 3 == 0 ? 12 : 20, FALSE, round % 3 * 2);
        double dynamic[CASE_CONTACTS], f[CASE_WIDTH], least[CASE_CONTACTS] = {0};
        TinkerContactMode modes[CASE_CONTACTS];
        for (int32_t k = 0; k < 10; k++) {
            bodies.friction[k] = g_rand_double_range(random, 0, 1);
            dynamic[k] = 0.7 * bodies.friction[k];
        }
        g_assert_cmpint(modes_laws(&bodies, dynamic, modes, f), ==, TINKER_CONTACT_SOLVED);
        impact_laws(&bodies, least, f);
    }
}

/* What p misses the laws by, `least` at least along the normals, as a share of the speeds and impulses. */
static double missed(const ContactCase *bodies, const double *least, const double *p)
{
    double after[CASE_WIDTH], rounding[CASE_WIDTH], speed = DBL_MIN, most = DBL_MIN, worst = 0;
    contact_case_after(bodies, p, after, rounding);
    for (int32_t i = 0; i < 2 * bodies->count; i++) {
        speed = MAX(speed, fabs(bodies->before[i]));
        most = MAX(most, fabs(p[i]));
    }
    for (int32_t k = 0; k < bodies->count; k++) {
        double n = after[2 * k] - least[k], t = after[2 * k + 1], bound = bodies->friction[k] * p[2 * k];
        g_assert_cmpfloat(p[2 * k], >=, 0);
        g_assert_cmpfloat(fabs(p[2 * k + 1]), <=, bound);
        worst = MAX(worst, -n / speed);
        /* the less of what two things that exclude one another are */
        worst = MAX(worst, MIN(fabs(n) / speed, p[2 * k] / most));
        if (t != 0) worst = MAX(worst, MIN(fabs(t) / speed, fabs(p[2 * k + 1] + copysign(bound, t)) / most));
    }
    return worst;
}

/* Chains that lie or fall on floors always have a solution: rods may tie contacts together so that W is singular, and
 * then velocities that are rounding decide nothing. */
static void test_chains(void)
{
    static const double noises[] = {0, 1e-18, 1e-16, 1e-14, 1e-13};
    g_autoptr(GRand) random = g_rand_new_with_seed(9);
    for (int32_t round = 0; round < 10000; round++) {
        ContactCase bodies;
        contact_case_fill_chain(&bodies, random, noises[round % G_N_ELEMENTS(noises)]);
        double e[CASE_CONTACTS], least[CASE_CONTACTS] = {0}, p[CASE_WIDTH], f[CASE_WIDTH], dynamic[CASE_CONTACTS];
        gboolean smooth = g_rand_int_range(random, 0, 4) == 0;
        for (int32_t k = 0; k < bodies.count; k++) {
            bodies.friction[k] = smooth ? 0 : round % 2 ? 0.5 : g_rand_double_range(random, 0, 1.5);
            e[k] = g_rand_int_range(random, 0, 4) / 3.0;
            dynamic[k] = 0.7 * bodies.friction[k];
        }
        TinkerImpact soft = {bodies.count, bodies.delassus, bodies.before, NULL, bodies.friction, least},
                     hard = {bodies.count, bodies.delassus, bodies.before, e, bodies.friction, NULL};
        g_assert_cmpint(tinker_impact_solve(&soft, p), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpfloat(missed(&bodies, least, p), <=, 1e-9);
        g_assert_cmpint(tinker_impact_solve(&hard, p), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpfloat(energy_gained(&bodies, p), <=, 1e-9);
        TinkerContactMode modes[CASE_CONTACTS];
        TinkerClosedContacts closed = {bodies.count,    bodies.delassus, bodies.before, bodies.sliding,
                                       bodies.friction, dynamic,         1e-12};
        g_assert_cmpint(tinker_contact_modes(&closed, modes, f), ==, TINKER_CONTACT_SOLVED);
    }
}

/* Five masses on a line of four rods, one of which strikes: all else rests, but for rounding. Tangential directions
 * that rods tie together are equal rows of W. */
static void test_resting_chain(void)
{
    static const double distinct[4][4] = {
        {0.23346137430644476, -0.11194618691111091, 0.11194618691111091, 0.1498079385403329},
        {-0.11194618691111091, 0.8745198463508321, 0.12548015364916787, 0.16791928036666637},
        {0.11194618691111091, 0.12548015364916787, 0.8745198463508321, -0.16791928036666637},
        {0.14980793854033295, 0.16791928036666637, -0.16791928036666637, 0.2752880921895007},
    };
    static const int8_t which[10] = {-1, 0, 1, 0, 2, 3, -1, 3, -1, 0}; /* -1: of a direction by itself */
    ContactCase bodies = {.count = 5,
                          .before = {0.0, -8.624326725198449e-20, -9.794453105918753e-21, 6.002912151974175e-20,
                                     9.79445310592193e-21, 4.3462297807821606e-20, 0.0, -1.7248152075579615e-20,
                                     -0.15654670373157423, -7.488181270186963e-18}};
    double least[5] = {0}, p[10];
    for (int32_t i = 0; i < 10; i++)
        for (int32_t j = 0; j < 10; j++)
            bodies.delassus[i * 10 + j] = which[i] < 0 || which[j] < 0 ? i == j : distinct[which[i]][which[j]];
    for (int32_t k = 0; k < 5; k++)
        bodies.friction[k] = 0.5;
    TinkerImpact impact = {5, bodies.delassus, bodies.before, NULL, bodies.friction, least};
    g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
    for (int32_t i = 0; i < 10; i++)
        g_assert_cmpfloat_with_epsilon(p[i], i == 8 ? -bodies.before[8] : 0, 1e-15);
}

/* A mass on a rod that stands too steeply for friction: it can move along (1, -7) alone, and cannot part again. */
static void test_wedge(void)
{
    const double w[4] = {0.02, -0.14, -0.14, 0.98}, velocity[2] = {-0.3, 2.1}, friction = 0.5, e = 1;
    double p[2];
    TinkerImpact impact = {1, w, velocity, &e, &friction, NULL};
    g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
    g_assert_cmpfloat_with_epsilon(p[0] - 7 * p[1], 15, 15e-9); /* W p = -u, and what rebound is rounding */
    g_assert_cmpfloat(fabs(p[1]), <=, friction * p[0]);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/contact-laws/impact/single", test_single_impact);
    g_test_add_func("/contact-laws/impact/coupled", test_coupled_impact);
    g_test_add_func("/contact-laws/impact/random", test_random_impacts);
    g_test_add_func("/contact-laws/impact/kane", test_kane);
    g_test_add_func("/contact-laws/impact/scales", test_scales);
    g_test_add_func("/contact-laws/impact/degenerate", test_degenerate_impacts);
    g_test_add_func("/contact-laws/modes/slope", test_slope);
    g_test_add_func("/contact-laws/modes/groove", test_groove);
    g_test_add_func("/contact-laws/modes/random", test_random_modes);
    g_test_add_func("/contact-laws/modes/degenerate", test_degenerate_modes);
    g_test_add_func("/contact-laws/painleve", test_painleve);
    g_test_add_func("/contact-laws/jams", test_random_jams);
    g_test_add_func("/contact-laws/many", test_many);
    g_test_add_func("/contact-laws/impact/resting-chain", test_resting_chain);
    g_test_add_func("/contact-laws/impact/wedge", test_wedge);
    g_test_add_func("/contact-laws/chains", test_chains);
    return g_test_run();
}

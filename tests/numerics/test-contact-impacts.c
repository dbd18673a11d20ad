/* Impacts against closed forms and their laws. */
#include <float.h>
#include <math.h>

#include "contact-law-checks.h"

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
        contact_laws_of_impact(&bodies, &zero, p);
    }
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
        g_assert_cmpfloat(contact_laws_energy_gained(&bodies, p), <=, 1e-14);
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
            contact_laws_of_impact(&bodies, least, again);
            g_assert_cmpfloat(contact_laws_energy_gained(&bodies, again), >, -1e-9);
        } else
            share = 1;
        for (int32_t k = 0; k < count; k++)
            least[k] = bodies.before[2 * k] < 0 ? -share * e[k] * bodies.before[2 * k] : 0;
        contact_laws_of_impact(&bodies, least, again);
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
        g_assert_cmpfloat(contact_laws_energy_gained(&bodies, p), <=, 1e-14);
        if (bodies.before[0] < 0 && after[0] < -e * bodies.before[0] - 1e-9) {
            held_back++;
            g_assert_cmpfloat_with_epsilon(contact_laws_energy_gained(&bodies, p), 0, 1e-12);
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
        contact_laws_of_impact(&bodies, least, p);
    }
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

/* Boxes between two walls: neighbours touch at two points, whose rows depend on one another, with friction that wedges
 * them. */
enum { BOXES = 12, POINTS = 2 * (BOXES + 1), ROWS = 2 * POINTS };

/* Rows of a point at (x, y) of a box at the left and one at the right, which touch across; -1: a wall. */
static void add_point(double rows[ROWS][3 * BOXES], int32_t point, const double at[2], const double places[BOXES][2],
                      int32_t left, const double n[2])
{
    for (int side = 0; side < 2; side++) {
        const int32_t box = left + side;
        if (box < 0 || box == BOXES) continue;
        const double sign = side == 0 ? 1 : -1, x = at[0] - places[box][0], y = at[1] - places[box][1];
        double *normal = rows[2 * point] + 3 * box, *slide = rows[2 * point + 1] + 3 * box;
        normal[0] = slide[1] = sign * -n[0];
        normal[1] = sign * -n[1];
        slide[0] = sign * n[1];
        normal[2] = (x * normal[1] - y * normal[0]) / 0.2;
        slide[2] = (x * slide[1] - y * slide[0]) / 0.2;
    }
}

/* Impulses without rebound keep the laws, to 1e-6 of the largest velocity. */
static void assert_laws(int32_t count, const double *w, const double *u, const double *friction, const double *p)
{
    const int32_t rows = 2 * count;
    double largest = 0;
    for (int32_t i = 0; i < rows; i++)
        largest = fmax(largest, fabs(u[i]));
    for (int32_t k = 0; k < count; k++) {
        const double noise = 1e-6 * largest, pn = p[2 * k], pt = p[2 * k + 1], most = friction[k] * pn;
        double after[2] = {u[2 * k], u[2 * k + 1]};
        for (int32_t i = 0; i < 2 * rows; i++)
            after[i / rows] += w[2 * k * rows + i] * p[i % rows];
        g_assert_cmpfloat(pn, >=, 0);
        g_assert_cmpfloat(fabs(pt), <=, most * (1 + 1e-12));
        g_assert_cmpfloat(after[0], >=, -noise);
        if (pn > noise) g_assert_cmpfloat(after[0], <=, noise);
        if (pt > noise - most) g_assert_cmpfloat(after[1], <=, noise);
        if (pt < most - noise) g_assert_cmpfloat(after[1], >=, -noise);
    }
}

/* The laws hold for pivots alone, to 1e-7 of the largest velocity, however degenerate the problem. */
static void test_pivot(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(5);
    for (int32_t round = 0; round < 200; round++) {
        double rows[ROWS][3 * BOXES] = {0}, places[BOXES][2], v[3 * BOXES], mass[BOXES];
        double w[ROWS * ROWS] = {0}, u[ROWS] = {0}, least[POINTS] = {0}, friction[POINTS], p[ROWS];
        for (int32_t i = 0; i < BOXES; i++) {
            places[i][0] = 0.5 * i;
            places[i][1] = g_rand_double_range(random, -0.1, 0.1);
            mass[i] = g_rand_int_range(random, 1, 4);
            for (int k = 0; k < 3; k++)
                v[3 * i + k] = round % 2 ? g_rand_double_range(random, -1, 1) : k == 1 ? -0.1 : 0;
        }
        for (int32_t k = 0; k < POINTS; k++) {
            const double angle = 0.1 * g_rand_int_range(random, -1, 2), n[2] = {cos(angle), sin(angle)};
            const double at[2] = {0.5 * (k / 2) - 0.25, k % 2 ? 0.2 : -0.2};
            add_point(rows, k, at, (const double(*)[2])places, k / 2 - 1, n);
            friction[k] = 0.5 * g_rand_int_range(random, 1, 4);
        }
        for (int32_t i = 0; i < ROWS; i++)
            for (int32_t c = 0; c < 3 * BOXES; c++) {
                u[i] += rows[i][c] * v[c];
                for (int32_t j = 0; j < ROWS; j++)
                    w[i * ROWS + j] += rows[i][c] * rows[j][c] / mass[c / 3];
            }
        g_autofree double *room = g_new(double, tinker_impact_pivot_room(POINTS));
        const TinkerImpact impact = {POINTS, w, u, NULL, friction, least};
        g_assert_true(tinker_impact_pivot(&impact, room, p));
        assert_laws(POINTS, w, u, friction, p);
    }
}

/* Contacts of two bodies, some of them next to others: corners that meet corners hold nearly the same place twice. */
static void test_twins(void)
{
    enum { CONTACTS = 7, COORDINATES = 6 };
    g_autoptr(GRand) random = g_rand_new_with_seed(2);
    for (int32_t round = 0; round < 500; round++) {
        double rows[2 * CONTACTS][COORDINATES], v[COORDINATES];
        double w[4 * CONTACTS * CONTACTS] = {0}, u[2 * CONTACTS] = {0}, p[2 * CONTACTS];
        double friction[CONTACTS], restitution[CONTACTS] = {0};
        for (int32_t i = 0; i < 2 * CONTACTS; i++) {
            const int32_t twin = i % 4 < 2 ? -1 : i - 2;
            const double apart = pow(10, -g_rand_double_range(random, 6, 10));
            for (int32_t c = 0; c < COORDINATES; c++)
                rows[i][c] =
                    (twin < 0 ? 0 : rows[twin][c]) + (twin < 0 ? 1 : apart) * g_rand_double_range(random, -1, 1);
            friction[i / 2] = 0.1 * (1 + round % 8);
        }
        for (int32_t c = 0; c < COORDINATES; c++)
            v[c] = g_rand_double_range(random, -1, 1);
        for (int32_t i = 0; i < 2 * CONTACTS; i++)
            for (int32_t c = 0; c < COORDINATES; c++) {
                u[i] += rows[i][c] * v[c];
                for (int32_t j = 0; j < 2 * CONTACTS; j++)
                    w[i * 2 * CONTACTS + j] += rows[i][c] * rows[j][c];
            }
        const TinkerImpact impact = {CONTACTS, w, u, restitution, friction};
        g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
        assert_laws(CONTACTS, w, u, friction, p);
    }
}

/* A body that stands on two corners at the foot of a wall, which one of them touches: the wall and the friction on the
 * floor may share what pushes it sideways, and the friction at the wall goes by its share. Something strikes it from
 * above, where it stands or beside that. What comes of it does not hang on rounding, of the speeds before nor of those
 * of others that slide along by themselves. */
static void test_corner(void)
{
    enum { CONTACTS = 5, COORDINATES = 7, WIDTH = 2 * CONTACTS };
    g_autoptr(GRand) random = g_rand_new_with_seed(7);
    for (int32_t round = 0; round < 300; round++) {
        const double a = g_rand_double_range(random, 0.1, 0.6), b = g_rand_double_range(random, 0.1, 0.6),
                     h = g_rand_double_range(random, 0.1, 0.6), top = g_rand_double_range(random, 0, 0.6),
                     s = g_rand_double_range(random, -1.5 * a, b), mu = g_rand_double_range(random, 0.05, 0.8);
        const double rows[WIDTH][COORDINATES] = {
            {0, 1, -a}, {1, 0, h},         {0, 1, b},           {1, 0, h},          {-1, 0, -h},
            {0, 1, b},  {0, -1, -s, 0, 1}, {-1, 0, -top, 1, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 0, 1}};
        const double inverse[COORDINATES] = {1, 1, 1 / g_rand_double_range(random, 0.02, 0.2), 0.4, 0.4, 1, 1};
        const double v[COORDINATES] = {0, 0, 0, g_rand_double_range(random, -1, 1), -4, 0, 3};
        double w[WIDTH * WIDTH] = {0}, friction[CONTACTS], restitution[CONTACTS] = {0}, first[WIDTH];
        for (int32_t i = 0; i < WIDTH; i++)
            for (int32_t j = 0; j < WIDTH; j++)
                for (int32_t c = 0; c < COORDINATES; c++)
                    w[i * WIDTH + j] += rows[i][c] * rows[j][c] * inverse[c];
        for (int32_t k = 0; k < CONTACTS; k++)
            friction[k] = mu;
        for (int32_t noise = 0; noise < 12; noise++) {
            double u[WIDTH], p[WIDTH];
            for (int32_t i = 0; i < WIDTH; i++) {
                u[i] = noise * g_rand_double_range(random, -1e-17, 1e-17);
                for (int32_t c = 0; c < COORDINATES; c++)
                    u[i] += rows[i][c] * v[c];
            }
            const TinkerImpact impact = {CONTACTS, w, u, restitution, friction};
            g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
            assert_laws(CONTACTS, w, u, friction, p);
            for (int32_t i = 0; i < WIDTH; i++) {
                for (int32_t j = 0; j < WIDTH; j++)
                    u[i] += w[i * WIDTH + j] * p[j];
                if (noise == 0) first[i] = u[i];
                g_assert_cmpfloat_with_epsilon(u[i], first[i], 1e-9);
            }
        }
    }
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
    g_test_add_func("/contact-laws/impact/wedge", test_wedge);
    g_test_add_func("/contact-laws/impact/pivot", test_pivot);
    g_test_add_func("/contact-laws/impact/twins", test_twins);
    g_test_add_func("/contact-laws/impact/corner", test_corner);
    return g_test_run();
}

/* Contacts that are tied together: many on one tangle of bodies, and chains on floors. */
#include <float.h>
#include <math.h>

#include "contact-law-checks.h"

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
        g_assert_cmpint(contact_laws_of_modes(&bodies, dynamic, modes, f), ==, TINKER_CONTACT_SOLVED);
        contact_laws_of_impact(&bodies, least, f);
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
        g_assert_cmpfloat(contact_laws_energy_gained(&bodies, p), <=, 1e-9);
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

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/contact-laws/many", test_many);
    g_test_add_func("/contact-laws/impact/resting-chain", test_resting_chain);
    g_test_add_func("/contact-laws/chains", test_chains);
    return g_test_run();
}

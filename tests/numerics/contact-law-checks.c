#include "contact-law-checks.h"

#include <math.h>

void contact_laws_of_impact(const ContactCase *bodies, const double *least, double *p)
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

double contact_laws_energy_gained(const ContactCase *bodies, const double *p)
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

TinkerContactResult contact_laws_of_modes(const ContactCase *bodies, const double *dynamic, TinkerContactMode *modes,
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

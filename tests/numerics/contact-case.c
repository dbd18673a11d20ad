#include "contact-case.h"

#include <math.h>
#include <string.h>

void contact_case_fill(ContactCase *self, GRand *random, int32_t count, int32_t freedoms, gboolean whole, double spread)
{
    double jacobian[CASE_WIDTH][CASE_WIDTH], inverse_mass[CASE_WIDTH], velocity[CASE_WIDTH];
    int32_t width = 2 * count;
    memset(self, 0, sizeof *self);
    self->count = count;
    for (int32_t k = 0; k < freedoms; k++) {
        inverse_mass[k] = whole ? 1 : pow(10, g_rand_double_range(random, -0.5, 0.5) * spread);
        velocity[k] = whole ? g_rand_int_range(random, -2, 3) : g_rand_double_range(random, -1, 1);
    }
    for (int32_t i = 0; i < width; i++)
        for (int32_t k = 0; k < freedoms; k++) {
            jacobian[i][k] = whole ? g_rand_int_range(random, -1, 2) : g_rand_double_range(random, -1, 1);
            self->before[i] += jacobian[i][k] * velocity[k];
        }
    for (int32_t i = 0; i < width; i++)
        for (int32_t j = 0; j < width; j++)
            for (int32_t k = 0; k < freedoms; k++)
                self->delassus[i * width + j] += jacobian[i][k] * inverse_mass[k] * jacobian[j][k];
}

void contact_case_after(const ContactCase *self, const double *p, double *after, double *rounding)
{
    int32_t width = 2 * self->count;
    double fastest = 0;
    for (int32_t i = 0; i < width; i++)
        fastest = MAX(fastest, fabs(self->before[i]));
    for (int32_t i = 0; i < width; i++) {
        long double sum = self->before[i], size = fabsl(sum);
        for (int32_t j = 0; j < width; j++) {
            sum += (long double)self->delassus[i * width + j] * p[j];
            size += fabsl((long double)self->delassus[i * width + j] * p[j]);
        }
        after[i] = (double)sum;
        rounding[i] = 1e-13 * (double)size + 1e-15 * (1 + fastest);
    }
}

gboolean contact_case_eliminate(int32_t n, long double a[CASE_WIDTH][CASE_WIDTH + 1])
{
    for (int32_t k = 0; k < n; k++) {
        int32_t best = k;
        for (int32_t i = k + 1; i < n; i++)
            if (fabsl(a[i][k]) > fabsl(a[best][k])) best = i;
        if (fabsl(a[best][k]) < 1e-12L) return FALSE;
        for (int32_t j = 0; j <= n; j++) {
            long double kept = a[k][j];
            a[k][j] = a[best][j];
            a[best][j] = kept;
        }
        for (int32_t i = k + 1; i < n; i++)
            for (int32_t j = n; j >= k; j--)
                a[i][j] -= a[i][k] / a[k][k] * a[k][j];
    }
    for (int32_t k = n - 1; k >= 0; k--) {
        for (int32_t j = k + 1; j < n; j++)
            a[k][n] -= a[k][j] * a[j][n];
        a[k][n] /= a[k][k];
    }
    return TRUE;
}

typedef struct {
    int32_t masses;
    double inverse_mass[CASE_CONTACTS], rods[CASE_CONTACTS][2]; /* directions */
} Chain;

/* x, velocities of the masses, changed as little as the rods ask for. */
static void project(const Chain *chain, double x[CASE_CONTACTS][2])
{
    long double system[CASE_WIDTH][CASE_WIDTH + 1] = {{0}};
    int32_t count = chain->masses - 1;
    for (int32_t i = 0; i < count; i++) {
        const double *rod = chain->rods[i], *last = i > 0 ? chain->rods[i - 1] : rod;
        double between = i > 0 ? -chain->inverse_mass[i] * (rod[0] * last[0] + rod[1] * last[1]) : 0;
        system[i][i] = chain->inverse_mass[i] + chain->inverse_mass[i + 1];
        if (i > 0) system[i][i - 1] = system[i - 1][i] = between;
        system[i][count] = rod[0] * (x[i + 1][0] - x[i][0]) + rod[1] * (x[i + 1][1] - x[i][1]);
    }
    g_assert_true(contact_case_eliminate(count, system));
    for (int32_t i = 0; i < count; i++)
        for (int32_t k = 0; k < 2; k++) {
            x[i][k] += chain->inverse_mass[i] * chain->rods[i][k] * (double)system[i][count];
            x[i + 1][k] -= chain->inverse_mass[i + 1] * chain->rods[i][k] * (double)system[i][count];
        }
}

static void fill_chain(Chain *chain, GRand *random)
{
    double last = 0, spread = g_rand_int_range(random, 0, 4);
    gboolean level = g_rand_boolean(random);
    chain->masses = g_rand_int_range(random, 1, 9);
    for (int32_t i = 0; i < chain->masses; i++) {
        int32_t kind = level ? 0 : g_rand_int_range(random, 0, 5);
        double angle = kind == 0   ? 0
                       : kind == 1 ? G_PI / 2
                       : kind == 2 ? G_PI / 6
                       : kind == 3 ? last + g_rand_double_range(random, -1e-5, 1e-5)
                                   : g_rand_double_range(random, -G_PI, G_PI);
        chain->inverse_mass[i] = pow(10, g_rand_double_range(random, -0.5, 0.5) * spread);
        chain->rods[i][0] = kind == 1 ? 0 : cos(angle);
        chain->rods[i][1] = sin(angle);
        last = angle;
    }
}

void contact_case_fill_chain(ContactCase *self, GRand *random, double noise)
{
    Chain chain;
    int32_t mass[CASE_CONTACTS] = {0}, width;
    double direction[CASE_WIDTH][2], velocity[CASE_CONTACTS][2];
    double slope = g_rand_boolean(random) ? 0 : g_rand_double_range(random, -1, 1);
    memset(self, 0, sizeof *self);
    fill_chain(&chain, random);
    for (int32_t i = 0; i < chain.masses; i++) {
        for (int32_t wall = 0; wall < 2; wall++) {
            if (self->count == CASE_CONTACTS || g_rand_int_range(random, 0, 8) >= (wall ? 1 : 6)) continue;
            double angle = wall ? slope - 1.5 : slope, n[2] = {-sin(angle), cos(angle)};
            memcpy(direction[2 * self->count], n, sizeof n);
            direction[2 * self->count + 1][0] = n[1];
            direction[2 * self->count + 1][1] = -n[0];
            mass[self->count++] = i;
        }
        for (int32_t k = 0; k < 2; k++)
            velocity[i][k] = g_rand_double_range(random, -1, 1);
    }
    width = 2 * self->count;
    for (int32_t j = 0; j < width; j++) {
        double x[CASE_CONTACTS][2] = {{0}};
        for (int32_t k = 0; k < 2; k++)
            x[mass[j / 2]][k] = chain.inverse_mass[mass[j / 2]] * direction[j][k];
        project(&chain, x);
        for (int32_t i = 0; i < width; i++)
            self->delassus[i * width + j] = direction[i][0] * x[mass[i / 2]][0] + direction[i][1] * x[mass[i / 2]][1];
    }
    project(&chain, velocity);
    gboolean blow = g_rand_boolean(random) && width > 0;
    int32_t at = blow ? 2 * g_rand_int_range(random, 0, self->count) : 0;
    for (int32_t i = 0; i < width; i++)
        self->before[i] =
            (blow ? -self->delassus[i * width + at]
                  : direction[i][0] * velocity[mass[i / 2]][0] + direction[i][1] * velocity[mass[i / 2]][1]) +
            noise * g_rand_double_range(random, -1, 1);
}

enum { OPEN, STICK, PLUS, MINUS };

/* p_t / p_n where contact k moves along +t or -t, or slides already. */
static double ratio(const ContactCase *self, int32_t k, int32_t state)
{
    if (self->sliding[k] != 0) return -self->friction[k] * self->sliding[k];
    return state == PLUS ? -self->friction[k] : self->friction[k];
}

static gboolean keeps_laws(const ContactCase *self, const int32_t *state, const double *p)
{
    double after[CASE_WIDTH], rounding[CASE_WIDTH];
    contact_case_after(self, p, after, rounding);
    for (int32_t k = 0; k < self->count; k++) {
        double v_n = after[2 * k], v_t = after[2 * k + 1], slack = 10 * rounding[2 * k + 1];
        if (p[2 * k] < -1e-11 || v_n < -10 * rounding[2 * k]) return FALSE;
        if (state[k] == STICK && fabs(p[2 * k + 1]) > self->friction[k] * p[2 * k] + 1e-11) return FALSE;
        if (self->sliding[k] != 0) continue;
        if ((state[k] == PLUS && v_t < -slack) || (state[k] == MINUS && v_t > slack)) return FALSE;
    }
    return TRUE;
}

static gboolean solve_states(const ContactCase *self, const int32_t *state, double *p)
{
    int32_t width = 2 * self->count, unknown[CASE_WIDTH], count = 0;
    long double system[CASE_WIDTH][CASE_WIDTH + 1];
    for (int32_t k = 0; k < self->count; k++) {
        if (state[k] != OPEN) unknown[count++] = 2 * k;
        if (state[k] == STICK) unknown[count++] = 2 * k + 1;
    }
    for (int32_t i = 0; i < count; i++) {
        const double *row = self->delassus + unknown[i] * width;
        for (int32_t j = 0; j < count; j++) {
            int32_t column = unknown[j], k = column / 2;
            system[i][j] = row[column];
            if (state[k] != STICK) system[i][j] += (long double)ratio(self, k, state[k]) * row[column + 1];
        }
        system[i][count] = -(long double)self->before[unknown[i]];
    }
    if (!contact_case_eliminate(count, system)) return FALSE;
    memset(p, 0, (size_t)width * sizeof *p);
    for (int32_t i = 0; i < count; i++)
        p[unknown[i]] = (double)system[i][count];
    for (int32_t k = 0; k < self->count; k++)
        if (state[k] == PLUS || state[k] == MINUS) p[2 * k + 1] = ratio(self, k, state[k]) * p[2 * k];
    return TRUE;
}

gboolean contact_case_has_solution(const ContactCase *self)
{
    for (int32_t code = 0; code < 1 << 2 * self->count; code++) {
        int32_t state[CASE_CONTACTS] = {OPEN};
        gboolean fits = TRUE;
        double p[CASE_WIDTH];
        for (int32_t k = 0; k < self->count; k++) {
            state[k] = code >> 2 * k & 3;
            fits = fits && !(self->sliding[k] != 0 && (state[k] == STICK || state[k] == MINUS));
        }
        if (fits && solve_states(self, state, p) && keeps_laws(self, state, p)) return TRUE;
    }
    return FALSE;
}

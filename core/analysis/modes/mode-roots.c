/* The quadratic eigenvalue problem s^2 y + s C y + L y = 0, with L diagonal, as a state space.
 *
 * With W = |L|^1/2 and z = (W y, y') it is z' = [0 W; -sign(L) W, -C] z, whose two halves are of one size; coordinates
 * of rigid motions, W = 0, drop out of the first half. Following forces, which have no such form, take z = (y, y'). The
 * roots are then sharpened with Rayleigh's functional, y^T (s^2 + s C + L) y = 0, whose error is the square of the
 * shape's. */
#include "analysis/modes/mode-roots-private.h"

#include <math.h>

#include "numerics/solve/lapack.h"

/* Roots this small beside the largest are rigid motions'. */
#define LEAST_ROOT 1e-12
/* A decay this small beside the strongest damping is rounding of it. */
#define LEAST_DECAY 1e-13
/* And so is one beside the largest root, where no root is sharpened: forces follow, or damping is not symmetric, as
 * that of a force across the velocity. */
#define LEAST_DECAY_OF_ROOTS 2e-14

/* Damping that couples two modes by less than this beside their own, or by mere rounding of the greater, does not. */
#define COUPLED  1e-12
#define ROUNDING 1e-15

static gboolean couples(const TinkerModalBasis *basis, int32_t i, int32_t k)
{
    gsize m = (gsize)basis->count, at = (gsize)i + m * (gsize)k;
    if (basis->following != NULL) return TRUE;
    if (basis->damping == NULL) return FALSE;
    double a = fabs(basis->damping[(gsize)i * (m + 1)]), b = fabs(basis->damping[(gsize)k * (m + 1)]);
    return fabs(basis->damping[at]) > COUPLED * sqrt(a) * sqrt(b) + ROUNDING * fmax(a, b);
}

/* The members of the group that `seed` belongs to, none of which was taken; marks them. */
static int32_t collect_group(const TinkerModalBasis *basis, int32_t seed, gboolean *taken, int32_t *members)
{
    int32_t count = 1;
    members[0] = seed;
    taken[seed] = TRUE;
    for (int32_t next = 0; next < count; next++)
        for (int32_t k = 0; k < basis->count; k++) {
            if (taken[k] || !couples(basis, members[next], k)) continue;
            taken[k] = TRUE;
            members[count++] = k;
        }
    return count;
}

GArray *tinker_mode_groups(const TinkerModalBasis *basis, int32_t *order)
{
    GArray *groups = g_array_new(FALSE, FALSE, sizeof(int32_t));
    g_autofree gboolean *taken = g_new0(gboolean, MAX(basis->count, 1));
    int32_t placed = 0;
    for (int32_t seed = 0; seed < basis->count; seed++) {
        if (taken[seed]) continue;
        int32_t count = collect_group(basis, seed, taken, order + placed);
        g_array_append_val(groups, count);
        placed += count;
    }
    return groups;
}

static double square_of(const TinkerModeGroup *group, int32_t i)
{
    return group->basis->squares[group->members[i]];
}

static double entry_of(const TinkerModeGroup *group, const double *matrix, int32_t r, int32_t c)
{
    gsize m = (gsize)group->basis->count;
    return matrix == NULL ? 0 : matrix[(gsize)group->members[r] + m * (gsize)group->members[c]];
}

static gboolean has_place(const TinkerModeGroup *group, int32_t i)
{
    return group->basis->following != NULL || square_of(group, i) != 0;
}

double *tinker_mode_state_matrix(const TinkerModeGroup *group, int32_t *order)
{
    gboolean plain = group->basis->following != NULL;
    int32_t places = 0, p = group->count;
    for (int32_t i = 0; i < p; i++)
        places += has_place(group, i);
    gsize n = (gsize)(places + p), velocity = (gsize)places, place = 0;
    double *a = g_new0(double, n *n);
    for (int32_t i = 0; i < p; i++, velocity++) {
        double square = square_of(group, i), w = plain ? 1 : sqrt(fabs(square));
        for (int32_t k = 0; k < p; k++) {
            a[velocity + n * (gsize)(places + k)] -= entry_of(group, group->basis->damping, i, k);
            if (plain) a[velocity + n * (gsize)k] -= entry_of(group, group->basis->following, i, k);
        }
        if (!has_place(group, i)) continue;
        a[place + n * velocity] += w;
        a[velocity + n * place] -= plain ? square : copysign(w, square);
        place++;
    }
    *order = (int32_t)n;
    return a;
}

static double complex sharpen(const TinkerModeGroup *group, double complex s, const double complex *y)
{
    double complex a = 0, b = 0, c = 0;
    double norm = 0;
    if (group->basis->following != NULL) return s;
    for (int32_t i = 0; i < group->count; i++) {
        a += y[i] * y[i];
        c += square_of(group, i) * y[i] * y[i];
        norm += creal(y[i] * conj(y[i]));
        for (int32_t k = 0; k < group->count; k++)
            b += y[i] * entry_of(group, group->basis->damping, i, k) * y[k];
    }
    if (cabs(2 * a * s + b) < 1e-4 * norm * cabs(s)) return s; /* two roots meet: there is nothing to sharpen with */
    double complex root = csqrt(b * b - 4 * a * c), plus = b + root, minus = b - root;
    double complex greater = cabs(plus) > cabs(minus) ? plus : minus;
    double complex first = -greater / (2 * a), second = greater != 0 ? -2 * c / greater : s;
    double complex near = cabs(first - s) < cabs(second - s) ? first : second;
    if (!(cabs(near - s) < 1e-6 * cabs(s))) return s;
    return cimag(s) == 0 ? creal(near) : near;
}

static double strongest_damping(const TinkerModeGroup *group)
{
    double most = 0;
    for (int32_t i = 0; i < group->count; i++)
        most = fmax(most, fabs(entry_of(group, group->basis->damping, i, i)));
    return most;
}

static void root_free(gpointer data)
{
    TinkerModeRoot *root = data;
    g_free(root->shape);
    g_free(root);
}

static gboolean is_symmetric(const TinkerModeGroup *group)
{
    for (int32_t i = 0; i < group->count; i++)
        for (int32_t k = 0; k < i; k++) {
            double there = entry_of(group, group->basis->damping, i, k);
            if (fabs(there - entry_of(group, group->basis->damping, k, i)) > 1e-12 * fabs(there)) return FALSE;
        }
    return TRUE;
}

GPtrArray *tinker_mode_roots(const TinkerModeGroup *group)
{
    int32_t n = 0, p = group->count;
    g_autofree double *a = tinker_mode_state_matrix(group, &n);
    gsize size = (guint)n, first = (guint)(n - p);
    g_autofree double *real = g_new0(double, size), *imaginary = g_new0(double, size),
                      *vectors = g_new0(double, size *size);
    double largest = 0, least_decay = LEAST_DECAY * strongest_damping(group);
    gboolean symmetric = is_symmetric(group);
    for (gsize i = 0; i < size * size; i++)
        if (!isfinite(a[i])) return NULL;
    if (!tinker_eigen_general(n, a, real, imaginary, vectors)) return NULL;
    for (gsize i = 0; i < size; i++)
        largest = fmax(largest, hypot(real[i], imaginary[i]));
    if (group->basis->following != NULL || !symmetric) least_decay = fmax(least_decay, LEAST_DECAY_OF_ROOTS * largest);
    GPtrArray *roots = g_ptr_array_new_with_free_func(root_free);
    for (gsize i = 0; i < size; i++) {
        if (hypot(real[i], imaginary[i]) <= LEAST_ROOT * largest || imaginary[i] < 0) continue;
        TinkerModeRoot *root = g_new0(TinkerModeRoot, 1);
        root->s = CMPLX(real[i], imaginary[i]);
        root->shape = g_new0(double complex, (gsize)p);
        for (gsize k = 0; k < (gsize)p; k++)
            root->shape[k] =
                CMPLX(vectors[first + k + size * i], imaginary[i] > 0 ? vectors[first + k + size * (i + 1)] : 0);
        if (symmetric) root->s = sharpen(group, root->s, root->shape);
        if (cimag(root->s) > 0 && fabs(creal(root->s)) <= least_decay) root->s = CMPLX(0, cimag(root->s));
        g_ptr_array_add(roots, root);
    }
    return roots;
}

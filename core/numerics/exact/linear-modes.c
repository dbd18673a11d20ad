/* Undamped modes: K = L D L^T without a subtraction, then rotations of the columns of M^-1/2 L D^1/2.
 *
 * Eliminating one coordinate of a graph of springs leaves a graph of springs: its neighbours i, j get w_i w_j / d
 * more stiffness between them, d being all the stiffness at the coordinate. Written for the stiffnesses themselves
 * nothing is ever subtracted, so every entry of the factor is accurate to rounding, and parts that nothing holds
 * end with d = 0 exactly. The largest d / m goes first; then the columns are well-conditioned but for their
 * lengths, and one-sided Jacobi rotations find every singular value to rounding of its own size. The rotated
 * columns are the modes.
 */
#include "numerics/exact/linear-modes.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include <tinker/types.h>

#define MOST_SWEEPS 60

gsize tinker_linear_modes_work(int32_t n)
{
    gsize size = (gsize)n;
    return size * size + 2 * size;
}

/* The coordinate with the largest d / m among those left (marked by a pivot of 0), and its d; -1 where none has
 * any. */
static int32_t stiffest(int32_t n, const double *mass, const double *weights, const double *ground, const double *taken,
                        double *stiffness)
{
    int32_t best = -1;
    double most = 0.0;
    for (int32_t i = 0; i < n; i++) {
        if (taken[i] != 0.0) continue;
        double sum = ground[i];
        for (int32_t j = 0; j < n; j++)
            if (j != i && taken[j] == 0.0) sum += weights[(gsize)i * n + j];
        if (sum / mass[i] <= most) continue;
        most = sum / mass[i];
        *stiffness = sum;
        best = i;
    }
    return best;
}

/* Takes coordinate i out, and writes its column of M^-1/2 L D^1/2. */
static void eliminate(int32_t n, int32_t i, double stiffness, const double *mass, double *weights, double *ground,
                      const double *taken, double *column)
{
    const double *row = weights + (gsize)i * n;
    double root = sqrt(stiffness);
    for (int32_t j = 0; j < n; j++) {
        if (taken[j] != 0.0 || j == i || row[j] == 0.0) continue;
        double part = row[j] / stiffness;
        column[j] = -(row[j] / root) / sqrt(mass[j]);
        ground[j] += part * ground[i];
        for (int32_t k = 0; k < n; k++)
            if (k != j && k != i && taken[k] == 0.0) weights[(gsize)j * n + k] += part * row[k];
    }
    column[i] = root / sqrt(mass[i]);
}

/* The number of columns. */
static int32_t factorise(int32_t n, const double *mass, double *weights, double *ground, double *taken, double *columns)
{
    memset(taken, 0, (gsize)n * sizeof *taken);
    memset(columns, 0, (gsize)n * n * sizeof *columns);
    for (int32_t rank = 0; rank < n; rank++) {
        double stiffness = 0.0;
        int32_t i = stiffest(n, mass, weights, ground, taken, &stiffness);
        if (i < 0) return rank;
        eliminate(n, i, stiffness, mass, weights, ground, taken, columns + (gsize)rank * n);
        taken[i] = 1.0;
    }
    return n;
}

static double dot(int32_t n, const double *restrict a, const double *restrict b)
{
    double sum[4] = {0.0};
    int32_t i = 0;
    for (; i + 4 <= n; i += 4)
        for (int s = 0; s < 4; s++)
            sum[s] += a[i + s] * b[i + s];
    for (; i < n; i++)
        sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static void turn(int32_t n, double cosine, double sine, double *restrict a, double *restrict b)
{
    for (int32_t i = 0; i < n; i++) {
        double left = a[i], right = b[i];
        a[i] = cosine * left - sine * right;
        b[i] = sine * left + cosine * right;
    }
}

/* Turns every pair of columns once until they are orthogonal; how many had to be. `square` holds |column|^2. */
TINKER_VARIANTS
static int32_t sweep(int32_t n, int32_t rank, double *columns, double *square)
{
    int32_t turned = 0;
    double tolerance = sqrt((double)n) * DBL_EPSILON;
    for (int32_t p = 0; p < rank; p++)
        square[p] = dot(n, columns + (gsize)p * n, columns + (gsize)p * n);
    for (int32_t p = 0; p + 1 < rank; p++) {
        for (int32_t q = p + 1; q < rank; q++) {
            double *a = columns + (gsize)p * n, *b = columns + (gsize)q * n;
            double product = dot(n, a, b);
            if (!(fabs(product) > tolerance * sqrt(square[p]) * sqrt(square[q]))) continue;
            double zeta = (square[q] - square[p]) / (2.0 * product);
            double tangent = copysign(1.0, zeta) / (fabs(zeta) + sqrt(1.0 + zeta * zeta));
            double cosine = 1.0 / sqrt(1.0 + tangent * tangent);
            turn(n, cosine, cosine * tangent, a, b);
            square[p] = dot(n, a, a);
            square[q] = dot(n, b, b);
            turned++;
        }
    }
    return turned;
}

/* Gives every coordinate the smallest number among those that springs join it with. */
static void join(int32_t n, const double *weights, double *part)
{
    for (int32_t i = 0; i < n; i++)
        part[i] = i;
    for (gboolean changed = TRUE; changed;) {
        changed = FALSE;
        for (int32_t i = 0; i < n; i++) {
            for (int32_t j = 0; j < n; j++) {
                if (i == j || weights[(gsize)i * n + j] == 0.0 || part[j] >= part[i]) continue;
                part[i] = part[j];
                changed = TRUE;
            }
        }
    }
}

/* A part that springs hold among themselves alone moves as one: its mode is known, and exactly the same everywhere
 * on it. */
static int32_t write_rigid_modes(int32_t n, int32_t first, const double *mass, const double *part, const double *held,
                                 double *omega, double *shape)
{
    int32_t mode = first;
    for (int32_t root = 0; root < n && mode < n; root++) {
        if (part[root] != root || held[root] != 0.0) continue;
        double total = 0.0;
        for (int32_t i = 0; i < n; i++)
            if (part[i] == root) total += mass[i];
        for (int32_t i = 0; i < n; i++)
            shape[(gsize)i * n + mode] = part[i] == root ? 1.0 / sqrt(total) : 0.0;
        omega[mode++] = 0.0;
    }
    return mode;
}

gboolean tinker_linear_modes(int32_t n, const double *mass, double *weights, double *ground, double *omega,
                             double *shape, double *work)
{
    double *columns = work, *part = work + (gsize)n * n, *held = part + n;
    join(n, weights, part);
    memset(held, 0, (gsize)n * sizeof *held);
    for (int32_t i = 0; i < n; i++)
        if (ground[i] != 0.0) held[(int32_t)part[i]] = 1.0;
    int32_t rank = factorise(n, mass, weights, ground, omega, columns);
    if (write_rigid_modes(n, rank, mass, part, held, omega, shape) != n) return FALSE;

    double *square = part;
    int32_t sweeps = 0;
    while (sweep(n, rank, columns, square) > 0)
        if (++sweeps == MOST_SWEEPS) return FALSE;
    for (int32_t j = 0; j < rank; j++) {
        omega[j] = sqrt(square[j]);
        for (int32_t i = 0; i < n; i++)
            shape[(gsize)i * n + j] = columns[(gsize)j * n + i] / omega[j] / sqrt(mass[i]);
    }
    return TRUE;
}

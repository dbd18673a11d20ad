#include "numerics/solve/least-norm.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

/* Room that LAPACK wants for its blocks. */
#define BLOCK 64

/* The room: what the reflections of Q and of Z are scaled by, then what LAPACK works in. */
static double *scales_of_z(int32_t n, double *room)
{
    return room + n;
}

static double *working_room(int32_t n, double *room)
{
    return room + 2 * n;
}

static int32_t working_size(int32_t n)
{
    return 2 * n + BLOCK * (n + 2);
}

int32_t tinker_least_norm_room(int32_t n)
{
    return 2 * n + working_size(n);
}

/* A singular value of a triangle, estimated, and the left vector x of norm 1 that attains it: |x^T R| = value. */
typedef struct {
    double value, *x;
} Estimate;

/* What a further column, w over the corner g, makes of an estimate. The vector is (s x, c) then, s^2 + c^2 = 1; with
 * alpha = x . w
 *
 *     value^2 = (s value)^2 + (s alpha + c g)^2,
 *
 * a form of s and c with the determinant (value g)^2, of which `largest` asks for the larger extreme, else the other.
 */
static double grow(const Estimate *estimate, int32_t count, const double *column, gboolean largest, double *s,
                   double *c)
{
    double alpha = 0, corner = column[count], value = estimate->value;
    for (int32_t i = 0; i < count; i++)
        alpha += estimate->x[i] * column[i];
    const double scale = fmax(value, fmax(fabs(alpha), fabs(corner)));
    *s = largest ? 1 : 0;
    *c = largest ? 0 : 1;
    if (!(scale > 0)) return 0;
    alpha /= scale;
    corner /= scale;
    value /= scale;
    const double before = value * value + alpha * alpha, own = corner * corner, both = alpha * corner;
    const double root = hypot(before - own, 2 * both), most = 0.5 * (before + own + root);
    double along = most - own, across = both; /* the vector of the larger extreme, up to its length */
    if (most - before > along) {
        along = both;
        across = most - before;
    }
    const double length = hypot(along, across), greatest = sqrt(most);
    if (length > 0) {
        *s = (largest ? along : -across) / length;
        *c = (largest ? across : along) / length;
    }
    return scale * (largest ? greatest : value * fabs(corner) / greatest);
}

static void take(Estimate *estimate, int32_t count, double value, double s, double c)
{
    for (int32_t i = 0; i < count; i++)
        estimate->x[i] *= s;
    estimate->x[count] = c;
    estimate->value = value;
}

/* How many columns of the upper triangle of a matrix are not dependent; all of what is not a number, which the solution
 * is not either then. `room`: 2n. */
static int32_t rank_of(int32_t n, const double *matrix, double dependent, double *room)
{
    Estimate most = {fabs(matrix[0]), room}, least = {fabs(matrix[0]), room + n};
    if (isnan(most.value)) return n;
    if (!(most.value > 0)) return 0;
    most.x[0] = least.x[0] = 1;
    for (int32_t rank = 1; rank < n; rank++) {
        const double *column = matrix + (gsize)rank * (gsize)n;
        double s[2], c[2];
        const double larger = grow(&most, rank, column, TRUE, &s[0], &c[0]),
                     smaller = grow(&least, rank, column, FALSE, &s[1], &c[1]);
        if (!(larger * dependent <= smaller)) return rank;
        take(&most, rank, larger, s[0], c[0]);
        take(&least, rank, smaller, s[1], c[1]);
    }
    return n;
}

int32_t tinker_least_norm_factor(int32_t n, double *matrix, double dependent, int32_t *order, double *room)
{
    double *work = working_room(n, room);
    if (n == 0) return 0;
    memset(order, 0, (gsize)n * sizeof(int32_t));
    LAPACKE_dgeqp3_work(LAPACK_COL_MAJOR, n, n, matrix, n, order, room, work, working_size(n));
    const int32_t rank = rank_of(n, matrix, dependent, work);
    if (rank > 0 && rank < n)
        LAPACKE_dtzrzf_work(LAPACK_COL_MAJOR, rank, n, matrix, n, scales_of_z(n, room), work, working_size(n));
    return rank;
}

/* T y = b, of the upper triangle. */
static void substitute(int32_t n, int32_t rank, const double *factor, double *b)
{
    for (int32_t j = rank; j-- > 0;) {
        const double *column = factor + (gsize)j * (gsize)n;
        b[j] /= column[j];
        for (int32_t i = 0; i < j; i++)
            b[i] -= b[j] * column[i];
    }
}

void tinker_least_norm_solve(int32_t n, int32_t rank, const double *factor, const int32_t *order, double *room,
                             double *b)
{
    double *work = working_room(n, room);
    if (rank > 0)
        LAPACKE_dormqr_work(LAPACK_COL_MAJOR, 'L', 'T', n, 1, n, factor, n, room, b, n, work, working_size(n));
    substitute(n, rank, factor, b);
    memset(b + rank, 0, (gsize)(n - rank) * sizeof(double));
    if (rank > 0 && rank < n)
        LAPACKE_dormrz_work(LAPACK_COL_MAJOR, 'L', 'T', n, 1, rank, n - rank, factor, n, scales_of_z(n, room), b, n,
                            work, working_size(n));
    for (int32_t i = 0; i < n; i++)
        work[order[i] - 1] = b[i];
    memcpy(b, work, (gsize)n * sizeof(double));
}

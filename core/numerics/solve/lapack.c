#include "numerics/solve/lapack.h"

#include <lapacke.h>
#include <string.h>

G_STATIC_ASSERT(sizeof(lapack_int) == sizeof(int32_t));

/* Takes the place of LAPACKE's own, which tells on standard output, among what the program writes there, and goes on:
 * callers would take the want of memory for numbers that leave their range. */
__attribute__((visibility("default"))) void LAPACKE_xerbla(const char *name, lapack_int info);
void LAPACKE_xerbla(const char *name, lapack_int info)
{
    if (info == LAPACK_WORK_MEMORY_ERROR || info == LAPACK_TRANSPOSE_MEMORY_ERROR)
        g_error("failed to allocate the work array of %s", name);
    g_critical("%s: argument %d is wrong", name, -(int)info);
}

gboolean tinker_eigen_symmetric(int32_t n, double *matrix, double *values)
{
    return n == 0 || LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', n, matrix, n, values) == 0;
}

gboolean tinker_eigen_symmetric_large(int32_t n, double *matrix, double *values)
{
    return n == 0 || LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', n, matrix, n, values) == 0;
}

gboolean tinker_eigen_tridiagonal(int32_t n, double *diagonal, double *beside, double *vectors)
{
    return LAPACKE_dstev(LAPACK_COL_MAJOR, 'V', n, diagonal, beside, vectors, n) == 0;
}

gboolean tinker_eigen_general(int32_t n, double *matrix, double *re, double *im, double *vectors)
{
    return n == 0 || LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', vectors != NULL ? 'V' : 'N', n, matrix, n, re, im, NULL, 1,
                                   vectors, vectors != NULL ? n : 1) == 0;
}

gboolean tinker_singular_values(int32_t rows, int32_t n, double *matrix, double *values, double *right, double *scale)
{
    double unused, stat[7] = {1, 1};
    lapack_int istat[3] = {0};
    if (LAPACKE_dgejsv(LAPACK_COL_MAJOR, 'F', 'N', 'V', 'R', 'N', 'N', rows, n, matrix, rows, values, &unused, 1, right,
                       n, stat, istat) != 0)
        return FALSE;
    *scale = stat[0] / stat[1];
    return TRUE;
}

gboolean tinker_hessenberg(int32_t n, double *matrix, double *q)
{
    g_autofree double *tau = g_new0(double, MAX(n, 1));
    if (LAPACKE_dgehrd(LAPACK_COL_MAJOR, n, 1, n, matrix, n, tau) != 0) return FALSE;
    memcpy(q, matrix, (gsize)n * (gsize)n * sizeof(double));
    return LAPACKE_dorghr(LAPACK_COL_MAJOR, n, 1, n, q, n, tau) == 0;
}

gboolean tinker_pivoted_qr(int32_t n, int32_t columns, double *matrix, double *q, int32_t *pivot)
{
    const int32_t least = MIN(n, columns);
    g_autofree double *tau = g_new0(double, MAX(least, 1));
    memset(pivot, 0, (gsize)columns * sizeof(int32_t));
    if (LAPACKE_dgeqp3(LAPACK_COL_MAJOR, n, columns, matrix, n, pivot, tau) != 0) return FALSE;
    for (int32_t column = 0; column < columns; column++)
        pivot[column]--;
    memcpy(q, matrix, sizeof(double) * (gsize)n * (gsize)least);
    return LAPACKE_dorgqr(LAPACK_COL_MAJOR, n, n, least, q, n, tau) == 0;
}

gboolean tinker_solve_complex(int32_t n, double complex *matrix, double complex *b, int32_t *pivot)
{
    return LAPACKE_zgesv(LAPACK_COL_MAJOR, n, 1, matrix, n, pivot, b, n) == 0;
}

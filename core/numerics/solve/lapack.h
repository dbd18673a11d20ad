/* The routines of LAPACK that are used, under the names of what they do. Matrices lie column by column, and are lost
 * unless it says otherwise. Answers are FALSE where an iteration fails; hand in finite numbers alone. Want of memory
 * ends the program with words. Source: Anderson et al., LAPACK Users' Guide, SIAM 1999. */
#ifndef TINKER_NUMERICS_LAPACK_H
#define TINKER_NUMERICS_LAPACK_H

#include <complex.h>

#include <glib.h>

/* Of a symmetric matrix (its upper triangle) of order n: values ascending, and in place of the matrix its vectors of
 * length 1. By QL; many vectors come sooner by divide and conquer, from the lower triangle. */
gboolean tinker_eigen_symmetric(int32_t n, double *matrix, double *values);
gboolean tinker_eigen_symmetric_large(int32_t n, double *matrix, double *values);

/* Of a symmetric tridiagonal matrix: values ascending in place of the diagonal; vectors n by n. */
gboolean tinker_eigen_tridiagonal(int32_t n, double *diagonal, double *beside, double *vectors);

/* Of any real matrix of order n, balanced first, so that states of very different size do no harm; conjugate pairs
 * stand side by side. `vectors` (n by n; of a pair its real and its imaginary part) may be NULL. */
gboolean tinker_eigen_general(int32_t n, double *matrix, double *re, double *im, double *vectors);

/* Singular values of a matrix of rows >= n by rotations, each to its own digits, and the right vectors (n by n). The
 * true values are `*scale` times those. */
gboolean tinker_singular_values(int32_t rows, int32_t n, double *matrix, double *values, double *right, double *scale);

/* matrix = Q H Q^T with H zero below the first diagonal under the main one; H in place of the matrix (what is left
 * below it is not to be used), Q into `q`. */
gboolean tinker_hessenberg(int32_t n, double *matrix, double *q);

/* matrix P = Q R with columns in the order of what is left of them; `columns` columns of length n. R in the upper
 * triangle of the matrix, Q (n by n) into `q`; `pivot` counts from 0. */
gboolean tinker_pivoted_qr(int32_t n, int32_t columns, double *matrix, double *q, int32_t *pivot);

/* Solves a complex system of order n in place of b; `pivot` is room for n. */
gboolean tinker_solve_complex(int32_t n, double complex *matrix, double complex *b, int32_t *pivot);

#endif

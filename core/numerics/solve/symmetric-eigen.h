/* Eigenvalues of small dense symmetric matrices by Jacobi's rotations.
 *
 * Slower than a tridiagonal method, but graded matrices (a stiffness of 1e12 N/m beside one of 1) keep the relative
 * accuracy of their small eigenvalues. Source: Golub, Van Loan, "Matrix Computations", 4th edition, section 8.5;
 * Demmel, Veselic, "Jacobi's method is more accurate than QR", SIAM J. Matrix Anal. Appl. 13 (1992). */
#ifndef TINKER_CORE_SYMMETRIC_EIGEN_H
#define TINKER_CORE_SYMMETRIC_EIGEN_H

#include <glib.h>

/* Diagonalises the n by n matrix a (column by column; its eigenvalues are left on its diagonal, in no order) by
 * rotations. `vectors` (rows by n, column by column) is multiplied by them from the right: hand in the identity for the
 * eigenvectors themselves. FALSE where it does not converge, which takes a number that is not finite. */
gboolean tinker_symmetric_eigen(int n, double *a, int rows, double *vectors);

#endif

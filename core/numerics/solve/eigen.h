/* The largest eigenvalues of operators of any size (ARPACK, Lanczos). Those of small matrices: lapack.h.
 *
 * Nothing here is used inside a step. Sources: Lehoucq, Sorensen, Yang, ARPACK Users' Guide, SIAM 1998; Golub, Meurant,
 * Matrices, Moments and Quadrature with Applications, Princeton 2010. */
#ifndef TINKER_CORE_EIGEN_H
#define TINKER_CORE_EIGEN_H

#include <glib.h>

/* y = A x. */
typedef void (*TinkerOperator)(void *data, const double *x, double *y);

/* The eigenvalue of a symmetric operator that is largest (algebraically), and its vector of length 1, to a relative
 * `tolerance`; at most about `most_products` products. n > 30. FALSE where it did not converge. */
gboolean tinker_lanczos_largest(int32_t n, TinkerOperator apply, void *data, int32_t most_products, double tolerance,
                                double *value, double *vector);

/* The `wanted` eigenvalues of any operator that are largest in size; a conjugate pair counts as two. Answers how many
 * were found (`wanted` + 1 where a pair would be cut). Room for wanted + 1. n > 30. */
int32_t tinker_arnoldi_largest(int32_t n, int32_t wanted, TinkerOperator apply, void *data, int32_t most_products,
                               double tolerance, double *re, double *im);

/* How a vector is made up of the eigenvectors of a symmetric operator, by at most `steps` products: the nodes and
 * weights (sum: 1) of the Gauss quadrature for its spectral measure. Where n <= steps, nodes are eigenvalues and a
 * weight is the square of the vector's part along them. Extreme eigenvalues that the vector contains come first. With
 * `other`, `forms` becomes x . B x for that operator B and the vector x of each node. Answers the number of nodes,
 * which ascend; 0 for the vector 0 or where an entry is not finite. */
#define TINKER_MOST_NODES 48
typedef struct {
    int32_t count;
    double nodes[TINKER_MOST_NODES], weights[TINKER_MOST_NODES], forms[TINKER_MOST_NODES];
} TinkerSpectralMeasure;
int32_t tinker_spectral_measure(int32_t n, int32_t steps, TinkerOperator apply, TinkerOperator other, void *data,
                                const double *vector, TinkerSpectralMeasure *measure);

#endif

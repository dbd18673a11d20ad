/* What the factors of symmetric and of unsymmetric values share: the order of elimination, and where every update goes.
 */
#ifndef TINKER_CORE_SPARSE_LDL_PRIVATE_H
#define TINKER_CORE_SPARSE_LDL_PRIVATE_H

#include "numerics/solve/sparse-ldl.h"

struct _TinkerSparseLdl {
    int n;
    int border;       /* the last so many are eliminated last, with pivots below 0 */
    int *place;       /* of a row in the order of elimination */
    int *starts;      /* n + 1: column k of L holds rows[starts[k]] to rows[starts[k + 1] - 1] */
    int *rows;        /* in the order of elimination */
    int *updates;     /* slots */
    double *values;   /* n + entries of L */
    double *diagonal; /* 1 / d, n */
    double *work;     /* n */
    double *left_out; /* border x border, see tinker_sparse_ldl_left_out */
    gboolean is_forest;
    int *sequence;      /* of a forest: the row that is eliminated at each place */
    int *parents;       /* of a forest: the row that the row at each place hangs on; itself where it hangs on none */
    int *parent_places; /* and its place */
};

#endif

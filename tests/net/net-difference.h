/* How far two records are apart. */
#ifndef NET_DIFFERENCE_H
#define NET_DIFFERENCE_H

#include <glib.h>

/* The largest difference, and where it is. */
typedef struct {
    double share;    /* of the largest magnitude that it is measured by; NAN: there is none */
    char column[96]; /* with its unit */
    double at;       /* s */
} NetLargest;

typedef struct {
    gboolean comparable;  /* the same columns; rows that only one has are left out */
    NetLargest of_column; /* by the largest magnitude of the column in either */
    NetLargest of_unit; /* by that of all columns of its unit: what is rounding in a column that should be zero is small
                           here */
} NetDifference;

/* Compares what the folder holds under two hashes. FALSE with `error` where it does not. */
gboolean net_difference(const char *store, const char *old_hash, const char *new_hash, NetDifference *difference,
                        GError **error);

#endif

/* Rows that keep a distance, g = L - length, which the host works out itself: nearly all rows there are. */
#ifndef TINKER_CORE_DISTANCE_ROWS_H
#define TINKER_CORE_DISTANCE_ROWS_H

#include <glib.h>
#include <tinker/block.h>

typedef struct {
    int32_t count;
    const int32_t *ends;         /* two points a row */
    const double *length;        /* m */
    const double *inverse_scale; /* 1/m: what |g| is measured by */
} TinkerDistances;

/* Works out the rows: g, four entries of the Jacobian each, and drift, as rows_at of TinkerConstraint; raises *miss to
 * the largest |g| * inverse scale. FALSE: some g or drift is not finite. */
gboolean tinker_distance_rows(const TinkerDistances *rows, const TinkerPoint *points, double *g, double *jacobian,
                              double *drift, double *miss);

#endif

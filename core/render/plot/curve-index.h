/* The least and the greatest of any stretch of a long curve, without a look at all its points: a pyramid of blocks,
 * each of which knows where its extremes are. */
#ifndef TINKER_CORE_CURVE_INDEX_H
#define TINKER_CORE_CURVE_INDEX_H

#include <glib.h>

typedef struct _TinkerCurveIndex TinkerCurveIndex;

/* Of no points. (transfer full) */
TinkerCurveIndex *tinker_curve_index_new(void);
void tinker_curve_index_free(TinkerCurveIndex *index);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerCurveIndex, tinker_curve_index_free)

/* Forgets all points. */
void tinker_curve_index_clear(TinkerCurveIndex *index);

/* Takes over the points from those that it knows up to `count`; the others are as they were. */
void tinker_curve_index_add(TinkerCurveIndex *index, const double *x, const double *y, gsize count);

/* Points that it knows; and whether all of them are finite and x never falls, without which it is of no use. */
gsize tinker_curve_index_count(const TinkerCurveIndex *index);
gboolean tinker_curve_index_is_ordered(const TinkerCurveIndex *index);

/* The first of the least values, and of the greatest, from point `from` on and before point `to`, which is greater. */
void tinker_curve_index_extremes(const TinkerCurveIndex *index, const double *y, gsize from, gsize to, gsize *least,
                                 gsize *greatest);

/* The first point whose x is not below this one; `count` where there is none. */
gsize tinker_curve_first_from(const double *x, gsize count, double from);

#endif

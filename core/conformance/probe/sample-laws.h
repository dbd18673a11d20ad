#ifndef TINKER_CONFORMANCE_SAMPLE_LAWS_H
#define TINKER_CONFORMANCE_SAMPLE_LAWS_H

#include "plugin/catalogue/catalogue.h"

/* What TinkerBatch.laws is for up to a thousand instances of a class, and how many each has; NULL and 0 where nothing
 * is typed into it. Borrowed, for good. */
const struct TinkerTypedLaw *const *kit_sample_laws(const TinkerBlockClass *block_class, int32_t *count);

/* The points that each property with TINKER_TEXT_POINTS has by default, for every instance. Kept for good. */
const TinkerPointList *kit_sample_points(const TinkerBlockClass *block_class, int32_t *count);

#endif

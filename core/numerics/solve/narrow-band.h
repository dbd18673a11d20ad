/* The order of reverse Cuthill and McKee, which brings the entries of a sparse symmetric matrix close to its diagonal.
 *
 * Source: E. Cuthill, J. McKee, Proc. 24th ACM National Conference (1969) 157-172; A. George, J. W. H. Liu, ACM Trans.
 * Math. Software 5 (1979) 284-295, for where to start. */
#ifndef TINKER_NUMERICS_NARROW_BAND_H
#define TINKER_NUMERICS_NARROW_BAND_H

#include <tinker/integrator.h>

/* Writes the place of every row (pattern->size entries) and answers the half bandwidth, the largest distance of an
 * entry from the diagonal. Rows stay where they are unless the band becomes narrower. */
int32_t tinker_narrow_band(const TinkerPattern *pattern, int32_t *place);

#endif

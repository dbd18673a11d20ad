/* The response of a large group of coupled modes: one reduction, then a solve a frequency in the square of its size. */
#ifndef TINKER_ANALYSIS_GROUP_RESPONSE_PRIVATE_H
#define TINKER_ANALYSIS_GROUP_RESPONSE_PRIVATE_H

#include "analysis/modes/mode-roots-private.h"

typedef struct _TinkerGroupResponse TinkerGroupResponse;

/* `load` and `read` over all modes of the basis, as in frequency-response.c. NULL where the reduction fails. (transfer
 * full) */
TinkerGroupResponse *tinker_group_response_new(const TinkerModeGroup *group, double *const load[2],
                                               double *const read[2]);
void tinker_group_response_free(TinkerGroupResponse *response);

/* What the group contributes to H at omega > 0. */
double complex tinker_group_response_at(TinkerGroupResponse *response, double omega);

#endif

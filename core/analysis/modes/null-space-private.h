/* The motions that a model's constraints allow, and those that they ask for. */
#ifndef TINKER_ANALYSIS_NULL_SPACE_PRIVATE_H
#define TINKER_ANALYSIS_NULL_SPACE_PRIVATE_H

#include "numerics/solve/null-space.h"
#include "physics/linearise/linearise.h"

/* Decomposes M^-1/2 J^T. FALSE where that fails. Clear it either way. */
gboolean tinker_null_space_of(const TinkerLinearisation *linear, TinkerNullSpace *space);

#endif

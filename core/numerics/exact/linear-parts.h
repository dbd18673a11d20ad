/* The parts of a linear system that no edge ties together; anchors tie nothing. */
#ifndef TINKER_NUMERICS_LINEAR_PARTS_H
#define TINKER_NUMERICS_LINEAR_PARTS_H

#include <glib.h>
#include <tinker/integrator.h>

typedef struct {
    int32_t count;
    int32_t *part_of;     /* of each coordinate */
    int32_t *local;       /* number of each coordinate within its part */
    int32_t *starts;      /* count + 1: where each part's coordinates begin in `members` */
    int32_t *members;     /* coordinates, part by part, ascending */
    int32_t *edge_starts; /* count + 1 */
    int32_t *edges;       /* edges with at least one coordinate, part by part */
} TinkerLinearParts;

/* (transfer full) */
TinkerLinearParts *tinker_linear_parts_new(const TinkerLinearSystem *system);
void tinker_linear_parts_free(TinkerLinearParts *parts);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerLinearParts, tinker_linear_parts_free)

#endif

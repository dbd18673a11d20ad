/* What the rules about momentum, places and directions share. */
#ifndef TINKER_CONFORMANCE_RULES_SYMMETRY_PRIVATE_H
#define TINKER_CONFORMANCE_RULES_SYMMETRY_PRIVATE_H

#include "conformance/probe/state.h"

/* Whether it acts between things of a scene, and not from outside. A force that follows what it acts on (a jet, held
 * along the line between two ends) looks at several ends, and acts from outside all the same: its category says so. */
gboolean symmetry_is_internal(const TinkerBlockClass *block_class);

/* The function whose answer is looked at; NULL with the reason told. */
const KitFunction *symmetry_function(KitCheck *check, const GArray *functions);

typedef struct {
    gboolean turn; /* else shift */
    double by[2];  /* the shift; or cosine and sine of the turn */
    double angle;
} SymmetryChange;

/* symmetry-change.c: what becomes of places and velocities, of a property, and of an answer. */
void symmetry_change_points(const SymmetryChange *change, TinkerPoint *points, int32_t count);
void symmetry_change_property(KitState *state, int32_t number, const SymmetryChange *change);
/* Forces and Jacobians turn along; numbers stay. */
void symmetry_change_answer(const KitFunction *function, KitAnswer *answer, const SymmetryChange *change);
/* The first two rows of a joint may be the two components of one vector, and then turn along, too: g and drift, and of
 * the Jacobian each number with that of the other row. */
void symmetry_change_joint_rows(const KitFunction *function, const KitState *state, KitAnswer *answer,
                                const SymmetryChange *change);

#endif

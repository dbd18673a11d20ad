/* Comparing what a block's code answers with what its law says: a difference beyond rounding fails the check. */
#ifndef TINKER_CORE_LAW_COMPARE_H
#define TINKER_CORE_LAW_COMPARE_H

#include "conformance/rule/law-values.h"

/* One instance of a line law, force element, constraint or motion. */
void kit_law_compare_instance(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                              const KitState *state, const KitAnswer *answer, int32_t instance);

/* The torques of a force element that gives them. */
void kit_law_compare_torques(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                             const KitState *state, const KitAnswer *answer, int32_t instance);

/* The force of all instances of a field on one body. */
void kit_law_compare_body(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                          const KitState *state, const KitAnswer *answer, int32_t number);

/* What an instance gives to its ends at the instant of the state. */
void kit_law_compare_blow(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *blow, const KitState *state,
                          const KitAnswer *answer, int32_t instance);

#endif

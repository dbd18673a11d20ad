/* What a block's law says in numbers, at random states. */
#ifndef TINKER_CORE_LAW_VALUES_H
#define TINKER_CORE_LAW_VALUES_H

#include "conformance/probe/state.h"
#include "law/block-law.h"

#define KIT_LAW_ROUNDING 64.0 /* times as much as was seen may be off */

/* Where a law is worked out. */
typedef struct {
    const TinkerBlockLaw *law;
    const KitState *state;
    int32_t instance, body, other;
    gboolean at_rest;
    GRand *shake; /* NULL: exactly there */
} KitLawPlace;

/* The value, and what may be lost of it to rounding: added where it is more than `lost`. */
double kit_law_value(const KitLawPlace *place, const TinkerExpression *expression, double *lost);

/* Whether it is a motion's that turns a support, and does not displace it. */
gboolean kit_law_turns_support(const TinkerBlockLaw *law);

/* What its role asks for, as a law would say it: number `component` of the end or row `number`. (transfer full) */
char *kit_law_name(const TinkerBlockLaw *law, int32_t component, int32_t number, int32_t count);

/* The derivative of its potential by a symbol; NULL: it does not state one. (transfer full) */
TinkerExpression *kit_law_slope(const TinkerBlockLaw *law, const char *by);

/* The expression, or minus the gradient of the potential where the law leaves it at that; NULL: it does not say.
 * (transfer full) */
TinkerExpression *kit_law_stated(const TinkerBlockLaw *law, int32_t component, int32_t number, int32_t count);

#endif

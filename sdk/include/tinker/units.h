/* Tinker SDK: the units interface, "tinker.units/1".
 *
 * Values are stored in SI; only the display is converted. The unit follows from the dimension by the host's table
 * (m and ft, kg and slug, N and lbf, ...); a block names another one where its field uses another.
 */
#ifndef TINKER_UNITS_H
#define TINKER_UNITS_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_UNITS_INTERFACE "tinker.units/1"

/* The display unit of one property or quantity. A unit is written as in a scene: "deg", "lbf/ft", "rpm". */
typedef struct TinkerUnitChoice {
    const char *id;      /* of the property or quantity */
    const char *si;      /* NULL: the one that follows from the dimension */
    const char *english; /* likewise */
} TinkerUnitChoice;

typedef struct TinkerUnits {
    uint32_t struct_size;
    int32_t reserved;
    TinkerSpan choices; /* of TinkerUnitChoice */
} TinkerUnits;

#ifdef __cplusplus
}
#endif
#endif

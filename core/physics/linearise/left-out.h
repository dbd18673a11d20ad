/* What a model that is made linear about a state leaves out of what is there: contacts between shapes; motions that
 * joints prescribe, of which only the places at t = 0 count; and that forces vary in time. */
#ifndef TINKER_CORE_LEFT_OUT_H
#define TINKER_CORE_LEFT_OUT_H

#include "physics/model/model.h"

typedef enum {
    TINKER_LEFT_OUT_CONTACT,   /* the two touch, and move as if the other were not there */
    TINKER_LEFT_OUT_MOTION,    /* a joint that turns or slides one by the other: it is held still */
    TINKER_LEFT_OUT_VARIATION, /* a force whose stiffness or damping is another at another time */
} TinkerLeftOutKind;

typedef struct {
    TinkerLeftOutKind kind;
    TinkerBlockId block, other; /* the bodies or supports; or the joint or force, and none */
} TinkerLeftOut;

/* Adds to `list` (of TinkerLeftOut) what there is in a held model with its bodies at these places (by coordinate), but
 * for what is on the list already; nothing where a force cannot be worked out there. */
void tinker_linearise_add_left_out(TinkerModel *model, const double *q, GArray *list);

/* Adds the forces whose stiffness or damping varies in time: in a held model about these places, whose extent (m) this
 * is. Looked for at a few times up to two minutes. */
void tinker_linearise_add_varying(TinkerModel *model, const double *q, double extent, GArray *list);

#endif

/* Start conditions in the words of problem statements: "released from equilibrium", "stretched by 5 cm", "at 30 degrees
 * from the vertical", "up the incline at 2 m/s".
 *
 * What is offered follows from what a block is connected to; no block is known by name. Places are those at t = 0, with
 * supports where their motions have them then. */
#ifndef TINKER_CORE_START_CONDITIONS_H
#define TINKER_CORE_START_CONDITIONS_H

#include "scene/history/history.h"

typedef enum {
    /* of a body that can move */
    TINKER_START_AT_EQUILIBRIUM,   /* it and all that hangs together with it at rest where the forces balance */
    TINKER_START_FROM_EQUILIBRIUM, /* likewise, but it by so much off its place; m */
    TINKER_START_STRETCHED,        /* `other`, a connector, is so much longer than its rest length; m */
    TINKER_START_AT_ANGLE,         /* `other` is at this angle from straight down of its far end; rad */
    TINKER_START_ON_TOP,           /* just touches the top of `other`, a plate, and lies along it */
    TINKER_START_ALONG_TOP,        /* moves along the top of `other`, uphill or to the right; m/s */
    TINKER_START_ROLLING,          /* a disc moves along that top and turns so that it does not slip; m/s */
    TINKER_START_AT_REST,
    TINKER_START_SPEED,     /* the direction stays; m/s */
    TINKER_START_DIRECTION, /* counter-clockwise from +x, the speed stays; rad */
    /* of a body that turns; what is joined to it goes along */
    TINKER_START_LEVEL,    /* its own x axis, a bar's length, along the world's */
    TINKER_START_UPRIGHT,  /* along the world's y axis */
    TINKER_START_INCLINED, /* at this angle, counter-clockwise from the right; rad */
    TINKER_START_SPINNING, /* turns at this rate, counter-clockwise, about what it is joined to; rad/s */
    /* of a connector that has a length */
    TINKER_START_LENGTH_AS_DRAWN,  /* the length becomes the distance of its ends */
    TINKER_START_LENGTH_STRETCHED, /* the length becomes that much less than the distance of its ends; m */
} TinkerStartKind;

typedef struct {
    TinkerStartKind kind;
    TinkerBlockId block;       /* the one that was asked about */
    TinkerBlockId other;       /* a connector or a plate, or TINKER_NO_BLOCK */
    char *label;               /* of the row; owned */
    char *description;         /* a sentence: what will be done, and to which blocks; owned */
    gboolean asks;             /* for a value; else a button alone */
    TinkerDimension dimension; /* of the value */
    double value;              /* what it is now, SI; 0 where that is not known */
} TinkerStartOption;

/* What can be offered for a block, in the order to show; of TinkerStartOption *. Empty for a placeholder and for a
 * block with nothing to offer. Looks for equilibrium only where few bodies hang together; where many do, it is offered
 * and looked for when applied. (transfer full) */
GPtrArray *tinker_start_options_new(TinkerScene *scene, TinkerBlockId block);

/* Makes it so, as one undo step. Rest lengths stay what they were: one that was left to the drawing is given first
 * where it would change. On failure nothing has changed, and the message says what is in the way: no equilibrium, a rod
 * that would have to change its length, a plate. Errors: TINKER_MODEL_ERROR, TINKER_SCENE_ERROR. */
gboolean tinker_start_apply(TinkerHistory *history, TinkerScene *scene, const TinkerStartOption *option, double value,
                            GError **error);

#endif

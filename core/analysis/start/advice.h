/* Advice: what is wrong or doubtful with a start, where it is, and the nearest repair. */
#ifndef TINKER_CORE_ADVICE_H
#define TINKER_CORE_ADVICE_H

#include "scene/history/history.h"

typedef enum {
    TINKER_ADVICE_DETACHED_END, /* repair: connects it to the nearest block that it accepts, or else to a new support */
    TINKER_ADVICE_MISSING_TYPE, /* no repair */
    TINKER_ADVICE_LENGTH,       /* a given length that is not as drawn; repair: as drawn */
    TINKER_ADVICE_JOINT,        /* a joint whose ends do not fit together; repair: its bodies are moved */
    TINKER_ADVICE_VELOCITY,     /* start velocities that constraints do not allow; repair: what they leave of them */
    TINKER_ADVICE_MODEL,        /* whatever else keeps the scene from running; no repair */
    TINKER_ADVICE_OVERLAP,      /* a body that starts in a plate; repair: out of it */
    TINKER_ADVICE_MEETING,      /* bodies whose start velocities take them through each other; no repair */
    TINKER_ADVICE_WOUND_ENDS,   /* what is wound begins where nothing is round, and ends on a disc; repair: swapped */
    TINKER_ADVICE_SMALL_WHEEL,  /* what goes over the centre of something round; no repair */
    TINKER_ADVICE_IDLE_TURN,    /* what acts on angles has an end on a point, or two on one body; no repair */
    TINKER_ADVICE_PASSING,      /* a body that turns, is not solid and lies at or over a solid top; repair: solid */
} TinkerAdviceKind;

/* A vector that belongs to a block: a velocity (m/s) or a shift (m). */
typedef struct {
    TinkerBlockId block;
    double x, y;
    double rate; /* rad/s: that it is to turn at; NAN: as it is */
} TinkerAdviceVector;

typedef struct {
    TinkerAdviceKind kind;
    gboolean blocks_run; /* nothing runs before it is repaired; else a warning */
    char *message;       /* one sentence: where, what, what would be right */
    GArray *blocks;      /* of TinkerBlockId: to select and to mark; the first is the one that it is about */
    char *repair;        /* label of the button; NULL: nothing that the program could do by itself */
    /* what the repair needs */
    int32_t end;                     /* of the first block */
    TinkerBlockId target;            /* to connect it to */
    const TinkerBlockClass *support; /* of which one is added where the end is; NULL: there is a target */
    double length;                   /* m */
    GArray *vectors;                 /* of TinkerAdviceVector; NULL: none */
} TinkerAdvice;

/* All that can be told without planning a run, worst first, at the price of compiling the scene once; of TinkerAdvice
 * *. (transfer full) */
GPtrArray *tinker_advice_new(TinkerScene *scene);

/* Does what the button says, as one undo step. Errors: TINKER_SCENE_ERROR, where the scene has changed since; then
 * nothing has changed. */
gboolean tinker_advice_repair(TinkerHistory *history, TinkerScene *scene, const TinkerAdvice *advice, GError **error);

#endif

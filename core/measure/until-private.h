/* What the two files of until.h share: conditions as they were read. */
#ifndef TINKER_CORE_UNTIL_PRIVATE_H
#define TINKER_CORE_UNTIL_PRIVATE_H

#include "measure/formula.h"
#include "measure/until.h"

typedef enum { UNTIL_ROOT, UNTIL_COMPARISON, UNTIL_EVENT } UntilKind;

typedef struct {
    UntilKind kind;
    char *text;
    TinkerFormula *left, *right; /* of a root; a comparison is `left` */
    char *event, *block;         /* block NULL: any */
    /* While a run goes on */
    int side;       /* sign of a root's difference when it was last not 0; 0: not yet */
    double largest; /* that either side of a root was */
    gboolean idle;  /* a comparison has been false */
} UntilCondition;

struct _TinkerUntil {
    TinkerScene *scene;
    double start;       /* s: what t is at the start of the run */
    GArray *columns;    /* of TinkerColumn */
    GArray *conditions; /* of UntilCondition */
    GArray *samples;    /* of double, s: of the run that was ended; NULL */
};

#endif

/* What the status line says: how the scene is run, how well it goes, and how far it has got. No widget. */
#ifndef TINKER_GUI_STATUS_TEXT_H
#define TINKER_GUI_STATUS_TEXT_H

#include "gui/document/plan-task.h"
#include "gui/document/player.h"

typedef enum {
    TINKER_STATUS_METHOD,
    TINKER_STATUS_ERROR,
    TINKER_STATUS_ENERGY,
    TINKER_STATUS_CONSTRAINTS,
    TINKER_STATUS_EVENT,
    TINKER_STATUS_PACE,
    TINKER_STATUS_RECORDED,
    TINKER_STATUS_COUNT,
} TinkerStatusPart;

typedef struct {
    char *text;       /* NULL: nothing to say */
    char *tooltip;    /* the same for somebody who has not heard of it yet */
    gboolean warning; /* it is worse than one would want */
} TinkerStatusItem;

/* What it is made of. */
typedef struct {
    const TinkerRunStatus *run;   /* NULL before there is one */
    const TinkerPlanResult *plan; /* NULL while there is none */
    const TinkerRunEvent *event;  /* the last one before the time that is shown; NULL: none */
    double duration;              /* s: as far as the run will go */
    double speed, pace;           /* of the play-back, as player.h has them */
} TinkerStatusFacts;

void tinker_status_fill(const TinkerStatusFacts *facts, TinkerStatusItem items[TINKER_STATUS_COUNT]);
void tinker_status_clear(TinkerStatusItem items[TINKER_STATUS_COUNT]);

/* All of it in one line. (transfer full) */
char *tinker_status_line_text(const TinkerStatusItem items[TINKER_STATUS_COUNT]);

/* A size in so many digits: "2e-9", "0.03" in one. (transfer full) */
char *tinker_status_size_text(double value, int digits);

#endif

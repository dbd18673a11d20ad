/* What the files about directions that are lost share: the lines that have one to lose, and the motion of their ends.
 */
#ifndef TINKER_CORE_DIRECTION_PRIVATE_H
#define TINKER_CORE_DIRECTION_PRIVATE_H

#include <math.h>

#include "physics/island/island-run.h"
#include "physics/limit/direction-watch.h"
#include "physics/model/model-data.h"

typedef struct {
    int32_t a, b;                  /* points */
    double tension;                /* N, at length 0 */
    double mass;                   /* kg: the ends' reduced mass */
    double start;                  /* m: its length then */
    const TinkerAskedBatch *asked; /* whose plugin tells the tension; NULL: merged, and constant */
    int32_t row;
    gboolean closest; /* its ends are so at the instant that is expected */
    gboolean lost;
} TinkerDirectionLine;

struct _TinkerDirectionWatch {
    TinkerIslandRun *run;
    TinkerModel *model;
    GArray *lines;                          /* of TinkerDirectionLine */
    double projection_work, position_error; /* of the system, where the step began */
    double *x, *u, *q, *v;                  /* a state within the step: of the system, of the bodies */
    double *acceleration;
    double *room;    /* which all these lie in */
    double expected; /* s: ends may meet then, on the way to which the method makes several steps; INFINITY */
};

/* The relative motion of a line's ends. */
typedef struct {
    double d[2], u[2], length, speed;
    double closing; /* -d . u */
} TinkerDirectionEnds;

/* J: beside that of rest at one place. */
static inline double tinker_direction_energy(const TinkerDirectionLine *line, const TinkerDirectionEnds *ends)
{
    return fabs(line->tension) * ends->length + 0.5 * line->mass * ends->speed * ends->speed;
}

/* Whether the island's coordinates are those along its line. */
static inline gboolean tinker_direction_is_straight(const TinkerIslandRun *run)
{
    return run->q != run->state.q;
}

/* Lists the lines with a tension at length 0; answers the length (m) below which evaluations are of interest, 0 where
 * that is not known. */
double tinker_direction_list(TinkerDirectionWatch *watch);

/* N, at length 0; 0 where the law has none there that is a number. */
double tinker_direction_tension(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row);

/* The blocks whose force a line is, joined by ", ". (transfer full) */
char *tinker_direction_names(const TinkerDirectionWatch *watch, const TinkerDirectionLine *line);

/* Where a line's ends are at a time within the last step, and how they move. The bodies are placed at its
 * end; for a time inside it the state is left in x and u. */
TinkerStatus tinker_direction_measure(TinkerDirectionWatch *watch, const TinkerDirectionLine *line, double t,
                                      TinkerDirectionEnds *ends);

/* The acceleration (m/s^2) of its second end relative to the first, in a state of the system. Costs the method no
 * evaluation. */
TinkerStatus tinker_direction_acceleration(TinkerDirectionWatch *watch, const TinkerDirectionLine *line, double t,
                                           const double *x, const double *u, double relative[2]);

#endif

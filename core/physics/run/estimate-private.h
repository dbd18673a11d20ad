/* What the files of an error estimate share. */
#ifndef TINKER_CORE_ESTIMATE_PRIVATE_H
#define TINKER_CORE_ESTIMATE_PRIVATE_H

#include "physics/island/island-run.h"
#include "physics/run/comparison.h"
#include "physics/run/estimate.h"
#include "physics/run/relay.h"

/* Of one island. */
typedef struct {
    gboolean compares;
    double length;                  /* s: of the run's last step */
    double reached;                 /* s: where that ended */
    double told;                    /* s: the companion has been told to come so far */
    double extent, speed;           /* m, m/s: the scales where it began, of an adaptive method */
    double next_extent, next_speed; /* and where it ended */
    double landing;                 /* s: the last one that the companion was told of */
    double beyond;                  /* s: and where it goes from there if a sample is behind it, */
    double begun;                   /* as it does now; else -INFINITY */
    TinkerTimeGrid grid;            /* of the companion's steps, and the number of the next one; of a fixed method */
    gint64 next_step;
    double acceleration; /* m/s^2: the largest so far */
    double fastest;      /* rad/s: no mode of an exact island is faster */
    double *start;       /* where its coordinates were; NULL where it is not exact */
    double swing;        /* and how far they have been from there, */
    double mean_speed;   /* m/s: on the way to where that was the fastest */
    double rounding;     /* m: of the places of its points in the scene */
} TinkerEstimatePart;

/* Room for the bodies of an island. */
typedef struct {
    double *q, *v;
} TinkerEstimateRoom;

struct _TinkerEstimate {
    TinkerIslandRuns *runs;
    TinkerComparison *comparison;
    TinkerRelay *relay;
    TinkerEstimatePart *parts; /* island by island */
    TinkerEstimateRoom then, now;
};

/* The run has made a step: where in it the two are compared is written to `times`, and how often is answered; and where
 * the companion goes from there. */
int32_t tinker_estimate_part_step(TinkerEstimatePart *part, TinkerIslandRun *run, double *times);

/* m, m/s: the scales of an island where its run has come to. */
void tinker_estimate_scales(TinkerIslandRun *run, double *extent, double *speed);
/* The same up to a sample at t, which a long step of the run has passed by far where motion begins: what it reaches at
 * its end would make little of errors that are large as yet. */
void tinker_estimate_scales_at(TinkerEstimate *estimate, TinkerIslandRun *run, const TinkerEstimatePart *part, double t,
                               double *extent, double *speed);
/* What rounding makes of an exact solution by time t. A frequency w that is off by one part in 1 / epsilon moves
 * places by epsilon w t of their swing and speeds by as much of theirs, which is epsilon t times the largest speed
 * and acceleration. */
double tinker_estimate_rounding(TinkerEstimate *estimate, guint number, double t);
/* Whether an island does nothing but rest on plates, or where a joint on a support holds it: what moves there is
 * rounding, and has no scale. */
gboolean tinker_estimate_part_rests(const TinkerEstimatePart *part, const TinkerIslandRun *run, double extent);

#endif

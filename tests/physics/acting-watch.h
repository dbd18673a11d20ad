/* What the tests of the forces that act share: a run that is looked at, sample by sample. */
#ifndef TEST_ACTING_WATCH_H
#define TEST_ACTING_WATCH_H

#include "physics-fixture.h"
#include "physics/run/acting-forces.h"
#include "physics/run/simulation.h"

typedef struct {
    TinkerScene *scene;
    TinkerActingForces *forces;
    GArray *out;
    GArray *bodies;  /* of TinkerBlockId; each has the columns ax, ay */
    GArray *columns; /* of TinkerColumn */
    GArray *samples; /* of double; or NULL */
    gboolean look;   /* FALSE: samples alone are kept */
    int looked, allotted;
    double most; /* N: the largest force seen */
} ActingWatch;

/* Of all bodies of a scene, with its model; samples are not kept. */
void acting_watch_open(ActingWatch *watch, TinkerScene *scene, TinkerModel *model);
void acting_watch_close(ActingWatch *watch);

/* For tinker_simulation_run(), with the watch as its data. */
gboolean acting_watch_look(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error);

/* What acts at the start, without a run. (transfer full) */
GArray *acting_watch_at_start(TinkerScene *scene);

#endif

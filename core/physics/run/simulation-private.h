/* What the files of a simulation share. */
#ifndef TINKER_CORE_SIMULATION_PRIVATE_H
#define TINKER_CORE_SIMULATION_PRIVATE_H

#include "physics/run/box-watch.h"
#include "physics/run/estimate.h"
#include "physics/run/event-values.h"
#include "physics/run/island-runs.h"
#include "physics/run/sample-watch.h"
#include "physics/run/simulation.h"

struct _TinkerSimulation {
    TinkerIslandRuns *all;
    TinkerBoxWatch *watch;      /* NULL where no two bodies could overlap, or where it has been told that they do */
    TinkerEstimate *estimate;   /* NULL where none is asked for, or none is needed */
    TinkerEventsFunc at_events; /* NULL: nobody wants to know of events */
    TinkerEventValues *events;  /* NULL where nobody wants to know of events, and before the run */
    void *data;                 /* handed to at_events and to whoever takes the samples */
    gboolean ended;             /* the run, and its estimate with it */
};

/* A simulation that steps its islands as it is told (one choice an island; NULL: as the options say). */
TinkerSimulation *tinker_simulation_new_chosen(TinkerModel *model, const TinkerRunOptions *options,
                                               const TinkerChoice *choices, GError **error);

#endif

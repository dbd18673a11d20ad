/* What the files of a simulation share. */
#ifndef TINKER_CORE_SIMULATION_PRIVATE_H
#define TINKER_CORE_SIMULATION_PRIVATE_H

#include "physics/event/contact-run.h"
#include "physics/model/model.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/record/sample-times.h"
#include "physics/record/sampler.h"
#include "physics/run/box-watch.h"
#include "physics/run/estimate.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

struct _TinkerSimulation {
    TinkerModel *model; /* the whole */
    TinkerRunOptions options;
    GPtrArray *islands; /* of TinkerIsland * */
    GPtrArray *runs;    /* of TinkerIslandRun *, one an island */
    TinkerSampleTimes times;
    double *sample_q, *sample_v; /* of the whole model's bodies */
    double *part_q, *part_v;     /* room for those of one island */
    double *orientation;         /* rad: of bodies that were turned by what they touched; else NAN */
    double sample_time;
    gint64 contact_changes; /* of all runs, when the whole model's closed contacts were gathered */
    double piece_end;       /* of the whole model, where it is not stepped itself */
    gint64 work;            /* of all runs together since the options' functions were last called */
    TinkerSampler *sampler;
    double *values;
    TinkerBoxWatch *watch;    /* NULL where no two bodies could overlap, or where it has been told that they do */
    TinkerEstimate *estimate; /* NULL where none is asked for, or none is needed */
    TinkerSummary summary;
};

/* Of a TinkerEvent. */
void tinker_event_free(gpointer data);

/* A simulation that steps its islands as it is told (one choice an island; NULL: as the options say). */
TinkerSimulation *tinker_simulation_new_chosen(TinkerModel *model, const TinkerRunOptions *options,
                                               const TinkerChoice *choices, GError **error);

/* One step of the island with this number. */
gboolean tinker_simulation_step_island(TinkerSimulation *simulation, guint number, GError **error);

/* Brings all islands to time t at least, and the whole model's bodies to where they are then. */
gboolean tinker_simulation_advance(TinkerSimulation *simulation, double t, GError **error);

/* Evaluates the columns there. */
TinkerStatus tinker_simulation_sample(TinkerSimulation *simulation, double t);

/* Adds up what the islands' runs say. */
void tinker_simulation_add_up(TinkerSimulation *simulation);

#endif

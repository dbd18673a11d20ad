/* A run that is held to an accuracy: its own error estimate is, by tightening steps and tolerances.
 *
 * The first try is stepped as the plan expects it to take. Where its estimate is above what was asked for, all is run
 * again: by the first estimate in proportion, tolerances by it and fixed steps by its root of the method's order; by
 * the second as the two before it tell. What steps exactly is left as it is. */
#ifndef TINKER_CORE_ACCURATE_RUN_H
#define TINKER_CORE_ACCURATE_RUN_H

#include "physics/run/simulation.h"

/* Runs at most, the first one included. */
#define TINKER_MOST_TRIES 3

/* Who takes the samples of a run. */
typedef struct {
    TinkerSampleFunc sample;         /* NULL: nobody */
    void (*begin_again)(void *data); /* forgets all samples so far: they were of a try that missed. NULL: later samples
                                        replace earlier ones anyway */
    TinkerEventsFunc at_events;      /* NULL: nobody wants to know */
    void *data;                      /* of the three */
} TinkerSampleTaker;

/* Runs *simulation, which has been prepared and not begun, to its end, as tinker_simulation_run does. Where its options
 * ask for an accuracy and for an estimate, and that is above it, the simulation is freed and another, tighter one takes
 * its place, and so on; the samples of the last one are what the taker has at the end, and its summary tells all tries.
 * Errors: those of tinker_simulation_run; TINKER_MODEL_ERROR_ACCURACY where the last try, which has been handed out
 * whole, still misses. */
gboolean tinker_accurate_run(TinkerSimulation **simulation, const GArray *columns, const TinkerSampleTaker *taker,
                             GError **error);

#endif

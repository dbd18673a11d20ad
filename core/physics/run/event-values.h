/* What the columns are just before and just behind the instants at which a run jumps: events of contact, and breaks of
 * waveforms. Between two samples nothing else tells of them. */
#ifndef TINKER_CORE_EVENT_VALUES_H
#define TINKER_CORE_EVENT_VALUES_H

#include "physics/run/island-runs.h"

typedef struct _TinkerEventValues TinkerEventValues;

/* The columns at an instant t (s), on its two sides. FALSE with `error` set stops the run. */
typedef gboolean (*TinkerEventValuesTaker)(void *taker, double t, const double *before, const double *behind,
                                           GError **error);

/* Of these runs, which are borrowed and have been told their columns. (transfer full) */
TinkerEventValues *tinker_event_values_new(TinkerIslandRuns *runs, TinkerEventValuesTaker take, void *taker);
void tinker_event_values_free(TinkerEventValues *values);

/* As tinker_island_runs_advance, by the same steps; hands out the instants up to the sample at t in their order. There
 * are no more of them than samples, and a few hundred besides: of more in a row the later ones are left out. */
gboolean tinker_event_values_advance(TinkerEventValues *values, double t, GError **error);

#endif

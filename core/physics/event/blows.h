/* Blows: impulses that blocks give at an instant, and what joints and contacts answer to them. */
#ifndef TINKER_CORE_BLOWS_H
#define TINKER_CORE_BLOWS_H

#include "physics/island/island-run.h"

/* Where blocks of the run's island strike at the state's time: changes the velocities as an impact does, and books the
 * work as given by motors. What lies on something when the blow comes does not rebound from it, and what rubs there
 * rubs with its dynamic coefficient (contact-laws.h). The event is "blow", with the block and what it strikes. */
gboolean tinker_island_run_strike(TinkerIslandRun *run, GError **error);

#endif

/* What the parts of the planted library know of each other. */
#ifndef TEST_PLANTED_H
#define TEST_PLANTED_H

#include <tinker/sdk.h>

/* Where the properties of pull stand, which pair has too; of gather the first. */
enum { STIFFNESS, REST_LENGTH, DAMPING };

/* For faults that ought to come to light where a block is prepared. */
#if defined(PLANT_counts) || defined(PLANT_counts_rows)
extern double planted_prepared;
#endif
#if defined(PLANT_counts) || defined(PLANT_counts_rows) || defined(PLANT_prepares_umask)
TinkerStatus planted_prepare(TinkerBatch *batch);
#endif

/* Other faults are of the code, which a law would show as well. */
#if defined(PLANT_none) || defined(PLANT_law_unit) || defined(PLANT_law_potential)
#define PLANTED_LAW 2 /* equations of pull */
#elif defined(PLANT_law_value) || defined(PLANT_law_text) || defined(PLANT_law_missing)
#define PLANTED_LAW 1
#endif
#if defined(PLANTED_LAW)
extern const TinkerLawEquation planted_pull_law[PLANTED_LAW];
#endif

#if defined(PLANT_blow_missing)
#define PLANTED_KNOCK_LAW 3
#else
#define PLANTED_KNOCK_LAW 4
#endif
extern const TinkerLawEquation planted_knock_law[PLANTED_KNOCK_LAW];

extern const TinkerPropertyType planted_pull_properties[3], planted_knock_properties[2], planted_rub_properties[4],
    planted_follow_properties[1], planted_gather_properties[1], planted_ball_properties[4], planted_keep_properties[1],
    planted_hold_properties[1], planted_sway_properties[4];
extern const TinkerQuantityType planted_quantities[1];
extern const TinkerInterface planted_pull_interfaces[4], planted_knock_interfaces[1], planted_clap_interfaces[1],
    planted_rub_interfaces[1], planted_pair_interfaces[1], planted_follow_interfaces[1], planted_gather_interfaces[1],
    planted_ball_interfaces[1], planted_keep_interfaces[1], planted_hold_interfaces[1], planted_sway_interfaces[1];
extern const TinkerIntegrator planted_integrators[1];

#endif

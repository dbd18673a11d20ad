/* What each block gave each body at an instant at which velocities jumped: contacts, ropes, blows, and the joints that
 * answer to them. */
#ifndef TINKER_CORE_JOLTS_H
#define TINKER_CORE_JOLTS_H

#include "physics/model/model.h"

typedef struct {
    double time; /* s */
    TinkerBlockId by, on;
    double impulse[2]; /* N s */
    double spin;       /* N m s, about the centre of the body */
} TinkerJolt;

/* (transfer full) */
GArray *tinker_jolts_new(void);

/* Adds an impulse (N s) along a coordinate of a body that can move, to what the same block gave it at that time. */
void tinker_jolts_add(GArray *jolts, const TinkerModel *model, double time, TinkerBlockId by, int32_t coordinate,
                      double impulse);

/* Adds what a row that holds in one direction only does with this multiplier (N s), slack or not; to `given` the change
 * of velocities, by coordinate, that it is. */
void tinker_jolts_add_pull(GArray *jolts, const TinkerModel *model, double time, int32_t row, double multiplier,
                           double *given);

/* Adds what the rows that were evaluated and solved last do with their multipliers (N s). */
void tinker_jolts_add_rows(GArray *jolts, const TinkerModel *model, double time);

#endif

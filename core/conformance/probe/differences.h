/* Derivatives of what a function answers, by differences. */
#ifndef TINKER_CONFORMANCE_DIFFERENCES_H
#define TINKER_CONFORMANCE_DIFFERENCES_H

#include "conformance/probe/state.h"

/* Changes the coordinate number `which` of a state by so much. */
typedef void (*KitMove)(KitState *state, int which, double by);

/* 0: the length of every instance of a line law; 1: the rate. */
void kit_move_line(KitState *state, int which, double by);
/* Component which % 2 of the end number which / 2 of every instance that has it. */
void kit_move_end(KitState *state, int which, double by);
/* Component which % 4 (x, y, vx, vy) of body which / 4. */
void kit_move_body(KitState *state, int which, double by);
/* Time goes on, with waveforms by their derivatives, which is a Taylor series up to its square: enough for second
 * derivatives where it begins. With which = 1 the ends as well, with their velocities. */
/* Turns what end number `which` of every instance is on. */
void kit_turn_end(KitState *state, int which, double by);
void kit_go_on(KitState *state, int which, double by);

/* How near to each other differences have to be. */
typedef struct {
    double close; /* relative error that is allowed */
    double floor; /* what is smaller than this share of the value itself is rounding */
} KitNearness;

/* The derivative of the first result by a move, first or second (`degree`), of every number of it; NAN where
 * differences do not tell it as nearly as that. NULL where the check is decided. (transfer full) */
double *kit_slopes(KitCheck *check, const KitFunction *function, const KitState *state, KitMove move, int which,
                   int degree, KitNearness nearness);

#endif

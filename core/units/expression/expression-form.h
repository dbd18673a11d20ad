/* Expressions as sums of a polynomial of t and of harmonics. */
#ifndef TINKER_EXPRESSION_FORM_H
#define TINKER_EXPRESSION_FORM_H

#include "units/expression/expression-program.h"

#define TINKER_MOST_HARMONICS 8

/* amplitude * sin(frequency * (t - origin) + phase) */
typedef struct {
    double amplitude, frequency, phase;
} TinkerHarmonic;

/* Both parts about the same origin. */
typedef struct {
    double polynomial[4];
    int count;
    TinkerHarmonic harmonics[TINKER_MOST_HARMONICS];
} TinkerForm;

/* How many harmonics the program has at most, in any of its pieces, beside a polynomial of degree 3; -1 where it is not
 * of that form, or not seen to be. */
int tinker_program_harmonics(const TinkerProgram *program);

/* The form by the cells as they stand, about the time t. Only where tinker_program_harmonics is not -1. */
void tinker_program_form(const TinkerProgramState *state, double t, TinkerForm *form);

#endif

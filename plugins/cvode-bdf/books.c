/* The books: integrals of powers over the step that was made.
 *
 * No error control of the state sees them: a body that sticks to an even belt moves evenly, which order 1 follows in a
 * single step, while the spring behind it is stretched and the belt works against it. So the powers are integrated
 * along CVODE's polynomial of the step, by Simpson's rule on so many parts as make them all but straight. Where a power
 * is off a straight line by a share d in the middle of a part, Simpson's rule is off by about (d / 6)^2, as long as its
 * fourth derivative is as the square of its second.
 */
#include "stepper-private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PLACES 64    /* that a step is cut into at most: a power of two */
#define LOOSER 100.0 /* a step may spend so many times its tolerance on the books */
/* Orders up to this follow motions that tell nothing of the powers: half a step is looked at, too. */
#define SIMPLE_ORDER 2

int stepper_books_create(Stepper *stepper)
{
    const size_t count = (size_t)stepper->system->books;
    stepper->books_from = calloc(count + 1, sizeof(double));
    stepper->power_to = calloc(count + 1, sizeof(double));
    stepper->power_within = calloc(count + 1, sizeof(double));
    stepper->powers = calloc((PLACES + 1) * count + 1, sizeof(double));
    return stepper->books_from != NULL && stepper->power_to != NULL && stepper->power_within != NULL &&
           stepper->powers != NULL;
}

void stepper_books_destroy(Stepper *stepper)
{
    free(stepper->books_from);
    free(stepper->power_to);
    free(stepper->power_within);
    free(stepper->powers);
}

void stepper_books_begin(Stepper *stepper, const TinkerState *state)
{
    const TinkerSystem *system = stepper->system;
    double energy = 0.0;
    for (int32_t i = 0; i < system->size; i++)
        energy += 0.5 * system->mass[i] * state->v[i] * state->v[i];
    stepper->energy = fmax(stepper->energy, energy);
    memcpy(stepper->books_from, state->books, (size_t)system->books * sizeof(double));
    memcpy(stepper->powers, stepper->power_to, (size_t)system->books * sizeof(double));
}

/* Whether this power, at these places of the step, is all but straight between the two beside the middle one. */
static int is_straight(const Stepper *stepper, double span, const double *left, const double *middle,
                       const double *right)
{
    const double share = LOOSER * stepper->tolerance;
    int straight = 1;
    for (int32_t i = 0; i < stepper->system->books; i++) {
        const double off = span * fabs(middle[i] - 0.5 * (left[i] + right[i]));
        const double size = span * fmax(fabs(middle[i]), fmax(fabs(left[i]), fabs(right[i])));
        straight &= off <= 6.0 * (sqrt(share) * size + share * stepper->energy);
    }
    return straight;
}

/* Works out the powers in the middle of every part of so many places. *straight tells whether that is enough. */
static TinkerStatus look_between(Stepper *stepper, double from, double span, int part, int *straight)
{
    const TinkerSystem *system = stepper->system;
    const int half = part / 2, count = system->books;
    for (int place = half; place < PLACES; place += part) {
        const double t = from + span * place / PLACES;
        if (CVodeGetDky(stepper->cvode, t, 0, stepper->weights) != CV_SUCCESS) return TINKER_FAILED;
        double *q = N_VGetArrayPointer(stepper->weights), *middle = stepper->powers + place * count;
        TinkerStatus status = system->acceleration(system->context, t, q, q + system->size, stepper->work, middle);
        if (status != TINKER_OK) return status;
        *straight &= is_straight(stepper, span, middle - half * count, middle, middle + half * count);
    }
    return TINKER_OK;
}

TinkerStatus stepper_books_integrate(Stepper *stepper, double from, double to, const double *power_to, double *books)
{
    const int count = stepper->system->books;
    const double span = to - from;
    int order = 0, straight = 0, part = 2 * PLACES;
    CVodeGetLastOrder(stepper->cvode, &order);
    memcpy(stepper->powers + PLACES * count, power_to, (size_t)count * sizeof(double));
    while (part > 2 && (!straight || (order <= SIMPLE_ORDER && part == PLACES))) {
        part /= 2;
        straight = 1;
        TinkerStatus status = look_between(stepper, from, span, part, &straight);
        if (status != TINKER_OK) return status;
    }
    for (int i = 0; i < count; i++) {
        double sum = 0.0;
        for (int place = 0; place < PLACES; place += part) {
            const double *at = stepper->powers + place * count + i;
            sum += at[0] + 4.0 * at[part / 2 * count] + at[part * count];
        }
        books[i] = stepper->books_from[i] + span * sum * part / (6.0 * PLACES);
    }
    return TINKER_OK;
}

/* The books: integrals of powers over the step that was made.
 *
 * No error control of the state sees them: a body that sticks to an even belt moves evenly, which order 1 follows in a
 * single step, while the spring behind it is stretched and the belt works against it. So the powers are integrated
 * along CVODE's polynomial of the step, by Simpson's rule on so many parts as make them all but straight. Where a power
 * is off a straight line by a share d in the middle of a part, Simpson's rule is off by about (d / 6)^2, as long as its
 * fourth derivative is as the square of its second.
 *
 * Where velocities hardly change, the step may be as long as the run, and swings of a power that stand still at even
 * places of it would be missed: there two places that lie unevenly tell whether powers are straight, else a rule of
 * Gauss and Kronrod is taken over the whole step (R. Piessens et al., QUADPACK, Springer, 1983), and the step is too
 * long where its two sums differ.
 */
#include "stepper-private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PLACES 64    /* that a step is cut into at most: a power of two */
#define LOOSER 100.0 /* a step may spend so many times its tolerance on the books */
/* Orders up to this follow motions that tell nothing of the powers: half a step is looked at, too. */
#define SIMPLE_ORDER 2
#define NODES        8     /* of the rule, from the outermost to the middle one; the other half mirrors them */
#define CANCELS      1e-10 /* of the kinetic energy: less in a step may be rounding of forces that cancel */
#define SHORTER      0.5   /* where the books are not known well enough */
#define FAR_BELOW    1e-4  /* of what is let pass: a longer step would do ... */
#define LONGER       1.5   /* ... by so much */

static const double node[NODES] = {
    0.991455371120812639, 0.949107912342758525, 0.864864423359769073, 0.741531185599394440,
    0.586087235467691130, 0.405845151377397167, 0.207784955007898468, 0.0};
static const double kronrod[NODES] = {0.022935322010529225, 0.063092092629978553, 0.104790010322250184,
                                      0.140653259715525919, 0.169004726639267903, 0.190350578064785410,
                                      0.204432940075298892, 0.209482141084727828};
static const double gauss[NODES] = {0.0, 0.129484966168869693, 0.0, 0.279705391489276668,
                                    0.0, 0.381830050505118945, 0.0, 0.417959183673469388};

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

/* The powers at a time within CVODE's last step. */
static TinkerStatus powers_at(Stepper *stepper, double t, double *powers)
{
    const TinkerSystem *system = stepper->system;
    if (CVodeGetDky(stepper->cvode, t, 0, stepper->weights) != CV_SUCCESS) return TINKER_FAILED;
    const double *q = N_VGetArrayPointer(stepper->weights);
    return system->acceleration(system->context, t, q, q + system->size, stepper->work, powers);
}

/* Adds this rule's integrals to `books`. *off is the most that its two sums differ by, *exchange the most that any
 * power would give in all of the step. */
static TinkerStatus add_by_gauss(Stepper *stepper, double from, double to, double *books, double *off, double *exchange)
{
    const int32_t count = stepper->system->books;
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double *powers = stepper->powers + count, *differences = powers + count; /* behind those at the start */
    memset(differences, 0, (size_t)count * sizeof *differences);
    *exchange = 0.0;
    for (int k = 0; k < 2 * NODES - 1; k++) {
        const int of = k < NODES ? k : k - NODES;
        TinkerStatus status = powers_at(stepper, middle + (k < NODES ? -half : half) * node[of], powers);
        if (status != TINKER_OK) return status;
        for (int32_t i = 0; i < count; i++) {
            books[i] += half * kronrod[of] * powers[i];
            differences[i] += half * (kronrod[of] - gauss[of]) * powers[i];
        }
        *exchange = fmax(*exchange, 2.0 * half * stepper_largest(count, powers));
    }
    *off = stepper_largest(count, differences);
    return TINKER_OK;
}

/* m/s: what changes its velocity by no more within the step is off by no more than places may be. */
static double slowest(Stepper *stepper, const double *q, const double *v, double span)
{
    double extent = 0.0, speed = 0.0;
    stepper->system->scales(stepper->system->context, q, v, &extent, &speed);
    return stepper->tolerance * extent / span;
}

void stepper_books_look(Stepper *stepper, const TinkerState *state, double to, const double *v, const double *a)
{
    double change = 0.0;
    for (int32_t i = 0; i < stepper->system->size; i++)
        change = fmax(change, fmax(fabs(v[i] - state->v[i]), fabs(a[i]) * (to - state->t)));
    stepper->slowest = slowest(stepper, state->q, state->v, to - state->t);
    stepper->even = change <= LOOSER * stepper->slowest;
}

/* J: what is at rest, or moves on with nothing to exchange, has powers of rounding. */
static double rounding(const Stepper *stepper)
{
    const TinkerSystem *system = stepper->system;
    return CANCELS * stepper->energy +
           stepper_largest(system->size, system->mass) * stepper->slowest * stepper->slowest;
}

/* Whether the powers are all but straight over the step, by two places that lie unevenly in it: then the cubics through
 * these four are integrated. */
static TinkerStatus integrate_straight(Stepper *stepper, double from, double to, const double *power_to, double *books,
                                       int *straight)
{
    static const double places[] = {0.381966011250105152, 0.723606797749978970};
    static const double weights[] = {0.134836165729157742, 0.462090414322895271, 0.287909585677104674,
                                     0.115163834270842314};
    const int32_t count = stepper->system->books;
    const double span = to - from, share = LOOSER * stepper->tolerance, *power_from = stepper->powers;
    double *within[] = {stepper->powers + count, stepper->powers + 2 * count};
    for (int k = 0; k < 2; k++) {
        TinkerStatus status = powers_at(stepper, from + places[k] * span, within[k]);
        if (status != TINKER_OK) return status;
    }
    *straight = 1;
    for (int32_t i = 0; i < count; i++) {
        const double size = fmax(fabs(power_from[i]), fabs(power_to[i]));
        for (int k = 0; k < 2; k++) {
            const double line = power_from[i] + places[k] * (power_to[i] - power_from[i]);
            *straight &= span * fabs(within[k][i] - line) <= 6.0 * (sqrt(share) * span * size + rounding(stepper));
        }
        books[i] = stepper->books_from[i] + span * (weights[0] * power_from[i] + weights[1] * within[0][i] +
                                                    weights[2] * within[1][i] + weights[3] * power_to[i]);
    }
    return TINKER_OK;
}

static TinkerStatus integrate_evenly(Stepper *stepper, double from, double to, const double *power_to, double *books)
{
    const TinkerSystem *system = stepper->system;
    const double exchanged = stepper_largest(system->books, stepper->books_from);
    double off = 0.0, exchange = 0.0;
    int straight = 0;
    stepper->books_error = 0.0;
    TinkerStatus status = integrate_straight(stepper, from, to, power_to, books, &straight);
    if (status != TINKER_OK || straight) return status;
    memcpy(books, stepper->books_from, (size_t)system->books * sizeof *books);
    status = add_by_gauss(stepper, from, to, books, &off, &exchange);
    const double limit = LOOSER * stepper->tolerance * fmax(exchange, exchanged) + rounding(stepper);
    stepper->books_error = off > 0.0 ? off / limit : 0.0;
    return status;
}

static TinkerStatus integrate_by_parts(Stepper *stepper, double from, double to, const double *power_to, double *books)
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

TinkerStatus stepper_books_integrate(Stepper *stepper, double from, double to, const double *power_to, double *books)
{
    if (stepper->even) return integrate_evenly(stepper, from, to, power_to, books);
    return integrate_by_parts(stepper, from, to, power_to, books);
}

int stepper_books_accept(Stepper *stepper, double span)
{
    const int known = !stepper->even || stepper->books_error <= 1.0;
    if (!known)
        stepper->longest = SHORTER * span;
    else if (!stepper->even)
        stepper->longest = 0.0;
    else if (stepper->books_error < FAR_BELOW)
        stepper->longest *= LONGER;
    CVodeSetMaxStep(stepper->cvode, stepper->longest);
    return known;
}

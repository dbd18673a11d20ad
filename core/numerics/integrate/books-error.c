/* The weights of the embedded methods, applied to the powers as they are to the accelerations. */
#include "numerics/integrate/books-error.h"

#include <math.h>

#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"
#include "numerics/solve/largest.h"

static int counts(const TinkerTableau *tableau, int stage)
{
    return tableau->error[stage] != 0.0 || (tableau->second_error && tableau->second_error[stage] != 0.0);
}

/* J: the most that a stage's powers would exchange in all of the step. */
static double exchange_of(const TinkerSystem *system, const TinkerBooksTrial *trial)
{
    double largest = 0.0;
    for (int stage = 0; stage <= trial->tableau->stages; stage++)
        if (counts(trial->tableau, stage)) largest = fmax(largest, tinker_largest(system->books, trial->power[stage]));
    return trial->h * largest;
}

/* m/s: what changes its velocity by no more within the step is off by no more than places may be. */
static double slowest(const TinkerSystem *system, const TinkerBooksTrial *trial)
{
    double extent = 0.0, speed = 0.0;
    system->scales(system->context, trial->q, trial->v, &extent, &speed);
    return trial->tolerance * extent / trial->h;
}

/* m/s: the most that a velocity changes by within the step. */
static double change_of_velocity(const TinkerSystem *system, const TinkerBooksTrial *trial)
{
    double largest = 0.0;
    for (int stage = 0; stage < trial->tableau->stages; stage++)
        largest = fmax(largest, tinker_largest(system->size, trial->a[stage]));
    return trial->h * largest;
}

static double kinetic_energy(const TinkerSystem *system, const double *v)
{
    double energy = 0.0;
    for (int32_t i = 0; i < system->size; i++)
        energy += 0.5 * system->mass[i] * v[i] * v[i];
    return energy;
}

static double error_of_book(const TinkerBooksTrial *trial, int32_t book, double scale)
{
    const TinkerTableau *tableau = trial->tableau;
    double error = 0.0, second_error = 0.0;
    for (int stage = 0; stage <= tableau->stages; stage++) {
        if (!counts(tableau, stage)) continue;
        error += tableau->error[stage] * trial->power[stage][book];
        if (tableau->second_error) second_error += tableau->second_error[stage] * trial->power[stage][book];
    }
    error = tinker_relative(trial->h * fabs(error), scale);
    if (!tableau->second_error) return error;
    return tinker_tableau_join_errors(error, tinker_relative(trial->h * fabs(second_error), scale));
}

double tinker_books_error(const TinkerSystem *system, const TinkerBooksTrial *trial)
{
    const double slow = slowest(system, trial), share = TINKER_BOOKS_LOOSER * trial->tolerance;
    /* a motion that changes by more is itself known well enough for its powers */
    if (change_of_velocity(system, trial) > TINKER_BOOKS_LOOSER * slow) return 0.0;
    const double exchanged = fmax(tinker_largest(system->books, trial->books0), exchange_of(system, trial));
    /* what sets out from rest, or moves on with nothing to exchange, has powers of rounding */
    const double least = TINKER_BOOKS_ROUNDING * kinetic_energy(system, trial->v) +
                         tinker_largest(system->size, system->mass) * slow * slow;
    double largest = 0.0;
    for (int32_t book = 0; book < system->books; book++)
        largest = fmax(largest, error_of_book(trial, book, share * exchanged + least));
    return largest;
}

/* The weights of the embedded methods, applied to the powers as they are to the accelerations. */
#include "numerics/integrate/books-error.h"

#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"
#include "numerics/solve/largest.h"

double tinker_books_energy(const TinkerSystem *system, const double *v, const double *books, double before)
{
    double kinetic = 0.0;
    if (system->books == 0) return 0.0;
    for (int32_t i = 0; i < system->size; i++)
        kinetic += 0.5 * system->mass[i] * v[i] * v[i];
    return fmax(fmax(before, kinetic), tinker_largest(system->books, books));
}

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

/* m/s: what moves no faster is off by no more than places may be. */
static double slow(const TinkerSystem *system, const TinkerBooksTrial *trial)
{
    double extent = 0.0, speed = 0.0;
    system->scales(system->context, trial->q, trial->v, &extent, &speed);
    return trial->tolerance * extent / trial->h;
}

gboolean tinker_books_trial_stands(const TinkerSystem *system, const TinkerBooksTrial *trial)
{
    const double speed = fmax(tinker_largest(system->size, trial->v0), tinker_largest(system->size, trial->v));
    return speed <= slow(system, trial);
}

/* J: what sets out from rest has powers of rounding. */
static double least_energy(const TinkerSystem *system, const TinkerBooksTrial *trial)
{
    const double speed = slow(system, trial);
    return tinker_largest(system->size, system->mass) * speed * speed;
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

double tinker_books_error(const TinkerSystem *system, const TinkerBooksTrial *trial, double *energy)
{
    double largest = 0.0;
    if (system->books == 0) return 0.0;
    *energy = fmax(*energy, exchange_of(system, trial));
    const double scale = TINKER_BOOKS_LOOSER * trial->tolerance * *energy + least_energy(system, trial);
    for (int32_t book = 0; book < system->books; book++)
        largest = fmax(largest, error_of_book(trial, book, scale));
    return largest;
}

/* Balance: energy now - energy at the start - everything given, relative to the largest energy exchanged so far. */
#include "physics/system/books.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/summary.h"
#include "physics/system/system.h"

#include <float.h>
#include <math.h>

#include "physics/system/tolerances.h"

double tinker_books_potential_of_origin(const TinkerModel *model)
{
    double mass = 0;
    for (int32_t i = 0; i < model->bodies; i++)
        mass += model->mass[i];
    return -mass * (model->field_acceleration[0] * model->origin[0] + model->field_acceleration[1] * model->origin[1]);
}

/* A straight system does not leave its forces in the model. */
static TinkerStatus evaluate_forces(TinkerModelSystem *system)
{
    TinkerModel *model = system->model;
    if (system->system.size == model->coordinates) return TINKER_OK;
    gint64 evaluations = model->evaluations;
    TinkerStatus status = tinker_model_applied(model, system->constrained, FALSE);
    model->evaluations = evaluations;
    return status;
}

/* Of the last evaluation. */
static double sum_of_forces(const TinkerModel *model)
{
    double sum = 0;
    for (int32_t i = 0; i < model->coordinates; i++)
        sum += fabs(model->force[i]) + model->coordinate_mass[i] * fabs(model->constant_acceleration[i]);
    return sum;
}

TinkerStatus tinker_books_open(TinkerBooks *books, TinkerModelSystem *system)
{
    TinkerModel *model = system->model;
    *books = (TinkerBooks){.system = system, .world_offset = tinker_books_potential_of_origin(model)};
    TinkerStatus status = tinker_model_set_time(model, 0.0);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, model->q_start, model->v_start);
    status = tinker_model_energy(model, &books->start);
    books->exchanged = books->start.kinetic;
    return status;
}

static double given(const TinkerBooks *books, const TinkerState *state, const TinkerEnergy *now, TinkerSummary *summary)
{
    const TinkerModelSystem *system = books->system;
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        summary->books[book] = 0;
    for (int32_t i = 0; i < system->system.books; i++)
        summary->books[system->book_of[i]] = state->books[i];
    /* of forces that store, a linear form books what they do not store; the model all that they do */
    if (system->form == NULL)
        summary->books[TINKER_BOOK_MOTORS] += now->stored_in_forces - books->start.stored_in_forces;
    summary->books[TINKER_BOOK_FIELDS] += now->stored_in_fields - books->start.stored_in_fields;
    summary->books[TINKER_BOOK_PROJECTION] = system->projection_work;
    double sum = 0;
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        sum += summary->books[book] += system->impact_work[book];
    return sum;
}

static double largest_exchange(const TinkerBooks *books, const TinkerEnergy *now, const TinkerSummary *summary)
{
    double largest = MAX(now->kinetic, fabs(now->potential - books->start.potential));
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        largest = MAX(largest, fabs(summary->books[book]));
    return largest;
}

TinkerStatus tinker_books_look(TinkerBooks *books, const TinkerState *state, double extent, TinkerSummary *summary)
{
    TinkerModel *model = books->system->model;
    TinkerEnergy now;
    TinkerStatus status = tinker_model_set_time(model, state->t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, state->q, state->v);
    status = tinker_model_energy(model, &now);
    if (status == TINKER_OK) status = evaluate_forces(books->system);
    if (status != TINKER_OK) return status;
    double sum = given(books, state, &now, summary);
    double missing = (now.kinetic - books->start.kinetic) + (now.potential - books->start.potential) - sum;
    books->exchanged = MAX(books->exchanged, largest_exchange(books, &now, summary));
    /* At rest nothing is exchanged but rounding: of the extent, times the forces that are balanced. */
    books->forces = fmax(books->forces, sum_of_forces(model));
    double rest = books->forces * extent, scale = MAX(books->exchanged, TINKER_BOOK_REST * rest);
    double bits = TINKER_BOOK_LAST_BITS * (rest + now.kinetic + fabs(now.potential));
    if (fabs(missing) <= bits) missing = 0;
    scale = MAX(scale, TINKER_BOOK_ROUNDING * (now.kinetic + fabs(now.potential)));
    double excess = books->allows_loss ? MAX(missing, 0) : fabs(missing);
    books->imbalance = scale > 0 ? excess / scale : 0;
    if (isnan(missing)) books->imbalance = NAN;
    books->missing = fmax(books->missing, fabs(missing));
    summary->kinetic_start = books->start.kinetic;
    summary->potential_start = books->start.potential + books->world_offset;
    summary->kinetic_end = now.kinetic;
    summary->potential_end = now.potential + books->world_offset;
    summary->energy_balance_error = scale > 0 ? books->missing / scale : 0;
    return TINKER_OK;
}

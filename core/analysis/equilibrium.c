/* Newton's method with a trust radius, in the coordinates of the modes.
 *
 * A step is taken where the forces do work along it: (r + r') . dq / 2 > 0 with the unbalanced forces r before and r' after
 * it. That is a fall of the energy where there is one, and asks for none where there is not. */
#include "analysis/equilibrium.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "analysis/modal-basis.h"

#define MOST_ITERATIONS 200
/* Of the extent: the first radius; and how far a model may wander before nothing is believed to hold it. */
#define FIRST_RADIUS 0.3
#define FARTHEST     30.0
/* Of the largest force: what may be left unbalanced where steps get no further. */
#define BALANCED 1e-9
/* Of the largest force: a push into a motion that nothing resists. */
#define PUSH 1e-10

typedef struct {
    TinkerModel *model;
    TinkerLinearisation *linear; /* at q */
    double *q, *trial, *step;
    gsize size;
    double radius, extent; /* m; extent as it was at first */
} Search;

static double greatest(const double *x, gsize n)
{
    double most = 0;
    for (gsize i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* The Newton step along each mode, cut to the radius. Answers its length as it was before. */
static double choose_step(Search *search, const TinkerModalBasis *basis)
{
    g_autofree double *y = g_new0(double, MAX(basis->count, 1));
    double heaviest = greatest(search->linear->mass, search->size);
    double push = PUSH * search->linear->force_scale / sqrt(heaviest);
    tinker_modal_basis_reduce(basis, search->linear->force, y);
    for (int32_t i = 0; i < basis->count; i++) {
        double square = fabs(basis->squares[i]);
        if (square > 0)
            y[i] /= square;
        else
            y[i] = fabs(y[i]) <= push ? 0 : copysign(2 * search->radius * sqrt(heaviest), y[i]);
    }
    tinker_modal_basis_expand(basis, y, search->step);
    double length = greatest(search->step, search->size);
    for (gsize i = 0; i < search->size && length > search->radius; i++)
        search->step[i] *= search->radius / length;
    return length;
}

static double work_along(const Search *search, const TinkerLinearisation *after)
{
    double work = 0;
    for (gsize i = 0; i < search->size; i++)
        work += 0.5 * (search->linear->force[i] + after->force[i]) * (search->trial[i] - search->q[i]);
    return work;
}

/* Tries the step; takes it where forces do work along it, or where they get smaller near the end. */
static gboolean try_step(Search *search)
{
    for (gsize i = 0; i < search->size; i++)
        search->trial[i] = search->q[i] + search->step[i];
    if (!tinker_model_meet_constraints(search->model, search->trial)) return FALSE;
    g_autoptr(TinkerLinearisation) after = tinker_linearise(search->model, search->trial, NULL);
    if (after == NULL) return FALSE;
    double before = greatest(search->linear->force, search->size), left = greatest(after->force, search->size);
    gboolean near = before <= 1e-6 * search->linear->force_scale;
    if (!isfinite(left) || !(near ? left < before : work_along(search, after) > 0)) return FALSE;
    memcpy(search->q, search->trial, search->size * sizeof(double));
    tinker_linearisation_free(search->linear);
    search->linear = g_steal_pointer(&after);
    return TRUE;
}

static gboolean is_balanced(const Search *search)
{
    return greatest(search->linear->force, search->size) <= search->linear->force_noise;
}

static gboolean wandered_off(const Search *search, const double *from)
{
    for (gsize i = 0; i < search->size; i++)
        if (fabs(search->q[i] - from[i]) > FARTHEST * search->extent) return TRUE;
    return FALSE;
}

static const char *search_for_rest(Search *search, const double *from, int *iterations)
{
    for (*iterations = 0; *iterations < MOST_ITERATIONS; (*iterations)++) {
        if (is_balanced(search)) return NULL;
        if (wandered_off(search, from)) return _("it moves away without end: nothing holds it against its forces");
        g_autoptr(TinkerModalBasis) basis = tinker_modal_basis_new(search->linear, NULL);
        if (basis == NULL) return _("its equations leave the range that can be computed with");
        double length = choose_step(search, basis);
        if (length <= 1e-15 * search->extent) return NULL;
        if (try_step(search)) {
            if (length > search->radius) search->radius *= 2;
            continue;
        }
        double balance = BALANCED * search->linear->force_scale + search->linear->force_noise;
        if (greatest(search->linear->force, search->size) <= balance) return NULL;
        search->radius = 0.25 * fmin(length, search->radius);
        if (search->radius < 1e-14 * search->extent) return _("its forces do not balance at any place near by");
    }
    return _("the search took more steps than it may");
}

gboolean tinker_equilibrium_find(TinkerModel *model, double *q, TinkerEquilibrium *result, GError **error)
{
    Search search = {.model = model, .q = q, .linear = tinker_linearise(model, q, error)};
    *result = (TinkerEquilibrium){0};
    if (search.linear == NULL) return FALSE;
    search.size = (gsize)search.linear->size;
    search.extent = search.linear->extent;
    search.radius = FIRST_RADIUS * search.extent;
    gsize bytes = MAX(search.size, 1) * sizeof(double);
    g_autofree double *from = g_malloc0(bytes), *trial = g_malloc0(bytes), *step = g_malloc0(bytes);
    memcpy(from, q, search.size * sizeof(double));
    search.trial = trial;
    search.step = step;
    const char *why = search_for_rest(&search, from, &result->iterations);
    result->found = why == NULL;
    result->unbalanced = greatest(search.linear->force, search.size);
    if (why != NULL) {
        g_strlcpy(result->why, why, sizeof result->why);
        memcpy(q, from, search.size * sizeof(double));
    }
    tinker_linearisation_free(search.linear);
    return TRUE;
}

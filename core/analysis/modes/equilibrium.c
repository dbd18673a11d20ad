/* Newton's method with a trust radius, in the coordinates of the modes.
 *
 * A step is taken where the forces do work along it: (r + r') . dq / 2 > 0 with the unbalanced forces r before and r'
 * after it. That is a fall of the energy where there is one, and asks for none where there is not.
 *
 * What is left at the end is held against the forces on the way. Where bodies that attract each other without bound
 * fall into one place, rounding of the places alone makes forces as large as those that pull, and "within rounding"
 * says nothing: at a rest state they cancel out, so that what is left is small beside what there was. */
#include "analysis/modes/equilibrium.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "analysis/modes/modal-basis.h"

#define MOST_ITERATIONS 200
/* Of the extent: the first radius; and how far a model may wander before nothing is believed to hold it. */
#define FIRST_RADIUS 0.3
#define FARTHEST     30.0
/* Of the largest force: what may be left unbalanced where steps get no further. */
#define BALANCED 1e-9
/* How much more than at the start rounding may make of the places, and what is left still be taken for balanced by it
 * alone. Otherwise what is left has to be this small beside the largest force left on the way. */
#define SAME_ROUNDING 1e3
#define CANCELLED     1e-4
/* Of the largest force: a push into a motion that nothing resists. */
#define PUSH 1e-10

/* A way is cut so often until nothing closes on it before its end. */
#define MOST_CUTS 50

typedef struct {
    TinkerModel *model;
    TinkerStillContacts *contacts; /* NULL: none are asked for */
    TinkerLinearisation *linear;   /* at q */
    double *q, *trial, *step;
    gsize size;
    double radius, extent; /* m; extent as it was at first */
    double noise;          /* N: of the start */
    double most;           /* N: the largest force left unbalanced so far */
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

static gboolean go_along(const Search *search, double share)
{
    for (gsize i = 0; i < search->size; i++)
        search->trial[i] = search->q[i] + share * search->step[i];
    return tinker_model_meet_constraints(search->model, search->trial);
}

typedef enum {
    STEP_REFUSED,
    STEP_TAKEN,
    STEP_BLOCKED, /* something touches already that the step would push through: it is closed now */
} StepResult;

/* As far along the step as no contact closes before. */
static StepResult go_to_contact(const Search *search)
{
    double share = 1;
    if (!go_along(search, share)) return STEP_REFUSED;
    for (int cut = 0; search->contacts != NULL && cut < MOST_CUTS; cut++) {
        double reach = tinker_still_contacts_reach(search->contacts, search->q, search->trial);
        if (reach == 0) return STEP_BLOCKED;
        if (reach == 1) return STEP_TAKEN;
        share *= reach;
        if (!go_along(search, share)) return STEP_REFUSED;
    }
    return search->contacts == NULL ? STEP_TAKEN : STEP_REFUSED;
}

static gboolean make_linear(Search *search)
{
    TinkerLinearisation *linear = tinker_linearise(search->model, search->q, NULL);
    if (linear == NULL) return FALSE;
    tinker_linearisation_free(search->linear);
    search->linear = linear;
    return TRUE;
}

/* Contacts are asked anew at q, and all is made linear there with those that act. */
static gboolean look_again(Search *search)
{
    if (search->contacts == NULL) return TRUE;
    return tinker_still_contacts_decide(search->contacts, search->q, NULL) && make_linear(search);
}

/* Tries the step; takes it where forces do work along it, or where they get smaller near the end. */
static StepResult try_step(Search *search)
{
    StepResult gone = go_to_contact(search);
    if (gone != STEP_TAKEN) return gone;
    g_autoptr(TinkerLinearisation) after = tinker_linearise(search->model, search->trial, NULL);
    if (after == NULL) return STEP_REFUSED;
    double before = greatest(search->linear->force, search->size), left = greatest(after->force, search->size);
    gboolean near = before <= 1e-6 * search->linear->force_scale;
    if (!isfinite(left) || !(near ? left < before : work_along(search, after) > 0)) return STEP_REFUSED;
    memcpy(search->q, search->trial, search->size * sizeof(double));
    tinker_linearisation_free(search->linear);
    search->linear = g_steal_pointer(&after);
    return look_again(search) ? STEP_TAKEN : STEP_REFUSED;
}

static double unbalanced(const Search *search)
{
    return greatest(search->linear->force, search->size);
}

/* Whether what is left looks little only beside forces that have grown without bound. */
static gboolean has_collapsed(const Search *search)
{
    return search->linear->force_noise > SAME_ROUNDING * search->noise && unbalanced(search) > CANCELLED * search->most;
}

static gboolean is_rest(const Search *search, double allowed)
{
    return unbalanced(search) <= allowed && search->linear->undefined_pulls == 0 && !has_collapsed(search);
}

/* Why the places that the search ends at are no rest; `otherwise`, unless there is more to say. */
static const char *why_no_rest(const Search *search, const char *otherwise)
{
    if (search->linear->undefined_pulls > 0)
        return _("two ends fall into one place, where the force between them has no direction");
    if (has_collapsed(search)) return _("its forces grow without bound as parts of it fall together");
    return otherwise;
}

static gboolean wandered_off(const Search *search, const double *from)
{
    for (gsize i = 0; i < search->size; i++)
        if (fabs(search->q[i] - from[i]) > FARTHEST * search->extent) return TRUE;
    return FALSE;
}

static const char *search_for_rest(Search *search, const double *from, int *iterations)
{
    const char *nowhere = _("its forces do not balance at any place near by");
    for (*iterations = 0; *iterations < MOST_ITERATIONS; (*iterations)++) {
        search->most = fmax(search->most, unbalanced(search));
        if (is_rest(search, search->linear->force_noise)) {
            if (search->contacts == NULL || !tinker_still_contacts_are_pushed(search->contacts)) return NULL;
            if (!look_again(search)) return nowhere; /* what was closed for one step opens where nothing presses it */
            continue;
        }
        if (has_collapsed(search) && unbalanced(search) <= search->linear->force_noise)
            return why_no_rest(search, nowhere); /* from here on rounding alone would lead the search */
        if (wandered_off(search, from)) return _("it moves away without end: nothing holds it against its forces");
        g_autoptr(TinkerModalBasis) basis = tinker_modal_basis_new(search->linear, NULL);
        if (basis == NULL) return _("its equations leave the range that can be computed with");
        double length = choose_step(search, basis);
        if (length <= 1e-15 * search->extent) return is_rest(search, INFINITY) ? NULL : why_no_rest(search, nowhere);
        StepResult result = try_step(search);
        if (result == STEP_TAKEN && length > search->radius) search->radius *= 2;
        if (result == STEP_BLOCKED && !make_linear(search)) return nowhere;
        if (result != STEP_REFUSED) continue;
        double balance = BALANCED * search->linear->force_scale + search->linear->force_noise;
        if (is_rest(search, balance)) return NULL;
        search->radius = 0.25 * fmin(length, search->radius);
        if (search->radius < 1e-14 * search->extent) return why_no_rest(search, nowhere);
    }
    return why_no_rest(search, _("the search took more steps than it may"));
}

/* One search from q; where it finds none, q stays. */
static gboolean find_once(TinkerModel *model, TinkerStillContacts *contacts, double *q, TinkerEquilibrium *result,
                          GError **error)
{
    Search search = {.model = model, .contacts = contacts, .q = q};
    *result = (TinkerEquilibrium){0};
    if (contacts != NULL && !tinker_still_contacts_decide(contacts, q, error)) return FALSE;
    search.linear = tinker_linearise(model, q, error);
    if (search.linear == NULL) return FALSE;
    search.size = (gsize)search.linear->size;
    search.noise = search.linear->force_noise;
    search.extent = search.linear->extent;
    search.radius = FIRST_RADIUS * search.extent;
    gsize bytes = MAX(search.size, 1) * sizeof(double);
    g_autofree double *from = g_malloc0(bytes), *trial = g_malloc0(bytes), *step = g_malloc0(bytes);
    memcpy(from, q, search.size * sizeof(double));
    search.trial = trial;
    search.step = step;
    const char *why = search_for_rest(&search, from, &result->iterations);
    result->found = why == NULL;
    result->unbalanced = unbalanced(&search);
    if (why != NULL) {
        g_strlcpy(result->why, why, sizeof result->why);
        memcpy(q, from, search.size * sizeof(double));
    }
    tinker_linearisation_free(search.linear);
    return TRUE;
}

gboolean tinker_equilibrium_find(TinkerModel *model, TinkerStillContacts *contacts, double *q,
                                 TinkerEquilibrium *result, GError **error)
{
    if (contacts == NULL) return find_once(model, NULL, q, result, error);
    tinker_still_contacts_begin_anew(contacts, TRUE);
    if (!find_once(model, contacts, q, result, error)) return FALSE;
    TinkerEquilibrium smooth = *result;
    if (!smooth.found) { /* a rough slope holds what a smooth one does not */
        tinker_still_contacts_begin_anew(contacts, FALSE);
        if (!find_once(model, contacts, q, result, error)) return FALSE;
    }
    if (!result->found) {
        tinker_still_contacts_begin_anew(contacts, FALSE);
        *result = smooth;
    }
    tinker_still_contacts_have_landed(contacts);
    return tinker_still_contacts_decide(contacts, q, error);
}

/* Where it is known what every contact does, the impulses solve a linear system; whether they keep the laws says what
 * the contacts should do instead. */
#include <math.h>
#include <string.h>

#include "numerics/contact/contact-private.h"
#include "numerics/contact/tolerances.h"
#include "numerics/solve/pivoted-solve.h"

/* What the normal impulse of contact k does in a row by way of those that lean on it and slip. */
static double leaning_entry(const TinkerContactWork *work, int32_t k, const double *row)
{
    const TinkerContactProblem *problem = &work->problem;
    double entry = 0;
    for (int32_t i = k + 1; i < problem->count; i++)
        if (problem->bearer[i] == k && work->state[i] != TINKER_STATE_STICK)
            entry += tinker_contact_slope(problem, i, work->state[i]) * row[2 * i + 1];
    return entry;
}

/* What those bounded by a number that slip do in a row. */
static double held_slips(const TinkerContactWork *work, const double *row)
{
    double sum = 0;
    for (int32_t i = 0; work->problem.bearer != NULL && i < work->problem.count; i++)
        if (work->state[i] != TINKER_STATE_STICK)
            sum += row[2 * i + 1] * tinker_contact_held_slip(&work->problem, i, work->state[i]);
    return sum;
}

static void solve_system(TinkerContactWork *work)
{
    const TinkerContactProblem *problem = &work->problem;
    int32_t m = problem->count, width = 2 * m, count = 0;
    for (int32_t k = 0; k < m; k++) {
        work->p[2 * k] = work->p[2 * k + 1] = 0;
        if (work->state[k] != TINKER_STATE_OPEN && !tinker_contact_leans(problem, k)) work->unknown[count++] = 2 * k;
        if (work->state[k] == TINKER_STATE_STICK) work->unknown[count++] = 2 * k + 1;
    }
    for (int32_t i = 0; i < count; i++) {
        const double *row = problem->delassus + (gsize)work->unknown[i] * (gsize)width;
        work->right[i] = -problem->offset[work->unknown[i]] - held_slips(work, row);
        for (int32_t j = 0; j < count; j++) {
            int32_t column = work->unknown[j], k = column / 2;
            double entry = row[column];
            if (column % 2 == 0 && work->state[k] != TINKER_STATE_STICK)
                entry += tinker_contact_slope(problem, k, work->state[k]) * row[column + 1];
            if (column % 2 == 0 && problem->bearer != NULL) entry += leaning_entry(work, k, row);
            work->system[i * count + j] = entry;
        }
    }
    const int32_t rank = tinker_pivoted_solve(count, work->system, work->right, work->order, TINKER_SMALLEST_PIVOT);
    work->singular = rank < count;
    for (int32_t i = 0; i < count; i++)
        work->p[work->unknown[i]] = work->right[i];
    for (int32_t k = 0; k < m; k++)
        if (work->state[k] != TINKER_STATE_STICK)
            work->p[2 * k + 1] =
                tinker_contact_slope(problem, k, work->state[k]) * tinker_contact_normal(problem, work->p, k);
}

double tinker_contact_velocity(const TinkerContactProblem *problem, const double *p, int32_t i, double *size)
{
    int32_t width = 2 * problem->count;
    const double *row = problem->delassus + (gsize)i * (gsize)width;
    double sum = problem->offset[i], total = fabs(sum);
    for (int32_t j = 0; j < width; j++) {
        double term = row[j] * p[j];
        sum += term;
        total += fabs(term);
    }
    if (size != NULL) *size = total;
    return sum;
}

void tinker_contact_velocities(const TinkerContactProblem *problem, const double *p, double *v, double *size)
{
    const int32_t width = 2 * problem->count;
    if (problem->delassus != NULL) {
        for (int32_t i = 0; i < width; i++)
            v[i] = tinker_contact_velocity(problem, p, i, &size[i]);
        return;
    }
    problem->motion->times(problem->motion->context, p, v, size);
    for (int32_t i = 0; i < width; i++) {
        v[i] += problem->offset[i];
        size[i] += fabs(problem->offset[i]);
    }
}

/* What is rounding in entry i of v. */
static double slack(const TinkerContactWork *work, int32_t i, double tolerance)
{
    return tolerance * (work->size[i] + work->floor);
}

/* What contact k should do rather than what it does, if that breaks a law by more than `tolerance`. */
static TinkerContactState better_state(const TinkerContactWork *work, int32_t k, double tolerance, double p_slack)
{
    const TinkerContactProblem *problem = &work->problem;
    int32_t n = 2 * k, t = n + 1;
    TinkerContactState state = work->state[k];
    gboolean grips = tinker_contact_grips(problem, k);
    if (tinker_contact_leans(problem, k)) {
        const int32_t bearer = tinker_contact_bearer(problem, k);
        if (bearer >= 0 && work->state[bearer] == TINKER_STATE_OPEN) return TINKER_STATE_OPEN;
        if (state == TINKER_STATE_OPEN) return grips ? TINKER_STATE_STICK : TINKER_STATE_FREE;
    } else if (state == TINKER_STATE_OPEN)
        return work->v[n] >= -slack(work, n, tolerance) ? state : grips ? TINKER_STATE_STICK : TINKER_STATE_FREE;
    const double normal = tinker_contact_normal(problem, work->p, k);
    if (normal < -p_slack) return tinker_contact_leans(problem, k) ? state : TINKER_STATE_OPEN;
    if (!grips) return state;
    if (state == TINKER_STATE_STICK) {
        if (fabs(work->p[t]) <= problem->friction[k] * normal + p_slack) return state;
        return work->p[t] < 0 ? TINKER_STATE_FORWARD : TINKER_STATE_BACKWARD;
    }
    double along = state == TINKER_STATE_FORWARD ? work->v[t] : -work->v[t];
    return along >= -slack(work, t, tolerance) ? state : TINKER_STATE_STICK;
}

gboolean tinker_contact_judge(TinkerContactWork *work, double tolerance, TinkerContactState *next)
{
    const TinkerContactProblem *problem = &work->problem;
    double largest = 0;
    gboolean good = TRUE;
    for (int32_t i = 0; i < 2 * problem->count; i++)
        largest = MAX(largest, fabs(work->p[i]));
    for (int32_t k = 0; k < problem->count; k++) {
        int32_t n = 2 * k, t = n + 1;
        TinkerContactState state = work->state[k], better = better_state(work, k, tolerance, tolerance * largest);
        /* a system without solution leaves equations that do not hold */
        good = good && (state == TINKER_STATE_OPEN || fabs(work->v[n]) <= slack(work, n, tolerance)) &&
               (state != TINKER_STATE_STICK || fabs(work->v[t]) <= slack(work, t, tolerance)) && better == state;
        if (next != NULL) next[k] = better;
    }
    return good && isfinite(largest);
}

gboolean tinker_contact_check(TinkerContactWork *work, double tolerance, TinkerContactState *next)
{
    tinker_contact_velocities(&work->problem, work->p, work->v, work->size);
    return tinker_contact_judge(work, tolerance, next);
}

void tinker_contact_correct(TinkerContactWork *work)
{
    const int32_t width = 2 * work->problem.count;
    const TinkerContactProblem problem = work->problem;
    double *before = work->lcp, *missing = before + width, *none = missing + width;
    memcpy(before, work->p, (gsize)width * sizeof *before);
    memcpy(missing, work->v, (gsize)width * sizeof *missing);
    memset(none, 0, (gsize)problem.count * sizeof *none);
    work->problem.offset = missing;
    work->problem.load = none;
    solve_system(work);
    work->problem = problem;
    for (int32_t i = 0; i < width; i++)
        work->p[i] += before[i];
}

gboolean tinker_contact_try_states(TinkerContactWork *work, double tolerance, TinkerContactState *next)
{
    solve_system(work);
    return tinker_contact_check(work, tolerance, next);
}

double tinker_contact_miss(TinkerContactWork *work)
{
    const TinkerContactProblem *problem = &work->problem;
    const double *p = work->p, *v = work->v;
    double most = 0;
    tinker_contact_velocities(problem, p, work->v, work->size);
    for (int32_t k = 0; k < problem->count; k++) {
        const int32_t n = 2 * k, t = n + 1;
        if (!isfinite(v[n]) || !isfinite(v[t])) return INFINITY;
        most = fmax(most, fabs(fmin(p[n], v[n])));
        if (!tinker_contact_grips(problem, k)) continue;
        const double bound = problem->friction[k] * fmax(tinker_contact_normal(problem, p, k), 0);
        most = fmax(most, fabs(p[t] - CLAMP(p[t] - v[t], -bound, bound)));
    }
    return most;
}

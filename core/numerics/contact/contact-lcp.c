/* The laws as a linear complementarity problem, after Anitescu and Potra: a contact that may hold by friction has four
 * unknowns, p_n, the two directions of p_t and the speed s of sliding,
 *
 *     v_n >= 0 | p_n >= 0,   s + v_t >= 0 | p_forward >= 0,   s - v_t >= 0 | p_backward >= 0,
 *     friction p_n - p_forward - p_backward >= 0 | s >= 0,       p_t = p_forward - p_backward;
 *
 * others have p_n alone. What leans on another has no p_n of its own: the bearer's stands in its place, and where it
 * cannot hold, it has no unknown at all. The matrix is copositive where none slides, so that Lemke's path ends in a
 * solution. */
#include <math.h>
#include <string.h>

#include "numerics/contact/complementarity.h"
#include "numerics/contact/contact-private.h"

/* By how much a contact is softened: in measures of its own, so that it is the same by whatever it is scaled. */
static double softness(const TinkerContactProblem *problem, int32_t k, double softening)
{
    const double *at = problem->delassus + 2 * (gsize)k * (2 * (gsize)problem->count + 1);
    return softening * (at[0] + at[2 * (gsize)problem->count + 1]);
}

/* What unit unknowns add to v: those of entry `row` of W for p_n (with its share of p_t) and p_t of contact k. */
static void entries(const TinkerContactProblem *problem, int32_t row, int32_t k, double softening, double *of_n,
                    double *of_t)
{
    const double *at = problem->delassus + (gsize)row * 2 * (gsize)problem->count + 2 * k;
    *of_n = at[0] + (row == 2 * k ? softness(problem, k, softening) : 0);
    *of_t = at[1] + (row == 2 * k + 1 ? softness(problem, k, softening) : 0);
    if (!tinker_contact_grips(problem, k)) *of_n += tinker_contact_slope(problem, k, TINKER_STATE_FREE) * *of_t;
    for (int32_t i = k + 1; problem->bearer != NULL && i < problem->count; i++)
        if (problem->bearer[i] == k && !tinker_contact_grips(problem, i))
            *of_n += tinker_contact_slope(problem, i, TINKER_STATE_FREE) * at[2 * (i - k) + 1];
}

/* How many unknowns a contact has. */
static int32_t unknowns_of(const TinkerContactProblem *problem, int32_t k)
{
    return (tinker_contact_leans(problem, k) ? 0 : 1) + (tinker_contact_grips(problem, k) ? 3 : 0);
}

/* The number of p_n of a contact that leans on no other. */
static int32_t normal_of(const TinkerContactProblem *problem, int32_t k)
{
    int32_t at = 0;
    for (int32_t i = 0; i < k; i++)
        at += unknowns_of(problem, i);
    return at;
}

/* A row of the matrix: `sign` times an entry of v. */
static void fill_row(const TinkerContactProblem *problem, int32_t entry, double sign, double softening, double *row)
{
    for (int32_t k = 0, at = 0; k < problem->count; k++) {
        double of_n, of_t;
        entries(problem, entry, k, softening, &of_n, &of_t);
        if (!tinker_contact_leans(problem, k)) row[at++] = sign * of_n;
        if (!tinker_contact_grips(problem, k)) continue;
        row[at++] = sign * of_t;
        row[at++] = -sign * of_t;
        row[at++] = 0;
    }
}

/* The least impulse that bounds the friction of a contact. */
static double least_of(const TinkerContactProblem *problem, int32_t k)
{
    return problem->least != NULL ? problem->least[tinker_contact_bearer(problem, k)] : 0;
}

static double offset_of(const TinkerContactProblem *problem, int32_t i, double softening, const double *centre)
{
    double given = 0; /* by those bounded by a number that slide, and by what is pressed in any case */
    for (int32_t k = 0; problem->least != NULL && k < problem->count; k++) {
        double of_n, of_t;
        entries(problem, i, k, softening, &of_n, &of_t);
        given += of_n * problem->least[k];
    }
    for (int32_t k = 0; problem->bearer != NULL && k < problem->count; k++)
        if (!tinker_contact_grips(problem, k))
            given += problem->delassus[(gsize)i * 2 * (gsize)problem->count + 2 * (gsize)k + 1] *
                     tinker_contact_held_slip(problem, k, TINKER_STATE_FREE);
    return problem->offset[i] + given - (centre != NULL ? softness(problem, i / 2, softening) * centre[i] : 0);
}

static int32_t fill(const TinkerContactProblem *problem, double softening, const double *centre, double *matrix,
                    double *q)
{
    int32_t size = 0, at = 0;
    for (int32_t k = 0; k < problem->count; k++)
        size += unknowns_of(problem, k);
    for (int32_t k = 0; k < problem->count; k++) {
        int32_t normal = at;
        if (tinker_contact_is_held(problem, k)) {
            normal = -1;
        } else if (tinker_contact_leans(problem, k)) {
            normal = normal_of(problem, problem->bearer[k]);
        } else {
            q[at] = offset_of(problem, 2 * k, softening, centre);
            fill_row(problem, 2 * k, 1, softening, matrix + (gsize)at * (gsize)size);
            at++;
        }
        if (!tinker_contact_grips(problem, k)) continue;
        double *row = matrix + (gsize)at * (gsize)size;
        q[at] = offset_of(problem, 2 * k + 1, softening, centre);
        q[at + 1] = -q[at];
        q[at + 2] = normal >= 0 ? problem->friction[k] * least_of(problem, k) : 0;
        fill_row(problem, 2 * k + 1, 1, softening, row);
        fill_row(problem, 2 * k + 1, -1, softening, row + size);
        row[at + 2] = row[size + at + 2] = 1;
        row += 2 * size;
        memset(row, 0, (gsize)size * sizeof *row);
        if (normal >= 0)
            row[normal] = problem->friction[k];
        else
            q[at + 2] = problem->friction[k] * tinker_contact_normal(problem, NULL, k);
        row[at] = row[at + 1] = -1;
        at += 3;
    }
    return size;
}

gboolean tinker_contact_by_complementarity(TinkerContactWork *work, double softening, const double *centre)
{
    const TinkerContactProblem *problem = &work->problem;
    double *q = work->lcp_room, *z = q + 4 * problem->count, *room = z + 4 * problem->count;
    int32_t size = fill(problem, softening, centre, work->lcp, q);
    /* where the solver gives up, it is the contacts' own check that judges what it has */
    if (tinker_lcp_solve(size, work->lcp, q, z, room) == TINKER_LCP_RAY) return FALSE;
    for (int32_t k = 0, at = 0; k < problem->count; k++) {
        const gboolean leans = tinker_contact_leans(problem, k);
        const double normal = leans ? tinker_contact_normal(problem, work->p, k) : z[at] + least_of(problem, k);
        const double *along = z + at + !leans;
        work->p[2 * k] = leans ? 0 : normal;
        if (tinker_contact_grips(problem, k)) {
            work->p[2 * k + 1] = along[0] - along[1];
            work->state[k] = along[2] > 0 ? work->p[2 * k + 1] < 0 ? TINKER_STATE_FORWARD : TINKER_STATE_BACKWARD
                                          : TINKER_STATE_STICK;
        } else {
            work->p[2 * k + 1] = tinker_contact_slope(problem, k, TINKER_STATE_FREE) * normal;
            work->state[k] = TINKER_STATE_FREE;
        }
        if (normal == 0) { /* where the solver gave up friction may be left without it */
            work->state[k] = TINKER_STATE_OPEN;
            work->p[2 * k + 1] = 0;
        }
        at += unknowns_of(problem, k);
    }
    return TRUE;
}

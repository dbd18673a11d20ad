/* One contact is solved in closed form. Of several, most problems are settled by a few guesses at what each does; else
 * by Lemke's method; where that ends in a ray, by trying all states of few contacts, by proximal points, or by sweeps.
 */
#include <math.h>
#include <string.h>

#include "numerics/contact/complementarity.h"
#include "numerics/contact/contact-private.h"
#include "numerics/contact/tolerances.h"
#include "numerics/solve/power-of-two.h"

/* Doubles on the stack, enough for 5 contacts. */
#define SMALL_ROOM 1320

/* Contacts whose states may all be tried. */
#define FEW 4

/* Of proximal points: where small ones leave W too nearly singular, large ones take more passes. */
static const double softenings[] = {1e-6, 3e-5, 1e-3};
#define MOST_PASSES 20
/* Of pivots alone. */
static const double softest[] = {0, 1e-10, 1e-9, 1e-8, 1e-7};

#define MOST_SWEEPS    2000
#define SWEEPS_FIRST   400 /* before Lemke's method, whose path grows long where contacts are more than */
#define MANY           8
#define SWEEPS_BETWEEN 50
/* W of more contacts is not written down. */
#define MOST_WRITTEN 2000

static gboolean is_immovable(const TinkerContactProblem *problem, int32_t k)
{
    gsize width = 2 * (gsize)problem->count, n = 2 * (gsize)k;
    if (tinker_contact_leans(problem, k)) return FALSE;
    double normal = problem->delassus[n * (width + 1)], along = problem->delassus[(n + 1) * (width + 1)];
    return !(normal > TINKER_IMMOVABLE * along);
}

/* A contact that slides one way, sigma: p_t = -friction p_n sigma. */
static gboolean slide_single(const TinkerContactProblem *problem, double sigma, double *p)
{
    double slope = problem->friction[0] * sigma, normal = problem->delassus[0], cross = slope * problem->delassus[1];
    if (!(normal - cross > 4e-16 * (normal + fabs(cross)))) return FALSE;
    p[0] = -problem->offset[0] / (normal - cross);
    p[1] = -slope * p[0];
    return TRUE;
}

static gboolean stick_single(const TinkerContactProblem *problem, double tolerance, double *p)
{
    const double *w = problem->delassus, *b = problem->offset;
    double coupling = w[2] / w[0], along = b[1] - coupling * b[0], left = w[3] - coupling * w[1];
    double noise = tolerance * (fabs(b[1]) + fabs(coupling * b[0]));
    /* along a guide both directions are one */
    p[1] = left > tolerance * w[3] ? -along / left : 0;
    p[0] = -(b[0] + w[1] * p[1]) / w[0];
    double most = problem->friction[0] * p[0];
    if ((p[1] == 0 && fabs(along) > noise) || !(fabs(p[1]) <= most * (1 + 4e-16))) return FALSE;
    p[1] = CLAMP(p[1], -most, most);
    return TRUE;
}

/* A contact that may hold by friction: it sticks, or it slides the way that friction lets it. */
static gboolean grip_single(const TinkerContactProblem *problem, double tolerance, double *p)
{
    const double *w = problem->delassus, *b = problem->offset;
    if (stick_single(problem, tolerance, p)) return TRUE;
    double sigma = b[1] - w[2] / w[0] * b[0] >= 0 ? 1 : -1;
    for (int32_t side = 0; side < 2; side++, sigma = -sigma) {
        if (!slide_single(problem, sigma, p)) continue;
        double size, along = tinker_contact_velocity(problem, p, 1, &size);
        if (sigma * along >= -tolerance * size) return TRUE;
    }
    return FALSE;
}

/* One that is bounded by a number. */
static TinkerContactResult hold_single(const TinkerContactProblem *problem, double *p)
{
    const double most = problem->friction[0] * tinker_contact_normal(problem, p, 0), own = problem->delassus[3];
    if (!isfinite(problem->offset[1]) || !isfinite(most)) return TINKER_CONTACT_GAVE_UP;
    if (tinker_contact_grips(problem, 0))
        p[1] = CLAMP(-problem->offset[1] / own, -most, most);
    else
        p[1] = tinker_contact_held_slip(problem, 0, TINKER_STATE_FREE);
    return TINKER_CONTACT_SOLVED;
}

static TinkerContactResult solve_single(const TinkerContactProblem *problem, double *p)
{
    const double *b = problem->offset;
    p[0] = p[1] = 0;
    if (tinker_contact_is_held(problem, 0)) return hold_single(problem, p);
    if (b[0] >= 0) return TINKER_CONTACT_SOLVED;
    if (!isfinite(b[0]) || !isfinite(b[1])) return TINKER_CONTACT_GAVE_UP;
    if (is_immovable(problem, 0)) return TINKER_CONTACT_NO_ACCELERATION;
    if (!tinker_contact_grips(problem, 0)) {
        double sigma = problem->sliding == NULL ? 0 : problem->sliding[0];
        return slide_single(problem, sigma, p) ? TINKER_CONTACT_SOLVED : TINKER_CONTACT_NO_ACCELERATION;
    }
    if (grip_single(problem, TINKER_GUESS_ROUNDING, p) || grip_single(problem, TINKER_LOOSE, p))
        return TINKER_CONTACT_SOLVED;
    p[0] = p[1] = 0;
    return TINKER_CONTACT_NO_ACCELERATION;
}

static gsize room_of(int32_t m)
{
    gsize n = (gsize)m;
    return 4 * n * n + 2 * n + n + 8 * n + 4 * n * n + 2 * n + 16 * n * n + 8 * n + (gsize)tinker_lcp_room(4 * m) +
           4 * n + n + 4 * n;
}

static void set_up(TinkerContactWork *work, const TinkerContactProblem *problem, double *room)
{
    gsize m = (gsize)problem->count, width = 2 * m;
    double *delassus = room, *offset = delassus + width * width;
    work->problem = *problem;
    work->problem.delassus = delassus;
    work->problem.offset = offset;
    work->scale = offset + width;
    work->centre = work->scale + m;
    work->p = work->centre + width;
    work->v = work->p + width;
    work->size = work->v + width;
    work->system = work->size + width;
    work->right = work->system + width * width;
    work->lcp = work->right + width;
    work->lcp_room = work->lcp + 4 * width * width;
    work->unknown = (int32_t *)(void *)(work->lcp_room + 4 * width + tinker_lcp_room(4 * problem->count));
    work->order = work->unknown + width;
    work->state = (TinkerContactState *)(void *)(work->order + width);
    double *load = (double *)(void *)(work->state + 2 * width); /* the states' guesses lie between */
    work->problem.load = load;
    work->kept = load + m;
    work->grip = work->kept + width;
    work->least = work->grip + m;

    double largest = 0;
    work->blocked = FALSE;
    for (gsize k = 0; k < m; k++) {
        double block = problem->delassus[2 * k * (width + 1)] + problem->delassus[(2 * k + 1) * (width + 1)];
        const int32_t bearer = tinker_contact_bearer(problem, (int32_t)k);
        /* the cone of what leans on another is over that one's normal */
        work->scale[k] = bearer >= 0 && bearer != (int32_t)k ? work->scale[bearer]
                         : block > 0                         ? 1 / tinker_power_of_two(sqrt(block))
                                                             : 1;
        for (gsize i = 2 * k; i < 2 * k + 2; i++)
            largest = MAX(largest, fabs(problem->offset[i]) * work->scale[k]);
    }
    work->floor = 1e-3;
    work->unit = largest > 0 ? tinker_power_of_two(largest) : 1;
    for (gsize i = 0; i < width; i++) {
        offset[i] = problem->offset[i] * work->scale[i / 2] / work->unit;
        for (gsize j = 0; j < width; j++)
            delassus[i * width + j] = problem->delassus[i * width + j] * work->scale[i / 2] * work->scale[j / 2];
    }
    for (gsize k = 0; k < m; k++)
        load[k] = 1 / (work->scale[k] * work->unit);
    for (int32_t k = 0; k < problem->count; k++)
        if (is_immovable(problem, k)) {
            work->blocked |= offset[2 * k] < -TINKER_STANDS_STILL;
            offset[2 * k] = 1;
        }
}

/* From what the offsets alone ask for, every contact by turns to what fits what the last guess gave. */
static gboolean guess(TinkerContactWork *work, double tolerance, TinkerContactState *next)
{
    const TinkerContactProblem *problem = &work->problem;
    for (int32_t k = 0; k < problem->count; k++) {
        const int32_t bearer = tinker_contact_bearer(problem, k);
        work->state[k] = bearer >= 0 && problem->offset[2 * bearer] >= 0 ? TINKER_STATE_OPEN
                         : tinker_contact_grips(problem, k)              ? TINKER_STATE_STICK
                                                                         : TINKER_STATE_FREE;
    }
    for (int32_t tries = 0; tries < MIN(problem->count, MANY) + 6; tries++) {
        if (tinker_contact_try_states(work, tolerance, next)) return TRUE;
        if (memcmp(next, work->state, (gsize)problem->count * sizeof *next) == 0) return FALSE;
        memcpy(work->state, next, (gsize)problem->count * sizeof *next);
    }
    return FALSE;
}

/* The impulses that the states found so far ask for, or else those that they were found with. */
static gboolean settle(TinkerContactWork *work, double tolerance)
{
    gsize bytes = 2 * (gsize)work->problem.count * sizeof *work->p;
    double *kept = work->lcp;
    memcpy(kept, work->p, bytes);
    if (tinker_contact_try_states(work, tolerance, NULL)) return TRUE;
    memcpy(work->p, kept, bytes);
    return tinker_contact_check(work, tolerance, NULL);
}

static gboolean by_complementarity(TinkerContactWork *work, double tolerance)
{
    return tinker_contact_by_complementarity(work, 0, NULL) && settle(work, tolerance);
}

/* The proximal point method: the softened problem again and again, with the springs that soften it at rest where the
 * last impulses were, so that they press no more in the end. Each solve is well posed however singular W is. Source:
 * Rockafellar, "Monotone operators and the proximal point algorithm", SIAM J. Control Optim. 14 (1976) 877-898. */
static gboolean by_proximal_points(TinkerContactWork *work, double softening, double tolerance)
{
    double *centre = work->centre;
    gsize width = 2 * (gsize)work->problem.count;
    memset(centre, 0, width * sizeof *centre);
    for (int32_t pass = 0; pass < MOST_PASSES; pass++) {
        if (!tinker_contact_by_complementarity(work, softening, centre)) return FALSE;
        memcpy(centre, work->p, width * sizeof *centre);
        if (settle(work, tolerance)) return TRUE;
    }
    return FALSE;
}

static void read_states(TinkerContactWork *work)
{
    const TinkerContactProblem *problem = &work->problem;
    for (int32_t k = 0; k < problem->count; k++) {
        const double pn = tinker_contact_normal(problem, work->p, k), pt = work->p[2 * k + 1];
        work->state[k] = !(pn > 0)                                                      ? TINKER_STATE_OPEN
                         : !tinker_contact_grips(problem, k)                            ? TINKER_STATE_FREE
                         : fabs(pt) < (1 - TINKER_AT_BOUND) * problem->friction[k] * pn ? TINKER_STATE_STICK
                         : pt < 0                                                       ? TINKER_STATE_FORWARD
                                                                                        : TINKER_STATE_BACKWARD;
    }
}

/* Sweeps do not end in rays, and tell in the end what every contact does. */
static gboolean by_sweeps(TinkerContactWork *work, int most, double tolerance)
{
    double *swept = work->centre;
    const gsize bytes = 2 * (gsize)work->problem.count * sizeof *swept;
    memset(swept, 0, bytes);
    for (int sweeps = 1; sweeps <= most; sweeps++) {
        tinker_contact_sweep(&work->problem, swept);
        if (sweeps % SWEEPS_BETWEEN != 0) continue;
        memcpy(work->p, swept, bytes);
        read_states(work);
        if (settle(work, tolerance)) return TRUE;
    }
    return FALSE;
}

static gboolean try_all(TinkerContactWork *work, double tolerance)
{
    const TinkerContactProblem *problem = &work->problem;
    int32_t m = problem->count;
    for (int32_t code = 0; code < 1 << 2 * m; code++) {
        gboolean fits = TRUE;
        for (int32_t k = 0; k < m; k++) {
            TinkerContactState state = (TinkerContactState)(code >> 2 * k & 3);
            gboolean grips = tinker_contact_grips(problem, k);
            fits = fits && (grips || state <= TINKER_STATE_STICK);
            work->state[k] = !grips && state == TINKER_STATE_STICK ? TINKER_STATE_FREE : state;
        }
        if (fits && tinker_contact_try_states(work, tolerance, NULL)) return TRUE;
    }
    return FALSE;
}

/* By pivots alone, whatever states that leads to: what hangs on rounding keeps the laws nearly. */
static gboolean by_pivots(TinkerContactWork *work)
{
    for (gsize i = 0; i < G_N_ELEMENTS(softest); i++) {
        if (!tinker_contact_by_complementarity(work, softest[i], NULL)) continue;
        if (settle(work, TINKER_LOOSE) || tinker_contact_miss(work) <= TINKER_PIVOTED) return TRUE;
    }
    return FALSE;
}

static TinkerContactResult solve_several(TinkerContactWork *work, TinkerContactState *next)
{
    const TinkerContactProblem *problem = &work->problem;
    if (!isfinite(work->unit)) return TINKER_CONTACT_GAVE_UP;
    /* to rounding, else near enough: where one contact is about to do something else, a loose answer is a poor one */
    for (int32_t pass = 0; pass < 2; pass++) {
        double tolerance = pass == 0 ? TINKER_GUESS_ROUNDING : TINKER_LOOSE;
        const gboolean found =
            guess(work, tolerance, next) || (problem->count > MANY && by_sweeps(work, SWEEPS_FIRST, tolerance)) ||
            by_complementarity(work, tolerance) || (problem->count <= FEW && try_all(work, tolerance));
        if (found && pass == 0 && !problem->any) tinker_contact_take_least(work, tolerance, next);
        if (found) return TINKER_CONTACT_SOLVED;
    }
    /* rods tie contacts together: velocities that contradict one another by rounding have no better answer */
    work->floor = 1;
    for (gsize i = 0; i < G_N_ELEMENTS(softenings); i++)
        if (by_proximal_points(work, softenings[i], TINKER_LOOSE)) return TINKER_CONTACT_SOLVED;
    if (problem->count > MANY && by_sweeps(work, MOST_SWEEPS, TINKER_LOOSE)) return TINKER_CONTACT_SOLVED;
    return by_pivots(work) ? TINKER_CONTACT_SOLVED : TINKER_CONTACT_NO_ACCELERATION;
}

/* Without W, or with it after all. */
static TinkerContactResult solve_many(const TinkerContactProblem *problem, double *p)
{
    const TinkerContactMotion *motion = problem->motion;
    const TinkerContactResult result = tinker_contact_solve_many(problem, p);
    if (result != TINKER_CONTACT_GAVE_UP) return result;
    const gsize width = 2 * (gsize)problem->count;
    if (problem->count > MOST_WRITTEN) return TINKER_CONTACT_GAVE_UP;
    g_autofree double *matrix = g_try_new(double, width *width), *unit = g_try_new0(double, 2 * width);
    if (matrix == NULL || unit == NULL) return TINKER_CONTACT_NO_MEMORY;
    for (gsize j = 0; j < width; j++) {
        unit[j] = 1;
        motion->times(motion->context, unit, unit + width, NULL);
        unit[j] = 0;
        for (gsize i = 0; i < width; i++)
            matrix[i * width + j] = unit[width + i];
    }
    TinkerContactProblem written = *problem;
    written.delassus = matrix;
    return tinker_contact_solve(&written, p);
}

/* What was found, in the units of the problem; nothing where there is no answer. */
static void write_found(const TinkerContactWork *work, const TinkerContactProblem *problem, gboolean any, double *p)
{
    for (int32_t k = 0; k < problem->count; k++) {
        const double normal = tinker_contact_normal(&work->problem, work->p, k);
        const gboolean pushes = any && normal > 0;
        const double factor = work->scale[k] * work->unit, most = problem->friction[k] * normal;
        p[2 * k] = pushes ? work->p[2 * k] * factor : 0;
        p[2 * k + 1] = pushes ? CLAMP(work->p[2 * k + 1], -most, most) * factor : 0;
    }
}

TinkerContactResult tinker_contact_solve(const TinkerContactProblem *problem, double *p)
{
    int32_t m = problem->count;
    if (m <= 0) return TINKER_CONTACT_SOLVED;
    if (problem->delassus == NULL) return solve_many(problem, p);
    if (m == 1) return solve_single(problem, p);
    double small[SMALL_ROOM];
    g_autofree double *large = room_of(m) > SMALL_ROOM ? g_try_new(double, room_of(m)) : NULL;
    if (room_of(m) > SMALL_ROOM && large == NULL) return TINKER_CONTACT_NO_MEMORY;
    TinkerContactWork work;
    set_up(&work, problem, large != NULL ? large : small);
    TinkerContactResult result = solve_several(&work, work.state + m);
    write_found(&work, problem, result == TINKER_CONTACT_SOLVED, p);
    return result == TINKER_CONTACT_SOLVED && work.blocked ? TINKER_CONTACT_NO_ACCELERATION : result;
}

size_t tinker_impact_pivot_room(int32_t count)
{
    return room_of(count) + 2 * (gsize)count;
}

int tinker_impact_pivot(const TinkerImpact *impact, double *room, double *impulses)
{
    const TinkerContactProblem problem = {impact->count, impact->delassus, room, impact->friction, NULL,
                                          NULL,          impact->bearer};
    for (int32_t i = 0; i < 2 * impact->count; i++)
        room[i] = impact->velocity[i] - (i % 2 == 0 ? impact->least[i / 2] : 0);
    TinkerContactWork work;
    set_up(&work, &problem, room + 2 * impact->count);
    const gboolean found = isfinite(work.unit) && by_pivots(&work);
    if (found) write_found(&work, &problem, TRUE, impulses);
    return found;
}

/* The laws for very many contacts, whose W is known by what it does: what each contact does is guessed, the impulses
 * follow from one solve, and whatever breaks a law changes what it does. That ends soon or goes in circles. Then the
 * impulses are approached by splitting (the alternating direction method of multipliers): by turns
 *
 *     p = -(W + rho)^-1 (b + gamma - rho (z - y)),   z = the nearest to p + y in the cones of friction,   y += p - z,
 *
 * with gamma = friction |v_t| along each normal, which makes Coulomb's law one of complementarity in cones (De Saxce);
 * -rho y becomes v + gamma. What it takes z for is a better guess now and then.
 *
 * Sources: Judice, Pires, "A block principal pivoting algorithm for large-scale strictly monotone linear
 * complementarity problems", Computers & Operations Research 21 (1994) 587-596; Carpentier, Montaut, Le Lidec, "From
 * compliant to rigid contact simulation: a unified and efficient approach", RSS 2024; Boyd et al., "Distributed
 * optimization and statistical learning via the alternating direction method of multipliers" (2011), sections 3.3
 * and 3.4. Where neither ends, whoever asks has to write W down. */
#include <math.h>
#include <string.h>

#include "numerics/contact/contact-private.h"
#include "numerics/contact/tolerances.h"
#include "numerics/solve/power-of-two.h"

/* Guesses that are followed from the offsets, and from what splitting gave. */
#define FIRST_GUESSES 8
#define LATER_GUESSES 1
/* Splitting: steps between guesses, and at most; how far a step goes (1 to 2). */
#define STEPS_BETWEEN 10
#define MOST_STEPS    600
#define RELAXATION    1.6
/* Its softness, where W is about 1: at first; how much it changes at once, to balance what is left to be done on both
 * sides; bounds. */
#define SOFTNESS   0.1
#define UNBALANCED 5.0
#define LEAST_SOFT 1e-6
#define MOST_SOFT  1e3
/* gamma goes so much of its way at once: with all of it contacts may swing between sticking and slipping. */
#define FOLLOWING 0.3
/* Sides that come no nearer to each other than by this share: what is asked for contradicts itself, or nearly, and
 * impulses grow until friction lets go. The softer, the faster. Where they still do after a while they grow without
 * bound. */
#define STALLED      0.9
#define LET_GO       0.2
#define MOST_STALLED 8

typedef struct {
    TinkerContactWork work; /* scaled, but for what only a written matrix needs */
    const TinkerContactMotion *motion;
    double *slope;         /* m */
    double *right, *raw;   /* 2m: right-hand side; impulses and velocities in their own units */
    double *z, *y, *gamma; /* 2m, 2m, m: of splitting */
    double rho;
    int8_t *unknown; /* 2m */
    TinkerContactState *next;
} Many;

static gsize room_of(gsize m)
{
    /* scale, slope; offset, p, v, size, right, raw, z, y; gamma; states, unknowns */
    return 2 * m + 8 * 2 * m + m + 2 * m * sizeof(TinkerContactState) / sizeof(double) + 2 + 2 * m / sizeof(double) + 2;
}

/* What a contact that closes would do by itself: it slips on where it is too fast to be stopped along the top. */
static TinkerContactState state_by_itself(const TinkerContactProblem *problem, int32_t k, double normal, double along)
{
    if (!tinker_contact_grips(problem, k)) return TINKER_STATE_FREE;
    if (problem->sliding != NULL || fabs(along) <= fmax(-problem->friction[k] * normal, TINKER_RESTING))
        return TINKER_STATE_STICK;
    return along > 0 ? TINKER_STATE_FORWARD : TINKER_STATE_BACKWARD;
}

/* From the offsets alone. One that rests while others strike is pressed by them, as likely as not. */
static TinkerContactState first_guess(const TinkerContactProblem *problem, int32_t k)
{
    const double normal = problem->offset[2 * k], along = problem->offset[2 * k + 1];
    if (problem->sliding != NULL ? normal >= 0 : normal > TINKER_RESTING) return TINKER_STATE_OPEN;
    return state_by_itself(problem, k, normal, along);
}

static void set_up(Many *many, const TinkerContactProblem *problem, double *room)
{
    const gsize m = (gsize)problem->count;
    double largest = 0, *offset = room + 2 * m;
    TinkerContactWork *work = &many->work;
    *many = (Many){.motion = problem->motion, .slope = room + m};
    *work = (TinkerContactWork){.problem = *problem, .scale = room, .floor = 1e-3};
    work->problem.offset = offset;
    work->p = offset + 2 * m;
    work->v = work->p + 2 * m;
    work->size = work->v + 2 * m;
    many->right = work->size + 2 * m;
    many->raw = many->right + 2 * m;
    many->z = many->raw + 2 * m;
    many->y = many->z + 2 * m;
    many->gamma = many->y + 2 * m;
    work->state = (TinkerContactState *)(void *)(many->gamma + m);
    many->next = work->state + m;
    many->unknown = (int8_t *)(many->next + m);
    for (gsize k = 0; k < m; k++) {
        work->scale[k] = sqrt(problem->motion->mass[k]);
        for (gsize i = 2 * k; i < 2 * k + 2; i++)
            largest = MAX(largest, fabs(problem->offset[i]) * work->scale[k]);
    }
    work->unit = largest > 0 ? tinker_power_of_two(largest) : 1;
    for (gsize i = 0; i < 2 * m; i++)
        offset[i] = problem->offset[i] * work->scale[i / 2] / work->unit;
    for (int32_t k = 0; k < problem->count; k++)
        work->state[k] = first_guess(&work->problem, k);
}

/* p of the states, v of p. FALSE where they cannot be solved for. */
static gboolean solve_states(Many *many)
{
    TinkerContactWork *work = &many->work;
    const int32_t m = work->problem.count;
    for (int32_t k = 0; k < m; k++) {
        const double back = -work->unit / work->scale[k];
        many->unknown[2 * k] = work->state[k] != TINKER_STATE_OPEN;
        many->unknown[2 * k + 1] = work->state[k] == TINKER_STATE_STICK;
        many->slope[k] = tinker_contact_slope(&work->problem, k, work->state[k]);
        many->right[2 * k] = back * work->problem.offset[2 * k];
        many->right[2 * k + 1] = back * work->problem.offset[2 * k + 1];
    }
    if (!many->motion->solve(many->motion->context, many->unknown, many->slope, many->right, many->raw, work->v,
                             work->size))
        return FALSE;
    for (int32_t i = 0; i < 2 * m; i++) {
        const double own = work->scale[i / 2] / work->unit, offset = work->problem.offset[i];
        work->p[i] = many->raw[i] / (work->scale[i / 2] * work->unit);
        work->v[i] = work->v[i] * own + offset;
        work->size[i] = work->size[i] * own + fabs(offset);
    }
    return TRUE;
}

/* Follows guesses from the states on. */
static gboolean guess(Many *many, int most, double tolerance)
{
    TinkerContactWork *work = &many->work;
    const gsize bytes = (gsize)work->problem.count * sizeof *many->next;
    for (int tries = 0; tries < most; tries++) {
        if (!solve_states(many)) return FALSE;
        if (tinker_contact_judge(work, tolerance, many->next)) return TRUE;
        for (int32_t k = 0; k < work->problem.count; k++)
            if (work->state[k] == TINKER_STATE_OPEN && many->next[k] == TINKER_STATE_STICK)
                many->next[k] = state_by_itself(&work->problem, k, work->v[2 * k], work->v[2 * k + 1]);
        if (memcmp(many->next, work->state, bytes) == 0) return FALSE;
        memcpy(work->state, many->next, bytes);
    }
    return FALSE;
}

/* Splitting -------------------------------------------------------------------------------------------------------- */

/* All contacts are closed, and those that may stick do, for the solve. */
static void soften(Many *many)
{
    const TinkerContactProblem *problem = &many->work.problem;
    for (int32_t k = 0; k < problem->count; k++) {
        many->unknown[2 * k] = TRUE;
        many->unknown[2 * k + 1] = tinker_contact_grips(problem, k);
        many->slope[k] = tinker_contact_slope(problem, k, TINKER_STATE_FREE);
    }
    many->motion->soften(many->motion->context, many->unknown, many->slope, many->rho);
}

/* The nearest to (n, t) in the cone of a friction, in place of it. */
static void project(double friction, double *n, double *t)
{
    const double along = fabs(*t);
    if (along <= friction * *n) return;
    if (friction * along <= -*n) {
        *n = *t = 0;
        return;
    }
    const double normal = (*n + friction * along) / (1 + friction * friction);
    *t = copysign(friction * normal, *t);
    *n = normal;
}

/* What contact k does by z, which lies on the bound of its cone where it was brought there. */
static TinkerContactState state_by(const Many *many, int32_t k)
{
    const TinkerContactProblem *problem = &many->work.problem;
    const double n = many->z[2 * k], t = many->z[2 * k + 1];
    if (!(n > 0)) return TINKER_STATE_OPEN;
    if (!tinker_contact_grips(problem, k)) return TINKER_STATE_FREE;
    if (fabs(t) < problem->friction[k] * n * (1 - 1e-12)) return TINKER_STATE_STICK;
    return t < 0 ? TINKER_STATE_FORWARD : TINKER_STATE_BACKWARD;
}

static void solve_softly(Many *many)
{
    TinkerContactWork *work = &many->work;
    const TinkerContactProblem *problem = &work->problem;
    for (int32_t k = 0; k < problem->count; k++) {
        const double slides = many->rho * fabs(many->y[2 * k + 1]);
        if (many->unknown[2 * k + 1]) many->gamma[k] += FOLLOWING * (problem->friction[k] * slides - many->gamma[k]);
        for (int32_t i = 2 * k; i < 2 * k + 2; i++) {
            double asked = many->rho * (many->z[i] - many->y[i]) - problem->offset[i];
            if (i == 2 * k) asked -= many->gamma[k];
            many->right[i] = asked * work->unit / work->scale[k];
        }
    }
    many->motion->solve_soft(many->motion->context, many->right, many->raw);
    for (int32_t i = 0; i < 2 * problem->count; i++)
        work->p[i] = many->raw[i] / (work->scale[i / 2] * work->unit);
}

/* One step; answers by how much the two sides miss each other, and z itself moved. */
static void split(Many *many, double *apart, double *moved)
{
    const TinkerContactProblem *problem = &many->work.problem;
    solve_softly(many);
    *apart = *moved = 0;
    for (int32_t k = 0; k < problem->count; k++) {
        double *z = many->z + 2 * k, *y = many->y + 2 * k, ahead[2], next[2];
        for (int i = 0; i < 2; i++)
            next[i] = ahead[i] = RELAXATION * many->work.p[2 * k + i] + (1 - RELAXATION) * z[i] + y[i];
        if (many->unknown[2 * k + 1]) {
            project(problem->friction[k], &next[0], &next[1]);
        } else {
            next[0] = fmax(next[0], 0);
            ahead[1] = next[1] = 0;
        }
        for (int i = 0; i < 2; i++) {
            if (i == 0 || many->unknown[2 * k + 1]) {
                *apart = fmax(*apart, fabs(many->work.p[2 * k + i] - next[i]));
                *moved = fmax(*moved, fabs(next[i] - z[i]));
            }
            y[i] = ahead[i] - next[i];
            z[i] = next[i];
        }
    }
}

static void set_softness(Many *many, double rho)
{
    const double before = many->rho;
    many->rho = CLAMP(rho, LEAST_SOFT, MOST_SOFT);
    for (int32_t i = 0; i < 2 * many->work.problem.count; i++)
        many->y[i] *= before / many->rho;
}

/* A softness that balances what is left to be done on both sides. */
static void balance(Many *many, double apart, double moved)
{
    const double ratio = moved > 0 ? sqrt(apart / (many->rho * moved)) : 1;
    if (ratio <= 0.5 || ratio >= 2) set_softness(many, many->rho * CLAMP(ratio, 1 / UNBALANCED, UNBALANCED));
}

/* `near`: z will do, so that both sides meet but for this share of the largest velocity; 0: only what keeps the laws to
 * rounding. */
static gboolean by_splitting(Many *many, double near)
{
    const gsize m = (gsize)many->work.problem.count;
    double apart, moved, before = INFINITY;
    int stalled = 0;
    memset(many->z, 0, 5 * m * sizeof(double)); /* y and gamma as well */
    many->rho = SOFTNESS;
    for (int steps = 0; steps < MOST_STEPS; steps += STEPS_BETWEEN) {
        soften(many);
        for (int k = 0; k < STEPS_BETWEEN; k++)
            split(many, &apart, &moved);
        for (gsize k = 0; k < m; k++)
            many->work.state[k] = state_by(many, (int32_t)k);
        if (guess(many, LATER_GUESSES, 2 * steps < MOST_STEPS ? TINKER_MANY_ROUNDING : TINKER_LOOSE)) return TRUE;
        const gboolean stalls = apart > STALLED * before;
        before = apart;
        if (!stalls) {
            if (stalled == 0) balance(many, apart, moved);
            continue;
        }
        if (many->rho * apart <= near || ++stalled > MOST_STALLED) break;
        set_softness(many, LET_GO * many->rho);
    }
    memcpy(many->work.p, many->z, 2 * m * sizeof(double));
    return many->rho * apart <= TINKER_MANY_NEARLY * near;
}

static gboolean find(Many *many, double near)
{
    return guess(many, FIRST_GUESSES, TINKER_MANY_ROUNDING) || by_splitting(many, near);
}

static void write_found(const Many *many, double *p)
{
    const TinkerContactWork *work = &many->work;
    for (int32_t k = 0; k < work->problem.count; k++) {
        const double *found = work->p + 2 * k, factor = work->scale[k] * work->unit;
        const double most = work->problem.friction[k] * found[0];
        p[2 * k] = found[0] > 0 ? found[0] * factor : 0;
        p[2 * k + 1] = found[0] > 0 ? CLAMP(found[1], -most, most) * factor : 0;
    }
}

TinkerContactResult tinker_contact_solve_many(const TinkerContactProblem *problem, double *p)
{
    g_autofree double *room = g_try_new(double, room_of((gsize)problem->count));
    Many many;
    if (room == NULL) return TINKER_CONTACT_NO_MEMORY;
    set_up(&many, problem, room);
    if (!isfinite(many.work.unit)) return TINKER_CONTACT_GAVE_UP;
    if (!find(&many, 0)) return TINKER_CONTACT_GAVE_UP;
    write_found(&many, p);
    return TINKER_CONTACT_SOLVED;
}

size_t tinker_impact_guess_room(int32_t count)
{
    return room_of((gsize)count) + 2 * (gsize)count;
}

TinkerImpactGuess tinker_impact_guess(const TinkerImpact *impact, double *room, double *impulses)
{
    double *offset = room, sum = 0;
    const TinkerContactProblem problem = {impact->count, NULL, offset, impact->friction, NULL, impact->motion};
    Many many;
    for (int32_t i = 0; i < 2 * impact->count; i++)
        offset[i] = impact->velocity[i] - (i % 2 == 0 ? impact->least[i / 2] : 0);
    set_up(&many, &problem, room + 2 * impact->count);
    if (!isfinite(many.work.unit)) return TINKER_IMPACT_NO_NUMBER;
    const gboolean met = find(&many, TINKER_MANY_NEAR);
    write_found(&many, impulses);
    for (int32_t i = 0; i < 2 * impact->count; i++)
        sum += impulses[i];
    return !isfinite(sum) ? TINKER_IMPACT_NO_NUMBER : met ? TINKER_IMPACT_MET : TINKER_IMPACT_APPROACHED;
}

/* Poisson's second phase is a problem of its own, p_n >= e p of the first with friction up to mu p_n: by projected
 * Gauss-Seidel, which converges for what touches at no more points than determine it; elsewhere it may come to no end,
 * and what still approaches then is brought to rest. */
#include "numerics/contact/impact-law.h"

#include <math.h>
#include <string.h>

#include "numerics/contact/contact-private.h"
#include "numerics/contact/tolerances.h"
#include "numerics/roots/step-roots.h"

/* Of the second phase; and blows in sequence, after which what still approaches is brought to rest at once. */
#define MOST_SWEEPS 20000
#define MOST_BLOWS  20000

static double largest_of(const TinkerImpact *impact)
{
    double largest = 0;
    for (int32_t i = 0; i < 2 * impact->count; i++)
        largest = fmax(largest, fabs(impact->velocity[i]));
    return largest;
}

/* u += W p. */
static void add_motion(const TinkerImpact *impact, const double *p, double *u)
{
    const gsize width = 2 * (gsize)impact->count;
    for (gsize i = 0; i < width; i++)
        for (gsize k = 0; k < width; k++)
            u[i] += impact->delassus[i * width + k] * p[k];
}

static gsize bearer_of(const TinkerImpact *impact, gsize k)
{
    return impact->bearer != NULL ? (gsize)impact->bearer[k] : k;
}

static double bound_of(const TinkerImpact *impact, gsize k, const double *p)
{
    if (impact->bearer != NULL && impact->bearer[k] < 0) return impact->friction[k];
    return impact->friction[k] * p[2 * bearer_of(impact, k)];
}

/* Of contacts that may come together by blows at others alone, which Newton's law does not ask about. */
static const double *restitution_of(const TinkerImpact *impact)
{
    return impact->driven != NULL ? impact->driven : impact->restitution;
}

/* Poisson's -------------------------------------------------------------------------------------------------------- */

/* One sweep of the second phase over all contacts; answers the largest change of a velocity. */
static double sweep(const TinkerImpact *impact, const double *least, double *p, double *u)
{
    const gsize width = 2 * (gsize)impact->count;
    double most = 0;
    for (gsize i = 0; i < width; i++) {
        const gsize k = i / 2;
        const double own = impact->delassus[i * width + i], limit = bound_of(impact, k, p);
        if (!(own > 0)) continue;
        const double wanted = p[i] - u[i] / own;
        const double next = i % 2 == 0 ? fmax(wanted, least[k]) : fmax(-limit, fmin(wanted, limit));
        const double change = next - p[i];
        for (gsize row = 0; row < width; row++)
            u[row] += impact->delassus[row * width + i] * change;
        most = fmax(most, fabs(own * change));
        p[i] = next;
    }
    return most;
}

typedef struct {
    const TinkerImpact *impact;
    const double *first; /* 2m: impulses of the first phase, */
    const double *rest;  /* 2m: and velocities behind it */
    const double *none;  /* m: no restitution */
    double *second, *u, *least, *third;
} Phases;

/* Where sweeps did not come to an end, what still approaches is brought to rest at once, which gains no energy. */
static void end_sweeps(const Phases *self)
{
    const TinkerImpact *impact = self->impact;
    const TinkerImpact last = {impact->count, impact->delassus, self->u, self->none, impact->friction, NULL,
                               NULL,          impact->bearer};
    if (tinker_impact_solve(&last, self->third) != TINKER_CONTACT_SOLVED) return;
    add_motion(impact, self->third, self->u);
    for (int32_t i = 0; i < 2 * impact->count; i++)
        self->second[i] += self->third[i];
}

/* The second phase with a share of the restitution; answers what energy both phases took, 0 where that is rounding. */
static double expand(void *data, double share)
{
    const Phases *self = data;
    const TinkerImpact *impact = self->impact;
    const gsize width = 2 * (gsize)impact->count;
    const double *restitution = restitution_of(impact), enough = 1e-16 * largest_of(impact);
    memset(self->second, 0, width * sizeof(double));
    memcpy(self->u, self->rest, width * sizeof(double));
    for (int32_t k = 0; k < impact->count; k++)
        self->least[k] = share * restitution[k] * self->first[2 * k];
    int32_t pass = 0;
    while (pass < MOST_SWEEPS && sweep(impact, self->least, self->second, self->u) > enough)
        pass++;
    if (pass == MOST_SWEEPS) end_sweeps(self);
    double gained = 0, size = 0;
    for (gsize i = 0; i < width; i++) {
        const double p = self->first[i] + self->second[i];
        gained += p * (impact->velocity[i] + self->u[i]) / 2;
        size += fabs(p) * (fabs(impact->velocity[i]) + fabs(self->u[i]));
    }
    return gained <= 1e-12 * size ? fmax(-gained, 0) : -gained;
}

static double expand_or_none(void *data, double share)
{
    const double lost = expand(data, share);
    return lost == 0 ? 1e-300 : lost; /* what is rounding counts as a little lost */
}

static TinkerContactResult strike_in_phases(const TinkerImpact *impact, double *impulses)
{
    const gsize m = (gsize)impact->count;
    g_autofree double *room = g_try_new0(double, 10 * m);
    if (room == NULL) return TINKER_CONTACT_NO_MEMORY;
    double *none = room, *rest = none + m, *second = rest + 2 * m, *u = second + 2 * m, *least = u + 2 * m,
           *third = least + m;
    TinkerImpact compression = *impact;
    compression.restitution = none;
    const TinkerContactResult result = tinker_impact_solve(&compression, impulses);
    if (result != TINKER_CONTACT_SOLVED) return result;
    memcpy(rest, impact->velocity, 2 * m * sizeof(double));
    add_motion(impact, impulses, rest);
    Phases phases = {impact, impulses, rest, none, second, u, least, third};
    double share = 1;
    if (expand(&phases, share) < 0) {
        share = tinker_step_refine(0, 1, expand_or_none, &phases);
        for (double back = 1e-15; expand(&phases, share) < 0 && share > 0; back *= 4)
            share = fmax(share - back, 0);
    }
    for (gsize i = 0; i < 2 * m; i++)
        impulses[i] += second[i];
    return result;
}

/* In sequence ------------------------------------------------------------------------------------------------------ */

/* The pair that approaches fastest; -1: none does. */
static int32_t next_pair(const TinkerImpact *impact, const int32_t *pair, const double *u, double still)
{
    double fastest = -still;
    int32_t next = -1;
    for (int32_t k = 0; k < impact->count; k++) {
        if (!(u[2 * k] < fastest)) continue;
        fastest = u[2 * k];
        next = pair[k];
    }
    return next;
}

/* The part of an impact that one pair has in it. */
typedef struct {
    int32_t count, *member, *bearer;
    double *delassus, *velocity, *restitution, *friction, *impulses;
} Part;

static void take_part(Part *part, const TinkerImpact *impact, const int32_t *pair, int32_t number, const double *u)
{
    const gsize width = 2 * (gsize)impact->count;
    const double *restitution = restitution_of(impact);
    part->count = 0;
    for (int32_t k = 0; k < impact->count; k++) {
        if (pair[k] != number) continue;
        part->restitution[part->count] = restitution[k];
        part->friction[part->count] = impact->friction[k];
        part->bearer[part->count] = impact->bearer != NULL && impact->bearer[k] < 0 ? -1 : part->count;
        for (int32_t i = 0; i < part->count; i++)
            if (part->member[i] == (int32_t)bearer_of(impact, (gsize)k)) part->bearer[part->count] = i;
        part->member[part->count++] = k;
    }
    for (int32_t i = 0; i < 2 * part->count; i++) {
        const gsize row = 2 * (gsize)part->member[i / 2] + i % 2;
        part->velocity[i] = u[row];
        for (int32_t k = 0; k < 2 * part->count; k++)
            part->delassus[i * 2 * part->count + k] =
                impact->delassus[row * width + 2 * (gsize)part->member[k / 2] + k % 2];
    }
}

/* Lets its impulses act on all; answers whether that changes a velocity. */
static gboolean put_part(const Part *part, const TinkerImpact *impact, double *impulses, double *u)
{
    const gsize width = 2 * (gsize)impact->count;
    gboolean changes = FALSE;
    for (int32_t i = 0; i < 2 * part->count; i++) {
        const gsize at = 2 * (gsize)part->member[i / 2] + i % 2;
        impulses[at] += part->impulses[i];
        for (gsize row = 0; row < width; row++) {
            const double before = u[row];
            u[row] += impact->delassus[row * width + at] * part->impulses[i];
            changes |= u[row] != before;
        }
    }
    return changes;
}

static TinkerContactResult strike_part(const Part *part)
{
    const TinkerImpact impact = {part->count,    part->delassus, part->velocity, part->restitution,
                                 part->friction, NULL,           NULL,           part->bearer};
    return tinker_impact_solve(&impact, part->impulses);
}

/* What has not ended after so many blows, and what is left by rounding. */
static TinkerContactResult bring_to_rest(const TinkerImpact *impact, Part *part, double *impulses, double *u)
{
    const gsize width = 2 * (gsize)impact->count;
    gboolean any = FALSE;
    for (int32_t k = 0; k < impact->count; k++)
        any |= u[2 * k] < 0;
    if (!any) return TINKER_CONTACT_SOLVED;
    memset(part->restitution, 0, (gsize)impact->count * sizeof(double));
    const TinkerImpact last = {impact->count, impact->delassus, u, part->restitution, impact->friction, NULL,
                               NULL,          impact->bearer};
    const TinkerContactResult result = tinker_impact_solve(&last, part->impulses);
    for (gsize i = 0; result == TINKER_CONTACT_SOLVED && i < width; i++)
        impulses[i] += part->impulses[i];
    return result;
}

static TinkerContactResult strike_in_sequence(const TinkerImpact *impact, const int32_t *pair, double *impulses)
{
    const gsize m = (gsize)impact->count;
    g_autofree double *room = g_try_new0(double, 4 * m * m + 8 * m);
    g_autofree int32_t *member = g_try_new(int32_t, 2 * m);
    if (room == NULL || member == NULL) return TINKER_CONTACT_NO_MEMORY;
    double *u = room + 4 * m * m;
    Part part = {0, member, member + m, room, u + 2 * m, u + 4 * m, u + 5 * m, u + 6 * m};
    const double still = TINKER_SEQUENCE_STILL * largest_of(impact);
    memcpy(u, impact->velocity, 2 * m * sizeof(double));
    memset(impulses, 0, 2 * m * sizeof(double));
    for (int32_t blow = 0; blow < MOST_BLOWS; blow++) {
        const int32_t next = next_pair(impact, pair, u, still);
        if (next < 0) break;
        take_part(&part, impact, pair, next, u);
        const TinkerContactResult result = strike_part(&part);
        if (result != TINKER_CONTACT_SOLVED) return result;
        if (!put_part(&part, impact, impulses, u)) break; /* what approaches is rounding to the pair's own blow */
    }
    return bring_to_rest(impact, &part, impulses, u);
}

TinkerContactResult tinker_impact_by_law(TinkerImpactLaw law, const TinkerImpact *impact, const int32_t *pair,
                                         double *impulses)
{
    if (law == TINKER_IMPACT_NEWTON || impact->delassus == NULL) return tinker_impact_solve(impact, impulses);
    return law == TINKER_IMPACT_POISSON ? strike_in_phases(impact, impulses)
                                        : strike_in_sequence(impact, pair, impulses);
}

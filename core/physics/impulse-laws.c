/* The laws of several contacts at once: to rounding where they are few, by projected Gauss-Seidel where they are many. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/impulse-private.h"

#define MOST_SWEEPS 500
/* Changes of velocities below this share of the largest end the sweeps. */
#define CONVERGED 1e-14
/* Friction nearer to its bound than this share holds no more. */
#define AT_BOUND 1e-9

static double friction_of(const TinkerImpulses *self, const TinkerImpulseTouch *touch)
{
    const TinkerImpulsePlate *plate = &self->plates[touch->plate];
    return touch->was == TINKER_CONTACT_STICK ? plate->static_friction : plate->dynamic_friction;
}

static double velocity_at(const TinkerImpact *impact, const double *impulses, int32_t i)
{
    const double *row = impact->delassus + (gsize)i * 2 * (gsize)impact->count;
    double sum = impact->velocity[i];
    for (int32_t j = 0; j < 2 * impact->count; j++)
        sum += row[j] * impulses[j];
    return sum;
}

/* One sweep over all contacts; answers the largest change of a velocity. */
static double sweep(const TinkerImpact *impact, double *impulses)
{
    double most = 0;
    const gsize width = 2 * (gsize)impact->count;
    for (int32_t k = 0; k < impact->count; k++) {
        for (int32_t i = 2 * k; i < 2 * k + 2; i++) {
            const double own = impact->delassus[(gsize)i * width + (gsize)i], before = impulses[i];
            if (!(own > 0)) continue;
            const double asked = i == 2 * k ? impact->least[k] : 0;
            const double wanted = before - (velocity_at(impact, impulses, i) - asked) / own;
            const double bound = i == 2 * k ? INFINITY : impact->friction[k] * impulses[2 * k];
            impulses[i] = CLAMP(wanted, i == 2 * k ? 0 : -bound, bound);
            most = fmax(most, own * fabs(impulses[i] - before));
        }
    }
    return most;
}

static gboolean solve_by_sweeps(const TinkerImpact *impact, double *impulses)
{
    double scale = 0;
    memset(impulses, 0, 2 * (gsize)impact->count * sizeof(double));
    for (int32_t i = 0; i < 2 * impact->count; i++)
        scale = fmax(scale, fabs(impact->velocity[i] - (i % 2 == 0 ? impact->least[i / 2] : 0)));
    for (int sweeps = 0; sweeps < MOST_SWEEPS; sweeps++)
        if (sweep(impact, impulses) <= CONVERGED * scale) break;
    return isfinite(scale);
}

static TinkerContactMode mode_of(const double *impulses, double friction)
{
    if (!(impulses[0] > 0)) return TINKER_CONTACT_OPEN;
    const double most = friction * impulses[0];
    if (most > 0 && fabs(impulses[1]) < (1 - AT_BOUND) * most) return TINKER_CONTACT_STICK;
    return impulses[1] > 0 ? TINKER_CONTACT_SLIP_BACKWARD : TINKER_CONTACT_SLIP_FORWARD;
}

/* Whoever begins to slip rubs with its dynamic coefficient. */
static gboolean let_slip(const TinkerImpulses *self, TinkerImpulseTouch *const *touches, int32_t count,
                         const double *impulses, double *friction)
{
    gboolean any = FALSE;
    for (int32_t k = 0; k < count; k++) {
        const double dynamic = self->plates[touches[k]->plate].dynamic_friction;
        const TinkerContactMode mode = mode_of(impulses + 2 * k, friction[k]);
        if (mode == TINKER_CONTACT_OPEN || mode == TINKER_CONTACT_STICK || friction[k] == dynamic) continue;
        friction[k] = dynamic;
        any = TRUE;
    }
    return any;
}

gboolean tinker_impulse_solve_laws(const TinkerImpulses *self, TinkerImpulseTouch **touches, int32_t count,
                                   const double *delassus, const double *velocity, const double *least, double *room)
{
    double *impulses = room, *friction = room + 2 * (gsize)count;
    const TinkerImpact impact = {count, delassus, velocity, NULL, friction, least};
    for (int32_t k = 0; k < count; k++)
        friction[k] = friction_of(self, touches[k]);
    for (int32_t tries = 0; tries <= count; tries++) {
        if (count > TINKER_MOST_TOUCHES ? !solve_by_sweeps(&impact, impulses)
                                        : tinker_impact_solve(&impact, impulses) != TINKER_CONTACT_SOLVED) {
            g_snprintf(self->model->failure, sizeof(self->model->failure),
                       _("no impulses satisfy the laws of impact for all bodies that touch there"));
            return FALSE;
        }
        if (!let_slip(self, touches, count, impulses, friction)) break;
    }
    for (int32_t k = 0; k < count; k++) {
        touches[k]->normal = impulses[2 * k];
        touches[k]->friction = impulses[2 * k + 1];
        touches[k]->is = mode_of(impulses + 2 * k, friction[k]);
    }
    return TRUE;
}

/* The laws of several contacts at once: to rounding where they are few; some more by projected Gauss-Seidel; many
 * without their matrix. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/contact/tolerances.h"
#include "physics/impulse/impulse-private.h"
#include "physics/model/failures.h"

static double friction_of(const TinkerImpulses *self, const TinkerImpulseTouch *touch)
{
    const TinkerSurface surface = tinker_contact_surface(self->contacts, touch->body, touch->plate);
    return touch->was == TINKER_CONTACT_STICK ? surface.static_friction : surface.dynamic_friction;
}

static TinkerContactMode mode_of(const double *impulses, double friction)
{
    if (!(impulses[0] > 0)) return TINKER_CONTACT_OPEN;
    const double most = friction * impulses[0];
    if (most > 0 && fabs(impulses[1]) < (1 - TINKER_AT_BOUND) * most) return TINKER_CONTACT_STICK;
    return impulses[1] > 0 ? TINKER_CONTACT_SLIP_BACKWARD : TINKER_CONTACT_SLIP_FORWARD;
}

/* Whoever begins to slip rubs with its dynamic coefficient. */
static gboolean let_slip(const TinkerImpulses *self, TinkerImpulseTouch *const *touches, int32_t count,
                         const double *impulses, double *friction)
{
    gboolean any = FALSE;
    for (int32_t k = 0; k < count; k++) {
        const double dynamic =
            tinker_contact_surface(self->contacts, touches[k]->body, touches[k]->plate).dynamic_friction;
        const TinkerContactMode mode = mode_of(impulses + 2 * k, friction[k]);
        if (mode == TINKER_CONTACT_OPEN || mode == TINKER_CONTACT_STICK || friction[k] == dynamic) continue;
        friction[k] = dynamic;
        any = TRUE;
    }
    return any;
}

/* `room` holds 2 per contact where there is a matrix. `last`: as near as it comes will do. */
static gboolean solve(const TinkerImpact *impact, gboolean last, double *impulses, double *room)
{
    if (impact->delassus == NULL) {
        const TinkerImpactGuess found = tinker_impact_guess(impact, room, impulses);
        return found == TINKER_IMPACT_MET || (last && found == TINKER_IMPACT_APPROACHED);
    }
    return impact->count > TINKER_MOST_TOUCHES ? tinker_impact_sweep(impact, room, impulses)
                                               : tinker_impact_solve(impact, impulses) == TINKER_CONTACT_SOLVED;
}

gsize tinker_impulse_laws_room(gsize count)
{
    return 4 * count + MAX(tinker_impact_guess_room((int32_t)count), 2 * count);
}

/* Where friction wedges, no impulses bring a body as far out as its gap or its restitution ask for: it comes to rest.
 */
static void ask_for_rest(const TinkerImpulses *self, TinkerImpulseTouch **touches, int32_t count, const double *least,
                         double *rest)
{
    for (int32_t k = 0; k < count; k++) {
        const TinkerImpulsePlate *plate = &self->plates[touches[k]->plate];
        rest[k] = fmin(least[k], tinker_dot(plate->normal, plate->velocity));
    }
}

gboolean tinker_impulse_solve_laws(const TinkerImpulses *self, TinkerImpulseTouch **touches, const TinkerImpact *given,
                                   double *room)
{
    const int32_t count = given->count;
    double *impulses = room, *friction = room + 2 * (gsize)count, *rest = friction + count;
    double *work = rest + count;
    TinkerImpact impact = *given;
    impact.friction = friction;
    for (int32_t k = 0; k < count; k++)
        friction[k] = friction_of(self, touches[k]);
    for (int32_t tries = 0; tries <= count; tries++) {
        impact.least = given->least;
        gboolean solved = solve(&impact, FALSE, impulses, work);
        if (!solved) {
            ask_for_rest(self, touches, count, given->least, rest);
            impact.least = rest;
            solved = solve(&impact, TRUE, impulses, work);
        }
        if (!solved) {
            tinker_model_tell_failure(self->model,
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

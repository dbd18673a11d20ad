/* The laws of contact for one body that no constraint holds: on one plate in closed form, on several together. */
#include <math.h>
#include <string.h>

#include "physics/impulse/impulse-private.h"

/* One contact, in closed form. */
static void solve_single(TinkerImpulseWay *way)
{
    TinkerImpulseTouch *touch = &way->touches[0];
    const TinkerImpulsePlate *plate = tinker_impulse_plate(way, touch);
    const double *n = plate->normal, *w = plate->velocity;
    const double relative[2] = {way->base[0] - w[0], way->base[1] - w[1]}, along = tinker_along(n, relative);
    const double normal = touch->least - tinker_dot(n, way->base);
    if (!(normal >= 0)) {
        touch->normal = touch->friction = 0;
        touch->is = TINKER_CONTACT_OPEN;
        memcpy(way->v, way->base, sizeof(way->v));
        return;
    }
    const double before[2] = {way->start[0] - w[0], way->start[1] - w[1]}, slides = tinker_along(n, before);
    const TinkerSurface surface = tinker_contact_surface(way->run->contacts, way->body, touch->plate);
    const double most = surface.dynamic_friction * normal;
    /* what stands still in the step may stick */
    const gboolean turns = touch->was != TINKER_CONTACT_OPEN && fabs(along) > most && slides * (along > 0 ? 1 : -1) < 0;
    const double holds = touch->was == TINKER_CONTACT_STICK || turns ? surface.static_friction * normal : most;
    touch->normal = normal;
    const gboolean sticks = holds > 0 && fabs(along) <= holds;
    const double left = sticks ? 0 : along > 0 ? MAX(along - most, 0) : MIN(along + most, 0);
    touch->friction = left - along;
    touch->is = sticks ? TINKER_CONTACT_STICK : left >= 0 ? TINKER_CONTACT_SLIP_FORWARD : TINKER_CONTACT_SLIP_BACKWARD;
    const double rises = touch->bounces ? touch->least - tinker_dot(n, w) : 0;
    way->v[0] = w[0] + rises * n[0] + left * n[1];
    way->v[1] = w[1] + rises * n[1] - left * n[0];
}

/* Where contacts leave nothing open the velocity follows from them, to the last bit. */
static void settle(TinkerImpulseWay *way)
{
    const TinkerImpulseTouch *first = NULL;
    for (int32_t k = 0; k < way->count; k++) {
        const TinkerImpulseTouch *touch = &way->touches[k];
        const TinkerImpulsePlate *plate = tinker_impulse_plate(way, touch);
        if (!(touch->normal > 0) || touch->bounces) continue;
        const double *n = plate->normal;
        if (touch->is == TINKER_CONTACT_STICK) {
            memcpy(way->v, plate->velocity, sizeof(way->v));
            return;
        }
        if (first == NULL) {
            first = touch;
            continue;
        }
        const double *m = tinker_impulse_plate(way, first)->normal, turn = m[0] * n[1] - m[1] * n[0];
        if (fabs(turn) < 1e-6) continue;
        const double a = tinker_dot(m, tinker_impulse_plate(way, first)->velocity), b = tinker_dot(n, plate->velocity);
        way->v[0] = (a * n[1] - b * m[1]) / turn;
        way->v[1] = (m[0] * b - n[0] * a) / turn;
        return;
    }
}

static gboolean solve_several(TinkerImpulseWay *way)
{
    enum { WIDTH = 2 * TINKER_MOST_TOUCHES };
    double delassus[WIDTH * WIDTH], velocity[WIDTH], least[TINKER_MOST_TOUCHES], room[6 * TINKER_MOST_TOUCHES];
    TinkerImpulseTouch *touches[TINKER_MOST_TOUCHES];
    double directions[WIDTH][2];
    const int32_t width = 2 * way->count;
    for (int32_t k = 0; k < way->count; k++) {
        const double *n = tinker_impulse_plate(way, &way->touches[k])->normal,
                     *w = tinker_impulse_plate(way, &way->touches[k])->velocity;
        touches[k] = &way->touches[k];
        least[k] = way->touches[k].least;
        memcpy(directions[2 * k], n, sizeof(directions[0]));
        directions[2 * k + 1][0] = n[1];
        directions[2 * k + 1][1] = -n[0];
        velocity[2 * k] = tinker_dot(n, way->base);
        velocity[2 * k + 1] = tinker_along(n, way->base) - tinker_along(n, w);
    }
    for (int32_t i = 0; i < width; i++)
        for (int32_t j = 0; j < width; j++)
            delassus[i * width + j] = tinker_dot(directions[i], directions[j]);
    const TinkerImpact impact = {.count = way->count, .delassus = delassus, .velocity = velocity, .least = least};
    if (!tinker_impulse_solve_laws(way->run, touches, &impact, room)) return FALSE;
    memcpy(way->v, way->base, sizeof(way->v));
    for (int32_t k = 0; k < way->count; k++)
        for (int32_t i = 0; i < 2; i++)
            way->v[i] += touches[k]->normal * directions[2 * k][i] + touches[k]->friction * directions[2 * k + 1][i];
    settle(way);
    return TRUE;
}

/* Work of all impulses that act now, from the velocity before them; relative to plates that stand still. */
static double gained(const TinkerImpulseWay *way)
{
    double work = 0;
    for (int32_t k = 0; k < way->count; k++) {
        const TinkerImpulsePlate *plate = tinker_impulse_plate(way, &way->touches[k]);
        const double mean[2] = {0.5 * (way->base[0] + way->v[0]) - plate->velocity[0],
                                0.5 * (way->base[1] + way->v[1]) - plate->velocity[1]};
        work += way->touches[k].normal * tinker_dot(plate->normal, mean) +
                way->touches[k].friction * tinker_along(plate->normal, mean);
    }
    return work;
}

/* No impact adds energy: where several at once would, none of them bounces. */
gboolean tinker_impulse_solve_way(TinkerImpulseWay *way)
{
    if (way->count == 1) {
        solve_single(way);
        return TRUE;
    }
    if (!solve_several(way)) return FALSE;
    if (!(gained(way) > 0)) return TRUE;
    gboolean any = FALSE;
    for (int32_t k = 0; k < way->count; k++) {
        const TinkerImpulsePlate *plate = tinker_impulse_plate(way, &way->touches[k]);
        any |= way->touches[k].bounces;
        way->touches[k].bounces = FALSE;
        way->touches[k].least = tinker_dot(plate->normal, plate->velocity);
    }
    return !any || solve_several(way);
}

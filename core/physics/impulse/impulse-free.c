/* Bodies that no constraint holds: each goes its own way through the step, straight from plate to plate.
 *
 * The velocity at the start of a step belongs to its middle rather, half a step back, as in all such methods
 * (leapfrog); so does the velocity at an impact, which else would add up to energy. */
#include <float.h>
#include <string.h>

#include "physics/contact/contacts.h"
#include "physics/contact/tolerances.h"
#include "physics/impulse/impulse-private.h"
#include "physics/impulse/tolerances.h"

/* The way is divided where it meets a plate, so many times at most: then the body stays where it is. */
#define MOST_PARTS 16

double tinker_impulse_meeting(const TinkerImpulses *self, int32_t body, int32_t number, gboolean closed,
                              const double x[2], const double v[2], double share)
{
    const TinkerImpulsePlate *plate = &self->plates[number];
    const double left = 1 - share, *n = plate->normal;
    double gap = tinker_impulse_gap(self, plate, body, x, share);
    const double fall = left * (plate->top[1] - plate->top[0] - self->h * tinker_dot(n, v));
    if (closed) {
        if (fall < 0) return INFINITY;
        gap = 0;
    } else {
        if (!(fall > 0) || gap >= fall) return INFINITY;
        if (gap < 0) {
            const double rounding =
                16 * DBL_EPSILON * (fabs(x[0]) + fabs(x[1]) + fabs(plate->top[0]) + self->contacts->half_height[body]);
            if (gap < -(self->started ? rounding : TINKER_TOUCHING)) return INFINITY;
            gap = 0;
        }
    }
    const double part = gap > 0 ? gap / fall * left : 0, way = self->h * part;
    const double at[2] = {x[0] + way * v[0], x[1] + way * v[1]};
    const double beside = fabs(tinker_impulse_along(plate, at, share + part)) - plate->half_width;
    if (beside > 0 && beside > 16 * DBL_EPSILON * (plate->half_width + fabs(plate->middle[0]))) return INFINITY;
    return share + part;
}

/* The velocity when they meet; of what touches already, at the start of the step. */
static void find_before(const TinkerImpulseWay *way, TinkerImpulseTouch *touch)
{
    const double *a = way->run->a + 2 * way->body, lead = way->run->h * (0.5 - touch->share);
    for (int32_t k = 0; k < 2; k++)
        touch->before[k] = touch->was != TINKER_CONTACT_OPEN ? way->start[k] : way->v[k] - lead * a[k];
}

/* What asks for more than rest: a body that strikes, and bounces for longer than this step. */
static void find_least(const TinkerImpulseWay *way, TinkerImpulseTouch *touch)
{
    const TinkerImpulses *self = way->run;
    const TinkerImpulsePlate *plate = tinker_impulse_plate(way, touch);
    const double *n = plate->normal, rest = tinker_dot(n, plate->velocity);
    const double e = tinker_contact_surface(self->contacts, way->body, touch->plate).restitution;
    touch->least = rest;
    touch->strikes = touch->bounces = FALSE;
    if (touch->was != TINKER_CONTACT_OPEN) return;
    const double pull = self->h * (0.5 - touch->share) * tinker_dot(n, self->a + 2 * way->body);
    const double approach = tinker_dot(n, touch->before) - rest, rebound = -e * approach;
    touch->strikes = approach < -self->h * fabs(tinker_dot(n, self->a + 2 * way->body)) -
                                    TINKER_MEETING_ROUNDING * self->context->speed;
    if (!touch->strikes || e <= 0) return;
    if (e < 1 && !(rebound > TINKER_LEAST_REBOUND * self->context->speed)) return;
    if (!(rebound + pull > 0)) return;
    touch->least = rest + rebound + pull;
    touch->bounces = TRUE;
}

static gboolean touches_already(const TinkerImpulseWay *way, int32_t plate)
{
    for (int32_t k = 0; k < way->count; k++)
        if (way->touches[k].plate == plate) return TRUE;
    return FALSE;
}

/* The first plates that it meets from here on: adds them and answers when that is; 1 where nothing is met. */
static double find_meetings(TinkerImpulseWay *way)
{
    TinkerImpulses *self = way->run;
    const GArray *near = tinker_impulse_neighbours(self, way->body, way->x, way->v, (1 - way->share) * self->h);
    const int32_t first = way->count;
    double earliest = 1;
    for (guint i = 0; (guint)first < near->len && i < near->len; i++) {
        const int32_t plate = g_array_index(near, int32_t, i);
        if (first > 0 && touches_already(way, plate)) continue;
        const TinkerContact *closed = way->share == 0 ? tinker_impulse_closed(self, way->body, plate, way->next) : NULL;
        const double share = tinker_impulse_meeting(self, way->body, plate, closed != NULL, way->x, way->v, way->share);
        if (share > earliest + TINKER_WHOLE_STEP || way->count == TINKER_MOST_TOUCHES) continue;
        if (share < earliest - TINKER_WHOLE_STEP) way->count = first;
        earliest = MIN(earliest, share);
        TinkerImpulseTouch *touch = &way->touches[way->count++];
        *touch = (TinkerImpulseTouch){
            .body = way->body,
            .plate = plate,
            .was = closed != NULL ? closed->mode : TINKER_CONTACT_OPEN,
            .anchor = closed != NULL ? closed->anchor : 0,
            .share = share,
        };
    }
    for (int32_t k = first; k < way->count; k++) {
        find_before(way, &way->touches[k]);
        find_least(way, &way->touches[k]);
    }
    return earliest;
}

/* Books a contact that is over, or that lasts to the end of the step. The work of an impact is that of the velocities
 * there. */
static void book(TinkerImpulseWay *way, TinkerImpulseTouch *touch)
{
    TinkerImpulses *self = way->run;
    const double mass = self->model->mass[way->body],
                 lead = touch->was == TINKER_CONTACT_OPEN ? self->h * (0.5 - touch->share) : 0;
    const double *a = self->a + 2 * way->body, after[2] = {way->v[0] - lead * a[0], way->v[1] - lead * a[1]};
    touch->normal += touch->normal_before;
    touch->friction += touch->friction_before;
    tinker_impulse_book(self, touch, mass * touch->normal, mass * touch->friction, touch->before, after);
}

/* What bounces off is booked, and parts; what the body goes on resting on keeps the impulses it has had. */
static void part(TinkerImpulseWay *way)
{
    int32_t kept = 0;
    for (int32_t k = 0; k < way->count; k++) {
        TinkerImpulseTouch touch = way->touches[k];
        if (!(touch.normal > 0)) continue;
        if (!touch.bounces) {
            touch.normal_before += touch.normal;
            touch.friction_before += touch.friction;
            touch.normal = touch.friction = 0;
            way->touches[kept++] = touch;
        } else {
            book(way, &touch);
            tinker_impulse_turn(way->run, way->body, touch.plate);
        }
    }
    way->count = kept;
    memcpy(way->base, way->v, sizeof(way->base));
}

static void note_strikes(TinkerImpulseWay *way)
{
    for (int32_t k = 0; k < way->count; k++)
        if (way->touches[k].strikes && way->touches[k].normal > 0) way->run->last_impact = way->run->to.t;
}

static gboolean bounces(const TinkerImpulseWay *way)
{
    for (int32_t k = 0; k < way->count; k++)
        if (way->touches[k].bounces && way->touches[k].normal > 0) return TRUE;
    return FALSE;
}

static void go_to(TinkerImpulseWay *way, double share)
{
    const double time = (share - way->share) * way->run->h;
    if (time > 0) {
        way->x[0] += time * way->v[0];
        way->x[1] += time * way->v[1];
    }
    way->share = MAX(share, way->share);
}

/* Sets it onto what it rests on, to rounding; one that stands still where it stood is left alone. */
static void place(TinkerImpulseWay *way)
{
    for (int32_t pass = 0; pass < way->count; pass++)
        for (int32_t k = 0; k < way->count; k++) {
            const TinkerImpulseTouch *touch = &way->touches[k];
            const TinkerImpulsePlate *plate = tinker_impulse_plate(way, touch);
            if (touch->is == TINKER_CONTACT_OPEN) continue;
            if (!plate->moving && touch->was != TINKER_CONTACT_OPEN && way->v[0] == 0 && way->v[1] == 0) continue;
            const double *n = plate->normal, gap = tinker_impulse_gap(way->run, plate, way->body, way->x, 1);
            double slip = 0;
            if (plate->moving && touch->is == TINKER_CONTACT_STICK && touch->was == TINKER_CONTACT_STICK)
                slip = touch->anchor - tinker_impulse_along(plate, way->x, 1);
            way->x[0] += slip * n[1] - gap * n[0];
            way->x[1] += -slip * n[0] - gap * n[1];
        }
}

/* From meeting to meeting to the end of the step; FALSE where there is no end of them, or a solve failed. */
static gboolean move_through_step(TinkerImpulseWay *way)
{
    for (int32_t parts = 0; parts < MOST_PARTS; parts++) {
        const int32_t before = way->count;
        const double share = find_meetings(way);
        if (way->count == before) {
            go_to(way, 1);
            return TRUE;
        }
        go_to(way, share);
        if (!tinker_impulse_solve_way(way)) return FALSE;
        note_strikes(way);
        if (bounces(way)) part(way);
    }
    return TRUE;
}

static void finish(TinkerImpulseWay *way)
{
    TinkerImpulses *self = way->run;
    const double mass = self->model->mass[way->body];
    const TinkerImpulseTouch *hardest = NULL;
    place(way);
    for (int32_t k = 0; k < way->count; k++) {
        TinkerImpulseTouch *touch = &way->touches[k];
        if (touch->is == TINKER_CONTACT_OPEN) continue;
        book(way, touch);
        tinker_impulse_close(self, touch, mass * touch->normal, mass * touch->friction, way->x);
        if (hardest == NULL || touch->normal > hardest->normal) hardest = touch;
    }
    if (hardest != NULL) tinker_impulse_turn(self, way->body, hardest->plate);
}

gboolean tinker_impulse_move_free(TinkerImpulses *self, int32_t body, guint next, double *q, double *v)
{
    const double *a = self->a + 2 * body, h = self->h;
    const double star[2] = {v[0] + h * a[0], v[1] + h * a[1]};
    if (tinker_impulse_neighbours(self, body, q, star, h)->len == 0) {
        for (int32_t k = 0; k < 2; k++) {
            v[k] = star[k];
            q[k] += h * star[k];
        }
        return TRUE;
    }
    TinkerImpulseWay way;
    way.run = self;
    way.body = body;
    way.next = next;
    way.share = 0;
    way.count = 0;
    for (int32_t k = 0; k < 2; k++) {
        way.x[k] = q[k];
        way.start[k] = v[k];
        way.v[k] = way.base[k] = star[k];
    }
    if (!move_through_step(&way)) return FALSE;
    memcpy(v, way.v, sizeof(way.v));
    finish(&way);
    memcpy(q, way.x, sizeof(way.x));
    return TRUE;
}

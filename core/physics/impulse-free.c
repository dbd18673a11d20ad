/* Bodies that no constraint holds: each goes its own way through the step, straight from plate to plate.
 *
 * The velocity at the start of a step belongs to its middle rather, half a step back, as in all such methods (leapfrog); so
 * does the velocity at an impact, which else would add up to energy. */
#include <float.h>
#include <string.h>

#include "physics/impulse-private.h"

/* The way is divided where it meets a plate, so many times at most: then the body stays where it is. */
#define MOST_PARTS 16
/* Of the largest speed: a rebound below ends in rest, but for one that loses nothing. */
#define LEAST_REBOUND 1e-6
/* Shares of the step that are as good as one. */
#define AT_ONCE 1e-12
/* Of what meets in a speed: rounding. */
#define SPEED_ROUNDING (16 * DBL_EPSILON)

typedef struct {
    TinkerImpulses *run;
    int32_t body;
    guint next;        /* see tinker_impulse_closed */
    double x[2], v[2]; /* where it is when `share` of the step is over, and its velocity from there on */
    double base[2];    /* v but for the contacts that touch */
    double start[2];   /* its velocity at the start of the step */
    double share;
    TinkerImpulseTouch touches[TINKER_MOST_TOUCHES]; /* that touch now, whether or not they press */
    int32_t count;
} Way;

static double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* Along the top: t . a. */
static double cross(const double n[2], const double a[2])
{
    return n[1] * a[0] - n[0] * a[1];
}

static const TinkerImpulsePlate *plate_of(const Way *way, const TinkerImpulseTouch *touch)
{
    return &way->run->plates[touch->plate];
}

double tinker_impulse_meeting(const TinkerImpulses *self, int32_t body, int32_t number, gboolean closed,
                              const double x[2], const double v[2], double share)
{
    const TinkerImpulsePlate *plate = &self->plates[number];
    const double left = 1 - share, *n = plate->normal;
    double gap = tinker_impulse_gap(self, plate, body, x, share);
    const double fall = left * (plate->top[1] - plate->top[0] - self->h * dot(n, v));
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
static void find_before(const Way *way, TinkerImpulseTouch *touch)
{
    const double *a = way->run->a + 2 * way->body, lead = way->run->h * (0.5 - touch->share);
    for (int32_t k = 0; k < 2; k++)
        touch->before[k] = touch->was != TINKER_CONTACT_OPEN ? way->start[k] : way->v[k] - lead * a[k];
}

/* What asks for more than rest: a body that strikes, and bounces for longer than this step. */
static void find_least(const Way *way, TinkerImpulseTouch *touch)
{
    const TinkerImpulses *self = way->run;
    const TinkerImpulsePlate *plate = plate_of(way, touch);
    const double *n = plate->normal, rest = dot(n, plate->velocity), e = plate->restitution;
    touch->least = rest;
    touch->strikes = touch->bounces = FALSE;
    if (touch->was != TINKER_CONTACT_OPEN) return;
    const double pull = self->h * (0.5 - touch->share) * dot(n, self->a + 2 * way->body);
    const double approach = dot(n, touch->before) - rest, rebound = -e * approach;
    touch->strikes =
        approach < -self->h * fabs(dot(n, self->a + 2 * way->body)) - SPEED_ROUNDING * self->context->speed;
    if (!touch->strikes || e <= 0) return;
    if (e < 1 && !(rebound > LEAST_REBOUND * self->context->speed)) return;
    if (!(rebound + pull > 0)) return;
    touch->least = rest + rebound + pull;
    touch->bounces = TRUE;
}

static gboolean touches_already(const Way *way, int32_t plate)
{
    for (int32_t k = 0; k < way->count; k++)
        if (way->touches[k].plate == plate) return TRUE;
    return FALSE;
}

/* The first plates that it meets from here on: adds them and answers when that is; 1 where nothing is met. */
static double find_meetings(Way *way)
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
        if (share > earliest + AT_ONCE || way->count == TINKER_MOST_TOUCHES) continue;
        if (share < earliest - AT_ONCE) way->count = first;
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

/* Laws -------------------------------------------------------------------------------------------------------------- */

/* One contact, in closed form. */
static void solve_single(Way *way)
{
    TinkerImpulseTouch *touch = &way->touches[0];
    const TinkerImpulsePlate *plate = plate_of(way, touch);
    const double *n = plate->normal, *w = plate->velocity;
    const double relative[2] = {way->base[0] - w[0], way->base[1] - w[1]}, along = cross(n, relative);
    const double normal = touch->least - dot(n, way->base);
    if (!(normal >= 0)) {
        touch->normal = touch->friction = 0;
        touch->is = TINKER_CONTACT_OPEN;
        memcpy(way->v, way->base, sizeof(way->v));
        return;
    }
    const double before[2] = {way->start[0] - w[0], way->start[1] - w[1]}, slides = cross(n, before);
    const double most = plate->dynamic_friction * normal;
    /* what stands still in the step may stick */
    const gboolean turns = touch->was != TINKER_CONTACT_OPEN && fabs(along) > most && slides * (along > 0 ? 1 : -1) < 0;
    const double holds = touch->was == TINKER_CONTACT_STICK || turns ? plate->static_friction * normal : most;
    touch->normal = normal;
    const gboolean sticks = holds > 0 && fabs(along) <= holds;
    const double left = sticks ? 0 : along > 0 ? MAX(along - most, 0) : MIN(along + most, 0);
    touch->friction = left - along;
    touch->is = sticks ? TINKER_CONTACT_STICK : left >= 0 ? TINKER_CONTACT_SLIP_FORWARD : TINKER_CONTACT_SLIP_BACKWARD;
    const double rises = touch->bounces ? touch->least - dot(n, w) : 0;
    way->v[0] = w[0] + rises * n[0] + left * n[1];
    way->v[1] = w[1] + rises * n[1] - left * n[0];
}

/* Where contacts leave nothing open the velocity follows from them, to the last bit. */
static void settle(Way *way)
{
    const TinkerImpulseTouch *first = NULL;
    for (int32_t k = 0; k < way->count; k++) {
        const TinkerImpulseTouch *touch = &way->touches[k];
        const TinkerImpulsePlate *plate = plate_of(way, touch);
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
        const double *m = plate_of(way, first)->normal, turn = m[0] * n[1] - m[1] * n[0];
        if (fabs(turn) < 1e-6) continue;
        const double a = dot(m, plate_of(way, first)->velocity), b = dot(n, plate->velocity);
        way->v[0] = (a * n[1] - b * m[1]) / turn;
        way->v[1] = (m[0] * b - n[0] * a) / turn;
        return;
    }
}

static gboolean solve_several(Way *way)
{
    enum { WIDTH = 2 * TINKER_MOST_TOUCHES };
    double delassus[WIDTH * WIDTH], velocity[WIDTH], least[TINKER_MOST_TOUCHES], room[6 * TINKER_MOST_TOUCHES];
    TinkerImpulseTouch *touches[TINKER_MOST_TOUCHES];
    double directions[WIDTH][2];
    const int32_t width = 2 * way->count;
    for (int32_t k = 0; k < way->count; k++) {
        const double *n = plate_of(way, &way->touches[k])->normal, *w = plate_of(way, &way->touches[k])->velocity;
        touches[k] = &way->touches[k];
        least[k] = way->touches[k].least;
        memcpy(directions[2 * k], n, sizeof(directions[0]));
        directions[2 * k + 1][0] = n[1];
        directions[2 * k + 1][1] = -n[0];
        velocity[2 * k] = dot(n, way->base);
        velocity[2 * k + 1] = cross(n, way->base) - cross(n, w);
    }
    for (int32_t i = 0; i < width; i++)
        for (int32_t j = 0; j < width; j++)
            delassus[i * width + j] = dot(directions[i], directions[j]);
    if (!tinker_impulse_solve_laws(way->run, touches, way->count, delassus, velocity, least, room)) return FALSE;
    memcpy(way->v, way->base, sizeof(way->v));
    for (int32_t k = 0; k < way->count; k++)
        for (int32_t i = 0; i < 2; i++)
            way->v[i] += touches[k]->normal * directions[2 * k][i] + touches[k]->friction * directions[2 * k + 1][i];
    settle(way);
    return TRUE;
}

/* Work of all impulses that act now, from the velocity before them; relative to plates that stand still. */
static double gained(const Way *way)
{
    double work = 0;
    for (int32_t k = 0; k < way->count; k++) {
        const TinkerImpulsePlate *plate = plate_of(way, &way->touches[k]);
        const double mean[2] = {0.5 * (way->base[0] + way->v[0]) - plate->velocity[0],
                                0.5 * (way->base[1] + way->v[1]) - plate->velocity[1]};
        work +=
            way->touches[k].normal * dot(plate->normal, mean) + way->touches[k].friction * cross(plate->normal, mean);
    }
    return work;
}

/* No impact adds energy: where several at once would, none of them bounces. */
static gboolean solve(Way *way)
{
    if (way->count == 1) {
        solve_single(way);
        return TRUE;
    }
    if (!solve_several(way)) return FALSE;
    if (!(gained(way) > 0)) return TRUE;
    gboolean any = FALSE;
    for (int32_t k = 0; k < way->count; k++) {
        const TinkerImpulsePlate *plate = plate_of(way, &way->touches[k]);
        any |= way->touches[k].bounces;
        way->touches[k].bounces = FALSE;
        way->touches[k].least = dot(plate->normal, plate->velocity);
    }
    return !any || solve_several(way);
}

/* The way ----------------------------------------------------------------------------------------------------------- */

/* Books a contact that is over, or that lasts to the end of the step. The work of an impact is that of the velocities there. */
static void book(Way *way, TinkerImpulseTouch *touch)
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
static void part(Way *way)
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
            way->run->orientation[way->body] = way->run->contacts->plates[touch.plate].orientation;
        }
    }
    way->count = kept;
    memcpy(way->base, way->v, sizeof(way->base));
}

static void note_strikes(Way *way)
{
    for (int32_t k = 0; k < way->count; k++)
        if (way->touches[k].strikes && way->touches[k].normal > 0) way->run->last_impact = way->run->to.t;
}

static gboolean bounces(const Way *way)
{
    for (int32_t k = 0; k < way->count; k++)
        if (way->touches[k].bounces && way->touches[k].normal > 0) return TRUE;
    return FALSE;
}

static void go_to(Way *way, double share)
{
    const double time = (share - way->share) * way->run->h;
    if (time > 0) {
        way->x[0] += time * way->v[0];
        way->x[1] += time * way->v[1];
    }
    way->share = MAX(share, way->share);
}

/* Sets it onto what it rests on, to rounding; one that stands still where it stood is left alone. */
static void place(Way *way)
{
    for (int32_t pass = 0; pass < way->count; pass++)
        for (int32_t k = 0; k < way->count; k++) {
            const TinkerImpulseTouch *touch = &way->touches[k];
            const TinkerImpulsePlate *plate = plate_of(way, touch);
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

static gboolean go_on(Way *way)
{
    for (int32_t parts = 0; parts < MOST_PARTS; parts++) {
        const int32_t before = way->count;
        const double share = find_meetings(way);
        if (way->count == before) {
            go_to(way, 1);
            return TRUE;
        }
        go_to(way, share);
        if (!solve(way)) return FALSE;
        note_strikes(way);
        if (bounces(way)) part(way);
    }
    return TRUE;
}

static void finish(Way *way)
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
    if (hardest != NULL) self->orientation[way->body] = self->contacts->plates[hardest->plate].orientation;
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
    Way way;
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
    if (!go_on(&way)) return FALSE;
    memcpy(v, way.v, sizeof(way.v));
    finish(&way);
    memcpy(q, way.x, sizeof(way.x));
    return TRUE;
}

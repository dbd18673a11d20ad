/* Impacts in the books: velocities that jump at an instant, with what jumped there. */
#include <math.h>
#include <string.h>

#include "equations/balance/book-keeper-private.h"

/* Whether the text, names joined by ", ", is of these two, or of the second alone. */
static gboolean names_both(const char *text, const char *one, const char *other)
{
    g_autofree char *first = g_strconcat(one, ", ", other, NULL), *second = g_strconcat(other, ", ", one, NULL);
    return strcmp(text, first) == 0 || strcmp(text, second) == 0 || strcmp(text, other) == 0;
}

/* The block that an event from one time to another names beside the body; -1 for none. */
static TinkerBlockId struck_by(const TinkerBookKeeper *keeper, TinkerBlockId body, double since, double time)
{
    const char *name = tinker_scene_block_name(keeper->scene, body);
    for (guint i = 0; keeper->instants != NULL && i < keeper->instants->len; i++) {
        const TinkerBookInstant *instant = g_ptr_array_index(keeper->instants, i);
        if (instant->time < since || instant->time > time || instant->blocks == NULL) continue;
        for (int32_t k = 0; k < tinker_scene_block_count(keeper->scene); k++) {
            const TinkerBlockId other = tinker_scene_block_at(keeper->scene, k);
            if (other != body && names_both(instant->blocks, name, tinker_scene_block_name(keeper->scene, other)))
                return other;
        }
    }
    return -1;
}

/* Adds what a block (-1: it cannot be told which) gave a body at an instant: impulse in x, y, and about its centre. */
static void add_impact(TinkerBookKeeper *keeper, const TinkerBookBody *body, const TinkerBodyState *state, double time,
                       TinkerBlockId by, const double given[3])
{
    const TinkerBodySample *at = &state->at;
    const double px = given[0], py = given[1], spin = given[2];
    const TinkerBookImpact impact = {.time = time,
                                     .by = by,
                                     .on = body->block,
                                     .impulse = {px, py},
                                     .work = 0.5 * (px * (at->vx + body->speed[0]) + py * (at->vy + body->speed[1]) +
                                                    spin * (state->rate + body->speed[2]))};
    const double rx = at->x - keeper->books->about[0], ry = at->y - keeper->books->about[1];
    const double angular = rx * py - ry * px + spin;
    g_array_append_val(keeper->books->impacts, impact);
    if (by < 0) return;
    TinkerBookAccount *account = tinker_book_account(keeper, by);
    account->entry.all.work += impact.work;
    account->entry.all.impulse[0] += px;
    account->entry.all.impulse[1] += py;
    account->entry.all.angular += angular;
    account->work += fabs(impact.work);
    account->impulse += hypot(px, py);
    account->angular += fabs(angular);
}

/* A jolt at an instant is written down at it, to rounding. */
#define SAME_INSTANT 1e-14
/* Of what a body was given: what the blocks of the run's jolts leave of it is rounding. */
#define ALL_TOLD 1e-9
/* Of the greatest momenta, linear and angular, of the run. */
#define ROUNDING 1e-12

static gboolean is_within(const TinkerJolt *jolt, const TinkerBookBody *body, double since, double time)
{
    return jolt->on == body->block && jolt->time >= since * (1 - SAME_INSTANT) &&
           jolt->time <= time * (1 + SAME_INSTANT);
}

/* Each block's share of what a body was given, and what is left of that by who is named in the event. */
static void add_impacts(TinkerBookKeeper *keeper, const TinkerBookBody *body, const TinkerBodyState *state,
                        double since, double time)
{
    const double given[] = {body->mass * (state->at.vx - body->speed[0]), body->mass * (state->at.vy - body->speed[1]),
                            body->inertia * (state->rate - body->speed[2])};
    double left[3], moved = fmax(hypot(given[0], given[1]), ROUNDING / ALL_TOLD * keeper->greatest[1]),
                    turned = fmax(fabs(given[2]), ROUNDING / ALL_TOLD * keeper->greatest[2]);
    memcpy(left, given, sizeof left);
    for (guint i = 0; i < keeper->jolts->len; i++) {
        const TinkerJolt *jolt = &g_array_index(keeper->jolts, TinkerJolt, i);
        if (!is_within(jolt, body, since, time)) continue;
        const double share[] = {jolt->impulse[0], jolt->impulse[1], body->inertia > 0 ? jolt->spin : 0};
        add_impact(keeper, body, state, jolt->time, jolt->by, share);
        moved = fmax(moved, hypot(share[0], share[1]));
        turned = fmax(turned, fabs(share[2]));
        for (int k = 0; k < 3; k++)
            left[k] -= share[k];
    }
    if (hypot(left[0], left[1]) <= ALL_TOLD * moved && fabs(left[2]) <= ALL_TOLD * turned) return;
    add_impact(keeper, body, state, time, struck_by(keeper, body->block, since, time), left);
}

/* Whether a body was given something: what hold against each other, as a blow on a bearing and the bearing, leave its
 * velocity as it was. */
static gboolean is_jolted(const TinkerBookKeeper *keeper, const TinkerBookBody *body, double since, double time)
{
    for (guint i = 0; i < keeper->jolts->len; i++) {
        const TinkerJolt *jolt = &g_array_index(keeper->jolts, TinkerJolt, i);
        if (is_within(jolt, body, since, time) &&
            (hypot(jolt->impulse[0], jolt->impulse[1]) > ROUNDING / ALL_TOLD * keeper->greatest[1] ||
             fabs(jolt->spin) > ROUNDING / ALL_TOLD * keeper->greatest[2]))
            return TRUE;
    }
    return FALSE;
}

/* Rounding and the short time before the instant are no jump. */
#define LEAST_JUMP 1e-11

static gboolean jumps(const double now[3], const double before[3])
{
    const double swung = fabs(now[2]) + fabs(before[2]);
    return hypot(now[0] - before[0], now[1] - before[1]) >
               LEAST_JUMP * (hypot(now[0], now[1]) + hypot(before[0], before[1])) ||
           fabs(now[2] - before[2]) > LEAST_JUMP * swung;
}

void tinker_book_look_for_jumps(TinkerBookKeeper *keeper, const TinkerModelState *state, double since)
{
    for (guint i = 0; i < keeper->bodies->len; i++) {
        TinkerBookBody *body = &g_array_index(keeper->bodies, TinkerBookBody, i);
        const TinkerBodyState *now = tinker_model_state_find(state, body->block);
        const double speed[] = {now->at.vx, now->at.vy, now->rate};
        if (isinf(since))
            memcpy(body->speed, speed, sizeof speed);
        else if (jumps(speed, body->speed) || is_jolted(keeper, body, since, state->time))
            add_impacts(keeper, body, now, since, state->time);
    }
}

/* m/s, m/s, rad/s: what a body was given at time 0. */
static void given_at_start(const TinkerBookKeeper *keeper, const TinkerBookBody *body, double given[3])
{
    memset(given, 0, 3 * sizeof *given);
    for (guint i = 0; i < keeper->jolts->len; i++) {
        const TinkerJolt *jolt = &g_array_index(keeper->jolts, TinkerJolt, i);
        if (!is_within(jolt, body, 0, 0)) continue;
        for (int axis = 0; axis < 2; axis++)
            given[axis] += jolt->impulse[axis] / body->mass;
        if (body->inertia > 0) given[2] += jolt->spin / body->inertia;
    }
}

static void add_speeds(TinkerBookKeeper *keeper, TinkerModelState *state, double sign)
{
    for (guint i = 0; i < state->bodies->len; i++) {
        TinkerBodyState *at = &g_array_index(state->bodies, TinkerBodyState, i);
        const TinkerBookBody *body = tinker_book_body(keeper, at->block);
        double given[3];
        if (body == NULL) continue;
        given_at_start(keeper, body, given);
        at->at.vx += sign * given[0];
        at->at.vy += sign * given[1];
        at->rate += sign * given[2];
    }
}

void tinker_book_begin_before_blows(TinkerBookKeeper *keeper, TinkerModelState *state)
{
    add_speeds(keeper, state, -1);
    tinker_book_add_motion(keeper, state, 0);
    tinker_book_look_for_jumps(keeper, state, INFINITY);
    add_speeds(keeper, state, 1);
    tinker_book_add_motion(keeper, state, -1);
    tinker_book_look_for_jumps(keeper, state, 0);
}

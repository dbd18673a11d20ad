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

/* The block that an event at the time names beside the body; -1 for none. */
static TinkerBlockId struck_by(const TinkerBookKeeper *keeper, TinkerBlockId body, double time)
{
    const char *name = tinker_scene_block_name(keeper->scene, body);
    for (guint i = 0; keeper->instants != NULL && i < keeper->instants->len; i++) {
        const TinkerBookInstant *instant = g_ptr_array_index(keeper->instants, i);
        if (instant->time != time || instant->blocks == NULL) continue;
        for (int32_t k = 0; k < tinker_scene_block_count(keeper->scene); k++) {
            const TinkerBlockId other = tinker_scene_block_at(keeper->scene, k);
            if (other != body && names_both(instant->blocks, name, tinker_scene_block_name(keeper->scene, other)))
                return other;
        }
    }
    return -1;
}

static void add_impact(TinkerBookKeeper *keeper, const TinkerBookBody *body, const TinkerBodyState *state, double time)
{
    const TinkerBodySample *at = &state->at;
    const double m = body->mass, px = m * (at->vx - body->speed[0]), py = m * (at->vy - body->speed[1]);
    const double spin = body->inertia * (state->rate - body->speed[2]);
    const double before = body->speed[0] * body->speed[0] + body->speed[1] * body->speed[1];
    const double turned = spin * (state->rate + body->speed[2]);
    const TinkerBookImpact impact = {.time = time,
                                     .by = struck_by(keeper, body->block, time),
                                     .on = body->block,
                                     .impulse = {px, py},
                                     .work = 0.5 * (m * (at->vx * at->vx + at->vy * at->vy - before) + turned)};
    const double rx = at->x - keeper->books->about[0], ry = at->y - keeper->books->about[1];
    const double angular = rx * py - ry * px + spin;
    g_array_append_val(keeper->books->impacts, impact);
    if (impact.by < 0) return;
    TinkerBookAccount *account = tinker_book_account(keeper, impact.by);
    account->entry.work += impact.work;
    account->entry.impulse[0] += px;
    account->entry.impulse[1] += py;
    account->entry.angular += angular;
    account->work += fabs(impact.work);
    account->impulse += hypot(px, py);
    account->angular += fabs(angular);
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

void tinker_book_look_for_jumps(TinkerBookKeeper *keeper, const TinkerModelState *state, gboolean after)
{
    for (guint i = 0; i < keeper->bodies->len; i++) {
        TinkerBookBody *body = &g_array_index(keeper->bodies, TinkerBookBody, i);
        const TinkerBodyState *now = tinker_model_state_find(state, body->block);
        const double speed[] = {now->at.vx, now->at.vy, now->rate};
        if (!after)
            memcpy(body->speed, speed, sizeof speed);
        else if (jumps(speed, body->speed))
            add_impact(keeper, body, now, state->time);
    }
}

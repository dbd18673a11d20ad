/* The accounts of the books: what motion there is, and what each block gives it. */
#include <math.h>
#include <string.h>

#include "equations/balance/book-keeper-private.h"

/* Of the moments by themselves: what is left of them is rounding. What turns wheels against each other, as a gear, has
 * its counterpart in their bearings, and does not cancel between them. */
#define CANCELS 1e-10

static TinkerBookBody *body_at(const TinkerBookKeeper *keeper, guint number)
{
    return &g_array_index(keeper->bodies, TinkerBookBody, number);
}

TinkerBookBody *tinker_book_body(const TinkerBookKeeper *keeper, TinkerBlockId block)
{
    for (guint i = 0; i < keeper->bodies->len; i++)
        if (body_at(keeper, i)->block == block) return body_at(keeper, i);
    return NULL;
}

/* Whether it is one of the bodies, and acts on others by touching them alone. */
static gboolean touches_others(const TinkerBookKeeper *keeper, TinkerBlockId block)
{
    const TinkerPhysics *physics = tinker_scene_block_class(keeper->scene, block)->physics;
    return tinker_book_body(keeper, block) != NULL && physics != NULL && physics->field == NULL;
}

/* Whether a block acts between the bodies alone: all that it is attached to is among them, or it is one of them, which
 * touches others. */
static gboolean is_inner(const TinkerBookKeeper *keeper, TinkerBlockId block)
{
    if (touches_others(keeper, block)) return TRUE;
    const int32_t ends = tinker_scene_end_count(keeper->scene, block);
    for (int32_t i = 0; i < ends; i++)
        if (tinker_book_body(keeper, tinker_scene_end(keeper->scene, block, i).block) == NULL) return FALSE;
    return ends > 1;
}

TinkerBookAccount *tinker_book_account(TinkerBookKeeper *keeper, TinkerBlockId by)
{
    TinkerBookAccount *account = &g_array_index(keeper->accounts, TinkerBookAccount, by);
    if (account->entry.by == by) return account;
    account->entry.by = by;
    account->entry.inner = is_inner(keeper, by);
    return account;
}

/* The moments of motion of one body: kinetic energy, momentum, angular momentum about a point; their sizes besides. */
typedef struct {
    double kinetic, momentum[2], angular, sizes[3];
} Motion;

static Motion motion_of(const TinkerBookBody *body, const TinkerBodyState *state, const double about[2])
{
    const TinkerBodySample *at = &state->at;
    const double m = body->mass, rx = at->x - about[0], ry = at->y - about[1], speed = hypot(at->vx, at->vy);
    const double spin = body->inertia * state->rate;
    Motion motion = {.kinetic = 0.5 * (m * (at->vx * at->vx + at->vy * at->vy) + spin * state->rate),
                     .momentum = {m * at->vx, m * at->vy},
                     .angular = m * (rx * at->vy - ry * at->vx) + spin};
    motion.sizes[0] = motion.kinetic;
    motion.sizes[1] = m * speed;
    motion.sizes[2] = m * speed * hypot(rx, ry) + fabs(spin);
    return motion;
}

void tinker_book_add_motion(TinkerBookKeeper *keeper, const TinkerModelState *state, int which)
{
    TinkerBooks *books = keeper->books;
    Motion sum = {.kinetic = 0};
    for (guint i = 0; i < keeper->bodies->len; i++) {
        const TinkerBookBody *body = body_at(keeper, i);
        const Motion own = motion_of(body, tinker_model_state_find(state, body->block), books->about);
        sum.kinetic += own.kinetic;
        sum.angular += own.angular;
        for (int k = 0; k < 2; k++)
            sum.momentum[k] += own.momentum[k];
        for (int k = 0; k < 3; k++)
            sum.sizes[k] += own.sizes[k];
    }
    for (int k = 0; k < 3; k++)
        keeper->greatest[k] = fmax(keeper->greatest[k], sum.sizes[k]);
    if (which < 0) return;
    books->kinetic[which] = sum.kinetic;
    memcpy(books->momentum[which], sum.momentum, sizeof sum.momentum);
    books->angular[which] = sum.angular;
}

/* sum += factor * share */
static void add_share(TinkerBookShare *sum, double factor, const TinkerBookShare *share)
{
    sum->work += factor * share->work;
    sum->angular += factor * share->angular;
    for (int axis = 0; axis < 2; axis++) {
        sum->force[axis] += factor * share->force[axis];
        sum->impulse[axis] += factor * share->impulse[axis];
    }
}

int tinker_book_parts(const TinkerBookEntry *entry, TinkerBookShare parts[2])
{
    parts[0] = entry->all;
    if (!entry->rubs) return 1;
    parts[1] = entry->friction;
    add_share(&parts[0], -1, &parts[1]);
    return 2;
}

/* Between 1 and 2, another one for each force: parts of turns by irrational numbers come near to no other soon. */
static double number_of(const TinkerActingForce *force)
{
    return 1 + fmod(0.6180339887498949 * force->by + 0.4142135623730950 * force->on, 1);
}

void tinker_book_add_forces(TinkerBookKeeper *keeper, const TinkerModelState *state, double weight, gboolean end,
                            double values[TINKER_BOOK_FUNCTIONS])
{
    const TinkerBooks *books = keeper->books;
    memset(values, 0, TINKER_BOOK_FUNCTIONS * sizeof *values);
    for (guint i = 0; i < state->forces->len; i++) {
        const TinkerActingForce *force = &g_array_index(state->forces, TinkerActingForce, i);
        const TinkerBookBody *body = tinker_book_body(keeper, force->on);
        if (body == NULL) continue;
        const TinkerBodyState *now = tinker_model_state_find(state, force->on);
        const TinkerBodySample *at = &now->at;
        TinkerBookAccount *account = tinker_book_account(keeper, force->by);
        /* what has no inertia has its forces at its centre */
        const double turning = body->inertia > 0 ? tinker_model_state_moment(state, force) : 0;
        const double power = force->fx * at->vx + force->fy * at->vy + turning * now->rate;
        const double moment = (at->x - books->about[0]) * force->fy - (at->y - books->about[1]) * force->fx + turning;
        const double number = number_of(force), each[] = {power, force->fx, force->fy, moment};
        for (int f = 0; f < TINKER_BOOK_FUNCTIONS; f++)
            values[f] += number * each[f];
        const TinkerBookShare share = {.force = {end ? force->fx : 0, end ? force->fy : 0},
                                       .work = weight * power,
                                       .impulse = {weight * force->fx, weight * force->fy},
                                       .angular = weight * moment};
        add_share(&account->entry.all, 1, &share);
        if (force->kind == TINKER_ACTING_FRICTION && hypot(force->fx, force->fy) > 0) {
            account->entry.rubs = TRUE;
            add_share(&account->entry.friction, 1, &share);
        }
        account->work += weight * fabs(power);
        account->impulse += weight * hypot(force->fx, force->fy);
        account->angular += weight * fabs(moment);
    }
}

void tinker_book_conclude(TinkerBookKeeper *keeper)
{
    TinkerBooks *books = keeper->books;
    double sums[3] = {0, 0, 0}, work = 0, impulse[2] = {0, 0}, angular = 0, force[2] = {0, 0}, forces = 0;
    g_array_set_size(books->entries, 0);
    for (int32_t i = 0; i < tinker_scene_block_count(keeper->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(keeper->scene, i);
        TinkerBookAccount *account = &g_array_index(keeper->accounts, TinkerBookAccount, block);
        if (account->entry.by != block) continue;
        /* what one that touches gives it takes by the account of the other */
        if (!touches_others(keeper, block) && fabs(account->entry.all.angular) > CANCELS * account->angular)
            account->entry.inner = FALSE;
        g_array_append_val(books->entries, account->entry);
        sums[0] += account->work;
        sums[1] += account->impulse;
        sums[2] += account->angular;
        work += account->entry.all.work;
        if (account->entry.inner) continue;
        forces += hypot(account->entry.all.force[0], account->entry.all.force[1]);
        for (int axis = 0; axis < 2; axis++) {
            force[axis] += account->entry.all.force[axis];
            impulse[axis] += account->entry.all.impulse[axis];
        }
        angular += account->entry.all.angular;
    }
    const double px = books->momentum[1][0] - books->momentum[0][0] - impulse[0],
                 py = books->momentum[1][1] - books->momentum[0][1] - impulse[1];
    books->newton = (TinkerBookBalance){hypot(force[0] - books->rate[0], force[1] - books->rate[1]), forces};
    books->energy =
        (TinkerBookBalance){books->kinetic[1] - books->kinetic[0] - work, fmax(keeper->greatest[0], sums[0])};
    books->impulse = (TinkerBookBalance){hypot(px, py), fmax(keeper->greatest[1], sums[1])};
    books->moment =
        (TinkerBookBalance){books->angular[1] - books->angular[0] - angular, fmax(keeper->greatest[2], sums[2])};
}

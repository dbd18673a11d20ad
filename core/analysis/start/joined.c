/* Where the bodies stand then is worked out by the physics' own constraints, and goes to the history as any edit does.
 */
#include "analysis/start/joined.h"

#include <math.h>
#include <string.h>

#include "analysis/start/start-private.h"
#include "physics/compile/assemble.h"

#define NO_MOVE 1e-12 /* m and rad, of 1 or of the value: rounding of the constraints is no edit */
#define EDGE    1e-6  /* of the size: what is closer to an edge is at it */

#define MOST_REACHES  12   /* times that a body is brought nearer to the hand */
#define NEAR_HAND     1e-9 /* m, of 1 or of the place: the hand has what it holds */
#define MOST_LEVERAGE 8.0  /* how much further than its centre, or less far, a place of a body goes at most */

static double component(const TinkerScene *scene, TinkerBlockId block, int32_t meaning, int32_t component)
{
    const TinkerBlockClass *block_class = block != TINKER_NO_BLOCK ? tinker_scene_block_class(scene, block) : NULL;
    const int32_t column = block_class != NULL ? tinker_block_class_meaning_column(block_class, meaning) : -1;
    return column >= 0 ? tinker_scene_get(scene, block, column + component) : 0;
}

TinkerPlacement tinker_placement_of(const TinkerScene *scene, TinkerBlockId block)
{
    return (TinkerPlacement){
        block,
        {component(scene, block, TINKER_MEANING_POSITION, 0), component(scene, block, TINKER_MEANING_POSITION, 1)},
        component(scene, block, TINKER_MEANING_ORIENTATION, 0),
        {component(scene, block, TINKER_MEANING_WIDTH, 0), component(scene, block, TINKER_MEANING_HEIGHT, 0)}};
}

static gboolean differs(double a, double b)
{
    return !(fabs(a - b) <= NO_MOVE * fmax(1, fabs(b)));
}

static gboolean is_elsewhere(const TinkerPlacement *a, const TinkerPlacement *b)
{
    return differs(a->place[0], b->place[0]) || differs(a->place[1], b->place[1]);
}

static gboolean has_other_size(const TinkerPlacement *a, const TinkerPlacement *b)
{
    return differs(a->size[0], b->size[0]) || differs(a->size[1], b->size[1]);
}

/* Sets what is another than it is now. */
static void put(TinkerHistory *history, const TinkerScene *scene, const TinkerPlacement *to)
{
    static const int32_t meanings[] = {TINKER_MEANING_ORIENTATION, TINKER_MEANING_WIDTH, TINKER_MEANING_HEIGHT};
    const TinkerPlacement now = tinker_placement_of(scene, to->block);
    const double wanted[] = {to->orientation, to->size[0], to->size[1]};
    const double present[] = {now.orientation, now.size[0], now.size[1]};
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, to->block);
    const int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    if (position >= 0 && is_elsewhere(to, &now)) tinker_history_set(history, to->block, position, to->place, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(meanings); i++) {
        const int32_t property = block_class->meanings[meanings[i]];
        if (property >= 0 && differs(wanted[i], present[i]))
            tinker_history_set(history, to->block, property, &wanted[i], NULL);
    }
}

/* A place along one of the block's axes, after its size there has become another: an edge stays an edge. */
static double at_edge(double at, double before, double now)
{
    const gboolean is_at_edge = before > 0 && fabs(fabs(at) - 0.5 * before) <= EDGE * before;
    return is_at_edge ? copysign(0.5 * now, at) : at;
}

static void keep_at_edges(TinkerHistory *history, TinkerScene *scene, const TinkerPlacement *before,
                          const TinkerPlacement *now)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        for (int32_t k = 0; k < tinker_scene_end_count(scene, block); k++) {
            const TinkerSceneEnd end = tinker_scene_end(scene, block, k);
            if (end.block != now->block) continue;
            const TinkerSceneEnd to = {end.block, at_edge(end.x, before->size[0], now->size[0]),
                                       at_edge(end.y, before->size[1], now->size[1])};
            if (to.x != end.x || to.y != end.y) tinker_history_set_end(history, block, k, to, NULL);
        }
    }
}

gboolean tinker_joined_can_be_brought(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerHeldBody held = {block, TRUE, TRUE, FALSE};
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, NULL);
    return bodies != NULL;
}

static void put_all(TinkerHistory *history, TinkerScene *scene, const GArray *bodies)
{
    for (guint i = 0; i < bodies->len; i++) {
        const TinkerAssembledBody *body = &g_array_index(bodies, TinkerAssembledBody, i);
        TinkerPlacement to = tinker_placement_of(scene, body->block);
        memcpy(to.place, body->place, sizeof to.place);
        if (body->turns) to.orientation = body->orientation;
        put(history, scene, &to);
    }
}

gboolean tinker_joined_follow(TinkerHistory *history, TinkerScene *scene, const TinkerPlacement *before, GError **error)
{
    const TinkerPlacement now = tinker_placement_of(scene, before->block);
    const TinkerHeldBody held = {now.block, is_elsewhere(&now, before), differs(now.orientation, before->orientation),
                                 FALSE};
    const gboolean resized = has_other_size(&now, before);
    if (!held.place && !held.orientation && !resized) return TRUE;
    if (resized) keep_at_edges(history, scene, before, &now);
    GError *cause = NULL;
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, &cause);
    if (bodies != NULL) {
        put_all(history, scene, bodies);
        return TRUE;
    }
    put(history, scene, before);
    if (resized) keep_at_edges(history, scene, &now, before);
    if (tinker_joined_can_be_brought(scene, now.block)) {
        g_propagate_error(error, cause);
        return FALSE;
    }
    put(history, scene, &now); /* it did not fit before: whoever mends it by hand is not held up */
    if (resized) keep_at_edges(history, scene, before, &now);
    g_error_free(cause);
    return TRUE;
}

/* Where a place of a body's own axes is. */
static void place_held(const TinkerPlacement *body, const double grip[2], double held[2])
{
    const double c = cos(body->orientation), s = sin(body->orientation);
    held[0] = body->place[0] + c * grip[0] - s * grip[1];
    held[1] = body->place[1] + s * grip[0] + c * grip[1];
}

/* Moves a body by so much, with what is joined to it; answers where it is then, which is as before where nothing fits.
 */
static TinkerPlacement shift(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, const double by[2])
{
    const TinkerPlacement before = tinker_placement_of(scene, block);
    TinkerPlacement to = before;
    to.place[0] += by[0];
    to.place[1] += by[1];
    put(history, scene, &to);
    tinker_joined_follow(history, scene, &before, NULL);
    return tinker_placement_of(scene, block);
}

/* The centre is what is moved, and joints decide how far the place that is held goes then: on a crank that turns about
 * one end its other end goes twice as far. So each reach tells how far to move the centre the next time. */
static void reach_hand(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, const double grip[2],
                       const double hand[2])
{
    TinkerPlacement now = tinker_placement_of(scene, block);
    double held[2], leverage = 1;
    place_held(&now, grip, held);
    for (int tries = 0; tries < MOST_REACHES; tries++) {
        const double missed[2] = {hand[0] - held[0], hand[1] - held[1]};
        const double by[2] = {missed[0] / leverage, missed[1] / leverage}, held_before[2] = {held[0], held[1]};
        const TinkerPlacement before = now;
        now = shift(history, scene, block, by);
        place_held(&now, grip, held);
        const double moved = hypot(now.place[0] - before.place[0], now.place[1] - before.place[1]);
        const double went = hypot(held[0] - held_before[0], held[1] - held_before[1]);
        if (!(went > NEAR_HAND * fmax(1, hypot(hand[0], hand[1]))) || !(moved > 0)) break;
        leverage = CLAMP(went / moved, 1 / MOST_LEVERAGE, MOST_LEVERAGE);
    }
}

gboolean tinker_joined_follow_hand(TinkerHistory *history, TinkerScene *scene, const TinkerPlacement *before,
                                   const double grip[2], const double hand[2], GError **error)
{
    const TinkerPlacement wanted = tinker_placement_of(scene, before->block);
    if (!tinker_joined_follow(history, scene, before, error)) return FALSE;
    const TinkerPlacement now = tinker_placement_of(scene, before->block);
    if (is_elsewhere(&now, &wanted)) reach_hand(history, scene, before->block, grip, hand);
    return TRUE;
}

void tinker_joined_bring(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerHeldBody held = {block, TRUE, TRUE, FALSE};
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, NULL);
    if (bodies != NULL) put_all(history, scene, bodies);
}

gboolean tinker_joined_spin(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, GError **error)
{
    const TinkerHeldBody held = {block, FALSE, FALSE, TRUE};
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, error);
    for (guint i = 0; bodies != NULL && i < bodies->len; i++) {
        const TinkerAssembledBody *body = &g_array_index(bodies, TinkerAssembledBody, i);
        if (!start_set_meaning(history, scene, body->block, TINKER_MEANING_VELOCITY, body->velocity, error) ||
            (body->turns &&
             !start_set_meaning(history, scene, body->block, TINKER_MEANING_ANGULAR_VELOCITY, &body->rate, error)))
            return FALSE;
    }
    return bodies != NULL;
}

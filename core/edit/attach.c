/* Where on a block an end goes. On bodies that turn the place matters: ends keep to the one where they are dropped, or
 * to the centre or an end of the body that is near it. */
#include <math.h>
#include <string.h>

#include "edit/edit-private.h"

#define MOST_PLACES 3    /* of a body that ends are drawn to */
#define LONG        3    /* times as long as high: what is joined at its ends */
#define SAME_PLACE  1e-9 /* m: of two places that are one */

static const TinkerBody *body_of(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    return block_class != NULL && block_class->physics != NULL ? block_class->physics->body : NULL;
}

static int32_t freedoms_of(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBody *body = body_of(scene, block);
    return body != NULL ? body->degrees_of_freedom : 0;
}

/* The places of a body that ends are drawn to, in its own axes: its centre, and where it has a length its ends. Answers
 * how many. */
static int32_t marked_places(TinkerFrame *frame, TinkerBlockId block, double own[MOST_PLACES][2])
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const double width = tinker_frame_meaning(frame, block, TINKER_MEANING_WIDTH, 0, 0);
    own[0][0] = own[0][1] = own[1][1] = own[2][1] = 0;
    own[1][0] = 0.5 * width;
    own[2][0] = -0.5 * width;
    return freedoms_of(scene, block) == 3 && width > 0 ? 3 : 1;
}

void edit_own_place(TinkerFrame *frame, TinkerBlockId target, const double place[2], double reach, double own[2])
{
    double marked[MOST_PLACES][2], nearest = reach;
    tinker_frame_to_own(frame, target, place, own);
    const double dropped[2] = {own[0], own[1]};
    const int32_t count =
        freedoms_of(tinker_frame_scene(frame), target) == 3 ? marked_places(frame, target, marked) : 0;
    for (int32_t i = 0; i < count; i++) {
        const double distance = hypot(marked[i][0] - dropped[0], marked[i][1] - dropped[1]);
        if (distance > nearest) continue;
        nearest = distance;
        own[0] = marked[i][0];
        own[1] = marked[i][1];
    }
}

gboolean edit_keeps_places(TinkerScene *scene, TinkerBlockId target)
{
    return freedoms_of(scene, target) == 3;
}

gboolean tinker_is_joint(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    const TinkerConstraint *constraint =
        block_class != NULL && block_class->physics != NULL ? block_class->physics->constraint : NULL;
    return constraint != NULL && constraint->joint != 0 && tinker_scene_end_count(scene, block) == 2;
}

/* Where a joint that is dropped near `place` goes: a point mass has its centre alone. */
static void common_place(TinkerFrame *frame, const TinkerBlockId *targets, int32_t count, double reach, double place[2])
{
    static const double centre[2] = {0, 0};
    double own[2];
    for (int32_t i = 0; i < count; i++) {
        edit_own_place(frame, targets[i], place, reach, own);
        tinker_frame_to_world(frame, targets[i], own, place);
    }
    for (int32_t i = 0; i < count; i++)
        if (freedoms_of(tinker_frame_scene(frame), targets[i]) == 2)
            tinker_frame_to_world(frame, targets[i], centre, place);
}

int32_t tinker_joint_drop(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint, double x, double y,
                          double reach)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL || !tinker_is_joint(scene, joint)) return 0;
    TinkerBlockId targets[2]; /* the upper one first */
    const int32_t count = edit_hit_connectables(frame, joint, x, y, reach, targets, 2);
    double place[2] = {x, y}, own[2][2] = {{0, 0}, {0, 0}};
    common_place(frame, targets, count, reach, place);
    for (int32_t i = 0; i < count; i++)
        if (freedoms_of(scene, targets[i]) != 2) tinker_frame_to_own(frame, targets[i], place, own[i]);
    for (int32_t end = 0; end < 2; end++) {
        const int32_t i = count - 1 - end;
        const TinkerSceneEnd to = i >= 0 ? (TinkerSceneEnd){targets[i], own[i][0], own[i][1]}
                                         : (TinkerSceneEnd){TINKER_NO_BLOCK, place[0], place[1]};
        tinker_history_set_end(history, joint, end, to, NULL);
    }
    return count;
}

/* The marked places of two blocks that are nearest to each other: in the axes of each, and how far they are apart. */
static double nearest_places(TinkerFrame *frame, const TinkerBlockId blocks[2], double own[2][2])
{
    double a[MOST_PLACES][2], b[MOST_PLACES][2], from[2], to[2], nearest = INFINITY;
    const int32_t count_a = marked_places(frame, blocks[0], a), count_b = marked_places(frame, blocks[1], b);
    for (int32_t i = 0; i < count_a; i++)
        for (int32_t j = 0; j < count_b; j++) {
            tinker_frame_to_world(frame, blocks[0], a[i], from);
            tinker_frame_to_world(frame, blocks[1], b[j], to);
            const double distance = hypot(to[0] - from[0], to[1] - from[1]);
            if (!(distance < nearest)) continue;
            nearest = distance;
            memcpy(own[0], a[i], sizeof a[i]);
            memcpy(own[1], b[j], sizeof b[j]);
        }
    return nearest;
}

void tinker_joint_put_between(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint,
                              const TinkerBlockId blocks[2])
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    double own[2][2];
    if (frame == NULL || !isfinite(nearest_places(frame, blocks, own))) return;
    for (int32_t end = 0; end < 2; end++)
        tinker_history_set_end(history, joint, end, (TinkerSceneEnd){blocks[end], own[end][0], own[end][1]}, NULL);
}

/* Whether another joint has an end on the block at this place of its own. */
static gboolean is_jointed_at(TinkerScene *scene, TinkerBlockId joint, TinkerBlockId block, const double own[2])
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId other = tinker_scene_block_at(scene, i);
        if (other == joint || !tinker_is_joint(scene, other)) continue;
        for (int32_t e = 0; e < 2; e++) {
            const TinkerSceneEnd end = tinker_scene_end(scene, other, e);
            if (end.block == block && hypot(end.x - own[0], end.y - own[1]) < SAME_PLACE) return TRUE;
        }
    }
    return FALSE;
}

/* The topmost block at a place, but for this one, that an end of the joint can be on. */
static TinkerBlockId other_at(TinkerFrame *frame, TinkerBlockId joint, TinkerBlockId block, const double place[2])
{
    TinkerBlockId there[2];
    const int32_t count = edit_hit_connectables(frame, joint, place[0], place[1], 0, there, 2);
    for (int32_t i = 0; i < count; i++)
        if (there[i] != block) return there[i];
    return TINKER_NO_BLOCK;
}

void tinker_joint_put_on(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint, TinkerBlockId block)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return;
    double marked[MOST_PLACES][2], place[2], best[2] = {NAN, NAN}, there[2] = {0, 0};
    const int32_t count = marked_places(frame, block, marked);
    const double height = tinker_frame_meaning(frame, block, TINKER_MEANING_HEIGHT, 0, 0);
    const gboolean is_long = count == MOST_PLACES && 2 * marked[1][0] > LONG * height;
    TinkerBlockId met = TINKER_NO_BLOCK;
    for (int32_t i = is_long ? 1 : 0; i < (is_long ? count : 1); i++) {
        if (is_long && is_jointed_at(scene, joint, block, marked[i])) continue;
        tinker_frame_to_world(frame, block, marked[i], place);
        const TinkerBlockId other = other_at(frame, joint, block, place);
        const double above = place[1] - best[1];
        const gboolean higher = fabs(above) > SAME_PLACE ? above > 0 : place[0] < best[0];
        const gboolean better =
            (other != TINKER_NO_BLOCK) == (met != TINKER_NO_BLOCK) ? higher : met == TINKER_NO_BLOCK;
        if (!isnan(best[0]) && !better) continue;
        met = other;
        memcpy(best, place, sizeof best);
        memcpy(there, marked[i], sizeof there);
    }
    double own[2] = {best[0], best[1]}; /* in the world where there is nothing to join it to */
    if (met != TINKER_NO_BLOCK) tinker_frame_to_own(frame, met, best, own);
    tinker_history_set_end(history, joint, 0, (TinkerSceneEnd){block, there[0], there[1]}, NULL);
    if (!isnan(best[0])) tinker_history_set_end(history, joint, 1, (TinkerSceneEnd){met, own[0], own[1]}, NULL);
}

static gboolean are_joined(TinkerScene *scene, TinkerBlockId a, TinkerBlockId b)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId joint = tinker_scene_block_at(scene, i);
        if (!tinker_is_joint(scene, joint)) continue;
        const TinkerBlockId on[2] = {tinker_scene_end(scene, joint, 0).block, tinker_scene_end(scene, joint, 1).block};
        if ((on[0] == a && on[1] == b) || (on[0] == b && on[1] == a)) return TRUE;
    }
    return FALSE;
}

TinkerBlockId tinker_body_met(TinkerScene *scene, TinkerBlockId body, double reach)
{
    double own[2][2];
    g_autoptr(TinkerFrame) frame = freedoms_of(scene, body) == 3 ? tinker_frame_new(scene, NULL) : NULL;
    for (int32_t i = tinker_scene_block_count(scene) - 1; frame != NULL && i >= 0; i--) {
        const TinkerBlockId other = tinker_scene_block_at(scene, i), pair[2] = {body, other};
        if (other == body || freedoms_of(scene, other) != 3 || are_joined(scene, body, other)) continue;
        if (nearest_places(frame, pair, own) <= reach) return other;
    }
    return TINKER_NO_BLOCK;
}

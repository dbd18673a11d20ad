/* Where on a block an end goes. On bodies that turn the place matters: ends keep to the one where they are dropped, or
 * to the centre or an end of the body that is near it. */
#include <math.h>
#include <string.h>

#include "edit/edit-private.h"

#define MOST_PLACES 3    /* of a body that ends are drawn to */
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

/* A place of the world in the axes of what an end is to be on: of a point mass always its centre. */
static void own_place(TinkerFrame *frame, TinkerBlockId block, const double place[2], double own[2])
{
    own[0] = own[1] = 0;
    if (freedoms_of(tinker_frame_scene(frame), block) != 2) tinker_frame_to_own(frame, block, place, own);
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
        own_place(frame, targets[i], place, own[i]);
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

/* Answers how many of them were taken, in their order. */
static int32_t set_ends(TinkerHistory *history, TinkerBlockId joint, const TinkerSceneEnd ends[2])
{
    int32_t set = 0;
    while (set < 2 && tinker_history_set_end(history, joint, set, ends[set], NULL))
        set++;
    return set;
}

int32_t tinker_joint_put_between(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint,
                                 const TinkerBlockId blocks[2])
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    double own[2][2];
    if (frame == NULL || !isfinite(nearest_places(frame, blocks, own))) return 0;
    return set_ends(history, joint,
                    (TinkerSceneEnd[]){{blocks[0], own[0][0], own[0][1]}, {blocks[1], own[1][0], own[1][1]}});
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

/* Where a joint could go on a block. */
typedef struct {
    double place[2];   /* in the world */
    double own[2];     /* in the block's axes */
    TinkerBlockId met; /* what it would join the block to there; or TINKER_NO_BLOCK */
} JointPlace;

/* Near a place of the block's own: a point mass that lies there has its centre alone, which the block has to reach. */
static JointPlace joint_place(TinkerFrame *frame, TinkerBlockId joint, TinkerBlockId block, const double own[2])
{
    static const double centre[2] = {0, 0};
    TinkerScene *scene = tinker_frame_scene(frame);
    JointPlace at = {.own = {own[0], own[1]}};
    double middle[2];
    tinker_frame_to_world(frame, block, own, at.place);
    at.met = other_at(frame, joint, block, at.place);
    if (at.met == TINKER_NO_BLOCK || freedoms_of(scene, at.met) != 2) return at;
    tinker_frame_to_world(frame, at.met, centre, middle);
    if (freedoms_of(scene, block) != 2) {
        memcpy(at.place, middle, sizeof middle);
        tinker_frame_to_own(frame, block, middle, at.own);
    } else if (hypot(middle[0] - at.place[0], middle[1] - at.place[1]) > SAME_PLACE) {
        at.met = TINKER_NO_BLOCK;
    }
    return at;
}

/* What meets another block first, then what is higher, then what is further left. */
static gboolean is_better(const JointPlace *a, const JointPlace *b)
{
    const double above = a->place[1] - b->place[1];
    if ((a->met != TINKER_NO_BLOCK) != (b->met != TINKER_NO_BLOCK)) return a->met != TINKER_NO_BLOCK;
    return fabs(above) > SAME_PLACE ? above > 0 : a->place[0] < b->place[0];
}

int32_t tinker_joint_put_on(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint, TinkerBlockId block)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return 0;
    double marked[MOST_PLACES][2], own[2];
    const int32_t count = marked_places(frame, block, marked);
    const gboolean is_long = edit_has_ends(frame, block);
    JointPlace best = {.met = TINKER_NO_BLOCK};
    gboolean found = FALSE;
    for (int32_t i = 1; is_long && i < count; i++) {
        const JointPlace at = joint_place(frame, joint, block, marked[i]);
        if (is_jointed_at(scene, joint, block, marked[i]) || is_jointed_at(scene, joint, block, at.own)) continue;
        if (found && !is_better(&at, &best)) continue;
        best = at;
        found = TRUE;
    }
    if (!found) best = joint_place(frame, joint, block, marked[0]);
    memcpy(own, best.place, sizeof own); /* in the world where there is nothing to join it to */
    if (best.met != TINKER_NO_BLOCK) own_place(frame, best.met, best.place, own);
    const int32_t set =
        set_ends(history, joint, (TinkerSceneEnd[]){{block, best.own[0], best.own[1]}, {best.met, own[0], own[1]}});
    return best.met != TINKER_NO_BLOCK ? set : MIN(set, 1);
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

#include "equations/balance/diagram.h"

#include <math.h>
#include <string.h>

#include "scene/frame/frame.h"

static gboolean is_listed(const TinkerBlockId *blocks, TinkerBlockId block)
{
    for (; *blocks >= 0; blocks++)
        if (*blocks == block) return TRUE;
    return FALSE;
}

/* What bodies give each other where they touch: `by` is the other one. */
static gboolean is_contact(const TinkerActingForce *acting)
{
    return acting->kind == TINKER_ACTING_NORMAL || acting->kind == TINKER_ACTING_FRICTION;
}

/* Whether a force acts between the blocks alone: all that its block acts on is among them, or what it touches is. */
static gboolean is_inner(TinkerScene *scene, const TinkerBlockId *blocks, const TinkerActingForce *acting)
{
    const TinkerBlockId by = acting->by;
    if (is_contact(acting)) return is_listed(blocks, by);
    const int32_t ends = tinker_scene_end_count(scene, by);
    for (int32_t i = 0; i < ends; i++)
        if (!is_listed(blocks, tinker_scene_end(scene, by, i).block)) return FALSE;
    return ends > 1;
}

static TinkerTermKind kind_of(TinkerScene *scene, const TinkerActingForce *acting)
{
    static const TinkerTermKind kinds[] = {
        [TINKER_ACTING_LINE] = TINKER_TERM_CONNECTOR, [TINKER_ACTING_CONSTRAINT] = TINKER_TERM_CONSTRAINT,
        [TINKER_ACTING_ELEMENT] = TINKER_TERM_FORCE,  [TINKER_ACTING_FIELD] = TINKER_TERM_FIELD,
        [TINKER_ACTING_NORMAL] = TINKER_TERM_NORMAL,  [TINKER_ACTING_FRICTION] = TINKER_TERM_FRICTION,
    };
    if (acting->kind != TINKER_ACTING_ELEMENT) return kinds[acting->kind];
    const char *category = tinker_scene_block_class(scene, acting->by)->type->category;
    return strcmp(category, TINKER_CONNECTOR) == 0 ? TINKER_TERM_CONNECTOR : TINKER_TERM_FORCE;
}

/* A path over more than two ends, along which each span pulls at both of its ends alike: a constraint of places alone.
 * What speaks of angles, as a gear does, may act on each of its ends otherwise. */
static gboolean is_rope(TinkerScene *scene, TinkerBlockId by)
{
    const TinkerPhysics *physics = tinker_scene_block_class(scene, by)->physics;
    return tinker_scene_end_count(scene, by) > 2 && physics != NULL && physics->constraint != NULL &&
           physics->constraint->angles == 0;
}

/* Who stands at the other end: of a rope its neighbours on the path. -1 for none. */
static void find_partners(TinkerScene *scene, const TinkerActingForce *acting, TinkerBlockId partners[2])
{
    partners[0] = partners[1] = -1;
    if (is_contact(acting)) {
        partners[0] = acting->by;
        return;
    }
    const int32_t ends = tinker_scene_end_count(scene, acting->by);
    if (ends > 2 && !is_rope(scene, acting->by)) return;
    int found = 0;
    if (acting->end < 0 && ends == 2) { /* across a rod that is held straight */
        const TinkerBlockId first = tinker_scene_end(scene, acting->by, 0).block;
        partners[0] = first == acting->on ? tinker_scene_end(scene, acting->by, 1).block : first;
    }
    for (int32_t end = acting->end - 1; acting->end >= 0 && end <= acting->end + 1; end += 2)
        if (end >= 0 && end < ends) partners[found++] = tinker_scene_end(scene, acting->by, end).block;
}

static void add_cancelled(TinkerDiagram *diagram, TinkerBlockId by)
{
    for (guint i = 0; i < diagram->cancelled->len; i++)
        if (g_array_index(diagram->cancelled, TinkerBlockId, i) == by) return;
    g_array_append_val(diagram->cancelled, by);
}

static void add_forces(TinkerDiagram *diagram, TinkerScene *scene, const TinkerModelState *state,
                       const TinkerBlockId *blocks)
{
    for (guint i = 0; i < state->forces->len; i++) {
        const TinkerActingForce *acting = &g_array_index(state->forces, TinkerActingForce, i);
        if (!is_listed(blocks, acting->on)) continue;
        if (is_inner(scene, blocks, acting)) {
            add_cancelled(diagram, acting->by);
            continue;
        }
        TinkerBlockId partners[2];
        find_partners(scene, acting, partners);
        const TinkerDiagramForce force = {.from = acting->by,
                                          .kind = kind_of(scene, acting),
                                          .point = {acting->x, acting->y},
                                          .force = {acting->fx, acting->fy},
                                          .torque = acting->torque,
                                          .on = acting->on,
                                          .partner = partners[0],
                                          .second = partners[1],
                                          .end = is_rope(scene, acting->by) ? acting->end + 1 : 0};
        g_array_append_val(diagram->forces, force);
    }
}

static void add_bodies(TinkerDiagram *diagram, const TinkerFrame *frame, const TinkerModelState *state,
                       const TinkerBlockId *blocks)
{
    for (guint i = 0; i < state->bodies->len; i++) {
        const TinkerBodyState *body = &g_array_index(state->bodies, TinkerBodyState, i);
        if (!is_listed(blocks, body->block)) continue;
        const double mass = tinker_frame_meaning(frame, body->block, TINKER_MEANING_MASS, 0, 0);
        const double place[] = {body->at.x, body->at.y};
        diagram->moves = TRUE;
        diagram->mass += mass;
        for (int axis = 0; axis < 2; axis++) {
            diagram->centre[axis] += (place[axis] - diagram->centre[axis]) * mass / diagram->mass;
            diagram->kinetic[axis] += mass * body->acceleration[axis];
        }
        /* of several bodies together moments are not balanced */
        const gboolean alone = blocks[1] < 0 && body->turns;
        diagram->inertia = alone ? tinker_frame_meaning(frame, body->block, TINKER_MEANING_INERTIA, 0, 0) : NAN;
        diagram->turning = alone ? diagram->inertia * body->angular_acceleration : 0;
    }
}

TinkerDiagram *tinker_diagram_new(TinkerScene *scene, const TinkerModelState *state, const TinkerBlockId *blocks,
                                  GError **error)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    if (frame == NULL || !tinker_frame_set_time(frame, state->time, error)) return NULL;
    TinkerDiagram *diagram = g_new0(TinkerDiagram, 1);
    *diagram = (TinkerDiagram){.time = state->time,
                               .inertia = NAN,
                               .forces = g_array_new(FALSE, FALSE, sizeof(TinkerDiagramForce)),
                               .cancelled = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId))};
    add_bodies(diagram, frame, state, blocks);
    double orientation;
    if (!diagram->moves) tinker_frame_centre(frame, blocks[0], &diagram->centre[0], &diagram->centre[1], &orientation);
    add_forces(diagram, scene, state, blocks);
    return diagram;
}

void tinker_diagram_free(TinkerDiagram *diagram)
{
    g_array_unref(diagram->forces);
    g_array_unref(diagram->cancelled);
    g_free(diagram);
}

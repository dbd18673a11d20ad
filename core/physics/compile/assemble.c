/* Assembling: the bodies that are joined, and what joins them, are compiled alone; the one that is held gets so great a
 * mass and inertia that the projection onto the constraints moves the others. */
#include "physics/compile/assemble.h"

#include <math.h>
#include <string.h>

#include "physics/compile/compile-private.h"
#include "physics/compile/compile.h"
#include "physics/compile/tolerances.h"
#include "physics/constraint/constraints.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

#define MOST_TRIES 20 /* at the place that is nearest to the hand */

static const TinkerPhysics *physics_of(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    return block_class != NULL ? block_class->physics : NULL;
}

static gboolean is_body(TinkerScene *scene, TinkerBlockId block)
{
    return tinker_block_class_moves(tinker_scene_block_class(scene, block));
}

/* Whether a block keeps its ends where they are to each other, whatever a hand does. */
static gboolean joins(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerPhysics *physics = physics_of(scene, block);
    if (physics == NULL || physics->constraint == NULL || physics->constraint->unilateral != 0) return FALSE;
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    for (int32_t p = 0; p < block_class->property_count; p++) {
        const TinkerPropertyType *property = &block_class->properties[p];
        if (property->kind == TINKER_KIND_WAVEFORM) return FALSE;
        if ((property->flags & TINKER_DEFAULT_AS_PLACED) != 0 &&
            isnan(tinker_scene_get(scene, block, block_class->first_columns[p])))
            return FALSE;
    }
    for (int32_t end = 0; end < tinker_scene_end_count(scene, block); end++)
        if (tinker_scene_end(scene, block, end).block == TINKER_NO_BLOCK) return FALSE;
    return TRUE;
}

/* Whether a joint is on what is held, or on a body that is taken in: supports do not carry on. */
static gboolean is_reached(TinkerScene *scene, TinkerBlockId joint, TinkerBlockId held, const gboolean *taken)
{
    for (int32_t end = 0; end < tinker_scene_end_count(scene, joint); end++) {
        const TinkerBlockId on = tinker_scene_end(scene, joint, end).block;
        if (on == held || (taken[on] && is_body(scene, on))) return TRUE;
    }
    return FALSE;
}

/* Takes in what is joined to the blocks that are taken already; answers whether that was any. */
static gboolean take_joined(TinkerScene *scene, TinkerBlockId held, gboolean *taken)
{
    gboolean any = FALSE;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId joint = tinker_scene_block_at(scene, i);
        if (taken[joint] || !joins(scene, joint) || !is_reached(scene, joint, held, taken)) continue;
        taken[joint] = any = TRUE;
        for (int32_t end = 0; end < tinker_scene_end_count(scene, joint); end++)
            taken[tinker_scene_end(scene, joint, end).block] = TRUE;
    }
    return any;
}

/* What moves the supports belongs to their places at t = 0. */
static void take_motions(TinkerScene *scene, gboolean *taken)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        const TinkerPhysics *physics = physics_of(scene, block);
        if (physics == NULL || physics->motion == NULL || tinker_scene_end_count(scene, block) == 0) continue;
        const TinkerBlockId on = tinker_scene_end(scene, block, 0).block;
        if (on != TINKER_NO_BLOCK && taken[on]) taken[block] = TRUE;
    }
}

static void weigh_down(GPtrArray *batches, TinkerBlockId block, int32_t meaning)
{
    for (guint i = 0; i < batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(batches, i);
        const int32_t column = tinker_block_class_meaning_column(batch->block_class, meaning);
        for (int32_t row = 0; column >= 0 && row < batch->count; row++)
            if (batch->ids[row] == block) batch->columns[column][row] *= TINKER_HELD_MASS;
    }
}

/* The bodies of a model where it starts. (transfer full) */
static GArray *bodies_of(const TinkerModel *model)
{
    GArray *bodies = g_array_new(FALSE, TRUE, sizeof(TinkerAssembledBody));
    for (int32_t i = 0; i < model->bodies; i++) {
        const int32_t turn = model->turn_of != NULL ? model->turn_of[i] : -1;
        TinkerAssembledBody body = {.block = model->body_blocks[i], .turns = turn >= 0};
        for (int k = 0; k < 2; k++) {
            body.place[k] = model->origin[k] + model->q_start[2 * i + k];
            body.velocity[k] = model->v_start[2 * i + k];
        }
        if (turn >= 0) {
            body.orientation = model->q_start[2 * model->bodies + turn] / model->turns[turn].gyration;
            body.rate = model->v_start[2 * model->bodies + turn] / model->turns[turn].gyration;
        }
        g_array_append_val(bodies, body);
    }
    return bodies;
}

/* The number of the held body; -1: it is a support. */
static int32_t held_body(const TinkerModel *model, const TinkerHeldBody *held)
{
    for (int32_t i = 0; i < model->bodies; i++)
        if (model->body_blocks[i] == held->block) return i;
    return -1;
}

/* The coordinate that a body turns by; -1: none. */
static int32_t turn_coordinate(const TinkerModel *model, int32_t body)
{
    const int32_t turn = body >= 0 && model->turn_of != NULL ? model->turn_of[body] : -1;
    return turn >= 0 ? 2 * model->bodies + turn : -1;
}

/* Newton steps go along the rows as they lie at first, and so not to the place that is nearest to the hand: what it
 * holds is put back into it, with the others where they came to stand, until that changes little. */
static TinkerStatus follow_hand(TinkerModel *model, const TinkerHeldBody *held)
{
    const int32_t body = held_body(model, held), angle = turn_coordinate(model, body);
    double *q = model->q_start;
    const double place[2] = {body >= 0 ? q[2 * body] : 0, body >= 0 ? q[2 * body + 1] : 0};
    const double orientation = angle >= 0 ? q[angle] : 0;
    TinkerStatus status = TINKER_OK;
    double missed = INFINITY, before;
    for (int tries = 0; tries < MOST_TRIES && status == TINKER_OK; tries++) {
        gboolean moved;
        if (held->place && body >= 0) memcpy(q + 2 * body, place, sizeof place);
        if (held->orientation && angle >= 0) q[angle] = orientation;
        status = tinker_constraints_project_positions(model, 0.0, q, model->v_start, &moved);
        before = missed;
        missed = held->place && body >= 0 ? hypot(q[2 * body] - place[0], q[2 * body + 1] - place[1]) : 0;
        if (held->orientation && angle >= 0) missed += fabs(q[angle] - orientation);
        if (!(fabs(before - missed) > TINKER_ASSEMBLED * missed)) break;
    }
    return status;
}

/* Projected velocities of a body whose rate is held: the rate is put back, until that changes little. */
static TinkerStatus follow_rate(TinkerModel *model, const TinkerHeldBody *held)
{
    const int32_t angle = turn_coordinate(model, held_body(model, held));
    const double rate = angle >= 0 ? model->v_start[angle] : 0;
    TinkerStatus status = TINKER_OK;
    double missed = INFINITY, before;
    for (int tries = 0; tries < MOST_TRIES && status == TINKER_OK; tries++) {
        gboolean moved;
        if (angle >= 0) model->v_start[angle] = rate;
        status = tinker_constraints_project_velocities(model, 0.0, model->q_start, model->v_start, FALSE, &moved);
        before = missed;
        missed = angle >= 0 ? fabs(model->v_start[angle] - rate) : 0;
        if (!(fabs(before - missed) > TINKER_ASSEMBLED * missed)) break;
    }
    return status;
}

static gboolean bring_together(TinkerModel *model, const TinkerHeldBody *held, GError **error)
{
    TinkerStatus status = tinker_model_set_time(model, 0.0);
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (status == TINKER_OK) status = tinker_constraints_evaluate(model);
    if (status == TINKER_OK) {
        tinker_constraints_find_redundant(model);
        status = follow_hand(model, held);
    }
    if (status == TINKER_OK && held->rate) status = follow_rate(model, held);
    if (status != TINKER_OK)
        g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_CONTRADICTION, model->failure);
    return status == TINKER_OK;
}

GArray *tinker_assemble(TinkerScene *scene, const TinkerHeldBody *held, GError **error)
{
    g_autofree gboolean *taken = g_new0(gboolean, (gsize)MAX(tinker_scene_id_limit(scene), 1));
    taken[held->block] = TRUE;
    gboolean any = FALSE;
    while (take_joined(scene, held->block, taken))
        any = TRUE;
    if (!any) return g_array_new(FALSE, TRUE, sizeof(TinkerAssembledBody));
    take_motions(scene, taken);
    g_autoptr(TinkerModel) model = tinker_model_new_of_batches(scene, tinker_batches_new(scene, taken));
    model->part = TRUE;
    if (!tinker_model_resolve_placed(model, error)) return NULL;
    if (held->place) weigh_down(model->batches, held->block, TINKER_MEANING_MASS);
    if (held->orientation || held->rate) weigh_down(model->batches, held->block, TINKER_MEANING_INERTIA);
    if (!tinker_model_compile_parts(model, error) || !bring_together(model, held, error)) return NULL;
    return bodies_of(model);
}

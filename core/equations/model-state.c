#include "equations/model-state.h"

#include <math.h>
#include <string.h>

/* Whether the record of a block has its acceleration. */
static gboolean has_acceleration(const TinkerScene *scene, TinkerBlockId block, int32_t quantities[2])
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    const TinkerPhysics *physics = block_class != NULL ? block_class->physics : NULL;
    if (physics == NULL || physics->body == NULL || physics->body->degrees_of_freedom == 0) return FALSE;
    quantities[0] = tinker_block_class_quantity(block_class, "ax");
    quantities[1] = tinker_block_class_quantity(block_class, "ay");
    return quantities[0] >= 0 && quantities[1] >= 0;
}

GArray *tinker_model_state_columns(TinkerScene *scene)
{
    GArray *columns = tinker_columns_new();
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        int32_t quantities[2];
        if (!has_acceleration(scene, block, quantities)) continue;
        for (int axis = 0; axis < 2; axis++)
            tinker_columns_add_quantity(columns, scene, block, quantities[axis]);
    }
    return columns;
}

/* Of bodies whose record has no accelerations. */
static void accelerations_by_forces(TinkerModelState *state, TinkerScene *scene)
{
    for (guint i = 0; i < state->bodies->len; i++) {
        TinkerBodyState *body = &g_array_index(state->bodies, TinkerBodyState, i);
        if (!isnan(body->acceleration[0])) continue;
        const int32_t column =
            tinker_block_class_meaning_column(tinker_scene_block_class(scene, body->block), TINKER_MEANING_MASS);
        const double mass = column >= 0 ? tinker_scene_get(scene, body->block, column) : 1;
        body->acceleration[0] = body->acceleration[1] = 0;
        for (guint k = 0; k < state->forces->len; k++) {
            const TinkerActingForce *acting = &g_array_index(state->forces, TinkerActingForce, k);
            if (acting->on != body->block) continue;
            body->acceleration[0] += acting->fx / mass;
            body->acceleration[1] += acting->fy / mass;
        }
    }
}

TinkerModelState *tinker_model_state_take(TinkerSimulation *simulation, TinkerModel *model, TinkerScene *scene,
                                          double time, const double *values, GError **error)
{
    g_autoptr(TinkerModelState) state = g_new0(TinkerModelState, 1);
    g_autoptr(TinkerActingForces) acting = tinker_acting_forces_new(model);
    state->time = time;
    state->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBodyState));
    state->forces = tinker_acting_forces_array();
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBodyState body = {.block = tinker_scene_block_at(scene, i), .acceleration = {NAN, NAN}};
        int32_t quantities[2];
        if (has_acceleration(scene, body.block, quantities)) {
            memcpy(body.acceleration, values, sizeof body.acceleration);
            values += 2;
        }
        if (tinker_simulation_body(simulation, body.block, &body.at)) g_array_append_val(state->bodies, body);
    }
    if (!tinker_acting_forces_at(acting, simulation, state->forces, error)) return NULL;
    accelerations_by_forces(state, scene);
    return g_steal_pointer(&state);
}

void tinker_model_state_free(TinkerModelState *state)
{
    g_clear_pointer(&state->bodies, g_array_unref);
    g_clear_pointer(&state->forces, g_array_unref);
    g_free(state);
}

const TinkerBodySample *tinker_model_state_body(const TinkerModelState *state, TinkerBlockId block)
{
    for (guint i = 0; i < state->bodies->len; i++) {
        const TinkerBodyState *body = &g_array_index(state->bodies, TinkerBodyState, i);
        if (body->block == block) return &body->at;
    }
    return NULL;
}

gboolean tinker_model_state_force(const TinkerModelState *state, TinkerBlockId by, TinkerBlockId on, int kind,
                                  double force[2])
{
    gboolean any = FALSE;
    force[0] = force[1] = 0;
    for (guint i = 0; i < state->forces->len; i++) {
        const TinkerActingForce *acting = &g_array_index(state->forces, TinkerActingForce, i);
        if (acting->by != by || (on >= 0 && acting->on != on) || (kind >= 0 && (int)acting->kind != kind)) continue;
        force[0] += acting->fx;
        force[1] += acting->fy;
        any = TRUE;
    }
    return any;
}

#include "equations/model-state.h"

TinkerModelState *tinker_model_state_take(TinkerSimulation *simulation, TinkerModel *model, TinkerScene *scene,
                                          double time, GError **error)
{
    g_autoptr(TinkerModelState) state = g_new0(TinkerModelState, 1);
    g_autoptr(TinkerActingForces) acting = tinker_acting_forces_new(model);
    state->time = time;
    state->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBodyState));
    state->forces = tinker_acting_forces_array();
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBodyState body = {.block = tinker_scene_block_at(scene, i)};
        if (tinker_simulation_body(simulation, body.block, &body.at)) g_array_append_val(state->bodies, body);
    }
    if (!tinker_acting_forces_at(acting, simulation, state->forces, error)) return NULL;
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

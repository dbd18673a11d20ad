#include "equations/state/model-state.h"

#include <math.h>
#include <string.h>

/* What is read from the record of a body: the last three of one that turns. */
#define QUANTITIES 5

/* The numbers of the quantities that the record of a block gives of its motion; answers how many there are. */
static int quantities_of(const TinkerScene *scene, TinkerBlockId block, int32_t quantities[QUANTITIES])
{
    static const char *const ids[QUANTITIES] = {"ax", "ay", "angle", "angular velocity", "angular acceleration"};
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (!tinker_block_class_moves(block_class)) return 0;
    int count = 0;
    while (count < QUANTITIES && (quantities[count] = tinker_block_class_quantity(block_class, ids[count])) >= 0)
        count++;
    return count == QUANTITIES ? QUANTITIES : count >= 2 ? 2 : 0;
}

GArray *tinker_model_state_columns(TinkerScene *scene)
{
    GArray *columns = tinker_columns_new();
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        int32_t quantities[QUANTITIES];
        const int count = quantities_of(scene, block, quantities);
        for (int k = 0; k < count; k++)
            tinker_columns_add_quantity(columns, scene, block, quantities[k]);
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
        int32_t quantities[QUANTITIES];
        const int count = quantities_of(scene, body.block, quantities);
        if (count >= 2) memcpy(body.acceleration, values, sizeof body.acceleration);
        body.turns = count == QUANTITIES;
        if (body.turns) {
            body.angle = values[2];
            body.rate = values[3];
            body.angular_acceleration = values[4];
        }
        values += count;
        if (tinker_simulation_body(simulation, body.block, &body.at)) g_array_append_val(state->bodies, body);
    }
    if (!tinker_acting_forces_at(acting, simulation, state->forces, error)) return NULL;
    state->touches = g_array_copy((GArray *)tinker_acting_forces_touches(acting));
    accelerations_by_forces(state, scene);
    return g_steal_pointer(&state);
}

void tinker_model_state_free(TinkerModelState *state)
{
    g_clear_pointer(&state->bodies, g_array_unref);
    g_clear_pointer(&state->forces, g_array_unref);
    g_clear_pointer(&state->touches, g_array_unref);
    g_free(state);
}

const TinkerBodyState *tinker_model_state_find(const TinkerModelState *state, TinkerBlockId block)
{
    for (guint i = 0; i < state->bodies->len; i++) {
        const TinkerBodyState *body = &g_array_index(state->bodies, TinkerBodyState, i);
        if (body->block == block) return body;
    }
    return NULL;
}

const TinkerBodySample *tinker_model_state_body(const TinkerModelState *state, TinkerBlockId block)
{
    const TinkerBodyState *body = tinker_model_state_find(state, block);
    return body != NULL ? &body->at : NULL;
}

double tinker_model_state_moment(const TinkerModelState *state, const TinkerActingForce *acting)
{
    const TinkerBodySample *at = tinker_model_state_body(state, acting->on);
    if (at == NULL) return acting->torque;
    return acting->torque + (acting->x - at->x) * acting->fy - (acting->y - at->y) * acting->fx;
}

double tinker_model_state_nothing(const TinkerModelState *state, TinkerBlockId body, gboolean moment)
{
    const TinkerBodySample *at = tinker_model_state_body(state, body);
    double greatest = 0, moments = 0;
    for (guint i = 0; i < state->forces->len; i++) {
        const TinkerActingForce *force = &g_array_index(state->forces, TinkerActingForce, i);
        const double strength = hypot(force->fx, force->fy);
        if (force->on != body || !isfinite(strength)) continue;
        greatest = fmax(greatest, strength);
        if (at != NULL) moments += strength * hypot(force->x - at->x, force->y - at->y) + fabs(force->torque);
    }
    return TINKER_FORCE_NOTHING * (moment ? moments : greatest);
}

gboolean tinker_model_state_force(const TinkerModelState *state, TinkerBlockId by, TinkerBlockId on, double force[3])
{
    gboolean any = FALSE;
    memset(force, 0, 3 * sizeof *force);
    for (guint i = 0; i < state->forces->len; i++) {
        const TinkerActingForce *acting = &g_array_index(state->forces, TinkerActingForce, i);
        if (acting->by != by || (on >= 0 && acting->on != on)) continue;
        force[0] += acting->fx;
        force[1] += acting->fy;
        force[2] += tinker_model_state_moment(state, acting);
        any = TRUE;
    }
    return any;
}

gboolean tinker_model_state_end_force(const TinkerModelState *state, TinkerBlockId by, int32_t end,
                                      const double about[2], double force[3])
{
    gboolean any = FALSE;
    memset(force, 0, 3 * sizeof *force);
    for (guint i = 0; i < state->forces->len; i++) {
        const TinkerActingForce *acting = &g_array_index(state->forces, TinkerActingForce, i);
        if (acting->by != by || acting->end != end) continue;
        force[0] += acting->fx;
        force[1] += acting->fy;
        force[2] += acting->torque;
        if (about != NULL) force[2] += (acting->x - about[0]) * acting->fy - (acting->y - about[1]) * acting->fx;
        any = TRUE;
    }
    return any;
}

/* How many entries an output has, and which instance one belongs to. */
#include "conformance/probe/state.h"

gsize kit_output_first(const KitOutput *output, const KitState *state, int32_t instance)
{
    switch (output->extent) {
    case KIT_INSTANCES:
        return (gsize)instance;
    case KIT_ENDS:
        return (gsize)state->offsets[instance];
    case KIT_ROWS:
        return (gsize)(instance * kit_state_rows(state));
    case KIT_ROW_ENDS:
        return (gsize)(state->offsets[instance] * kit_state_rows(state));
    default:
        return 0;
    }
}

gsize kit_output_entries(const KitOutput *output, const KitState *state)
{
    switch (output->extent) {
    case KIT_INSTANCES:
        return (gsize)state->count;
    case KIT_ENDS:
        return (gsize)kit_state_end_count(state);
    case KIT_ROWS:
        return (gsize)(state->count * kit_state_rows(state));
    case KIT_ROW_ENDS:
        return (gsize)(kit_state_end_count(state) * kit_state_rows(state));
    case KIT_BODIES:
        return (gsize)state->body_range;
    default:
        return 1;
    }
}

int32_t kit_output_instance(const KitOutput *output, const KitState *state, gsize entry)
{
    if (output->extent == KIT_BODIES || output->extent == KIT_ONCE) return state->count == 1 ? 0 : -1;
    int32_t instance = 0;
    while (instance + 1 < state->count && kit_output_first(output, state, instance + 1) <= entry)
        instance++;
    return instance;
}

int32_t kit_state_rows(const KitState *state)
{
    const TinkerPhysics *physics = state->block_class->physics;
    return physics != NULL && physics->constraint != NULL ? physics->constraint->rows : 0;
}

int32_t kit_state_end_count(const KitState *state)
{
    return state->offsets[state->count];
}

/* Calling a function on a state: on copies of all that it may read, with room about all that it may write, so that one
 * fault shows in the rule that is about it and in no other. */
#include <math.h>
#include <string.h>

#include "conformance/probe/state.h"

#define ROOM 512 /* doubles before and behind a result */

static void make_room(KitAnswer *answer, const KitFunction *function, const KitState *state)
{
    for (int k = 0; k < function->output_count; k++) {
        const KitOutput *output = &function->outputs[k];
        answer->entries[k] = kit_output_entries(output, state) * (gsize)output->width;
        const gsize whole = answer->entries[k] + 2 * ROOM;
        answer->memory[k] = g_new(double, whole);
        for (gsize i = 0; i < whole; i++)
            answer->memory[k][i] = NAN;
        answer->values[k] = answer->memory[k] + ROOM;
        if (output->integers) memset(answer->memory[k], 0xff, whole * sizeof(double));
        if (output->angular) memset(answer->values[k], 0, answer->entries[k] * sizeof(double)); // so it is for a run
    }
}

TinkerGraphInput kit_state_graph_input(const KitState *state)
{
    const TinkerPhysics *physics = state->block_class->physics;
    TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput),
                              .ends = state->points,
                              .accelerations = state->accelerations,
                              .poses = state->poses};
    if (physics == NULL) return input;
    if (physics->constraint != NULL) input.multipliers = state->multipliers;
    if (physics->force_element != NULL) input.forces = state->forces;
    if (physics->force_element != NULL && physics->force_element->angles != 0) input.torques = state->torques;
    if (physics->body != NULL) input.contacts = state->contacts;
    if (physics->field == NULL) return input;
    input.bodies = state->bodies;
    input.masses = state->masses;
    input.body_count = state->body_count;
    return input;
}

/* For the report of a crash: of many instances nobody knows which one it was. */
static void tell_call(KitCheck *check, const KitFunction *function, const KitState *state)
{
    g_autofree char *values = kit_state_describe(state, 0);
    if (state->count > 1)
        kit_phase(check, "%s at %s (the first of %d instances has %s)", function->name, state->label, state->count,
                  values);
    else
        kit_phase(check, "%s at %s (%s)", function->name, state->label, values);
}

KitAnswer *kit_call(KitCheck *check, const KitFunction *function, const KitState *original)
{
    KitAnswer *answer = g_new0(KitAnswer, 1);
    g_autoptr(KitState) state = kit_state_copy(original);
    g_autofree const double **columns = g_new0(const double *, state->block_class->column_count + 1);
    TinkerBatch view = kit_state_view(state, columns);
    const TinkerBodies bodies = {sizeof(TinkerBodies), state->body_count, state->bodies,
                                 state->masses,        state->first_body, state->body_range};
    const TinkerGraphInput graph = kit_state_graph_input(state);
    make_room(answer, function, state);
    tell_call(check, function, state);
    const KitArguments with = {
        &view, state->lengths, state->rates, state->points, &bodies, &graph, (void *const *)answer->values};
    answer->status = function->call(function, state->block_class, &with);
    answer->failed_instance = view.failed_instance;
    answer->failure = view.failure;
    return answer;
}

KitAnswer *kit_call_first_blow(KitCheck *check, const GArray *functions, KitState *state)
{
    const KitFunction *next = kit_function(functions, "next_blow"), *blow = kit_function(functions, "blow");
    if (next == NULL || blow == NULL) return NULL;
    state->time = -1;
    g_autoptr(KitAnswer) when = kit_call_well(check, next, state);
    if (when == NULL || !isfinite(when->values[0][0])) return NULL;
    state->time = when->values[0][0];
    return kit_call_well(check, blow, state);
}

void kit_answer_free(KitAnswer *answer)
{
    if (answer == NULL) return;
    for (int k = 0; k < KIT_MOST_OUTPUTS; k++)
        g_free(answer->memory[k]);
    g_free(answer);
}

KitAnswer *kit_call_well(KitCheck *check, const KitFunction *function, const KitState *state)
{
    KitAnswer *answer = kit_call(check, function, state);
    if (answer->status == TINKER_OK) return answer;
    kit_fail(check, "%s answers %d at %s, 0 was expected: %s", function->name, answer->status, state->label,
             answer->failure != NULL ? answer->failure : "it gives no reason");
    kit_answer_free(answer);
    return NULL;
}

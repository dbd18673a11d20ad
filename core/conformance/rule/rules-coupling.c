/* coupling: the host keeps bodies in one island only where a field says that it couples them. A field that does not say
 * so sees each island's bodies alone, so its force on a body has to be the same with nobody else there. */
#include <math.h>
#include <string.h>

#include "conformance/probe/state.h"

#define ROUNDS 4
#define CLOSE  1e-9 /* of the force */
#define NEARER 0.1  /* at their places the bodies are some 0.4 m apart; a short reach shows when they come closer */

static void come_closer(KitState *state)
{
    for (int32_t b = 0; b < state->body_count; b++) {
        state->bodies[b].x *= NEARER;
        state->bodies[b].y *= NEARER;
    }
    g_strlcpy(state->label, "bodies close together", sizeof state->label);
}

/* (transfer full) */
static KitState *with_body_alone(const KitState *state, int32_t body)
{
    KitState *alone = kit_state_copy(state);
    alone->bodies[0] = state->bodies[body];
    alone->masses[0] = state->masses[body];
    alone->body_count = alone->body_range = 1;
    g_strlcpy(alone->label, "a body alone", sizeof alone->label);
    return alone;
}

static void tell_difference(KitCheck *check, const KitState *state, int32_t body, const double *among,
                            const KitAnswer *alone)
{
    g_autofree char *values = kit_state_describe_body(state, body);
    if (alone->status != TINKER_OK)
        kit_fail(check,
                 "force answers %d for body %d alone, 0 with the others there; couples_bodies = 1 was expected (%s)",
                 alone->status, body, values);
    else
        kit_fail(
            check,
            "the force on body %d is (%.9g, %.9g) N, and (%.9g, %.9g) N with nobody else there: it depends on other "
            "bodies, so couples_bodies = 1 was expected (%s)",
            body, among[0], among[1], alone->values[0][0], alone->values[0][1], values);
}

/* Whether the force on a body depends on others; told where the field does not say so. */
static gboolean is_coupled(KitCheck *check, const KitFunction *force, const KitState *state)
{
    g_autoptr(KitAnswer) among = kit_call(check, force, state);
    for (int32_t b = 0; among->status == TINKER_OK && b < state->body_count; b++) {
        g_autoptr(KitState) one = with_body_alone(state, b);
        g_autoptr(KitAnswer) alone = kit_call(check, force, one);
        const double *f = among->values[0] + 2 * b, size = hypot(f[0], f[1]);
        if (!isfinite(size)) continue; // another rule's fault
        if (alone->status == TINKER_OK && hypot(alone->values[0][0] - f[0], alone->values[0][1] - f[1]) <= CLOSE * size)
            continue;
        if (check->block_class->physics->field->couples_bodies == 0) tell_difference(check, state, b, f, alone);
        return TRUE;
    }
    return FALSE;
}

void kit_try_coupling(KitCheck *check)
{
    const TinkerPhysics *physics = check->block_class->physics;
    if (physics == NULL || physics->field == NULL) {
        kit_skip(check, "it is no field");
        return;
    }
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *force = kit_function(functions, "force");
    gboolean coupled = FALSE;
    for (int round = 0; round < ROUNDS && !coupled && !kit_decided(check); round++) {
        g_autoptr(KitState) state = kit_state_new(check, 1);
        if (state == NULL) return;
        coupled = is_coupled(check, force, state);
        come_closer(state);
        coupled = coupled || is_coupled(check, force, state);
    }
    if (!coupled && physics->field->couples_bodies != 0)
        kit_tell(check,
                 "couples_bodies is 1, but no force was seen to depend on other bodies: all are stepped together "
                 "for nothing");
}

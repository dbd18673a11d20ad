/* finite: at degenerate states a function answers finite numbers, or says in words why it does not. */
#include <math.h>

#include "conformance/probe/state.h"

/* Squares of the first are subnormal or 0; sixth powers of the second are still finite. */
#define TINY       1e-170
#define HUGE_VALUE 1e50

typedef void (*Change)(KitState *state);

static void each_point(KitState *state, double place, double velocity)
{
    for (int32_t e = 0; e < kit_state_end_count(state); e++) {
        TinkerPoint *p = &state->points[e];
        *p = (TinkerPoint){p->x * place, p->y * place, p->vx * velocity, p->vy * velocity};
        state->poses[e].rate *= velocity;
    }
    for (int32_t b = 0; b < state->body_count; b++) {
        TinkerPoint *p = &state->bodies[b];
        *p = (TinkerPoint){p->x * place, p->y * place, p->vx * velocity, p->vy * velocity};
    }
    for (int32_t i = 0; i < state->count; i++) {
        state->lengths[i] *= place;
        state->rates[i] *= velocity;
    }
}

static void coincide(KitState *state)
{
    each_point(state, 0, 1);
    for (int32_t i = 0; i < state->count; i++)
        state->rates[i] = 0; // the contract: 0 where the length is
}
static void coincide_at_rest(KitState *state)
{
    each_point(state, 0, 0);
}
static void rest(KitState *state)
{
    each_point(state, 1, 0);
}
static void shrink(KitState *state)
{
    each_point(state, TINY, 1);
}
static void shrink_and_slow(KitState *state)
{
    each_point(state, TINY, TINY);
}
static void grow(KitState *state)
{
    each_point(state, HUGE_VALUE, 1);
}
static void speed_up(KitState *state)
{
    each_point(state, 1, HUGE_VALUE);
}
static void late(KitState *state)
{
    state->time = 1e6;
}
static void still_waves(KitState *state)
{
    for (int32_t i = 0; i < state->block_class->property_count; i++)
        if (state->block_class->properties[i].kind == TINKER_KIND_WAVEFORM)
            for (int c = 0; c < 3 * state->count; c++)
                state->columns[state->block_class->first_columns[i] + c / state->count][c % state->count] = 0;
}

static const struct {
    const char *label;
    Change change;
} changes[] = {
    {"coincident ends", coincide},
    {"coincident ends at rest", coincide_at_rest},
    {"zero velocity", rest},
    {"tiny distances", shrink},
    {"tiny distances and velocities", shrink_and_slow},
    {"huge distances", grow},
    {"huge velocities", speed_up},
    {"a late time", late},
    {"waveforms at zero", still_waves},
};

static void look_at_numbers(KitCheck *check, const KitFunction *function, const KitState *state,
                            const KitAnswer *answer)
{
    for (int k = 0; k < function->output_count; k++) {
        const KitOutput *output = &function->outputs[k];
        if (output->integers) continue;
        for (gsize i = 0; i < answer->entries[k]; i++) {
            const double value = answer->values[k][i];
            const gboolean negative = output->tolerance && value < 0;
            if ((isfinite(value) && !negative) || (output->infinite && value == INFINITY)) continue;
            if (kit_output_is_absent(output, state, value)) continue;
            const gsize entry = i / (gsize)output->width;
            g_autofree char *where = kit_entry_name(output, state, entry);
            g_autofree char *values = kit_entry_describe(output, state, entry);
            kit_fail(check, "%s: \"%s\" of %s is %g at %s%s (%s)", function->name, output->name, where,
                     isnan(value) ? NAN : value, state->label, // nan without the sign that it may have
                     negative ? ", which no length is" : "", values);
            return;
        }
    }
}

static void try_function(KitCheck *check, const KitFunction *function, const KitState *state)
{
    g_autoptr(KitAnswer) answer = kit_call(check, function, state);
    if (answer->status == TINKER_OK) {
        look_at_numbers(check, function, state, answer);
    } else if (answer->status == TINKER_FAILED) {
        if (answer->failure == NULL || answer->failure[0] == '\0')
            kit_fail(check, "%s fails at %s without a reason", function->name, state->label);
        else if (answer->failed_instance < 0 || answer->failed_instance >= state->count)
            kit_fail(check, "%s fails at %s and blames instance %d, 0 to %d was expected", function->name, state->label,
                     answer->failed_instance, state->count - 1);
    } else if (answer->status != TINKER_RETRY_SMALLER) {
        kit_fail(check, "%s answers %d at %s, 0 to 2 was expected", function->name, answer->status, state->label);
    }
}

/* A state that the block itself refuses is nobody's to evaluate. */
static void try_state(KitCheck *check, const GArray *functions, KitState *state)
{
    const char *failure;
    kit_phase(check, "prepare or check at %s", state->label);
    if (kit_state_prepare(state, &failure) != TINKER_OK) {
        if (failure == NULL) kit_fail(check, "it refuses %s without a reason", state->label);
        return;
    }
    for (guint i = 0; i < functions->len && !kit_decided(check); i++)
        try_function(check, &g_array_index(functions, KitFunction, i), state);
}

/* Least and greatest value that a user can give it; of an open end a value close by. */
static double limit_of(const TinkerPropertyType *property, gboolean greatest)
{
    const double span = property->flags & TINKER_HAS_SOFT_RANGE ? property->soft_maximum - property->soft_minimum : 1.0;
    if (property->kind == TINKER_KIND_SWITCH) return greatest;
    if (property->kind == TINKER_KIND_CHOICE) return greatest ? property->choice_count - 1 : 0;
    if (greatest) {
        if (!(property->flags & TINKER_HAS_MAXIMUM))
            return property->flags & TINKER_HAS_SOFT_RANGE ? property->soft_maximum : property->default_value[0] + 1;
        return property->hard_maximum - (property->flags & TINKER_OPEN_MAXIMUM ? 1e-9 * fabs(span) : 0);
    }
    if (!(property->flags & TINKER_HAS_MINIMUM))
        return property->flags & TINKER_HAS_SOFT_RANGE ? property->soft_minimum : property->default_value[0] - 1;
    return property->hard_minimum + (property->flags & TINKER_OPEN_MINIMUM ? 1e-9 * fabs(span) : 0);
}

static gboolean is_set_by_user(const TinkerPropertyType *property)
{
    return tinker_kind_columns(property->kind) > 0 && property->kind != TINKER_KIND_WAVEFORM &&
           !(property->flags & (TINKER_READ_ONLY | TINKER_DERIVED));
}

static void set_to_limit(KitState *state, int32_t number, gboolean greatest)
{
    const TinkerBlockClass *block_class = state->block_class;
    const TinkerPropertyType *property = &block_class->properties[number];
    for (int32_t c = 0; c < tinker_kind_columns(property->kind); c++)
        for (int32_t i = 0; i < state->count; i++)
            state->columns[block_class->first_columns[number] + c][i] = limit_of(property, greatest);
}

/* The states above, each with a property at a limit: a quotient of two that vanish is to be had only so. */
static void try_changes(KitCheck *check, const GArray *functions, const KitState *from, const char *with)
{
    for (gsize i = 0; i < G_N_ELEMENTS(changes) && !kit_decided(check); i++) {
        g_autoptr(KitState) state = kit_state_copy(from);
        changes[i].change(state);
        g_snprintf(state->label, sizeof state->label, "%s%s", changes[i].label, with);
        try_state(check, functions, state);
    }
}

static void try_limit(KitCheck *check, const GArray *functions, const KitState *ordinary, int32_t number,
                      gboolean greatest)
{
    const TinkerPropertyType *property = &ordinary->block_class->properties[number];
    g_autoptr(KitState) state = kit_state_copy(ordinary);
    g_autofree char *limit = g_strdup_printf("the %s of %s", greatest ? "greatest" : "least", property->id);
    g_autofree char *with = g_strconcat(" and ", limit, NULL);
    set_to_limit(state, number, greatest);
    g_strlcpy(state->label, limit, sizeof state->label);
    try_state(check, functions, state);
    if (!kit_decided(check)) try_changes(check, functions, state, with);
}

void kit_try_finite(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    if (functions->len == 0) {
        kit_skip(check, "it offers no function over batches");
        return;
    }
    g_autoptr(KitState) ordinary = kit_state_new(check, KIT_COUNT);
    if (ordinary == NULL) return;
    try_state(check, functions, ordinary);
    try_changes(check, functions, ordinary, "");
    for (int32_t i = 0; i < check->block_class->property_count && !kit_decided(check); i++) {
        if (!is_set_by_user(&check->block_class->properties[i])) continue;
        try_limit(check, functions, ordinary, i, FALSE);
        try_limit(check, functions, ordinary, i, TRUE);
    }
}

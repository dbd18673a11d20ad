/* batches: a function is a pure map of each instance, so it does not matter how the host cuts its batches. */
#include <string.h>

#include "conformance/probe/state.h"

#define ROUNDS 2

static void tell_difference(KitCheck *check, const KitFunction *function, int output, const KitState *state,
                            const char *how, gsize number, const void *whole, const void *other)
{
    const KitOutput *kind = &function->outputs[output];
    const gsize entry = number / (gsize)kind->width;
    g_autofree char *where = kit_entry_name(kind, state, entry), *values = kit_entry_describe(kind, state, entry);
    if (kind->integers) {
        kit_fail(check, "%s: \"%s\" of %s is %d in the whole batch and %d %s (%s)", function->name, kind->name, where,
                 ((const int32_t *)whole)[number], ((const int32_t *)other)[number], how, values);
        return;
    }
    kit_fail(check, "%s: \"%s\" of %s is %.17g in the whole batch and %.17g %s (%s)", function->name, kind->name, where,
             ((const double *)whole)[number], ((const double *)other)[number], how, values);
}

/* Compares `entries` of an answer with those of the whole from `first` on. `state` is the whole. */
static void compare(KitCheck *check, const KitFunction *function, int output, const KitState *state,
                    const KitAnswer *whole, const KitAnswer *part, gsize first, const char *how)
{
    const KitOutput *kind = &function->outputs[output];
    const gsize size = kind->integers ? sizeof(int32_t) : sizeof(double), skip = first * (gsize)kind->width;
    const char *a = (const char *)whole->values[output] + skip * size, *b = (const char *)part->values[output];
    for (gsize i = 0; i < part->entries[output]; i++) {
        if (memcmp(a + i * size, b + i * size, size) == 0) continue;
        tell_difference(check, function, output, state, how, skip + i, whole->values[output], b - skip * size);
        return;
    }
}

static void compare_repeated(KitCheck *check, const KitFunction *function, const KitState *state,
                             const KitAnswer *whole)
{
    g_autoptr(KitAnswer) again = kit_call(check, function, state);
    if (again->status != whole->status)
        kit_fail(check, "%s answers %d, and %d when it is called again with the same values", function->name,
                 whole->status, again->status);
    for (int k = 0; k < function->output_count && !kit_decided(check) && whole->status == TINKER_OK; k++)
        compare(check, function, k, state, whole, again, 0, "when it is called again with the same values");
}

static void compare_slice(KitCheck *check, const KitFunction *function, const KitState *state, const KitAnswer *whole,
                          int32_t first, int32_t count)
{
    g_autoptr(KitState) slice = kit_state_slice(state, first, count);
    g_autoptr(KitAnswer) part = kit_call(check, function, slice);
    if (part->status != TINKER_OK) {
        kit_fail(check, "%s answers %d for the %d instances from %d on, and %d for the whole batch", function->name,
                 part->status, count, first, whole->status);
        return;
    }
    g_autofree char *how = g_strdup_printf("in a slice of %d from %d on", count, first);
    for (int k = 0; k < function->output_count && !kit_decided(check); k++) {
        const KitOutput *kind = &function->outputs[k];
        if (kind->extent == KIT_ONCE || kind->extent == KIT_BODIES) continue;
        compare(check, function, k, state, whole, part, kit_output_first(kind, state, first), how);
    }
}

/* Of a field it is the bodies that are cut into ranges. */
static void compare_bodies(KitCheck *check, const KitFunction *function, const KitState *state, const KitAnswer *whole,
                           int32_t first, int32_t range)
{
    g_autoptr(KitState) cut = kit_state_copy(state);
    cut->first_body = first;
    cut->body_range = range;
    g_autoptr(KitAnswer) part = kit_call_well(check, function, cut);
    if (part == NULL) return;
    g_autofree char *how = g_strdup_printf("for the %d bodies from %d on alone", range, first);
    for (int k = 0; k < function->output_count && !kit_decided(check); k++)
        if (function->outputs[k].extent == KIT_BODIES)
            compare(check, function, k, state, whole, part, (gsize)first, how);
}

static void try_function(KitCheck *check, const KitFunction *function, const KitState *state)
{
    g_autoptr(KitAnswer) whole = kit_call(check, function, state);
    compare_repeated(check, function, state, whole);
    if (whole->status != TINKER_OK || kit_decided(check)) return; // not of that form
    static const int32_t cuts[][2] = {{0, 7}, {7, 1}, {8, KIT_COUNT - 8}};
    for (gsize i = 0; i < G_N_ELEMENTS(cuts) && !kit_decided(check); i++)
        compare_slice(check, function, state, whole, cuts[i][0], cuts[i][1]);
    for (int32_t i = 0; i < state->count && !kit_decided(check); i++)
        compare_slice(check, function, state, whole, i, 1);
    for (int32_t i = 0; i < state->body_count && !kit_decided(check); i++)
        compare_bodies(check, function, state, whole, i, i % 2 == 0 ? 1 : state->body_count - i);
}

void kit_try_batches(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    if (functions->len == 0) kit_skip(check, "it offers no function over batches");
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        for (guint i = 0; i < functions->len && !kit_decided(check); i++)
            try_function(check, &g_array_index(functions, KitFunction, i), state);
    }
}

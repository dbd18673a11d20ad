/* The signals of a piece as inputs: functions of time that follow from their own values at the start of a step.
 *
 * Modes that are apart share the functions (polynomials, and one pair for each frequency), each mode with
 * amplitudes of its own. Coupled modes have one input for each signal, whose direction is part of the matrix, and
 * one for the constant force on each mode without stiffness; on the others a constant force only shifts the place
 * that they move about.
 */
#include <math.h>
#include <string.h>

#include "numerics/exact/exact-private.h"

#define MOST_MEMORY  ((gsize)1 << 30) /* bytes of propagators of one part */
#define LEVEL_MEMORY ((gsize)1 << 27) /* bytes for the levels of halving, where they are wanted */

void tinker_exact_derivative(const TinkerLinearInput *input, const TinkerExactValues values, TinkerExactValues rate)
{
    if (input->count == 2) {
        rate[0] = input->rate * values[1];
        rate[1] = -input->rate * values[0];
        rate[2] = rate[3] = 0.0;
        return;
    }
    for (int k = 0; k < 3; k++)
        rate[k] = values[k + 1];
    rate[3] = 0.0;
}

double tinker_exact_bound(const TinkerLinearInput *input, const TinkerExactValues values, double h)
{
    if (input->count == 2) return hypot(values[0], values[1]);
    h = fabs(h);
    return fabs(values[0]) + h * (fabs(values[1]) + h * (fabs(values[2]) / 2.0 + h * fabs(values[3]) / 6.0));
}

/* One function for all polynomials, one for each frequency. */
static void find_basis(TinkerExactPart *part, const TinkerSignal *signals)
{
    part->basis[0] = (TinkerLinearInput){0, part->signal_count > 0 ? 4 : 1, 0.0};
    part->basis_count = 1;
    part->basis_entries = part->basis[0].count;
    for (int32_t s = 0; s < part->signal_count; s++) {
        const TinkerSignal *signal = &signals[part->signals[s].id];
        int32_t b = 0;
        if (signal->kind == TINKER_SIGNAL_HARMONIC) {
            for (b = 1; b < part->basis_count && part->basis[b].rate != signal->coefficient[1];)
                b++;
            if (b == part->basis_count) {
                part->basis[part->basis_count++] = (TinkerLinearInput){part->basis_entries, 2, signal->coefficient[1]};
                part->basis_entries += 2;
            }
        }
        part->basis_of[s] = b;
    }
}

static void use_basis(TinkerExactPart *part)
{
    part->input_count = part->basis_count;
    part->entries = part->basis_entries;
    memcpy(part->inputs, part->basis, (gsize)part->basis_count * sizeof *part->inputs);
    for (int32_t s = 0; s < part->signal_count; s++)
        part->signals[s].input = part->basis_of[s];
    memset(part->drive, 0, (gsize)part->entries * sizeof *part->drive);
    part->unit[0] = 1.0;
    for (int32_t i = 0; i < part->input_count; i++) {
        part->drive[part->inputs[i].first] = 1.0;
        part->moments[i] = (TinkerLinearMoment){i, part->unit};
    }
}

static void add_input(TinkerExactPart *part, int32_t count, double rate)
{
    part->inputs[part->input_count++] = (TinkerLinearInput){part->entries, count, rate};
    part->entries += count;
}

static void use_signals(TinkerExactPart *part)
{
    int32_t n = part->n, fixed = 0;
    part->input_count = part->entries = 0;
    for (int32_t j = 0; j < n; j++)
        if (part->omega[j] == 0.0) add_input(part, 1, 0.0);
    for (int32_t s = 0; s < part->signal_count; s++) {
        const TinkerLinearInput *function = &part->basis[part->basis_of[s]];
        part->signals[s].input = part->input_count;
        add_input(part, function->count, function->rate);
    }
    gsize entries = (gsize)part->entries;
    memset(part->drive, 0, (gsize)n * entries * sizeof *part->drive);
    for (int32_t j = 0; j < n; j++) {
        double *row = part->drive + (gsize)j * entries;
        if (part->omega[j] == 0.0) row[fixed++] = 1.0;
        for (int32_t s = 0; s < part->signal_count; s++) {
            const TinkerLinearInput *input = &part->inputs[part->signals[s].input];
            row[input->first] += part->signals[s].by_value[j];
            row[input->first + 1] += part->signals[s].by_rate[j] * (input->count == 2 ? input->rate : 1.0);
        }
    }
    for (int32_t k = 0; k < part->power_count; k++)
        part->moments[k] = (TinkerLinearMoment){part->signals[part->powers[k].signal].input, part->powers[k].direction};
}

/* What does not depend on the signals' forms, once. */
static gboolean allot_inputs(TinkerExactPart *part)
{
    GPtrArray *memory = part->memory;
    gsize n = (gsize)part->n, signals = (gsize)part->signal_count;
    gsize inputs = n + signals + 1, entries = n + 4 * signals + 4;
    part->basis = tinker_exact_allot(memory, signals + 1, sizeof *part->basis);
    part->basis_of = tinker_exact_allot(memory, signals, sizeof *part->basis_of);
    part->inputs = tinker_exact_allot(memory, inputs, sizeof *part->inputs);
    part->moments = tinker_exact_allot(memory, inputs + (gsize)part->power_count, sizeof *part->moments);
    part->drive = tinker_exact_allot(memory, part->coupled ? n * entries : entries, sizeof(double));
    part->amplitude = tinker_exact_allot(memory, n * (4 + 2 * signals) + entries + 2 * n, sizeof(double));
    part->slots = tinker_exact_allot(memory, TINKER_EXACT_MOST_LEVELS + 8, sizeof *part->slots);
    return part->basis && part->basis_of && part->inputs && part->moments && part->drive && part->amplitude &&
           part->slots;
}

static gboolean grow(double **memory, gsize *size, gsize needed)
{
    if (needed <= *size) return TRUE;
    g_free(*memory);
    *memory = needed > MOST_MEMORY / sizeof(double) ? NULL : g_try_malloc_n(needed, sizeof(double));
    *size = *memory ? needed : 0;
    return *memory != NULL;
}

/* Cuts the slots out of one block: six for steps, and some for what is looked at in between. */
static gboolean cut_slots(TinkerExactPart *part)
{
    gsize each = tinker_exact_slot_doubles(part);
    part->step_slots = 6;
    part->slot_count = part->step_slots + 2;
    if ((part->coupled || part->watched > 0) && each * sizeof(double) * TINKER_EXACT_MOST_LEVELS <= LEVEL_MEMORY)
        part->slot_count = part->step_slots + TINKER_EXACT_MOST_LEVELS;
    if (!grow(&part->slot_memory, &part->slot_memory_size, each * (gsize)part->slot_count)) return FALSE;
    if (tinker_exact_slots_prepare(part)) return TRUE;
    // Slots that are there count as ready.
    g_clear_pointer(&part->slot_memory, g_free);
    part->slot_memory_size = 0;
    return FALSE;
}

/* Propagators stay valid where the new signals are of the same kinds and frequencies. */
static gboolean are_inputs_same(const TinkerExactPart *part, const TinkerSignal *signals)
{
    for (int32_t s = 0; s < part->signal_count; s++) {
        const TinkerSignal *signal = &signals[part->signals[s].id];
        const TinkerLinearInput *input = &part->basis[part->basis_of[s]];
        gboolean harmonic = signal->kind == TINKER_SIGNAL_HARMONIC;
        if (input->count != (harmonic ? 2 : 4)) return FALSE;
        if (harmonic && input->rate != signal->coefficient[1]) return FALSE;
    }
    return TRUE;
}

gboolean tinker_exact_part_enter(TinkerExactPart *part, const TinkerSignal *signals)
{
    part->quiet = FALSE;
    if (!part->basis && !allot_inputs(part)) {
        part->basis = NULL; // all of it is asked for again
        return FALSE;
    }
    if (part->slot_memory && are_inputs_same(part, signals)) return TRUE;
    find_basis(part, signals);
    if (part->coupled)
        use_signals(part);
    else
        use_basis(part);
    return cut_slots(part);
}

/* energy, passive: a store of energy pulls back as much as it takes, and what is left of a force takes energy.
 *
 *   line law:       dE/dL = T(L, 0)             (T(L, rate) - T(L, 0)) rate >= 0
 *   force element:  F(x, 0) = -dE/dx            (F(x, v) - F(x, 0)) . v <= 0
 *   field:          F(x, 0) = -dE/dx            the same
 *
 * A law that is the gradient of a function gives no energy round a closed path. A waveform may give energy: what it moves
 * is booked as a motor's. */
#include <math.h>

#include "conformance/state-private.h"

#define CLOSE  1e-6 /* relative, of differences */
#define GIVEN  1e-9 /* of the power's size that rounding may give */
#define ROUNDS 2

static gboolean has_waveform(const TinkerBlockClass *block_class)
{
    for (int32_t i = 0; i < block_class->property_count; i++)
        if (block_class->properties[i].kind == TINKER_KIND_WAVEFORM) return TRUE;
    return FALSE;
}

static void set_at_rest(KitState *state)
{
    for (int32_t i = 0; i < state->count; i++)
        state->rates[i] = 0;
    for (int32_t e = 0; e < kit_state_end_count(state); e++)
        state->points[e].vx = state->points[e].vy = 0;
    for (int32_t b = 0; b < state->body_count; b++)
        state->bodies[b].vx = state->bodies[b].vy = 0;
}

/* Places, one after another: a length of each instance, or two of each end or body. */
static gsize place_count(const KitState *state, const KitFunction *force)
{
    return force->outputs[0].extent == KIT_INSTANCES ? 1
           : force->outputs[0].extent == KIT_BODIES  ? 2 * (gsize)state->body_count
                                                     : 2 * (gsize)kit_state_end_count(state);
}

/* Of a line law all lengths are moved at once: instances do not feel one another. */
static void move(KitState *state, const KitFunction *force, gsize place, double by)
{
    if (force->outputs[0].extent == KIT_INSTANCES) {
        for (int32_t i = 0; i < state->count; i++)
            state->lengths[i] += by;
        return;
    }
    TinkerPoint *point = force->outputs[0].extent == KIT_BODIES ? &state->bodies[place / 2] : &state->points[place / 2];
    *(place % 2 == 0 ? &point->x : &point->y) += by;
}

static KitAnswer *energies_at(KitCheck *check, const KitFunction *energy, const KitState *state,
                              const KitFunction *force, gsize place, double by)
{
    g_autoptr(KitState) moved = kit_state_copy(state);
    move(moved, force, place, by);
    return kit_call_well(check, energy, moved);
}

/* Differences of two widths, the second extrapolated: where they do not agree there is a kink, and nothing to compare. */
static void compare_place(KitCheck *check, const KitFunction *force, const KitFunction *energy, const KitState *state,
                          const KitAnswer *forces, gsize place, int *compared)
{
    const double h = 1e-3, sign = force->outputs[0].extent == KIT_INSTANCES ? 1.0 : -1.0;
    g_autoptr(KitAnswer) far_behind = energies_at(check, energy, state, force, place, -2 * h);
    g_autoptr(KitAnswer) behind = energies_at(check, energy, state, force, place, -h);
    g_autoptr(KitAnswer) ahead = energies_at(check, energy, state, force, place, h);
    g_autoptr(KitAnswer) far_ahead = energies_at(check, energy, state, force, place, 2 * h);
    if (kit_decided(check)) return;
    for (gsize i = 0; i < ahead->entries[0]; i++) {
        const gboolean line = force->outputs[0].extent == KIT_INSTANCES;
        if (!line && energy->outputs[0].extent == KIT_INSTANCES &&
            (int32_t)i != kit_output_instance(&force->outputs[0], state, place / 2))
            continue;
        const double near = (ahead->values[0][i] - behind->values[0][i]) / (2 * h);
        const double far = (far_ahead->values[0][i] - far_behind->values[0][i]) / (4 * h);
        const double slope = sign * (4 * near - far) / 3, given = forces->values[0][line ? i : place];
        const double size = fmax(fmax(fabs(slope), fabs(given)), 1e-6 * fabs(ahead->values[0][i]));
        if (fabs(near - far) > 1e-2 * size) continue;
        (*compared)++;
        if (fabs(slope - given) <= CLOSE * size + 1e-12) continue;
        g_autofree char *values = kit_state_describe(state, line || state->count == 1 ? (int32_t)i : -1);
        kit_fail(check, "%s is %.9g N where the gradient of the energy is %.9g N (%s)", force->outputs[0].name, given,
                 slope, values);
        return;
    }
}

/* Without energy nothing is stored, so a line law may not pull at rest: the host would book its power as taken by dampers. */
static void expect_no_pull(KitCheck *check, const KitFunction *force, const KitState *state)
{
    g_autoptr(KitAnswer) answer = kit_call_well(check, force, state);
    for (int32_t i = 0; answer != NULL && i < state->count; i++)
        if (answer->values[0][i] != 0)
            kit_fail(check, "the tension is %.6g N at rest, but it offers no `energy`: nothing would be stored",
                     answer->values[0][i]);
    kit_skip(check, "it stores no energy");
}

void kit_try_energy(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const TinkerPhysics *physics = check->block_class->physics;
    const KitFunction *energy = kit_function(functions, "energy"), *tension = kit_function(functions, "tension");
    const KitFunction *force = tension != NULL ? tension : kit_function(functions, "force");
    if (force == NULL)
        kit_skip(check, "it gives no force of its own");
    else if (has_waveform(check->block_class))
        kit_skip(check, "a waveform changes it: all of its power is booked as a motor's");
    else if (energy == NULL && tension == NULL)
        kit_skip(check, physics->field != NULL ? "it stores no energy: its power is booked as given by fields"
                                               : "it stores no energy: its power is booked as a motor's");
    if (kit_decided(check)) return;
    int compared = 0;
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        if (state == NULL) return;
        set_at_rest(state);
        if (energy == NULL) {
            expect_no_pull(check, force, state);
            return;
        }
        g_autoptr(KitAnswer) forces = kit_call_well(check, force, state);
        for (gsize place = 0; forces != NULL && place < place_count(state, force) && !kit_decided(check); place++)
            compare_place(check, force, energy, state, forces, place, &compared);
    }
    if (compared == 0) kit_skip(check, "the energy has kinks wherever it was tried");
}

/* The power that the part which depends on velocity gives to what it acts on. */
static double power_of(const KitState *state, const KitFunction *force, const double *moving, const double *resting,
                       gsize first, gsize count, double *size)
{
    double power = 0;
    for (gsize i = first; i < first + count; i++) {
        double velocity = 0;
        if (force->outputs[0].extent == KIT_INSTANCES)
            velocity = -state->rates[i];
        else {
            const TinkerPoint *p =
                force->outputs[0].extent == KIT_BODIES ? &state->bodies[i / 2] : &state->points[i / 2];
            velocity = i % 2 == 0 ? p->vx : p->vy;
        }
        power += (moving[i] - resting[i]) * velocity;
        *size += fmax(fabs(moving[i]), fabs(resting[i])) * fabs(velocity);
    }
    return power;
}

static void try_powers(KitCheck *check, const KitFunction *force)
{
    g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
    if (state == NULL) return;
    g_autoptr(KitState) resting = kit_state_copy(state);
    set_at_rest(resting);
    g_autoptr(KitAnswer) with = kit_call_well(check, force, state), without = kit_call_well(check, force, resting);
    const gboolean bodies = force->outputs[0].extent == KIT_BODIES;
    for (int32_t i = 0; with != NULL && without != NULL && i < (bodies ? 1 : state->count); i++) {
        const gsize width = (gsize)force->outputs[0].width;
        const gsize first = bodies ? 0 : width * kit_output_first(&force->outputs[0], state, i);
        const gsize past = bodies || i + 1 == state->count ? with->entries[0]
                                                           : width * kit_output_first(&force->outputs[0], state, i + 1);
        double size = 0;
        const double power = power_of(state, force, with->values[0], without->values[0], first, past - first, &size);
        if (!(power > GIVEN * size)) continue;
        g_autofree char *values = kit_state_describe(state, bodies ? -1 : i);
        kit_fail(check, "what depends on velocity gives %.6g W, none was expected (%s)", power, values);
        return;
    }
}

void kit_try_passive(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *tension = kit_function(functions, "tension");
    const KitFunction *force = tension != NULL ? tension : kit_function(functions, "force");
    if (force == NULL)
        kit_skip(check, "it gives no force of its own");
    else if (has_waveform(check->block_class))
        kit_skip(check, "a waveform drives it, which may give energy");
    else if (tension == NULL && kit_function(functions, "energy") == NULL)
        kit_skip(check, check->block_class->physics->field != NULL ? "its power is booked as given by fields"
                                                                   : "its power is booked as a motor's");
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++)
        try_powers(check, force);
}

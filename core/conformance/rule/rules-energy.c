/* energy, passive: a store of energy pulls back as much as it takes, and what is left of a force takes energy.
 *
 *   line law:       dE/dL = T(L, 0)             (T(L, rate) - T(L, 0)) rate >= 0
 *   force element:  F(x, 0) = -dE/dx            (F(x, v) - F(x, 0)) . v <= 0
 *   field:          F(x, 0) = -dE/dx            the same
 *
 * A law that is the gradient of a function gives no energy round a closed path. A waveform may give energy: what it
 * moves is booked as a motor's. */
#include <math.h>

#include "conformance/probe/differences.h"

#define GIVEN  1e-9 /* of the power's size that rounding may give */
#define ROUNDS 2

static const KitNearness nearness = {.close = 1e-6, .floor = 1e-6};

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
        state->points[e].vx = state->points[e].vy = state->poses[e].rate = 0;
    for (int32_t b = 0; b < state->body_count; b++)
        state->bodies[b].vx = state->bodies[b].vy = 0;
}

/* The torques against the energy's slopes along the angles of the ends. */
static void compare_turns(KitCheck *check, const KitFunction *force, const KitFunction *energy, const KitState *state,
                          const KitAnswer *forces, int *compared)
{
    int32_t most = 0;
    for (int32_t i = 0; force->output_count > 1 && i < state->count; i++)
        most = MAX(most, state->offsets[i + 1] - state->offsets[i]);
    for (int which = 0; which < most && !kit_decided(check); which++) {
        g_autofree double *slope = kit_slopes(check, energy, state, kit_turn_end, which, 1, nearness);
        for (int32_t i = 0; slope != NULL && i < state->count && !kit_decided(check); i++) {
            const int32_t end = state->offsets[i] + which;
            if (end >= state->offsets[i + 1] || isnan(slope[i])) continue;
            const double given = forces->values[1][end];
            (*compared)++;
            if (fabs(given + slope[i]) <= nearness.close * fmax(fabs(given), fabs(slope[i]))) continue;
            g_autofree char *values = kit_state_describe(state, i);
            kit_fail(check, "torque is %.9g N m where the gradient of the energy is %.9g N m (%s)", given, -slope[i],
                     values);
        }
    }
}

/* The number `entry` of the force against the energy's slope along it. `stored` is the energy. */
static void compare(KitCheck *check, const KitFunction *force, const KitState *state, const KitAnswer *forces,
                    gsize entry, double slope, double stored, int *compared)
{
    const KitExtent extent = force->outputs[0].extent;
    const double given = forces->values[0][entry], expected = extent == KIT_INSTANCES ? slope : -slope;
    if (isnan(slope) || kit_decided(check)) return;
    (*compared)++;
    const double size = fmax(fmax(fabs(expected), fabs(given)), nearness.floor * fabs(stored));
    if (fabs(expected - given) <= nearness.close * size) return;
    const gsize width = (gsize)force->outputs[0].width;
    g_autofree char *values = kit_entry_describe(&force->outputs[0], state, entry / width);
    kit_fail(check, "%s is %.9g N where the gradient of the energy is %.9g N (%s)", force->outputs[0].name, given,
             expected, values);
}

/* One coordinate: the length of all instances, a component of their end number which / 2, or of a body. Instances do
 * not feel one another, so all of them are moved at once. */
static void compare_along(KitCheck *check, const KitFunction *force, const KitFunction *energy, const KitState *state,
                          const KitAnswer *forces, const KitAnswer *stored, int which, int *compared)
{
    const KitExtent extent = force->outputs[0].extent;
    const KitMove move = extent == KIT_INSTANCES ? kit_move_line : extent == KIT_ENDS ? kit_move_end : kit_move_body;
    const int coordinate = extent == KIT_BODIES ? which / 2 * 4 + which % 2 : which;
    g_autofree double *slope = kit_slopes(check, energy, state, move, coordinate, 1, nearness);
    if (slope == NULL) return;
    if (extent == KIT_BODIES) {
        compare(check, force, state, forces, (gsize)which, slope[0], stored->values[0][0], compared);
        return;
    }
    for (int32_t i = 0; i < state->count; i++) {
        const int32_t end = state->offsets[i] + which / 2;
        if (extent == KIT_ENDS && end >= state->offsets[i + 1]) continue;
        const int32_t entry = extent == KIT_ENDS ? 2 * end + which % 2 : i;
        compare(check, force, state, forces, (gsize)entry, slope[i], stored->values[0][i], compared);
    }
}

static void compare_all(KitCheck *check, const KitFunction *force, const KitFunction *energy, const KitState *state,
                        int *compared)
{
    g_autoptr(KitAnswer) forces = kit_call_well(check, force, state), stored = kit_call_well(check, energy, state);
    int32_t coordinates = force->outputs[0].extent == KIT_BODIES ? 2 * state->body_count : 1;
    for (int32_t i = 0; force->outputs[0].extent == KIT_ENDS && i < state->count; i++)
        coordinates = MAX(coordinates, 2 * (state->offsets[i + 1] - state->offsets[i]));
    for (int which = 0; forces != NULL && stored != NULL && which < coordinates && !kit_decided(check); which++)
        compare_along(check, force, energy, state, forces, stored, which, compared);
    if (forces != NULL && stored != NULL) compare_turns(check, force, energy, state, forces, compared);
}

/* Without energy nothing is stored, so a line law may not pull at rest: the host would book its power as taken by
 * dampers. */
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
        compare_all(check, force, energy, state, &compared);
    }
    if (compared == 0) kit_skip(check, "the energy has kinks, or sharp bends, wherever it was tried");
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
        double power = power_of(state, force, with->values[0], without->values[0], first, past - first, &size);
        for (gsize e = first / 2; force->output_count > 1 && force->outputs[1].angular && e < past / 2; e++) {
            power += (with->values[1][e] - without->values[1][e]) * state->poses[e].rate;
            size += fmax(fabs(with->values[1][e]), fabs(without->values[1][e])) * fabs(state->poses[e].rate);
        }
        if (!(power > GIVEN * size)) continue;
        g_autofree char *values = kit_state_describe(state, bodies ? -1 : i);
        kit_fail(check, "what depends on velocity gives %.6g W, none was expected (%s)", power, values);
        return;
    }
}

static gboolean dissipates(const TinkerBlockClass *block_class)
{
    const TinkerForceElement *element = block_class->physics->force_element;
    return element != NULL && element->dissipates != 0;
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
    else if (tension == NULL && kit_function(functions, "energy") == NULL && !dissipates(check->block_class))
        kit_skip(check, check->block_class->physics->field != NULL ? "its power is booked as given by fields"
                                                                   : "its power is booked as a motor's");
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++)
        try_powers(check, force);
}

/* derivatives, jacobian, drift, motion: what is given as a derivative agrees with differences. */
#include <math.h>

#include "conformance/probe/differences.h"

#define ROUNDS 2

static const KitNearness nearness = {.close = 2e-6, .floor = 1e-3};

static double *slopes(KitCheck *check, const KitFunction *function, const KitState *state, KitMove move, int which,
                      int degree)
{
    return kit_slopes(check, function, state, move, which, degree, nearness);
}

/* One number against its slope. `number` is that of the instance, or of the body that a field acts on; `size` is what
 * rounding is measured by. */
static void compare(KitCheck *check, const KitState *state, int32_t number, const char *what, double given,
                    double slope, double size, int *compared)
{
    if (isnan(slope) || kit_decided(check)) return;
    (*compared)++;
    if (fabs(given - slope) <= nearness.close * fmax(fmax(fabs(given), fabs(slope)), size)) return;
    const gboolean field = state->block_class->physics->field != NULL;
    g_autofree char *whose = field ? g_strdup_printf("body %d", number) : g_strdup_printf("instance %d", number);
    g_autofree char *values = field ? kit_state_describe_body(state, number) : kit_state_describe(state, number);
    kit_fail(check, "%s of %s is %.9g, by differences it is %.9g (%s)", what, whose, given, slope, values);
}

static void try_line(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    const KitFunction *derivatives = kit_function(functions, "derivatives"),
                      *tension = kit_function(functions, "tension");
    g_autoptr(KitAnswer) given = kit_call_well(check, derivatives, state), at = kit_call_well(check, tension, state);
    for (int which = 0; which < 2 && given != NULL && at != NULL; which++) {
        g_autofree double *slope = slopes(check, tension, state, kit_move_line, which, 1);
        for (int32_t i = 0; slope != NULL && i < state->count; i++)
            compare(check, state, i, which == 0 ? "by_length" : "by_rate", given->values[which][i], slope[i],
                    1e-3 * fabs(at->values[0][i]), compared);
    }
}

static void try_field(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    const KitFunction *derivatives = kit_function(functions, "derivatives"), *force = kit_function(functions, "force");
    g_autoptr(KitAnswer) given = kit_call_well(check, derivatives, state), at = kit_call_well(check, force, state);
    for (int which = 0; which < 4 * state->body_count && given != NULL && at != NULL && !kit_decided(check); which++) {
        g_autofree double *slope = slopes(check, force, state, kit_move_body, which, 1);
        const int body = which / 4, part = which % 4;
        for (int row = 0; slope != NULL && row < 2; row++) {
            g_autofree char *what = g_strdup_printf("jacobian[%d]", (part < 2 ? 0 : 4) + 2 * row + part % 2);
            compare(check, state, body, what, given->values[0][8 * body + (part < 2 ? 0 : 4) + 2 * row + part % 2],
                    slope[2 * body + row], 1e-3 * hypot(at->values[0][2 * body], at->values[0][2 * body + 1]),
                    compared);
        }
    }
}

static void try_ends(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    const KitFunction *rows = kit_function(functions, "rows_at");
    g_autoptr(KitAnswer) given = kit_call_well(check, rows, state);
    const int32_t row_count = kit_state_rows(state);
    int32_t most = 0;
    for (int32_t i = 0; i < state->count; i++)
        most = MAX(most, state->offsets[i + 1] - state->offsets[i]);
    for (int which = 0; given != NULL && which < 2 * most && !kit_decided(check); which++) {
        g_autofree double *slope = slopes(check, rows, state, kit_move_end, which, 1);
        for (int32_t i = 0; slope != NULL && i < state->count; i++) {
            const int32_t ends = state->offsets[i + 1] - state->offsets[i];
            if (which / 2 >= ends) continue;
            for (int32_t r = 0; r < row_count; r++) {
                g_autofree char *what = g_strdup_printf("row %d: d g / d %c of end %d", r, "xy"[which % 2], which / 2);
                const int32_t at = 2 * (row_count * state->offsets[i] + r * ends + which / 2) + which % 2;
                compare(check, state, i, what, given->values[1][at], slope[i * row_count + r], 1e-3, compared);
            }
        }
    }
}

static void try_turns(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    const KitFunction *rows = kit_function(functions, "rows_at");
    g_autoptr(KitAnswer) given = rows->output_count > 3 ? kit_call_well(check, rows, state) : NULL;
    const int32_t row_count = kit_state_rows(state);
    int32_t most = 0;
    for (int32_t i = 0; i < state->count; i++)
        most = MAX(most, state->offsets[i + 1] - state->offsets[i]);
    for (int which = 0; given != NULL && which < most && !kit_decided(check); which++) {
        g_autofree double *slope = slopes(check, rows, state, kit_turn_end, which, 1);
        for (int32_t i = 0; slope != NULL && i < state->count; i++) {
            const int32_t ends = state->offsets[i + 1] - state->offsets[i];
            for (int32_t r = 0; which < ends && r < row_count; r++) {
                g_autofree char *what = g_strdup_printf("row %d: d g / d angle of end %d", r, which);
                const int32_t at = row_count * state->offsets[i] + r * ends + which;
                compare(check, state, i, what, given->values[3][at], slope[i * row_count + r], 1e-3, compared);
            }
        }
    }
}

static void try_columns(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    try_ends(check, functions, state, compared);
    try_turns(check, functions, state, compared);
}

static void try_drift(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    const KitFunction *rows = kit_function(functions, "rows_at"), *rate = kit_function(functions, "prescribed_rate");
    g_autoptr(KitAnswer) given = kit_call_well(check, rows, state);
    g_autofree double *bend = given == NULL ? NULL : slopes(check, rows, state, kit_go_on, 1, 2);
    g_autofree double *slope = bend == NULL ? NULL : slopes(check, rows, state, kit_go_on, 0, 1);
    g_autoptr(KitAnswer) told = slope == NULL || rate == NULL ? NULL : kit_call_well(check, rate, state);
    const int32_t row_count = kit_state_rows(state);
    for (int32_t k = 0; slope != NULL && k < row_count * state->count; k++) {
        compare(check, state, k / row_count, "drift", given->values[2][k], bend[k], 1e-2, compared);
        compare(check, state, k / row_count, "prescribed_rate", told != NULL ? told->values[0][k] : 0, slope[k], 1e-3,
                compared);
    }
}

static void try_motion(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    const KitFunction *motion = kit_function(functions, "motion");
    g_autoptr(KitAnswer) given = kit_call_well(check, motion, state);
    g_autofree double *first = given == NULL ? NULL : slopes(check, motion, state, kit_go_on, 0, 1);
    g_autofree double *second = first == NULL ? NULL : slopes(check, motion, state, kit_go_on, 0, 2);
    for (int32_t k = 0; second != NULL && k < 2 * state->count; k++) {
        compare(check, state, k / 2, k % 2 == 0 ? "the x velocity" : "the y velocity", given->values[1][k], first[k],
                1e-3, compared);
        compare(check, state, k / 2, k % 2 == 0 ? "the x acceleration" : "the y acceleration", given->values[2][k],
                second[k], 1e-3, compared);
    }
}

static void try_rotation(KitCheck *check, const GArray *functions, const KitState *state, int *compared)
{
    const KitFunction *rotation = kit_function(functions, "rotation");
    g_autoptr(KitAnswer) given = kit_call_well(check, rotation, state);
    g_autofree double *first = given == NULL ? NULL : slopes(check, rotation, state, kit_go_on, 0, 1);
    g_autofree double *second = first == NULL ? NULL : slopes(check, rotation, state, kit_go_on, 0, 2);
    for (int32_t i = 0; second != NULL && i < state->count; i++) {
        compare(check, state, i, "the rate", given->values[0][3 * i + 1], first[3 * i], 1e-3, compared);
        compare(check, state, i, "the angular acceleration", given->values[0][3 * i + 2], second[3 * i], 1e-3,
                compared);
    }
}

static void try_with(KitCheck *check, const char *needed, const char *absent,
                     void (*try_state)(KitCheck *, const GArray *, const KitState *, int *))
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    int compared = 0;
    if (try_state == NULL || kit_function(functions, needed) == NULL) {
        kit_skip(check, "%s", absent);
        return;
    }
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        if (state != NULL) try_state(check, functions, state, &compared);
    }
    if (compared == 0) kit_skip(check, "there are kinks, or sharp bends, wherever it was tried");
}

void kit_try_derivatives(KitCheck *check)
{
    const TinkerPhysics *physics = check->block_class->physics;
    const gboolean line = physics != NULL && physics->line_law != NULL;
    try_with(check, "derivatives", "it offers no derivatives: the host takes differences", line ? try_line : try_field);
}

void kit_try_jacobian(KitCheck *check)
{
    try_with(check, "rows_at", "it is no constraint", try_columns);
}

void kit_try_drift(KitCheck *check)
{
    try_with(check, "rows_at", "it is no constraint", try_drift);
}

void kit_try_motion(KitCheck *check)
{
    const TinkerPhysics *physics = check->block_class->physics;
    const gboolean turns = physics != NULL && physics->motion != NULL && physics->motion->motion == NULL;
    try_with(check, turns ? "rotation" : "motion", "it is no motion", turns ? try_rotation : try_motion);
}

/* momentum, moment: internal forces sum to zero, and give no moment.
 *
 * A force on one body alone, one of the category "force", and a field in which bodies do not feel one another, act from
 * outside: they may change momentum. */
#include <math.h>

#include "conformance/rule/rules-symmetry-private.h"

#define ROUNDS 3
#define CLOSE  1e-8 /* of the sizes of what is added */

static const KitFunction *force_function(KitCheck *check, const GArray *functions)
{
    const KitFunction *function = symmetry_function(check, functions);
    if (function == NULL) return NULL;
    if (check->block_class->physics->constraint != NULL)
        kit_skip(check, "for a constraint it follows from translation, rotation and jacobian");
    else if (!symmetry_is_internal(check->block_class))
        kit_skip(check, check->block_class->physics->field != NULL
                            ? "a field that does not couple bodies acts from outside"
                            : "a force element of one end, or of the category \"force\", acts from outside");
    return kit_decided(check) ? NULL : function;
}

typedef struct {
    double force[2], moment, size; /* size: sum of the magnitudes of all forces */
    double reach;                  /* largest distance from the middle */
    double turning;                /* sum of the magnitudes of all torques */
} Sum;

/* `torques` of the ends, or NULL. */
static Sum sum_of(const TinkerPoint *points, const double *force, const double *torques, int32_t count)
{
    Sum sum = {{0, 0}, 0, 0, 0, 0};
    double x = 0, y = 0;
    for (int32_t i = 0; i < count; i++) {
        x += points[i].x / count;
        y += points[i].y / count;
    }
    for (int32_t i = 0; i < count; i++) {
        const double dx = points[i].x - x, dy = points[i].y - y;
        sum.force[0] += force[2 * i];
        sum.force[1] += force[2 * i + 1];
        sum.moment += dx * force[2 * i + 1] - dy * force[2 * i];
        sum.size += hypot(force[2 * i], force[2 * i + 1]);
        sum.reach = fmax(sum.reach, hypot(dx, dy));
        if (torques == NULL) continue;
        sum.moment += torques[i];
        sum.turning += fabs(torques[i]);
    }
    return sum;
}

static gboolean is_zero(double value, double size)
{
    return fabs(value) <= CLOSE * size;
}

/* What a blow between ends gives one of them it takes from the others, as a force does. */
static void try_blow(KitCheck *check, const GArray *functions)
{
    if (kit_function(functions, "blow") == NULL) return;
    g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
    if (state == NULL) return;
    g_autoptr(KitAnswer) answer = kit_call_first_blow(check, functions, state);
    for (int32_t i = 0; answer != NULL && i < state->count && !kit_decided(check); i++) {
        const int32_t from = state->offsets[i], ends = state->offsets[i + 1] - from;
        const Sum sum = sum_of(state->points + from, answer->values[0] + 2 * from, NULL, ends);
        if (is_zero(hypot(sum.force[0], sum.force[1]), sum.size)) continue;
        g_autofree char *values = kit_state_describe(state, i);
        kit_fail(check, "the impulses of its blow sum to (%.6g, %.6g) N s, 0 was expected (%s)", sum.force[0],
                 sum.force[1], values);
    }
}

static void judge_sum(KitCheck *check, const KitState *state, int32_t instance, Sum sum, gboolean moment)
{
    g_autofree char *values = kit_state_describe(state, instance);
    const gboolean balanced = is_zero(hypot(sum.force[0], sum.force[1]), sum.size);
    if (moment && !balanced)
        kit_skip(check, "the forces do not sum to zero, so that their moment depends on the point: see momentum");
    else if (moment && !is_zero(sum.moment, sum.size * sum.reach + sum.turning))
        kit_fail(check, "the forces have the moment %.6g N m about the middle of the ends, 0 was expected (%s)",
                 sum.moment, values);
    else if (!moment && !balanced)
        kit_fail(check, "the forces sum to (%.6g, %.6g) N, 0 was expected (%s)", sum.force[0], sum.force[1], values);
}

static void try_sums(KitCheck *check, gboolean moment)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *function = force_function(check, functions);
    for (int round = 0; round < ROUNDS && function != NULL && !kit_decided(check); round++) {
        if (!moment) try_blow(check, functions);
        if (kit_decided(check)) return;
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        g_autoptr(KitAnswer) answer = state == NULL ? NULL : kit_call_well(check, function, state);
        if (answer == NULL) return;
        if (function->outputs[0].extent == KIT_BODIES) {
            judge_sum(check, state, -1, sum_of(state->bodies, answer->values[0], NULL, state->body_count), moment);
            continue;
        }
        for (int32_t i = 0; i < state->count && !kit_decided(check); i++) {
            const int32_t from = state->offsets[i];
            judge_sum(check, state, i,
                      sum_of(state->points + from, answer->values[0] + 2 * from,
                             function->output_count > 1 ? answer->values[1] + from : NULL,
                             state->offsets[i + 1] - from),
                      moment);
        }
    }
}

void kit_try_momentum(KitCheck *check)
{
    try_sums(check, FALSE);
}

void kit_try_moment(KitCheck *check)
{
    try_sums(check, TRUE);
}

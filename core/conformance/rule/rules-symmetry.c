/* translation, rotation: moved or turned with all of its scene, a block answers the same.
 *
 * What acts from outside (see momentum) may depend on the place. Turned with the scene it has to be all the same, as
 * far as its properties tell a direction: properties that are vectors, and angles, are turned along where that explains
 * the answer. An angle between two arms does not turn, the angle of a force does; which is which is found by trying. */
#include <math.h>
#include <string.h>

#include "conformance/rule/rules-symmetry-private.h"

#define ROUNDS        3
#define CLOSE         1e-8 /* of the largest of an instance's numbers */
#define MOST_PARTNERS 6    /* properties that are tried in all combinations */

gboolean symmetry_is_internal(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    if (physics->field != NULL) return physics->field->couples_bodies != 0;
    return block_class->type->least_ends >= 2 && strcmp(block_class->type->category, TINKER_FORCE) != 0;
}

const KitFunction *symmetry_function(KitCheck *check, const GArray *functions)
{
    const TinkerPhysics *physics = check->block_class->physics;
    const char *reason = NULL;
    if (physics == NULL)
        reason = "it has no physics";
    else if (physics->line_law != NULL)
        reason = "a line law holds it by construction: it sees a length alone, and the host pulls both ends along it";
    else if (physics->motion != NULL)
        reason = "a motion is prescribed, and exerts no force";
    else if (physics->body != NULL && physics->force_element == NULL && physics->field == NULL &&
             physics->constraint == NULL)
        reason = "a body exerts no force";
    if (reason != NULL) {
        kit_skip(check, "%s", reason);
        return NULL;
    }
    return kit_function(functions, physics->constraint != NULL ? "rows_at" : "force");
}

/* Whether a property may take part: as a vector, as an angle of a direction, as a place. The phase of a waveform is an
 * angle of another kind. */
static gboolean may_take_part(const TinkerBlockClass *block_class, int32_t number, gboolean turn)
{
    const TinkerPropertyType *property = &block_class->properties[number];
    const TinkerDimension d = property->dimension;
    if (property->kind == TINKER_KIND_VECTOR)
        return turn || (d.mass == 0 && d.length == 1 && d.time == 0 && d.angle == 0);
    if (!turn || property->kind != TINKER_KIND_REAL) return FALSE;
    for (int32_t i = 0; i < block_class->property_count; i++)
        if (g_strcmp0(block_class->properties[i].phase, property->id) == 0) return FALSE;
    return d.mass == 0 && d.length == 0 && d.time == 0 && d.angle == 1;
}

/* Largest difference, relative to the largest number of the instance. */
static double miss_of(const KitFunction *function, const KitState *state, const KitAnswer *expected,
                      const KitAnswer *answer)
{
    double worst = 0;
    for (int k = 0; k < function->output_count; k++) {
        const KitOutput *output = &function->outputs[k];
        const gsize width = (gsize)output->width, entries = answer->entries[k] / width;
        for (gsize first = 0; first < entries;) {
            gsize past = first;
            double size = 0, miss = 0;
            const int32_t instance = kit_output_instance(output, state, first);
            for (; past < entries && kit_output_instance(output, state, past) == instance; past++)
                for (gsize c = past * width; c < (past + 1) * width; c++) {
                    size = fmax(size, fabs(expected->values[k][c]));
                    miss = fmax(miss, fabs(answer->values[k][c] - expected->values[k][c]));
                }
            if (miss > 0) worst = fmax(worst, size > 0 ? miss / size : INFINITY);
            first = past;
        }
    }
    return worst;
}

static gboolean is_joint(const KitState *state)
{
    const TinkerConstraint *constraint = state->block_class->physics->constraint;
    return constraint != NULL && constraint->joint == 1 && constraint->rows >= 2;
}

static double miss_with(KitCheck *check, const KitFunction *function, const KitState *state, const KitAnswer *expected,
                        const SymmetryChange *change, const int32_t *partners, guint taking_part)
{
    g_autoptr(KitState) changed = kit_state_copy(state);
    symmetry_change_points(change, changed->points, kit_state_end_count(changed));
    symmetry_change_points(change, changed->placed, kit_state_end_count(changed));
    symmetry_change_points(change, changed->bodies, changed->body_count);
    for (int32_t e = 0; change->turn && e < kit_state_end_count(changed); e++) {
        if (!changed->has_angle[e]) continue;
        changed->poses[e].angle += change->angle;
        changed->placed_poses[e].angle += change->angle;
    }
    for (int k = 0; k < MOST_PARTNERS; k++)
        if (taking_part & 1u << k) symmetry_change_property(changed, partners[k], change);
    g_strlcpy(changed->label, change->turn ? "turned values" : "shifted values", sizeof changed->label);
    const char *failure;
    if (kit_state_prepare(changed, &failure) != TINKER_OK) return INFINITY;
    g_autoptr(KitAnswer) answer = kit_call(check, function, changed);
    return answer->status == TINKER_OK ? miss_of(function, state, expected, answer) : INFINITY;
}

/* Which properties took part, as words. (transfer full) */
static char *names_of(const TinkerBlockClass *block_class, const int32_t *partners, guint taking_part)
{
    GString *names = g_string_new(NULL);
    for (int k = 0; k < MOST_PARTNERS; k++)
        if (taking_part & 1u << k)
            g_string_append_printf(names, "%s\"%s\"", names->len > 0 ? ", " : "",
                                   block_class->properties[partners[k]].id);
    return g_string_free(names, FALSE);
}

static void report_miss(KitCheck *check, double miss, gboolean turn)
{
    const char *what = turn ? "turned" : "shifted";
    if (symmetry_is_internal(check->block_class))
        kit_fail(check, "with the scene %s, the answer differs by %.3g of its size, whichever of its properties %s",
                 what, miss, turn ? "turn along" : "move along");
    else
        kit_skip(check, "it acts from outside and %s",
                 turn ? "has a direction that no property tells" : "depends on the place");
}

/* A mass does not turn along with the scene. */
static void let_all_turn(KitState *state)
{
    for (int32_t e = 0; e < kit_state_end_count(state); e++)
        state->has_angle[e] = 1;
}

/* A combination of properties has to explain the answers of all rounds. */
static void try_change(KitCheck *check, const KitFunction *function, gboolean turn)
{
    const TinkerBlockClass *block_class = check->block_class;
    int32_t partners[MOST_PARTNERS], count = 0;
    for (int32_t i = 0; i < block_class->property_count && count < MOST_PARTNERS; i++)
        if (may_take_part(block_class, i, turn)) partners[count++] = i;
    double misses[1 << MOST_PARTNERS] = {0};
    for (int round = 0; round < ROUNDS; round++) {
        const double angle = g_rand_double_range(check->random, 0.3, 2.8);
        const SymmetryChange change = {turn, {turn ? cos(angle) : 7.25, turn ? sin(angle) : -3.5}, angle};
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        if (turn && state != NULL) let_all_turn(state);
        g_autoptr(KitAnswer) expected = state == NULL ? NULL : kit_call_well(check, function, state);
        if (expected == NULL) return;
        symmetry_change_answer(function, expected, &change);
        if (turn && is_joint(state)) symmetry_change_joint_rows(function, state, expected, &change);
        for (guint taking_part = 0; taking_part < 1u << count; taking_part++)
            misses[taking_part] =
                fmax(misses[taking_part], miss_with(check, function, state, expected, &change, partners, taking_part));
    }
    double least = misses[0];
    for (guint taking_part = 0; taking_part < 1u << count; taking_part++) {
        least = fmin(least, misses[taking_part]);
        if (!(misses[taking_part] <= CLOSE)) continue;
        g_autofree char *names = names_of(block_class, partners, taking_part);
        if (taking_part != 0) kit_tell(check, "%s %s along", names, turn ? "turning" : "moving");
        return;
    }
    report_miss(check, least, turn);
}

static void move_back(TinkerPoint *points, int32_t count, const double origin[2])
{
    for (int32_t i = 0; i < count; i++) {
        points[i].x -= origin[0];
        points[i].y -= origin[1];
    }
}

/* The host chooses from where places are told, and says so in batch->origin: nothing may depend on it. */
static void try_origin(KitCheck *check, const KitFunction *function)
{
    g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
    g_autoptr(KitState) other = state == NULL ? NULL : kit_state_copy(state);
    g_autoptr(KitAnswer) expected = state == NULL ? NULL : kit_call_well(check, function, state);
    if (expected == NULL) return;
    other->origin[0] = 6.5;
    other->origin[1] = -9.25;
    move_back(other->points, kit_state_end_count(other), other->origin);
    move_back(other->placed, kit_state_end_count(other), other->origin);
    move_back(other->bodies, other->body_count, other->origin);
    g_strlcpy(other->label, "another origin", sizeof other->label);
    g_autoptr(KitAnswer) answer = kit_call_well(check, function, other);
    const double miss = answer == NULL ? 0 : miss_of(function, state, expected, answer);
    if (!(miss <= CLOSE))
        kit_fail(
            check,
            "with batch->origin at (%g, %g) m and all ends told from there, the answer differs by %.3g of its size",
            other->origin[0], other->origin[1], miss);
}

void kit_try_translation(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *function = symmetry_function(check, functions);
    if (function != NULL) try_origin(check, function);
    if (function != NULL && !kit_decided(check)) try_change(check, function, FALSE);
}

void kit_try_rotation(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *function = symmetry_function(check, functions);
    if (function != NULL) try_change(check, function, TRUE);
}

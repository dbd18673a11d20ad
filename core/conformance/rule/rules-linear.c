/* linear, breaks: short cuts that the host takes instead of the general functions say the same; breaks lie ahead. */
#include <math.h>
#include <string.h>

#include "conformance/probe/state.h"

#define CLOSE  1e-9
#define ROUNDS 2
#define BREAKS 50

/* `number` is that of the instance, or of the body that a field acts on. */
static void compare(KitCheck *check, const KitState *state, int32_t number, const char *what, double general,
                    double simple, double size)
{
    if (fabs(general - simple) <= CLOSE * fmax(fmax(fabs(general), fabs(simple)), size)) return;
    const gboolean field = state->block_class->physics->field != NULL;
    g_autofree char *whose = field ? g_strdup_printf("body %d", number) : g_strdup_printf("instance %d", number);
    g_autofree char *values = field ? kit_state_describe_body(state, number) : kit_state_describe(state, number);
    kit_fail(check, "%s of %s is %.12g, by the short form %.12g (%s)", what, whose, general, simple, values);
}

static void compare_line(KitCheck *check, const KitState *state, const KitAnswer *general, const KitAnswer *form)
{
    for (int32_t i = 0; i < state->count; i++) {
        double *const *f = form->values; // stiffness, damping, length, tension
        const double spring = f[0][i] * (state->lengths[i] - f[2][i]), damper = f[1][i] * state->rates[i];
        compare(check, state, i, "tension", general->values[0][i], f[3][i] + spring + damper,
                fabs(spring) + fabs(damper) + fabs(f[3][i]));
    }
}

/* The columns of the waveform that a form names; NULL where it names none that there is. */
static double *const *wave_of(KitCheck *check, const KitState *state, const double *columns, int32_t instance)
{
    const int32_t column = ((const int32_t *)(const void *)columns)[instance];
    const TinkerBlockClass *c = state->block_class;
    for (int32_t k = 0; k < c->property_count; k++)
        if (c->properties[k].kind == TINKER_KIND_WAVEFORM && c->first_columns[k] == column)
            return state->columns + column;
    if (column != -1) kit_fail(check, "column %d is not the first one of a waveform", column);
    return NULL;
}

static void compare_force(KitCheck *check, const KitState *state, const KitAnswer *general, const KitAnswer *form)
{
    for (int32_t i = 0; i < state->count; i++) {
        double *const *wave = wave_of(check, state, form->values[2], i);
        for (int32_t k = 2 * state->offsets[i]; k < 2 * state->offsets[i + 1]; k++) {
            const double driven = wave != NULL ? wave[0][i] * form->values[1][k] : 0;
            compare(check, state, i, "force", general->values[0][k], form->values[0][k] + driven, fabs(driven));
        }
    }
}

/* Torques of two ends that are linear in their angles. */
static void compare_torsion(KitCheck *check, const KitState *state, const KitAnswer *general, const KitAnswer *form)
{
    double *const *f = form->values; // stiffness, damping, rest, waveform column
    for (int32_t i = 0; i < state->count; i++) {
        double *const *wave = wave_of(check, state, f[3], i);
        const int32_t first = state->offsets[i], ends = state->offsets[i + 1] - first;
        const TinkerPose *a = &state->poses[first], *b = a + 1;
        const double spring = ends > 1 ? f[0][i] * (b->angle - a->angle - f[2][i]) : 0;
        const double damper = ends > 1 ? f[1][i] * (b->rate - a->rate) : 0, driven = wave != NULL ? wave[0][i] : 0;
        for (int32_t k = 0; k < ends; k++) {
            const double torque = spring + damper + driven;
            compare(check, state, i, "torque", general->values[1][first + k], k == 0 ? torque : -torque,
                    fabs(spring) + fabs(damper) + fabs(driven));
            for (int axis = 0; axis < 2; axis++)
                compare(check, state, i, "force", general->values[0][2 * (first + k) + axis], 0, 0);
        }
    }
}

/* The last row, of angles alone; of more rows, those of ends at one place come before it. */
static void compare_turning(KitCheck *check, const KitState *state, const KitAnswer *general, const KitAnswer *form)
{
    const int32_t rows = kit_state_rows(state);
    if (rows != 1 && rows != 3) kit_fail(check, "it turns by the last of 1 or 3 rows, not of %d", rows);
    for (int32_t i = 0; i < state->count && !kit_decided(check); i++) {
        const double *g = general->values[0] + rows * i;
        double sum = 0, size = 0;
        for (int32_t e = state->offsets[i]; e < state->offsets[i + 1]; e++) {
            if (!state->has_angle[e]) return;
            sum += form->values[0][e] * (state->poses[e].angle - state->placed_poses[e].angle);
            size += fabs(form->values[0][e] * state->poses[e].angle);
        }
        compare(check, state, i, "g", g[rows - 1], sum, size);
        const TinkerPoint *a = &state->points[state->offsets[i]], *b = a + 1;
        if (rows > 1) compare(check, state, i, "g", g[0], b->x - a->x, 1);
        if (rows > 1) compare(check, state, i, "g", g[1], b->y - a->y, 1);
    }
}

static void compare_field(KitCheck *check, const KitState *state, const KitAnswer *general, const KitAnswer *form)
{
    const TinkerLinearField *laws = (const TinkerLinearField *)(const void *)form->values[0];
    for (int32_t b = 0; b < state->body_count; b++) {
        const TinkerPoint *p = &state->bodies[b];
        for (int axis = 0; axis < 2; axis++) {
            double sum = 0, size = 0;
            for (int32_t i = 0; i < state->count; i++) {
                const double parts[] = {state->masses[b] * laws[i].acceleration[axis], laws[i].force[axis],
                                        -laws[i].drag * (axis == 0 ? p->vx : p->vy)};
                for (int k = 0; k < 3; k++) {
                    sum += parts[k];
                    size += fabs(parts[k]);
                }
            }
            compare(check, state, b, "force", general->values[0][2 * b + axis], sum, size);
        }
    }
}

static void compare_motion(KitCheck *check, const KitState *state, const KitAnswer *general, const KitAnswer *form)
{
    static const char *const names[] = {"displacement", "velocity", "acceleration"};
    for (int32_t i = 0; i < state->count; i++) {
        double *const *wave = wave_of(check, state, form->values[1], i);
        for (int k = 0; k < 6; k++)
            compare(check, state, i, names[k / 2], general->values[k / 2][2 * i + k % 2],
                    wave != NULL ? wave[k / 2][i] * form->values[0][2 * i + k % 2] : 0, 0);
    }
}

static void compare_distance(KitCheck *check, const KitState *state, const KitAnswer *general, const KitAnswer *form)
{
    for (int32_t i = 0; i < state->count; i++) {
        const TinkerPoint *a = &state->points[state->offsets[i]], *b = a + 1;
        compare(check, state, i, "g", general->values[0][i], hypot(b->x - a->x, b->y - a->y) - form->values[0][i], 1);
    }
}

/* The rows that the host works out of ends that coincide. */
static void try_coincident(KitCheck *check, const KitFunction *general)
{
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        g_autoptr(KitAnswer) answer = state != NULL ? kit_call_well(check, general, state) : NULL;
        for (int32_t i = 0; answer != NULL && i < state->count && !kit_decided(check); i++) {
            const TinkerPoint *a = &state->points[state->offsets[i]], *b = a + 1;
            compare(check, state, i, "g", answer->values[0][2 * i], b->x - a->x, 1);
            compare(check, state, i, "g", answer->values[0][2 * i + 1], b->y - a->y, 1);
        }
    }
}

/* Instances one by one: a form is refused for the type where one of them does not have it. */
static int try_instance(KitCheck *check, const KitFunction *general, const KitFunction *form, const KitState *state)
{
    g_autoptr(KitAnswer) simple = kit_call(check, form, state);
    if (simple->status == TINKER_RETRY_SMALLER) return 0;
    if (simple->status != TINKER_OK) {
        kit_fail(check, "%s answers %d", form->name, simple->status);
        return 0;
    }
    g_autoptr(KitAnswer) whole = kit_call_well(check, general, state);
    const TinkerPhysics *physics = check->block_class->physics;
    if (whole == NULL) return 0;
    if (physics->line_law != NULL) compare_line(check, state, whole, simple);
    const gboolean turns = strcmp(form->name, "torsion") == 0 || strcmp(form->name, "turning") == 0;
    if (physics->force_element != NULL) (turns ? compare_torsion : compare_force)(check, state, whole, simple);
    if (physics->field != NULL) compare_field(check, state, whole, simple);
    if (physics->motion != NULL) compare_motion(check, state, whole, simple);
    if (physics->constraint != NULL) (turns ? compare_turning : compare_distance)(check, state, whole, simple);
    return 1;
}

void kit_try_linear(KitCheck *check)
{
    static const char *const generals[] = {"tension", "force", "motion", "rows_at"};
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *form = kit_function(functions, "linear"), *general = NULL;
    static const char *const forms[] = {"distance", "torsion", "turning"};
    for (gsize i = 0; i < G_N_ELEMENTS(forms) && form == NULL; i++)
        form = kit_function(functions, forms[i]);
    for (gsize i = 0; i < G_N_ELEMENTS(generals) && general == NULL; i++)
        general = kit_function(functions, generals[i]);
    const TinkerPhysics *physics = check->block_class->physics;
    const TinkerConstraint *constraint = physics != NULL ? physics->constraint : NULL;
    if (general != NULL && constraint != NULL && constraint->coincident != 0) {
        if (constraint->rows != 2) kit_fail(check, "ends coincide by two rows, not %d", constraint->rows);
        try_coincident(check, general);
        return;
    }
    if (form == NULL || general == NULL) {
        kit_skip(check, "it offers no such form");
        return;
    }
    int compared = 0;
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        for (int32_t i = 0; state != NULL && i < state->count && !kit_decided(check); i++) {
            g_autoptr(KitState) one = kit_state_slice(state, i, 1);
            compared += try_instance(check, general, form, one);
        }
    }
    if (compared == 0) kit_skip(check, "no instance that was tried is of that form");
}

void kit_try_breaks(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *next = kit_function(functions, "next_break");
    if (next == NULL) {
        kit_skip(check, "it offers no next_break: the host looks after waveforms");
        return;
    }
    g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
    for (int i = 0; state != NULL && i < BREAKS && !kit_decided(check); i++) {
        g_autoptr(KitAnswer) answer = kit_call_well(check, next, state);
        if (answer == NULL) return;
        const double time = answer->values[0][0];
        if (!(time > state->time))
            kit_fail(check, "asked at %.17g s it answers %.17g s, a later time was expected", state->time, time);
        if (isinf(time)) return;
        state->time = time;
    }
}

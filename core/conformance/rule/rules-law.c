/* law: what a block states as data is what its code does: at random states to rounding, with dimensions that go
 * together, and with forces that are minus the gradient of the potential where it states one. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "conformance/probe/state.h"
#include "law/block-law.h"
#include "law/derivative.h"
#include "law/dimension.h"
#include "law/value.h"

#define ROUNDS   42   /* of KIT_COUNT instances: a thousand states */
#define SHAKES   3    /* of the last digits, to see what rounding does */
#define SHAKEN   4    /* last digits */
#define ROUNDING 64.0 /* times as much as was seen may be off */

/* Where a law is worked out. */
typedef struct {
    const TinkerBlockLaw *law;
    const KitState *state;
    int32_t instance, body, other;
    gboolean at_rest;
    GRand *shake; /* NULL: exactly there */
} Place;

/* x, y, vx, vy of a point; places are in the world. */
static double of_point(const Place *place, const TinkerPoint *point, const char *quantity)
{
    const KitState *state = place->state;
    const gboolean velocity = quantity[0] == 'v', along_x = quantity[velocity ? 1 : 0] == 'x';
    const int axis = along_x ? 0 : 1;
    if (velocity) return place->at_rest ? 0 : along_x ? point->vx : point->vy;
    /* the points of fields are in the world already */
    const double origin = place->law->role == TINKER_LAW_FIELD ? 0 : state->origin[axis];
    return (along_x ? point->x : point->y) + origin;
}

/* What the role has for an end. Of a block that asks for no angles ends are as on point masses. */
static double of_end(const Place *place, const TinkerLawSymbol *symbol)
{
    const KitState *state = place->state;
    const int32_t end = state->offsets[place->instance] + symbol->end;
    const gboolean angles = tinker_block_class_speaks_of_angles(state->block_class);
    const char *quantity = symbol->quantity;
    if (strcmp(quantity, "theta") == 0) return angles ? state->poses[end].angle : 0;
    if (strcmp(quantity, "omega") == 0) return angles && !place->at_rest ? state->poses[end].rate : 0;
    if (strcmp(quantity, "turns") == 0) return angles ? state->has_angle[end] : 0;
    if (strcmp(quantity, "theta_start") == 0) return angles ? state->placed_poses[end].angle : 0;
    const gboolean start = angles && g_str_has_suffix(quantity, "_start");
    return of_point(place, start ? &state->placed[end] : &state->points[end], quantity);
}

static double length_of(const Place *place)
{
    const KitState *state = place->state;
    double sum = 0;
    if (place->law->role == TINKER_LAW_LINE) return state->lengths[place->instance];
    for (int32_t e = state->offsets[place->instance] + 1; e < state->offsets[place->instance + 1]; e++)
        sum += hypot(state->points[e].x - state->points[e - 1].x, state->points[e].y - state->points[e - 1].y);
    return sum;
}

static double of_role(const Place *place, const char *symbol)
{
    const KitState *state = place->state;
    if (strcmp(symbol, "t") == 0) return state->time;
    if (strcmp(symbol, "L") == 0) return length_of(place);
    if (strcmp(symbol, "rate") == 0) return place->at_rest ? 0 : state->rates[place->instance];
    if (symbol[0] == 'm') return state->masses[symbol[1] == '2' ? place->other : place->body];
    const char last = symbol[strlen(symbol) - 1];
    return of_point(place, &state->bodies[last == '2' ? place->other : place->body], symbol);
}

static double value_at(const char *symbol, void *data)
{
    const Place *place = data;
    const TinkerLawSymbol *known = tinker_block_law_symbol(place->law, symbol);
    if (known == NULL) return tinker_expression_value(tinker_block_law_find(place->law, symbol), value_at, data);
    double **columns = known->at_start ? place->state->placed_columns : place->state->columns;
    const double value = known->absent          ? 0
                         : known->property >= 0 ? columns[known->column][place->instance]
                         : known->end >= 0      ? of_end(place, known)
                                                : of_role(place, symbol);
    return place->shake == NULL ? value
                                : value * (1 + g_rand_double_range(place->shake, -SHAKEN, SHAKEN) * DBL_EPSILON);
}

/* The value, and what may be lost of it to rounding. */
static double worked_out(const Place *place, const TinkerExpression *expression, double *lost)
{
    const double value = tinker_expression_value(expression, value_at, (void *)place);
    g_autoptr(GRand) random = g_rand_new_with_seed(1);
    Place shaken = *place;
    shaken.shake = random;
    for (int i = 0; i < SHAKES; i++)
        *lost = fmax(*lost, fabs(tinker_expression_value(expression, value_at, &shaken) - value));
    *lost = fmax(*lost, DBL_EPSILON * fabs(value));
    return value;
}

/* Dimensions ------------------------------------------------------------------------------------------------------- */

static gboolean dimension_of(const char *symbol, TinkerDimension *dimension, void *data)
{
    const TinkerBlockLaw *law = data;
    const TinkerLawSymbol *known = tinker_block_law_symbol(law, symbol);
    if (known != NULL) *dimension = known->dimension;
    for (guint i = 0; known == NULL && i < law->definitions->len; i++) {
        const TinkerLawDefinition *definition = &g_array_index(law->definitions, TinkerLawDefinition, i);
        if (strcmp(definition->symbol, symbol) == 0) *dimension = definition->dimension;
    }
    return TRUE;
}

static void look_at_dimensions(KitCheck *check, const TinkerBlockLaw *law)
{
    for (guint i = 0; i < law->definitions->len; i++) {
        const TinkerLawDefinition *definition = &g_array_index(law->definitions, TinkerLawDefinition, i);
        const TinkerDimension declared = definition->dimension;
        TinkerLawDimension found;
        g_autofree char *why = NULL;
        if (!tinker_expression_dimension(definition->is, dimension_of, (void *)law, &found, &why)) {
            kit_fail(check, "\"%s\" of its law: %s", definition->symbol, why);
        } else if (!tinker_law_dimension_is(&found, declared)) {
            const TinkerLawDimension wanted = {FALSE, declared.mass, declared.length, declared.time};
            g_autofree char *is = tinker_law_dimension_text(&found), *says = tinker_law_dimension_text(&wanted);
            kit_fail(check, "\"%s\" of its law is in %s, and is declared in %s", definition->symbol, is, says);
        }
    }
}

/* Code and law ----------------------------------------------------------------------------------------------------- */

static void expect_near(KitCheck *check, const KitOutput *output, const KitState *state, gsize entry, double given,
                        double expected, double lost)
{
    if (fabs(given - expected) <= ROUNDING * lost || kit_decided(check)) return;
    g_autofree char *values = kit_entry_describe(output, state, entry);
    kit_fail(check, "\"%s\" is %.9g where its law says %.9g (%s)", output->name, given, expected, values);
}

/* Whether it is a motion's that turns a support, and does not displace it. */
static gboolean turns_support(const TinkerBlockLaw *law)
{
    return law->role == TINKER_LAW_MOTION && tinker_block_law_find(law, "rotation") != NULL;
}

/* What its role asks for, as a law would say it: number `component` of the end or row `number`. (transfer full) */
static char *equation_name(const TinkerBlockLaw *law, int32_t component, int32_t number, int32_t count)
{
    static const char *const forces[] = {"force_x", "force_y"}, *const moves[] = {"displacement_x", "displacement_y"};
    g_autofree char *digits = count > 1 ? g_strdup_printf("%d", number + 1) : g_strdup("");
    switch (law->role) {
    case TINKER_LAW_LINE:
        return g_strdup("tension");
    case TINKER_LAW_FORCE:
        return g_strconcat(forces[component], digits, NULL);
    case TINKER_LAW_FIELD:
        return g_strdup(forces[component]);
    case TINKER_LAW_CONSTRAINT:
        return g_strconcat("g", digits, NULL);
    default:
        return g_strdup(turns_support(law) ? "rotation" : moves[component]);
    }
}

typedef struct {
    const TinkerBlockLaw *law;
    const char *by;
} Gradient;

static TinkerExpression *through_steps(const char *symbol, void *data)
{
    const Gradient *gradient = data;
    if (strcmp(symbol, gradient->by) == 0) return tinker_expression_number(1);
    const TinkerExpression *step = tinker_block_law_find(gradient->law, symbol);
    return step != NULL ? tinker_expression_derivative(step, through_steps, data) : NULL;
}

static TinkerExpression *slope_of(const TinkerBlockLaw *law, const char *equation, const char *by)
{
    const TinkerExpression *is = tinker_block_law_find(law, equation);
    Gradient gradient = {law, by};
    return is != NULL ? tinker_expression_derivative(is, through_steps, &gradient) : NULL;
}

/* The expression, or minus the gradient of the potential where the law leaves it at that; NULL: it does not say.
 * (transfer full) */
static TinkerExpression *stated(const TinkerBlockLaw *law, int32_t component, int32_t number, int32_t count)
{
    g_autofree char *name = equation_name(law, component, number, count);
    const TinkerExpression *is = tinker_block_law_find(law, name);
    if (is != NULL) return tinker_expression_ref(is);
    if (law->role != TINKER_LAW_FORCE) return NULL;
    g_autofree char *turn = count > 1 ? g_strdup_printf("torque%d", number + 1) : g_strdup("torque");
    if (tinker_block_law_find(law, turn) != NULL) return tinker_expression_number(0);
    g_autofree char *by = count > 1 ? g_strdup_printf("%c%d", component == 0 ? 'x' : 'y', number + 1)
                                    : g_strdup(component == 0 ? "x" : "y");
    TinkerExpression *slope = slope_of(law, "potential", by);
    return slope != NULL ? tinker_expression_negated(slope) : NULL;
}

/* One number of a result of a line law, force element, constraint or motion. */
static void compare_instance(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                             const KitState *state, const KitAnswer *answer, int32_t instance)
{
    const KitOutput *output = &function->outputs[0];
    const int32_t ends = state->offsets[instance + 1] - state->offsets[instance];
    const int32_t parts = law->role == TINKER_LAW_FORCE        ? ends
                          : law->role == TINKER_LAW_CONSTRAINT ? kit_state_rows(state)
                                                               : 1;
    const gsize first = law->role == TINKER_LAW_FORCE ? (gsize)state->offsets[instance] : (gsize)(instance * parts);
    for (int32_t part = 0; part < parts && !kit_decided(check); part++) {
        for (int32_t c = 0; c < (turns_support(law) ? 1 : output->width); c++) {
            const Place place = {.law = law, .state = state, .instance = instance};
            const gsize entry = first + (gsize)part;
            g_autoptr(TinkerExpression) is = stated(law, c, part, parts);
            double lost = 0;
            if (is == NULL) {
                g_autofree char *missing = equation_name(law, c, part, parts);
                kit_fail(check, "its law says nothing of \"%s\"", missing);
                return;
            }
            const double expected = worked_out(&place, is, &lost);
            expect_near(check, output, state, entry, answer->values[0][entry * (gsize)output->width + (gsize)c],
                        expected, lost);
        }
    }
}

/* The torques of a force element that gives them. */
static void compare_torques(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                            const KitState *state, const KitAnswer *answer, int32_t instance)
{
    const int32_t first = state->offsets[instance], ends = state->offsets[instance + 1] - first;
    for (int32_t k = 0; function->output_count > 1 && k < ends && !kit_decided(check); k++) {
        const Place place = {.law = law, .state = state, .instance = instance};
        g_autofree char *digits = ends > 1 ? g_strdup_printf("%d", k + 1) : g_strdup("");
        g_autofree char *name = g_strconcat("torque", digits, NULL), *by = g_strconcat("theta", digits, NULL);
        const TinkerExpression *is = tinker_block_law_find(law, name);
        g_autoptr(TinkerExpression) slope = is == NULL ? slope_of(law, "potential", by) : NULL;
        double lost = 0, expected = 0;
        if (is != NULL)
            expected = worked_out(&place, is, &lost);
        else if (slope != NULL)
            expected = -worked_out(&place, slope, &lost);
        expect_near(check, &function->outputs[1], state, (gsize)(first + k), answer->values[1][first + k], expected,
                    lost);
    }
}

/* The force of all instances on one body. */
static void compare_body(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function, const KitState *state,
                         const KitAnswer *answer, int32_t number)
{
    static const char *const own[] = {"force_x", "force_y"}, *const of_pairs[] = {"pair_force_x", "pair_force_y"};
    const gboolean pairs = state->block_class->physics->field->couples_bodies != 0;
    for (int c = 0; c < 2 && !kit_decided(check); c++) {
        const char *name = pairs ? of_pairs[c] : own[c];
        const TinkerExpression *is = tinker_block_law_find(law, name);
        double sum = 0, lost = 0;
        if (is == NULL) {
            kit_fail(check, "its law says nothing of \"%s\"", name);
            return;
        }
        for (int32_t i = 0; i < state->count; i++) {
            for (int32_t other = 0; other < (pairs ? state->body_count : 1); other++) {
                Place place = {.law = law, .state = state, .instance = i, .body = state->first_body + number};
                place.other = other;
                double part = 0;
                if (pairs && other == place.body) continue;
                sum += worked_out(&place, is, &part);
                lost += part;
            }
        }
        expect_near(check, &function->outputs[0], state, (gsize)number, answer->values[0][2 * number + c], sum, lost);
    }
}

/* Potentials ------------------------------------------------------------------------------------------------------- */

/* The force at rest is minus the gradient of the potential; a tension its slope. */
static void compare_potential(KitCheck *check, const TinkerBlockLaw *law, const KitState *state, int32_t instance)
{
    static const char *const coordinates[] = {"x", "y"};
    const gboolean line = law->role == TINKER_LAW_LINE;
    if (!line && law->role != TINKER_LAW_FIELD) return;
    for (int c = 0; c < (line ? 1 : 2) && !kit_decided(check); c++) {
        g_autofree char *name = equation_name(law, c, 0, 1);
        const TinkerExpression *force = tinker_block_law_find(law, name);
        g_autoptr(TinkerExpression) slope = slope_of(law, "potential", line ? "L" : coordinates[c]);
        if (slope == NULL || force == NULL) continue;
        const Place place = {.law = law, .state = state, .instance = instance, .at_rest = TRUE};
        double lost = 0;
        const double given = worked_out(&place, force, &lost), gradient = worked_out(&place, slope, &lost);
        if (fabs(given - (line ? gradient : -gradient)) <= ROUNDING * lost) continue;
        g_autofree char *values = kit_state_describe(state, instance);
        kit_fail(check, "\"%s\" of its law is %.9g at rest where its potential gives %.9g (%s)", name, given,
                 line ? gradient : -gradient, values);
    }
}

/* The law as it is for the ends of an instance. NULL: it cannot be read. (transfer full) */
static TinkerBlockLaw *law_of(KitCheck *check, const KitState *state, int32_t instance)
{
    g_autoptr(GError) error = NULL;
    const int32_t ends = state->offsets[instance + 1] - state->offsets[instance];
    TinkerBlockLaw *law = tinker_block_law_new(check->block_class, ends, &error);
    if (law == NULL) kit_fail(check, "its law cannot be read: %s", error->message);
    return law;
}

static void compare_state(KitCheck *check, const KitFunction *function, const KitState *state)
{
    g_autoptr(KitAnswer) answer = kit_call_well(check, function, state);
    if (answer == NULL) return;
    g_autoptr(TinkerBlockLaw) law = NULL;
    for (int32_t i = 0; i < state->count && !kit_decided(check); i++) {
        g_clear_pointer(&law, tinker_block_law_free);
        law = law_of(check, state, i);
        if (law == NULL) return;
        if (i == 0) look_at_dimensions(check, law);
        if (kit_decided(check)) return;
        if (law->role != TINKER_LAW_FIELD) compare_instance(check, law, function, state, answer, i);
        if (law->role == TINKER_LAW_FORCE) compare_torques(check, law, function, state, answer, i);
        compare_potential(check, law, state, i);
    }
    const gboolean field = law != NULL && law->role == TINKER_LAW_FIELD;
    for (int32_t b = 0; field && b < state->body_range && !kit_decided(check); b++)
        compare_body(check, law, function, state, answer, b);
}

/* What an instance gives to its ends at the instant of the state. */
static void compare_blow(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *blow, const KitState *state,
                         const KitAnswer *answer, int32_t instance)
{
    static const char *const names[] = {"impulse_x", "impulse_y", "angular_impulse"};
    const int32_t first = state->offsets[instance], ends = state->offsets[instance + 1] - first;
    const Place place = {.law = law, .state = state, .instance = instance};
    for (int32_t k = 0; k < 3 * ends && !kit_decided(check); k++) {
        const int32_t component = k % 3, output = component / 2, end = k / 3;
        if (output >= blow->output_count) continue;
        g_autofree char *digits = ends > 1 ? g_strdup_printf("%d", end + 1) : g_strdup("");
        g_autofree char *name = g_strconcat(names[component], digits, NULL);
        const TinkerExpression *is = tinker_block_law_find(law, name);
        const gsize entry = (gsize)(first + end), width = (gsize)blow->outputs[output].width;
        const double given = answer->values[output][entry * width + (gsize)(component % 2)];
        if (is == NULL) {
            kit_fail(check, "its law says nothing of \"%s\"", name);
            return;
        }
        double lost = 0;
        const double expected = worked_out(&place, is, &lost);
        expect_near(check, &blow->outputs[output], state, entry, given, expected, lost);
    }
}

/* At the instant of the first blow, those that strike then. */
static void try_blows(KitCheck *check, const KitFunction *next, const KitFunction *blow)
{
    const int32_t instant = check->block_class->meanings[TINKER_MEANING_INSTANT];
    g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
    if (state == NULL) return;
    state->time = -1;
    g_autoptr(KitAnswer) when = kit_call_well(check, next, state);
    if (when == NULL || !isfinite(when->values[0][0])) return;
    state->time = when->values[0][0];
    g_autoptr(KitAnswer) answer = kit_call_well(check, blow, state);
    for (int32_t i = 0; answer != NULL && i < state->count && !kit_decided(check); i++) {
        if (instant < 0 || state->columns[check->block_class->first_columns[instant]][i] != state->time) continue;
        g_autoptr(TinkerBlockLaw) law = law_of(check, state, i);
        if (law != NULL) compare_blow(check, law, blow, state, answer, i);
    }
}

void kit_try_law(KitCheck *check)
{
    static const char *const asked[] = {"tension", "force", "force", "rows_at", "motion"};
    const TinkerLawRole role = tinker_law_role(check->block_class);
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    if (role == TINKER_LAW_NONE) kit_skip(check, "it does nothing that a law would say");
    if (role != TINKER_LAW_NONE && check->block_class->law_count == 0)
        kit_skip(check, "it states no law: equations name its force, and cannot say what it is");
    if (kit_decided(check)) return;
    const KitFunction *function = kit_function(functions, asked[role]);
    if (function == NULL) function = kit_function(functions, "rotation");
    const KitFunction *next = kit_function(functions, "next_blow"), *blow = kit_function(functions, "blow");
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        if (next != NULL && blow != NULL) try_blows(check, next, blow);
        if (kit_decided(check)) return;
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        if (state == NULL) return;
        compare_state(check, function, state);
    }
}

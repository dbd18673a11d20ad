/* law: what a block states as data is what its code does: at random states to rounding, with dimensions that go
 * together, and with forces that are minus the gradient of the potential where it states one. */
#include <math.h>
#include <string.h>

#include "conformance/rule/law-compare.h"
#include "conformance/rule/law-values.h"
#include "law/dimension.h"

#define ROUNDS 42 /* of KIT_COUNT instances: a thousand states */

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

/* Potentials ------------------------------------------------------------------------------------------------------- */

/* The force at rest is minus the gradient of the potential; a tension its slope. */
static void compare_potential(KitCheck *check, const TinkerBlockLaw *law, const KitState *state, int32_t instance)
{
    static const char *const coordinates[] = {"x", "y"};
    const gboolean line = law->role == TINKER_LAW_LINE;
    if (!line && law->role != TINKER_LAW_FIELD) return;
    for (int c = 0; c < (line ? 1 : 2) && !kit_decided(check); c++) {
        g_autofree char *name = kit_law_name(law, c, 0, 1);
        const TinkerExpression *force = tinker_block_law_find(law, name);
        g_autoptr(TinkerExpression) slope = kit_law_slope(law, line ? "L" : coordinates[c]);
        if (slope == NULL || force == NULL) continue;
        const KitLawPlace place = {.law = law, .state = state, .instance = instance, .at_rest = TRUE};
        double lost = 0;
        const double given = kit_law_value(&place, force, &lost), gradient = kit_law_value(&place, slope, &lost);
        if (fabs(given - (line ? gradient : -gradient)) <= KIT_LAW_ROUNDING * lost) continue;
        g_autofree char *values = kit_state_describe(state, instance);
        kit_fail(check, "\"%s\" of its law is %.9g at rest where its potential gives %.9g (%s)", name, given,
                 line ? gradient : -gradient, values);
    }
}

/* Code and law ----------------------------------------------------------------------------------------------------- */

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
        if (law->role != TINKER_LAW_FIELD) kit_law_compare_instance(check, law, function, state, answer, i);
        if (law->role == TINKER_LAW_FORCE) kit_law_compare_torques(check, law, function, state, answer, i);
        compare_potential(check, law, state, i);
    }
    const gboolean field = law != NULL && law->role == TINKER_LAW_FIELD;
    for (int32_t b = 0; field && b < state->body_range && !kit_decided(check); b++)
        kit_law_compare_body(check, law, function, state, answer, b);
}

/* At the instant of the first blow, those that strike then. */
static void try_blows(KitCheck *check, const GArray *functions)
{
    const KitFunction *blow = kit_function(functions, "blow");
    if (blow == NULL) return;
    const int32_t instant = check->block_class->meanings[TINKER_MEANING_INSTANT];
    g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
    if (state == NULL) return;
    g_autoptr(KitAnswer) answer = kit_call_first_blow(check, functions, state);
    for (int32_t i = 0; answer != NULL && i < state->count && !kit_decided(check); i++) {
        if (instant < 0 || state->columns[check->block_class->first_columns[instant]][i] != state->time) continue;
        g_autoptr(TinkerBlockLaw) law = law_of(check, state, i);
        if (law != NULL) kit_law_compare_blow(check, law, blow, state, answer, i);
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
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        try_blows(check, functions);
        if (kit_decided(check)) return;
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        if (state == NULL) return;
        compare_state(check, function, state);
    }
}

/* A block's code against its law, number by number. */
#include "conformance/rule/law-compare.h"

#include <math.h>

static void expect_near(KitCheck *check, const KitOutput *output, const KitState *state, gsize entry, double given,
                        double expected, double lost)
{
    if (fabs(given - expected) <= KIT_LAW_ROUNDING * lost || kit_decided(check)) return;
    g_autofree char *values = kit_entry_describe(output, state, entry);
    kit_fail(check, "\"%s\" is %.9g where its law says %.9g (%s)", output->name, given, expected, values);
}

void kit_law_compare_instance(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                              const KitState *state, const KitAnswer *answer, int32_t instance)
{
    const KitOutput *output = &function->outputs[0];
    const int32_t ends = state->offsets[instance + 1] - state->offsets[instance];
    const int32_t parts = law->role == TINKER_LAW_FORCE        ? ends
                          : law->role == TINKER_LAW_CONSTRAINT ? kit_state_rows(state)
                                                               : 1;
    const gsize first = law->role == TINKER_LAW_FORCE ? (gsize)state->offsets[instance] : (gsize)(instance * parts);
    for (int32_t part = 0; part < parts && !kit_decided(check); part++) {
        for (int32_t c = 0; c < (kit_law_turns_support(law) ? 1 : output->width); c++) {
            const KitLawPlace place = {.law = law, .state = state, .instance = instance};
            const gsize entry = first + (gsize)part;
            g_autoptr(TinkerExpression) is = kit_law_stated(law, c, part, parts);
            double lost = 0;
            if (is == NULL) {
                g_autofree char *missing = kit_law_name(law, c, part, parts);
                kit_fail(check, "its law says nothing of \"%s\"", missing);
                return;
            }
            const double expected = kit_law_value(&place, is, &lost);
            expect_near(check, output, state, entry, answer->values[0][entry * (gsize)output->width + (gsize)c],
                        expected, lost);
        }
    }
}

void kit_law_compare_torques(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                             const KitState *state, const KitAnswer *answer, int32_t instance)
{
    const int32_t first = state->offsets[instance], ends = state->offsets[instance + 1] - first;
    for (int32_t k = 0; function->output_count > 1 && k < ends && !kit_decided(check); k++) {
        const KitLawPlace place = {.law = law, .state = state, .instance = instance};
        g_autofree char *digits = ends > 1 ? g_strdup_printf("%d", k + 1) : g_strdup("");
        g_autofree char *name = g_strconcat("torque", digits, NULL), *by = g_strconcat("theta", digits, NULL);
        const TinkerExpression *is = tinker_block_law_find(law, name);
        g_autoptr(TinkerExpression) slope = is == NULL ? kit_law_slope(law, by) : NULL;
        double lost = 0, expected = 0;
        if (is != NULL)
            expected = kit_law_value(&place, is, &lost);
        else if (slope != NULL)
            expected = -kit_law_value(&place, slope, &lost);
        expect_near(check, &function->outputs[1], state, (gsize)(first + k), answer->values[1][first + k], expected,
                    lost);
    }
}

void kit_law_compare_body(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *function,
                          const KitState *state, const KitAnswer *answer, int32_t number)
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
                KitLawPlace place = {.law = law, .state = state, .instance = i, .body = state->first_body + number};
                place.other = other;
                double part = 0;
                if (pairs && other == place.body) continue;
                sum += kit_law_value(&place, is, &part);
                lost += part;
            }
        }
        expect_near(check, &function->outputs[0], state, (gsize)number, answer->values[0][2 * number + c], sum, lost);
    }
}

void kit_law_compare_blow(KitCheck *check, const TinkerBlockLaw *law, const KitFunction *blow, const KitState *state,
                          const KitAnswer *answer, int32_t instance)
{
    static const char *const names[] = {"impulse_x", "impulse_y", "angular_impulse"};
    const int32_t first = state->offsets[instance], ends = state->offsets[instance + 1] - first;
    const KitLawPlace place = {.law = law, .state = state, .instance = instance};
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
        const double expected = kit_law_value(&place, is, &lost);
        expect_near(check, &blow->outputs[output], state, entry, given, expected, lost);
    }
}

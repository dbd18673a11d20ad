/* Reading conditions: two expressions and an equals sign, a comparison, or an event. */
#include <string.h>

#include "measure/until-private.h"
#include "physics/record/columns.h"
#include "scene/store/conditions.h"
#include "units/expression/expression-tree.h"

static void clear_condition(gpointer data)
{
    UntilCondition *condition = data;
    g_clear_pointer(&condition->left, tinker_formula_free);
    g_clear_pointer(&condition->right, tinker_formula_free);
    g_free(condition->text);
    g_free(condition->event);
    g_free(condition->block);
}

TinkerUntil *tinker_until_new(TinkerScene *scene, double start)
{
    TinkerUntil *until = g_new0(TinkerUntil, 1);
    until->scene = scene;
    until->start = start;
    until->columns = tinker_columns_new();
    until->conditions = g_array_new(FALSE, FALSE, sizeof(UntilCondition));
    g_array_set_clear_func(until->conditions, clear_condition);
    return until;
}

void tinker_until_free(TinkerUntil *until)
{
    if (until == NULL) return;
    g_array_unref(until->conditions);
    g_array_unref(until->columns);
    g_clear_pointer(&until->samples, g_array_unref);
    g_free(until);
}

static gboolean fail(const char *text, GError **error, const char *why)
{
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME, "\"%s\": %s", text, why);
    return FALSE;
}

/* Of a condition the characters from `from` to `to`, at the columns that they have there. */
static TinkerFormula *read_formula(TinkerUntil *until, const char *whole, const char *from, const char *to,
                                   GError **error)
{
    g_autoptr(GError) reason = NULL;
    g_autofree char *before = g_strnfill((gsize)g_utf8_strlen(whole, from - whole), ' ');
    g_autofree char *text = g_strdup_printf("%s%.*s", before, (int)(to - from), from);
    TinkerFormula *formula = tinker_formula_new(until->scene, text, until->columns, &reason);
    if (formula == NULL) fail(whole, error, reason->message);
    return formula;
}

static gboolean read_event(TinkerUntil *until, const char *text, UntilCondition *condition, GError **error)
{
    static const char *const kinds[] = {"impact",      "rest", "take-off", "stick", "slip", "reversal",
                                        "end",         "jam",  "taut",     "slack", "jerk", "direction lost",
                                        "bifurcation", "blow", NULL};
    condition->event = tinker_condition_event(text, &condition->block);
    if (text[strlen(text) - 1] != ')') return fail(text, error, "it must end with \")\", as in event(impact, Mass 0)");
    if (!g_strv_contains(kinds, condition->event)) {
        const char *nearest = tinker_nearest_word(condition->event, kinds);
        g_autofree char *all = g_strjoinv(", ", (char **)kinds);
        g_autofree char *why =
            nearest != NULL
                ? g_strdup_printf("there is no event \"%s\"; did you mean \"%s\"?", condition->event, nearest)
                : g_strdup_printf("there is no event \"%s\" (there are %s)", condition->event, all);
        return fail(text, error, why);
    }
    if (condition->block == NULL || tinker_scene_find_block(until->scene, condition->block) != TINKER_NO_BLOCK)
        return TRUE;
    g_autofree char *why = g_strdup_printf("the scene has no block \"%s\"", condition->block);
    return fail(text, error, why);
}

static gboolean read_condition(TinkerUntil *until, const char *text, UntilCondition *condition, GError **error)
{
    const char *equals = tinker_expression_find_equals(text);
    if (g_str_has_prefix(text, "event(")) {
        condition->kind = UNTIL_EVENT;
        return read_event(until, text, condition, error);
    }
    const char *end = text + strlen(text);
    condition->kind = equals != NULL ? UNTIL_ROOT : UNTIL_COMPARISON;
    condition->left = read_formula(until, text, text, equals != NULL ? equals : end, error);
    if (condition->left == NULL) return FALSE;
    if (condition->kind == UNTIL_ROOT) {
        condition->right = read_formula(until, text, equals + 1, end, error);
        return condition->right != NULL;
    }
    return tinker_formula_is_comparison(condition->left) ||
           fail(text, error, "it is no condition (as in \"{Mass 0.y} = 0\", \"{Mass 0.vx} < 1\" or event(impact))");
}

gboolean tinker_until_add(TinkerUntil *until, const char *text, GError **error)
{
    UntilCondition condition = {.text = g_strstrip(g_strdup(text))};
    if (read_condition(until, condition.text, &condition, error)) {
        g_array_append_val(until->conditions, condition);
        return TRUE;
    }
    clear_condition(&condition);
    return FALSE;
}

gboolean tinker_until_add_all(TinkerUntil *until, const char *text, GError **error)
{
    g_auto(GStrv) conditions = tinker_conditions_split(text);
    for (char **condition = conditions; *condition != NULL; condition++)
        if (!tinker_until_add(until, *condition, error)) return FALSE;
    return TRUE;
}

guint tinker_until_count(const TinkerUntil *until)
{
    return until->conditions->len;
}

const char *tinker_until_text(const TinkerUntil *until, int number)
{
    return g_array_index(until->conditions, UntilCondition, number).text;
}

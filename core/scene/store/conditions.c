/* Names of blocks may hold any sign, so nothing in braces or parentheses is looked at for separators. */
#include "scene/store/conditions.h"

#include <string.h>

#include "scene/store/scene-expression.h"

#define EVENT "event("

static void add_condition(GPtrArray *conditions, const char *from, const char *to)
{
    char *condition = g_strstrip(g_strndup(from, (gsize)(to - from)));
    if (*condition != '\0')
        g_ptr_array_add(conditions, condition);
    else
        g_free(condition);
}

char **tinker_conditions_split(const char *text)
{
    GPtrArray *conditions = g_ptr_array_new();
    int depth = 0;
    gboolean braced = FALSE;
    const char *from = text, *at = text;
    for (; *at != '\0'; at++) {
        if (*at == '{' || *at == '}') braced = *at == '{';
        if (!braced) depth += (*at == '(') - (*at == ')');
        if (*at != ';' || braced || depth > 0) continue;
        add_condition(conditions, from, at);
        from = at + 1;
    }
    add_condition(conditions, from, at);
    g_ptr_array_add(conditions, NULL);
    return (char **)g_ptr_array_free(conditions, FALSE);
}

char *tinker_condition_event(const char *condition, char **block)
{
    *block = NULL;
    if (!g_str_has_prefix(condition, EVENT)) return NULL;
    const char *inside = condition + strlen(EVENT), *close = strrchr(inside, ')');
    g_autofree char *arguments = close != NULL ? g_strndup(inside, (gsize)(close - inside)) : g_strdup(inside);
    char *comma = strchr(arguments, ',');
    if (comma != NULL) {
        *comma = '\0';
        *block = g_strstrip(g_strdup(comma + 1));
    }
    return g_strstrip(g_strdup(arguments));
}

static char *renamed_condition(const char *condition, const char *from, const char *to)
{
    g_autofree char *block = NULL, *kind = tinker_condition_event(condition, &block);
    if (kind == NULL) return tinker_scene_expression_renamed(condition, from, to);
    return g_strcmp0(block, from) == 0 ? g_strdup_printf(EVENT "%s, %s)", kind, to) : NULL;
}

char *tinker_conditions_renamed(const char *text, const char *from, const char *to)
{
    g_auto(GStrv) conditions = tinker_conditions_split(text);
    gboolean changed = FALSE;
    for (char **condition = conditions; *condition != NULL; condition++) {
        char *renamed = renamed_condition(*condition, from, to);
        if (renamed == NULL) continue;
        g_free(*condition);
        *condition = renamed;
        changed = TRUE;
    }
    return changed ? g_strjoinv("; ", conditions) : NULL;
}

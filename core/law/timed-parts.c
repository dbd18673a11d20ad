#include "law/timed-parts.h"

#include <string.h>

#include "law/build.h"

static gboolean names_only_time(const TinkerExpression *expression)
{
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) return strcmp(expression->name, "t") == 0;
    for (int i = 0; i < expression->count; i++)
        if (!names_only_time(expression->parts[i])) return FALSE;
    return TRUE;
}

static void collect(const TinkerExpression *expression, GPtrArray *found)
{
    if (!tinker_expression_uses(expression, "t")) return;
    if (names_only_time(expression)) {
        g_ptr_array_add(found, tinker_expression_ref(expression));
        return;
    }
    for (int i = 0; i < expression->count; i++)
        collect(expression->parts[i], found);
}

TinkerExpression *tinker_expression_timed_parts(const TinkerExpression *law)
{
    g_autoptr(GPtrArray) found = g_ptr_array_new();
    collect(law, found);
    if (found->len == 0) return NULL;
    if (found->len == 1) return g_ptr_array_index(found, 0);
    return tinker_expression_node(TINKER_EXPRESSION_SUM, NULL, (TinkerExpression *const *)found->pdata,
                                  (int)found->len);
}

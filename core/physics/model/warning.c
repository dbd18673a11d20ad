/* What a model, a plan and a run warn of. */
#include "physics/model/warning.h"

static void warning_free(void *data)
{
    TinkerWarning *warning = data;
    g_free(warning->text);
    g_free(warning->brief);
    g_free(warning);
}

GPtrArray *tinker_warnings_new(void)
{
    return g_ptr_array_new_with_free_func(warning_free);
}

/* A warning of this text, which it takes, and of a copy of `brief`. */
static TinkerWarning *warning_new(TinkerWarningKind kind, char *text, const char *brief, double number)
{
    TinkerWarning *warning = g_new(TinkerWarning, 1);
    *warning = (TinkerWarning){.kind = kind, .text = text, .brief = g_strdup(brief), .number = number};
    return warning;
}

TinkerWarning *tinker_warning_new(TinkerWarningKind kind, char *text)
{
    return warning_new(kind, text, NULL, 0);
}

void tinker_warnings_add(GPtrArray *warnings, TinkerWarningKind kind, char *text)
{
    g_ptr_array_add(warnings, tinker_warning_new(kind, text));
}

void tinker_warnings_add_with_help(GPtrArray *warnings, TinkerWarningKind kind, const char *brief, const char *help,
                                   double number)
{
    g_ptr_array_add(warnings, warning_new(kind, g_strdup_printf("%s (%s)", brief, help), brief, number));
}

void tinker_warnings_add_copies(GPtrArray *warnings, const GPtrArray *others)
{
    for (guint i = 0; i < others->len; i++) {
        const TinkerWarning *other = g_ptr_array_index(others, i);
        g_ptr_array_add(warnings, warning_new(other->kind, g_strdup(other->text), other->brief, other->number));
    }
}

const char *tinker_warnings_text(const GPtrArray *warnings, guint i)
{
    return ((const TinkerWarning *)g_ptr_array_index(warnings, i))->text;
}

GPtrArray *tinker_warnings_texts(const GPtrArray *warnings)
{
    GPtrArray *texts = g_ptr_array_new();
    for (guint i = 0; i < warnings->len; i++)
        g_ptr_array_add(texts, (gpointer)tinker_warnings_text(warnings, i));
    return texts;
}

gboolean tinker_warnings_say(const GPtrArray *warnings, const char *text)
{
    for (guint i = 0; i < warnings->len; i++)
        if (g_str_equal(tinker_warnings_text(warnings, i), text)) return TRUE;
    return FALSE;
}

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

TinkerWarning *tinker_warning_new(TinkerWarningKind kind, char *text)
{
    TinkerWarning *warning = g_new0(TinkerWarning, 1);
    warning->kind = kind;
    warning->text = text;
    return warning;
}

void tinker_warnings_add(GPtrArray *warnings, TinkerWarningKind kind, char *text)
{
    g_ptr_array_add(warnings, tinker_warning_new(kind, text));
}

void tinker_warnings_add_with_help(GPtrArray *warnings, TinkerWarningKind kind, const char *brief, const char *help,
                                   double number)
{
    TinkerWarning *warning = tinker_warning_new(kind, g_strdup_printf("%s (%s)", brief, help));
    warning->brief = g_strdup(brief);
    warning->number = number;
    g_ptr_array_add(warnings, warning);
}

void tinker_warnings_add_copies(GPtrArray *warnings, const GPtrArray *others)
{
    for (guint i = 0; i < others->len; i++) {
        const TinkerWarning *other = g_ptr_array_index(others, i);
        TinkerWarning *warning = tinker_warning_new(other->kind, g_strdup(other->text));
        warning->brief = g_strdup(other->brief);
        warning->number = other->number;
        g_ptr_array_add(warnings, warning);
    }
}

void tinker_warnings_add_texts(GPtrArray *warnings, TinkerWarningKind kind, const GPtrArray *texts)
{
    for (guint i = 0; i < texts->len; i++)
        tinker_warnings_add(warnings, kind, g_strdup(g_ptr_array_index(texts, i)));
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

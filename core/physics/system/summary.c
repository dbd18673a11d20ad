/* What a run tells of itself. */
#include "physics/system/summary.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* The name of the key stands in brackets, for those who work with files. */
#define LAWS_DIFFER                                                                                                    \
    N_("the outcome depends on the impact law: at %.6g s several contacts close at once, and Newton's law, "           \
       "Poisson's and one blow after the other differ (impact_law in the scene chooses; the events of the "            \
       "summary tell the velocities by each)")

void tinker_summary_warn_of_scene(TinkerSummary *summary, char *text)
{
    g_ptr_array_add(summary->warnings, text);
    g_ptr_array_add(summary->of_scene, text);
}

void tinker_summary_warn_of_laws(TinkerSummary *summary, double t)
{
    tinker_summary_warn_of_scene(summary, g_strdup_printf(_(LAWS_DIFFER), t));
}

char *tinker_summary_told_of_laws(const char *warning)
{
    const char *format = _(LAWS_DIFFER), *number = strchr(format, '%'), *bracket = strrchr(warning, '(');
    if (bracket == NULL || strncmp(warning, format, (gsize)(number - format)) != 0) return NULL;
    return g_strchomp(g_strndup(warning, (gsize)(bracket - warning)));
}

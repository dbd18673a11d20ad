/* What a run tells of itself. */
#include "physics/system/summary.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* The name of the key stands in brackets, for those who work with files. */
#define LAWS_DIFFER                                                                                                    \
    N_("the outcome depends on the impact law: at %.6g s several contacts close at once, and Newton's law, "           \
       "Poisson's and one blow after the other differ (impact_law in the scene chooses; the events of the "            \
       "summary tell the velocities by each)")

#define SAMPLES_MISS                                                                                                   \
    N_("%s swings faster than samples %.6g s apart can show: curves and playback miss what it does between them (an "  \
       "interval of %.6g s shows it)")

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

void tinker_summary_warn_of_samples(TinkerSummary *summary, const char *name, double apart, double interval)
{
    tinker_summary_warn_of_scene(summary, g_strdup_printf(_(SAMPLES_MISS), name, apart, interval));
}

char *tinker_summary_told_of_samples(const char *warning, double *interval)
{
    const char *format = _(SAMPLES_MISS), *middle = strchr(format, ' '), *bracket = strrchr(warning, '(');
    g_autofree char *between = g_strndup(middle, (gsize)(strstr(format, "%.6g") - middle));
    if (bracket == NULL || strstr(warning, between) == NULL) return NULL;
    *interval = g_ascii_strtod(bracket + strcspn(bracket, "0123456789"), NULL);
    if (!(*interval > 0)) return NULL;
    return g_strchomp(g_strndup(warning, (gsize)(bracket - warning)));
}

/* What a run tells of itself. */
#include "physics/system/summary.h"

#include <glib/gi18n-lib.h>

void tinker_summary_warn_of_method(TinkerSummary *summary, char *text)
{
    tinker_warnings_add(summary->warnings, TINKER_WARNING_METHOD, text);
}

void tinker_summary_warn_of_scene(TinkerSummary *summary, char *text)
{
    tinker_warnings_add(summary->warnings, TINKER_WARNING_SCENE, text);
}

void tinker_summary_warn_of_laws(TinkerSummary *summary, double t)
{
    g_autofree char *brief =
        g_strdup_printf(_("the outcome depends on the impact law: at %.6g s several contacts close at once, and "
                          "Newton's law, Poisson's and one blow after the other differ"),
                        t);
    tinker_warnings_add_with_help(
        summary->warnings, TINKER_WARNING_LAWS, brief,
        _("impact_law in the scene chooses; the events of the summary tell the velocities by each"), 0);
}

void tinker_summary_warn_of_samples(TinkerSummary *summary, const char *name, double apart, double interval)
{
    g_autofree char *brief = g_strdup_printf(
        _("%s swings faster than samples %.6g s apart can show: curves and playback miss what it does between them"),
        name, apart);
    g_autofree char *help = g_strdup_printf(_("an interval of %.6g s shows it"), interval);
    tinker_warnings_add_with_help(summary->warnings, TINKER_WARNING_SAMPLES, brief, help, interval);
}

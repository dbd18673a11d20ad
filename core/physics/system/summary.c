/* What a run tells of itself. */
#include "physics/system/summary.h"

void tinker_summary_warn_of_scene(TinkerSummary *summary, char *text)
{
    g_ptr_array_add(summary->warnings, text);
    g_ptr_array_add(summary->of_scene, text);
}

/* Words for the islands of a plan. */
#include "common/words/plan-words.h"

#include <glib/gi18n.h>

#define MOST_BLOCKS 6 /* in a line */

char *tinker_island_blocks_text(const TinkerScene *scene, const TinkerIslandPlan *island)
{
    g_autoptr(GString) text = g_string_new(NULL);
    guint count = island->blocks->len, shown = count > MOST_BLOCKS + 1 ? MOST_BLOCKS : count;
    for (guint i = 0; i < shown; i++)
        g_string_append_printf(text, "%s%s", i > 0 ? ", " : "",
                               tinker_scene_block_name(scene, g_array_index(island->blocks, TinkerBlockId, i)));
    if (shown < count) g_string_append_printf(text, _(" and %u more"), count - shown);
    if (count == 0) g_string_append(text, _("nothing that moves"));
    return g_string_free(g_steal_pointer(&text), FALSE);
}

char *tinker_method_text(const char *method, double step, double tolerance)
{
    if (step > 0) return g_strdup_printf(_("%s, step %.4g s"), method, step);
    return tolerance > 0 ? g_strdup_printf(_("%s, tolerance %g"), method, tolerance) : g_strdup(method);
}

char *tinker_island_method_text(const TinkerIslandPlan *island)
{
    return tinker_method_text(island->choice.method->id, island->choice.step, island->choice.tolerance);
}

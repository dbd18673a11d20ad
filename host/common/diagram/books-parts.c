/* How the parts of an entry are called. */
#include <glib/gi18n.h>

#include "common/diagram/books-accounts.h"
#include "common/overlay/force-arrows.h"

static gboolean has_struck(const TinkerBooks *books, TinkerBlockId block)
{
    for (guint i = 0; i < books->impacts->len; i++)
        if (g_array_index(books->impacts, TinkerBookImpact, i).by == block) return TRUE;
    return FALSE;
}

char *tinker_book_part_name(const TinkerBooks *books, TinkerScene *scene, const TinkerBookEntry *entry, int part)
{
    const char *name = tinker_scene_block_name(scene, entry->by);
    if (!entry->rubs) return g_strdup(name);
    if (part == 0 && has_struck(books, entry->by)) return g_strdup_printf(_("%s (Normal force, impacts)"), name);
    const TinkerArrowKind kind = part == 0 ? TINKER_ARROW_NORMAL : TINKER_ARROW_FRICTION;
    return g_strdup_printf("%s (%s)", name, tinker_force_arrow_word(kind));
}

/* The words that stand behind symbols: English in the tree and in JSON, and as the locale has them on a page. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "equations/page-private.h"

static const char *const words[] = {
    NC_("equations", "a step of its law"),
    NC_("equations", "angle at the start"),
    NC_("equations", "arm from the centre of mass"),
    NC_("equations", "direction of sliding"),
    NC_("equations", "distance between the ends"),
    NC_("equations", "force"),
    NC_("equations", "friction force"),
    NC_("equations", "its acceleration"),
    NC_("equations", "its force"),
    NC_("equations", "its velocity"),
    NC_("equations", "length along the ends"),
    NC_("equations", "multiplier"),
    NC_("equations", "normal force"),
    NC_("equations", "place along the top"),
    NC_("equations", "rate at which that grows"),
    NC_("equations", "stored energy"),
    NC_("equations", "tension"),
    NC_("equations", "velocity of that end"),
    NC_("equations", "where its end is"),
    NC_("equations", "where its motion has it"),
    NC_("equations", "x at the start"),
    NC_("equations", "y at the start"),
};

const char *tinker_page_words(const char *english)
{
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++)
        if (strcmp(words[i], english) == 0) return g_dpgettext2(GETTEXT_PACKAGE, "equations", english);
    return english;
}

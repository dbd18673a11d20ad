/* Words for what happens in a run. */
#include "common/words/event-words.h"

#include <glib/gi18n.h>
#include <string.h>

/* What one block does, and what one does with another. */
static const struct {
    const char *kind, *words;
    int blocks;
    gboolean turns, stays; /* of such events alone */
} sentences[] = {
    {"reversal", N_("%s begins to roll the other way on %s"), 2, TRUE},
    {"slip", N_("%s begins to roll on %s"), 2, TRUE},
    {"stick", N_("%s stops rolling on %s"), 2, TRUE},
    {"reversal", N_("%s begins to turn the other way"), 1, TRUE},
    {"slip", N_("%s begins to turn"), 1, TRUE},
    {"stick", N_("%s stops turning"), 1, TRUE},
    {"blow", N_("%s strikes %s"), 2},
    {"end", N_("%s comes to the end of %s"), 2, FALSE, TRUE},
    {"end", N_("%s leaves the end of %s"), 2},
    {"impact", N_("%s strikes %s"), 2},
    {"jam", N_("%s jams on %s"), 2},
    {"rest", N_("%s lands on %s"), 2},
    {"reversal", N_("%s begins to slide the other way on %s"), 2},
    {"slip", N_("%s begins to slide on %s"), 2},
    {"stick", N_("%s stops sliding on %s"), 2},
    {"take-off", N_("%s lifts off %s at a corner"), 2, FALSE, TRUE},
    {"take-off", N_("%s lifts off %s"), 2},
    {"bifurcation", N_("%s passes a place from where it could go on in several ways"), 1},
    {"direction lost", N_("The ends of %s meet: its force has no direction there"), 1},
    {"jerk", N_("%s is jerked taut"), 1},
    {"slack", N_("%s goes slack"), 1},
    {"taut", N_("%s becomes taut"), 1},
    {"start", N_("The start velocities are changed to what connectors and supports allow"), 0},
};

static gboolean is_block(const TinkerScene *scene, const char *name)
{
    return tinker_scene_find_block(scene, name) != TINKER_NO_BLOCK;
}

/* Where the first of two names ends: at a comma, but a name may have some of its own. NULL for one name. */
static const char *end_of_first(const TinkerScene *scene, const char *names)
{
    const char *first = strstr(names, ", ");
    for (const char *comma = first; comma != NULL; comma = strstr(comma + 2, ", ")) {
        g_autofree char *name = g_strndup(names, (gsize)(comma - names));
        if (is_block(scene, name) && is_block(scene, comma + 2)) return comma;
    }
    return first;
}

/* The words with the names in their places, which a translation keeps in this order. */
static char *filled(const char *words, const char *const names[2])
{
    g_auto(GStrv) parts = g_strsplit(words, "%s", 3);
    GString *text = g_string_new(parts[0]);
    for (int i = 0; i < 2 && parts[i] != NULL && parts[i + 1] != NULL; i++)
        g_string_append_printf(text, "%s%s", names[i], parts[i + 1]);
    return g_string_free(text, FALSE);
}

char *tinker_event_text(const TinkerScene *scene, const TinkerEvent *event)
{
    const char *all = event->blocks != NULL ? event->blocks : "", *comma = end_of_first(scene, all);
    g_autofree char *first = comma != NULL ? g_strndup(all, (gsize)(comma - all)) : NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(sentences); i++) {
        if (!g_str_equal(sentences[i].kind, event->kind) || (sentences[i].turns && !event->turns) ||
            (sentences[i].stays && !event->stays) || (sentences[i].blocks == 2 && comma == NULL))
            continue;
        const gboolean two = sentences[i].blocks == 2;
        return filled(_(sentences[i].words), (const char *[]){two ? first : all, two ? comma + 2 : ""});
    }
    return g_strdup_printf("%s%s%s", event->kind, all[0] != '\0' ? ", " : "", all);
}

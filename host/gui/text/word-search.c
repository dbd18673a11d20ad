/* Endings are taken off the words that are searched for, not off those of the text: what begins with the rest is found,
 * whatever follows. */
#include "gui/text/word-search.h"

#include <string.h>

#define LEAST_STEM 4 /* letters that are left without an ending */
#define LEAST_PART 5 /* letters that are looked for within a word */

/* The longest first. */
static const char *const endings[] = {"ations", "ators", "ation", "ator", "ating", "ances", "ungen", "ated",
                                      "ates",   "ance",  "ings",  "ions", "ing",   "ant",   "ers",   "ors",
                                      "ung",    "ion",   "er",    "ed",   "es",    "or",    "al",    "ic",
                                      "en",     "em",    "y",     "e",    "s",     "n",     NULL};

/* Words with other letters than those of ASCII have a second form without. (transfer full) */
static GStrv fold(const char *text)
{
    g_auto(GStrv) others = NULL;
    g_auto(GStrv) words = g_str_tokenize_and_fold(text, NULL, &others);
    GPtrArray *all = g_ptr_array_new();
    for (char **word = words; *word != NULL; word++)
        g_ptr_array_add(all, g_strdup(*word));
    for (char **word = others; *word != NULL; word++)
        g_ptr_array_add(all, g_strdup(*word));
    g_ptr_array_add(all, NULL);
    return (GStrv)g_ptr_array_free(all, FALSE);
}

GStrv tinker_search_words(const char *text)
{
    return fold(text);
}

static void cut_ending(char *word)
{
    for (const char *const *ending = endings; *ending != NULL; ending++) {
        if (!g_str_has_suffix(word, *ending)) continue;
        char *end = word + strlen(word) - strlen(*ending);
        if (g_utf8_strlen(word, end - word) < LEAST_STEM) continue;
        *end = '\0';
        return;
    }
}

GStrv tinker_search_stems(const char *typed)
{
    GStrv stems = g_str_tokenize_and_fold(typed, NULL, NULL);
    for (char **stem = stems; *stem != NULL; stem++)
        cut_ending(*stem);
    return stems;
}

static gboolean finds_one(char **words, const char *stem)
{
    const gboolean anywhere = g_utf8_strlen(stem, -1) >= LEAST_PART;
    for (char **word = words; *word != NULL; word++)
        if (g_str_has_prefix(*word, stem) || (anywhere && strstr(*word, stem) != NULL)) return TRUE;
    return FALSE;
}

gboolean tinker_search_finds(char **words, char **stems)
{
    for (char **stem = stems; *stem != NULL; stem++)
        if (!finds_one(words, *stem)) return FALSE;
    return TRUE;
}

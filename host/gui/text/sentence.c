/* A name is the user's own: "m1: its length ..." is not about a block "M1". */
#include "gui/text/sentence.h"

#include <string.h>

static char *ended(const char *message)
{
    gboolean has_end = *message == '\0' || strchr(".?!", message[strlen(message) - 1]) != NULL;
    return g_strconcat(message, has_end ? "" : ".", NULL);
}

char *tinker_sentence(const char *message)
{
    if (*message == '\0') return g_strdup("");
    const char *rest = g_utf8_next_char(message);
    g_autofree char *first = g_utf8_strup(message, rest - message);
    g_autofree char *capital = g_strconcat(first, rest, NULL);
    return ended(capital);
}

static gboolean begins_with_word(const char *text, const char *word)
{
    gsize length = strlen(word);
    return length > 0 && strncmp(text, word, length) == 0 && !g_unichar_isalnum(g_utf8_get_char(text + length));
}

char *tinker_sentence_in(TinkerScene *scene, const char *message)
{
    gboolean is_small = g_unichar_islower(g_utf8_get_char(message));
    for (int32_t i = 0; is_small && i < tinker_scene_block_count(scene); i++)
        if (begins_with_word(message, tinker_scene_block_name(scene, tinker_scene_block_at(scene, i))))
            return ended(message);
    return tinker_sentence(message);
}

/* A name is the user's own: "m1: its length ..." is not about a block "M1". */
#include "gui/text/sentence.h"

#include <glib/gi18n.h>
#include <string.h>

#include "gui/text/translate.h"

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

const char *tinker_without_column(const char *message, int *column)
{
    static const char word[] = "column ";
    char *end = NULL;
    const int number = g_str_has_prefix(message, word) ? (int)g_ascii_strtoull(message + strlen(word), &end, 10) : 0;
    const gboolean has_column = number > 0 && g_str_has_prefix(end, ": ");
    if (column != NULL) *column = has_column ? number : 0;
    return has_column ? end + strlen(": ") : message;
}

static gboolean is_word_character(char c)
{
    return g_ascii_isalnum(c) || c == '_';
}

char *tinker_with_titles(const char *message, const TinkerBlockClass *block_class)
{
    GString *text = g_string_new(NULL);
    for (const char *at = message; *at != '\0';) {
        gsize length = 0;
        while (is_word_character(at[length]))
            length++;
        g_autofree char *word = g_strndup(at, MAX(length, 1));
        int32_t property = block_class != NULL && length > 0 ? tinker_block_class_property(block_class, word) : -1;
        if (property >= 0)
            g_string_append_printf(text, _("“%s”"), tinker_translate(block_class->properties[property].title));
        else
            g_string_append(text, word);
        at += strlen(word);
    }
    return g_string_free(text, FALSE);
}

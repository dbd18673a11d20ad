/* Words of plugins, made fit for a line of a message. */
#include "plugin/call/words.h"

#include <string.h>

#include "plugin/call/call.h"

#define MOST_BYTES 1000

static char *copy_bounded(const char *text)
{
    return text == NULL ? NULL : g_strndup(text, MOST_BYTES);
}

char *tinker_plugin_words(const TinkerBlockClass *block_class, const TinkerIntegrator *method, const char *text)
{
    g_autofree char *copy = NULL;
    TINKER_CALL_VOID(copy = copy_bounded(text), .phase = "failure", .block_class = block_class, .method = method);
    if (copy == NULL) return NULL;
    char *words = g_utf8_make_valid(copy, -1);
    for (char *c = words; *c != '\0'; c++)
        if (g_ascii_iscntrl(*c)) *c = ' ';
    g_strstrip(words);
    if (words[0] == '\0') g_clear_pointer(&words, g_free);
    return words;
}

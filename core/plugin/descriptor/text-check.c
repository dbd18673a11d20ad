/* Checks of texts. What is quoted in a message has passed as text first. */
#include "plugin/descriptor/text-check.h"

#include <string.h>

#include "plugin/trust/refuse.h"

#define MOST_TEXT 4096
#define MOST_ID   100

static gboolean has_control(const char *text)
{
    for (const char *p = text; *p != '\0'; p++) {
        if (g_ascii_iscntrl(*p) && *p != '\n') return TRUE;
    }
    return FALSE;
}

gboolean tinker_check_text(const char *text, const char *what, gboolean required, GError **error)
{
    if (text == NULL) return required ? tinker_refuse(error, "%s is NULL, a text was expected", what) : TRUE;
    // Bounded, so that a text without an end is not followed through the whole memory.
    const gsize length = strnlen(text, MOST_TEXT + 1);
    if (length > MOST_TEXT) return tinker_refuse(error, "%s has more than %d bytes", what, MOST_TEXT);
    if (!g_utf8_validate(text, (gssize)length, NULL)) return tinker_refuse(error, "%s is not valid UTF-8", what);
    if (has_control(text)) return tinker_refuse(error, "%s contains control characters", what);
    return TRUE;
}

gboolean tinker_check_id(const char *id, const char *what, const char *forbidden, GError **error)
{
    if (!tinker_check_text(id, what, TRUE, error)) return FALSE;
    const gsize length = strlen(id);
    if (length == 0) return tinker_refuse(error, "%s is empty", what);
    if (length > MOST_ID)
        return tinker_refuse(error, "%s has %zu bytes, at most %d are allowed", what, length, MOST_ID);
    if (id[0] == ' ' || id[length - 1] == ' ' || strpbrk(id, "\n\"") != NULL)
        return tinker_refuse(error, "%s must not contain quotes or line ends, or blanks at its ends", what);
    const char *bad = strpbrk(id, forbidden);
    if (bad != NULL) return tinker_refuse(error, "%s \"%s\" must not contain \"%c\"", what, id, *bad);
    return TRUE;
}

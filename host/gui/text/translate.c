/* One catalogue for the texts of the window and for those of descriptors: an entry is found by the English text itself.
 */
#include "gui/text/translate.h"

#include <glib/gi18n.h>
#include <string.h>

#include "scene/store/quantities.h"

/* An empty text would be answered with the header of the catalogue. */
const char *tinker_translate(const char *text)
{
    static const char distance[] = TINKER_DISTANCE_TITLE;
    if (text == NULL || *text == '\0') return text;
    if (!g_str_has_prefix(text, distance)) return g_dgettext(GETTEXT_PACKAGE, text);
    /* of a block, whose name is the user's */
    g_autofree char *title = g_strdup_printf(_("Distance to %s"), text + strlen(distance));
    return g_intern_string(title);
}

const char *tinker_translate_title(const char *title, const char *description)
{
    const gboolean is_bundled = title != NULL && tinker_translate(description) != description;
    return is_bundled ? g_dpgettext2(GETTEXT_PACKAGE, "Title of an example", title) : title;
}

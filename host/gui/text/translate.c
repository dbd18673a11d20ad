/* One catalogue for the texts of the window and for those of descriptors: an entry is found by the English text itself.
 */
#include "gui/text/translate.h"

#include <glib.h>

/* An empty text would be answered with the header of the catalogue. */
const char *tinker_translate(const char *text)
{
    return text == NULL || *text == '\0' ? text : g_dgettext(GETTEXT_PACKAGE, text);
}

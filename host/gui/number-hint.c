/* A comma is never read as a point: "1,000" is a thousand to some and one to others. */
#include "number-hint.h"

#include <glib/gi18n.h>
#include <string.h>

#include "units/units.h"

gboolean tinker_number_hint_comma(const char *text, GError **error)
{
    if (strchr(text, ',') == NULL) return FALSE;
    g_set_error_literal(error, TINKER_UNITS_ERROR, TINKER_UNITS_ERROR_SYNTAX,
                        _("A number is written with a point and without thousands separators, as in 3.5."));
    return TRUE;
}

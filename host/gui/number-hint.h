/* What the entries for numbers have in common to say. No widget. */
#ifndef TINKER_GUI_NUMBER_HINT_H
#define TINKER_GUI_NUMBER_HINT_H

#include <glib.h>

/* Where a text that is no number has a comma, as many write numbers: sets the error to a sentence that says how it is
 * written here, and answers TRUE. */
gboolean tinker_number_hint_comma(const char *text, GError **error);

#endif

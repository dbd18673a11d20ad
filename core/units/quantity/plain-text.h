/* Text for a line on a terminal: what a file, a plugin or an argument says must neither move its cursor nor change its
 * colours, nor make two lines of a message. */
#ifndef TINKER_CORE_PLAIN_TEXT_H
#define TINKER_CORE_PLAIN_TEXT_H

#include <glib.h>

/* Whether a text has none of the characters that are escaped: the control characters of ASCII and of ISO 8859-1, the
 * line and paragraph separators, those that turn the direction of writing, and bytes that are no UTF-8. */
gboolean tinker_text_is_plain(const char *text);

/* The text with each of these written as in JSON, "\u001b", "\n", "\t"; a byte that is no UTF-8 as "\x9b". With `lines`
 * line feeds and tabs stay, of texts that have several lines; what is escaped in the JSON that is left is still the
 * same JSON. (transfer full) */
char *tinker_text_escaped(const char *text, gboolean lines);

#endif

/* Checks of the texts that a plugin declares. */
#ifndef TINKER_PLUGIN_TEXT_CHECK_H
#define TINKER_PLUGIN_TEXT_CHECK_H

#include "plugin/descriptor/block-class.h"

/* Text is UTF-8 without control characters, at most 4096 bytes. NULL passes unless it is required. */
gboolean tinker_check_text(const char *text, const char *what, gboolean required, GError **error);

/* An id is text of 1 to 100 bytes without blanks at its ends and without any of `forbidden`. */
gboolean tinker_check_id(const char *id, const char *what, const char *forbidden, GError **error);

#endif

/* Refusals: how every check of a plugin says no. */
#ifndef TINKER_PLUGIN_REFUSE_H
#define TINKER_PLUGIN_REFUSE_H

#include "plugin/trust/plugin-error.h"

/* Sets a TINKER_PLUGIN_ERROR_REFUSED and answers FALSE, so that a check can end with it. */
gboolean tinker_refuse(GError **error, const char *format, ...) G_GNUC_PRINTF(2, 3);

/* Sets a TINKER_PLUGIN_ERROR_FILE: nobody's plugin is at fault, a file or program could not be used. */
gboolean tinker_fail_file(GError **error, const char *format, ...) G_GNUC_PRINTF(2, 3);

#endif

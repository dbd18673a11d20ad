/* The errors of everything that has to do with plugins. */
#ifndef TINKER_PLUGIN_ERROR_H
#define TINKER_PLUGIN_ERROR_H

#include <glib.h>

typedef enum {
    TINKER_PLUGIN_ERROR_MISSING, /* nobody provides the type */
    TINKER_PLUGIN_ERROR_REFUSED, /* the library failed a check; the message has both sides' values */
    TINKER_PLUGIN_ERROR_FILE,    /* a folder or file could not be read or written; memory or a process cannot be had */
} TinkerPluginError;
#define TINKER_PLUGIN_ERROR (tinker_plugin_error_quark())
GQuark tinker_plugin_error_quark(void);

#endif

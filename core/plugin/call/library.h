/* An opened library: the checks in their order, and what it declares. */
#ifndef TINKER_PLUGIN_LIBRARY_H
#define TINKER_PLUGIN_LIBRARY_H

#include "plugin/descriptor/block-class.h"
#include "plugin/trust/identity.h"

/* A library that has passed. Lives as long as the process, as does everything it shows. */
typedef struct TinkerLibrary {
    char *path;
    TinkerIdentity identity;    /* of the file when it was opened */
    const TinkerPlugin *plugin; /* a copy of the host's size with its id; its spans are the plugin's own */
    int32_t class_count;
    const TinkerBlockClass *const *classes;
    int32_t integrator_count;
    const TinkerIntegrator *integrators; /* copies of the host's size, with their ids */
    char *changed;                       /* of the process, as it was opened, and put back since; NULL: nothing */
    const struct TinkerLibrary *next;    /* the one opened before it */
} TinkerLibrary;

/* Opens the library at this absolute path, or answers the one that this process opened earlier. Runs the plugin's code.
 * NULL with _REFUSED (the message is the reason alone, without the path) or _FILE. (transfer none) */
const TinkerLibrary *tinker_library_open(const char *path, GError **error);

/* The plugin that a method is of; NULL where it is of none. Locks nothing, so that a handler of signals may ask. */
const TinkerPlugin *tinker_library_plugin_of_method(const TinkerIntegrator *method);

/* The library at this path, where it was opened and has passed; else NULL. Locks nothing, either. */
const TinkerLibrary *tinker_library_passed(const char *path);

/* Makes all checks of a library on a descriptor that is in memory already (NULL is refused), and calls its init if it
 * passes them. Nothing of it is kept. FALSE with _REFUSED. */
gboolean tinker_library_check_descriptor(const TinkerPlugin *plugin, GError **error);

/* What opening the library at this absolute path changed of the state of the process (process-state.h), and was put
 * back since: "the locale". NULL where it changed nothing, or is not open. Borrowed. */
const char *tinker_library_changed_process(const char *path);

#endif

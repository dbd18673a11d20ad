/* The probe: a library is looked at in a child process first, so that one that crashes or hangs takes nobody along. */
#ifndef TINKER_PLUGIN_PROBE_PRIVATE_H
#define TINKER_PLUGIN_PROBE_PRIVATE_H

#include "plugin/catalogue/catalogue.h"

/* Runs `PROGRAM plugins describe --output - FILE` and answers what it wrote, a manifest as JSON text (transfer full).
 * NULL with _REFUSED where the library is at fault (refused, crashed, hung, wrote something else), with _FILE where it
 * could not be probed at all, which says nothing about it. `seconds` limits the time. */
char *tinker_probe(const char *program, const char *path, double seconds, GError **error);

#endif

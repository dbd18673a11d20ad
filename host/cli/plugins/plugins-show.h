/* Block types and integrators for people: what their descriptors declare. */
#ifndef TINKER_CLI_PLUGINS_SHOW_H
#define TINKER_CLI_PLUGINS_SHOW_H

#include <stdio.h>

#include "plugin/catalogue/catalogue.h"

void tinker_plugins_show(const TinkerBlockClass *block_class, FILE *file);

/* `library` is the one that provides the integrator; NULL: it is built in. */
void tinker_plugins_show_integrator(const TinkerIntegrator *integrator, const TinkerLibraryEntry *library, FILE *file);

#endif

/* A block type for people: what its descriptor declares. */
#ifndef TINKER_CLI_PLUGINS_SHOW_H
#define TINKER_CLI_PLUGINS_SHOW_H

#include <stdio.h>

#include "plugin/catalogue.h"

void tinker_plugins_show(const TinkerBlockClass *block_class, FILE *file);

#endif

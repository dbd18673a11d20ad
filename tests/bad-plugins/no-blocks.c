/* A plugin with nothing in it. */
#include "exhibit.h"

static const TinkerPlugin plugin = {TINKER_PLUGIN_HEAD, EXHIBIT_TEXTS, .blocks = {exhibit_blocks, 0, 0}};

EXHIBIT_ENTRY(plugin)

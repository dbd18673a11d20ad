/* Block types that lie closer together than they are long. */
#include "exhibit.h"

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = {exhibit_blocks, 1, 16},
};

EXHIBIT_ENTRY(plugin)

/* Writes on standard output, where a record or a manifest may be going. */
#include <stdio.h>

#include "exhibit.h"

static TinkerStatus init(const TinkerHost *host)
{
    puts("Hello!");
    return TINKER_OK;
}

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(exhibit_blocks),
    .init = init,
};

EXHIBIT_ENTRY(plugin)

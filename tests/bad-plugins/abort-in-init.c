/* Aborts while it makes itself ready. */
#include <stdlib.h>

#include "exhibit.h"

static TinkerStatus init(const TinkerHost *host)
{
    abort();
}

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(exhibit_blocks),
    .init = init,
};

EXHIBIT_ENTRY(plugin)

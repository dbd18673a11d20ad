/* Writes without end. */
#include <unistd.h>

#include "exhibit.h"

static TinkerStatus init(const TinkerHost *host)
{
    char block[4096] = "";
    while (write(STDERR_FILENO, block, sizeof block) > 0)
        ;
    return TINKER_OK;
}

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(exhibit_blocks),
    .init = init,
};

EXHIBIT_ENTRY(plugin)

/* Says that it cannot become ready. */
#include "exhibit.h"

static TinkerStatus init(const TinkerHost *host)
{
    return TINKER_FAILED;
}

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(exhibit_blocks),
    .init = init,
};

EXHIBIT_ENTRY(plugin)

/* Never becomes ready. It closes its outputs too, so that their end is no sign of its own. */
#include <unistd.h>

#include "exhibit.h"

static TinkerStatus init(const TinkerHost *host)
{
    close(STDOUT_FILENO);
    close(STDERR_FILENO);
    while (host != NULL)
        pause();
    return TINKER_OK;
}

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(exhibit_blocks),
    .init = init,
};

EXHIBIT_ENTRY(plugin)

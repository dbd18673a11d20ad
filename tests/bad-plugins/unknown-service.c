/* Cannot do without a service that no host has. */
#include "exhibit.h"

static const char *const services[] = {TINKER_LOG_SERVICE, "org.example.teleport/1"};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(exhibit_blocks),
    .services = TINKER_SPAN(services),
};

EXHIBIT_ENTRY(plugin)

/* Needs a host that does not exist yet. */
#include "exhibit.h"

static const TinkerPlugin plugin = {
    .magic = TINKER_MAGIC,
    .struct_size = sizeof(TinkerPlugin),
    .abi_minor = 99,
    .least_host_minor = 99,
    .size_of_double = sizeof(double),
    .size_of_index = sizeof(int32_t),
    .blocks = TINKER_SPAN(exhibit_blocks),
    EXHIBIT_TEXTS,
};

EXHIBIT_ENTRY(plugin)

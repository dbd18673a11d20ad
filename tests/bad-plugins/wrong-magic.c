/* Another magic number. */
#include "exhibit.h"

static const TinkerPlugin plugin = {
    .magic = 0xdeadbeef,
    .struct_size = sizeof(TinkerPlugin),
    .size_of_double = sizeof(double),
    .size_of_index = sizeof(int32_t),
    .blocks = TINKER_SPAN(exhibit_blocks),
    EXHIBIT_TEXTS,
};

EXHIBIT_ENTRY(plugin)

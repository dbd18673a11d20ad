/* Compiled where a double has 4 bytes and an index 8. */
#include "exhibit.h"

static const TinkerPlugin plugin = {
    .magic = TINKER_MAGIC,
    .struct_size = sizeof(TinkerPlugin),
    .size_of_double = 4,
    .size_of_index = 8,
    .blocks = TINKER_SPAN(exhibit_blocks),
    EXHIBIT_TEXTS,
};

EXHIBIT_ENTRY(plugin)

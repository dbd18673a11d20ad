/* A descriptor that ends before its spans. */
#include "exhibit.h"

static const TinkerPlugin plugin = {
    .magic = TINKER_MAGIC,
    .struct_size = 64,
    .size_of_double = sizeof(double),
    .size_of_index = sizeof(int32_t),
    .blocks = TINKER_SPAN(exhibit_blocks),
    EXHIBIT_TEXTS,
};

EXHIBIT_ENTRY(plugin)

/* Fewer than no properties. */
#include "exhibit.h"

static const TinkerPropertyType properties[1];

static const TinkerBlockType blocks[] = {{
    .struct_size = sizeof(TinkerBlockType),
    .schema_version = 1,
    .id = "exhibit",
    .category = TINKER_FIELD,
    .properties = {properties, -3, sizeof(TinkerPropertyType)},
}};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(blocks),
};

EXHIBIT_ENTRY(plugin)

/* Two properties of one id. */
#include "exhibit.h"

#define PROPERTY                                                                                                       \
    {                                                                                                                  \
        .struct_size = sizeof(TinkerPropertyType), .id = "weight", .title = "Weight", .panel = -1                      \
    }

static const TinkerPropertyType properties[] = {PROPERTY, PROPERTY};

static const TinkerBlockType blocks[] = {{
    .struct_size = sizeof(TinkerBlockType),
    .schema_version = 1,
    .id = "exhibit",
    .category = TINKER_FIELD,
    .properties = TINKER_SPAN(properties),
}};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(blocks),
};

EXHIBIT_ENTRY(plugin)

/* Two block types of one id. */
#include "exhibit.h"

static const TinkerBlockType blocks[] = {EXHIBIT_BLOCK("exhibit"), EXHIBIT_BLOCK("other"), EXHIBIT_BLOCK("exhibit")};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .blocks = TINKER_SPAN(blocks),
};

EXHIBIT_ENTRY(plugin)

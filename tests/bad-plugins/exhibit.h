/* What the exhibits of the museum have in common: a block type and the texts of a descriptor without fault. Each
 * exhibit changes the one thing that it is named after. */
#ifndef TINKER_EXHIBIT_H
#define TINKER_EXHIBIT_H

#include <tinker/sdk.h>

#define EXHIBIT_BLOCK(block_id)                                                                                        \
    {                                                                                                                  \
        .struct_size = sizeof(TinkerBlockType), .schema_version = 1, .id = block_id, .title = "Exhibit",               \
        .category = TINKER_FIELD, .summary = "Stands in a museum."                                                     \
    }

static const TinkerBlockType exhibit_blocks[] = {EXHIBIT_BLOCK("exhibit")};

#define EXHIBIT_TEXTS                                                                                                  \
    .id = "org.tinker.test.exhibit", .title = "Exhibit", .version = "1.0.0", .licence = "MIT",                         \
    .home_page = "https://example.org"

#define EXHIBIT_ENTRY(descriptor)                                                                                      \
    const TinkerPlugin *tinker_plugin_v1(void)                                                                         \
    {                                                                                                                  \
        return &(descriptor);                                                                                          \
    }

#endif

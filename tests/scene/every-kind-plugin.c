/* A block with a property of every kind, for the kinds that no installed block uses; and one with vectors, two of which
 * have the same labels in the same group. */
#include <tinker/sdk.h>

static const char *const shades[] = {"black", "grey", "white"};

static const TinkerPropertyType properties[] = {
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_TEXT,
     .id = "note",
     .title = "Note",
     .group = "All",
     .description = "A text",
     .panel = -1,
     .default_text = "none yet"},
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_INTEGER,
     .id = "count",
     .title = "Count",
     .group = "All",
     .description = "A whole number",
     .panel = -1,
     .flags = TINKER_HAS_MINIMUM | TINKER_HAS_MAXIMUM,
     .hard_maximum = 10},
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_CHOICE,
     .id = "shade",
     .title = "Shade",
     .group = "All",
     .description = "A choice",
     .panel = -1,
     .choice_count = 3,
     .choices = shades},
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_SWITCH,
     .id = "open",
     .title = "Open",
     .group = "All",
     .description = "A switch",
     .panel = -1},
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_REAL,
     .id = "level",
     .title = "Level",
     .group = "All",
     .description = "Worked out by the block",
     .panel = -1,
     .flags = TINKER_READ_ONLY},
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_REAL,
     .id = "first",
     .title = "First",
     .group = "All",
     .description = "A number",
     .panel = -1,
     .default_value = {2}},
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_REAL,
     .id = "second",
     .title = "Second",
     .group = "All",
     .description = "As the first",
     .panel = -1,
     .flags = TINKER_DEFAULT_SAME_AS,
     .default_from = "first"},
};

static const TinkerPropertyType vectors[] = {
    {TINKER_VECTOR_PROPERTY("point", "Point", "Guide", "X", "Y", TINKER_DIMENSION_LENGTH)},
    {TINKER_REAL_PROPERTY("radius", "Radius", "Guide", TINKER_DIMENSION_LENGTH)},
    {TINKER_VECTOR_PROPERTY("moment", "Moment", "Guide", "Along", "Across", TINKER_DIMENSION_FORCE)},
    {TINKER_VECTOR_PROPERTY("centre", "Centre", "Guide", "X", "Y", TINKER_DIMENSION_LENGTH)},
    {TINKER_VECTOR_PROPERTY("pull", "Pull", "Guide", "X Pull", "Y pull", TINKER_DIMENSION_FORCE)},
    {TINKER_VECTOR_PROPERTY("home", "Place", "Its Places", "X", "Y", TINKER_DIMENSION_LENGTH)},
};

static TinkerStatus nothing(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t end = 0; end < 2 * (batch->ends >= 0 ? batch->ends * batch->count : batch->end_offsets[batch->count]);
         end++)
        force[end] = 0;
    return TINKER_OK;
}

static const TinkerForceElement force_element = {.struct_size = sizeof(TinkerForceElement), .force = nothing};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};
static const TinkerInterface interfaces[] = {{TINKER_PHYSICS_INTERFACE, &physics}};

static const TinkerBlockType blocks[] = {
    {.struct_size = sizeof(TinkerBlockType),
     .schema_version = 1,
     .id = "every-kind",
     .title = "Every Kind",
     .category = TINKER_FORCE,
     .summary = "Has a property of every kind",
     .least_ends = 0,
     .most_ends = -1,
     .end_accepts = TINKER_ACCEPTS_BODY,
     .properties = TINKER_SPAN(properties),
     .quantities = TINKER_NO_SPAN,
     .interfaces = TINKER_SPAN(interfaces)},
    {TINKER_BLOCK("vectors", "Vectors", TINKER_FORCE), .summary = "Has vectors", .most_ends = -1,
     .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(vectors), .interfaces = TINKER_SPAN(interfaces)},
};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    .id = "org.tinker.test.every-kind",
    .title = "Every kind",
    .version = "1.0.0",
    .licence = "MIT",
    .home_page = "",
    .blocks = TINKER_SPAN(blocks),
    .integrators = TINKER_NO_SPAN,
    .services = TINKER_NO_SPAN,
};

TINKER_EXPORT const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin;
}

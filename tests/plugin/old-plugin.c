/* A plugin as older headers would have made it: its structs end earlier. Their first members are those of today, since
 * members are only ever appended. */
#include <tinker/sdk.h>

typedef struct {
    uint32_t struct_size;
    int32_t kind;
    const char *id;
    const char *title;
} OldProperty;

typedef struct {
    uint32_t struct_size;
    uint32_t flags;
    const char *id;
} OldQuantity;

typedef struct {
    uint32_t struct_size;
    int32_t reserved;
    TinkerStatus (*tension)(TinkerBatch *batch, const double *length, const double *rate, double *tension);
} OldLineLaw;

typedef struct {
    uint32_t struct_size;
    int32_t scratch_size;
    const TinkerBody *body;
    const OldLineLaw *line_law;
} OldPhysics;

typedef struct {
    uint32_t struct_size;
    int32_t layer;
    void (*draw)(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style);
} OldRender;

/* Behind a struct that ends early stands something else: reading on would find it. */
#define SPOILER 0x5a5a5a5a5a5a5a5a

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *tension_out)
{
    for (int32_t i = 0; i < batch->count; i++)
        tension_out[i] = length[i];
    return TINKER_OK;
}

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *values_out)
{
    return TINKER_OK;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style) {}

static const OldProperty properties[] = {
    {sizeof(OldProperty), TINKER_KIND_REAL, "first", "First"},
    {sizeof(OldProperty), TINKER_KIND_VECTOR, "second", "Second"},
};
static const OldQuantity quantities[] = {{sizeof(OldQuantity), TINKER_RECORDED, "tension"}};

static const struct {
    OldLineLaw law;
    uint64_t spoiler[8];
} line_law = {{sizeof(OldLineLaw), 0, tension}, {SPOILER, SPOILER, SPOILER, SPOILER}};
static const struct {
    OldPhysics physics;
    uint64_t spoiler[8];
} physics = {{sizeof(OldPhysics), 0, NULL, &line_law.law}, {SPOILER, SPOILER, SPOILER, SPOILER, SPOILER}};
static const struct {
    OldRender render;
    uint64_t spoiler[8];
} render = {{sizeof(OldRender), 2, draw}, {SPOILER}};
static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {{
    .struct_size = sizeof(TinkerBlockType),
    .schema_version = 1,
    .id = "old",
    .category = TINKER_CONNECTOR,
    .least_ends = 2,
    .most_ends = 2,
    .end_accepts = TINKER_ACCEPTS_BODY,
    .properties = TINKER_SPAN(properties),
    .quantities = TINKER_SPAN(quantities),
    .interfaces = TINKER_SPAN(interfaces),
}};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD, .id = "org.tinker.test.old",   .title = "Old", .version = "0.1.0",
    .licence = "MIT",   .blocks = TINKER_SPAN(blocks),
};

const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin;
}

/* A plugin as newer headers would have made it: every struct has members that this host does not know, and every span
 * a longer stride. */
#include <tinker/sdk.h>

#define NEWER(type)                                                                                                    \
    struct {                                                                                                           \
        type known;                                                                                                    \
        double unknown[3];                                                                                             \
    }

typedef NEWER(TinkerPropertyType) NewProperty;
typedef NEWER(TinkerQuantityType) NewQuantity;
typedef NEWER(TinkerField) NewField;
typedef NEWER(TinkerPhysics) NewPhysics;
typedef NEWER(TinkerGraph) NewGraph;
typedef NEWER(TinkerInterface) NewInterface;
typedef NEWER(TinkerBlockType) NewBlock;
typedef NEWER(TinkerPlugin) NewPlugin;

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *force_out)
{
    return TINKER_OK;
}

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *values_out)
{
    return TINKER_OK;
}

static const NewProperty properties[] = {
    {{.struct_size = sizeof(NewProperty), .id = "first", .panel = -1, .default_value = {1.5, 0}}, {7, 7, 7}},
    {{.struct_size = sizeof(NewProperty), .id = "second", .panel = -1, .default_value = {2.5, 0}}, {7, 7, 7}},
};
static const NewQuantity quantities[] = {
    {{.struct_size = sizeof(NewQuantity), .id = "one"}, {7, 7, 7}},
    {{.struct_size = sizeof(NewQuantity), .id = "two"}, {7, 7, 7}},
};
static const NewField field = {{.struct_size = sizeof(NewField), .force = force}, {7, 7, 7}};
static const NewPhysics physics = {{.struct_size = sizeof(NewPhysics), .field = &field.known}, {7, 7, 7}};
static const NewGraph graph = {{.struct_size = sizeof(NewGraph), .values = values}, {7, 7, 7}};
static const NewInterface interfaces[] = {
    {{TINKER_PHYSICS_INTERFACE, &physics}, {7, 7, 7}},
    {{"tinker.sound/1", &physics}, {7, 7, 7}},
    {{TINKER_GRAPH_INTERFACE, &graph}, {7, 7, 7}},
};

static const NewBlock blocks[] = {
    {{
         .struct_size = sizeof(NewBlock),
         .schema_version = 1,
         .id = "new",
         .category = TINKER_FIELD,
         .properties = TINKER_SPAN(properties),
         .quantities = TINKER_SPAN(quantities),
         .interfaces = TINKER_SPAN(interfaces),
     },
     {7, 7, 7}},
    {{
         .struct_size = sizeof(NewBlock),
         .schema_version = 1,
         .id = "newer",
         .category = TINKER_FIELD,
         .properties = TINKER_SPAN(properties),
     },
     {7, 7, 7}},
};

static const NewPlugin plugin = {
    {
        .magic = TINKER_MAGIC,
        .struct_size = sizeof(NewPlugin),
        .abi_minor = TINKER_ABI_MINOR + 5,
        .size_of_double = sizeof(double),
        .size_of_index = sizeof(int32_t),
        .id = "org.tinker.test.new",
        .title = "New",
        .version = "9.0.0",
        .licence = "MIT",
        .blocks = TINKER_SPAN(blocks),
    },
    {7, 7, 7},
};

const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin.known;
}

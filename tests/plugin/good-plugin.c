/* A plugin without fault: a line law "pull", T = k (L - length), and an integrator that does nothing. Compiled several
 * times, with the ids that its definitions say. */
#include <tinker/sdk.h>

#ifndef GOOD_ID
#define GOOD_ID "org.tinker.test.good"
#endif
#ifndef GOOD_TYPE
#define GOOD_TYPE "pull"
#endif

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *tension_out)
{
    for (int32_t i = 0; i < batch->count; i++)
        tension_out[i] = batch->columns[0][i] * (length[i] - batch->columns[1][i]);
    return TINKER_OK;
}

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *values_out)
{
    for (int32_t i = 0; i < batch->count; i++)
        values_out[i] = quantity;
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {
        .struct_size = sizeof(TinkerPropertyType),
        .kind = TINKER_KIND_REAL,
        .id = "stiffness",
        .title = "Stiffness",
        .dimension = {1, 0, -2, 0},
        .flags = TINKER_HAS_MINIMUM,
        .variability = TINKER_TUNABLE,
        .panel = -1,
        .default_value = {10, 0},
    },
    {
        .struct_size = sizeof(TinkerPropertyType),
        .kind = TINKER_KIND_REAL,
        .id = "length",
        .title = "Undeformed Length",
        .dimension = {0, 1, 0, 0},
        .flags = TINKER_DEFAULT_AS_PLACED,
        .meaning = TINKER_MEANING_LENGTH,
        .panel = -1,
    },
};

static const TinkerQuantityType quantities[] = {{
    .struct_size = sizeof(TinkerQuantityType),
    .flags = TINKER_RECORDED,
    .id = "tension",
    .title = "Tension",
    .dimension = {1, 1, -2, 0},
}};

static const TinkerLineLaw line_law = {.struct_size = sizeof(TinkerLineLaw), .tension = tension};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &line_law};
static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};
static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {{
    .struct_size = sizeof(TinkerBlockType),
    .schema_version = 1,
    .id = GOOD_TYPE,
    .title = "Pull",
    .category = TINKER_CONNECTOR,
    .summary = "Pulls.",
    .least_ends = 2,
    .most_ends = 2,
    .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
    .properties = TINKER_SPAN(properties),
    .quantities = TINKER_SPAN(quantities),
    .interfaces = TINKER_SPAN(interfaces),
}};

static char stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return &stepper;
}

static void destroy(void *own) {}

static void restart(void *own) {}

static TinkerStatus step(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    return TINKER_FAILED;
}

static TinkerStatus interpolate(void *own, double t, double *q, double *v, double *books)
{
    return TINKER_FAILED;
}

static const TinkerIntegrator integrators[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .id = GOOD_TYPE "-method",
    .title = "Stands still",
    .order = 1,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

static TinkerStatus init(const TinkerHost *host)
{
    const TinkerLogService *log = host->service(host, TINKER_LOG_SERVICE);
    if (log == NULL || host->service(host, "org.example.nothing/1") != NULL) return TINKER_FAILED;
    log->log(host, TINKER_LOG_INFO, "ready");
    return TINKER_OK;
}

static const char *const services[] = {TINKER_LOG_SERVICE};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    .id = GOOD_ID,
    .title = "Good",
    .version = "1.2.3",
    .licence = "MIT",
    .home_page = "https://example.org/good",
    .blocks = TINKER_SPAN(blocks),
    .integrators = TINKER_SPAN(integrators),
    .services = TINKER_SPAN(services),
    .init = init,
};

const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin;
}

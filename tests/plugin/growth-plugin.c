/* The plugin of test-growth.c. Compiled with the present headers and with those of the next minor version, in which
 * every struct has a member more, filled in here with what a host must not take for something else. */
#include <tinker/sdk.h>

#if defined(TINKER_NEXT)
#define ID   "next"
#define MORE .next_member = {7, 8, 9},
#else
#define ID "present"
#define MORE
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
        values_out[i] = quantity + input->accelerations[i];
    return TINKER_OK;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style) {}

static const TinkerPropertyType properties[] = {
    {.struct_size = sizeof(TinkerPropertyType), .id = "first", .panel = -1, .default_value = {1.5, 0}, MORE},
    {.struct_size = sizeof(TinkerPropertyType), .id = "second", .panel = -1, .default_value = {2.5, 0}, MORE},
};
static const TinkerQuantityType quantities[] = {
    {.struct_size = sizeof(TinkerQuantityType), .id = "one", MORE},
    {.struct_size = sizeof(TinkerQuantityType), .id = "two", MORE},
};
static const TinkerLineLaw law = {.struct_size = sizeof(TinkerLineLaw), .tension = tension, MORE};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &law, MORE};
static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values, MORE};
static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw, MORE};
static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_GRAPH_INTERFACE, &graph},
    {TINKER_RENDER_INTERFACE, &render},
};

#define BLOCK(id_)                                                                                                     \
    {                                                                                                                  \
        TINKER_BLOCK(id_, "Block", TINKER_CONNECTOR),                                                                  \
            .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY,                                       \
            .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),                              \
            .interfaces = TINKER_SPAN(interfaces), MORE                                                                \
    }
static const TinkerBlockType blocks[] = {BLOCK(ID "-a"), BLOCK(ID "-b")};

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return (void *)system->mass;
}

static void destroy(void *own) {}

static void restart(void *own) {}

static TinkerStatus step(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    state->t = limit;
    report->step = 0.25;
    return TINKER_OK;
}

static TinkerStatus interpolate(void *own, double t, double *q, double *v, double *books)
{
    return TINKER_FAILED;
}

#define METHOD(id_, order_)                                                                                            \
    {                                                                                                                  \
        .struct_size = sizeof(TinkerIntegrator), .id = id_, .title = "Method", .order = order_, .create = create,      \
        .destroy = destroy, .restart = restart, .step = step, .interpolate = interpolate, MORE                         \
    }
static const TinkerIntegrator integrators[] = {METHOD(ID "-slow", 1), METHOD(ID "-fast", 4)};

/* A host that is older has no more than its own members. */
static TinkerStatus init(const TinkerHost *host)
{
    const TinkerLogService *log = host->service(host, TINKER_LOG_SERVICE);
    return log != NULL && TINKER_HAS(TinkerHost, host, service) && TINKER_HAS(TinkerLogService, log, log)
               ? TINKER_OK
               : TINKER_FAILED;
}

static const TinkerPlugin plugin = {TINKER_PLUGIN_HEAD,
                                    .id = "org.tinker.test." ID,
                                    .title = "Growth",
                                    .version = "1.0.0",
                                    .licence = "MIT",
                                    .blocks = TINKER_SPAN(blocks),
                                    .integrators = TINKER_SPAN(integrators),
                                    .init = init,
                                    MORE};

const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin;
}

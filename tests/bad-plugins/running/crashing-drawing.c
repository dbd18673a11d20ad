/* A block whose drawing writes through a null pointer. */
#include <tinker/sdk.h>

static int32_t *volatile nowhere;

static TinkerStatus no_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < 2 * batch->count; i++)
        force[i] = 0;
    return TINKER_OK;
}

/* No sanitizer is to stop it: the fault is what the host must live with. */
__attribute__((no_sanitize("undefined", "address"))) static void draw(const TinkerInstance *instance,
                                                                      struct _cairo *cairo, const TinkerStyle *style)
{
    *nowhere = 1;
}

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = no_force};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &element};
static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw};
static const TinkerInterface interfaces[] = {{TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}};
static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("crashing-drawing", "Exhibit", TINKER_FORCE), .summary = "Hangs in a museum.", .least_ends = 1,
     .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.example.crashing-drawing", "Exhibit", "1.0.0", "MIT", blocks)

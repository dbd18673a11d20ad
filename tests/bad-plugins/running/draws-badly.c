/* Forces of nothing that all draw the same line; all but the first leave the context of the picture otherwise than it
 * was. */
#include <cairo.h>
#include <tinker/sdk.h>

static TinkerStatus no_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < 2 * batch->count; i++)
        force[i] = 0;
    return TINKER_OK;
}

static void draw_line(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *end = &instance->end[0];
    style->line(style, cairo, TINKER_COLOUR_FORCE, end->x, end->y, end->x + 1, end->y + 0.5);
}

static void draw_saved(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    draw_line(instance, cairo, style);
    cairo_save(cairo);
    cairo_scale(cairo, 0.1, 0.1);
}

static void draw_restored(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    draw_line(instance, cairo, style);
    cairo_restore(cairo);
    cairo_scale(cairo, 0.1, 0.1);
}

static void draw_group(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    draw_line(instance, cairo, style);
    cairo_push_group(cairo);
}

static void draw_broken(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    draw_line(instance, cairo, style);
    cairo_pop_group_to_source(cairo);
}

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = no_force};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &element};

#define DRAWN(name)                                                                                                    \
    static const TinkerRender name##_render = {.struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw_##name};  \
    static const TinkerInterface name##_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &physics},                          \
                                                        {TINKER_RENDER_INTERFACE, &name##_render}};
DRAWN(line)
DRAWN(saved)
DRAWN(restored)
DRAWN(group)
DRAWN(broken)

#define BLOCK(name)                                                                                                    \
    {                                                                                                                  \
        TINKER_BLOCK("draws-" #name, "Exhibit", TINKER_FORCE), .summary = "Hangs in a museum.", .least_ends = 1,       \
                                                               .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY,     \
                                                               .interfaces = TINKER_SPAN(name##_interfaces)            \
    }
static const TinkerBlockType blocks[] = {BLOCK(line), BLOCK(saved), BLOCK(restored), BLOCK(group), BLOCK(broken)};

TINKER_DEFINE_PLUGIN("org.example.draws-badly", "Exhibit", "1.0.0", "MIT", blocks)

/* Marker: a point of a body or a support, whose place, velocity, acceleration and path can be seen. It acts on nothing,
 * so that a scene moves with it as without it. */
#include <tinker/sdk.h>

enum { QUANTITY_X, QUANTITY_Y, QUANTITY_VX, QUANTITY_VY, QUANTITY_SPEED, QUANTITY_AX, QUANTITY_AY };

#define RING 0.5 /* of the symbol size: its radius, */
#define TICK 0.8 /* and how far ticks reach */

/* Drawing */

/* A ring with four ticks about the point, and the path that led there. */
static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *at = instance->end;
    const int32_t count = TINKER_HAS(TinkerInstance, instance, path_count) ? instance->path_count : 0;
    if (count > 0 && TINKER_HAS(TinkerStyle, style, polyline)) {
        const double *last = &instance->path[2 * (count - 1)];
        const double rest[4] = {last[0], last[1], at->x, at->y};
        style->polyline(style, cairo, TINKER_COLOUR_MOTION, instance->path, count);
        style->polyline(style, cairo, TINKER_COLOUR_MOTION, rest, 2);
    }
    style->circle(style, cairo, -1, TINKER_COLOUR_MOTION, at->x, at->y, RING * style->symbol_size);
    for (int k = 0; k < 4; k++) {
        static const double ways[4][2] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
        const double from = RING * style->symbol_size, to = TICK * style->symbol_size;
        style->line(style, cairo, TINKER_COLOUR_MOTION, at->x + from * ways[k][0], at->y + from * ways[k][1],
                    at->x + to * ways[k][0], at->y + to * ways[k][1]);
    }
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const int32_t count = TINKER_HAS(TinkerInstance, instance, path_count) ? instance->path_count : 0;
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->end->x, instance->end->y,
                      TICK * style->symbol_size + 2.0 * style->line_width + style->pixel);
    for (int32_t k = 0; k < count; k++) {
        tinker_bounds_add(box, instance->path[2 * k], instance->path[2 * k + 1], style->line_width + style->pixel);
    }
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    return tinker_ends_hit(instance, x, y, fmax(reach, RING * tinker_instance_symbol_size(instance)));
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (quantity != QUANTITY_SPEED) {
        const int32_t component =
            quantity < QUANTITY_SPEED ? quantity : quantity - 1; /* tinker_point_values has none */
        const TinkerStatus status = tinker_point_values(batch, input, component, result);
        for (int32_t i = 0; status == TINKER_OK && quantity <= QUANTITY_Y && i < batch->count; i++) {
            result[i] += batch->origin[quantity];
        }
        return status;
    }
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = tinker_length(input->ends[i].vx, input->ends[i].vy);
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "x", "X Position", "Horizontal place of the point", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(TINKER_RECORDED, "y", "Y Position", "Vertical place of the point", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(TINKER_RECORDED, "vx", "X Velocity", "Horizontal velocity", TINKER_DIMENSION_VELOCITY),
    TINKER_QUANTITY(TINKER_RECORDED, "vy", "Y Velocity", "Vertical velocity", TINKER_DIMENSION_VELOCITY),
    TINKER_QUANTITY(0, "speed", "Speed", "Magnitude of the velocity", TINKER_DIMENSION_VELOCITY),
    TINKER_QUANTITY(0, "ax", "X Acceleration", "Horizontal acceleration", TINKER_DIMENSION_ACCELERATION),
    TINKER_QUANTITY(0, "ay", "Y Acceleration", "Vertical acceleration", TINKER_DIMENSION_ACCELERATION),
};

static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"x", "m", "ft"}, {"y", "m", "ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("marker", "Marker", TINKER_MEASURE), .summary = "A point whose motion and path can be seen",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .flags = TINKER_LEAVES_PATH, .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.marker", "Marker", "0.1.0", "MIT", blocks)

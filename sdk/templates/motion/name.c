/* @title@: carries a support along a straight line at a constant speed, like a lift or a belt. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. A vector takes two. */
enum { COLUMN_VELOCITY };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* u = w t: the displacement from the support's place, and its exact first and second derivatives, two numbers for each
 * block of the range. */
static TinkerStatus motion(TinkerBatch *batch, double *displacement, double *velocity, double *acceleration)
{
    for (int axis = 0; axis < 2; axis++) {
        const double *w = tinker_column(batch, COLUMN_VELOCITY + axis);
        for (int32_t i = 0; i < batch->count; i++) {
            displacement[2 * i + axis] = w[i] * batch->time;
            velocity[2 * i + axis] = w[i];
            acceleration[2 * i + axis] = 0.0;
        }
    }
    return TINKER_OK;
}

/* A motion with kinks offers `.next_break`: the next time at which a derivative jumps. */
static const TinkerMotion motion_role = {.struct_size = sizeof(TinkerMotion), .motion = motion};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .motion = &motion_role};

/* Drawing ---------------------------------------------------------------------------------------------------------- */

/* An arrow from the support's centre; `symbol_size` is the length that suits symbols in this scene. */
static TinkerArrow arrow_of(const TinkerInstance *instance, const TinkerStyle *style)
{
    const double *w = &instance->columns[COLUMN_VELOCITY], speed = tinker_length(w[0], w[1]);
    const double direction[2] = {speed > 0.0 ? w[0] / speed : 0.0, speed > 0.0 ? w[1] / speed : 0.0};
    return tinker_arrow_from(instance->end[0].x, instance->end[0].y, direction, 4.0 * style->symbol_size);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerArrow arrow = arrow_of(instance, style);
    style->arrow(style, cairo, TINKER_COLOUR_MOTION, arrow.x1, arrow.y1, arrow.x2, arrow.y2);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const TinkerArrow arrow = arrow_of(instance, style);
    tinker_arrow_bounds(&arrow, tinker_drawing_margin(style), box);
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 3, .draw = draw, .bounds = bounds};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *wx = tinker_column(batch, COLUMN_VELOCITY), *wy = tinker_column(batch, COLUMN_VELOCITY + 1);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = tinker_length(wx[i], wy[i]) * batch->time;
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_VECTOR_PROPERTY("velocity", "Velocity", "@title@", "X Velocity", "Y Velocity", TINKER_DIMENSION_VELOCITY),
     TINKER_ANY_VALUE(0, -5.0, 5.0), .default_value = {1.0, 0.0}, .symbol = "w", .variability = TINKER_STRUCTURAL,
     .description = "How fast it carries its support, and where to"},
};

/* The law once more, as data: from it come the equations of a scene, and a check of the code above. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("displacement_x", "wx*t", NULL, TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("displacement_y", "wy*t", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "distance", "Distance", "How far it has carried its support", TINKER_DIMENSION_LENGTH),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_MOTION), .summary = "Carries a support along at a constant speed",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

/* @title@: a fan: a torque against the turning, by the square of its rate. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. */
enum { COLUMN_STRENGTH };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* M = -c |omega| omega, with omega from the pose of what the end is on.
 *
 * `force` writes two numbers for each end of each block of the range, and with `.angles` the torque on what end k is on
 * to batch->angular, counter-clockwise. What has no angle, such as a mass, is not turned. */
static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *c = tinker_column(batch, COLUMN_STRENGTH);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const double rate = batch->poses[i].rate;
        result[2 * i] = 0.0;
        result[2 * i + 1] = 0.0;
        batch->angular[i] = -c[i] * (rate < 0.0 ? -rate : rate) * rate;
    }
    return TINKER_OK;
}

/* `.dissipates`: what it takes is booked as taken by dampers. A torque that comes from a potential offers `.energy`. */
static const TinkerForceElement force_element = {
    .struct_size = sizeof(TinkerForceElement), .angles = 1, .force = force, .dissipates = 1};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};

/* Drawing ---------------------------------------------------------------------------------------------------------- */

/* A ring about the hub; `symbol_size` is the length that suits symbols in this scene. */
static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *end = &instance->end[0];
    style->circle(style, cairo, -1, TINKER_COLOUR_FORCE, end->x, end->y, 2.0 * style->symbol_size);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->end[0].x, instance->end[0].y,
                      2.0 * style->symbol_size + tinker_drawing_margin(style));
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 3, .draw = draw, .bounds = bounds};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *c = tinker_column(batch, COLUMN_STRENGTH);
    if (input->poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const double rate = input->poses[i].rate;
        result[i] = -c[i] * (rate < 0.0 ? -rate : rate) * rate;
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("strength", "Strength", "@title@", TINKER_DIMENSION_INERTIA), TINKER_NOT_NEGATIVE(0, 10.0),
     .default_value = {1.0}, .symbol = "c", .variability = TINKER_TUNABLE,
     .description = "Torque over the square of the rate"},
};

/* The law once more, as data: from it come the equations of a scene, and a check of the code above. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("torque", "-c*abs(omega)*omega", NULL, TINKER_DIMENSION_TORQUE),
    TINKER_EQUATION("force_x", "0", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "0", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "torque", "Torque", "On what its end is on, counter-clockwise",
                    TINKER_DIMENSION_TORQUE),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_FORCE), .summary = "Slows what turns, by the square of its rate",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

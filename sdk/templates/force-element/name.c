/* @title@: pushes one body sideways, square to its velocity, as a magnetic field does with a charge and spin with a
 * ball. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. */
enum { COLUMN_STRENGTH };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* F = b (-vy, vx): to the left of where it moves. It does no work, so the speed stays.
 *
 * `force` writes two numbers for each end of each block of the range: end k of block i is at i * ends + k. Here each
 * block has one end. A law that looks at places sees them relative to batch->origin. */
static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *b = tinker_column(batch, COLUMN_STRENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        result[2 * i] = -b[i] * ends[i].vy;
        result[2 * i + 1] = b[i] * ends[i].vx;
    }
    return TINKER_OK;
}

/* A force that comes from a potential offers `.energy` as well, so that its work is booked as stored. */
static const TinkerForceElement force_element = {.struct_size = sizeof(TinkerForceElement), .force = force};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};

/* Drawing ---------------------------------------------------------------------------------------------------------- */

/* A ring with its name about the body; `symbol_size` is the length that suits symbols in this scene. */
static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *end = &instance->end[0];
    style->circle(style, cairo, -1, TINKER_COLOUR_FORCE, end->x, end->y, 3.0 * style->symbol_size);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->end[0].x, instance->end[0].y,
                      3.0 * style->symbol_size + tinker_drawing_margin(style));
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 3, .draw = draw, .bounds = bounds};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

/* input->forces are those that the law above gave. */
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = tinker_length(input->forces[2 * i], input->forces[2 * i + 1]);
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("strength", "Strength", "@title@", TINKER_DIMENSION_DAMPING),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .default_value = {1.0}, .symbol = "b", .variability = TINKER_TUNABLE,
     .description = "Force per speed; positive to the left"},
};

/* The law once more, as data: from it come the equations of a scene, and a check of the code above. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("force_x", "-b*vy", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "b*vx", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "force", "Force", "Magnitude of the force", TINKER_DIMENSION_FORCE),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_FORCE), .summary = "Pushes a body sideways as it moves", .least_ends = 1,
     .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

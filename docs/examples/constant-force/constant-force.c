/* Constant force: pushes one body with the same force for ever, F = (Fx, Fy). */
#include <tinker/sdk.h>

enum { COLUMN_FORCE_X, COLUMN_FORCE_Y };

/* Physics */

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *x = tinker_column(batch, COLUMN_FORCE_X), *y = tinker_column(batch, COLUMN_FORCE_Y);
    for (int32_t i = 0; i < batch->count; i++) {
        result[2 * i] = x[i];
        result[2 * i + 1] = y[i];
    }
    return TINKER_OK;
}

static const TinkerForceElement force_element = {.struct_size = sizeof(TinkerForceElement), .force = force};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double *force_columns = instance->columns + COLUMN_FORCE_X;
    const double size = tinker_length(force_columns[0], force_columns[1]);
    const double reach = size > 0.0 ? 6.0 * style->symbol_size / size : 0.0;
    const TinkerEnd *end = instance->end;
    style->arrow(style, cairo, TINKER_COLOUR_FORCE, end->x, end->y, end->x + reach * force_columns[0],
                 end->y + reach * force_columns[1]);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->end->x, instance->end->y, 6.0 * style->symbol_size + tinker_drawing_margin(style));
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 3, .draw = draw, .bounds = bounds};

/* Graphs */

static TinkerStatus power(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *values)
{
    for (int32_t i = 0; i < batch->count; i++)
        values[i] = input->forces[2 * i] * input->ends[i].vx + input->forces[2 * i + 1] * input->ends[i].vy;
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = power};

/* Declaration */

static const TinkerPropertyType properties[] = {
    {TINKER_VECTOR_PROPERTY("force", "Force", "Constant Force", "X", "Y", TINKER_DIMENSION_FORCE),
     TINKER_ANY_VALUE(0, -20.0, 20.0), .default_value = {1.0, 0.0}, .symbol = "F", .variability = TINKER_TUNABLE,
     .description = "The force on the body"},
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "power", "Power", "Power given to the body", TINKER_DIMENSION_POWER),
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("force_x", "Fx", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "Fy", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("constant-force", "Constant Force", TINKER_FORCE), .summary = "The same force on one body for ever",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.constant-force", "Constant Force", "1.0.0", "MIT", blocks)

/* Box: a rigid rectangle, which turns.
 *
 * Where its inertia is left out it is that of an even plate about its centre, m (w^2 + h^2) / 12. */
#include <tinker/sdk.h>

enum { COLUMN_WIDTH = TINKER_BODY_COLUMNS, COLUMN_HEIGHT };

static const TinkerBoxColumns box_columns = TINKER_BODY_BOX(COLUMN_WIDTH, COLUMN_HEIGHT);

/* Physics */

static TinkerStatus as_shaped(TinkerBatch *batch, int32_t property, double *values)
{
    const double *mass = tinker_column(batch, TINKER_BODY_MASS);
    const double *width = tinker_column(batch, COLUMN_WIDTH), *height = tinker_column(batch, COLUMN_HEIGHT);
    (void)property; /* the inertia is the only one */
    for (int32_t i = 0; i < batch->count; i++) {
        values[i] = mass[i] * (width[i] * width[i] + height[i] * height[i]) / 12.0;
    }
    return TINKER_OK;
}

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    style->box(style, cairo, TINKER_COLOUR_BODY, TINKER_COLOUR_BODY_EDGE, instance->x, instance->y,
               instance->columns[COLUMN_WIDTH], instance->columns[COLUMN_HEIGHT], instance->orientation);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_box_bounds(instance, &box_columns, tinker_drawing_margin(style), box);
}

/* Editing */

TINKER_DEFINE_BOX_EDIT(edit, box_columns)

/* Tables */

static const TinkerPropertyType properties[] = {
    TINKER_BODY_PROPERTIES(TINKER_SOLID),
    {TINKER_REAL_PROPERTY("width", "Width", "Size", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.1, 4.0),
     .default_value = {0.8}, .symbol = "w", .meaning = TINKER_MEANING_WIDTH, .variability = TINKER_STRUCTURAL,
     .description = "Along its own x axis"},
    {TINKER_REAL_PROPERTY("height", "Height", "Size", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.1, 4.0),
     .default_value = {0.8}, .symbol = "h", .meaning = TINKER_MEANING_HEIGHT, .variability = TINKER_STRUCTURAL,
     .description = "Along its own y axis"},
};

static const TinkerQuantityType quantities[] = {TINKER_BODY_QUANTITIES};

static const TinkerBody body = {sizeof(TinkerBody), 3, TINKER_SHAPE_BOX, 0, as_shaped};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body};
static const TinkerRender render = {sizeof(TinkerRender), 1, draw, bounds};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, tinker_body_values};

static const TinkerUnitChoice unit_choices[] = {TINKER_BODY_UNITS, {"width", "m", "ft"}, {"height", "m", "ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("box", "Box", TINKER_CONNECTABLE), .summary = "A rigid rectangle that turns",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.box", "Box", "0.1.0", "MIT", blocks)

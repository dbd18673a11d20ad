/* Mass: a point with inertia that forces act on, drawn as a box, or as a dot where its size is 0.
 *
 * The host integrates it (m a = F); the block only says what it is. Its box matters in one way: the centre stands off
 * the top of a solid support that it touches by half its height, however either is turned. */
#include <tinker/sdk.h>

enum {
    COLUMN_MASS,
    COLUMN_POSITION,
    COLUMN_VELOCITY = COLUMN_POSITION + 2,
    COLUMN_LOCAL_ORIGIN = COLUMN_VELOCITY + 2,
    COLUMN_ORIGIN_END = COLUMN_LOCAL_ORIGIN + 2,
    COLUMN_ORIENTATION = COLUMN_ORIGIN_END,
    COLUMN_WIDTH,
    COLUMN_HEIGHT,
};

/* Behind the six quantities of a point; the last one behind the three of contacts. */
enum { QUANTITY_SPEED = 6, QUANTITY_KINETIC_ENERGY, QUANTITY_X_MOMENTUM, QUANTITY_Y_MOMENTUM, QUANTITY_CONTACTS };
#define QUANTITY_ACCELERATION (QUANTITY_CONTACTS + 3)

static const TinkerBoxColumns box_columns = {COLUMN_POSITION, COLUMN_LOCAL_ORIGIN, COLUMN_ORIENTATION, COLUMN_WIDTH,
                                             COLUMN_HEIGHT};

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

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (quantity < QUANTITY_SPEED) return tinker_point_values(batch, input, quantity, result);
    if (quantity >= QUANTITY_CONTACTS && quantity < QUANTITY_ACCELERATION)
        return tinker_contact_values(batch, input, quantity - QUANTITY_CONTACTS, result);
    const double *mass = tinker_column(batch, COLUMN_MASS);
    if (quantity == QUANTITY_KINETIC_ENERGY) {
        for (int32_t i = 0; i < batch->count; i++) {
            const double vx = input->ends[i].vx, vy = input->ends[i].vy;
            result[i] = 0.5 * mass[i] * (vx * vx + vy * vy);
        }
        return TINKER_OK;
    }
    const int32_t component = quantity == QUANTITY_SPEED          ? 0
                              : quantity == QUANTITY_ACCELERATION ? 1
                              : quantity == QUANTITY_X_MOMENTUM   ? 2
                                                                  : 3;
    return tinker_centre_values(batch, input, mass, component, result);
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("mass", "Mass", "Properties", TINKER_DIMENSION_MASS), TINKER_POSITIVE(0, 0.1, 10.0),
     .default_value = {1.0}, .symbol = "m", .meaning = TINKER_MEANING_MASS, .variability = TINKER_TUNABLE,
     .description = "How much it resists being accelerated"},
    {TINKER_VECTOR_PROPERTY("position", "Position", "Global Position", "X", "Y", TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .symbol = "x", .meaning = TINKER_MEANING_POSITION, .variability = TINKER_INITIAL,
     .description = "Where its centre starts"},
    {TINKER_VECTOR_PROPERTY("velocity", "Velocity", "Initial Velocity", "Vx", "Vy", TINKER_DIMENSION_VELOCITY),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .symbol = "v", .meaning = TINKER_MEANING_VELOCITY, .variability = TINKER_INITIAL,
     .description = "How it moves at the start"},
    {TINKER_VECTOR_PROPERTY("local_origin", "Local Origin", "Offset (Local Coordinates)", "X", "Y",
                            TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(TINKER_DEFAULT_SAME_AS, -10.0, 10.0), .default_from = "position",
     .meaning = TINKER_MEANING_LOCAL_ORIGIN, .variability = TINKER_TUNABLE,
     .description = "Where its offset is measured from; the motion does not depend on it"},
    {TINKER_REAL_PROPERTY("orientation", "Orientation", "Properties", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .meaning = TINKER_MEANING_ORIENTATION, .variability = TINKER_INITIAL,
     .description = "How it is drawn at the start, counter-clockwise; landing on a support turns it along the top"},
    {TINKER_REAL_PROPERTY("width", "Width", "Size", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 4.0),
     .default_value = {0.8}, .meaning = TINKER_MEANING_WIDTH, .variability = TINKER_STRUCTURAL,
     .description = "Width of its box, for the drawing; with a height of 0 it is a dot"},
    {TINKER_REAL_PROPERTY("height", "Height", "Size", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 4.0),
     .default_value = {0.8}, .meaning = TINKER_MEANING_HEIGHT, .variability = TINKER_STRUCTURAL,
     .description = "Height of its box: its centre stands half of it off what it touches"},
    TINKER_SURFACE_PROPERTIES,
    {TINKER_SWITCH_PROPERTY("collides", "Collides", "Properties"), .meaning = TINKER_MEANING_COLLIDES,
     .variability = TINKER_STRUCTURAL,
     .description =
         "Whether its box meets others that collide, and bodies that turn; it is not turned by landing then"},
};

static const TinkerQuantityType quantities[] = {
    TINKER_POINT_QUANTITIES(TINKER_RECORDED),
    TINKER_QUANTITY(0, "speed", "Speed", "Magnitude of the velocity", TINKER_DIMENSION_VELOCITY),
    TINKER_QUANTITY(0, "kinetic energy", "Kinetic Energy", "m v^2 / 2", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "x momentum", "X Momentum", "m vx", TINKER_DIMENSION_MOMENTUM),
    TINKER_QUANTITY(0, "y momentum", "Y Momentum", "m vy", TINKER_DIMENSION_MOMENTUM),
    TINKER_CONTACT_QUANTITIES,
    TINKER_QUANTITY(0, "acceleration", "Acceleration", "Magnitude of the acceleration", TINKER_DIMENSION_ACCELERATION),
};

static const TinkerBody body = {sizeof(TinkerBody), 2, TINKER_SHAPE_BOX, 0};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body};
static const TinkerRender render = {sizeof(TinkerRender), 1, draw, bounds};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"orientation", "deg", "deg"},
    {"kinetic energy", "J", "lbf*ft"},
    {"x momentum", "kg*m/s", "slug*ft/s"},
    {"y momentum", "kg*m/s", "slug*ft/s"},
};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("mass", "Mass", TINKER_CONNECTABLE), .summary = "A point with inertia that forces act on",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.mass", "Mass", "0.1.0", "MIT", blocks)

/* @title@: a round point mass that nothing collides with, and that knows its angular momentum: a planet. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. A vector takes two. */
enum { COLUMN_MASS, COLUMN_POSITION, COLUMN_VELOCITY = COLUMN_POSITION + 2, COLUMN_RADIUS = COLUMN_VELOCITY + 2 };

/* The six quantities of a point come first. */
enum { QUANTITY_ANGULAR_MOMENTUM = 6 };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* A body has no law of its own: it says how it can move, and the host integrates m a = F. Which of its properties are
 * its mass, place and velocity is said by their `.meaning` below. 2 degrees of freedom: a point mass; 0: its place is a
 * known function of time. A body may be a field as well, and nothing else. */
static const TinkerBody body = {.struct_size = sizeof(TinkerBody), .degrees_of_freedom = 2, .shape = TINKER_SHAPE_NONE};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body};

/* Drawing and editing ---------------------------------------------------------------------------------------------- */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    style->circle(style, cairo, TINKER_COLOUR_BODY, TINKER_COLOUR_BODY_EDGE, instance->x, instance->y,
                  instance->columns[COLUMN_RADIUS]);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->x, instance->y, instance->columns[COLUMN_RADIUS] + tinker_drawing_margin(style));
}

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double distance = tinker_length(x - instance->x, y - instance->y);
    return distance <= instance->columns[COLUMN_RADIUS] + reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* Changes go through the editor, so that they can be undone. */
static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    editor->set(editor, COLUMN_POSITION, instance->columns[COLUMN_POSITION] + dx);
    editor->set(editor, COLUMN_POSITION + 1, instance->columns[COLUMN_POSITION + 1] + dy);
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    move(instance, part, x - instance->x, y - instance->y, editor);
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 1, .draw = draw, .bounds = bounds};
static const TinkerEdit edit = {
    .struct_size = sizeof(TinkerEdit), .hit = hit, .move = move, .move_absolute = move_absolute};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

/* About the world's origin: m (x vy - y vx). A body's places are those of the world: batch->origin is 0 here. */
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *mass = tinker_column(batch, COLUMN_MASS);
    if (quantity < QUANTITY_ANGULAR_MOMENTUM) return tinker_point_values(batch, input, quantity, result);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *point = &input->ends[i];
        result[i] = mass[i] * (point->x * point->vy - point->y * point->vx);
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("mass", "Mass", "@title@", TINKER_DIMENSION_MASS), TINKER_POSITIVE(0, 0.1, 10.0),
     .default_value = {1.0}, .symbol = "m", .meaning = TINKER_MEANING_MASS, .variability = TINKER_TUNABLE,
     .description = "How much it resists being accelerated"},
    {TINKER_VECTOR_PROPERTY("position", "Position", "Global Position", "X", "Y", TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .symbol = "x", .meaning = TINKER_MEANING_POSITION, .variability = TINKER_INITIAL,
     .description = "Where its centre starts"},
    {TINKER_VECTOR_PROPERTY("velocity", "Velocity", "Initial Velocity", "Vx", "Vy", TINKER_DIMENSION_VELOCITY),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .symbol = "v", .meaning = TINKER_MEANING_VELOCITY, .variability = TINKER_INITIAL,
     .description = "How it moves at the start"},
    {TINKER_REAL_PROPERTY("radius", "Radius", "Size", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 2.0),
     .default_value = {0.3}, .variability = TINKER_TUNABLE, .description = "How large it is drawn"},
};

static const TinkerQuantityType quantities[] = {
    TINKER_POINT_QUANTITIES(TINKER_RECORDED),
    TINKER_QUANTITY(0, "angular momentum", "Angular Momentum", "m (x vy - y vx)", {1, 2, -1, 0}),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_CONNECTABLE), .summary = "A round mass that nothing collides with",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

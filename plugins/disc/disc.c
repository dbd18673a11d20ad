/* Disc: a rigid round body, which turns.
 *
 * Where its inertia is left out it is that of an even disc about its centre, m r^2 / 2; a hoop is a disc with m r^2. */
#include <tinker/sdk.h>

enum { COLUMN_RADIUS = TINKER_BODY_COLUMNS };

/* Where its place is; as a box it has no size. */
static const TinkerBoxColumns place_columns = TINKER_BODY_BOX(-1, -1);

/* Physics */

static TinkerStatus as_shaped(TinkerBatch *batch, int32_t property, double *values)
{
    const double *mass = tinker_column(batch, TINKER_BODY_MASS), *radius = tinker_column(batch, COLUMN_RADIUS);
    (void)property; /* the inertia is the only one */
    for (int32_t i = 0; i < batch->count; i++) {
        values[i] = mass[i] * radius[i] * radius[i] / 2.0;
    }
    return TINKER_OK;
}

/* Drawing */

/* With a spoke along its own x axis, so that its turning shows. */
static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    double x, y;
    tinker_box_to_world(instance, instance->columns[COLUMN_RADIUS], 0.0, &x, &y);
    style->circle(style, cairo, TINKER_COLOUR_BODY, TINKER_COLOUR_BODY_EDGE, instance->x, instance->y,
                  instance->columns[COLUMN_RADIUS]);
    style->line(style, cairo, TINKER_COLOUR_BODY_EDGE, instance->x, instance->y, x, y);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->x, instance->y, instance->columns[COLUMN_RADIUS] + tinker_drawing_margin(style));
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double distance = tinker_length(x - instance->x, y - instance->y);
    return distance <= instance->columns[COLUMN_RADIUS] + reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* The handle of its size is at the right of its rim. */
static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    const double radius = instance->columns[COLUMN_RADIUS];
    double x, y;
    tinker_box_to_world(instance, radius, 0.0, &x, &y);
    const int32_t count = tinker_handle_add(list, room, 0, TINKER_HANDLE_SIZE, x, y);
    return tinker_turned_handles(instance, &place_columns, radius, radius, list, room, count);
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    if (part == TINKER_HANDLE_SIZE) {
        editor->set(editor, COLUMN_RADIUS, tinker_length(x - instance->x, y - instance->y));
    } else {
        tinker_turned_move_absolute(instance, &place_columns, part, x, y, editor);
    }
}

static const TinkerEdit edit;

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    tinker_turned_move(instance, &place_columns, &edit, part, dx, dy, editor);
}

/* Tables */

static const TinkerPropertyType properties[] = {
    TINKER_BODY_PROPERTIES(TINKER_SOLID),
    {TINKER_REAL_PROPERTY("radius", "Radius", "Size", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.1, 2.0),
     .meaning = TINKER_MEANING_RADIUS, .default_value = {0.4}, .symbol = "r", .variability = TINKER_STRUCTURAL,
     .description = "From its centre to its rim"},
    {TINKER_REAL_PROPERTY("rolling_resistance", "Rolling resistance", "Friction", TINKER_DIMENSION_LENGTH),
     TINKER_NOT_NEGATIVE(TINKER_DEFAULT_NONE, 0.1), .meaning = TINKER_MEANING_ROLLING_RESISTANCE, .symbol = "ρ",
     .variability = TINKER_STRUCTURAL,
     .description = "The moment that resists its rolling on what it touches, at most, per normal force"},
};

static const TinkerQuantityType quantities[] = {TINKER_BODY_QUANTITIES};

static const TinkerBody body = {sizeof(TinkerBody), 3, TINKER_SHAPE_DISC, 0, as_shaped};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body};
static const TinkerRender render = {sizeof(TinkerRender), 1, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, tinker_body_values};

static const TinkerUnitChoice unit_choices[] = {
    TINKER_BODY_UNITS, {"radius", "m", "ft"}, {"rolling_resistance", "m", "ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("disc", "Disc", TINKER_CONNECTABLE), .summary = "A rigid round body that turns",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.disc", "Disc", "0.1.0", "MIT", blocks)

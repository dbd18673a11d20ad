/* Disc: a rigid round body, which turns.
 *
 * Where its inertia is left out it is that of an even disc about its centre, m r^2 / 2; a hoop is a disc with m r^2. */
#include <tinker/sdk.h>

enum { COLUMN_RADIUS = TINKER_BODY_COLUMNS };

#define HANDLE_RADIUS   (TINKER_PART_HANDLE + 0) /* at the right of its rim */
#define HANDLE_ROTATION (TINKER_PART_HANDLE + 1) /* beyond its top */
#define HANDLE_ORIGIN   (TINKER_PART_HANDLE + 2)

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

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    const double symbol = tinker_instance_symbol_size(instance), radius = instance->columns[COLUMN_RADIUS];
    double x, y;
    tinker_box_to_world(instance, radius, 0.0, &x, &y);
    int32_t count = tinker_handle_add(list, room, 0, HANDLE_RADIUS, x, y);
    tinker_box_to_world(instance, 0.0, radius + 2.0 * symbol, &x, &y);
    count = tinker_handle_add(list, room, count, HANDLE_ROTATION, x, y);
    x = instance->columns[TINKER_BODY_LOCAL_ORIGIN];
    y = instance->columns[TINKER_BODY_LOCAL_ORIGIN + 1];
    if (tinker_length(x - instance->x, y - instance->y) <= symbol) {
        tinker_box_to_world(instance, -radius - symbol, -radius - symbol, &x, &y);
    }
    return tinker_handle_add(list, room, count, HANDLE_ORIGIN, x, y);
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    const double *columns = instance->columns;
    if (part == TINKER_PART_WHOLE) {
        editor->set(editor, TINKER_BODY_POSITION, x - (instance->x - columns[TINKER_BODY_POSITION]));
        editor->set(editor, TINKER_BODY_POSITION + 1, y - (instance->y - columns[TINKER_BODY_POSITION + 1]));
    } else if (part == HANDLE_ORIGIN) {
        editor->set(editor, TINKER_BODY_LOCAL_ORIGIN, x);
        editor->set(editor, TINKER_BODY_LOCAL_ORIGIN + 1, y);
    } else if (part == HANDLE_RADIUS) {
        editor->set(editor, COLUMN_RADIUS, tinker_length(x - instance->x, y - instance->y));
    } else if (part == HANDLE_ROTATION) {
        tinker_set_angle(editor, TINKER_BODY_ORIENTATION, y - instance->y, instance->x - x);
    }
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    TinkerHandle list[3];
    if (part == TINKER_PART_WHOLE || part == HANDLE_ORIGIN) {
        const int32_t column = part == TINKER_PART_WHOLE ? TINKER_BODY_POSITION : TINKER_BODY_LOCAL_ORIGIN;
        editor->set(editor, column, instance->columns[column] + dx);
        editor->set(editor, column + 1, instance->columns[column + 1] + dy);
        return;
    }
    const int32_t count = handles(instance, list, 3);
    for (int32_t k = 0; k < count; k++) {
        if (list[k].part == part) move_absolute(instance, part, list[k].x + dx, list[k].y + dy, editor);
    }
}

/* Tables */

static const TinkerPropertyType properties[] = {
    TINKER_BODY_PROPERTIES(TINKER_SOLID),
    {TINKER_REAL_PROPERTY("radius", "Radius", "Size", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.1, 2.0),
     .meaning = TINKER_MEANING_RADIUS, .default_value = {0.4}, .symbol = "r", .variability = TINKER_STRUCTURAL,
     .description = "From its centre to its rim"},
};

static const TinkerQuantityType quantities[] = {TINKER_BODY_QUANTITIES};

static const TinkerBody body = {sizeof(TinkerBody), 3, TINKER_SHAPE_DISC, 0, as_shaped};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body};
static const TinkerRender render = {sizeof(TinkerRender), 1, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, tinker_body_values};

static const TinkerUnitChoice unit_choices[] = {TINKER_BODY_UNITS, {"radius", "m", "ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("disc", "Disc", TINKER_CONNECTABLE), .summary = "A rigid round body that turns",
     .formula = "m a = F, I alpha = M", .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.disc", "Disc", "0.1.0", "MIT", blocks)

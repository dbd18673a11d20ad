/* Support: a place that does not give way, and a plate with one solid side.
 *
 * Forces do not move it. Its solid side is its top, the +y side of its own axes: masses that come from above stop there
 * or bounce, rest and slide with friction; from below and from the ends they pass. The host works out the contacts; the
 * block only says what it is. It is drawn as a slab whose solid line is the top; one that is not solid as a pin. */
#include <tinker/sdk.h>

enum {
    COLUMN_POSITION,
    COLUMN_LOCAL_ORIGIN = COLUMN_POSITION + 2,
    COLUMN_ORIGIN_END = COLUMN_LOCAL_ORIGIN + 2,
    COLUMN_ORIENTATION = COLUMN_ORIGIN_END,
    COLUMN_WIDTH,
    COLUMN_HEIGHT,
    COLUMN_STATIC_FRICTION,
    COLUMN_DYNAMIC_FRICTION,
    COLUMN_RESTITUTION,
    COLUMN_SOLID,
    COLUMN_COUNT,
};

/* The radius of a pin's ring, of half the width of its ground. */
#define RING_SHARE 0.25

/* Of a point; those of its contacts follow. */
enum { POINT_QUANTITIES = 6 };

static const TinkerBoxColumns box_columns = {COLUMN_POSITION, COLUMN_LOCAL_ORIGIN, COLUMN_ORIENTATION, COLUMN_WIDTH,
                                             COLUMN_HEIGHT};

/* Physics */

static TinkerStatus prepare(TinkerBatch *batch)
{
    const double *at_rest = tinker_column(batch, COLUMN_STATIC_FRICTION);
    const double *sliding = tinker_column(batch, COLUMN_DYNAMIC_FRICTION);
    for (int32_t i = 0; i < batch->count; i++) {
        if (sliding[i] > at_rest[i]) {
            return tinker_fail(batch, i,
                               "dynamic_friction is above static_friction; it must be at most as large, since sliding "
                               "never holds better than rest");
        }
    }
    return TINKER_OK;
}

/* A pin is no wider than high, however long the slab would be. */
static double drawn_width(const TinkerInstance *instance)
{
    const double width = instance->columns[COLUMN_WIDTH];
    return instance->columns[COLUMN_SOLID] != 0.0 ? width : fmin(width, instance->columns[COLUMN_HEIGHT]);
}

/* The support as large as it is drawn, its columns in `columns`. */
static TinkerInstance as_drawn(const TinkerInstance *instance, double columns[COLUMN_COUNT])
{
    TinkerInstance drawn = *instance;
    for (int column = 0; column < COLUMN_COUNT; column++)
        columns[column] = instance->columns[column];
    columns[COLUMN_WIDTH] = drawn_width(instance);
    drawn.columns = columns;
    return drawn;
}

/* Drawing */

/* A line between two points of the support's own axes, with hatching on its right-hand side where it is wanted. */
static void draw_own_line(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style,
                          const double from[2], const double to[2], int hatched)
{
    double x1, y1, x2, y2;
    tinker_box_to_world(instance, from[0], from[1], &x1, &y1);
    tinker_box_to_world(instance, to[0], to[1], &x2, &y2);
    if (hatched) style->hatch(style, cairo, TINKER_COLOUR_BODY_EDGE, x1, y1, x2, y2);
    style->line(style, cairo, TINKER_COLOUR_BODY_EDGE, x1, y1, x2, y2);
}

/* The hatching lies below the line from left to right: in the slab. */
static void draw_slab(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double width = instance->columns[COLUMN_WIDTH], height = instance->columns[COLUMN_HEIGHT];
    const double left[2] = {-width / 2.0, height / 2.0}, right[2] = {width / 2.0, height / 2.0};
    style->box(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_SUPPORT, instance->x, instance->y, width, height,
               instance->orientation);
    draw_own_line(instance, cairo, style, left, right, 1);
}

/* A pin as textbooks draw it: a triangle on hatched ground, its point at the centre. */
static void draw_pin(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double height = instance->columns[COLUMN_HEIGHT], half = drawn_width(instance) / 2.0;
    const double top[2] = {0.0, 0.0}, left[2] = {-half, -height / 2.0}, right[2] = {half, -height / 2.0};
    draw_own_line(instance, cairo, style, top, left, 0);
    draw_own_line(instance, cairo, style, top, right, 0);
    draw_own_line(instance, cairo, style, left, right, 1);
    style->circle(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_BODY_EDGE, instance->x, instance->y,
                  RING_SHARE * half);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    if (instance->columns[COLUMN_SOLID] != 0.0) {
        draw_slab(instance, cairo, style);
    } else {
        draw_pin(instance, cairo, style);
    }
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    double columns[COLUMN_COUNT];
    const TinkerInstance drawn = as_drawn(instance, columns);
    tinker_box_bounds(&drawn, &box_columns, tinker_drawing_margin(style), box);
}

/* Editing */

/* A pin lies below its ring, where it leaves free what hangs on it. */
static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    double columns[COLUMN_COUNT];
    TinkerInstance drawn = as_drawn(instance, columns);
    if (instance->columns[COLUMN_SOLID] == 0.0) {
        const double below = columns[COLUMN_HEIGHT] / 2.0, above = RING_SHARE * columns[COLUMN_WIDTH] / 2.0;
        columns[COLUMN_HEIGHT] = below + above;
        tinker_box_to_world(instance, 0.0, (above - below) / 2.0, &drawn.x, &drawn.y);
    }
    return tinker_box_hit(&drawn, &box_columns, x, y, reach);
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *all, int32_t room)
{
    double columns[COLUMN_COUNT];
    const TinkerInstance drawn = as_drawn(instance, columns);
    return tinker_box_handles(&drawn, &box_columns, all, room);
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    tinker_box_move_absolute(instance, &box_columns, part, x, y, editor);
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor);

static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    tinker_turned_move(instance, &box_columns, &edit, part, dx, dy, editor);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (quantity < POINT_QUANTITIES) return tinker_point_values(batch, input, quantity, result);
    return tinker_contact_values(batch, input, quantity - POINT_QUANTITIES, result);
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_VECTOR_PROPERTY("position", "Position", "Global Position", "X", "Y", TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .symbol = "x", .meaning = TINKER_MEANING_POSITION, .variability = TINKER_INITIAL,
     .description = "Where its centre is placed"},
    {TINKER_VECTOR_PROPERTY("local_origin", "Local Origin", "Offset (Local Coordinates)", "X", "Y",
                            TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(TINKER_DEFAULT_SAME_AS, -10.0, 10.0), .default_from = "position",
     .meaning = TINKER_MEANING_LOCAL_ORIGIN, .variability = TINKER_TUNABLE,
     .description = "Where its offset is measured from; the motion does not depend on it"},
    {TINKER_REAL_PROPERTY("orientation", "Orientation", "Properties", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .meaning = TINKER_MEANING_ORIENTATION,
     .variability = TINKER_STRUCTURAL, .description = "Counter-clockwise; at 0 its top faces up"},
    {TINKER_REAL_PROPERTY("width", "Width", "Size", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 20.0),
     .default_value = {4.0}, .meaning = TINKER_MEANING_WIDTH, .variability = TINKER_STRUCTURAL,
     .description = "Length of its top: a mass touches while its centre is over it"},
    {TINKER_REAL_PROPERTY("height", "Height", "Size", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 4.0),
     .default_value = {0.4}, .meaning = TINKER_MEANING_HEIGHT, .variability = TINKER_STRUCTURAL,
     .description = "Its top lies half of it above the centre"},
    {TINKER_REAL_PROPERTY("static_friction", "Static coefficient", "Friction", TINKER_DIMENSION_NONE),
     TINKER_NOT_NEGATIVE(0, 1.0), .default_value = {0.5}, .symbol = "μs", .meaning = TINKER_MEANING_STATIC_FRICTION,
     .variability = TINKER_TUNABLE,
     .description = "Friction that holds a mass at rest on it, at most, per normal force"},
    {TINKER_REAL_PROPERTY("dynamic_friction", "Dynamic coefficient", "Friction", TINKER_DIMENSION_NONE),
     TINKER_NOT_NEGATIVE(0, 1.0), .default_value = {0.5}, .symbol = "μd", .meaning = TINKER_MEANING_DYNAMIC_FRICTION,
     .variability = TINKER_TUNABLE,
     .description = "Friction on a mass that slides on it, per normal force; at most the static coefficient"},
    {TINKER_REAL_PROPERTY("restitution", "Restitution", "Properties", TINKER_DIMENSION_NONE),
     TINKER_BETWEEN(0, 0.0, 1.0), .symbol = "e", .meaning = TINKER_MEANING_RESTITUTION, .variability = TINKER_TUNABLE,
     .description = "How much of its normal velocity a mass keeps when it bounces: 0 none, 1 all"},
    {TINKER_SWITCH_PROPERTY("solid", "Solid", "Properties"), .default_value = {1.0}, .meaning = TINKER_MEANING_SOLID,
     .variability = TINKER_STRUCTURAL,
     .description = "On: masses cannot pass its top from above; off: a mere anchor, drawn as a pin"},
};

static const TinkerQuantityType quantities[] = {TINKER_POINT_QUANTITIES(0), TINKER_CONTACT_QUANTITIES};

static const TinkerBody body = {sizeof(TinkerBody), 0, TINKER_SHAPE_PLATE, 0};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body, .prepare = prepare};
static const TinkerRender render = {sizeof(TinkerRender), 0, draw, bounds};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"orientation", "deg", "deg"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("support", "Support", TINKER_CONNECTABLE),
     .summary = "A fixed place to attach to, with a top that masses land on: floor, wall, ramp, incline, pivot",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.support", "Support", "0.1.0", "MIT", blocks)

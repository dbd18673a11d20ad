/* Plate: a rigid body with the outline of a polygon, which turns.
 *
 * With the corners (x_i, y_i) in order, c_i = x_i y_i+1 - x_i+1 y_i, A = sum c_i / 2, where left out:
 *
 *     centre of mass   sum (x_i + x_i+1) c_i / 6 A, and so for y,
 *     inertia          m times the second moment of area about that over A (Green's theorem), for an even plate.
 *
 * The corners are in axes of their own; the centre of mass lies at the block's place, and places on it count from
 * there. */
#include <tinker/sdk.h>

enum { COLUMN_CENTRE = TINKER_BODY_COLUMNS };

/* Where its place is; as a box it has no size. */
static const TinkerBoxColumns place_columns = TINKER_BODY_BOX(-1, -1);

/* Physics */

typedef struct {
    double area;      /* m^2: positive counter-clockwise */
    double centre[2]; /* m */
    double second;    /* m^2: second moment about the centre, over the area */
} Shape;

static double cross(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* From the first corner on, so that a plate far from its origin loses no digits. */
static Shape shape_of(const TinkerPointList *corners)
{
    Shape shape = {0.0, {0.0, 0.0}, 0.0};
    const double *from = corners->points;
    double second = 0.0;
    for (int32_t i = 1; i + 1 < corners->count; i++) {
        const double *a = &corners->points[2 * i], *b = a + 2, twice = cross(from, a, b);
        const double ax = a[0] - from[0], ay = a[1] - from[1], bx = b[0] - from[0], by = b[1] - from[1];
        shape.area += 0.5 * twice;
        shape.centre[0] += twice * (ax + bx) / 6.0;
        shape.centre[1] += twice * (ay + by) / 6.0;
        second += twice * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12.0;
    }
    if (shape.area == 0.0) return shape;
    shape.centre[0] /= shape.area;
    shape.centre[1] /= shape.area;
    shape.second = second / shape.area - shape.centre[0] * shape.centre[0] - shape.centre[1] * shape.centre[1];
    if (corners->count > 0) {
        shape.centre[0] += from[0];
        shape.centre[1] += from[1];
    }
    return shape;
}

/* What is no outline is told by `prepare`; until then it has some size, so that it can be drawn and mended. */
static TinkerStatus as_shaped(TinkerBatch *batch, int32_t property, double *values)
{
    const double *mass = tinker_column(batch, TINKER_BODY_MASS);
    const double *x = tinker_column(batch, COLUMN_CENTRE), *y = tinker_column(batch, COLUMN_CENTRE + 1);
    for (int32_t i = 0; i < batch->count; i++) {
        const Shape shape = shape_of(&batch->point_lists[i]);
        if (property != TINKER_BODY_INERTIA_PROPERTY) {
            values[2 * i] = shape.centre[0];
            values[2 * i + 1] = shape.centre[1];
            continue;
        }
        const double dx = isnan(x[i]) ? 0.0 : x[i] - shape.centre[0], dy = isnan(y[i]) ? 0.0 : y[i] - shape.centre[1];
        const double square = shape.second + dx * dx + dy * dy;
        values[i] = mass[i] * (square > 0.0 ? square : 1.0);
    }
    return TINKER_OK;
}

static int lies_between(const double *a, const double *b, const double *p)
{
    return fmin(a[0], b[0]) <= p[0] && p[0] <= fmax(a[0], b[0]) && fmin(a[1], b[1]) <= p[1] && p[1] <= fmax(a[1], b[1]);
}

/* Whether the edges from a to b and from c to d have a point in common. */
static int meet(const double *a, const double *b, const double *c, const double *d)
{
    const double p = cross(a, b, c), q = cross(a, b, d), r = cross(c, d, a), s = cross(c, d, b);
    if (((p > 0.0 && q < 0.0) || (p < 0.0 && q > 0.0)) && ((r > 0.0 && s < 0.0) || (r < 0.0 && s > 0.0))) return 1;
    return (p == 0.0 && lies_between(a, b, c)) || (q == 0.0 && lies_between(a, b, d)) ||
           (r == 0.0 && lies_between(c, d, a)) || (s == 0.0 && lies_between(c, d, b));
}

/* Neighbours meet in their corner, and may not fold back. */
static int crosses_itself(const TinkerPointList *corners)
{
    const int32_t n = corners->count;
    for (int32_t i = 0; i < n; i++) {
        const double *a = &corners->points[2 * i], *b = &corners->points[2 * ((i + 1) % n)];
        const double *next = &corners->points[2 * ((i + 2) % n)];
        if (cross(a, b, next) == 0.0 && (lies_between(a, b, next) || lies_between(b, next, a))) return 1;
        for (int32_t k = i + 2; k < n && (k + 1) % n != i; k++) {
            if (meet(a, b, &corners->points[2 * k], &corners->points[2 * ((k + 1) % n)])) return 1;
        }
    }
    return 0;
}

static int lie_on_one_line(const TinkerPointList *corners)
{
    const int32_t n = corners->count;
    for (int32_t i = 0; i < n; i++) {
        if (cross(&corners->points[2 * i], &corners->points[2 * ((i + 1) % n)], &corners->points[2 * ((i + 2) % n)]) !=
            0.0)
            return 0;
    }
    return 1;
}

static TinkerStatus prepare(TinkerBatch *batch)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPointList *corners = &batch->point_lists[i];
        if (corners->count < 3) {
            return tinker_fail(batch, i,
                               "corners are fewer than 3; an outline has at least 3, as [[0, 0], [1, 0], [0, 1]]");
        }
        const int is_flat = shape_of(corners).area == 0.0;
        if (is_flat && lie_on_one_line(corners)) {
            return tinker_fail(batch, i, "its corners enclose no area; they must not all lie on one line");
        }
        if (is_flat || crosses_itself(corners)) {
            return tinker_fail(batch, i,
                               "its outline crosses or touches itself; give the corners in order round the outline");
        }
    }
    return TINKER_OK;
}

/* Drawing */

#define MOST_DRAWN 1000

/* In the world, the first again at the end. */
static int32_t outline_of(const TinkerInstance *instance, double *points)
{
    const TinkerPointList *corners = instance->point_lists;
    const double *columns = instance->columns;
    const int32_t count = corners == NULL ? 0 : corners->count < MOST_DRAWN ? corners->count : MOST_DRAWN;
    for (int32_t i = 0; i < count; i++) {
        tinker_box_to_world(instance, corners->points[2 * i] - columns[COLUMN_CENTRE],
                            corners->points[2 * i + 1] - columns[COLUMN_CENTRE + 1], &points[2 * i],
                            &points[2 * i + 1]);
    }
    return count;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    double points[2 * MOST_DRAWN];
    const int32_t count = outline_of(instance, points);
    style->polygon(style, cairo, TINKER_COLOUR_BODY, TINKER_COLOUR_BODY_EDGE, points, count);
    style->circle(style, cairo, TINKER_COLOUR_BODY_EDGE, -1, instance->x, instance->y, 0.12 * style->symbol_size);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    double points[2 * MOST_DRAWN];
    const int32_t count = outline_of(instance, points);
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->x, instance->y, tinker_drawing_margin(style));
    for (int32_t i = 0; i < count; i++) {
        tinker_bounds_add(box, points[2 * i], points[2 * i + 1], tinker_drawing_margin(style));
    }
}

/* Editing: whole; the host moves its corners */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    double points[2 * MOST_DRAWN];
    const int32_t count = outline_of(instance, points);
    int inside = 0;
    for (int32_t i = 0, k = count - 1; i < count; k = i++) {
        const double *a = &points[2 * i], *b = &points[2 * k];
        if (tinker_segment_distance(x, y, a[0], a[1], b[0], b[1]) <= reach) return TINKER_PART_WHOLE;
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside || tinker_length(x - instance->x, y - instance->y) <= reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* How far its corners are from its place; the handle for turning is beyond. */
static double extent_of(const TinkerInstance *instance)
{
    double points[2 * MOST_DRAWN], extent = 0.0;
    const int32_t count = outline_of(instance, points);
    for (int32_t i = 0; i < count; i++) {
        extent = fmax(extent, tinker_length(points[2 * i] - instance->x, points[2 * i + 1] - instance->y));
    }
    return extent;
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    double points[2 * MOST_DRAWN];
    const double extent = extent_of(instance);
    const int32_t corners = outline_of(instance, points);
    int32_t count = tinker_turned_handles(instance, &place_columns, extent, extent, list, room, 0);
    for (int32_t i = 0; i < corners; i++) {
        count = tinker_handle_add(list, room, count, TINKER_PART_POINT + i, points[2 * i], points[2 * i + 1]);
    }
    return count;
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    tinker_turned_move_absolute(instance, &place_columns, part, x, y, editor);
}

static const TinkerEdit edit;

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    tinker_turned_move(instance, &place_columns, &edit, part, dx, dy, editor);
}

/* Tables */

static const TinkerPropertyType properties[] = {
    TINKER_BODY_PROPERTIES(TINKER_SOLID),
    {TINKER_POINTS_PROPERTY("corners", "Corners", "Size", "-0.5 -0.3; 0.5 -0.3; 0 0.6", TINKER_DIMENSION_LENGTH),
     .variability = TINKER_STRUCTURAL,
     .description = "Points in order round its outline, in axes of its own: x y; x y; ..."},
    {TINKER_VECTOR_PROPERTY("centre_of_mass", "Centre of Mass", "Size", "X", "Y", TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(TINKER_DEFAULT_AS_SHAPED, -2.0, 2.0), .meaning = TINKER_MEANING_CENTRE_OF_MASS,
     .variability = TINKER_STRUCTURAL, .description = "In the axes of the corners"},
};

static const TinkerQuantityType quantities[] = {TINKER_BODY_QUANTITIES};

static const TinkerBody body = {sizeof(TinkerBody), 3, TINKER_SHAPE_OUTLINE, 0, as_shaped};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body, .prepare = prepare};
static const TinkerRender render = {sizeof(TinkerRender), 1, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, tinker_body_values};

static const TinkerUnitChoice unit_choices[] = {TINKER_BODY_UNITS, {"centre_of_mass", "m", "ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("plate", "Plate", TINKER_CONNECTABLE), .summary = "A rigid body with any outline, which turns",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.plate", "Plate", "0.1.0", "MIT", blocks)

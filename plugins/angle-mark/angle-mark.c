/* Angle mark: the angle at its second end between the ways to the first and to the third, as an arc with its value. It
 * acts on nothing, so that a scene moves with it as without it.
 *
 * With a = x_1 - x_2 and b = x_3 - x_2 the angle is atan2(a x b, a . b): from the first way counter-clockwise to the
 * third's, in (-pi, pi]. Its rate is (b x vb)/|b|^2 - (a x va)/|a|^2, of the velocities of the ends against the
 * second. */
#include <stdio.h>

#include <tinker/sdk.h>

enum { QUANTITY_ANGLE, QUANTITY_RATE };

#define RADIUS   3.0 /* symbol sizes, of the arc, */
#define HALF     1.6 /* half a text */
#define SHARE    0.6 /* of the shorter way, at most */
#define TEXT     1.2 /* symbol sizes from the arc to the middle of the text */
#define SEGMENTS 32  /* of the arc */

static double angle_between(double ax, double ay, double bx, double by)
{
    return atan2(ax * by - ay * bx, ax * bx + ay * by);
}

/* Drawing */

typedef struct {
    double x, y;       /* of the second end */
    double radius;     /* m; 0 where a way has no length */
    double from, span; /* rad */
} Arc;

static Arc arc_of(const TinkerInstance *instance)
{
    const TinkerEnd *end = instance->end;
    const double ax = end[0].x - end[1].x, ay = end[0].y - end[1].y, bx = end[2].x - end[1].x, by = end[2].y - end[1].y;
    const double shorter = fmin(tinker_length(ax, ay), tinker_length(bx, by));
    const double radius = fmin(RADIUS * tinker_instance_symbol_size(instance), SHARE * shorter);
    const Arc arc = {end[1].x, end[1].y, radius, atan2(ay, ax), angle_between(ax, ay, bx, by)};
    return arc;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    static const double degrees = 57.29577951308232;
    const Arc arc = arc_of(instance);
    const TinkerEnd *end = instance->end;
    double points[2 * (SEGMENTS + 1)];
    char text[48];
    for (int k = 0; k <= SEGMENTS; k++) {
        const double angle = arc.from + arc.span * k / SEGMENTS;
        points[2 * k] = arc.x + arc.radius * cos(angle);
        points[2 * k + 1] = arc.y + arc.radius * sin(angle);
    }
    style->line(style, cairo, TINKER_COLOUR_MOTION, end[1].x, end[1].y, end[0].x, end[0].y);
    style->line(style, cairo, TINKER_COLOUR_MOTION, end[1].x, end[1].y, end[2].x, end[2].y);
    if (arc.radius > 0.0) {
        const double middle = arc.from + 0.5 * arc.span, off = arc.radius + TEXT * style->symbol_size;
        if (TINKER_HAS(TinkerStyle, style, polyline)) {
            style->polyline(style, cairo, TINKER_COLOUR_MOTION, points, SEGMENTS + 1);
        }
        snprintf(text, sizeof text, "%.1f\302\260", degrees * arc.span);
        style->text(style, cairo, TINKER_COLOUR_TEXT, arc.x + off * cos(middle), arc.y + off * sin(middle), text);
    }
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const Arc arc = arc_of(instance);
    tinker_connector_bounds(instance, style, box);
    tinker_bounds_add(box, arc.x, arc.y, arc.radius + (TEXT + 1.0) * style->symbol_size + tinker_drawing_margin(style));
}

/* Editing */

/* The ways, the arc and the text. */
static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const Arc arc = arc_of(instance);
    const double symbol = tinker_instance_symbol_size(instance), middle = arc.from + 0.5 * arc.span;
    const double dx = x - arc.x, dy = y - arc.y, off = arc.radius + TEXT * symbol;
    const double along = angle_between(cos(middle), sin(middle), dx, dy);
    const int32_t part = tinker_connector_hit(instance, x, y, reach);
    if (part != TINKER_PART_NONE) return part;
    if (fabs(along) <= 0.5 * fabs(arc.span) && fabs(tinker_length(dx, dy) - arc.radius) <= reach) {
        return TINKER_PART_WHOLE;
    }
    return tinker_length(dx - off * cos(middle), dy - off * sin(middle)) <= HALF * symbol + reach ? TINKER_PART_WHOLE
                                                                                                  : TINKER_PART_NONE;
}

/* Graphs */

static double rate_of(double x, double y, double vx, double vy)
{
    const double squared = x * x + y * y;
    return squared > 0.0 ? (x * vy - y * vx) / squared : 0.0;
}

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *end = &input->ends[3 * i];
        const double ax = end[0].x - end[1].x, ay = end[0].y - end[1].y, bx = end[2].x - end[1].x,
                     by = end[2].y - end[1].y;
        if (quantity == QUANTITY_ANGLE) {
            result[i] = angle_between(ax, ay, bx, by);
        } else {
            result[i] = rate_of(bx, by, end[2].vx - end[1].vx, end[2].vy - end[1].vy) -
                        rate_of(ax, ay, end[0].vx - end[1].vx, end[0].vy - end[1].vy);
        }
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "angle", "Angle",
                    "At the second end, from the first way counter-clockwise to the third's", TINKER_DIMENSION_ANGLE),
    TINKER_QUANTITY(TINKER_RECORDED, "angle rate", "Angle Rate", "How fast the angle grows",
                    TINKER_DIMENSION_ANGULAR_FREQUENCY),
};

static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"angle", "deg", "deg"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("angle-mark", "Angle Mark", TINKER_MEASURE),
     .summary = "The angle at its second end between the ways to the others", .least_ends = 3, .most_ends = 3,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.angle-mark", "Angle Mark", "0.1.0", "MIT", blocks)

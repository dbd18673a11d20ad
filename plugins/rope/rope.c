/* Rope: from its first end over small ideal wheels, the ends between, to its last; its path is at most its length.
 *
 *     g = L - l <= 0, with L the path from end to end (tinker_path_row)
 *
 * The row holds in one direction only: slack, the rope does nothing; where its path has become as long as it is, it
 * takes what parts its ends at once and without rebound. Its multiplier is minus the tension, the same in all strands.
 * Wheels have no size but on the picture. */
#include <tinker/sdk.h>

enum { COLUMN_LENGTH };

enum { QUANTITY_TENSION, QUANTITY_SLACK };

/* Where a rope pulls something into a wheel, the strand between them would swing round ever faster: as small as wheels
 * are, the motion ends there, at this share of the rope's length, unless the rope is slack. */
#define LEAST_STRAND 1e-3
#define NEARLY_TAUT  0.999

#define VISIBLY_SLACK 1e-3 /* of its length: shorter by this it is drawn slack */
#define WHEEL         0.5  /* of the symbol size: radius of a wheel; less where it would reach */
#define WHEEL_SHARE   0.3  /* beyond this share of a strand */
#define ARC_STEPS     12

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t first = tinker_first_end(batch, i), count = tinker_first_end(batch, i + 1) - first;
        const double shortest = tinker_path_row(&ends[first], count, &g[i], &jacobian[2 * first], &drift[i]);
        if (count > 2 && shortest < LEAST_STRAND * length[i] && g[i] > NEARLY_TAUT * length[i]) {
            return tinker_retry(batch, i, "what it pulls has run into a wheel (or two of its ends are in one place)");
        }
        g[i] -= length[i];
    }
    return TINKER_OK;
}

/* The rope's length is what errors are measured against. */
static TinkerStatus lengths(TinkerBatch *batch, double *result)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = length[i];
    }
    return TINKER_OK;
}

/* Ropes without wheels are distances. */
static TinkerStatus distance(TinkerBatch *batch, double *result)
{
    for (int32_t i = 0; i < batch->count; i++) {
        if (tinker_first_end(batch, i + 1) - tinker_first_end(batch, i) != 2) return TINKER_RETRY_SMALLER;
    }
    return lengths(batch, result);
}

static TinkerStatus check(TinkerBatch *batch)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        if (!(length[i] > 0.0)) return tinker_fail(batch, i, "length is 0; a rope needs a length above 0");
    }
    return TINKER_OK;
}

/* Drawing */

static double strand(const TinkerInstance *instance, int32_t k)
{
    return tinker_length(instance->end[k].x - instance->end[k - 1].x, instance->end[k].y - instance->end[k - 1].y);
}

/* How much longer each strand is than its way, where the rope is slack; else 1. Where the slack lies nothing tells: all
 * strands are drawn with their share of it. */
static double hangs_by(const TinkerInstance *instance)
{
    const double length = instance->columns[COLUMN_LENGTH];
    double path = 0.0;
    for (int32_t k = 1; k < instance->ends; k++) {
        path += strand(instance, k);
    }
    return length - path > VISIBLY_SLACK * length && path > 0.0 ? length / path : 1.0;
}

/* How far to the left of its way the rope passes the centre of a wheel: where it turns left, at the wheel's right. 0 at
 * its first and last end. */
static double offset(const TinkerInstance *instance, int32_t k, double symbol_size)
{
    if (k == 0 || k == instance->ends - 1) return 0.0;
    const TinkerEnd *a = &instance->end[k - 1], *b = a + 1, *c = b + 1;
    const double turn = (b->x - a->x) * (c->y - b->y) - (b->y - a->y) * (c->x - b->x);
    const double radius = fmin(WHEEL * symbol_size, WHEEL_SHARE * fmin(strand(instance, k), strand(instance, k + 1)));
    return turn >= 0.0 ? -radius : radius;
}

/* The strand that ends at end k: a common tangent of the wheels at both of its ends. With its direction u, n to the
 * left of u and offsets p, q: it goes from a + p n to b + q n, where (b - a) . n = p - q, so that u is turned from b -
 * a by asin((q - p) / |b - a|). Writes both points, and n. */
static void tangent(const TinkerInstance *instance, int32_t k, double symbol_size, double line[4], double normal[2])
{
    const TinkerEnd *a = &instance->end[k - 1], *b = a + 1;
    const double p = offset(instance, k - 1, symbol_size), q = offset(instance, k, symbol_size);
    const double length = strand(instance, k);
    const double ratio = length > 0.0 ? (q - p) / length : 0.0; /* at most 2 WHEEL_SHARE */
    const double angle = atan2(b->y - a->y, b->x - a->x) + asin(fmax(-1.0, fmin(1.0, ratio)));
    normal[0] = -sin(angle);
    normal[1] = cos(angle);
    line[0] = a->x + p * normal[0];
    line[1] = a->y + p * normal[1];
    line[2] = b->x + q * normal[0];
    line[3] = b->y + q * normal[1];
}

/* The part of the rope that lies on wheel k, from the strand with normal `from` to that with normal `to`. */
static void draw_wrapped(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style, int32_t colour,
                         int32_t k, const double from[2], const double to[2])
{
    const TinkerEnd *wheel = &instance->end[k];
    const double side = offset(instance, k, style->symbol_size);
    const double start = atan2(from[1], from[0]);
    double turn = atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    if (side < 0.0 && turn < 0.0) turn += 2.0 * TINKER_PI;
    if (side > 0.0 && turn > 0.0) turn -= 2.0 * TINKER_PI;
    double x = wheel->x + side * from[0], y = wheel->y + side * from[1];
    for (int step = 1; step <= ARC_STEPS; step++) {
        const double angle = start + turn * step / ARC_STEPS;
        const double next_x = wheel->x + side * cos(angle), next_y = wheel->y + side * sin(angle);
        style->line(style, cairo, colour, x, y, next_x, next_y);
        x = next_x;
        y = next_y;
    }
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double factor = hangs_by(instance);
    const int32_t colour = factor > 1.0 ? TINKER_COLOUR_COMPRESSED : TINKER_COLOUR_CONNECTOR;
    double line[4], normal[2], before[2] = {0.0, 0.0}, points[2 * TINKER_HANGING_POINTS];
    for (int32_t k = 1; k < instance->ends - 1; k++) {
        style->circle(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_BODY_EDGE, instance->end[k].x,
                      instance->end[k].y, fabs(offset(instance, k, style->symbol_size)));
    }
    for (int32_t k = 1; k < instance->ends; k++) {
        tangent(instance, k, style->symbol_size, line, normal);
        if (k > 1) draw_wrapped(instance, cairo, style, colour, k - 1, before, normal);
        if (factor > 1.0) {
            const double length = factor * tinker_length(line[2] - line[0], line[3] - line[1]);
            tinker_hanging_line(line[0], line[1], line[2], line[3], length, points);
            style->polyline(style, cairo, colour, points, TINKER_HANGING_POINTS);
        } else {
            style->line(style, cairo, colour, line[0], line[1], line[2], line[3]);
        }
        before[0] = normal[0];
        before[1] = normal[1];
    }
    tinker_ends_draw_marks(instance, cairo, style);
}

/* A slack one where it hangs, between the centres of its wheels. */
static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double factor = hangs_by(instance);
    if (!(factor > 1.0)) return tinker_connector_hit(instance, x, y, reach);
    const int32_t part = tinker_ends_hit(instance, x, y, reach);
    for (int32_t k = 1; part == TINKER_PART_NONE && k < instance->ends; k++) {
        const TinkerEnd *a = &instance->end[k - 1], *b = a + 1;
        double points[2 * TINKER_HANGING_POINTS];
        tinker_hanging_line(a->x, a->y, b->x, b->y, factor * strand(instance, k), points);
        if (tinker_polyline_is_near(points, TINKER_HANGING_POINTS, x, y, reach)) return TINKER_PART_WHOLE;
    }
    return part;
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const double factor = hangs_by(instance), margin = tinker_drawing_margin(style);
    tinker_connector_bounds(instance, style, box);
    for (int32_t k = 1; k < instance->ends && factor > 1.0; k++) {
        const TinkerEnd *a = &instance->end[k - 1], *b = a + 1;
        const double depth = tinker_hanging_depth(a->y, b->y, factor * strand(instance, k));
        tinker_bounds_add(box, b->x, fmin(a->y, b->y) - depth, margin);
    }
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    if (quantity == QUANTITY_TENSION && input->multipliers == NULL) {
        return tinker_fail(batch, 0, "the rope's force is not known yet");
    }
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = quantity == QUANTITY_TENSION ? 0.0 - input->multipliers[i] : length[i];
        if (quantity == QUANTITY_TENSION) continue;
        for (int32_t k = tinker_first_end(batch, i) + 1; k < tinker_first_end(batch, i + 1); k++) {
            const TinkerPoint *a = &input->ends[k - 1], *b = a + 1;
            result[i] -= tinker_length(b->x - a->x, b->y - a->y);
        }
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Rope", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.1, 10.0), .symbol = "l", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_STRUCTURAL, .description = "Longest path from its first end over the wheels to its last"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g", "L - l", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force along the rope, the same in all strands",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "slack", "Slack", "How much longer the rope is than its path", TINKER_DIMENSION_LENGTH),
};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 1,
                                            .unilateral = 1,
                                            .rows_at = rows_at,
                                            .scale = lengths,
                                            .check = check,
                                            .distance = distance};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"length", "m", "ft"}, {"tension", "N", "lbf"}, {"slack", "m", "ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("rope", "Rope", TINKER_ROPE),
     .summary = "Over any number of small wheels, which it does not turn; it pulls and never pushes", .least_ends = 2,
     .most_ends = -1, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.rope", "Rope", "0.1.0", "MIT", blocks)

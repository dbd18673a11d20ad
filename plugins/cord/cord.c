/* Cord: wound on the disc about its first end, which it leaves along a tangent to its second end; it pulls and never
 * pushes. With d from the first end to the second, R the radius, theta the angle of what the first end is on, and
 * sigma = +1 where it leaves on the left as seen from the disc towards the second end, -1 on the right:
 *
 *     s = (d^2 - R^2)^1/2                 the free part,
 *     phi = angle of d + sigma acos(R/|d|)  where on the rim it leaves,
 *     g = s - sigma R [(phi - phi(0)) - (theta - theta(0))] - l <= 0.
 *
 * With n = (cos phi, sin phi) and e = sigma (sin phi, -cos phi) along the free part:
 *
 *     dg/dx_2 = e = -dg/dx_1,   dg/dtheta = sigma R,   drift = (n . (v_2 - v_1))^2 / s.
 *
 * The multiplier is minus the tension. The angle of d is taken within half a turn of where it was placed: the host
 * places what is wound anew on the way. Where it does not, as for a look at one state, a cord that pulls and would be
 * stretched by more than half of the rim has been unwound by whole turns beyond that. */
#include <tinker/sdk.h>

enum { COLUMN_SIDE, COLUMN_RADIUS, COLUMN_LENGTH };

enum { QUANTITY_TENSION, QUANTITY_FREE };

#define LEAST_FREE  1e-3 /* of the radius: a taut cord's load has come up to the disc */
#define NEARLY_TAUT 0.05 /* of the radius */
#define RINGS       24   /* lines of the ring that is wound on the disc */

#define VISIBLY_SLACK 1e-3 /* of its length: longer by this than its way it is drawn slack */

/* Physics */

/* The free part of a cord. */
typedef struct {
    double free;   /* m; 0 where the second end is inside */
    double angle;  /* where it leaves the rim */
    double out[2]; /* n */
    double way[2]; /* e, towards the second end */
} Tangent;

static double side_of(double side)
{
    return side == 0.0 ? 1.0 : -1.0;
}

static Tangent tangent_of(double dx, double dy, double radius, double sigma)
{
    const double distance = tinker_length(dx, dy);
    Tangent t = {0.0, 0.0, {0.0, 0.0}, {0.0, 0.0}};
    if (!(distance > radius)) return t;
    t.free = sqrt((distance - radius) * (distance + radius));
    t.angle = atan2(dy, dx) + sigma * atan2(t.free, radius);
    /* n = (R d + sigma s d turned left) / |d|^2 */
    t.out[0] = (radius * dx - sigma * t.free * dy) / (distance * distance);
    t.out[1] = (radius * dy + sigma * t.free * dx) / (distance * distance);
    t.way[0] = sigma * t.out[1];
    t.way[1] = -sigma * t.out[0];
    return t;
}

/* Within half a turn of 0. */
static double within_half_turn(double angle)
{
    return angle - 2.0 * TINKER_PI * floor(angle / (2.0 * TINKER_PI) + 0.5);
}

/* How far round the disc the direction of the second end has gone since t = 0. */
static double gone_round(const TinkerPoint *now, const TinkerPoint *placed)
{
    const double angle = atan2(now[1].y - now[0].y, now[1].x - now[0].x);
    return within_half_turn(angle - atan2(placed[1].y - placed[0].y, placed[1].x - placed[0].x));
}

/* g of a cord, if its second end has gone round by so much. */
static double stretch(const Tangent *now, const Tangent *placed, double round, double turned, double radius,
                      double sigma, double length)
{
    const double leaves = round + sigma * (atan2(now->free, radius) - atan2(placed->free, radius));
    return now->free - sigma * radius * (leaves - turned) - length;
}

/* What whole turns that have been unwound take off a cord that would be stretched by more than half of the rim. */
static double unwound(double g, double rim)
{
    return g > 0.5 * rim ? rim * floor(g / rim + 0.5) : 0.0;
}

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *side = tinker_column(batch, COLUMN_SIDE), *radius = tinker_column(batch, COLUMN_RADIUS);
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1, *placed = &batch->placed[2 * i];
        const double sigma = side_of(side[i]), round = gone_round(a, placed);
        const double turned = batch->poses[2 * i].angle - batch->placed_poses[2 * i].angle;
        const Tangent t = tangent_of(b->x - a->x, b->y - a->y, radius[i], sigma);
        const Tangent was = tangent_of(placed[1].x - placed[0].x, placed[1].y - placed[0].y, radius[i], sigma);
        if (!(t.free > 0.0)) {
            return tinker_retry(batch, i, "its second end is inside the disc that it is wound on");
        }
        const double within = stretch(&t, &was, round, turned, radius[i], sigma, length[i]);
        const double turns = unwound(within, 2.0 * TINKER_PI * radius[i]);
        g[i] = within - turns;
        const int taut = g[i] > -NEARLY_TAUT * radius[i];
        if (taut && t.free < LEAST_FREE * radius[i]) {
            return tinker_retry(batch, i, "what it pulls has come up to the disc that it is wound on");
        }
        const double across = t.out[0] * (b->vx - a->vx) + t.out[1] * (b->vy - a->vy);
        drift[i] = across * across / t.free;
        for (int k = 0; k < 2; k++) {
            jacobian[4 * i + k] = -t.way[k];
            jacobian[4 * i + 2 + k] = t.way[k];
        }
        batch->angular[2 * i] = sigma * radius[i];
        batch->angular[2 * i + 1] = 0.0;
    }
    return TINKER_OK;
}

static TinkerStatus scale(TinkerBatch *batch, double *result)
{
    const double *radius = tinker_column(batch, COLUMN_RADIUS), *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = fmax(radius[i], length[i]);
    }
    return TINKER_OK;
}

static TinkerStatus check(TinkerBatch *batch)
{
    const double *radius = tinker_column(batch, COLUMN_RADIUS), *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        if (!(radius[i] > 0.0)) return tinker_fail(batch, i, "radius is 0; a cord is wound on a radius above 0");
        if (!(length[i] > 0.0)) {
            return tinker_fail(batch, i,
                               "its free part has no length; its second end must lie outside the disc at t = 0");
        }
    }
    return TINKER_OK;
}

/* Drawing: a ring on the disc, and the free part along its tangent, or hanging where it is slack */

static Tangent drawn(const TinkerInstance *instance)
{
    const TinkerEnd *a = &instance->end[0], *b = a + 1;
    return tangent_of(b->x - a->x, b->y - a->y, instance->columns[COLUMN_RADIUS],
                      side_of(instance->columns[COLUMN_SIDE]));
}

/* Where it leaves the disc. */
static void touch_of(const TinkerInstance *instance, const Tangent *t, double touch[2])
{
    const double radius = t->free > 0.0 ? instance->columns[COLUMN_RADIUS] : 0.0;
    touch[0] = instance->end[0].x + radius * t->out[0];
    touch[1] = instance->end[0].y + radius * t->out[1];
}

/* Not where its length is not known. */
static int is_slack(const TinkerInstance *instance, const Tangent *t)
{
    const double length = instance->columns[COLUMN_LENGTH];
    return length - t->free > VISIBLY_SLACK * length;
}

/* The line of its free part; how many points it has. */
static int32_t free_line(const TinkerInstance *instance, const Tangent *t, double points[2 * TINKER_HANGING_POINTS])
{
    const TinkerEnd *b = &instance->end[1];
    double touch[2];
    touch_of(instance, t, touch);
    if (is_slack(instance, t)) {
        tinker_hanging_line(touch[0], touch[1], b->x, b->y, instance->columns[COLUMN_LENGTH], points);
        return TINKER_HANGING_POINTS;
    }
    points[0] = touch[0];
    points[1] = touch[1];
    points[2] = b->x;
    points[3] = b->y;
    return 2;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0];
    const double radius = instance->columns[COLUMN_RADIUS], sigma = side_of(instance->columns[COLUMN_SIDE]);
    const Tangent t = drawn(instance);
    const int32_t colour = is_slack(instance, &t) ? TINKER_COLOUR_COMPRESSED : TINKER_COLOUR_CONNECTOR;
    double points[2 * RINGS + 2], free[2 * TINKER_HANGING_POINTS];
    for (int k = 0; k <= RINGS; k++) { /* the wound part begins where the free one ends */
        const double angle = t.angle + sigma * 2.0 * TINKER_PI * k / RINGS;
        points[2 * k] = a->x + radius * cos(angle);
        points[2 * k + 1] = a->y + radius * sin(angle);
    }
    style->polyline(style, cairo, TINKER_COLOUR_CONNECTOR, points, RINGS + 1);
    if (free_line(instance, &t, free) == 2)
        style->line(style, cairo, colour, free[0], free[1], free[2], free[3]);
    else
        style->polyline(style, cairo, colour, free, TINKER_HANGING_POINTS);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const double margin = tinker_drawing_margin(style);
    const Tangent t = drawn(instance);
    double touch[2];
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->end[0].x, instance->end[0].y, instance->columns[COLUMN_RADIUS] + margin);
    tinker_bounds_add(box, instance->end[1].x, instance->end[1].y, margin);
    if (is_slack(instance, &t)) {
        touch_of(instance, &t, touch);
        const double depth = tinker_hanging_depth(touch[1], instance->end[1].y, instance->columns[COLUMN_LENGTH]);
        tinker_bounds_add(box, instance->end[1].x, fmin(touch[1], instance->end[1].y) - depth, margin);
    }
}

/* Editing: the handle where it leaves the disc sets the radius; one where it would on the other side takes it there */

#define PART_OTHER_SIDE (TINKER_PART_HANDLE + 1)

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const Tangent t = drawn(instance);
    const double out = tinker_length(x - instance->end[0].x, y - instance->end[0].y);
    const int32_t part = tinker_ends_hit(instance, x, y, reach);
    if (part != TINKER_PART_NONE) return part;
    if (fabs(out - instance->columns[COLUMN_RADIUS]) <= reach) return TINKER_PART_WHOLE;
    double line[2 * TINKER_HANGING_POINTS];
    const int32_t points = free_line(instance, &t, line);
    return tinker_polyline_is_near(line, points, x, y, reach) ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* Where it leaves the disc, or would on its other side. */
static int32_t place_of(const TinkerInstance *instance, int32_t part, double place[2])
{
    const TinkerEnd *a = &instance->end[0], *b = a + 1;
    const double sigma = side_of(instance->columns[COLUMN_SIDE]);
    const Tangent t = tangent_of(b->x - a->x, b->y - a->y, instance->columns[COLUMN_RADIUS],
                                 part == PART_OTHER_SIDE ? -sigma : sigma);
    touch_of(instance, &t, place);
    return t.free > 0.0;
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    int32_t count = 0;
    for (int32_t part = TINKER_PART_HANDLE; part <= PART_OTHER_SIDE; part++) {
        double at[2];
        if (place_of(instance, part, at)) count = tinker_handle_add(list, room, count, part, at[0], at[1]);
    }
    return count;
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    const TinkerEnd *a = &instance->end[0], *b = a + 1;
    if (part == TINKER_PART_HANDLE) {
        editor->set(editor, COLUMN_RADIUS, tinker_length(x - a->x, y - a->y));
    } else if (part == PART_OTHER_SIDE) { /* it is never on the side that the cord is on */
        const double left = (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
        const double sigma = side_of(instance->columns[COLUMN_SIDE]);
        if (sigma * left < 0.0) editor->set(editor, COLUMN_SIDE, sigma > 0.0 ? 1.0 : 0.0);
    } else {
        tinker_ends_move_absolute(instance, part, x, y, editor);
    }
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    double at[2];
    if (part == TINKER_PART_HANDLE || part == PART_OTHER_SIDE) {
        place_of(instance, part, at);
        move_absolute(instance, part, at[0] + dx, at[1] + dy, editor);
    } else {
        tinker_ends_move(instance, part, dx, dy, editor);
    }
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *radius = tinker_column(batch, COLUMN_RADIUS);
    if (quantity == QUANTITY_TENSION && input->multipliers == NULL) {
        return tinker_fail(batch, 0, "the cord's force is not known yet");
    }
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &input->ends[2 * i], *b = a + 1;
        result[i] = quantity == QUANTITY_TENSION ? 0.0 - input->multipliers[i]
                                                 : tangent_of(b->x - a->x, b->y - a->y, radius[i], 1.0).free;
    }
    return TINKER_OK;
}

/* Tables */

static const char *const sides[] = {"left", "right"};

static const TinkerPropertyType properties[] = {
    {TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_CHOICE, "side", "Side towards Load", "Cord", TINKER_DIMENSION_NONE),
     .symbol = "f", .choice_count = 2, .choices = sides, .variability = TINKER_STRUCTURAL,
     .description =
         "On which side it leaves the disc, as one looks from the disc's centre to its second end, the load: where "
         "that "
         "hangs below, left is on the right of the picture. The handle on the other side of the disc changes it"},
    {TINKER_REAL_PROPERTY("radius", "Radius", "Cord", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.1, 2.0), .symbol = "R", .meaning = TINKER_MEANING_RADIUS,
     .variability = TINKER_STRUCTURAL, .description = "Of what it is wound on, about its first end"},
    {TINKER_REAL_PROPERTY("length", "Length", "Cord", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.1, 10.0), .symbol = "l", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_STRUCTURAL, .description = "Of its free part at t = 0; longer than the way, it is slack"},
};

/* sigma is 1 - 2 f. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("s", "sqrt((x2 - x1)^2 + (y2 - y1)^2 - R^2)", "free part", TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("s0", "sqrt(max((x2_start - x1_start)^2 + (y2_start - y1_start)^2 - R^2, 0))",
                    "free part at the start", TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("φ",
                    "mod(atan2(y2 - y1, x2 - x1) - atan2(y2_start - y1_start, x2_start - x1_start) + pi, 2*pi) - pi",
                    "how far round the disc its second end has gone", TINKER_DIMENSION_ANGLE),
    TINKER_EQUATION("w", "s - R*(atan2(s, R) - atan2(s0, R)) - (1 - 2*f)*R*(φ - (theta1 - theta1_start)) - l",
                    "how far it is stretched, but for whole turns", TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("c", "2*pi*R", "once round the disc", TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("g", "w - if(w > c/2, c*floor(w/c + 0.5), 0)", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force along the cord", TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "free length", "Free Length", "From the disc to its second end", TINKER_DIMENSION_LENGTH),
};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 1,
                                            .unilateral = 1,
                                            .rows_at = rows_at,
                                            .scale = scale,
                                            .check = check,
                                            .angles = 1};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"radius", "m", "ft"}, {"length", "m", "ft"}, {"tension", "N", "lbf"}, {"free length", "m", "ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("cord", "Cord", TINKER_ROPE),
     .summary = "Wound on a disc that it turns, one on either side of a heavy pulley; it pulls and never pushes",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.cord", "Cord", "0.1.0", "MIT", blocks)

/* Straight guide: keeps a body on the line through two points, which may themselves be bodies or moving supports.
 *
 * The ends are the body x and the points a and b. With d = b - a, L = |d|, n = d / L, m = n turned left by 90 deg, u =
 * x - a, s = n . u (how far along) and w = m . d' / L (how fast the line turns), n' = w m and m' = -w n:
 *
 *     g  = m . u                                     the distance from the line, positive to its left
 *     g' = m . u' - w s,   so that   dg/dx = m,   dg/db = -(s / L) m,   dg/da = -(1 - s / L) m
 *     drift = -2 w (n . u') + 2 w s (n . d') / L - w^2 g
 *
 * The multiplier is the force on the body along m, to the left of the direction from a to b. */
#include <tinker/sdk.h>

enum { QUANTITY_FORCE, QUANTITY_ALONG, QUANTITY_OFF };

enum { BODY, FROM, TO, ENDS };

#define COINCIDE "its two points coincide (a line needs two that are apart)"

/* The line of one guide. L is 0 where its points coincide: then there is no line. */
typedef struct {
    double length, nx, ny, ux, uy;
} Line;

static Line line_of(const TinkerPoint *end)
{
    const double dx = end[TO].x - end[FROM].x, dy = end[TO].y - end[FROM].y;
    Line line = {.length = tinker_length(dx, dy), .ux = end[BODY].x - end[FROM].x, .uy = end[BODY].y - end[FROM].y};
    line.nx = dx / line.length;
    line.ny = dy / line.length;
    return line;
}

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *end = &ends[ENDS * i];
        const Line line = line_of(end);
        if (line.length == 0.0) return tinker_retry(batch, i, COINCIDE);
        const double mx = -line.ny, my = line.nx, share = (line.nx * line.ux + line.ny * line.uy) / line.length;
        const double ux = end[BODY].vx - end[FROM].vx, uy = end[BODY].vy - end[FROM].vy;
        const double dx = end[TO].vx - end[FROM].vx, dy = end[TO].vy - end[FROM].vy;
        const double turning = (mx * dx + my * dy) / line.length;
        double *j = &jacobian[2 * ENDS * i];
        j[2 * BODY] = mx;
        j[2 * BODY + 1] = my;
        j[2 * FROM] = (share - 1.0) * mx;
        j[2 * FROM + 1] = (share - 1.0) * my;
        j[2 * TO] = -share * mx;
        j[2 * TO + 1] = -share * my;
        g[i] = mx * line.ux + my * line.uy;
        drift[i] = 2.0 * turning * (share * (line.nx * dx + line.ny * dy) - (line.nx * ux + line.ny * uy)) -
                   turning * (turning * g[i]);
    }
    return TINKER_OK;
}

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};

/* Drawing and editing: the line from point to point, and on to the body where that lies beyond */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *end = instance->end;
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, end[FROM].x, end[FROM].y, end[TO].x, end[TO].y);
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, end[BODY].x, end[BODY].y, end[FROM].x, end[FROM].y);
    tinker_ends_draw_marks(instance, cairo, style);
}

static const TinkerRender render = {
    .struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw, .bounds = tinker_connector_bounds};
static const TinkerEdit edit = {.struct_size = sizeof(TinkerEdit),
                                .hit = tinker_connector_hit,
                                .move = tinker_ends_move,
                                .move_absolute = tinker_ends_move_absolute};

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (quantity == QUANTITY_FORCE && input->multipliers == NULL)
        return tinker_fail(batch, 0, "the guide's force is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const Line line = line_of(&input->ends[ENDS * i]);
        if (line.length == 0.0) return tinker_fail(batch, i, COINCIDE);
        switch (quantity) {
        case QUANTITY_FORCE:
            result[i] = input->multipliers[i];
            break;
        case QUANTITY_ALONG:
            result[i] = line.nx * line.ux + line.ny * line.uy;
            break;
        default:
            result[i] = line.nx * line.uy - line.ny * line.ux;
            break;
        }
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* Declaration */

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("d", "sqrt((x3 - x2)^2 + (y3 - y2)^2)", "distance of the two points", TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("g", "((x3 - x2)*(y1 - y2) - (y3 - y2)*(x1 - x2))/d", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "force", "Force", "On the body, to the left of the line from point to point",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "along", "Place", "Of the body along the line, from the first point on",
                    TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(0, "error", "Error", "How far the body is off the line", TINKER_DIMENSION_LENGTH),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("straight-guide", "Straight Guide", TINKER_CONNECTOR),
     .summary = "Keeps its first end on the line through the two others", .least_ends = ENDS, .most_ends = ENDS,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.straight-guide", "Straight Guide", "1.0.0", "MIT", blocks)

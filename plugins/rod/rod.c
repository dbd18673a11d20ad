/* Rod: keeps a fixed distance between its ends, g = L - l = 0.
 *
 * With d = x_b - x_a, L = |d|, n = d / L and w = v_b - v_a:
 *     J = dg/dx = (-n, n),  dL/dt = n . w,
 *     d2L/dt2 = n . (a_b - a_a) + (|w|^2 - (n . w)^2) / L = n . (a_b - a_a) + (n x w)^2 / L,
 * so the drift is (n x w)^2 / L. The cross product is what is left of the difference before it, without its
 * cancellation where the ends move along the rod. */
#include <tinker/sdk.h>

enum { COLUMN_LENGTH };

enum { QUANTITY_TENSION, QUANTITY_LENGTH_ERROR };

/* Physics */

/* Where the ends coincide the rod has no direction, and can exert nothing; its g says how wrong that is. */
static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, distance = tinker_length(dx, dy);
        const double nx = distance == 0.0 ? 0.0 : dx / distance, ny = distance == 0.0 ? 0.0 : dy / distance;
        const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        g[i] = distance - length[i];
        jacobian[4 * i] = -nx;
        jacobian[4 * i + 1] = -ny;
        jacobian[4 * i + 2] = nx;
        jacobian[4 * i + 3] = ny;
        drift[i] = distance == 0.0 ? 0.0 : across / distance * across;
    }
    return TINKER_OK;
}

/* The rod's length is what it keeps, and what its errors are measured against. */
static TinkerStatus lengths(TinkerBatch *batch, double *result)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = length[i];
    }
    return TINKER_OK;
}

static TinkerStatus check(TinkerBatch *batch)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        if (!(length[i] > 0.0)) return tinker_fail(batch, i, "length is 0; a rod needs a length above 0");
    }
    return TINKER_OK;
}

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    style->bar(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* Graphs */

/* The multiplier of g = L - l pushes the ends apart where it is positive: the tension is minus it. */
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    if (quantity == QUANTITY_TENSION) {
        if (input->multipliers == NULL) return tinker_fail(batch, 0, "the rod's force is not known yet");
        for (int32_t i = 0; i < batch->count; i++) {
            result[i] = -input->multipliers[i];
        }
        return TINKER_OK;
    }
    tinker_end_distances(batch->count, input->ends, result);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] -= length[i];
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Rod Properties", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.1, 10.0), .symbol = "l", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_STRUCTURAL, .description = "Distance that it keeps between its ends"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g", "L - l", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "length error", "Length Error", "How far its length is off", TINKER_DIMENSION_LENGTH),
};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 1,
                                            .rows_at = rows_at,
                                            .scale = lengths,
                                            .check = check,
                                            .distance = lengths};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"length", "m", "ft"}, {"tension", "N", "lbf"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("rod", "Rod", TINKER_CONNECTOR), .summary = "Keeps a fixed distance between its ends",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.rod", "Rod", "0.1.0", "MIT", blocks)

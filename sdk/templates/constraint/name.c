/* @title@: a straight, frictionless rail that a body cannot leave. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. A vector takes two. */
enum { COLUMN_POINT, COLUMN_ANGLE = COLUMN_POINT + 2 };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* With the rail's normal n = (-sin a, cos a) and a point p of it: g(x) = n . (x - p) = 0.
 *
 * The host finds the force that keeps g at 0: lambda * J with J = dg/dx = n. `drift` is what d2g/dt2 has besides J
 * times the acceleration; of a straight rail that is nothing. Places of ends are relative to batch->origin. */
static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *px = tinker_column(batch, COLUMN_POINT), *py = tinker_column(batch, COLUMN_POINT + 1);
    const double *angle = tinker_column(batch, COLUMN_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        double along[2];
        tinker_direction(angle[i], along);
        jacobian[2 * i] = -along[1];
        jacobian[2 * i + 1] = along[0];
        g[i] = along[0] * (ends[i].y + batch->origin[1] - py[i]) - along[1] * (ends[i].x + batch->origin[0] - px[i]);
        drift[i] = 0.0;
    }
    return TINKER_OK;
}

/* What errors of g are measured against. A rail has no length of its own, and one end no distance to another: 1 m. */
static TinkerStatus scale(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < batch->count; i++) {
        length[i] = 1.0;
    }
    return TINKER_OK;
}

/* `.unilateral = 1` would say g <= 0: a wall that holds on one side only. */
static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .scale = scale};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};

/* Drawing ---------------------------------------------------------------------------------------------------------- */

/* A piece of the rail to both sides of the body; `symbol_size` is the length that suits symbols in this scene. */
static TinkerArrow piece_of(const TinkerInstance *instance, double symbol_size)
{
    double along[2];
    tinker_direction(instance->columns[COLUMN_ANGLE], along);
    const double reach = 6.0 * symbol_size;
    return tinker_arrow_from(instance->end[0].x - reach * along[0], instance->end[0].y - reach * along[1], along,
                             2.0 * reach);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerArrow piece = piece_of(instance, style->symbol_size);
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, piece.x1, piece.y1, piece.x2, piece.y2);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const TinkerArrow piece = piece_of(instance, style->symbol_size);
    tinker_arrow_bounds(&piece, tinker_drawing_margin(style), box);
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw, .bounds = bounds};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

/* The multiplier of a row is its force, as g has the unit of a length and J is a unit vector. */
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the rail's force is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = input->multipliers[i];
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_VECTOR_PROPERTY("point", "Point", "@title@", "X", "Y", TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .symbol = "p", .variability = TINKER_STRUCTURAL,
     .description = "A point of the rail"},
    {TINKER_REAL_PROPERTY("angle", "Angle", "@title@", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "a", .variability = TINKER_STRUCTURAL,
     .description = "Direction of the rail, counter-clockwise from the right"},
};

/* The law once more, as data: from it come the equations of a scene, and a check of the code above. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g", "cos(a)*(y - py) - sin(a)*(x - px)", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "force", "Force", "Force of the rail on the body, positive to the rail's left",
                    TINKER_DIMENSION_FORCE),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_CONNECTOR), .summary = "Keeps a body on a straight line", .least_ends = 1,
     .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

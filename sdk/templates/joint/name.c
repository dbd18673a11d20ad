/* @title@: a belt that does not slip: two wheels turn the same way, by a ratio. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. */
enum { COLUMN_RATIO };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* g = (theta_2 - its start) - r (theta_1 - its start) = 0, in rad: `poses` tell how what each end is on is turned.
 *
 * The host finds what keeps g at 0. Of a row of angles that is a torque: lambda dg/dtheta_k on what end k is on. Places
 * do not matter here, so their columns of the Jacobian are cleared; a joint that holds places fills them in, too.
 * `drift` is what d2g/dt2 has besides J times the accelerations: nothing. */
static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *ratio = tinker_column(batch, COLUMN_RATIO);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPose *now = &batch->poses[2 * i], *start = &batch->placed_poses[2 * i];
        if (!batch->has_angle[2 * i] || !batch->has_angle[2 * i + 1]) {
            return tinker_fail(batch, i, "one of its ends is on something that does not turn (attach it to a disc)");
        }
        tinker_row_clear(jacobian + 4 * i, batch->angular + 2 * i, 2);
        g[i] = (now[1].angle - start[1].angle) - ratio[i] * (now[0].angle - start[0].angle);
        batch->angular[2 * i] = -ratio[i];
        batch->angular[2 * i + 1] = 1.0;
        drift[i] = 0.0;
    }
    return TINKER_OK;
}

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 1,
                                            .rows_at = rows_at,
                                            .scale = tinker_scale_of_angles,
                                            .angles = 1};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};

/* Drawing ---------------------------------------------------------------------------------------------------------- */

/* From wheel to wheel, with the marks of the ends. */
static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    for (int32_t k = 0; k < 2; k++) {
        tinker_bounds_add(box, instance->end[k].x, instance->end[k].y, tinker_drawing_margin(style));
    }
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw, .bounds = bounds};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the belt's torque is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = input->multipliers[i];
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("ratio", "Ratio", "@title@", TINKER_DIMENSION_NONE), TINKER_POSITIVE(0, 0.1, 10.0),
     .default_value = {1.0}, .symbol = "r", .variability = TINKER_STRUCTURAL,
     .description = "How often the second wheel turns while the first one turns once"},
};

/* The law once more, as data: from it come the equations of a scene, and a check of the code above. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g", "theta2 - theta2_start - r*(theta1 - theta1_start)", NULL, TINKER_DIMENSION_ANGLE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "torque", "Torque", "On what its second end is on", TINKER_DIMENSION_TORQUE),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_JOINT), .summary = "Turns two wheels the same way, by a ratio",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

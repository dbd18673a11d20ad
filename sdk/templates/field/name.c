/* @title@: resting water or air that resists all bodies by the square of their speed. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. */
enum { COLUMN_DRAG };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* On each body F = -c |v| v. */
static void add_force(double c, const TinkerPoint *point, double force[2])
{
    const double factor = c * tinker_length(point->vx, point->vy);
    force[0] -= factor * point->vx;
    force[1] -= factor * point->vy;
}

/* A field sees all bodies, and writes the force on those of the range: the sum over all fields of this type. Masses are
 * in bodies->masses. */
static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    const double *c = tinker_column(batch, COLUMN_DRAG);
    for (int32_t k = 0; k < bodies->range; k++) {
        result[2 * k] = result[2 * k + 1] = 0.0;
        for (int32_t i = 0; i < batch->count; i++) {
            add_force(c[i], &bodies->points[bodies->first + k], &result[2 * k]);
        }
    }
    return TINKER_OK;
}

/* A field that comes from a potential offers `.energy` as well. The force on a body here depends on that body alone;
 * where it depends on others, `.couples_bodies` is 1. */
static const TinkerField field = {.struct_size = sizeof(TinkerField), .force = force};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .field = &field};

/* Drawing ---------------------------------------------------------------------------------------------------------- */

/* A field has no place: the host shows it at a corner of the canvas, at instance->x, instance->y. */
static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    style->circle(style, cairo, -1, TINKER_COLOUR_FIELD, instance->x, instance->y, style->symbol_size);
    style->text(style, cairo, TINKER_COLOUR_FIELD, instance->x, instance->y, "c");
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->x, instance->y, style->symbol_size + tinker_drawing_margin(style));
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 3, .draw = draw, .bounds = bounds};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *c = tinker_column(batch, COLUMN_DRAG);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = 0.0;
        for (int32_t k = 0; k < input->body_count; k++) {
            const TinkerPoint *point = &input->bodies[k];
            double on_body[2] = {0.0, 0.0};
            add_force(c[i], point, on_body);
            result[i] += on_body[0] * point->vx + on_body[1] * point->vy;
        }
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("drag", "Drag", "@title@", TINKER_DIMENSION_QUADRATIC_DRAG), TINKER_NOT_NEGATIVE(0, 5.0),
     .default_value = {0.1}, .symbol = "c", .variability = TINKER_TUNABLE,
     .description = "Force per square of the speed"},
};

/* The law once more, as data: from it come the equations of a scene, and a check of the code above. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("force_x", "-c*sqrt(vx^2 + vy^2)*vx", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "-c*sqrt(vx^2 + vy^2)*vy", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "power", "Power", "Power given to all bodies", TINKER_DIMENSION_POWER),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_FIELD), .summary = "Resists all bodies by the square of their speed",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

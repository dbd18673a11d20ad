/* @title@: a rubber band that gets harder the further it is drawn out, and is slack below its rest length. */
#include <tinker/sdk.h>

/* A property's place among the columns: their order is that of the declaration below. */
enum { COLUMN_STIFFNESS, COLUMN_HARDENING, COLUMN_REST_LENGTH };

/* The law ---------------------------------------------------------------------------------------------------------- */

/* With e = L - L0, how far it is drawn out:
 *     T = k e + k3 e^3 where e > 0, else 0, and the energy that it stores is k e^2 / 2 + k3 e^4 / 4. */

static double extension(const TinkerBatch *batch, int32_t i, double length)
{
    return fmax(length - tinker_column(batch, COLUMN_REST_LENGTH)[i], 0.0);
}

/* The tension (N) of each block of the range; positive where it pulls the ends together. `rate` is dL/dt, for laws that
 * resist it. */
static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *k3 = tinker_column(batch, COLUMN_HARDENING);
    for (int32_t i = 0; i < batch->count; i++) {
        const double e = extension(batch, i, length[i]);
        result[i] = (k[i] + k3[i] * e * e) * e;
    }
    return TINKER_OK;
}

/* Optional: the tension's derivatives by length and rate. Without them the host takes differences. */
static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *k3 = tinker_column(batch, COLUMN_HARDENING);
    for (int32_t i = 0; i < batch->count; i++) {
        const double e = extension(batch, i, length[i]);
        by_length[i] = e > 0.0 ? k[i] + 3.0 * k3[i] * e * e : 0.0;
        by_rate[i] = 0.0;
    }
    return TINKER_OK;
}

/* Optional: the energy (J) whose derivative by the length is the tension. Without it all work counts as lost. */
static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *k3 = tinker_column(batch, COLUMN_HARDENING);
    for (int32_t i = 0; i < batch->count; i++) {
        const double e = extension(batch, i, length[i]);
        stored[i] = (0.5 * k[i] + 0.25 * k3[i] * e * e) * e * e;
    }
    return TINKER_OK;
}

static const TinkerLineLaw line_law = {
    .struct_size = sizeof(TinkerLineLaw), .tension = tension, .derivatives = derivatives, .energy = energy};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &line_law};

/* Drawing and editing ---------------------------------------------------------------------------------------------- */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const int taut = tinker_length(b->x - a->x, b->y - a->y) > instance->columns[COLUMN_REST_LENGTH];
    style->line(style, cairo, taut ? TINKER_COLOUR_STRETCHED : TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
    tinker_ends_draw_marks(instance, cairo, style);
}

static const TinkerRender render = {
    .struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw, .bounds = tinker_connector_bounds};
static const TinkerEdit edit = {.struct_size = sizeof(TinkerEdit),
                                .hit = tinker_connector_hit,
                                .move = tinker_ends_move,
                                .move_absolute = tinker_ends_move_absolute};

/* Graphs: one function for all quantities, in the order of their declaration --------------------------------------- */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    tinker_end_distances(batch->count, input->ends, result); /* quantity 0 is the length */
    return quantity == 0 ? TINKER_OK : tension(batch, result, NULL, result);
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* The declaration: from it the host makes the property panel, units, checks, the file format and the help ---------- */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "@title@", TINKER_DIMENSION_STIFFNESS),
     TINKER_NOT_NEGATIVE(0, 200.0), .default_value = {20.0}, .symbol = "k", .variability = TINKER_TUNABLE,
     .description = "Force per length that it is drawn out, while that is little"},
    {TINKER_REAL_PROPERTY("hardening", "Hardening", "@title@", {1, -2, -2, 0}), TINKER_NOT_NEGATIVE(0, 200.0),
     .default_value = {10.0}, .symbol = "k3", .variability = TINKER_TUNABLE,
     .description = "Force per cube of the length that it is drawn out"},
    {TINKER_REAL_PROPERTY("rest_length", "Rest Length", "@title@", TINKER_DIMENSION_LENGTH),
     TINKER_NOT_NEGATIVE(TINKER_DEFAULT_AS_PLACED, 10.0), .symbol = "L0", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_STRUCTURAL, .description = "Length below which it is slack"},
};

/* The law once more, as data: from it come the equations of a scene, and a check of the code above. */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("e", "max(L - L0, 0)", "how far it is drawn out", TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("tension", "k*e + k3*e^3", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("potential", "k*e^2/2 + k3*e^4/4", NULL, TINKER_DIMENSION_ENERGY),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "length", "Length", "Distance between its ends", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
                    TINKER_DIMENSION_FORCE),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("@name@", "@title@", TINKER_CONNECTOR), .summary = "Pulls like a rubber band, harder and harder",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", blocks)

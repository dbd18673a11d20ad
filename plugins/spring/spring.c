/* Spring: a linear line law, T = k (L - L0), with the energy k (L - L0)^2 / 2. */
#include <tinker/sdk.h>

enum { COLUMN_STIFFNESS, COLUMN_REST_LENGTH, COLUMN_LENGTH };

enum { QUANTITY_LENGTH, QUANTITY_EXTENSION, QUANTITY_TENSION, QUANTITY_ENERGY };

/* A spring counts as at rest within this part of its rest length. */
#define REST_TOLERANCE 1e-6

/* Physics */

TINKER_LINE_LOOP(tension_loop, k, L0, k *(L - L0))
TINKER_LINE_LOOP(energy_loop, k, L0, 0.5 * k * (L - L0) * (L - L0))

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    tension_loop(batch->count, tinker_column(batch, COLUMN_STIFFNESS), tinker_column(batch, COLUMN_REST_LENGTH), length,
                 rate, result);
    return TINKER_OK;
}

static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS);
    for (int32_t i = 0; i < batch->count; i++) {
        by_length[i] = stiffness[i];
        by_rate[i] = 0.0;
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    energy_loop(batch->count, tinker_column(batch, COLUMN_STIFFNESS), tinker_column(batch, COLUMN_REST_LENGTH), length,
                length, stored);
    return TINKER_OK;
}

static TinkerStatus linear(TinkerBatch *batch, double *stiffness, double *damping, double *length, double *at_length)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        stiffness[i] = k[i];
        damping[i] = 0.0;
        length[i] = rest[i];
        at_length[i] = 0.0;
    }
    return TINKER_OK;
}

/* Drawing */

static int32_t colour_of_state(double length, double rest_length)
{
    const double extension = length - rest_length, slack = REST_TOLERANCE * rest_length;
    if (extension < -slack) return TINKER_COLOUR_COMPRESSED;
    return extension > slack ? TINKER_COLOUR_STRETCHED : TINKER_COLOUR_CONNECTOR;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double rest_length = instance->columns[COLUMN_REST_LENGTH];
    const int32_t colour = colour_of_state(tinker_length(b->x - a->x, b->y - a->y), rest_length);
    style->coil(style, cairo, colour, a->x, a->y, b->x, b->y, rest_length);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_LENGTH);
    tinker_end_distances(batch->count, input->ends, result);
    for (int32_t i = 0; i < batch->count; i++) {
        const double extension = result[i] - rest[i];
        switch (quantity) {
        case QUANTITY_LENGTH:
            break;
        case QUANTITY_EXTENSION:
            result[i] = extension;
            break;
        case QUANTITY_TENSION:
            result[i] = k[i] * extension;
            break;
        default:
            result[i] = 0.5 * k[i] * extension * extension;
            break;
        }
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "K", "Spring Properties", TINKER_DIMENSION_STIFFNESS),
     TINKER_NOT_NEGATIVE(0, 200.0), .default_value = {25.0}, .symbol = "k", .variability = TINKER_TUNABLE,
     .description = "Stiffness: force per extension"},
    {TINKER_REAL_PROPERTY("rest_length", "Undeformed Length", "Spring Properties", TINKER_DIMENSION_LENGTH),
     TINKER_NOT_NEGATIVE(TINKER_DEFAULT_AS_PLACED, 10.0), .symbol = "L0", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_TUNABLE, .description = "Length at which it exerts no force"},
    {TINKER_REAL_PROPERTY("length", "Length", "Spring Properties", TINKER_DIMENSION_LENGTH),
     .flags = TINKER_READ_ONLY | TINKER_DERIVED, .symbol = "L", .variability = TINKER_TUNABLE,
     .description = "Distance between its ends now"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("tension", "k*(L - L0)", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("potential", "k*(L - L0)^2/2", NULL, TINKER_DIMENSION_ENERGY),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "length", "Length", "Distance between the ends", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(0, "extension", "Extension", "Length beyond the undeformed length", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "energy", "Stored Energy", "k (L - L0)^2 / 2", TINKER_DIMENSION_ENERGY),
};

static const TinkerLineLaw line_law = {.struct_size = sizeof(TinkerLineLaw),
                                       .tension = tension,
                                       .derivatives = derivatives,
                                       .energy = energy,
                                       .linear = linear};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &line_law};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"stiffness", "N/m", "lbf/ft"}, {"energy", "J", "lbf*ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("spring", "Spring", TINKER_CONNECTOR),
     .summary = "Pulls or pushes its ends towards its undeformed length", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.spring", "Spring", "0.1.0", "MIT", blocks)

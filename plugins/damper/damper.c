/* Damper: a linear line law, T = c dL/dt. It stores nothing; where its ends coincide it exerts nothing. */
#include <tinker/sdk.h>

enum { COLUMN_DAMPING };

enum { QUANTITY_RATE, QUANTITY_TENSION, QUANTITY_POWER };

/* Physics */

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    const double *damping = tinker_column(batch, COLUMN_DAMPING);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = damping[i] * rate[i];
    }
    return TINKER_OK;
}

static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    const double *damping = tinker_column(batch, COLUMN_DAMPING);
    for (int32_t i = 0; i < batch->count; i++) {
        by_length[i] = 0.0;
        by_rate[i] = damping[i];
    }
    return TINKER_OK;
}

static TinkerStatus linear(TinkerBatch *batch, double *stiffness, double *damping, double *length, double *at_length)
{
    const double *c = tinker_column(batch, COLUMN_DAMPING);
    for (int32_t i = 0; i < batch->count; i++) {
        stiffness[i] = 0.0;
        damping[i] = c[i];
        length[i] = at_length[i] = 0.0;
    }
    return TINKER_OK;
}

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    style->dashpot(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *damping = tinker_column(batch, COLUMN_DAMPING);
    tinker_end_rates(batch->count, input->ends, result);
    for (int32_t i = 0; i < batch->count; i++) {
        const double rate = result[i];
        switch (quantity) {
        case QUANTITY_RATE:
            break;
        case QUANTITY_TENSION:
            result[i] = damping[i] * rate;
            break;
        default:
            result[i] = damping[i] * rate * rate;
            break;
        }
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("damping", "C", "Damper Properties", TINKER_DIMENSION_DAMPING), TINKER_NOT_NEGATIVE(0, 20.0),
     .default_value = {1.0}, .symbol = "c", .variability = TINKER_TUNABLE,
     .description = "Damping: force per rate at which it gets longer"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("tension", "c*rate", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "rate", "Rate", "How fast it gets longer", TINKER_DIMENSION_VELOCITY),
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "dissipated power", "Dissipated Power", "Power turned into heat", TINKER_DIMENSION_POWER),
};

static const TinkerLineLaw line_law = {
    .struct_size = sizeof(TinkerLineLaw), .tension = tension, .derivatives = derivatives, .linear = linear};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &line_law};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"damping", "N*s/m", "lbf*s/ft"},
                                                {"dissipated power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("damper", "Damper", TINKER_CONNECTOR),
     .summary = "Resists the rate at which its ends move apart or together", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.damper", "Damper", "0.1.0", "MIT", blocks)

/* Torque: turns what its first end is on by a function of time, counter-clockwise; with a second end the reaction acts
 * on what that is on. It stores nothing: its power is booked as given by motors. */
#include <tinker/sdk.h>

enum {
    COLUMN_WAVEFORM, /* value, first and second derivative */
    COLUMN_AMPLITUDE = COLUMN_WAVEFORM + 3,
    COLUMN_FREQUENCY,
    COLUMN_PHASE,
};

enum { QUANTITY_TORQUE, QUANTITY_POWER };

#define RADIUS 2.0 /* of the arrow, in symbols */

/* Physics */

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *value = tinker_column(batch, COLUMN_WAVEFORM);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t first = tinker_first_end(batch, i), past = tinker_first_end(batch, i + 1);
        for (int32_t e = first; e < past; e++) {
            result[2 * e] = result[2 * e + 1] = 0.0;
            batch->angular[e] = e == first ? value[i] : -value[i];
        }
    }
    return TINKER_OK;
}

static TinkerStatus torsion(TinkerBatch *batch, double *stiffness, double *damping, double *rest,
                            int32_t *waveform_column)
{
    for (int32_t i = 0; i < batch->count; i++) {
        stiffness[i] = damping[i] = rest[i] = 0.0;
        waveform_column[i] = COLUMN_WAVEFORM;
    }
    return TINKER_OK;
}

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double value = instance->columns[COLUMN_WAVEFORM];
    for (int32_t k = 0; k < instance->ends; k++) {
        tinker_draw_turn_arrow(style, cairo, TINKER_COLOUR_FORCE, instance->end[k].x, instance->end[k].y,
                               RADIUS * style->symbol_size, k == 0 ? value : -value);
    }
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_round_bounds(instance, style, (RADIUS + 1.0) * style->symbol_size, box);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double radius = RADIUS * tinker_instance_symbol_size(instance);
    int32_t part = tinker_ends_hit(instance, x, y, reach);
    for (int32_t k = 0; k < instance->ends && part == TINKER_PART_NONE; k++) {
        const double out = tinker_length(x - instance->end[k].x, y - instance->end[k].y);
        if (fabs(out - radius) <= reach) part = TINKER_PART_WHOLE;
    }
    return part;
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *value = tinker_column(batch, COLUMN_WAVEFORM);
    if (input->poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t first = tinker_first_end(batch, i), count = tinker_first_end(batch, i + 1) - first;
        const double rate = input->poses[first].rate - (count > 1 ? input->poses[first + 1].rate : 0.0);
        result[i] = quantity == QUANTITY_TORQUE ? value[i] : value[i] * rate;
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_WAVEFORM_IN_PANEL(-1, "waveform", "Type", "Torque", "cosine", TINKER_DIMENSION_TORQUE), .symbol = "M",
     .variability = TINKER_TUNABLE, .description = "How the torque depends on time"},
    {TINKER_REAL_PROPERTY("amplitude", "Amplitude", "Torque", TINKER_DIMENSION_TORQUE),
     TINKER_ANY_VALUE(0, -20.0, 20.0), .default_value = {1.0}, .symbol = "A", .variability = TINKER_TUNABLE,
     .description = "Greatest torque"},
    {TINKER_REAL_PROPERTY("frequency", "Frequency", "Torque", TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0.0, 20.0), .symbol = "ω", .variability = TINKER_TUNABLE, .description = "Angular frequency"},
    {TINKER_REAL_PROPERTY("phase", "Phase", "Torque", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "φ", .variability = TINKER_TUNABLE,
     .description = "Phase at t = 0"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("torque", "M", NULL, TINKER_DIMENSION_TORQUE),
    TINKER_EQUATION("torque1", "M", NULL, TINKER_DIMENSION_TORQUE),
    TINKER_EQUATION("torque2", "-M", NULL, TINKER_DIMENSION_TORQUE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "torque", "Torque", "On what its first end is on, counter-clockwise", TINKER_DIMENSION_TORQUE),
    TINKER_QUANTITY(0, "power", "Power", "Power given to what it turns", TINKER_DIMENSION_POWER),
};

static const TinkerForceElement force_element = {
    .struct_size = sizeof(TinkerForceElement), .angles = 1, .force = force, .torsion = torsion};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"waveform", "N*m", "lbf*ft"},   {"amplitude", "N*m", "lbf*ft"},
                                                {"frequency", "rad/s", "rad/s"}, {"phase", "deg", "deg"},
                                                {"torque", "N*m", "lbf*ft"},     {"power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("torque", "Torque", TINKER_FORCE), .summary = "Turns a body by a torque that varies with time",
     .least_ends = 1, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.torque", "Torque", "0.1.0", "MIT", blocks)

/* Drive: prescribes how what its first end is on turns against what the second is on,
 *
 *     g = (theta_1 - theta_2) - (theta_1 - theta_2 as placed) - speed t - (u(t) - u(0)),   drift = -u''.
 *
 * g is in rad and its multiplier a torque. What it gives is booked as given by motors. */
#include <tinker/sdk.h>

enum {
    COLUMN_SPEED,
    COLUMN_WAVEFORM, /* value, first and second derivative */
    COLUMN_AMPLITUDE = COLUMN_WAVEFORM + 3,
    COLUMN_FREQUENCY,
    COLUMN_PHASE,
};

enum { QUANTITY_TORQUE, QUANTITY_POWER, QUANTITY_ANGLE, QUANTITY_RATE };

#define RADIUS 1.4 /* of what is drawn, in symbols */

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *speed = tinker_column(batch, COLUMN_SPEED), *w = tinker_column(batch, COLUMN_WAVEFORM);
    const double *bend = tinker_column(batch, COLUMN_WAVEFORM + 2), *w0 = batch->placed_columns[COLUMN_WAVEFORM];
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPose *pose = &batch->poses[2 * i], *placed = &batch->placed_poses[2 * i];
        if (!batch->has_angle[2 * i] && !batch->has_angle[2 * i + 1])
            return tinker_fail(batch, i,
                               "neither of its ends is on something that turns (attach one to a bar, a disc, a box)");
        tinker_row_clear(jacobian + 4 * i, batch->angular + 2 * i, 2);
        g[i] = (pose[0].angle - pose[1].angle) - (placed[0].angle - placed[1].angle) - speed[i] * batch->time -
               (w[i] - w0[i]);
        batch->angular[2 * i] = 1.0;
        batch->angular[2 * i + 1] = -1.0;
        drift[i] = -bend[i];
    }
    return TINKER_OK;
}

static TinkerStatus prescribed_rate(TinkerBatch *batch, const TinkerPoint *ends, double *rate)
{
    const double *speed = tinker_column(batch, COLUMN_SPEED), *slope = tinker_column(batch, COLUMN_WAVEFORM + 1);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        rate[i] = -speed[i] - slope[i];
    }
    return TINKER_OK;
}

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double radius = RADIUS * style->symbol_size;
    const double rate = instance->columns[COLUMN_SPEED] + instance->columns[COLUMN_WAVEFORM + 1];
    const TinkerEnd *at = tinker_turn_end(instance);
    tinker_turn_draw_ends(instance, cairo, style, radius);
    style->circle(style, cairo, -1, TINKER_COLOUR_MOTION, at->x, at->y, 0.5 * radius);
    tinker_draw_turn_arrow(style, cairo, TINKER_COLOUR_MOTION, at->x, at->y, radius,
                           instance->end[0].attached == TINKER_ATTACHED_TO_SUPPORT ? -rate
                                                                                   : rate); /* as what moves turns */
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_turn_bounds(instance, style, (RADIUS + 1.0) * style->symbol_size, box);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    return tinker_turn_hit(instance, (RADIUS + 0.5) * tinker_instance_symbol_size(instance), x, y, reach);
}

/* Graphs */

static TinkerStatus turned(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (input->poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPose *first = &input->poses[2 * i], *second = &input->poses[2 * i + 1];
        result[i] = quantity == QUANTITY_ANGLE ? first->angle - second->angle : first->rate - second->rate;
    }
    return TINKER_OK;
}

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *speed = tinker_column(batch, COLUMN_SPEED), *slope = tinker_column(batch, COLUMN_WAVEFORM + 1);
    if (quantity == QUANTITY_ANGLE || quantity == QUANTITY_RATE) return turned(batch, input, quantity, result);
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the drive's torque is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const double torque = input->multipliers[i];
        result[i] = quantity == QUANTITY_TORQUE ? torque : torque * (speed[i] + slope[i]);
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("speed", "Speed", "Drive", TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, -20.0, 20.0), .default_value = {1.0}, .symbol = "n", .variability = TINKER_STRUCTURAL,
     .description = "How fast it turns, counter-clockwise, beside the waveform"},
    {TINKER_WAVEFORM_IN_PANEL(-1, "waveform", "Type", "Drive", "none", TINKER_DIMENSION_ANGLE), .symbol = "u",
     .variability = TINKER_STRUCTURAL,
     .description = "Angle that is added, as a function of time, less its value at t = 0"},
    {TINKER_REAL_PROPERTY("amplitude", "Amplitude", "Drive", TINKER_DIMENSION_ANGLE), TINKER_ANY_VALUE(0, -20.0, 20.0),
     .default_value = {0.0}, .symbol = "A", .variability = TINKER_STRUCTURAL,
     .description = "Greatest angle that is added"},
    {TINKER_REAL_PROPERTY("frequency", "Frequency", "Drive", TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0.0, 20.0), .symbol = "ω", .variability = TINKER_STRUCTURAL,
     .description = "Angular frequency"},
    {TINKER_REAL_PROPERTY("phase", "Phase", "Drive", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "φ", .variability = TINKER_STRUCTURAL,
     .description = "Phase at t = 0"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g", "theta1 - theta2 - (theta1_start - theta2_start) - n*t - (u - u_start)", NULL,
                    TINKER_DIMENSION_ANGLE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "torque", "Torque", "On what its first end is on", TINKER_DIMENSION_TORQUE),
    TINKER_QUANTITY(0, "power", "Power", "Power that it gives", TINKER_DIMENSION_POWER),
    TINKER_QUANTITY(0, "angle", "Angle", "From what its second end is on to what its first is on, counting turns",
                    TINKER_DIMENSION_ANGLE),
    TINKER_QUANTITY(0, "angle rate", "Angle Rate", "How fast the angle grows", TINKER_DIMENSION_ANGULAR_FREQUENCY),
};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 1,
                                            .rows_at = rows_at,
                                            .prescribed_rate = prescribed_rate,
                                            .scale = tinker_scale_of_angles,
                                            .angles = 1};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"speed", "rad/s", "rad/s"},     {"waveform", "deg", "deg"},  {"amplitude", "deg", "deg"}, {"phase", "deg", "deg"},
    {"frequency", "rad/s", "rad/s"}, {"torque", "N*m", "lbf*ft"}, {"power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("drive", "Drive", TINKER_JOINT), .summary = "Prescribes how a body turns against another",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.drive", "Drive", "0.1.0", "MIT", blocks)

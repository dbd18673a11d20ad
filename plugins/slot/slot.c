/* Slot: keeps its second end on a line through the first one, which turns with what that is on (track.h). */
#include <tinker/sdk.h>

enum { ROWS = 1 };

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        tinker_track_row(batch, i, ROWS, ends, g, jacobian, drift);
    }
    return TINKER_OK;
}

/* Drawing: the track, and a bolt that runs in it */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *b = &instance->end[1];
    tinker_track_draw(instance, cairo, style);
    style->circle(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_CONNECTOR, b->x, b->y,
                  0.9 * TINKER_TRACK_WIDTH * style->symbol_size);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the slot's force is not known yet");
    return tinker_track_values(batch, input, ROWS, quantity, result);
}

/* Tables */

static const TinkerPropertyType properties[] = {TINKER_TRACK_PROPERTIES};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g", "(y2 - y1)*cos(α + theta1) - (x2 - x1)*sin(α + theta1)", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {TINKER_JOINT_QUANTITIES};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = ROWS, .joint = 2, .rows_at = rows_at, .angles = 1};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_track_bounds};
static const TinkerEdit edit = TINKER_TRACK_EDIT;
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"angle", "deg", "deg"}, TINKER_JOINT_UNITS};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("slot", "Slot", TINKER_JOINT), .summary = "Keeps a point on a line that turns with a body",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .flags = TINKER_HAS_SPAN, .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.slot", "Slot", "0.1.0", "MIT", blocks)

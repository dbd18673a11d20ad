/* Hand: pulls one body to a place by a spring and a damper, and the place may be moved while the scene runs. The spring
 * stores nothing that the books would have to keep when the hand moves on: what it gives is booked as given by motors.
 */
#include <tinker/sdk.h>

enum { COLUMN_PLACE, COLUMN_PULLS = COLUMN_PLACE + 2, COLUMN_STIFFNESS, COLUMN_DAMPING };

enum { QUANTITY_FORCE, QUANTITY_POWER };

#define DOT   0.35 /* symbol sizes: the radius of the hand itself, */
#define ARROW 5.0  /* and the length of the arrow */

/* Physics */

/* Of the end's place in the world, where `origin` is what it is counted from. */
static void force_on(TinkerBatch *batch, int32_t i, const TinkerPoint *end, const double origin[2], double force[2])
{
    const double *pulls = tinker_column(batch, COLUMN_PULLS), *k = tinker_column(batch, COLUMN_STIFFNESS),
                 *c = tinker_column(batch, COLUMN_DAMPING);
    const double *px = tinker_column(batch, COLUMN_PLACE), *py = tinker_column(batch, COLUMN_PLACE + 1);
    force[0] = pulls[i] * (k[i] * (px[i] - origin[0] - end->x) - c[i] * end->vx);
    force[1] = pulls[i] * (k[i] * (py[i] - origin[1] - end->y) - c[i] * end->vy);
}

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    for (int32_t i = 0; i < batch->count; i++)
        force_on(batch, i, &ends[i], batch->origin, &result[2 * i]);
    return TINKER_OK;
}

/* Drawing */

static void find_hand(const TinkerInstance *instance, double *x, double *y)
{
    *x = instance->columns[COLUMN_PLACE];
    *y = instance->columns[COLUMN_PLACE + 1];
}

/* Where it would pull to, while it does not. */
static TinkerArrow arrow_of(const TinkerInstance *instance)
{
    const TinkerEnd *end = &instance->end[0];
    double x, y;
    find_hand(instance, &x, &y);
    const double length = tinker_length(x - end->x, y - end->y);
    const double direction[2] = {length > 0.0 ? (x - end->x) / length : 0.0,
                                 length > 0.0 ? (y - end->y) / length : 1.0};
    return tinker_arrow_from(end->x, end->y, direction, ARROW * tinker_instance_symbol_size(instance));
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *end = &instance->end[0];
    double x, y;
    find_hand(instance, &x, &y);
    if (instance->columns[COLUMN_PULLS] != 0.0) {
        style->coil(style, cairo, TINKER_COLOUR_FORCE, end->x, end->y, x, y, tinker_length(x - end->x, y - end->y));
    } else {
        const TinkerArrow arrow = arrow_of(instance);
        style->line(style, cairo, TINKER_COLOUR_FORCE, end->x, end->y, x, y);
        style->arrow(style, cairo, TINKER_COLOUR_FORCE, arrow.x1, arrow.y1, arrow.x2, arrow.y2);
    }
    style->circle(style, cairo, TINKER_COLOUR_FORCE, -1, x, y, DOT * style->symbol_size);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const double margin = tinker_drawing_margin(style);
    double x, y;
    find_hand(instance, &x, &y);
    const TinkerArrow arrow = arrow_of(instance);
    tinker_arrow_bounds(&arrow, margin, box);
    tinker_bounds_add(box, x, y, DOT * style->symbol_size + margin);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const TinkerEnd *end = &instance->end[0];
    const int32_t part = tinker_ends_hit(instance, x, y, reach);
    double hand_x, hand_y;
    find_hand(instance, &hand_x, &hand_y);
    if (part != TINKER_PART_NONE) return part;
    const double half = DOT * tinker_instance_symbol_size(instance);
    const int near = tinker_segment_distance(x, y, end->x, end->y, hand_x, hand_y) <= reach + half;
    const TinkerArrow arrow = arrow_of(instance);
    if (instance->columns[COLUMN_PULLS] == 0.0 && tinker_arrow_is_hit(&arrow, x, y, reach)) return TINKER_PART_WHOLE;
    return near ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* What is taken by the hand is pulled. */
static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    if (part != TINKER_PART_HANDLE) {
        tinker_ends_move_absolute(instance, part, x, y, editor);
        return;
    }
    editor->set(editor, COLUMN_PLACE, x);
    editor->set(editor, COLUMN_PLACE + 1, y);
    editor->set(editor, COLUMN_PULLS, 1.0);
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    double x, y;
    find_hand(instance, &x, &y);
    if (part == TINKER_PART_HANDLE) {
        move_absolute(instance, part, x + dx, y + dy, editor);
    } else {
        tinker_ends_move(instance, part, dx, dy, editor);
    }
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    double x, y;
    find_hand(instance, &x, &y);
    return tinker_handle_add(list, room, 0, TINKER_PART_HANDLE, x, y);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    static const double world[2] = {0.0, 0.0};
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *end = &input->ends[i];
        double pull[2];
        force_on(batch, i, end, world, pull);
        result[i] =
            quantity == QUANTITY_FORCE ? tinker_length(pull[0], pull[1]) : pull[0] * end->vx + pull[1] * end->vy;
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_VECTOR_PROPERTY("place", "Place", "Hand", "X", "Y", TINKER_DIMENSION_LENGTH), .symbol = "p",
     .variability = TINKER_TUNABLE, TINKER_ANY_VALUE(0, -10.0, 10.0), .default_value = {0.0, 1.0},
     .description = "Where it pulls to"},
    {TINKER_SWITCH_PROPERTY("pulls", "Pulls", "Hand"), .symbol = "h", .variability = TINKER_TUNABLE,
     .description = "Whether it holds the body; it does once it is dragged"},
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "Hand", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 200.0),
     .default_value = {25.0}, .symbol = "k", .variability = TINKER_TUNABLE, .description = "Force by distance"},
    {TINKER_REAL_PROPERTY("damping", "Damping", "Hand", TINKER_DIMENSION_DAMPING), TINKER_NOT_NEGATIVE(0, 20.0),
     .default_value = {2.0}, .symbol = "c", .variability = TINKER_TUNABLE, .description = "Force against the velocity"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("force_x", "h*(k*(px - x) - c*vx)", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "h*(k*(py - y) - c*vy)", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "force", "Force", "How strongly it pulls", TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "power", "Power", "Power given to the body", TINKER_DIMENSION_POWER),
};

static const TinkerForceElement force_element = {.struct_size = sizeof(TinkerForceElement), .force = force};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("hand", "Hand", TINKER_FORCE), .summary = "Pulls one body to where it is dragged, while it runs",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.hand", "Hand", "0.1.0", "MIT", blocks)

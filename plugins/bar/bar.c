/* Bar: a rigid body along its own x axis, of a length and a width, which turns.
 *
 * Where its inertia is left out it is that of a slender bar about its centre, m l^2 / 12, whatever its width. */
#include <tinker/sdk.h>

enum { COLUMN_LENGTH = TINKER_BODY_COLUMNS, COLUMN_WIDTH };

static const TinkerBoxColumns box_columns = TINKER_BODY_BOX(COLUMN_LENGTH, COLUMN_WIDTH);

/* Physics */

static TinkerStatus as_shaped(TinkerBatch *batch, int32_t property, double *values)
{
    const double *mass = tinker_column(batch, TINKER_BODY_MASS), *length = tinker_column(batch, COLUMN_LENGTH);
    (void)property; /* the inertia is the only one */
    for (int32_t i = 0; i < batch->count; i++) {
        values[i] = mass[i] * length[i] * length[i] / 12.0;
    }
    return TINKER_OK;
}

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double length = instance->columns[COLUMN_LENGTH], width = instance->columns[COLUMN_WIDTH];
    double x1, y1, x2, y2;
    if (width > 0.0) {
        style->box(style, cairo, TINKER_COLOUR_BODY, TINKER_COLOUR_BODY_EDGE, instance->x, instance->y, length, width,
                   instance->orientation);
        return;
    }
    tinker_box_to_world(instance, -length / 2.0, 0.0, &x1, &y1);
    tinker_box_to_world(instance, length / 2.0, 0.0, &x2, &y2);
    style->line(style, cairo, TINKER_COLOUR_BODY_EDGE, x1, y1, x2, y2);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_box_bounds(instance, &box_columns, tinker_drawing_margin(style), box);
}

/* Editing */

/* By its ends: the one that is dragged goes along with the hand and the other one stays, as of a line that is drawn.
 * The handle of the width is on the upper side, off the middle, where the whole is dragged. */
enum { HANDLE_END = TINKER_HANDLE_SIZE, HANDLE_START = TINKER_HANDLE_LOCAL_ORIGIN + 1, HANDLE_WIDTH };

#define WIDTH_AT    0.25 /* of the length, from the middle */
#define LEAST_WIDTH 0.01 /* of the length: what the handle leaves is at least so wide, or a line */

static const TinkerEdit edit;

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    return tinker_box_hit(instance, &box_columns, x, y, reach);
}

static int32_t handles_of(const TinkerInstance *instance, TinkerHandle *handles, int32_t room)
{
    const double half = instance->columns[COLUMN_LENGTH] / 2.0;
    double x, y;
    int32_t count = 0;
    for (int side = -1; side <= 1; side += 2) {
        tinker_box_to_world(instance, side * half, 0.0, &x, &y);
        count = tinker_handle_add(handles, room, count, side < 0 ? HANDLE_START : HANDLE_END, x, y);
    }
    tinker_box_to_world(instance, 2.0 * WIDTH_AT * half, instance->columns[COLUMN_WIDTH] / 2.0, &x, &y);
    count = tinker_handle_add(handles, room, count, HANDLE_WIDTH, x, y);
    return tinker_turned_handles(instance, &box_columns, half, instance->columns[COLUMN_WIDTH] / 2.0, handles, room,
                                 count);
}

/* Near the line in its middle it has none: a hand does not hit 0, and so thin a bar looks as one without. */
static void set_width(const TinkerInstance *instance, double x, double y, const TinkerEditor *editor)
{
    double own_x, own_y;
    tinker_box_to_own(instance, x, y, &own_x, &own_y);
    const double width = 2.0 * fabs(own_y);
    editor->set(editor, COLUMN_WIDTH, width > LEAST_WIDTH * instance->columns[COLUMN_LENGTH] ? width : 0.0);
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    const double side = part == HANDLE_END ? 1.0 : -1.0;
    double x0, y0; /* of the end that stays */
    if (part == HANDLE_WIDTH) {
        set_width(instance, x, y, editor);
        return;
    }
    if (part != HANDLE_END && part != HANDLE_START) {
        tinker_turned_move_absolute(instance, &box_columns, part, x, y, editor);
        return;
    }
    tinker_box_to_world(instance, -side * instance->columns[COLUMN_LENGTH] / 2.0, 0.0, &x0, &y0);
    const double length = tinker_length(x - x0, y - y0);
    if (!(length > 0.0)) return; /* it would point nowhere */
    tinker_turned_move_absolute(instance, &box_columns, TINKER_PART_WHOLE, (x + x0) / 2.0, (y + y0) / 2.0, editor);
    tinker_set_angle(editor, TINKER_BODY_ORIENTATION, side * (x - x0), side * (y - y0));
    editor->set(editor, COLUMN_LENGTH, length);
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    tinker_turned_move(instance, &box_columns, &edit, part, dx, dy, editor);
}

static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles_of};

/* Tables */

static const TinkerPropertyType properties[] = {
    TINKER_BODY_PROPERTIES(TINKER_NOT_SOLID),
    {TINKER_REAL_PROPERTY("length", "Length", "Size", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.1, 4.0),
     .default_value = {1.0}, .symbol = "l", .meaning = TINKER_MEANING_WIDTH, .variability = TINKER_STRUCTURAL,
     .description = "Along its own x axis"},
    {TINKER_REAL_PROPERTY("width", "Width", "Size", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 1.0),
     .default_value = {0.05}, .meaning = TINKER_MEANING_HEIGHT, .variability = TINKER_STRUCTURAL,
     .description = "Across; with a width of 0 it is a line"},
};

static const TinkerQuantityType quantities[] = {TINKER_BODY_QUANTITIES};

static const TinkerBody body = {sizeof(TinkerBody), 3, TINKER_SHAPE_BOX, 0, as_shaped};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .body = &body};
static const TinkerRender render = {sizeof(TinkerRender), 1, draw, bounds};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, tinker_body_values};

static const TinkerUnitChoice unit_choices[] = {TINKER_BODY_UNITS, {"length", "m", "ft"}, {"width", "m", "in"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("bar", "Bar", TINKER_CONNECTABLE), .summary = "A slender rigid body that turns",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.bar", "Bar", "0.1.0", "MIT", blocks)

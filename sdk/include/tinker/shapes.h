/* Tinker SDK: the geometry that drawing and editing of most blocks share: connectors between two ends, boxes about a
 * centre, arrows from a point. Plain C99 and C++11, static inline. */
#ifndef TINKER_SHAPES_H
#define TINKER_SHAPES_H

#include "edit.h"
#include "kernels.h"
#include "render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Distance of a point from a segment. */
static inline double tinker_segment_distance(double x, double y, double x1, double y1, double x2, double y2)
{
    const double dx = x2 - x1, dy = y2 - y1, square = dx * dx + dy * dy;
    double along = square > 0.0 ? ((x - x1) * dx + (y - y1) * dy) / square : 0.0;
    along = along < 0.0 ? 0.0 : along > 1.0 ? 1.0 : along;
    return tinker_length(x - (x1 + along * dx), y - (y1 + along * dy));
}

/* How far the helpers of the style reach beyond the points they are given: coils, dashpots, heads of arrows, hatching
 * and marks are at most 1.2 symbols wide, lines have a width, and a dot is never less than a few pixels. */
static inline double tinker_drawing_margin(const TinkerStyle *style)
{
    return 0.6 * style->symbol_size + 2.0 * style->line_width + 5.0 * style->pixel;
}

/* A box that holds nothing yet, and one grown to hold a point with a margin about it. */
static inline void tinker_bounds_clear(double box[4])
{
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
}
static inline void tinker_bounds_add(double box[4], double x, double y, double margin)
{
    box[0] = fmin(box[0], x - margin);
    box[1] = fmin(box[1], y - margin);
    box[2] = fmax(box[2], x + margin);
    box[3] = fmax(box[3], y + margin);
}

/* The size of symbols where no style is at hand, so that what is hit is what was drawn. */
static inline double tinker_instance_symbol_size(const TinkerInstance *instance)
{
    return TINKER_HAS(TinkerInstance, instance, symbol_size) && instance->symbol_size > 0.0 ? instance->symbol_size
                                                                                            : 0.2;
}

/* Ends ----------------------------------------------------------------------------------------------------------- */

/* The end nearest to the point, within reach, else TINKER_PART_NONE. */
static inline int32_t tinker_ends_hit(const TinkerInstance *instance, double x, double y, double reach)
{
    int32_t part = TINKER_PART_NONE;
    double nearest = reach;
    for (int32_t k = 0; k < instance->ends; k++) {
        const double distance = tinker_length(x - instance->end[k].x, y - instance->end[k].y);
        if (distance <= nearest) {
            nearest = distance;
            part = k;
        }
    }
    return part;
}

/* Moves one end, which thereby comes off, or as the whole all ends that are detached: those that are attached stay. */
static inline void tinker_ends_move(const TinkerInstance *instance, int32_t part, double dx, double dy,
                                    const TinkerEditor *editor)
{
    for (int32_t k = 0; k < instance->ends; k++) {
        const TinkerEnd *end = &instance->end[k];
        if (part == k || (part == TINKER_PART_WHOLE && !end->attached)) {
            editor->set_end(editor, k, end->x + dx, end->y + dy);
        }
    }
}

/* Moves to a place: an end goes there; of the whole, its centre. */
static inline void tinker_ends_move_absolute(const TinkerInstance *instance, int32_t part, double x, double y,
                                             const TinkerEditor *editor)
{
    if (part >= 0 && part < instance->ends) {
        editor->set_end(editor, part, x, y);
    } else if (part == TINKER_PART_WHOLE) {
        tinker_ends_move(instance, part, x - instance->x, y - instance->y, editor);
    }
}

/* The marks of all ends, drawn last. */
static inline void tinker_ends_draw_marks(const TinkerInstance *instance, struct _cairo *cairo,
                                          const TinkerStyle *style)
{
    for (int32_t k = 0; k < instance->ends; k++) {
        style->end_mark(style, cairo, instance->end[k].x, instance->end[k].y, instance->end[k].attached);
    }
}

/* Hit, and bounds, of a connector that is drawn along the lines from each end to the next. */
static inline int32_t tinker_connector_hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const TinkerEnd *end = instance->end;
    int32_t part = tinker_ends_hit(instance, x, y, reach);
    for (int32_t k = 1; k < instance->ends && part == TINKER_PART_NONE; k++) {
        if (tinker_segment_distance(x, y, end[k - 1].x, end[k - 1].y, end[k].x, end[k].y) <= reach) {
            part = TINKER_PART_WHOLE;
        }
    }
    return part;
}
static inline void tinker_connector_bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    for (int32_t k = 0; k < instance->ends; k++) {
        tinker_bounds_add(box, instance->end[k].x, instance->end[k].y, tinker_drawing_margin(style));
    }
}

/* What hangs between two points, a catenary ---------------------------------------------------------------------- */

#define TINKER_HANGING_POINTS 49

/* The ratio sinh(u) / u that u is to have, by Newton's method; at least 1. */
static inline double tinker_hanging_parameter(double ratio)
{
    double u = ratio < 3.0 ? sqrt(6.0 * (ratio - 1.0)) : log(2.0 * ratio) + log(log(2.0 * ratio));
    for (int step = 0; step < 30 && u > 0.0; step++) {
        const double change = (sinh(u) - ratio * u) / (cosh(u) - ratio);
        u -= change;
        if (fabs(change) <= 1e-12 * u) break;
    }
    return u;
}

/* Points at equal ways along a line of this length that hangs in -y from (x1, y1) to (x2, y2), as x, y: straight where
 * it is no longer than the way. With d the span, h = y2 - y1 and sinh(u) / u = (l^2 - h^2)^1/2 / d its parameter is a =
 * d / (2 u), and its lowest point lies (l - h coth(u)) / 2 along it. */
static inline void tinker_hanging_line(double x1, double y1, double x2, double y2, double length,
                                       double points[2 * TINKER_HANGING_POINTS])
{
    const double least = 1e-6 * length, h = y2 - y1, along = x2 < x1 ? -1.0 : 1.0;
    const double span = fabs(x2 - x1) > least ? fabs(x2 - x1) : least;
    const double ratio = length > fabs(h) ? sqrt((length - h) * (length + h)) / span : 0.0;
    const int hangs = ratio > 1.0 + 1e-9;
    const double u = hangs ? tinker_hanging_parameter(ratio) : 1.0, a = span / (2.0 * u);
    const double lowest = (length - h / tanh(u)) / 2.0;
    for (int k = 0; k < TINKER_HANGING_POINTS; k++) {
        const double share = k / (TINKER_HANGING_POINTS - 1.0), s = share * length - lowest;
        points[2 * k] = x1 + (hangs ? along * a * (asinh(s / a) + asinh(lowest / a)) : share * (x2 - x1));
        points[2 * k + 1] = y1 + (hangs ? tinker_length(a, s) - tinker_length(a, lowest) : share * h);
    }
}

/* The most by which it hangs below the lower of its ends. */
static inline double tinker_hanging_depth(double y1, double y2, double length)
{
    const double slack = length - fabs(y2 - y1);
    return slack > 0.0 ? slack / 2.0 : 0.0;
}

/* Whether a place is within reach of a line through so many points, as x, y. */
static inline int tinker_polyline_is_near(const double *points, int32_t count, double x, double y, double reach)
{
    for (int32_t k = 1; k < count; k++) {
        const double *p = points + 2 * k;
        if (tinker_segment_distance(x, y, p[-2], p[-1], p[0], p[1]) <= reach) return 1;
    }
    return 0;
}

/* Arrows --------------------------------------------------------------------------------------------------------- */

typedef struct TinkerArrow {
    double x1, y1, x2, y2; /* tail and tip, m */
} TinkerArrow;

/* From a point along a direction. */
static inline TinkerArrow tinker_arrow_from(double x, double y, const double direction[2], double length)
{
    const TinkerArrow arrow = {x, y, x + length * direction[0], y + length * direction[1]};
    return arrow;
}

static inline int32_t tinker_arrow_is_hit(const TinkerArrow *arrow, double x, double y, double reach)
{
    return tinker_segment_distance(x, y, arrow->x1, arrow->y1, arrow->x2, arrow->y2) <= reach;
}

static inline void tinker_arrow_bounds(const TinkerArrow *arrow, double margin, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, arrow->x1, arrow->y1, margin);
    tinker_bounds_add(box, arrow->x2, arrow->y2, margin);
}

/* Sets an angle to that of a vector; one of length 0 has none and changes nothing. */
static inline void tinker_set_angle(const TinkerEditor *editor, int32_t column, double dx, double dy)
{
    if (dx != 0.0 || dy != 0.0) editor->set(editor, column, atan2(dy, dx));
}

/* Writes a handle, where there is room, and answers how many there are with it. */
static inline int32_t tinker_handle_add(TinkerHandle *handles, int32_t room, int32_t count, int32_t part, double x,
                                        double y)
{
    if (count >= room) return count;
    handles[count].x = x;
    handles[count].y = y;
    handles[count].part = part;
    handles[count].reserved = 0;
    return count + 1;
}

/* Boxes ---------------------------------------------------------------------------------------------------------- */

/* The columns in which a block about a centre keeps its place and size; of a vector the first one. */
typedef struct TinkerBoxColumns {
    int32_t position, local_origin, orientation, width, height;
} TinkerBoxColumns;

#define TINKER_HANDLE_SIZE         (TINKER_PART_HANDLE + 0) /* of a box the corner at the right of the top */
#define TINKER_HANDLE_ROTATION     (TINKER_PART_HANDLE + 1) /* above the top */
#define TINKER_HANDLE_LOCAL_ORIGIN (TINKER_PART_HANDLE + 2)

/* A point of the block's own axes in the world, and back. */
static inline void tinker_box_to_world(const TinkerInstance *instance, double own_x, double own_y, double *x, double *y)
{
    double axis[2];
    tinker_direction(instance->orientation, axis);
    *x = instance->x + own_x * axis[0] - own_y * axis[1];
    *y = instance->y + own_x * axis[1] + own_y * axis[0];
}
static inline void tinker_box_to_own(const TinkerInstance *instance, double x, double y, double *own_x, double *own_y)
{
    double axis[2];
    tinker_direction(instance->orientation, axis);
    *own_x = (x - instance->x) * axis[0] + (y - instance->y) * axis[1];
    *own_y = (y - instance->y) * axis[0] - (x - instance->x) * axis[1];
}

/* The whole where the turned box, or the dot that it has shrunk to, is within reach. */
static inline int32_t tinker_box_hit(const TinkerInstance *instance, const TinkerBoxColumns *at, double x, double y,
                                     double reach)
{
    double own_x, own_y;
    tinker_box_to_own(instance, x, y, &own_x, &own_y);
    const double beyond_x = fabs(own_x) - instance->columns[at->width] / 2.0;
    const double beyond_y = fabs(own_y) - instance->columns[at->height] / 2.0;
    /* Not fmax: it would drop a NaN, and the point would count as inside. */
    const double distance = tinker_length(beyond_x < 0.0 ? 0.0 : beyond_x, beyond_y < 0.0 ? 0.0 : beyond_y);
    return distance <= reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static inline void tinker_box_bounds(const TinkerInstance *instance, const TinkerBoxColumns *at, double margin,
                                     double box[4])
{
    const double half_width = instance->columns[at->width] / 2.0, half_height = instance->columns[at->height] / 2.0;
    tinker_bounds_clear(box);
    for (int corner = 0; corner < 4; corner++) {
        double x, y;
        tinker_box_to_world(instance, corner & 1 ? half_width : -half_width, corner & 2 ? half_height : -half_height,
                            &x, &y);
        tinker_bounds_add(box, x, y, margin);
    }
}

/* The handles of rotation, above what reaches so far from the centre along its own axes, and of the local origin. While
 * that lies on the centre its handle is parked beyond a corner: there it hides no mass from being dragged. Answers how
 * many handles there are with those `count` that are written already. */
static inline int32_t tinker_turned_handles(const TinkerInstance *instance, const TinkerBoxColumns *at,
                                            double half_width, double half_height, TinkerHandle *handles, int32_t room,
                                            int32_t count)
{
    const double symbol = tinker_instance_symbol_size(instance);
    double x, y;
    if (half_width > 0.0 || half_height > 0.0) {
        tinker_box_to_world(instance, 0.0, half_height + 2.0 * symbol, &x, &y);
        count = tinker_handle_add(handles, room, count, TINKER_HANDLE_ROTATION, x, y);
    }
    x = instance->columns[at->local_origin];
    y = instance->columns[at->local_origin + 1];
    if (tinker_length(x - instance->x, y - instance->y) <= symbol) {
        tinker_box_to_world(instance, -half_width - symbol, -half_height - symbol, &x, &y);
    }
    return tinker_handle_add(handles, room, count, TINKER_HANDLE_LOCAL_ORIGIN, x, y);
}

/* Moves the whole or the handle of rotation or of the local origin to a place. Moving the whole sets the place; what
 * displaces the block from it (a motion) stays, and so does the local origin. Uses no size. */
static inline void tinker_turned_move_absolute(const TinkerInstance *instance, const TinkerBoxColumns *at, int32_t part,
                                               double x, double y, const TinkerEditor *editor)
{
    const double *columns = instance->columns;
    if (part == TINKER_PART_WHOLE) {
        editor->set(editor, at->position, x - (instance->x - columns[at->position]));
        editor->set(editor, at->position + 1, y - (instance->y - columns[at->position + 1]));
    } else if (part == TINKER_HANDLE_LOCAL_ORIGIN) {
        editor->set(editor, at->local_origin, x);
        editor->set(editor, at->local_origin + 1, y);
    } else if (part == TINKER_HANDLE_ROTATION) {
        tinker_set_angle(editor, at->orientation, y - instance->y, instance->x - x);
    }
}

/* Moves the whole or the local origin by an offset; a handle, which has no columns of its own, to where it is then, by
 * the block's own function. */
static inline void tinker_turned_move(const TinkerInstance *instance, const TinkerBoxColumns *at,
                                      const TinkerEdit *edit, int32_t part, double dx, double dy,
                                      const TinkerEditor *editor)
{
    TinkerHandle handles[16]; /* all of a block that has points besides */
    if (part == TINKER_PART_WHOLE || part == TINKER_HANDLE_LOCAL_ORIGIN) {
        const int32_t column = part == TINKER_PART_WHOLE ? at->position : at->local_origin;
        editor->set(editor, column, instance->columns[column] + dx);
        editor->set(editor, column + 1, instance->columns[column + 1] + dy);
        return;
    }
    const int32_t count = edit->handles(instance, handles, 16);
    for (int32_t k = 0; k < count; k++) {
        if (handles[k].part == part) edit->move_absolute(instance, part, handles[k].x + dx, handles[k].y + dy, editor);
    }
}

/* Size, unless it is a dot, rotation and local origin. */
static inline int32_t tinker_box_handles(const TinkerInstance *instance, const TinkerBoxColumns *at,
                                         TinkerHandle *handles, int32_t room)
{
    const double half_width = instance->columns[at->width] / 2.0, half_height = instance->columns[at->height] / 2.0;
    int32_t count = 0;
    if (half_width > 0.0 || half_height > 0.0) {
        double x, y;
        tinker_box_to_world(instance, half_width, half_height, &x, &y);
        count = tinker_handle_add(handles, room, count, TINKER_HANDLE_SIZE, x, y);
    }
    return tinker_turned_handles(instance, at, half_width, half_height, handles, room, count);
}

static inline void tinker_box_move_absolute(const TinkerInstance *instance, const TinkerBoxColumns *at, int32_t part,
                                            double x, double y, const TinkerEditor *editor)
{
    double own_x, own_y;
    if (part != TINKER_HANDLE_SIZE) {
        tinker_turned_move_absolute(instance, at, part, x, y, editor);
        return;
    }
    tinker_box_to_own(instance, x, y, &own_x, &own_y);
    editor->set(editor, at->width, 2.0 * fabs(own_x));
    editor->set(editor, at->height, 2.0 * fabs(own_y));
}

/* Defines the interface of editing of a block that is a box with these columns, as a constant of this name. */
#define TINKER_DEFINE_BOX_EDIT(edit, columns)                                                                          \
    static int32_t edit##_hit(const TinkerInstance *instance, double x, double y, double reach)                        \
    {                                                                                                                  \
        return tinker_box_hit(instance, &(columns), x, y, reach);                                                      \
    }                                                                                                                  \
    static int32_t edit##_handles(const TinkerInstance *instance, TinkerHandle *handles, int32_t room)                 \
    {                                                                                                                  \
        return tinker_box_handles(instance, &(columns), handles, room);                                                \
    }                                                                                                                  \
    static void edit##_move_absolute(const TinkerInstance *instance, int32_t part, double x, double y,                 \
                                     const TinkerEditor *editor)                                                       \
    {                                                                                                                  \
        tinker_box_move_absolute(instance, &(columns), part, x, y, editor);                                            \
    }                                                                                                                  \
    static void edit##_move(const TinkerInstance *instance, int32_t part, double dx, double dy,                        \
                            const TinkerEditor *editor);                                                               \
    static const TinkerEdit edit = {sizeof(TinkerEdit), 0, edit##_hit, edit##_move, edit##_move_absolute,              \
                                    edit##_handles};                                                                   \
    static void edit##_move(const TinkerInstance *instance, int32_t part, double dx, double dy,                        \
                            const TinkerEditor *editor)                                                                \
    {                                                                                                                  \
        tinker_turned_move(instance, &(columns), &(edit), part, dx, dy, editor);                                       \
    }

#ifdef __cplusplus
}
#endif
#endif

/* Tinker SDK: what joints whose second end runs along a line of what their first end is on have in common: the row, the
 * drawing and the editing. C99 and later.
 *
 * The line goes through the first end x_1. With its direction u at the angle alpha + theta_1, its normal n, and
 * d = x_2 - x_1,
 *
 *     g = n . d,   dg/dx_2 = n,   dg/dx_1 = -n,   dg/dtheta_1 = -u . d,   drift = -w^2 n . d - 2 w u . d',
 *
 * since n' = -w u and u' = w n. A mass has no angle: on one the line keeps its direction.
 *
 *                     n ^      o x_2   g > 0: above the line
 *                       |    .
 *        x_1 o----------+----------> u
 *
 * Their first property is the angle alpha:
 *
 *     static const TinkerPropertyType properties[] = {TINKER_TRACK_PROPERTIES};
 *     static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_track_bounds};
 *     static const TinkerEdit edit = TINKER_TRACK_EDIT;
 */
#ifndef TINKER_TRACK_H
#define TINKER_TRACK_H

#include "joint.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The columns of TINKER_TRACK_PROPERTIES, which come first; those of the block's own properties begin behind them. */
enum { TINKER_TRACK_ANGLE, TINKER_TRACK_COLUMNS };

#define TINKER_TRACK_PROPERTIES                                                                                        \
    {                                                                                                                  \
        TINKER_REAL_PROPERTY("angle", "Angle", "Track", TINKER_DIMENSION_ANGLE),                                       \
            TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI),                                                                \
            .symbol = "α", .variability = TINKER_STRUCTURAL,                                                           \
            .description = "Of the track, from the x axis of what its first end is on"                                 \
    }

/* The direction u of the line of an instance, and its normal n, turned with what the first end is on. */
static inline void tinker_track_axes(double angle, const TinkerPose *pose, double u[2], double n[2])
{
    tinker_direction(angle + pose->angle, u);
    n[0] = -u[1];
    n[1] = u[0];
}

/* Writes the first row of an instance, of a constraint with so many `rows`, as a call of rows_at has to. */
static inline void tinker_track_row(const TinkerBatch *batch, int32_t instance, int32_t rows, const TinkerPoint *ends,
                                    double *g, double *jacobian, double *drift)
{
    const TinkerPoint *a = &ends[2 * instance], *b = a + 1;
    const TinkerPose *pose = &batch->poses[2 * instance];
    const double dx = b->x - a->x, dy = b->y - a->y, rate = pose->rate;
    const int32_t row = rows * instance;
    double u[2], n[2], *j = jacobian + 4 * row, *angular = batch->angular + 2 * row;
    tinker_track_axes(tinker_column(batch, TINKER_TRACK_ANGLE)[instance], pose, u, n);
    g[row] = n[0] * dx + n[1] * dy;
    j[0] = -n[0];
    j[1] = -n[1];
    j[2] = n[0];
    j[3] = n[1];
    angular[0] = -(u[0] * dx + u[1] * dy);
    angular[1] = 0.0;
    drift[row] = -rate * rate * g[row] - 2.0 * rate * (u[0] * (b->vx - a->vx) + u[1] * (b->vy - a->vy));
}

/* TINKER_JOINT_QUANTITIES from known multipliers; that of a second row is a torque. */
static inline TinkerStatus tinker_track_values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t rows,
                                               int32_t quantity, double *result)
{
    const double *angle = tinker_column(batch, TINKER_TRACK_ANGLE);
    if (input->poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &input->ends[2 * i], *b = a + 1;
        const double *l = input->multipliers + rows * i;
        double u[2], n[2];
        tinker_track_axes(angle[i], &input->poses[2 * i], u, n);
        double torque = -l[0] * (u[0] * (b->x - a->x) + u[1] * (b->y - a->y));
        if (rows > 1) torque -= l[1];
        result[i] = tinker_joint_value(quantity, -l[0] * n[0], -l[0] * n[1], torque);
    }
    return TINKER_OK;
}

/* Drawing: the track as two lines -------------------------------------------------------------------------------- */

/* Half of the track's length and width, in symbols; it is longer where the second end comes far from the first, and as
 * long during a whole run: it is a part of what the first end is on. */
#define TINKER_TRACK_LENGTH 3.0
#define TINKER_TRACK_WIDTH  0.45

static inline double tinker_track_half_length(const TinkerInstance *instance, double symbol)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double farthest = fmax(tinker_length(b->x - a->x, b->y - a->y), instance->span);
    return fmax(TINKER_TRACK_LENGTH * symbol, farthest + symbol);
}

/* The line's direction as it is drawn (rad). */
static inline double tinker_track_direction(const TinkerInstance *instance)
{
    return instance->columns[TINKER_TRACK_ANGLE] + instance->end[0].angle;
}

static inline void tinker_track_draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0];
    const double half = tinker_track_half_length(instance, style->symbol_size);
    const double off = TINKER_TRACK_WIDTH * style->symbol_size;
    double u[2];
    tinker_direction(tinker_track_direction(instance), u);
    for (int side = -1; side <= 1; side += 2) {
        const double x = a->x - side * off * u[1], y = a->y + side * off * u[0];
        style->line(style, cairo, TINKER_COLOUR_CONNECTOR, x - half * u[0], y - half * u[1], x + half * u[0],
                    y + half * u[1]);
    }
}

static inline void tinker_track_bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const double symbol = style->symbol_size;
    tinker_round_bounds(instance, style, tinker_track_half_length(instance, symbol) + symbol, box);
}

/* Editing: the handle, at the end of the line, turns it ---------------------------------------------------------- */

/* How far from the second end what runs in the track is still hit, in symbols. */
#define TINKER_TRACK_RUNNER 0.8

/* Where the line ends, on the side of u or, with side -1, on the other. */
static inline void tinker_track_end(const TinkerInstance *instance, double side, double *x, double *y)
{
    const double half = side * tinker_track_half_length(instance, tinker_instance_symbol_size(instance));
    double u[2];
    tinker_direction(tinker_track_direction(instance), u);
    *x = instance->end[0].x + half * u[0];
    *y = instance->end[0].y + half * u[1];
}

static inline int32_t tinker_track_hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double symbol = tinker_instance_symbol_size(instance);
    const TinkerEnd *b = &instance->end[1];
    const int32_t part = tinker_connector_hit(instance, x, y, reach);
    double x1, y1, x2, y2;
    if (part != TINKER_PART_NONE) return part;
    tinker_track_end(instance, -1.0, &x1, &y1);
    tinker_track_end(instance, 1.0, &x2, &y2);
    if (tinker_segment_distance(x, y, x1, y1, x2, y2) <= reach + TINKER_TRACK_WIDTH * symbol) return TINKER_PART_WHOLE;
    return tinker_length(x - b->x, y - b->y) <= reach + TINKER_TRACK_RUNNER * symbol ? TINKER_PART_WHOLE
                                                                                     : TINKER_PART_NONE;
}

static inline int32_t tinker_track_handles(const TinkerInstance *instance, TinkerHandle *handles, int32_t room)
{
    double x, y;
    tinker_track_end(instance, 1.0, &x, &y);
    return tinker_handle_add(handles, room, 0, TINKER_PART_HANDLE, x, y);
}

static inline void tinker_track_move_absolute(const TinkerInstance *instance, int32_t part, double x, double y,
                                              const TinkerEditor *editor)
{
    const double dx = x - instance->end[0].x, dy = y - instance->end[0].y;
    if (part != TINKER_PART_HANDLE) {
        tinker_ends_move_absolute(instance, part, x, y, editor);
    } else if (dx != 0.0 || dy != 0.0) {
        editor->set(editor, TINKER_TRACK_ANGLE, atan2(dy, dx) - instance->end[0].angle);
    }
}

static inline void tinker_track_move(const TinkerInstance *instance, int32_t part, double dx, double dy,
                                     const TinkerEditor *editor)
{
    double x, y;
    if (part != TINKER_PART_HANDLE) {
        tinker_ends_move(instance, part, dx, dy, editor);
        return;
    }
    tinker_track_end(instance, 1.0, &x, &y);
    tinker_track_move_absolute(instance, part, x + dx, y + dy, editor);
}

#define TINKER_TRACK_EDIT                                                                                              \
    {                                                                                                                  \
        sizeof(TinkerEdit), 0, tinker_track_hit, tinker_track_move, tinker_track_move_absolute, tinker_track_handles   \
    }

#ifdef __cplusplus
}
#endif
#endif

/* Tinker SDK: what joints have in common: quantities, drawing, editing. C99 and later.
 *
 *     static const TinkerQuantityType quantities[] = {TINKER_JOINT_QUANTITIES};
 *     static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
 *     {
 *         ... fx, fy and torque on what the first end is on, of every instance, from input->multipliers:
 *         result[i] = tinker_joint_value(quantity, fx, fy, torque);
 *     }
 */
#ifndef TINKER_JOINT_H
#define TINKER_JOINT_H

#include "declare.h"
#include "shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_DIMENSION_TORQUE TINKER_DIMENSION_ENERGY

/* What acts on the first end, or on what that is on; the opposite acts on the second. */
#define TINKER_JOINT_QUANTITIES                                                                                        \
    TINKER_QUANTITY(TINKER_RECORDED, "force x", "X Force", "Horizontal force on its first end",                        \
                    TINKER_DIMENSION_FORCE),                                                                           \
        TINKER_QUANTITY(TINKER_RECORDED, "force y", "Y Force", "Vertical force on its first end",                      \
                        TINKER_DIMENSION_FORCE),                                                                       \
        TINKER_QUANTITY(0, "force", "Force", "Magnitude of the force on either end", TINKER_DIMENSION_FORCE),          \
        TINKER_QUANTITY(0, "torque", "Torque", "On what its first end is on", TINKER_DIMENSION_TORQUE)

static inline double tinker_joint_value(int32_t quantity, double fx, double fy, double torque)
{
    return quantity == 0 ? fx : quantity == 1 ? fy : quantity == 2 ? tinker_length(fx, fy) : torque;
}

/* The units that its quantities are shown in at first. */
#define TINKER_JOINT_UNITS                                                                                             \
    {"force", "N", "lbf"}, {"force x", "N", "lbf"}, {"force y", "N", "lbf"},                                           \
    {                                                                                                                  \
        "torque", "N*m", "lbf*ft"                                                                                      \
    }

/* Writes 0 into all that a call of rows_at writes of one row of the Jacobian with two ends. */
static inline void tinker_row_clear(double *jacobian, double *angular, int32_t ends)
{
    for (int32_t k = 0; k < ends; k++) {
        jacobian[2 * k] = jacobian[2 * k + 1] = angular[k] = 0.0;
    }
}

/* Writes what a torque between the two ends of an instance does, as a call of `force` has to: no force, and the torque
 * on what the first end is on, its opposite on what the second is on. */
static inline void tinker_pair_of_torques(const TinkerBatch *batch, int32_t instance, double torque, double *forces)
{
    for (int32_t k = 0; k < 4; k++) {
        forces[4 * instance + k] = 0.0;
    }
    batch->angular[2 * instance] = torque;
    batch->angular[2 * instance + 1] = -torque;
}

/* `scale` of a constraint of angles alone, whose rows are in rad: an error is measured against one radian, wherever the
 * ends are. */
static inline TinkerStatus tinker_scale_of_angles(TinkerBatch *batch, double *scale)
{
    for (int32_t i = 0; i < batch->count; i++) {
        scale[i] = 1.0;
    }
    return TINKER_OK;
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

#define TINKER_ARC_LINES 24

/* A part of a circle about a place, from one angle to another, or of a spiral whose radius changes on its way. */
static inline void tinker_draw_arc(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x, double y,
                                   double from, double to, double radius_from, double radius_to)
{
    double points[2 * TINKER_ARC_LINES + 2];
    for (int k = 0; k <= TINKER_ARC_LINES; k++) {
        const double part = (double)k / TINKER_ARC_LINES, angle = from + part * (to - from);
        const double radius = radius_from + part * (radius_to - radius_from);
        points[2 * k] = x + radius * cos(angle);
        points[2 * k + 1] = y + radius * sin(angle);
    }
    style->polyline(style, cairo, colour, points, TINKER_ARC_LINES + 1);
}

/* Three quarters of a turn about a place with a head at its end, counter-clockwise where `turn` is positive. */
static inline void tinker_draw_turn_arrow(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x,
                                          double y, double radius, double turn)
{
    const double side = turn < 0.0 ? -1.0 : 1.0, from = side > 0.0 ? -0.25 * TINKER_PI : 1.25 * TINKER_PI;
    const double to = from + side * 1.4 * TINKER_PI, head = to + side * 0.12;
    tinker_draw_arc(style, cairo, colour, x, y, from, to, radius, radius);
    style->arrow(style, cairo, colour, x + radius * cos(to), y + radius * sin(to), x + radius * cos(head),
                 y + radius * sin(head));
}

/* Bounds of a connector that is drawn along the lines between its ends and within a radius about them. */
static inline void tinker_round_bounds(const TinkerInstance *instance, const TinkerStyle *style, double radius,
                                       double box[4])
{
    tinker_bounds_clear(box);
    for (int32_t k = 0; k < instance->ends; k++) {
        tinker_bounds_add(box, instance->end[k].x, instance->end[k].y, radius + tinker_drawing_margin(style));
    }
}

/* Where its ends have come apart, as in a scene whose start does not fit, what is between them. */
static inline void tinker_joint_draw_gap(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style,
                                         double near)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    if (tinker_length(b->x - a->x, b->y - a->y) <= near) return;
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* What ties the turning of two blocks and holds no places: a drive, a torsional spring. It is drawn at one place, at
 * the end on what stands, as a bearing does, else at its first end, whatever lies between its ends; these are shown
 * only while it is selected, or one of them is loose. */
static inline const TinkerEnd *tinker_turn_end(const TinkerInstance *instance)
{
    const TinkerEnd *end = instance->end;
    const int first = end[0].attached == TINKER_ATTACHED_TO_SUPPORT;
    return !first && instance->ends > 1 && end[1].attached == TINKER_ATTACHED_TO_SUPPORT ? &end[1] : &end[0];
}

static inline int tinker_turn_shows_ends(const TinkerInstance *instance, uint32_t state)
{
    int loose = 0;
    for (int32_t k = 0; k < instance->ends; k++) {
        loose = loose || !instance->end[k].attached;
    }
    return loose || (state & (TINKER_STATE_SELECTED | TINKER_STATE_DETACHED)) != 0;
}

static inline void tinker_turn_draw_ends(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style,
                                         double near)
{
    if (tinker_turn_shows_ends(instance, style->state)) tinker_joint_draw_gap(instance, cairo, style, near);
}

static inline void tinker_turn_bounds(const TinkerInstance *instance, const TinkerStyle *style, double radius,
                                      double box[4])
{
    const TinkerEnd *at = tinker_turn_end(instance);
    tinker_bounds_clear(box);
    if (tinker_turn_shows_ends(instance, style->state)) tinker_connector_bounds(instance, style, box);
    tinker_bounds_add(box, at->x, at->y, radius + tinker_drawing_margin(style));
}

static inline int32_t tinker_turn_hit(const TinkerInstance *instance, double radius, double x, double y, double reach)
{
    const TinkerEnd *at = tinker_turn_end(instance);
    const int32_t part = tinker_turn_shows_ends(instance, 0) ? tinker_connector_hit(instance, x, y, reach)
                                                             : tinker_ends_hit(instance, x, y, reach);
    if (part != TINKER_PART_NONE) return part;
    return tinker_length(x - at->x, y - at->y) <= radius + reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

#ifdef __cplusplus
}
#endif
#endif

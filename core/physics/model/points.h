/* Points and coordinates: what each point belongs to, what a vector by coordinate means at a point, and how
 * accelerations and forces go from one to the other. */
#ifndef TINKER_CORE_POINTS_H
#define TINKER_CORE_POINTS_H

#include "physics/model/model-data.h"

/* One entry of a row or a column over coordinates. */
typedef struct {
    int32_t coordinate;
    double value;
} TinkerCoordinateEntry;

/* Where a point is at the start, relative to the origin; of supports where they are unmoved. */
void tinker_model_start_place(const TinkerModel *model, int32_t point, double place[2]);

/* An attachment: a point from `first_attachment` on. */
static inline TinkerAttachment *tinker_model_attachment(const TinkerModel *model, int32_t point)
{
    return &g_array_index(model->attachments, TinkerAttachment, (guint)(point - model->first_attachment));
}

/* The body that a point is fixed to; -1: a support. */
static inline int32_t tinker_model_body_of(const TinkerModel *model, int32_t point)
{
    return point < model->bodies ? point : tinker_model_attachment(model, point)->body;
}

/* The block that a point is fixed to. */
static inline TinkerBlockId tinker_model_block_of(const TinkerModel *model, int32_t point)
{
    return point < model->bodies ? model->body_blocks[point] : tinker_model_attachment(model, point)->block;
}

/* How a body turns; NULL where it does not. */
static inline const TinkerTurn *tinker_model_turn(const TinkerModel *model, int32_t body)
{
    const int32_t turn = model->turn_of != NULL ? model->turn_of[body] : -1;
    return turn < 0 ? NULL : &model->turns[turn];
}

/* The coordinate that a body turns by; -1 where it does not. */
static inline int32_t tinker_model_turn_of(const TinkerModel *model, int32_t body)
{
    const TinkerTurn *turn = tinker_model_turn(model, body);
    return turn == NULL ? -1 : 2 * model->bodies + (int32_t)(turn - model->turns);
}

/* The body that moves along a coordinate. */
static inline int32_t tinker_model_moved_by(const TinkerModel *model, int32_t coordinate)
{
    return coordinate < 2 * model->bodies ? coordinate / 2 : model->turns[coordinate - 2 * model->bodies].body;
}

/* What a vector by coordinate means for a point: of velocities its velocity, of displacements its displacement. */
static inline void tinker_model_at_point(const TinkerModel *model, int32_t point, const double *by_coordinate,
                                         double out[2])
{
    const int32_t body = tinker_model_body_of(model, point);
    out[0] = out[1] = 0;
    if (body < 0) return;
    out[0] = by_coordinate[2 * body];
    out[1] = by_coordinate[2 * body + 1];
    if (point == body) return;
    const int32_t number = model->turn_of[body];
    const double turned = by_coordinate[2 * model->bodies + number] / model->turns[number].gyration;
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    if (at->turn) {
        out[0] = turned;
        out[1] = 0;
        return;
    }
    out[0] -= turned * at->arm[1];
    out[1] += turned * at->arm[0];
}

/* How the x (axis 0) or y (1) of a point depends on the coordinates, for the state set last; of a support on its own
 * entries in a vector by point. Answers how many entries there are. */
static inline int32_t tinker_model_point_entries(const TinkerModel *model, int32_t point, int axis,
                                                 TinkerCoordinateEntry list[2])
{
    if (point < model->bodies || point >= model->first_support) {
        list[0] = (TinkerCoordinateEntry){2 * point + axis, 1};
        return 1;
    }
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    const int32_t number = model->turn_of[at->body];
    if (at->turn) {
        list[0] = (TinkerCoordinateEntry){2 * model->bodies + number, 1 / model->turns[number].gyration};
        return axis == 0 ? 1 : 0;
    }
    const double arm = axis == 0 ? -at->arm[1] : at->arm[0];
    list[0] = (TinkerCoordinateEntry){2 * at->body + axis, 1};
    list[1] = (TinkerCoordinateEntry){2 * model->bodies + number, arm / model->turns[number].gyration};
    return 2;
}

/* What a vector by coordinate says of a body's turning: of places its angle (rad, counting turns), of velocities its
 * rate (rad/s); 0 where it does not turn. */
static inline double tinker_model_angle(const TinkerModel *model, int32_t body, const double *by_coordinate)
{
    const int32_t at = tinker_model_turn_of(model, body);
    return at < 0 ? 0 : by_coordinate[at] / model->turns[at - 2 * model->bodies].gyration;
}

/* The point of a block's centre; -1 where it has none, or is not of the model. */
static inline int32_t tinker_model_centre(const TinkerModel *model, TinkerBlockId block)
{
    const int32_t number = tinker_block_index_find(model->numbers, block);
    return number < 0 ? -1 : model->centre_point[number];
}

/* point_acceleration of attachments to bodies, from that of the coordinates. */
void tinker_model_accelerate_attachments(TinkerModel *model);

/* The other way: force of the coordinates gets what acts on attachments to bodies. */
void tinker_model_reduce_forces(TinkerModel *model);

#endif

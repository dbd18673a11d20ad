/* A place r of a body's own axes, with the body turned by the angle a, has the acceleration
 *
 *     x'' + w' x R(a) r - w^2 R(a) r;
 *
 * a force F there is F on the centre and the torque R(a) r x F, or that divided by the radius of gyration along the
 * coordinate of the turn. */
#include "physics/model/points.h"

#include <math.h>

void tinker_model_start_place(const TinkerModel *model, int32_t point, double place[2])
{
    if (point < model->bodies) {
        place[0] = model->q_start[2 * point];
        place[1] = model->q_start[2 * point + 1];
        return;
    }
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    place[0] = at->x;
    place[1] = at->y;
    if (at->body < 0) return;
    const double angle = tinker_model_angle(model, at->body, model->q_start), c = cos(angle), s = sin(angle);
    if (at->turn) {
        place[0] = angle;
        return;
    }
    place[0] = model->q_start[2 * at->body] + c * at->x - s * at->y;
    place[1] = model->q_start[2 * at->body + 1] + s * at->x + c * at->y;
}

void tinker_model_accelerate_attachments(TinkerModel *model)
{
    double *a = model->point_acceleration;
    for (int32_t point = model->first_attachment; point < model->first_support; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        const int32_t number = model->turn_of[at->body];
        const TinkerTurn *turn = &model->turns[number];
        const double w = turn->rate, alpha = a[2 * model->bodies + number] / turn->gyration;
        if (at->turn) {
            a[2 * point] = alpha;
            a[2 * point + 1] = 0;
            continue;
        }
        a[2 * point] = a[2 * at->body] - alpha * at->arm[1] - w * w * at->arm[0];
        a[2 * point + 1] = a[2 * at->body + 1] + alpha * at->arm[0] - w * w * at->arm[1];
    }
}

void tinker_model_reduce_forces(TinkerModel *model)
{
    const TinkerAttachment *at = (const TinkerAttachment *)(const void *)model->attachments->data;
    for (int32_t k = 0; k < model->turning; k++) {
        const TinkerTurn *turn = &model->turns[k];
        double *on_body = model->force + 2 * turn->body, *on_turn = model->force + 2 * model->bodies + k;
        for (int32_t point = turn->first_attachment; point < turn->end_attachment; point++, at++) {
            const double *f = model->force + 2 * point;
            if (at->turn) {
                *on_turn += f[0] / turn->gyration;
                continue;
            }
            on_body[0] += f[0];
            on_body[1] += f[1];
            *on_turn += (at->arm[0] * f[1] - at->arm[1] * f[0]) / turn->gyration;
        }
    }
}

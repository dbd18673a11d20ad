/* How far and how fast a model in the plane reaches: what errors of steps are measured against. */
#include <math.h>
#include <string.h>

#include "physics/system/system-private.h"

static void widen(double *box, double x, double y)
{
    box[0] = MIN(box[0], x);
    box[1] = MIN(box[1], y);
    box[2] = MAX(box[2], x);
    box[3] = MAX(box[3], y);
}

/* Widens the box by a state and by the points of supports that something attaches to. */
static void widen_by_state(const TinkerModel *model, const double *q, double *box)
{
    for (int32_t i = 0; i < model->bodies; i++)
        widen(box, q[2 * i], q[2 * i + 1]);
    for (int32_t i = model->bodies; i < model->points; i++)
        if (model->point_used[i]) widen(box, model->point[i].x, model->point[i].y);
}

/* A trial may be thrown away, so what it reaches is not kept: see tinker_model_system_keep. */
void system_scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    const TinkerModelSystem *self = context;
    const TinkerModel *model = self->model;
    double box[4], fastest = 0;
    memcpy(box, self->box, sizeof(box));
    widen_by_state(model, q, box);
    for (int32_t i = 0; i < model->bodies; i++)
        fastest = MAX(fastest, v[2 * i] * v[2 * i] + v[2 * i + 1] * v[2 * i + 1]);
    *extent = model->bodies > 0 ? MAX(hypot(box[2] - box[0], box[3] - box[1]), self->reach) : 0;
    for (int32_t k = 0; k < model->turning; k++) { // a body that turns in one place has its own size
        const double along = v[2 * model->bodies + k];
        fastest = MAX(fastest, along * along);
        *extent = MAX(*extent, 2 * model->turns[k].gyration);
    }
    *speed = MAX(self->speed, sqrt(fastest));
}

void tinker_model_system_keep(TinkerModelSystem *self, const double *q, const double *v)
{
    double extent;
    if (system_is_reduced(self)) {
        tinker_straight_system_keep(self, q, v);
        return;
    }
    system_scales(self, q, v, &extent, &self->speed);
    widen_by_state(self->model, q, self->box);
}

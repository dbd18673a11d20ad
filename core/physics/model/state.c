/* Bringing a model to a time and a state. */
#include "physics/model/state.h"
#include "numerics/sharing/sharing.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/model/failures.h"
#include "physics/model/points.h"
#include "physics/model/turns.h"

/* Of a support that is turned by a about its centre: c + R(a) r, c' + w x R(a) r, c'' + w' x R(a) r - w^2 R(a) r, with
 * the arm r that it has unmoved. */
static void turn_support_point(TinkerModel *model, int32_t point, const TinkerAttachment *at, const TinkerPlace *place)
{
    double *a = &model->point_acceleration[2 * point];
    const double w = place->rate, alpha = place->angular_acceleration;
    if (at->turn) {
        model->point[point] = (TinkerPoint){at->x + place->angle, 0, w, 0};
        a[0] = alpha;
        a[1] = 0;
        return;
    }
    const double c = cos(place->angle), s = sin(place->angle);
    const double r[2] = {c * at->arm[0] - s * at->arm[1], s * at->arm[0] + c * at->arm[1]};
    model->point[point] = (TinkerPoint){at->x - at->arm[0] + place->x + r[0], at->y - at->arm[1] + place->y + r[1],
                                        place->vx - w * r[1], place->vy + w * r[0]};
    a[0] = place->ax - alpha * r[1] - w * w * r[0];
    a[1] = place->ay + alpha * r[0] - w * w * r[1];
}

static G_NO_INLINE TinkerStatus move_supports(TinkerModel *model, double t)
{
    if (!tinker_motions_evaluate(model->motions, t)) {
        model->time = NAN; /* some supports are there, others not */
        tinker_model_tell_failure(model, _("%s: its motion at t = %g s is not a number"),
                                  tinker_scene_block_name(model->scene, tinker_motions_failure(model->motions)), t);
        return TINKER_RETRY_SMALLER;
    }
    for (int32_t point = model->first_support; point < model->points; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        if (!at->moving) continue;
        const TinkerPlace *place = tinker_motions_place(model->motions, at->block);
        if (at->turn || place->turns) {
            turn_support_point(model, point, at, place);
            continue;
        }
        model->point[point] = (TinkerPoint){at->x + place->x, at->y + place->y, place->vx, place->vy};
        model->point_acceleration[2 * point] = place->ax;
        model->point_acceleration[2 * point + 1] = place->ay;
    }
    return TINKER_OK;
}

TinkerStatus tinker_model_change_time(TinkerModel *model, double t)
{
    model->time = t;
    for (guint i = 0; i < model->waveform_batches->len; i++)
        tinker_block_batch_set_time(g_ptr_array_index(model->waveform_batches, i), t);
    return model->moving_supports == 0 ? TINKER_OK : move_supports(model, t);
}

typedef struct {
    TinkerPoint *point;
    const double *q, *v;
} Packing;

static void pack(void *data, int32_t first, int32_t end)
{
    const Packing *loop = data;
    TinkerPoint *restrict point = loop->point;
    const double *restrict q = loop->q, *restrict v = loop->v;
    for (int32_t i = first; i < end; i++)
        point[i] = (TinkerPoint){q[2 * i], q[2 * i + 1], v[2 * i], v[2 * i + 1]};
}

void tinker_model_share_state(TinkerModel *model, const double *q, const double *v)
{
    tinker_share_range(model->bodies, pack, &(Packing){model->point, q, v});
    if (model->turning == 0) return;
    tinker_model_set_angles(model, q);
    tinker_model_set_rates(model, v);
}

void tinker_model_set_places(TinkerModel *model, const double *q)
{
    TinkerPoint *restrict point = model->point;
    for (int32_t i = 0; i < model->bodies; i++)
        memcpy(&point[i].x, &q[2 * i], 2 * sizeof(double)); /* as one, for it is read so again at once */
    if (model->turning > 0) tinker_model_set_angles(model, q);
}

void tinker_model_set_velocities(TinkerModel *model, const double *v)
{
    for (int32_t i = 0; i < model->bodies; i++) {
        model->point[i].vx = v[2 * i];
        model->point[i].vy = v[2 * i + 1];
    }
    if (model->turning > 0) tinker_model_set_rates(model, v);
}

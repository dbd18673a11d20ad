/* Bringing a model to a time and a state, and showing plugins their part of it. */
#include <glib/gi18n-lib.h>

#include "numerics/sines/sines.h"
#include "physics/model/model-data.h"

#define TOGETHER 64 /* bodies whose angles are set at once */

TinkerBatch tinker_model_view(const TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                              const double **columns)
{
    for (int32_t column = 0; column < batch->block_class->column_count; column++)
        columns[column] = batch->columns[column] + first;
    for (int32_t i = 0; batch->ends < 0 && i <= count; i++)
        model->chunk_offsets[i] = batch->end_offsets[first + i] - batch->end_offsets[first];
    return (TinkerBatch){
        .struct_size = sizeof(TinkerBatch),
        .first = first,
        .count = count,
        .ends = batch->ends,
        .end_offsets = batch->ends < 0 ? model->chunk_offsets : NULL,
        .columns = columns,
        .scratch = batch->scratch,
        .time = model->time,
        .origin = {model->origin[0], model->origin[1]},
        .failed_instance = -1,
        .law_count = batch->law_count,
        .point_list_count = batch->point_list_count,
        .point_lists =
            batch->point_lists != NULL ? batch->point_lists + (gsize)first * (gsize)batch->point_list_count : NULL,
        .end_masses = batch->end_masses != NULL ? batch->end_masses + batch->end_offsets[first] : NULL,
        .laws = batch->laws != NULL
                    ? (const struct TinkerTypedLaw *const *)batch->laws + (gsize)first * (gsize)batch->law_count
                    : NULL,
    };
}

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

/* Turning bodies: a place r of a body's own axes, with the body turned by the angle a, is at
 *
 *     x + R(a) r,  v + w x R(a) r,  with the acceleration  x'' + w' x R(a) r - w^2 R(a) r;
 *
 * a force F there is F on the centre and the torque R(a) r x F, or that divided by the radius of gyration along the
 * coordinate of the turn. */

/* What is attached to a body that turns; NULL for nothing: where no body has anything there is no array to count in. */
static inline TinkerAttachment *attachments_of(const TinkerModel *model, const TinkerTurn *turn)
{
    if (turn->first_attachment == turn->end_attachment) return NULL;
    return (TinkerAttachment *)(void *)model->attachments->data + (turn->first_attachment - model->first_attachment);
}

static void set_turn_rates(TinkerModel *model, const double *v)
{
    const double *speeds = v + 2 * model->bodies;
    for (int32_t k = 0; k < model->turning; k++) {
        TinkerTurn *turn = &model->turns[k];
        const double vx = model->point[turn->body].vx, vy = model->point[turn->body].vy;
        const double rate = turn->rate = speeds[k] * turn->by_gyration;
        turn->speed = speeds[k];
        const TinkerAttachment *restrict at = attachments_of(model, turn);
        TinkerPoint *restrict point = model->point + turn->first_attachment;
        const TinkerPoint *const end = model->point + turn->end_attachment;
        for (; point < end; point++, at++) {
            if (at->turn) {
                point->vx = rate;
                continue;
            }
            point->vx = vx - rate * at->arm[1];
            point->vy = vy + rate * at->arm[0];
        }
    }
}

static inline void turn_arm(TinkerAttachment *at, double cosine, double sine)
{
    const double x = at->x, y = at->y;
    at->arm[0] = cosine * x - sine * y;
    at->arm[1] = sine * x + cosine * y;
}

static inline void put_attachments(TinkerModel *model, const TinkerTurn *turn, gboolean turned)
{
    const double x = turn->x, y = turn->y;
    const double angle = turn->angle, cosine = turn->cosine, sine = turn->sine;
    TinkerAttachment *restrict at = attachments_of(model, turn);
    TinkerPoint *restrict point = model->point + turn->first_attachment;
    const TinkerPoint *const end = model->point + turn->end_attachment;
    for (; point < end; point++, at++) {
        if (at->turn) {
            point->x = angle;
            continue;
        }
        if (turned) turn_arm(at, cosine, sine);
        point->x = x + at->arm[0];
        point->y = y + at->arm[1];
    }
}

static void turn_bodies(TinkerModel *model, TinkerTurn *turns, int32_t count, const double *places)
{
    double angles[TOGETHER], sines[TOGETHER], cosines[TOGETHER];
    for (int32_t k = 0; k < count; k++) {
        const TinkerPoint *centre = &model->point[turns[k].body];
        angles[k] = turns[k].angle = places[k] / turns[k].gyration;
        turns[k].place = places[k];
        turns[k].x = centre->x;
        turns[k].y = centre->y;
    }
    tinker_sines(count, angles, sines, cosines);
    for (int32_t k = 0; k < count; k++) {
        turns[k].cosine = cosines[k];
        turns[k].sine = sines[k];
        put_attachments(model, &turns[k], TRUE);
    }
    model->turned = TRUE;
}

static void move_bodies(TinkerModel *model, TinkerTurn *turns, int32_t count)
{
    for (TinkerTurn *turn = turns; turn < turns + count; turn++) {
        const TinkerPoint *centre = &model->point[turn->body];
        if (turn->x == centre->x && turn->y == centre->y) continue;
        turn->x = centre->x;
        turn->y = centre->y;
        put_attachments(model, turn, FALSE);
    }
}

static gboolean any_turned(const TinkerTurn *turns, int32_t count, const double *places)
{
    for (int32_t k = 0; k < count; k++)
        if (turns[k].place != places[k]) return TRUE;
    return FALSE;
}

/* Many states stand at one place, between the stages of a step and its projections. */
static gboolean any_moved(const TinkerModel *model, const TinkerTurn *turns, int32_t count, const double *places)
{
    for (int32_t k = 0; k < count; k++) {
        const TinkerPoint *centre = &model->point[turns[k].body];
        if (turns[k].place != places[k] || turns[k].x != centre->x || turns[k].y != centre->y) return TRUE;
    }
    return FALSE;
}

void tinker_model_set_angles(TinkerModel *model, const double *q)
{
    const double *places = q + 2 * model->bodies;
    for (int32_t first = 0; first < model->turning; first += TOGETHER) {
        const int32_t count = MIN(TOGETHER, model->turning - first);
        TinkerTurn *turns = model->turns + first;
        if (!any_moved(model, turns, count, places + first)) continue;
        if (any_turned(turns, count, places + first))
            turn_bodies(model, turns, count, places + first);
        else
            move_bodies(model, turns, count);
    }
}

gboolean tinker_model_has_angles(const TinkerModel *model, const double *q)
{
    return !any_turned(model->turns, model->turning, q + 2 * model->bodies);
}

void tinker_model_set_turns(TinkerModel *model, const double *q, const double *v)
{
    tinker_model_set_angles(model, q);
    set_turn_rates(model, v);
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
    if (model->turning > 0) tinker_model_set_turns(model, q, v);
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
    if (model->turning > 0) set_turn_rates(model, v);
}

/* Turning bodies: a place r of a body's own axes, with the body turned by the angle a, is at x + R(a) r, and moves with
 * v + w x R(a) r. */
#include "physics/model/turns.h"

#include "numerics/sines/sines.h"

#define TOGETHER 64 /* bodies whose angles are set at once */

/* What is attached to a body that turns; NULL for nothing: where no body has anything there is no array to count in. */
static inline TinkerAttachment *attachments_of(const TinkerModel *model, const TinkerTurn *turn)
{
    if (turn->first_attachment == turn->end_attachment) return NULL;
    return (TinkerAttachment *)(void *)model->attachments->data + (turn->first_attachment - model->first_attachment);
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
void tinker_model_set_rates(TinkerModel *model, const double *v)
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

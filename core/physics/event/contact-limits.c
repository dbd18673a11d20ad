/* How long a step may be where contacts are: what no error control of the method sees. */
#include <math.h>

#include "numerics/solve/largest.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* What was large and is no more loses so much of its say in every step. */
#define FADING 0.9

/* The top of the support with this centre; NULL: none. */
static const TinkerPlate *top_at(const TinkerContacts *contacts, int32_t point)
{
    for (int32_t i = 0; i < contacts->plate_count; i++)
        if (contacts->plates[i].point == point) return &contacts->plates[i];
    return NULL;
}

double tinker_contact_run_swing(TinkerContactRun *self, int32_t point, const TinkerPlate *top, double from, double to)
{
    const TinkerPlace *turned = top != NULL ? top->turned : NULL;
    const double reach = turned != NULL ? hypot(top->half_width, top->half_height) : 0;
    double *speed = &self->plate_speed[point - self->model->first_support], change = 0;
    for (int k = 0; k <= 8; k++) {
        if (tinker_model_set_time(self->model, from + k * (to - from) / 8) != TINKER_OK) return 0;
        const double *a = self->model->point_acceleration + 2 * point;
        const double rate = turned != NULL ? fabs(turned->rate) : 0,
                     alpha = turned != NULL ? fabs(turned->angular_acceleration) : 0;
        *speed = fmax(*speed, hypot(self->model->point[point].vx, self->model->point[point].vy) + rate * reach);
        change = fmax(change, hypot(a[0], a[1]) + (alpha + rate * rate) * reach);
    }
    self->contacts->plate_speed = fmax(self->contacts->plate_speed, *speed);
    return *speed > 0 ? change / *speed : 0;
}

double tinker_contact_run_fastest_turn(const TinkerContactRun *self)
{
    const TinkerModel *model = self->model;
    double highest = 0;
    for (int32_t k = 0; self->contacts->gap_count > 0 && k < model->turning; k++) {
        const int32_t at = 2 * model->bodies + k;
        const double speed = fmax(fabs(self->from.v[at]), fabs(self->run->state.v[at]));
        if (self->contacts->reach[model->turns[k].body] > 0) highest = fmax(highest, speed / model->turns[k].gyration);
    }
    return highest;
}

/* What supports that move do to bodies that rest is a function of time that no error control sees, since the bodies
 * stay or go along: its work needs steps that resolve it. */
static G_NO_INLINE double resolved_limit(TinkerContactRun *self, double limit)
{
    const TinkerModel *model = self->model;
    double from = self->run->state.t;
    for (int32_t point = model->first_support; self->contacts->closed->len > 0 && point < model->points; point++) {
        if (!tinker_model_attachment(model, point)->moving) continue;
        double swing = tinker_contact_run_swing(self, point, top_at(self->contacts, point), from, limit);
        if (swing > 0) limit = MIN(limit, from + TINKER_LONGEST_SWING / swing);
    }
    return limit;
}

/* How fast the motion swings that holds the energy: its largest acceleration beside its largest speed, of late. From
 * rest the speed is at first what one short step makes of the acceleration, so that steps grow as fast as the motion
 * does. */
static G_NO_INLINE double swing_limit(TinkerContactRun *self, double limit)
{
    TinkerIslandRun *run = self->run;
    TinkerSystem *system = &run->system.system;
    const TinkerState *state = &run->state;
    gint64 evaluations = self->model->evaluations;
    if (system->acceleration(system->context, state->t, state->q, state->v, self->force, NULL) == TINKER_OK)
        self->strongest = fmax(FADING * self->strongest, tinker_largest(system->size, self->force));
    self->model->evaluations = evaluations;
    self->fastest = fmax(FADING * self->fastest, tinker_largest(system->size, state->v));
    if (!(self->strongest > 0)) return limit;
    double share = TINKER_FIRST_WAY * (limit - state->t);
    return fmin(limit, state->t + fmax(share, TINKER_LONGEST_ARC * self->fastest / self->strongest));
}

/* The search for events follows no more turns than so many within a step. */
static G_NO_INLINE double turning_limit(const TinkerContactRun *self, double limit)
{
    const TinkerModel *model = self->model;
    double rate = 0;
    for (int32_t k = 0; k < model->turning; k++)
        rate = fmax(rate, fabs(self->run->state.v[2 * model->bodies + k]) / model->turns[k].gyration);
    return rate > 0 ? fmin(limit, self->run->state.t + TINKER_LONGEST_TURN / rate) : limit;
}

/* What few runs are limited by is called, so that the others do not carry its registers. */
double tinker_contact_run_step_limit(TinkerContactRun *self, double limit)
{
    if (self->contacts->gap_count > 0) limit = turning_limit(self, limit);
    if (self->model->moving_supports > 0 && tinker_method_is_adaptive(self->run->choice.method))
        limit = resolved_limit(self, limit);
    return self->exact ? swing_limit(self, limit) : limit;
}

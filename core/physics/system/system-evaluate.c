/* Accelerations of a model in the plane, and the powers that go into its books. */
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/force/forces.h"
#include "physics/model/state.h"
#include "physics/system/system-private.h"

static void write_books(const TinkerModelSystem *self, double *power)
{
    for (int32_t i = 0; i < self->system.books; i++)
        power[i] = self->model->book_power[self->book_of[i]];
}

static inline TinkerStatus applied_at(TinkerModelSystem *self, double t, const double *q, const double *v, double *a,
                                      gboolean books)
{
    TinkerStatus status = tinker_model_set_time(self->model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(self->model, q, v);
    return tinker_model_applied(self->model, a, books);
}

static gboolean constraints_give(const TinkerModel *model)
{
    return model->constraints.rows > 0 && (model->moving_supports > 0 || model->constraints.prescribed);
}

static TinkerStatus constrain_with_contacts(TinkerModel *model, double *a, gboolean books)
{
    TinkerStatus status = model->constraints.rows > 0 ? tinker_constraints_evaluate(model) : TINKER_OK;
    if (status != TINKER_OK) return status;
    tinker_contacts_accelerate(model->contacts, a);
    if (books) tinker_contacts_add_power(model->contacts);
    if (books && constraints_give(model)) tinker_constraints_add_power(model);
    return TINKER_OK;
}

/* Adds the accelerations by constraints and contacts, and what they give by what is prescribed to them. */
static TinkerStatus constrain(TinkerModel *model, double *a, gboolean books)
{
    if (tinker_contacts_act(model->contacts)) return constrain_with_contacts(model, a, books);
    if (model->constraints.rows == 0) return TINKER_OK;
    TinkerStatus status = tinker_constraints_evaluate(model);
    if (status != TINKER_OK) return status;
    tinker_constraints_accelerate(model, a);
    if (books && constraints_give(model)) tinker_constraints_add_power(model);
    return TINKER_OK;
}

/* Takes what was evaluated last, if that was at this state. */
static G_NO_INLINE gboolean take_known(TinkerModelSystem *self, double t, const double *q, const double *v, double *a,
                                       double *power)
{
    const TinkerEvaluated *known = self->known;
    const gsize bytes = (gsize)self->system.size * sizeof(double);
    self->known = NULL;
    if (t != known->t || memcmp(q, known->q, bytes) != 0 || memcmp(v, known->v, bytes) != 0) return FALSE;
    memcpy(a, known->a, bytes);
    if (power != NULL) memcpy(power, known->power, (gsize)self->system.books * sizeof(double));
    return TRUE;
}

TinkerStatus system_acceleration(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    TinkerModelSystem *self = context;
    if (G_UNLIKELY(self->known != NULL) && take_known(self, t, q, v, a, power)) return TINKER_OK;
    TinkerStatus status = applied_at(self, t, q, v, a, power != NULL);
    if (status == TINKER_OK) status = constrain(self->model, a, power != NULL);
    if (status == TINKER_OK && power != NULL) write_books(self, power);
    return status;
}

/* Friction is applied, but follows from the normal forces, which the constrained accelerations tell. */
static TinkerStatus apply_friction(TinkerModelSystem *self, double *a, gboolean books)
{
    memcpy(self->constrained, a, (gsize)self->model->coordinates * sizeof(double));
    TinkerStatus status = constrain_with_contacts(self->model, self->constrained, books);
    if (status == TINKER_OK) tinker_contacts_add_friction(self->model->contacts, a);
    return status;
}

/* Where nothing that acts feels velocities, a step that goes on to project them need not say them twice. */
static TinkerStatus applied_at_place(TinkerModelSystem *self, double t, const double *q, double *a)
{
    TinkerStatus status = tinker_model_set_time(self->model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_places(self->model, q);
    return tinker_model_applied(self->model, a, FALSE);
}

static gboolean feels_places_alone(const TinkerModelSystem *self)
{
    return system_is_held(self) && !(self->system.flags & TINKER_SYSTEM_VELOCITY_DEPENDENT) &&
           !tinker_contacts_act(self->model->contacts);
}

/* The applied accelerations leave the constraints out, the power does not: a support gives through its rods too. */
TinkerStatus system_applied(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    TinkerModelSystem *self = context;
    if (power == NULL && feels_places_alone(self)) return applied_at_place(self, t, q, a);
    TinkerStatus status = applied_at(self, t, q, v, a, power != NULL);
    if (status != TINKER_OK) return status;
    if (tinker_contacts_act(self->model->contacts)) {
        status = apply_friction(self, a, power != NULL);
        if (power != NULL) write_books(self, power);
        return status;
    }
    if (power == NULL) return status;
    if (constraints_give(self->model)) {
        memcpy(self->constrained, a, (gsize)self->model->coordinates * sizeof(double));
        status = constrain(self->model, self->constrained, TRUE);
    }
    write_books(self, power);
    return status;
}

/* The model as the abstract second-order system that integrators advance. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/force/forces.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/system/hold-energy.h"
#include "physics/system/jacobian.h"
#include "physics/system/system.h"

const char *const tinker_method_swapped_state =
    N_("the method put other arrays in the place of those of the state, which it is to fill (its plugin is at fault)");

static gboolean is_reduced(const TinkerModelSystem *self)
{
    return self->form != NULL && tinker_linear_form_is_reduced(self->form);
}

/* Whether the coordinates are held by constraints; those of shafts meet them as they are. */
static gboolean is_held(const TinkerModelSystem *self)
{
    return self->model->constraints.rows > 0 && !is_reduced(self);
}

static void write_books(const TinkerModelSystem *self, double *power)
{
    for (int32_t i = 0; i < self->system.books; i++)
        power[i] = self->model->book_power[self->book_of[i]];
}

static TinkerStatus applied_at(TinkerModelSystem *self, double t, const double *q, const double *v, double *a,
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

static TinkerStatus acceleration(void *context, double t, const double *q, const double *v, double *a, double *power)
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
    return is_held(self) && !(self->system.flags & TINKER_SYSTEM_VELOCITY_DEPENDENT) &&
           !tinker_contacts_act(self->model->contacts);
}

/* The applied accelerations leave the constraints out, the power does not: a support gives through its rods too. */
static TinkerStatus applied(void *context, double t, const double *q, const double *v, double *a, double *power)
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

static TinkerStatus project_with_contacts(TinkerModelSystem *self, double t, double *q, double *v, int32_t *moved)
{
    TinkerModel *model = self->model;
    gboolean placed, turned = FALSE;
    double work;
    TinkerStatus status = tinker_contacts_project_positions(model->contacts, t, q, v, &placed, &work);
    if (status != TINKER_OK) return status;
    self->projection_work += work + tinker_contacts_correct_velocities(model->contacts, v, FALSE, &turned);
    if (model->constraints.rows > 0)
        self->position_error = fmax(self->position_error, tinker_constraints_worst_miss(model));
    *moved = placed || turned;
    return TINKER_OK;
}

static TinkerStatus project(void *context, double t, double *q, double *v, int32_t *moved)
{
    TinkerModelSystem *self = context;
    TinkerModel *model = self->model;
    gboolean placed = FALSE, turned = FALSE;
    *moved = 0;
    if (tinker_contacts_act(model->contacts)) return project_with_contacts(self, t, q, v, moved);
    TinkerStatus status = TINKER_OK;
    if (is_held(self)) {
        status = tinker_constraints_project_positions(model, t, q, v, &placed);
        if (status != TINKER_OK) return status;
        self->projection_work +=
            model->constraints.work + tinker_constraints_correct_velocities(model, v, FALSE, &turned);
        self->position_error = fmax(self->position_error, tinker_constraints_worst_miss(model));
    }
    gboolean shifted = FALSE;
    if (self->holds_energy) status = tinker_model_system_hold_energy(self, t, q, v, &shifted);
    *moved = placed || turned || shifted;
    return status;
}

static TinkerStatus constrain_step(void *context, double t_from, const double *q_from, double t, double h, double *q,
                                   double *v)
{
    TinkerModelSystem *self = context;
    if (tinker_contacts_act(self->model->contacts))
        return tinker_contacts_rattle(self->model->contacts, t_from, q_from, t, h, q, v);
    if (!is_held(self)) return TINKER_OK;
    return tinker_constraints_rattle(self->model, t_from, q_from, t, h, q, v);
}

static TinkerStatus project_velocity_with_contacts(TinkerModel *model, double t, const double *q, double *v,
                                                   gboolean homogeneous)
{
    gboolean moved;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, q, v);
    if (model->constraints.rows > 0) status = tinker_constraints_evaluate(model);
    if (status == TINKER_OK) tinker_contacts_correct_velocities(model->contacts, v, homogeneous, &moved);
    return status;
}

static TinkerStatus project_velocity(void *context, double t, const double *q, double *v, int32_t homogeneous)
{
    TinkerModelSystem *self = context;
    gboolean moved;
    if (tinker_contacts_act(self->model->contacts))
        return project_velocity_with_contacts(self->model, t, q, v, homogeneous != 0);
    if (!is_held(self)) return TINKER_OK;
    return tinker_constraints_project_velocities(self->model, t, q, v, homogeneous != 0, &moved);
}

static TinkerStatus damping_product(void *context, double t, const double *q, const double *v, const double *dv,
                                    double *out)
{
    TinkerModelSystem *self = context;
    TinkerStatus status = tinker_model_set_time(self->model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(self->model, q, v);
    return tinker_model_damping_product(self->model, dv, out);
}

static TinkerStatus jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                             double *damping)
{
    const TinkerModelSystem *self = context;
    return tinker_jacobian_evaluate(self->jacobian, t, q, v, stiffness, damping);
}

static TinkerStatus row_masses(void *context, double t, const double *q, double *values)
{
    const TinkerModelSystem *self = context;
    return tinker_jacobian_row_masses(self->jacobian, t, q, values);
}

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
static void scales(void *context, const double *q, const double *v, double *extent, double *speed)
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
    if (is_reduced(self)) {
        tinker_straight_system_keep(self, q, v);
        return;
    }
    scales(self, q, v, &extent, &self->speed);
    widen_by_state(self->model, q, self->box);
}

static const char *failure(void *context)
{
    const TinkerModelSystem *self = context;
    return self->model->failure[0] != '\0' ? self->model->failure : NULL;
}

/* Whether any force depends on velocities: an asked batch may, and is taken to. */
static gboolean velocity_dependent(const TinkerModel *model)
{
    return model->lines.any_damping || model->field_drag != 0 || model->asked_lines->len > 0 ||
           model->asked_forces->len > 0 || model->asked_fields->len > 0;
}

static TinkerStatus signals(void *context, TinkerSignal *out)
{
    const TinkerModelSystem *self = context;
    return tinker_linear_form_signals(self->form, out);
}

static void set_functions_of_plane(TinkerModelSystem *self)
{
    TinkerSystem *system = &self->system;
    system->size = self->model->coordinates;
    system->mass = self->model->coordinate_mass;
    system->acceleration = acceleration;
    system->applied = applied;
    system->damping_product = damping_product;
    system->scales = scales;
    system->linear = NULL;
    system->signals = NULL;
}

static void set_form(TinkerModelSystem *self, TinkerLinearForm *form)
{
    self->form = form;
    self->system.linear = tinker_linear_form_system(form);
    self->system.signals = signals;
    if (!is_held(self)) self->system.flags &= ~(uint32_t)TINKER_SYSTEM_CONSTRAINED;
    if (is_reduced(self)) tinker_straight_system_init(self);
}

static void set_flags(TinkerModelSystem *self)
{
    self->system.flags = 0;
    if (self->model->constraints.rows > 0) self->system.flags |= TINKER_SYSTEM_CONSTRAINED;
    if (velocity_dependent(self->model)) self->system.flags |= TINKER_SYSTEM_VELOCITY_DEPENDENT;
}

void tinker_model_system_init(TinkerModelSystem *self, TinkerModel *model, TinkerLinearForm *form)
{
    *self = (TinkerModelSystem){
        .model = model,
        .box = {INFINITY, INFINITY, -INFINITY, -INFINITY},
        .reach = tinker_constraints_reach(model),
        .constrained = g_new0(double, (gsize)MAX(model->coordinates, 1)),
    };
    self->system = (TinkerSystem){
        .struct_size = sizeof(TinkerSystem),
        .context = self,
        .project = project,
        .constrain_step = constrain_step,
        .project_velocity = project_velocity,
        .failure = failure,
    };
    set_functions_of_plane(self);
    set_flags(self);
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        if (model->has_book[book]) self->book_of[self->system.books++] = book;
    if (form != NULL) set_form(self, form);
}

void tinker_model_system_enter_plane(TinkerModelSystem *self)
{
    TinkerSystem *system = &self->system;
    if (is_reduced(self)) tinker_straight_system_widen_box(self);
    self->form = NULL;
    set_functions_of_plane(self);
    /* what presses depends on the speeds of what constraints hold, and friction on what presses */
    if (self->model->constraints.rows > 0) system->flags |= TINKER_SYSTEM_VELOCITY_DEPENDENT;
    system->flags |= TINKER_SYSTEM_CONSTRAINED;
    g_clear_pointer(&self->jacobian, tinker_jacobian_free);
    system->pattern = NULL;
    system->jacobian = NULL;
    system->row_masses = NULL;
}

void tinker_model_system_leave_plane(TinkerModelSystem *self, TinkerLinearForm *form)
{
    set_flags(self);
    set_form(self, form);
    if (is_reduced(self)) tinker_straight_system_narrow_box(self);
}

void tinker_model_system_offer_jacobian(TinkerModelSystem *self)
{
    if (self->system.pattern != NULL) return;
    if (is_reduced(self)) {
        tinker_straight_system_offer_jacobian(self);
        return;
    }
    self->jacobian = tinker_jacobian_new(self->model);
    self->system.pattern = tinker_jacobian_pattern(self->jacobian);
    self->system.jacobian = jacobian;
    if (self->system.flags & TINKER_SYSTEM_CONSTRAINED) self->system.row_masses = row_masses;
}

void tinker_model_system_clear(TinkerModelSystem *self)
{
    g_clear_pointer(&self->jacobian, tinker_jacobian_free);
    g_clear_pointer(&self->constrained, g_free);
}

/* The model as the abstract second-order system that integrators advance: which functions stand in it, and when. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/constraint/constraints.h"
#include "physics/force/forces.h"
#include "physics/model/state.h"
#include "physics/system/system-private.h"

const char *const tinker_method_swapped_state =
    N_("the method put other arrays in the place of those of the state, which it is to fill (its plugin is at fault)");

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

static const char *failure(void *context)
{
    const TinkerModelSystem *self = context;
    return self->model->failure[0] != '\0' ? self->model->failure : NULL;
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
    system->acceleration = system_acceleration;
    system->applied = system_applied;
    system->damping_product = damping_product;
    system->scales = system_scales;
    system->linear = NULL;
    system->signals = NULL;
}

static void set_form(TinkerModelSystem *self, TinkerLinearForm *form)
{
    self->form = form;
    self->system.linear = tinker_linear_form_system(form);
    self->system.signals = signals;
    if (!system_is_held(self)) self->system.flags &= ~(uint32_t)TINKER_SYSTEM_CONSTRAINED;
    if (system_is_reduced(self)) tinker_straight_system_init(self);
}

static void set_flags(TinkerModelSystem *self)
{
    self->system.flags = 0;
    if (self->model->constraints.rows > 0) self->system.flags |= TINKER_SYSTEM_CONSTRAINED;
    if (tinker_model_feels_velocities(self->model)) self->system.flags |= TINKER_SYSTEM_VELOCITY_DEPENDENT;
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
        .project = system_project,
        .constrain_step = system_constrain_step,
        .project_velocity = system_project_velocity,
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
    if (system_is_reduced(self)) tinker_straight_system_widen_box(self);
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
    if (system_is_reduced(self)) tinker_straight_system_narrow_box(self);
}

void tinker_model_system_offer_jacobian(TinkerModelSystem *self)
{
    if (self->system.pattern != NULL) return;
    if (system_is_reduced(self)) {
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

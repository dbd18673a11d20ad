/* The linear form of a model: M x'' + C x' + K x = loads, where the model has one.
 *
 * Springs are linear where they have no length, or where everything lies and moves on one line, stably across it: then
 * there is one coordinate a body, along the line. Bodies that nothing holds are linear in both. Bodies that turn are
 * where they do so on fixed axes, tied by gears, torsional springs and dampers: there is one coordinate a shaft. */
#ifndef TINKER_CORE_LINEAR_FORM_H
#define TINKER_CORE_LINEAR_FORM_H

#include <tinker/integrator.h>

#include "physics/model/model.h"

typedef struct _TinkerLinearForm TinkerLinearForm;

/* NULL where the model has none, or where a signal has no form that can be given on some piece. The model is borrowed.
 * (transfer full) */
TinkerLinearForm *tinker_linear_form_new(TinkerModel *model);
void tinker_linear_form_free(TinkerLinearForm *form);

/* Its coefficients, without books. Borrowed. */
const TinkerLinearSystem *tinker_linear_form_system(const TinkerLinearForm *form);

/* Whether its coordinates are other ones than those of the model: along a line, or of shafts. */
gboolean tinker_linear_form_is_reduced(const TinkerLinearForm *form);

/* Whether they are those of shafts: bodies that turn on fixed axes. */
gboolean tinker_linear_form_is_of_shafts(const TinkerLinearForm *form);

/* Whether the model is stepped along one line, and its direction (a unit vector, where `direction` is not NULL). */
gboolean tinker_linear_form_is_straight(const TinkerLinearForm *form, double direction[2]);

/* The rate (1/s) at which straight motion of the model is left, where it lies on a line but is not stable across it; 0
 * everywhere else. Such a model has no linear form. */
double tinker_model_sideways_growth(TinkerModel *model);

/* Every signal in the piece between breaks that the model entered last. */
TinkerStatus tinker_linear_form_signals(TinkerLinearForm *form, TinkerSignal *signals);

/* Coordinates of the form to and from those of the model (relative to its origin). */
void tinker_linear_form_expand(const TinkerLinearForm *form, const double *x, const double *u, double *q, double *v);
void tinker_linear_form_reduce(const TinkerLinearForm *form, const double *q, const double *v, double *x, double *u);

/* Whether a state of the model is one of the form: along its line, to 1e-12 of the extent (m) and of the speed (m/s) of
 * the motion, where it is straight. */
gboolean tinker_linear_form_holds(const TinkerLinearForm *form, const double *q, const double *v, double extent,
                                  double speed);

#endif

/* The engine of the adaptive explicit Runge-Kutta methods: a method is a tableau.
 *
 * Stages are numbered from 0. Stage `stages` stands for the new point: its row of `a` are the weights b. Behind it come
 * `extra_stages` that only dense output needs. Dense output is, in Hairer's nested form with s = (t - t0) / h,
 *
 *     y(s) = y0 + s (F0 + (1-s) (F1 + s (F2 + (1-s) (F3 + s (F4 + ...)))))
 *     F0 = y1 - y0,  F1 = h f0 - F0,  F2 = 2 F0 - h (f0 + f1),  F3.. = h sum_i d_i f_i
 */
#ifndef TINKER_NUMERICS_EXPLICIT_RK_H
#define TINKER_NUMERICS_EXPLICIT_RK_H

#include "numerics/integrate/step-control.h"

#define TINKER_RK_STAGES_CAP 16 /* the new point and the extra stages included */

/* Constants of a method; all rows are TINKER_RK_STAGES_CAP wide, unset entries 0. */
typedef struct TinkerTableau {
    int order;
    int stages;
    int extra_stages;
    int dense_rows;
    const double *c;
    const double (*a)[TINKER_RK_STAGES_CAP];
    const double (*d)[TINKER_RK_STAGES_CAP];
    const double *error;        /* b minus the weights of the embedded method */
    const double *second_error; /* of a third method of lower order, or NULL: see tinker_tableau_join_errors */
    const double *dense_error;  /* at least what dense output is off by, where `error` can be blind to it; or NULL */
    TinkerStepLaw law;
    const struct TinkerTableau *brief; /* fewer stages, for steps that are far shorter; NULL: none */
} TinkerTableau;

/* True where the error weights need the acceleration at the new point. */
int tinker_tableau_ends_on_evaluation(const TinkerTableau *tableau);

/* The one error from the method's two, as DOP853 joins them: e^2 / sqrt(e^2 + 0.01 e2^2). */
double tinker_tableau_join_errors(double error, double second_error);

/* weights[i], i below all stages, of y(s) = y0 + h sum_i weights[i] f_i. */
void tinker_tableau_dense_weights(const TinkerTableau *tableau, double s, double *weights);

/* The functions of the vtable; `create` takes the tableau besides. */
void *tinker_explicit_rk_create(const TinkerTableau *tableau, const TinkerSystem *system,
                                const TinkerIntegratorOptions *options);
void tinker_explicit_rk_destroy(void *stepper);
void tinker_explicit_rk_restart(void *stepper);
TinkerStatus tinker_explicit_rk_step(void *stepper, TinkerState *state, double limit, TinkerStepReport *report);
TinkerStatus tinker_explicit_rk_interpolate(void *stepper, double t, double *q, double *v, double *books);

/* The tableaus, for the tests of their order conditions. */
extern const TinkerTableau tinker_tableau_dopri5;
extern const TinkerTableau tinker_tableau_dop853;
extern const TinkerTableau tinker_tableau_kutta;

#endif

/* The equations of linear motion with matrices: M x'' + C x' + K x = f(t). */
#ifndef TINKER_CORE_EQUATION_MATRIX_H
#define TINKER_CORE_EQUATION_MATRIX_H

#include "equations/newton/equations.h"
#include "physics/plan/plan.h"

/* Along one line of a body's motion. */
typedef struct {
    char *symbol;
    TinkerBlockId body;
    double direction[2];  /* unit vector */
    TinkerExpression *is; /* of the body's place, m */
    double about;         /* m: what x is counted from; */
    double rounding;      /* how far rounding alone can have moved that */
} TinkerMatrixCoordinate;

/* Entries are expressions, n by n by rows. */
typedef struct {
    GArray *blocks;      /* of TinkerBlockId: bodies, then what acts on them */
    GArray *coordinates; /* of TinkerMatrixCoordinate */
    GPtrArray *mass, *damping, *stiffness, *load;
    gboolean about_rest; /* K is regular: constant loads are in `about` */
    /* of pairs of roots s: omega^2 = s1 s2, 2 zeta omega = -(s1 + s2); of NAN there is none: */
    double *omega, *zeta, *decay, *unstable; /* unstable: two a pair */
} TinkerMatrixIsland;

typedef struct {
    GPtrArray *islands; /* of TinkerMatrixIsland */
    GPtrArray *why;     /* of TinkerNotWritten, without symbols: of each other island its first body, and the reason */
} TinkerMatrixForm;

/* The islands of a plan that are linear. (transfer full) */
TinkerMatrixForm *tinker_matrix_form_new(const TinkerEquations *equations, const TinkerPlan *plan);
void tinker_matrix_form_free(TinkerMatrixForm *form);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerMatrixForm, tinker_matrix_form_free)

#endif

/* The equations of linear motion with matrices: M x'' + C x' + K x = f(t). */
#ifndef TINKER_CORE_EQUATION_MATRIX_H
#define TINKER_CORE_EQUATION_MATRIX_H

#include "equations/newton/equations.h"
#include "physics/plan/plan.h"

/* Along one line of a body's motion; or its angle. */
typedef struct {
    char *symbol;
    TinkerBlockId body;
    gboolean turning;
    double direction[2];  /* unit vector, of one that does not turn */
    TinkerExpression *is; /* of the body's place, m, or its angle, rad */
    double about;         /* what that is counted from; */
    double rounding;      /* how far rounding alone can have moved that */
} TinkerMatrixCoordinate;

typedef enum { TINKER_MATRIX_MASS, TINKER_MATRIX_DAMPING, TINKER_MATRIX_STIFFNESS, TINKER_MATRICES } TinkerMatrixKind;

/* Entries are expressions, n by n by rows. */
typedef struct {
    GArray *blocks;      /* of TinkerBlockId: bodies, then what acts on them */
    GArray *coordinates; /* of TinkerMatrixCoordinate */
    GPtrArray *matrices[TINKER_MATRICES], *load;
    GHashTable *sparse[TINKER_MATRICES]; /* in the place of these of many coordinates: see tinker_matrix_each */
    gboolean about_rest;                 /* K is regular: constant loads are in `about` */
    /* of pairs of roots s: omega^2 = s1 s2, 2 zeta omega = -(s1 + s2); of NAN there is none: */
    double *omega, *zeta, *decay, *unstable; /* unstable: two a pair */
} TinkerMatrixIsland;

typedef struct {
    GPtrArray *islands; /* of TinkerMatrixIsland */
    GPtrArray *large;   /* likewise, without loads, rest and roots: those that are linear and have more coordinates */
    GPtrArray *why; /* of TinkerNotWritten, without symbols: of each that is not in `islands` its first body, and the
                       reason */
} TinkerMatrixForm;

/* The islands of a plan that are linear. Up to 64 coordinates they have rest and roots; `all_numbers` of more, up to
 * 256, or 512 of a symmetric matrix without damping, whose roots cost less. (transfer full) */
TinkerMatrixForm *tinker_matrix_form_new(const TinkerEquations *equations, const TinkerPlan *plan,
                                         gboolean all_numbers);
void tinker_matrix_form_free(TinkerMatrixForm *form);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerMatrixForm, tinker_matrix_form_free)

/* Each entry that is not 0, by rows. */
typedef void (*TinkerMatrixFunc)(guint row, guint column, const TinkerExpression *entry, void *data);
void tinker_matrix_each(const TinkerMatrixIsland *island, TinkerMatrixKind kind, TinkerMatrixFunc func, void *data);

#endif

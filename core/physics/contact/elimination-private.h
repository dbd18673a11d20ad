/* What the files of the elimination share: the bodies of a group with the ends of its rows, and the factor. */
#ifndef TINKER_CORE_ELIMINATION_PRIVATE_H
#define TINKER_CORE_ELIMINATION_PRIVATE_H

#include "numerics/solve/sparse-ldu.h"
#include "physics/contact/contact-elimination.h"

/* For loops whose counts are constants where they are called. */
#define INLINE __attribute__((always_inline)) static inline

/* One end of a row on a body of the group. */
typedef struct {
    int32_t row, entry; /* in the group; in the Jacobian */
} EliminationEnd;

typedef struct {
    int32_t body;
    double inverse_mass;
    int32_t first_end, end_count;
    int32_t first_product; /* of end_count x end_count */
    int32_t first, count;  /* equations */
} EliminationBody;

typedef struct {
    double inverse[TINKER_MOST_EQUATIONS]; /* its row of A^-1 */
    double miss, move;                     /* what is still asked for; the force that does so */
} EliminationEquation;

struct _TinkerContactElimination {
    TinkerModel *model;
    int32_t bodies, rows, equations;
    gsize room; /* for equations */
    const TinkerContactEquation *of;
    EliminationBody *body; /* in the order of the model */
    EliminationEnd *ends;
    int *slots; /* of products */
    TinkerSparseLdu *ldu;
    double *least, *mu; /* by row */
    int *diagonal;
    EliminationEquation *equation;
    double *along;   /* by equation */
    double *by_body; /* by coordinate of the model; borrowed */
    gint64 solves;

    /* a solve in progress */
    const double *b;
    double *x;
    double miss, before; /* largest miss of x, and what it was before the last moves */
    int tries;
    gboolean full, done;
    gboolean went_back; /* the last push was not of x */
};

static inline double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* Factors S with a softness on the diagonals of equations and rows, and solves for mu of the misses by the way, which
 * costs next to nothing more. FALSE where equations or rows depend on one another. */
gboolean tinker_elimination_factor(TinkerContactElimination *elimination, double softness, double row_softness);

/* mu of the misses, with the last factor. */
void tinker_elimination_solve_rows(TinkerContactElimination *elimination);

#endif

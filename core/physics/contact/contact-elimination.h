/* Equations of contacts beside constraint rows, solved by eliminating the contacts first.
 *
 * An equation acts on one body alone: a force along `force` (d) keeps the motion along `row` (c) at what is asked for.
 * With the constraint rows J, which answer to every force, the forces f of all equations and the multipliers mu follow
 * from
 *
 *     C M^-1 (D f + J^T mu) + s M^-1 f = b,      J M^-1 (D f + J^T mu) = 0,
 *
 * b the motion that is asked for, s >= 0 a softness. The first line holds body by body: with A = C_i D_i + s, of as
 * many rows as equations act on body i, f_i = A^-1 (m_i b_i - C_i J_i^T mu). What is left of the second is
 *
 *     sum_i J_i (1 - D_i A^-1 C_i) J_i^T / m_i  mu = - sum_i J_i D_i A^-1 b_i,
 *
 * S = J M^-1 J^T with the mobility taken off the bodies that contacts take of them: all of it where a body sticks, all
 * but what is along the top where it slides. It has the pattern of S, so that its factor costs as much as that of S,
 * linear along chains and trees, however many contacts there are. With friction it is not symmetric. Where constraints
 * and contacts hold bodies more than once it is singular for s = 0.
 *
 * Source: Schur complements of saddle point matrices, Benzi, Golub, Liesen, "Numerical solution of saddle point
 * problems", Acta Numerica 14 (2005) 1-137, section 5; tested against dense elimination in tests/physics. */
#ifndef TINKER_CORE_CONTACT_ELIMINATION_H
#define TINKER_CORE_CONTACT_ELIMINATION_H

#include "physics/model/model-data.h"

/* Of one body at most. */
#define TINKER_MOST_EQUATIONS 8

typedef struct {
    int32_t body;
    double row[2], force[2];
    double slope; /* for whoever lists them */
} TinkerContactEquation;

typedef struct _TinkerContactElimination TinkerContactElimination;

/* For the bodies of one set (`group`: by body, the first of its set), which no constraint joins to others. Pushes are
 * worked out in `by_body`, one number a coordinate of the model: borrowed, and anybody's in between. NULL where there
 * is no memory. (transfer full) */
TinkerContactElimination *tinker_contact_elimination_new(TinkerModel *model, const int32_t *group, int32_t first,
                                                         double *by_body);
void tinker_contact_elimination_free(TinkerContactElimination *elimination);

/* Room for so many equations. FALSE: no memory. */
gboolean tinker_contact_elimination_make_room(TinkerContactElimination *elimination, gsize count);

/* Takes equations that there is room for, in the order of their bodies, no more than TINKER_MOST_EQUATIONS of one;
 * borrowed. */
void tinker_contact_elimination_take(TinkerContactElimination *elimination, const TinkerContactEquation *equations,
                                     int32_t count);

/* What the forces x of the equations, and the constraints' answer to them, do along each equation, for the constraint
 * rows evaluated last. */
void tinker_contact_elimination_push(TinkerContactElimination *elimination, const double *x, double *along);

/* What the bodies of the model did at the push made last: 2 per body, in what the elimination borrowed for it. */
const double *tinker_contact_elimination_pushed(const TinkerContactElimination *elimination);

/* Changes the forces x until they do b along each equation, for the constraint rows evaluated last: to rounding where
 * that is to be had. Where equations and rows depend on one another x is the solution that is nearest to what it was,
 * by forces over the roots of masses; FALSE then. The last push is that of x. Allots nothing. */
gboolean tinker_contact_elimination_solve(TinkerContactElimination *elimination, const double *b, double *x);

/* The same of several at once, no two of which are joined by a constraint, so that it takes no more answers of the
 * constraints, which cost in proportion to the whole model, than one of them: each is begun, with b and x borrowed to
 * the end, then all are taken there. Then each says whether its x is determined. What was pushed last does not count.
 */
void tinker_contact_elimination_begin(TinkerContactElimination *elimination, const double *b, double *x);
void tinker_contact_eliminations_end(TinkerContactElimination *const *eliminations, guint count);
gboolean tinker_contact_elimination_is_full(const TinkerContactElimination *elimination);

/* Solves once with a softness s on the diagonal, as a step of an iteration; factored first. x need not be set. */
void tinker_contact_elimination_soften(TinkerContactElimination *elimination, double softness);
void tinker_contact_elimination_solve_soft(TinkerContactElimination *elimination, const double *b, double *x);

/* Entries of both triangles of the factor; and how many factors and solves, each of which costs in proportion to them,
 * there were. */
gsize tinker_contact_elimination_fill(const TinkerContactElimination *elimination);
gint64 tinker_contact_elimination_solves(const TinkerContactElimination *elimination);

#endif

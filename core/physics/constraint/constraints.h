/* Constraints of a model: their rows, solving for their forces, and bringing a state back onto them. */
#ifndef TINKER_CORE_CONSTRAINTS_H
#define TINKER_CORE_CONSTRAINTS_H

#include "physics/model/model-data.h"
#include "physics/model/points.h"

/* The greatest length (m) that a constraint with one end declares, else 0: it holds a body about a place where no point
 * is. */
double tinker_constraints_reach(const TinkerModel *model);
/* Rows at the state in the points: g, Jacobian, drift. */
TinkerStatus tinker_constraints_evaluate(TinkerModel *model);
/* Whether all rows are of ends that coincide, of which g can be had alone, from the places in the points: the Jacobian
 * and what else was evaluated last stay as they are. */
gboolean tinker_constraints_are_gaps(const TinkerModel *model);
TinkerStatus tinker_constraints_find_gaps(TinkerModel *model);
/* Asks a plugin for the rows of a view of its batch, whose ends are at these places and, where the rows depend on
 * angles, turned as part->angles has it: g and drift a row, two numbers of the Jacobian an entry. */
TinkerStatus tinker_constraints_ask(const TinkerConstraintBatch *part, TinkerBatch *view, const TinkerPoint *ends,
                                    double *g, double *jacobian, double *drift);
/* Adds the constraint accelerations to a (2 per body), for the rows evaluated last; leaves lambda. Answers the largest
 * acceleration (m/s^2) that could not be met: see tinker_constraints_solve. */
double tinker_constraints_accelerate(TinkerModel *model, double *a);
/* Between two steps, before a sample is worked out: a factor that is at hand serves a first Newton step too, so that
 * samples would depend on those before them, and the next step on all of them. From here on there is none; the step's
 * is put back by the second of these, which does nothing where nobody has looked. */
void tinker_constraints_begin_look(TinkerModel *model);
void tinker_constraints_end_look(TinkerModel *model);
/* Solves S x = b, both of one entry a row; in place. Answers the largest residual: 0 where the rows are independent,
 * rounding where dependent rows agree, more where they contradict each other. Rows that no body feels get 0. */
double tinker_constraints_solve(TinkerModel *model, double *b);
/* A Newton step back to the constraints, S x = -g: leaves x in lambda and M^-1 J^T x in displacement. `roughly`: with
 * the factor at hand. */
void tinker_constraints_newton_step(TinkerModel *model, gboolean roughly);
/* Solves S x = asked, of one entry a row: leaves x in lambda and adds M^-1 J^T x to v. */
void tinker_constraints_change_speeds(TinkerModel *model, const double *asked, double *v);
/* Adds to v what the constraints answer to the change of velocities in by_point, so that it breaks none of the rows
 * evaluated last. */
void tinker_constraints_answer(TinkerModel *model, double *v);
TinkerStatus tinker_constraints_project_positions(TinkerModel *model, double t, double *q, const double *v,
                                                  gboolean *moved);
/* Brings velocities back onto the rows evaluated last. Answers the kinetic energy (J) that this gave. */
double tinker_constraints_correct_velocities(TinkerModel *model, double *v, gboolean homogeneous, gboolean *moved);
TinkerStatus tinker_constraints_project_velocities(TinkerModel *model, double t, const double *q, double *v,
                                                   gboolean homogeneous, gboolean *moved);
/* RATTLE's position stage, see TinkerSystem.constrain_step. */
TinkerStatus tinker_constraints_rattle(TinkerModel *model, double t_from, const double *q_from, double t, double h,
                                       double *q, double *v);
/* J v + dg/dt of the rows evaluated last, for the velocities in the points; J u for a vector u by point. */
void tinker_constraints_rates(const TinkerModel *model, double *out);
void tinker_constraints_rows_times(const TinkerConstraints *constraints, const double *by_point, double *out);
/* Largest |g| relative to the rows' lengths, and largest |J v + dg/dt| (m/s), at a state. */
TinkerStatus tinker_constraints_errors(TinkerModel *model, double t, const double *q, const double *v, double *position,
                                       double *velocity);
/* Has what is wound on a body (a cord) count from how it is at a state of the run (wound-rows.c): after each step. */
TinkerStatus tinker_constraints_rewind(TinkerModel *model, double t, const double *q, const double *v);
/* The length (m) of what is off the body that a block is wound on, slack with it, at a state; NAN where no row of the
 * model is that block's and wound. What was evaluated last stays as it is, but for the points. */
double tinker_constraints_wound_length(TinkerModel *model, double t, const double *q, const double *v,
                                       TinkerBlockId block);

/* The unit of what a row misses, "m" or "rad". Static. */
const char *tinker_constraints_row_unit(const TinkerModel *model, int32_t row);
/* The largest |g| relative to its row's length, of the rows evaluated last. */
double tinker_constraints_worst_miss(const TinkerModel *model);
/* The row that is off most, by the same measure. */
int32_t tinker_constraints_worst_row(const TinkerModel *model);
/* Of rows that hold in one direction only: whether one acts from the next evaluation on. */
void tinker_constraints_set_slack(TinkerModel *model, int32_t row, gboolean slack);
/* Makes all rows that hold in one direction only slack, or none. */
void tinker_constraints_set_all_slack(TinkerModel *model, gboolean slack);
/* Whether it acts or not, for the rows evaluated last: dg/dt with the velocities in the points; J x of bodies alone (2
 * per body); and what d2g/dt2 is beside J a of the bodies. */
double tinker_constraints_own_rate(const TinkerModel *model, int32_t row);
double tinker_constraints_own_row_times(const TinkerModel *model, int32_t row, const double *by_body);
double tinker_constraints_own_drift(const TinkerModel *model, int32_t row);
/* Keeps what the rows are as their own, and takes the slack ones out. Called by tinker_constraints_evaluate. */
void tinker_constraints_hide_slack(TinkerConstraints *constraints);

/* Whether every solve is proximal (constraints.c): where rows depend on others at the start, other than that they
 * repeat one, and where they could without their hubs, which the factor is of. */
static inline gboolean tinker_constraints_are_proximal(const TinkerConstraints *all)
{
    return all->dependent > 0 || all->border > 0;
}

/* The first entry of a row in `turns`; of the row behind the last one, their end. */
static inline int32_t tinker_row_turns(const TinkerConstraints *all, int32_t row)
{
    return all->turn_starts != NULL ? all->turn_starts[row] : 0;
}

/* A row evaluated last over coordinates, and over what supports have in a vector by point; one coordinate may come more
 * than once. `list` has room for three entries an end. Answers how many there are. */
static inline int32_t tinker_constraints_list_row(const TinkerConstraints *all, int32_t row,
                                                  TinkerCoordinateEntry *list)
{
    int32_t count = 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
        for (int32_t k = 0; k < 2; k++)
            list[count++] = (TinkerCoordinateEntry){2 * all->points[e] + k, all->jacobian[2 * e + k]};
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++)
        list[count++] = (TinkerCoordinateEntry){all->turns[k].coordinate, all->jacobian[2 * all->entries + k]};
    return count;
}

/* Room for any row. (transfer full) */
static inline TinkerCoordinateEntry *tinker_constraints_row_room(const TinkerConstraints *all)
{
    int32_t most = 0;
    for (int32_t row = 0; row < all->rows; row++)
        most = MAX(most, all->row_starts[row + 1] - all->row_starts[row]);
    return g_new(TinkerCoordinateEntry, 3 * (gsize)most + 1);
}

/* Whether a row holds nothing (idle-rows.c). */
gboolean tinker_constraints_is_idle(const TinkerConstraints *constraints, int32_t row);
/* Finds which rows hold nothing and how many depend on others, at the rows evaluated last. */
void tinker_constraints_find_redundant(TinkerModel *model);
/* How many rows depend on others, at the rows evaluated last. */
int32_t tinker_constraints_count_dependent(TinkerModel *model);
/* Adds the power that moving supports and prescribed rows give through the constraints to model->book_power, with the
 * lambda solved last. */
void tinker_constraints_add_power(TinkerModel *model);
void tinker_constraints_clear(TinkerConstraints *constraints);

#endif

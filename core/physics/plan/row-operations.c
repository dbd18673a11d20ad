/* Counted like the rest of a run (operations.c). A chain of rods, or of bodies that pins tie, has a factor of its own
 * size; other rows take what the pattern of theirs does. */
#include "physics/plan/row-operations.h"

#include "numerics/solve/sparse-ldl.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/model-data.h"

/* Jacobian, factor, solve, a row; along a chain of rods, and of bodies that pins tie. */
#define PER_ROD_ROW 45.0
#define PER_PIN_ROW 110.0
/* Of rows that are solved by the general factor. */
#define PER_JACOBIAN 48.0 /* a row, by itself */
#define PER_PRODUCT  4.0  /* an entry's with another's */
#define PER_UPDATE   3.0  /* what a column takes off another of the factor */
#define PER_FILL     16.0 /* an entry of the factor, in each round of a solve */
#define PER_ENTRY    8.0  /* an entry of the Jacobian, likewise */
/* Solves within a run take fewer rounds than one for any motion; refining many rows adds a share of them. */
#define ROUNDS_WITHIN  0.6
#define REFINED_ROUNDS 1.5
/* Bringing a step back onto constraint rows, and each Newton step for it. Of a chain, a row, whose factor is at hand;
 * of other rows this share of evaluating them. */
#define PER_ROD_PROJECTION 55.0
#define PER_ROD_CORRECTION 30.0
#define PER_PIN_PROJECTION 20.0
#define PER_PIN_CORRECTION 85.0
#define PROJECTION         0.5
#define CORRECTION         1.0

/* Of the rounds of one solve beside the first. */
static double more_rounds(const TinkerConstraints *all)
{
    return ROUNDS_WITHIN * all->rounds * (all->rows < TINKER_REFINED_ROWS ? 1 : REFINED_ROUNDS);
}

/* Operations that rows take for once which their plugins are asked for. */
static double asked_rows(const TinkerConstraints *all)
{
    double called = 0;
    for (guint i = 0; all->rows > 0 && i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (part->distances == NULL && !part->coincident) called += TINKER_OPERATIONS_ASKED * part->batch->count;
    }
    return called;
}

/* Whether rows cost what those of a chain of rods do: each is of one or two points, and their factor has no fill. */
static gboolean are_of_rods(const TinkerConstraints *all)
{
    if (all->chains != NULL || all->rows == 0) return TRUE;
    return all->pin_chains == NULL && all->turn_count == 0 && all->entries <= 2 * all->rows &&
           tinker_sparse_ldl_fill(all->ldl) <= (gsize)all->rows;
}

double tinker_row_operations(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    const double called = asked_rows(all);
    if (are_of_rods(all)) return called + PER_ROD_ROW * all->rows;
    if (all->pin_chains != NULL) return called + PER_PIN_ROW * all->rows;
    const double products = (double)(all->product_count + all->turn_product_count),
                 updates = (double)tinker_sparse_ldl_updates(all->ldl), fill = (double)tinker_sparse_ldl_fill(all->ldl);
    return called + PER_JACOBIAN * all->rows + PER_PRODUCT * products + PER_UPDATE * updates +
           (1 + more_rounds(all)) * (PER_FILL * fill + PER_ENTRY * (all->entries + all->turn_count));
}

double tinker_row_operations_of_correction(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (are_of_rods(all)) return asked_rows(all) + PER_ROD_CORRECTION * all->rows;
    if (all->pin_chains != NULL) return asked_rows(all) + PER_PIN_CORRECTION * all->rows;
    return CORRECTION * tinker_row_operations(model);
}

double tinker_row_operations_of_projection(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (are_of_rods(all)) return asked_rows(all) + PER_ROD_PROJECTION * all->rows;
    if (all->pin_chains != NULL) return asked_rows(all) + PER_PIN_PROJECTION * all->rows;
    return PROJECTION * tinker_row_operations(model);
}

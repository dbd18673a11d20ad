/* Rows that hold nothing: a weld of a mass, which has no angle, has a row for the angle all the same. Such a row is 0
 * in everything that is solved and depends on no other; with 1 on the diagonal of S its multiplier is 0. */
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/model/model-data.h"

static gboolean is_zero(const TinkerConstraints *all, int32_t row)
{
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
        if (all->jacobian[2 * e] != 0 || all->jacobian[2 * e + 1] != 0) return FALSE;
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++)
        if (all->jacobian[2 * all->entries + k] != 0) return FALSE;
    return all->g[row] == 0 && all->drift[row] == 0;
}

/* What depends on angles says nothing of ends that have none; any other row that is 0 may be so here alone. */
static void find_idle_rows(TinkerConstraints *all)
{
    all->idle_count = 0;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (part->angles == NULL || part->constraint->unilateral != 0) continue;
        for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++)
            if (is_zero(all, row))
                all->idle[all->idle_count++] = (TinkerIdleRow){row, tinker_sparse_ldl_slot(all->ldl, row, row)};
    }
}

gboolean tinker_constraints_is_idle(const TinkerConstraints *all, int32_t row)
{
    for (int32_t i = 0; i < all->idle_count; i++)
        if (all->idle[i].row == row) return TRUE;
    return FALSE;
}

static int32_t count_repeated(const TinkerConstraints *all)
{
    int32_t count = 0;
    for (int32_t i = 0; i < all->repeated_count; i++)
        count += !tinker_constraints_is_idle(all, all->repeated[i].row);
    return count;
}

void tinker_constraints_find_redundant(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    find_idle_rows(all);
    const int32_t dependent = tinker_constraints_count_dependent(model);
    all->dependent = MAX(dependent, all->fitted);
    all->redundant = MAX(dependent + count_repeated(all), all->fitted);
}

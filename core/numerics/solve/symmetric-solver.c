/* Where each entry of the pattern goes is worked out once; an off-diagonal entry and its mirror image meet in one
 * place, each with half its value, which leaves the symmetric part. */
#include "numerics/solve/symmetric-solver.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/banded-ldl.h"
#include "numerics/solve/narrow-band.h"
#include "numerics/solve/sparse-ldl.h"

/* Up to this half bandwidth a band is solved faster than a list of entries that are looked up. */
#define WIDEST_BAND 12

struct _TinkerSymmetricSolver {
    const TinkerPattern *pattern;
    TinkerSolverKind kind;
    int32_t *place;
    gboolean in_order; /* every row is at its own place */
    TinkerBandedLdl band;
    TinkerSparseLdl *sparse;
    double **target; /* of each entry */
    double *ordered; /* b in the order of the band */
};

static double *band_target(TinkerSymmetricSolver *self, int32_t row, int32_t column)
{
    int32_t i = MAX(self->place[row], self->place[column]), j = MIN(self->place[row], self->place[column]);
    if (i == j) return &self->band.pivots[i];
    return &self->band.rows[(gsize)i * (gsize)self->band.width + (gsize)(j - i + self->band.width)];
}

static double *sparse_target(TinkerSymmetricSolver *self, int32_t row, int32_t column)
{
    return tinker_sparse_ldl_values(self->sparse) + tinker_sparse_ldl_slot(self->sparse, row, column);
}

static TinkerSparseLdl *new_sparse(const TinkerPattern *pattern)
{
    g_autofree int *rows = g_new(int, MAX(pattern->entries, 1)), *columns = g_new(int, MAX(pattern->entries, 1));
    gsize count = 0;
    for (int32_t row = 0; row < pattern->size; row++)
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++) {
            if (pattern->columns[k] >= row) continue;
            rows[count] = row;
            columns[count++] = pattern->columns[k];
        }
    return tinker_sparse_ldl_new(pattern->size, rows, columns, count);
}

static void find_targets(TinkerSymmetricSolver *self)
{
    const TinkerPattern *pattern = self->pattern;
    self->target = g_new(double *, MAX(pattern->entries, 1));
    for (int32_t row = 0; row < pattern->size; row++)
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++)
            self->target[k] = self->kind == TINKER_SOLVER_BANDED ? band_target(self, row, pattern->columns[k])
                                                                 : sparse_target(self, row, pattern->columns[k]);
}

TinkerSymmetricSolver *tinker_symmetric_solver_new(const TinkerPattern *pattern, TinkerSolverKind kind)
{
    TinkerSymmetricSolver *self = g_new0(TinkerSymmetricSolver, 1);
    int32_t n = pattern->size;
    self->pattern = pattern;
    self->place = g_new0(int32_t, MAX(n, 1));
    int32_t width = tinker_narrow_band(pattern, self->place);
    self->in_order = TRUE;
    for (int32_t i = 0; i < n; i++)
        self->in_order &= self->place[i] == i;
    if (kind == TINKER_SOLVER_FITTING) kind = width <= WIDEST_BAND ? TINKER_SOLVER_BANDED : TINKER_SOLVER_SPARSE;
    self->kind = kind;
    if (kind == TINKER_SOLVER_BANDED) {
        tinker_banded_ldl_init(&self->band, n, width);
        self->ordered = g_new0(double, MAX(n, 1));
    } else {
        self->sparse = new_sparse(pattern);
        if (self->sparse == NULL) {
            tinker_symmetric_solver_free(self);
            return NULL;
        }
    }
    find_targets(self);
    return self;
}

void tinker_symmetric_solver_free(TinkerSymmetricSolver *self)
{
    if (self == NULL) return;
    tinker_banded_ldl_clear(&self->band);
    tinker_sparse_ldl_free(self->sparse);
    g_free(self->place);
    g_free(self->target);
    g_free(self->ordered);
    g_free(self);
}

TinkerSolverKind tinker_symmetric_solver_kind(const TinkerSymmetricSolver *self)
{
    return self->kind;
}

gboolean tinker_symmetric_solver_factor(TinkerSymmetricSolver *self, const double *values)
{
    const TinkerPattern *pattern = self->pattern;
    if (self->kind == TINKER_SOLVER_BANDED)
        tinker_banded_ldl_reset(&self->band);
    else
        tinker_sparse_ldl_clear(self->sparse);
    for (int32_t row = 0; row < pattern->size; row++)
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++)
            *self->target[k] += pattern->columns[k] == row ? values[k] : 0.5 * values[k];
    if (self->kind == TINKER_SOLVER_BANDED) return tinker_banded_ldl_factor(&self->band);
    /* negative pivots pass: whoever iterates checks residuals */
    return tinker_sparse_ldl_factor(self->sparse, 0.0, -HUGE_VAL);
}

void tinker_symmetric_solver_solve(TinkerSymmetricSolver *self, double *b)
{
    if (self->kind == TINKER_SOLVER_SPARSE) {
        tinker_sparse_ldl_solve(self->sparse, b);
        return;
    }
    if (self->in_order) {
        tinker_banded_ldl_solve(&self->band, b);
        return;
    }
    int32_t n = self->pattern->size;
    for (int32_t i = 0; i < n; i++)
        self->ordered[self->place[i]] = b[i];
    tinker_banded_ldl_solve(&self->band, self->ordered);
    for (int32_t i = 0; i < n; i++)
        b[i] = self->ordered[self->place[i]];
}

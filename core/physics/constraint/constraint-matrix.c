/* S = J M^-1 J^T of constraint rows, and its factor. */
#include <math.h>
#include <string.h>

#include "numerics/solve/lapack.h"
#include "numerics/solve/rank.h"
#include "physics/constraint/constraints-private.h"
#include "physics/constraint/tolerances.h"

static void assemble(TinkerConstraints *all)
{
    tinker_sparse_ldl_clear(all->ldl);
    double *restrict values = tinker_sparse_ldl_values(all->ldl);
    const double *restrict j = all->jacobian;
    const TinkerProduct *restrict p = all->products;
    const TinkerProduct *end = p + all->product_count;
    while (p < end) {
        int32_t slot = p->slot;
        double sum = 0;
        do {
            const double *first = j + 2 * p->first_entry, *second = j + 2 * p->second_entry;
            sum += p->inverse_mass * (first[0] * second[0] + first[1] * second[1]);
        } while (++p < end && p->slot == slot);
        values[slot] = sum;
    }
    for (gsize i = 0; i < all->turn_product_count; i++) {
        const TinkerProduct *turn = &all->turn_products[i];
        values[turn->slot] += turn->inverse_mass * j[turn->first_entry] * j[turn->second_entry];
    }
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->slack[row]) values[all->diagonal[row]] = 1.0;
    for (int32_t i = 0; i < all->idle_count; i++)
        if (values[all->idle[i].slot] == 0) values[all->idle[i].slot] = 1.0;
    for (int32_t i = 0; i < all->repeated_count; i++)
        values[all->repeated[i].slot] = 1.0;
    for (int32_t k = 0; k < all->hub_entry_count; k++)
        values[all->hub_entries[k].slot] += j[all->hub_entries[k].entry];
    for (int32_t k = 0; k < all->border; k++)
        values[all->hub_masses[k].slot] = -all->hub_masses[k].mass;
}

static double mean_diagonal(const TinkerConstraints *all)
{
    double sum = 0;
    const double *j = all->jacobian;
    const TinkerProduct *products = all->products;
    for (gsize i = 0; i < all->product_count; i++) {
        const TinkerProduct *p = &products[i];
        const double *at = j + 2 * p->first_entry;
        if (p->first_entry == p->second_entry) sum += p->inverse_mass * (at[0] * at[0] + at[1] * at[1]);
    }
    for (gsize i = 0; i < all->turn_product_count; i++) {
        const TinkerProduct *p = &all->turn_products[i];
        if (p->first_entry == p->second_entry) sum += p->inverse_mass * j[p->first_entry] * j[p->first_entry];
    }
    for (int32_t k = 0; k < all->hub_entry_count; k++) {
        const TinkerHubEntry *of = &all->hub_entries[k];
        sum += j[of->entry] * j[of->entry] / all->hub_masses[of->unknown - all->rows].mass;
    }
    return sum / (all->rows - all->repeated_count);
}

gboolean tinker_constraints_are_factored(const TinkerConstraints *all)
{
    if (!all->factored || all->keeps_factored) return all->factored;
    if (all->jacobian[0] != all->factored_jacobian[0]) return FALSE;
    return memcmp(all->jacobian, all->factored_jacobian, all->jacobian_size * sizeof(double)) == 0;
}

/* Masses may differ so much that one shift for all rows drowns those of the heavy ones. Then every row is shifted by a
 * share of its own diagonal: the solution is the same motion, of least norm with the multipliers weighed by that.
 * Answers what is left to be added to all of them, which is no more than the least row's share; `evenly`: no row was
 * shifted by itself. */
static double shift_rows(TinkerConstraints *all, gboolean *evenly)
{
    double *values = tinker_sparse_ldl_values(all->ldl), least = INFINITY, greatest = 0;
    const TinkerProduct *products = all->products;
    for (gsize i = 0; i < all->product_count; i++) {
        if (products[i].first_entry != products[i].second_entry) continue;
        least = MIN(least, values[products[i].slot]);
        greatest = MAX(greatest, values[products[i].slot]);
    }
    *evenly = !(greatest > TINKER_EVEN_ROWS * least);
    if (*evenly) return all->shift * mean_diagonal(all);
    int32_t last = -1;
    for (gsize i = 0; i < all->product_count; i++) {
        if (products[i].first_entry != products[i].second_entry || products[i].slot == last) continue;
        last = products[i].slot;
        values[last] *= 1 + all->shift;
    }
    return all->shift * least;
}

/* Of a row that others repeat only its share of what all of them would be shifted by: the norm of the multipliers is
 * that of all of them. */
static void share_shift(TinkerConstraints *all, double shift, gboolean evenly)
{
    double *values = tinker_sparse_ldl_values(all->ldl);
    int32_t last = -1;
    for (int32_t i = 0; i < all->repeated_count; i++) {
        const TinkerRepeatedRow *of = &all->repeated[i];
        if (of->first == last) continue;
        last = of->first;
        if (evenly)
            values[of->first_slot] -= shift * (1 - 1.0 / of->copies);
        else
            values[of->first_slot] *= (1 + all->shift / of->copies) / (1 + all->shift);
    }
}

void tinker_constraints_factor_shifted(TinkerConstraints *all)
{
    assemble(all);
    gboolean evenly;
    double shift = shift_rows(all, &evenly);
    /* Rows between supports alone have no diagonal at all: the shift stands for all of it. */
    if (!(shift > 0)) shift = 1.0;
    share_shift(all, shift, evenly);
    all->shifted = TRUE;
    tinker_sparse_ldl_factor(all->ldl, shift, 0.0);
}

gboolean tinker_constraints_factor_and_solve(TinkerConstraints *all, double *b)
{
    gsize bytes = (gsize)all->rows * sizeof(double);
    all->factored = TRUE;
    all->shifted = FALSE;
    all->keeps_factored = TRUE;
    if (!tinker_constraints_are_proximal(all)) {
        memcpy(all->residual, b, bytes);
        assemble(all);
        if (tinker_sparse_ldl_factor_and_solve(all->ldl, TINKER_DEPENDENT, b)) return TRUE;
        memcpy(b, all->residual, bytes);
    }
    tinker_constraints_factor_shifted(all);
    return FALSE;
}

void tinker_constraints_substitute(TinkerConstraints *all, double *b)
{
    if (all->border == 0) {
        tinker_sparse_ldl_solve(all->ldl, b);
        return;
    }
    const gsize bytes = (gsize)all->rows * sizeof(double);
    memcpy(all->bordered, b, bytes);
    memset(all->bordered + all->rows, 0, (gsize)all->border * sizeof(double));
    tinker_sparse_ldl_solve(all->ldl, all->bordered);
    memcpy(b, all->bordered, bytes);
}

/* How many of the rows that are dependent without their hubs are not with them: of what they have there, the rank. */
static int32_t rank_on_hubs(const TinkerConstraints *all)
{
    const gsize n = (gsize)all->border;
    g_autofree double *products = g_new0(double, n *n), *values = g_new0(double, n);
    int32_t rank = 0;
    tinker_sparse_ldl_left_out(all->ldl, products);
    for (gsize i = 0; i < n * n; i++)
        products[i] /= sqrt(all->hub_masses[i / n].mass * all->hub_masses[i % n].mass);
    if (!tinker_eigen_symmetric((int32_t)n, products, values)) return 0;
    for (gsize i = 0; i < n; i++)
        rank += values[i] > TINKER_DEPENDENT * values[n - 1];
    return rank;
}

int32_t tinker_constraints_count_dependent(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    assemble(all);
    all->factored = all->keeps_factored = FALSE;
    const int32_t count = tinker_sparse_ldl_count_dependent(all->ldl, TINKER_DEPENDENT, NULL);
    return count == 0 || all->border == 0 ? count : count - rank_on_hubs(all);
}

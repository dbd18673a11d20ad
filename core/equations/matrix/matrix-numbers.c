/* The rest of a matrix form. */
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "equations/matrix/matrix-private.h"
#include "law/derivative.h"

/* A matrix whose inverse is larger than this share of it is singular. */
#define SINGULAR 1e-13
#define SOLVE    4 /* roundings of a solve, in units of the last place of the largest number */

typedef struct {
    const TinkerEquations *equations;
    double *numbers;
    guint n;
} Numbers;

static void put_number(guint row, guint column, const TinkerExpression *entry, void *data)
{
    const Numbers *self = data;
    self->numbers[row * self->n + column] = tinker_equations_value(self->equations, entry);
}

double *tinker_matrix_numbers(const TinkerEquations *equations, const TinkerMatrixIsland *island, TinkerMatrixKind kind)
{
    const guint n = island->coordinates->len;
    Numbers self = {equations, g_new0(double, (gsize)n *n), n};
    tinker_matrix_each(island, kind, put_number, &self);
    return self.numbers;
}

/* Functions of time alone, which have names. */
static gboolean varies(const TinkerEquations *equations, const char *symbol)
{
    if (tinker_equations_is_not_written(equations, symbol)) return TRUE;
    const TinkerEquationDefinition *definition = tinker_equations_definition(equations, symbol);
    return definition != NULL && tinker_expression_uses(definition->is, "t");
}

typedef struct {
    const TinkerEquations *equations;
} Rest;

static TinkerExpression *definition_or_zero(const char *symbol, void *data)
{
    const Rest *rest = data;
    if (varies(rest->equations, symbol)) return tinker_expression_number(0);
    const TinkerEquationDefinition *definition = tinker_equations_definition(rest->equations, symbol);
    return definition != NULL ? tinker_expression_replace(definition->is, definition_or_zero, data) : NULL;
}

/* Through definitions, of which those that vary are symbols themselves. */
typedef struct {
    const TinkerEquations *equations;
    const char *by;
} Slope;

static TinkerExpression *slope_of(const char *symbol, void *data)
{
    const Slope *slope = data;
    if (strcmp(symbol, slope->by) == 0) return tinker_expression_number(1);
    if (varies(slope->equations, symbol)) return NULL;
    const TinkerEquationDefinition *definition = tinker_equations_definition(slope->equations, symbol);
    return definition != NULL ? tinker_expression_derivative(definition->is, slope_of, data) : NULL;
}

/* A load's part that is linear in a function of time, added to a sum, which is used up. */
static TinkerExpression *plus_part(TinkerExpression *sum, const TinkerEquations *equations,
                                   const TinkerExpression *load, const char *symbol)
{
    Slope slope = {equations, symbol};
    TinkerExpression *factor = tinker_expression_derivative(load, slope_of, &slope);
    return tinker_expression_plus(sum, tinker_expression_times(factor, tinker_expression_symbol(symbol)));
}

/* What varies of a load: linear in the functions of time. (transfer full) */
static TinkerExpression *varying_part(const TinkerEquations *equations, const TinkerExpression *load)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (guint i = 0; i < equations->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i);
        if (tinker_expression_uses(definition->is, "t")) sum = plus_part(sum, equations, load, definition->name);
    }
    for (guint i = 0; i < equations->not_written->len; i++) {
        const TinkerNotWritten *missing = g_ptr_array_index(equations->not_written, i);
        for (guint k = 0; k < missing->symbols->len; k++)
            sum = plus_part(sum, equations, load, g_ptr_array_index(missing->symbols, k));
    }
    return sum;
}

void tinker_matrix_count_from_rest(const TinkerEquations *equations, TinkerMatrixIsland *island)
{
    const lapack_int n = (lapack_int)island->coordinates->len;
    g_autofree double *k = tinker_matrix_numbers(equations, island, TINKER_MATRIX_STIFFNESS),
                      *rest = g_new(double, 2 * n);
    double *rounding = rest + n, farthest = 0;
    g_autofree lapack_int *pivots = g_new(lapack_int, n);
    Rest question = {equations};
    double largest = 0;
    for (lapack_int i = 0; i < n * n; i++)
        largest = fmax(largest, fabs(k[i]));
    for (lapack_int i = 0; i < n; i++) {
        g_autoptr(TinkerExpression) constant =
            tinker_expression_replace(g_ptr_array_index(island->load, i), definition_or_zero, &question);
        rest[i] = tinker_equations_value(equations, constant);
        rounding[i] = tinker_equations_rounding(equations, constant);
    }
    if (largest == 0 || LAPACKE_dgetrf(LAPACK_ROW_MAJOR, n, n, k, n, pivots) != 0) return;
    for (lapack_int i = 0; i < n; i++)
        if (fabs(k[i * n + i]) <= SINGULAR * largest) return;
    LAPACKE_dgetrs(LAPACK_ROW_MAJOR, 'N', n, 1, k, n, pivots, rest, 1);
    LAPACKE_dgetrs(LAPACK_ROW_MAJOR, 'N', n, 1, k, n, pivots, rounding, 1);
    for (lapack_int i = 0; i < n; i++)
        farthest = fmax(farthest, fabs(rest[i]));
    island->about_rest = TRUE;
    for (lapack_int i = 0; i < n; i++) {
        TinkerMatrixCoordinate *coordinate = &g_array_index(island->coordinates, TinkerMatrixCoordinate, i);
        coordinate->about = rest[i];
        coordinate->rounding = SOLVE * DBL_EPSILON * farthest + fabs(rounding[i]);
        TinkerExpression *varying = varying_part(equations, g_ptr_array_index(island->load, i));
        tinker_expression_unref(g_ptr_array_index(island->load, i));
        island->load->pdata[i] = varying;
    }
}

/* Islands of a plan as matrices: which can be, in which coordinates, and for which there are numbers. */
#include "equations/matrix/matrix.h"

#include <float.h>
#include <math.h>

#include "equations/matrix/matrix-entries.h"
#include "equations/matrix/matrix-private.h"

#define MOST_DENSE     64    /* coordinates; matrices of more have those entries alone that are not 0, and ... */
#define MOST_ROOTS     256   /* ... up to so many have their roots, */
#define MOST_SYMMETRIC 512   /* without damping */
#define MOST_SPARSE    50000 /* the numbers of their entries are 32 bits wide */
#define ROUNDING       (4 * DBL_EPSILON) /* of a unit vector */

static const char too_many[] = "it has too many coordinates to be written out (256 can be, or 512 without dampers)";

static GPtrArray *zeros(guint count)
{
    GPtrArray *entries = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
    for (guint i = 0; i < count; i++)
        g_ptr_array_add(entries, tinker_expression_number(0));
    return entries;
}

static void coordinate_clear(void *data)
{
    TinkerMatrixCoordinate *coordinate = data;
    g_free(coordinate->symbol);
    tinker_expression_unref(coordinate->is);
}

static void island_free(void *data)
{
    TinkerMatrixIsland *island = data;
    for (int kind = 0; kind < TINKER_MATRICES; kind++) {
        g_clear_pointer(&island->matrices[kind], g_ptr_array_unref);
        g_clear_pointer(&island->sparse[kind], g_hash_table_unref);
    }
    g_clear_pointer(&island->load, g_ptr_array_unref);
    g_array_unref(island->blocks);
    g_array_unref(island->coordinates);
    g_free(island->omega);
    g_free(island->zeta);
    g_free(island->decay);
    g_free(island->unstable);
    g_free(island);
}

/* A direction along an axis has no share of the other. */
static double without_rounding(double component, double other)
{
    if (fabs(component) <= ROUNDING) return 0;
    return fabs(other) <= ROUNDING ? copysign(1, component) : component;
}

/* The coordinates of an island: one a body along its line, or two in the plane where nothing ties it. */
static void choose_coordinates(TinkerMatrixBuilder *builder, const TinkerIslandPlan *plan)
{
    for (guint i = 0; i < plan->blocks->len; i++) {
        const TinkerBlockId block = g_array_index(plan->blocks, TinkerBlockId, i);
        if (tinker_matrix_equation_of(builder, block) == NULL) continue;
        if (plan->straight) {
            const double ux = plan->direction[0], uy = plan->direction[1];
            tinker_matrix_add_coordinate(builder, block, without_rounding(ux, uy), without_rounding(uy, ux));
            continue;
        }
        tinker_matrix_add_coordinate(builder, block, 1, 0);
        tinker_matrix_add_coordinate(builder, block, 0, 1);
    }
}

/* Matrices of zeros; FALSE with the reason where there are too many coordinates. */
static gboolean allot(TinkerMatrixBuilder *builder)
{
    const guint n = builder->island->coordinates->len;
    if (n == 0 || n > MOST_SPARSE) {
        builder->why = too_many;
        return FALSE;
    }
    if (n > MOST_DENSE) {
        tinker_matrix_sparse_init(builder->island);
    } else {
        for (int kind = 0; kind < TINKER_MATRICES; kind++)
            builder->island->matrices[kind] = zeros(n * n);
    }
    builder->island->load = zeros(n);
    return TRUE;
}

static gboolean write_shafts(TinkerMatrixBuilder *builder)
{
    g_autoptr(GArray) shafts = tinker_matrix_shafts(builder);
    if (builder->why != NULL || !allot(builder)) return FALSE;
    tinker_matrix_add_shafts(builder, shafts);
    return builder->why == NULL;
}

/* FALSE with the reason where it has no such form. */
static gboolean write_island(TinkerMatrixBuilder *builder, const TinkerIslandPlan *plan)
{
    gboolean connected = FALSE;
    if (!plan->linear) {
        builder->why = "it is not linear, or not in a way that the plan knows";
        return FALSE;
    }
    if (plan->shafts) return write_shafts(builder);
    choose_coordinates(builder, plan);
    if (!allot(builder)) return FALSE;
    for (guint i = 0; i < builder->island->coordinates->len; i++)
        tinker_matrix_add_body(builder, i);
    for (guint i = 0; i < builder->equations->lines->len; i++) {
        const TinkerLineEquation *line = g_ptr_array_index(builder->equations->lines, i);
        connected = connected || tinker_matrix_coordinate_of(builder, line->ends[0]) >= 0 ||
                    tinker_matrix_coordinate_of(builder, line->ends[1]) >= 0;
        tinker_matrix_add_pull(builder, line, 0);
        tinker_matrix_add_pull(builder, line, 1);
    }
    if (connected && !plan->straight) builder->why = "it is linear in the plane, not along one line";
    return builder->why == NULL;
}

static void add_reason(TinkerMatrixForm *form, const TinkerIslandPlan *plan, const char *why)
{
    TinkerNotWritten *reason = g_new(TinkerNotWritten, 1);
    const TinkerBlockId first = plan->blocks->len > 0 ? g_array_index(plan->blocks, TinkerBlockId, 0) : -1;
    *reason = (TinkerNotWritten){first, NULL, g_strdup(why)};
    g_ptr_array_add(form->why, reason);
}

static void reason_free(void *data)
{
    g_free(((TinkerNotWritten *)data)->why);
    g_free(data);
}

/* Whether an island is small enough for its numbers. */
static gboolean has_numbers(const TinkerEquations *equations, const TinkerMatrixIsland *island, gboolean all_numbers)
{
    const guint n = island->coordinates->len;
    if (island->sparse[0] == NULL) return TRUE;
    if (!all_numbers) return FALSE;
    return n <= MOST_ROOTS || (n <= MOST_SYMMETRIC && tinker_matrix_is_symmetric(equations, island));
}

TinkerMatrixForm *tinker_matrix_form_new(const TinkerEquations *equations, const TinkerPlan *plan, gboolean all_numbers)
{
    TinkerMatrixForm *form = g_new(TinkerMatrixForm, 1);
    *form = (TinkerMatrixForm){g_ptr_array_new_with_free_func(island_free), g_ptr_array_new_with_free_func(island_free),
                               g_ptr_array_new_with_free_func(reason_free)};
    for (guint i = 0; i < plan->islands->len; i++) {
        const TinkerIslandPlan *each = g_ptr_array_index(plan->islands, i);
        TinkerMatrixIsland *island = g_new0(TinkerMatrixIsland, 1);
        island->blocks = g_array_copy(each->blocks);
        island->coordinates = g_array_new(FALSE, TRUE, sizeof(TinkerMatrixCoordinate));
        g_array_set_clear_func(island->coordinates, coordinate_clear);
        TinkerMatrixBuilder builder = {equations, island, NULL};
        const gboolean written = write_island(&builder, each);
        if (written && !has_numbers(equations, island, all_numbers)) {
            add_reason(form, each, too_many);
            g_ptr_array_add(form->large, island);
        } else if (written) {
            tinker_matrix_count_from_rest(equations, island);
            tinker_matrix_roots(equations, island);
            g_ptr_array_add(form->islands, island);
        } else {
            add_reason(form, each, builder.why);
            island_free(island);
        }
    }
    return form;
}

void tinker_matrix_form_free(TinkerMatrixForm *form)
{
    g_ptr_array_unref(form->islands);
    g_ptr_array_unref(form->large);
    g_ptr_array_unref(form->why);
    g_free(form);
}

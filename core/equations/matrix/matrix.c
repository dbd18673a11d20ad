/* Matrices from the equations: what depends on places and velocities is linear in them, so their derivatives are the
 * entries, and what is left at 0 is the load. A connector along the line of motion has L = s (q_b - q_a) with the sign
 * s of now: its tension T0 + k L + c dL/dt becomes s T0 + k (q_b - q_a) + c (v_b - v_a). */
#include "equations/matrix/matrix.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "equations/matrix/matrix-private.h"
#include "law/derivative.h"

#define MOST_DENSE     64    /* coordinates; matrices of more have those entries alone that are not 0, and ... */
#define MOST_ROOTS     256   /* ... up to so many have their roots, */
#define MOST_SYMMETRIC 512   /* without damping */
#define MOST_SPARSE    50000 /* the numbers of their entries are 32 bits wide */
#define ROUNDING       (4 * DBL_EPSILON) /* of a unit vector */

static const char too_many[] = "it has too many coordinates to be written out (256 can be, or 512 without dampers)";

typedef struct {
    const TinkerEquations *equations;
    TinkerMatrixIsland *island;
    const char *why; /* it cannot be written; NULL so far */
} Builder;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static guint size_of(const Builder *builder)
{
    return builder->island->coordinates->len;
}

static const TinkerMatrixCoordinate *coordinate_at(const Builder *builder, guint number)
{
    return &g_array_index(builder->island->coordinates, TinkerMatrixCoordinate, number);
}

/* Adds to an entry; uses the expression up. */
static void add(Builder *builder, TinkerMatrixKind kind, guint number, TinkerExpression *more)
{
    TinkerMatrixIsland *island = builder->island;
    GPtrArray *const matrices[] = {island->mass, island->damping, island->stiffness};
    if (island->sparse[kind] != NULL)
        tinker_matrix_sparse_add(island, kind, number, more);
    else
        matrices[kind]->pdata[number] = tinker_expression_plus(matrices[kind]->pdata[number], more);
}

static void add_load(Builder *builder, guint number, TinkerExpression *more)
{
    GPtrArray *load = builder->island->load;
    load->pdata[number] = tinker_expression_plus(load->pdata[number], more);
}

/* u . (x, y) */
static TinkerExpression *along(const double direction[2], const TinkerExpression *x, const TinkerExpression *y)
{
    return tinker_expression_plus(tinker_expression_times(tinker_expression_number(direction[0]), copy(x)),
                                  tinker_expression_times(tinker_expression_number(direction[1]), copy(y)));
}

static TinkerExpression *state_symbol(const Builder *builder, TinkerBlockId body, const char *quantity)
{
    g_autofree char *name = g_strconcat(tinker_scene_block_name(builder->equations->scene, body), ".", quantity, NULL);
    return tinker_expression_symbol(name);
}

static void add_coordinate(Builder *builder, TinkerBlockId body, double ux, double uy)
{
    g_autoptr(TinkerExpression) x = state_symbol(builder, body, "x"), y = state_symbol(builder, body, "y");
    TinkerMatrixCoordinate coordinate = {
        .symbol = g_strdup_printf("q_%u", size_of(builder) + 1), .body = body, .direction = {ux, uy}};
    coordinate.is = along(coordinate.direction, x, y);
    g_array_append_val(builder->island->coordinates, coordinate);
}

/* Definitions written out, so that an expression speaks of the state itself. */
static TinkerExpression *definition_of(const char *symbol, void *data)
{
    const Builder *builder = data;
    const TinkerEquationDefinition *definition = tinker_equations_definition(builder->equations, symbol);
    /* functions of time alone keep their names */
    if (definition == NULL || tinker_expression_uses(definition->is, "t")) return NULL;
    return tinker_expression_replace(definition->is, definition_of, data);
}

static gboolean is_state(const Builder *builder, const char *symbol)
{
    static const char *const quantities[] = {"x", "y", "vx", "vy", NULL};
    const char *dot = strrchr(symbol, '.');
    if (dot == NULL || !g_strv_contains(quantities, dot + 1)) return FALSE;
    g_autofree char *name = g_strndup(symbol, (gsize)(dot - symbol));
    return tinker_scene_find_block(builder->equations->scene, name) >= 0;
}

static TinkerExpression *zero_of_state(const char *symbol, void *data)
{
    return is_state(data, symbol) ? tinker_expression_number(0) : NULL;
}

static gboolean uses_state(const Builder *builder, const TinkerExpression *expression)
{
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) return is_state(builder, expression->name);
    for (int i = 0; i < expression->count; i++)
        if (uses_state(builder, expression->parts[i])) return TRUE;
    return FALSE;
}

/* Whether an expression names the state of this body. */
static gboolean uses_body(const Builder *builder, const TinkerExpression *expression, TinkerBlockId body)
{
    const char *name = tinker_scene_block_name(builder->equations->scene, body);
    const gsize length = strlen(name);
    if (expression->kind == TINKER_EXPRESSION_SYMBOL)
        return strncmp(expression->name, name, length) == 0 && expression->name[length] == '.';
    for (int i = 0; i < expression->count; i++)
        if (uses_body(builder, expression->parts[i], body)) return TRUE;
    return FALSE;
}

/* Of a force along coordinate i that is linear in the states of single bodies: a field, a motor. */
static void add_term(Builder *builder, guint i, const TinkerTerm *term)
{
    static const char *const quantities[2][2] = {{"x", "y"}, {"vx", "vy"}};
    const guint n = size_of(builder);
    g_autoptr(TinkerExpression) sum = along(coordinate_at(builder, i)->direction, term->x, term->y);
    g_autoptr(TinkerExpression) force = tinker_expression_replace(sum, definition_of, builder);
    for (guint k = 0; k < n; k++) {
        const TinkerMatrixCoordinate *other = coordinate_at(builder, k);
        if (!uses_body(builder, force, other->body)) continue;
        for (int order = 0; order < 2; order++) {
            TinkerExpression *slope = tinker_expression_number(0);
            for (int axis = 0; axis < 2; axis++) {
                g_autoptr(TinkerExpression) symbol = state_symbol(builder, other->body, quantities[order][axis]);
                TinkerExpression *part = tinker_expression_derivative_by(force, symbol->name);
                slope = tinker_expression_plus(
                    slope, tinker_expression_times(tinker_expression_number(other->direction[axis]), part));
            }
            if (uses_state(builder, slope)) builder->why = "a force on it is not linear";
            add(builder, order == 0 ? TINKER_MATRIX_STIFFNESS : TINKER_MATRIX_DAMPING, i * n + k,
                tinker_expression_negated(slope));
        }
    }
    add_load(builder, i, tinker_expression_replace(force, zero_of_state, builder));
}

/* The coordinate of a body; -1 for none. */
static int coordinate_of(const Builder *builder, TinkerBlockId body)
{
    for (guint i = 0; body >= 0 && i < size_of(builder); i++)
        if (coordinate_at(builder, i)->body == body) return (int)i;
    return -1;
}

static TinkerExpression *zero_of_line(const char *symbol, void *data)
{
    const TinkerLineEquation *line = data;
    const gboolean length = strcmp(symbol, line->length->name) == 0;
    const gboolean rate = line->rate != NULL && strcmp(symbol, line->rate->name) == 0;
    return length || rate ? tinker_expression_number(0) : NULL;
}

/* The pull of a connector on the body at one of its ends. */
static void add_pull(Builder *builder, const TinkerLineEquation *line, int end)
{
    const guint n = size_of(builder);
    const int own = coordinate_of(builder, line->ends[end]), other = coordinate_of(builder, line->ends[1 - end]);
    if (own < 0) return;
    const double *direction = coordinate_at(builder, (guint)own)->direction;
    g_autoptr(TinkerExpression) here = along(direction, line->place[end][0], line->place[end][1]),
                                there = along(direction, line->place[1 - end][0], line->place[1 - end][1]),
                                speed = along(direction, line->velocity[1 - end][0], line->velocity[1 - end][1]);
    const double sign =
        tinker_equations_value(builder->equations, there) >= tinker_equations_value(builder->equations, here) ? 1 : -1;
    g_autoptr(TinkerExpression) k = tinker_expression_derivative_by(line->tension, line->length->name);
    g_autoptr(TinkerExpression) c = line->rate != NULL
                                        ? tinker_expression_derivative_by(line->tension, line->rate->name)
                                        : tinker_expression_number(0);
    TinkerExpression *at_zero = tinker_expression_replace(line->tension, zero_of_line, (void *)line);
    static const TinkerMatrixKind matrices[] = {TINKER_MATRIX_STIFFNESS, TINKER_MATRIX_DAMPING};
    const TinkerExpression *const slopes[] = {k, c}, *const moved[] = {there, speed};
    add_load(builder, (guint)own, tinker_expression_times(tinker_expression_number(sign), at_zero));
    for (int order = 0; order < 2; order++) {
        if (tinker_expression_uses(slopes[order], line->length->name)) builder->why = "a connector is not linear";
        add(builder, matrices[order], (guint)own * n + (guint)own, copy(slopes[order]));
        if (other >= 0)
            add(builder, matrices[order], (guint)own * n + (guint)other,
                tinker_expression_negated(copy(slopes[order])));
        else
            add_load(builder, (guint)own, tinker_expression_times(copy(slopes[order]), copy(moved[order])));
    }
}

static const TinkerBodyEquation *equation_of(const Builder *builder, TinkerBlockId body)
{
    for (guint i = 0; i < builder->equations->bodies->len; i++) {
        const TinkerBodyEquation *equation = g_ptr_array_index(builder->equations->bodies, i);
        if (equation->block == body) return equation;
    }
    return NULL;
}

static gboolean is_line(const Builder *builder, TinkerBlockId block)
{
    for (guint i = 0; i < builder->equations->lines->len; i++)
        if (((TinkerLineEquation *)g_ptr_array_index(builder->equations->lines, i))->block == block) return TRUE;
    return FALSE;
}

static void add_body(Builder *builder, guint i)
{
    const TinkerBodyEquation *equation = equation_of(builder, coordinate_at(builder, i)->body);
    add(builder, TINKER_MATRIX_MASS, i * size_of(builder) + i, copy(equation->mass));
    for (guint k = 0; k < equation->terms->len; k++) {
        const TinkerTerm *term = &g_array_index(equation->terms, TinkerTerm, k);
        if (term->kind == TINKER_TERM_CONSTRAINT) builder->why = "a constraint holds it";
        if (term->kind == TINKER_TERM_NORMAL) builder->why = "it lies on something";
        if (!is_line(builder, term->block)) add_term(builder, i, term);
    }
}

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
    GPtrArray *const entries[] = {island->mass, island->damping, island->stiffness, island->load};
    for (gsize i = 0; i < G_N_ELEMENTS(entries); i++)
        if (entries[i] != NULL) g_ptr_array_unref(entries[i]);
    for (int kind = 0; kind < TINKER_MATRICES; kind++)
        g_clear_pointer(&island->sparse[kind], g_hash_table_unref);
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
static void choose_coordinates(Builder *builder, const TinkerIslandPlan *plan)
{
    for (guint i = 0; i < plan->blocks->len; i++) {
        const TinkerBlockId block = g_array_index(plan->blocks, TinkerBlockId, i);
        if (equation_of(builder, block) == NULL) continue;
        if (plan->straight) {
            const double ux = plan->direction[0], uy = plan->direction[1];
            add_coordinate(builder, block, without_rounding(ux, uy), without_rounding(uy, ux));
            continue;
        }
        add_coordinate(builder, block, 1, 0);
        add_coordinate(builder, block, 0, 1);
    }
}

/* FALSE with the reason where it has no such form. */
static gboolean write_island(Builder *builder, const TinkerIslandPlan *plan)
{
    gboolean connected = FALSE;
    if (!plan->linear) {
        builder->why = "it is not linear";
        return FALSE;
    }
    if (plan->shafts) {
        builder->why = "it is linear in the angles of its shafts, not along one line";
        return FALSE;
    }
    choose_coordinates(builder, plan);
    const guint n = size_of(builder);
    if (n == 0 || n > MOST_SPARSE) {
        builder->why = too_many;
        return FALSE;
    }
    if (n > MOST_DENSE) {
        tinker_matrix_sparse_init(builder->island);
    } else {
        builder->island->mass = zeros(n * n);
        builder->island->damping = zeros(n * n);
        builder->island->stiffness = zeros(n * n);
    }
    builder->island->load = zeros(n);
    for (guint i = 0; i < n; i++)
        add_body(builder, i);
    for (guint i = 0; i < builder->equations->lines->len; i++) {
        const TinkerLineEquation *line = g_ptr_array_index(builder->equations->lines, i);
        connected =
            connected || coordinate_of(builder, line->ends[0]) >= 0 || coordinate_of(builder, line->ends[1]) >= 0;
        add_pull(builder, line, 0);
        add_pull(builder, line, 1);
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
        Builder builder = {equations, island, NULL};
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

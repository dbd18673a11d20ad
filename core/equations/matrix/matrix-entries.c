/* What depends on places and velocities is linear in them, so their derivatives are the entries, and what is left at 0
 * is the load. A connector along the line of motion has L = s (q_b - q_a) with the sign s of now: its tension
 * T0 + k L + c dL/dt becomes s T0 + k (q_b - q_a) + c (v_b - v_a). */
#include "equations/matrix/matrix-entries.h"

#include <string.h>

#include "equations/matrix/matrix-private.h"
#include "law/derivative.h"

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static guint size_of(const TinkerMatrixBuilder *builder)
{
    return builder->island->coordinates->len;
}

static const TinkerMatrixCoordinate *coordinate_at(const TinkerMatrixBuilder *builder, guint number)
{
    return &g_array_index(builder->island->coordinates, TinkerMatrixCoordinate, number);
}

void tinker_matrix_add(TinkerMatrixBuilder *builder, TinkerMatrixKind kind, guint row, guint column,
                       TinkerExpression *more)
{
    TinkerMatrixIsland *island = builder->island;
    const guint number = row * island->coordinates->len + column;
    if (island->sparse[kind] != NULL)
        tinker_matrix_sparse_add(island, kind, number, more);
    else
        island->matrices[kind]->pdata[number] = tinker_expression_plus(island->matrices[kind]->pdata[number], more);
}

void tinker_matrix_add_load(TinkerMatrixBuilder *builder, guint number, TinkerExpression *more)
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

TinkerExpression *tinker_matrix_state_symbol(const TinkerMatrixBuilder *builder, TinkerBlockId body,
                                             const char *quantity)
{
    g_autofree char *name = g_strconcat(tinker_scene_block_name(builder->equations->scene, body), ".", quantity, NULL);
    return tinker_expression_symbol(name);
}

void tinker_matrix_add_coordinate(TinkerMatrixBuilder *builder, TinkerBlockId body, double ux, double uy)
{
    g_autoptr(TinkerExpression) x = tinker_matrix_state_symbol(builder, body, "x"),
                                y = tinker_matrix_state_symbol(builder, body, "y");
    TinkerMatrixCoordinate coordinate = {
        .symbol = g_strdup_printf("q_%u", size_of(builder) + 1), .body = body, .direction = {ux, uy}};
    coordinate.is = along(coordinate.direction, x, y);
    g_array_append_val(builder->island->coordinates, coordinate);
}

void tinker_matrix_add_angle(TinkerMatrixBuilder *builder, TinkerBlockId body)
{
    const TinkerMatrixCoordinate coordinate = {.symbol = g_strdup_printf("q_%u", size_of(builder) + 1),
                                               .body = body,
                                               .turning = TRUE,
                                               .is = tinker_matrix_state_symbol(builder, body, "angle")};
    g_array_append_val(builder->island->coordinates, coordinate);
}

static TinkerExpression *definition_of(const char *symbol, void *data)
{
    const TinkerMatrixBuilder *builder = data;
    const TinkerEquationDefinition *definition = tinker_equations_definition(builder->equations, symbol);
    /* functions of time alone keep their names */
    if (definition == NULL || tinker_expression_uses(definition->is, "t")) return NULL;
    return tinker_expression_replace(definition->is, definition_of, data);
}

TinkerExpression *tinker_matrix_written_out(const TinkerMatrixBuilder *builder, const TinkerExpression *expression)
{
    return tinker_expression_replace(expression, definition_of, (void *)builder);
}

static gboolean is_state(const TinkerMatrixBuilder *builder, const char *symbol)
{
    static const char *const quantities[] = {"x", "y", "vx", "vy", "angle", "rate", NULL};
    const char *dot = strrchr(symbol, '.');
    if (dot == NULL || !g_strv_contains(quantities, dot + 1)) return FALSE;
    g_autofree char *name = g_strndup(symbol, (gsize)(dot - symbol));
    return tinker_scene_find_block(builder->equations->scene, name) >= 0;
}

static TinkerExpression *zero_of_state(const char *symbol, void *data)
{
    return is_state(data, symbol) ? tinker_expression_number(0) : NULL;
}

gboolean tinker_matrix_uses_state(const TinkerMatrixBuilder *builder, const TinkerExpression *expression)
{
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) return is_state(builder, expression->name);
    for (int i = 0; i < expression->count; i++)
        if (tinker_matrix_uses_state(builder, expression->parts[i])) return TRUE;
    return FALSE;
}

/* Whether an expression names the state of this body. */
static gboolean uses_body(const TinkerMatrixBuilder *builder, const TinkerExpression *expression, TinkerBlockId body)
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
static void add_term(TinkerMatrixBuilder *builder, guint i, const TinkerTerm *term)
{
    static const char *const quantities[2][2] = {{"x", "y"}, {"vx", "vy"}};
    const guint n = size_of(builder);
    g_autoptr(TinkerExpression) sum = along(coordinate_at(builder, i)->direction, term->x, term->y);
    g_autoptr(TinkerExpression) force = tinker_matrix_written_out(builder, sum);
    for (guint k = 0; k < n; k++) {
        const TinkerMatrixCoordinate *other = coordinate_at(builder, k);
        if (!uses_body(builder, force, other->body)) continue;
        for (int order = 0; order < 2; order++) {
            TinkerExpression *slope = tinker_expression_number(0);
            for (int axis = 0; axis < 2; axis++) {
                g_autoptr(TinkerExpression) symbol =
                    tinker_matrix_state_symbol(builder, other->body, quantities[order][axis]);
                TinkerExpression *part = tinker_expression_derivative_by(force, symbol->name);
                slope = tinker_expression_plus(
                    slope, tinker_expression_times(tinker_expression_number(other->direction[axis]), part));
            }
            if (tinker_matrix_uses_state(builder, slope)) builder->why = "a force on it is not linear";
            tinker_matrix_add(builder, order == 0 ? TINKER_MATRIX_STIFFNESS : TINKER_MATRIX_DAMPING, i, k,
                              tinker_expression_negated(slope));
        }
    }
    tinker_matrix_add_load(builder, i, tinker_expression_replace(force, zero_of_state, builder));
}

int tinker_matrix_coordinate_of(const TinkerMatrixBuilder *builder, TinkerBlockId body)
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

void tinker_matrix_add_pull(TinkerMatrixBuilder *builder, const TinkerLineEquation *line, int end)
{
    const int own = tinker_matrix_coordinate_of(builder, line->ends[end]),
              other = tinker_matrix_coordinate_of(builder, line->ends[1 - end]);
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
    tinker_matrix_add_load(builder, (guint)own, tinker_expression_times(tinker_expression_number(sign), at_zero));
    for (int order = 0; order < 2; order++) {
        if (tinker_expression_uses(slopes[order], line->length->name)) builder->why = "a connector is not linear";
        tinker_matrix_add(builder, matrices[order], (guint)own, (guint)own, copy(slopes[order]));
        if (other >= 0)
            tinker_matrix_add(builder, matrices[order], (guint)own, (guint)other,
                              tinker_expression_negated(copy(slopes[order])));
        else
            tinker_matrix_add_load(builder, (guint)own,
                                   tinker_expression_times(copy(slopes[order]), copy(moved[order])));
    }
}

const TinkerBodyEquation *tinker_matrix_equation_of(const TinkerMatrixBuilder *builder, TinkerBlockId body)
{
    for (guint i = 0; i < builder->equations->bodies->len; i++) {
        const TinkerBodyEquation *equation = g_ptr_array_index(builder->equations->bodies, i);
        if (equation->block == body) return equation;
    }
    return NULL;
}

static gboolean is_line(const TinkerMatrixBuilder *builder, TinkerBlockId block)
{
    for (guint i = 0; i < builder->equations->lines->len; i++)
        if (((TinkerLineEquation *)g_ptr_array_index(builder->equations->lines, i))->block == block) return TRUE;
    return FALSE;
}

void tinker_matrix_add_body(TinkerMatrixBuilder *builder, guint i)
{
    const TinkerBodyEquation *equation = tinker_matrix_equation_of(builder, coordinate_at(builder, i)->body);
    tinker_matrix_add(builder, TINKER_MATRIX_MASS, i, i, copy(equation->mass));
    for (guint k = 0; k < equation->terms->len; k++) {
        const TinkerTerm *term = &g_array_index(equation->terms, TinkerTerm, k);
        if (term->kind == TINKER_TERM_CONSTRAINT) builder->why = "a constraint holds it";
        if (term->kind == TINKER_TERM_NORMAL) builder->why = "it lies on something";
        if (!is_line(builder, term->block)) add_term(builder, i, term);
    }
}

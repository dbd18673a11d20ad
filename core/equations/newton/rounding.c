/* Running error bounds: the value of each node with what the roundings below it and its own can have moved it by
 * (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 3.3). A place is as exact as the scene is wide, an
 * unknown force as the forces on the bodies that it acts on. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"
#include "law/build.h"

/* A solve of linear equations takes some operations a row. */
#define SOLVE 32

typedef struct {
    double value, error;
} Bounded;

static double error_of_symbol(const TinkerEquations *equations, const char *name, double value)
{
    const double *known = g_hash_table_lookup(equations->roundings, name);
    return known != NULL ? *known : DBL_EPSILON * fabs(value);
}

static Bounded bounded(const TinkerEquations *equations, const TinkerExpression *node);

/* By trying: how far the node moves where each of its parts is moved by its error. */
static Bounded of_function(const TinkerExpression *node, const Bounded *parts)
{
    double values[3];
    for (int i = 0; i < node->count; i++)
        values[i] = parts[i].value;
    Bounded found = {tinker_expression_apply(node, values), 0};
    for (int i = 0; i < node->count; i++) {
        double moved = 0;
        for (int sign = -1; sign <= 1; sign += 2) {
            values[i] = parts[i].value + sign * parts[i].error;
            moved = fmax(moved, fabs(tinker_expression_apply(node, values) - found.value));
        }
        values[i] = parts[i].value;
        found.error += moved;
    }
    found.error += DBL_EPSILON * fabs(found.value);
    return found;
}

static Bounded times(Bounded a, Bounded b)
{
    const double value = a.value * b.value;
    return (Bounded){value,
                     fabs(a.value) * b.error + fabs(b.value) * a.error + a.error * b.error + DBL_EPSILON * fabs(value)};
}

static Bounded of_parts(const TinkerEquations *equations, const TinkerExpression *node)
{
    Bounded found = bounded(equations, node->parts[0]);
    for (int i = 1; i < node->count; i++) {
        const Bounded next = bounded(equations, node->parts[i]);
        if (node->kind == TINKER_EXPRESSION_PRODUCT)
            found = times(found, next);
        else
            found = (Bounded){found.value + next.value,
                              found.error + next.error + DBL_EPSILON * (fabs(found.value) + fabs(next.value))};
    }
    return found;
}

static Bounded bounded(const TinkerEquations *equations, const TinkerExpression *node)
{
    Bounded found = {0};
    switch (node->kind) {
    case TINKER_EXPRESSION_NUMBER:
        return (Bounded){node->number, DBL_EPSILON * fabs(node->number)};
    case TINKER_EXPRESSION_SYMBOL:
        found.value = tinker_equations_value(equations, node);
        found.error = error_of_symbol(equations, node->name, found.value);
        return found;
    case TINKER_EXPRESSION_SUM:
    case TINKER_EXPRESSION_PRODUCT:
        return of_parts(equations, node);
    case TINKER_EXPRESSION_NEGATIVE:
        found = bounded(equations, node->parts[0]);
        found.value = -found.value;
        return found;
    default:
        break;
    }
    if (node->kind == TINKER_EXPRESSION_FUNCTION && strcmp(node->name, "if") == 0)
        return bounded(equations, node->parts[tinker_equations_value(equations, node->parts[0]) != 0 ? 1 : 2]);
    Bounded parts[3];
    for (int i = 0; i < node->count; i++)
        parts[i] = bounded(equations, node->parts[i]);
    return of_function(node, parts);
}

double tinker_equations_rounding(const TinkerEquations *equations, const TinkerExpression *expression)
{
    return bounded(equations, expression).error;
}

double tinker_equations_shown_value(const TinkerEquations *equations, const TinkerExpression *expression)
{
    const Bounded found = bounded(equations, expression);
    return fabs(found.value) <= found.error ? 0 : found.value;
}

void tinker_equations_set_rounding(TinkerEquations *equations, const char *name, double rounding)
{
    double *kept = g_new(double, 1);
    *kept = rounding;
    g_hash_table_insert(equations->roundings, g_strdup(name), kept);
}

static void bound_definitions(TinkerEquations *equations)
{
    for (guint i = 0; i < equations->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i);
        tinker_equations_set_rounding(equations, definition->name,
                                      tinker_equations_rounding(equations, definition->is));
    }
}

/* Which of these unknowns an expression has. */
static void find_unknowns(const TinkerExpression *node, GHashTable *unknowns, GHashTable *found)
{
    if (node->kind == TINKER_EXPRESSION_SYMBOL) {
        if (g_hash_table_contains(unknowns, node->name)) g_hash_table_add(found, (gpointer)node->name);
        return;
    }
    for (int i = 0; i < node->count; i++)
        find_unknowns(node->parts[i], unknowns, found);
}

/* Adds the roundings of all forces on a body, or of all moments, to those unknowns that act on it. */
static void add_loads(const TinkerEquations *equations, const TinkerBodyEquation *body, gboolean moment,
                      GHashTable *unknowns)
{
    g_autoptr(GHashTable) acting = g_hash_table_new(g_str_hash, g_str_equal);
    double loads = 0;
    for (guint k = 0; k < body->terms->len; k++) {
        const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
        const TinkerExpression *const parts[] = {term->x, term->y, term->torque};
        for (int n = 0; n < (term->torque != NULL ? 3 : 2); n++) {
            find_unknowns(parts[n], unknowns, acting);
            if ((n == 2) == moment) loads += tinker_equations_rounding(equations, parts[n]);
        }
    }
    GHashTableIter each;
    gpointer name;
    g_hash_table_iter_init(&each, acting);
    while (g_hash_table_iter_next(&each, &name, NULL))
        *(double *)g_hash_table_lookup(unknowns, name) += loads;
}

/* An unknown of a kind, forces or moments, has those of all loads on the bodies that it acts on. */
static void bound_unknowns(TinkerEquations *equations, TinkerDimension dimension, gboolean moment)
{
    g_autoptr(GHashTable) unknowns = g_hash_table_new_full(g_str_hash, g_str_equal, NULL, g_free);
    for (guint i = 0; i < equations->symbols->len; i++) {
        const TinkerEquationSymbol *symbol = g_ptr_array_index(equations->symbols, i);
        if (symbol->quantity != NULL && tinker_dimension_equal(symbol->dimension, dimension))
            g_hash_table_insert(unknowns, symbol->name, g_new0(double, 1));
    }
    for (guint i = 0; i < equations->bodies->len; i++)
        add_loads(equations, g_ptr_array_index(equations->bodies, i), moment, unknowns);
    GHashTableIter each;
    gpointer name, loads;
    g_hash_table_iter_init(&each, unknowns);
    while (g_hash_table_iter_next(&each, &name, &loads))
        tinker_equations_set_rounding(equations, name, SOLVE * *(double *)loads);
}

/* Moments have those of the forces in them, and some definitions those of both. */
void tinker_equations_bound_roundings(TinkerEquations *equations)
{
    bound_definitions(equations);
    bound_unknowns(equations, tinker_force_dimension, FALSE);
    bound_unknowns(equations, tinker_torque_dimension, TRUE);
    bound_definitions(equations);
}

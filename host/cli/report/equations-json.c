/* Equations as JSON: expressions are arrays with the sign or the function in front. */
#include "cli/report/equations-json.h"

#include <cjson/cJSON.h>
#include <math.h>

#include "cli/report/scene-json.h"
#include "units/quantity/units.h"

static cJSON *expression_json(const TinkerExpression *expression)
{
    static const char *const signs[] = {
        [TINKER_EXPRESSION_SUM] = "+",      [TINKER_EXPRESSION_PRODUCT] = "*", [TINKER_EXPRESSION_NEGATIVE] = "-",
        [TINKER_EXPRESSION_QUOTIENT] = "/", [TINKER_EXPRESSION_POWER] = "^",
    };
    if (expression->kind == TINKER_EXPRESSION_NUMBER) return cJSON_CreateNumber(expression->number);
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) return cJSON_CreateString(expression->name);
    cJSON *array = cJSON_CreateArray();
    const char *sign = expression->name != NULL ? expression->name : signs[expression->kind];
    cJSON_AddItemToArray(array, cJSON_CreateString(sign));
    for (int i = 0; i < expression->count; i++)
        cJSON_AddItemToArray(array, expression_json(expression->parts[i]));
    return array;
}

static void add_block(cJSON *object, const TinkerEquations *equations, TinkerBlockId block)
{
    if (block >= 0)
        cJSON_AddStringToObject(object, "block", tinker_scene_block_name(equations->scene, block));
    else
        cJSON_AddNullToObject(object, "block");
}

static gboolean is_wanted(const TinkerBlockId *blocks, TinkerBlockId block)
{
    if (blocks == NULL) return TRUE;
    for (; *blocks >= 0; blocks++)
        if (*blocks == block) return TRUE;
    return FALSE;
}

static cJSON *body_json(const TinkerEquations *equations, const TinkerBodyEquation *body)
{
    cJSON *object = cJSON_CreateObject();
    add_block(object, equations, body->block);
    cJSON_AddItemToObject(object, "mass", expression_json(body->mass));
    if (body->inertia != NULL)
        cJSON_AddItemToObject(object, "inertia", expression_json(body->inertia));
    else
        cJSON_AddNullToObject(object, "inertia");
    cJSON *terms = cJSON_AddArrayToObject(object, "terms");
    for (guint i = 0; i < body->terms->len; i++) {
        const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, i);
        cJSON *each = cJSON_CreateObject();
        add_block(each, equations, term->block);
        cJSON_AddStringToObject(each, "kind", tinker_term_kind_name(term->kind));
        cJSON_AddItemToObject(each, "x", expression_json(term->x));
        cJSON_AddItemToObject(each, "y", expression_json(term->y));
        if (term->torque != NULL)
            cJSON_AddItemToObject(each, "torque", expression_json(term->torque));
        else
            cJSON_AddNullToObject(each, "torque");
        cJSON_AddItemToArray(terms, each);
    }
    return object;
}

static void add_symbols(cJSON *root, const TinkerEquations *equations)
{
    cJSON *symbols = cJSON_AddObjectToObject(root, "symbols");
    for (guint i = 0; i < equations->symbols->len; i++) {
        const TinkerEquationSymbol *symbol = g_ptr_array_index(equations->symbols, i);
        cJSON *object = cJSON_AddObjectToObject(symbols, symbol->name);
        cJSON_AddNumberToObject(object, "value", symbol->value);
        cJSON_AddStringToObject(object, "unit", tinker_equation_unit(symbol->dimension, FALSE));
        add_block(object, equations, symbol->block);
        const char *typed = tinker_equations_typed_text(equations, symbol);
        if (typed != NULL) cJSON_AddStringToObject(object, "text", typed);
        if (symbol->property != NULL) cJSON_AddStringToObject(object, "property", symbol->property);
        if (symbol->quantity != NULL) cJSON_AddStringToObject(object, "quantity", symbol->quantity);
    }
}

static void add_definitions(cJSON *definitions, const TinkerEquations *equations, const GPtrArray *list)
{
    for (guint i = 0; i < list->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(list, i);
        cJSON *object = cJSON_CreateObject();
        cJSON_AddStringToObject(object, "symbol", definition->name);
        add_block(object, equations, definition->block);
        cJSON_AddStringToObject(object, "unit", tinker_equation_unit(definition->dimension, definition->energy));
        if (definition->means != NULL) cJSON_AddStringToObject(object, "means", definition->means);
        cJSON_AddItemToObject(object, "is", expression_json(definition->is));
        if (definition->typed) cJSON_AddTrueToObject(object, "typed");
        cJSON_AddItemToArray(definitions, object);
    }
}

static void add_constraints(cJSON *root, const TinkerEquations *equations)
{
    cJSON *constraints = cJSON_AddArrayToObject(root, "constraints");
    for (guint i = 0; i < equations->constraints->len; i++) {
        const TinkerConstraintEquation *row = g_ptr_array_index(equations->constraints, i);
        cJSON *object = cJSON_CreateObject();
        add_block(object, equations, row->block);
        cJSON_AddItemToObject(object, "g", expression_json(row->g));
        cJSON_AddStringToObject(object, "multiplier", row->multiplier);
        cJSON_AddStringToObject(object, "unit", tinker_equation_unit(row->dimension, FALSE));
        cJSON_AddBoolToObject(object, "active", row->active);
        if (row->redundant) cJSON_AddTrueToObject(object, "redundant");
        cJSON_AddItemToArray(constraints, object);
    }
}

static void add_not_written(cJSON *root, const TinkerEquations *equations)
{
    cJSON *list = cJSON_AddArrayToObject(root, "not_written");
    for (guint i = 0; i < equations->not_written->len; i++) {
        const TinkerNotWritten *missing = g_ptr_array_index(equations->not_written, i);
        cJSON *object = cJSON_CreateObject();
        add_block(object, equations, missing->block);
        cJSON *symbols = cJSON_AddArrayToObject(object, "symbols");
        for (guint k = 0; k < missing->symbols->len; k++)
            cJSON_AddItemToArray(symbols, cJSON_CreateString(g_ptr_array_index(missing->symbols, k)));
        cJSON_AddStringToObject(object, "why", missing->why);
        cJSON_AddItemToArray(list, object);
    }
}

static char *printed(cJSON *root)
{
    char *text = cJSON_Print(root), *copy = g_strdup(text);
    cJSON_free(text);
    cJSON_Delete(root);
    return copy;
}

static cJSON *head_json(const TinkerEquations *equations, const char *form)
{
    cJSON *root = cJSON_CreateObject();
    cJSON_AddNumberToObject(root, "tinker_equations", 1);
    cJSON_AddStringToObject(root, "form", form);
    cJSON_AddNumberToObject(root, "time", equations->time);
    return root;
}

char *tinker_equations_json(const TinkerEquations *equations, const TinkerBlockId *blocks)
{
    cJSON *root = head_json(equations, "newton");
    cJSON *bodies = cJSON_AddArrayToObject(root, "bodies");
    for (guint i = 0; i < equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(equations->bodies, i);
        if (is_wanted(blocks, body->block)) cJSON_AddItemToArray(bodies, body_json(equations, body));
    }
    add_symbols(root, equations);
    add_definitions(cJSON_AddArrayToObject(root, "definitions"), equations, equations->definitions);
    add_constraints(root, equations);
    add_not_written(root, equations);
    return printed(root);
}

static void add_reasons(cJSON *root, const TinkerEquations *equations, const GPtrArray *reasons)
{
    cJSON *why = cJSON_AddArrayToObject(root, "why");
    for (guint i = 0; i < reasons->len; i++) {
        const TinkerNotWritten *reason = g_ptr_array_index(reasons, i);
        cJSON *object = cJSON_CreateObject(), *blocks = cJSON_AddArrayToObject(object, "blocks");
        if (reason->block >= 0) tinker_json_add_name(blocks, equations->scene, reason->block);
        cJSON_AddStringToObject(object, "why", reason->why);
        cJSON_AddItemToArray(why, object);
    }
}

/* The matrix form -------------------------------------------------------------------------------------------------- */

typedef struct {
    const TinkerExpression **entries; /* by rows; NULL: 0 */
    guint n;
} Entries;

static void put_entry(guint row, guint column, const TinkerExpression *entry, void *data)
{
    const Entries *self = data;
    self->entries[row * self->n + column] = entry;
}

static void add_entries(cJSON *object, const char *key, const TinkerMatrixIsland *island, TinkerMatrixKind kind)
{
    const guint n = island->coordinates->len;
    g_autofree const TinkerExpression **entries = g_new0(const TinkerExpression *, (gsize)n *n);
    Entries self = {entries, n};
    tinker_matrix_each(island, kind, put_entry, &self);
    cJSON *rows = cJSON_AddArrayToObject(object, key);
    for (guint i = 0; i < n; i++) {
        cJSON *row = cJSON_CreateArray();
        for (guint k = 0; k < n; k++)
            cJSON_AddItemToArray(row, entries[i * n + k] != NULL ? expression_json(entries[i * n + k])
                                                                 : cJSON_CreateNumber(0));
        cJSON_AddItemToArray(rows, row);
    }
}

/* null where there is no number */
static void add_numbers(cJSON *object, const char *key, const double *numbers, guint count)
{
    cJSON *list = cJSON_AddArrayToObject(object, key);
    for (guint i = 0; i < count; i++)
        cJSON_AddItemToArray(list, isnan(numbers[i]) ? cJSON_CreateNull() : cJSON_CreateNumber(numbers[i]));
}

static void add_unstable(cJSON *object, const TinkerMatrixIsland *island, guint n)
{
    cJSON *list = cJSON_AddArrayToObject(object, "unstable");
    for (guint i = 0; i < n; i++)
        if (!isnan(island->unstable[2 * i]))
            cJSON_AddItemToArray(list, cJSON_CreateDoubleArray(&island->unstable[2 * i], 2));
}

static void add_coordinates(cJSON *object, const TinkerMatrixIsland *island)
{
    cJSON *list = cJSON_AddArrayToObject(object, "coordinates");
    cJSON *about = cJSON_AddObjectToObject(object, "about");
    for (guint i = 0; i < island->coordinates->len; i++) {
        const TinkerMatrixCoordinate *coordinate = &g_array_index(island->coordinates, TinkerMatrixCoordinate, i);
        cJSON *each = cJSON_CreateObject();
        cJSON_AddStringToObject(each, "symbol", coordinate->symbol);
        cJSON_AddStringToObject(each, "unit", coordinate->turning ? "rad" : "m");
        cJSON_AddItemToObject(each, "is", expression_json(coordinate->is));
        cJSON_AddItemToArray(list, each);
        cJSON_AddNumberToObject(about, coordinate->symbol, coordinate->about);
    }
}

static cJSON *island_json(const TinkerEquations *equations, const TinkerMatrixIsland *island)
{
    const guint n = island->coordinates->len;
    cJSON *object = cJSON_CreateObject();
    tinker_json_add_names(object, equations->scene, island->blocks);
    add_coordinates(object, island);
    add_entries(object, "M", island, TINKER_MATRIX_MASS);
    add_entries(object, "C", island, TINKER_MATRIX_DAMPING);
    add_entries(object, "K", island, TINKER_MATRIX_STIFFNESS);
    cJSON *load = cJSON_AddArrayToObject(object, "f");
    for (guint i = 0; i < n; i++)
        cJSON_AddItemToArray(load, expression_json(g_ptr_array_index(island->load, i)));
    add_numbers(object, "omega", island->omega, n);
    add_numbers(object, "zeta", island->zeta, n);
    add_numbers(object, "decay", island->decay, n);
    add_unstable(object, island, n);
    return object;
}

char *tinker_equations_matrix_json(const TinkerEquations *equations, const TinkerMatrixForm *form)
{
    cJSON *root = head_json(equations, "matrix");
    cJSON *islands = cJSON_AddArrayToObject(root, "islands");
    for (guint i = 0; i < form->islands->len; i++)
        cJSON_AddItemToArray(islands, island_json(equations, g_ptr_array_index(form->islands, i)));
    add_reasons(root, equations, form->why);
    add_symbols(root, equations);
    add_definitions(cJSON_AddArrayToObject(root, "definitions"), equations, equations->definitions);
    return printed(root);
}

/* Angles ----------------------------------------------------------------------------------------------------------- */

static cJSON *tree_json(const TinkerEquations *equations, const TinkerAngleTree *tree)
{
    cJSON *object = cJSON_CreateObject(), *blocks = cJSON_AddArrayToObject(object, "blocks");
    cJSON *angles = cJSON_AddArrayToObject(object, "angles");
    cJSON *accelerations = cJSON_AddArrayToObject(object, "accelerations");
    cJSON *list = cJSON_AddArrayToObject(object, "equations");
    for (guint i = 0; i < tree->angles->len; i++) {
        const TinkerRodAngle *angle = &g_array_index(tree->angles, TinkerRodAngle, i);
        const char *rod = tinker_scene_block_name(equations->scene, angle->rod);
        tinker_json_add_name(blocks, equations->scene, angle->body);
        if (angle->rod != angle->body) tinker_json_add_name(blocks, equations->scene, angle->rod);
        cJSON *each = cJSON_CreateObject();
        cJSON_AddStringToObject(each, "symbol", angle->angle);
        cJSON_AddStringToObject(each, "block", rod);
        cJSON_AddNumberToObject(each, "value", angle->value);
        cJSON_AddStringToObject(each, "rate", angle->rate);
        cJSON_AddNumberToObject(each, "rate_value", angle->rate_value);
        cJSON_AddStringToObject(each, "acceleration", angle->acceleration);
        cJSON_AddItemToArray(angles, each);
        cJSON_AddItemToArray(accelerations, cJSON_CreateString(angle->acceleration));
        cJSON_AddItemToArray(list, expression_json(g_ptr_array_index(tree->equations, i)));
    }
    return object;
}

char *tinker_equations_angles_json(const TinkerEquations *equations, const TinkerAngleForm *form)
{
    cJSON *root = head_json(equations, "angles");
    cJSON *islands = cJSON_AddArrayToObject(root, "islands");
    for (guint i = 0; i < form->trees->len; i++)
        cJSON_AddItemToArray(islands, tree_json(equations, g_ptr_array_index(form->trees, i)));
    add_reasons(root, equations, form->why);
    add_symbols(root, equations);
    cJSON *definitions = cJSON_AddArrayToObject(root, "definitions");
    add_definitions(definitions, equations, equations->definitions);
    add_definitions(definitions, equations, form->lengths);
    add_definitions(definitions, equations, form->definitions);
    return printed(root);
}

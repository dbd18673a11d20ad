/* Trees of expressions, and the reader that makes them. */
#include "units/expression/expression-tree.h"

#include <string.h>

#include "units/expression/expression-program.h"

#define MOST_NODES 32768
#define DEEPEST    1000 /* levels: trees are walked by recursion */

/* What is read: the handle of a node is its place. */
typedef struct {
    GPtrArray *nodes;
    int deepest;
} TreeMaker;

static int keep(TreeMaker *maker, TinkerExpression *node)
{
    maker->deepest = MAX(maker->deepest, node->depth);
    g_ptr_array_add(maker->nodes, node);
    return (int)maker->nodes->len - 1;
}

static TinkerExpression *at(const TreeMaker *maker, int handle)
{
    return g_ptr_array_index(maker->nodes, handle);
}

static gboolean has_room(void *into)
{
    const TreeMaker *maker = into;
    return maker->nodes->len <= MOST_NODES && maker->deepest <= DEEPEST;
}

static int read_number(void *into, double value)
{
    return keep(into, tinker_expression_number(value));
}

static int read_time(void *into)
{
    return keep(into, tinker_expression_symbol("t"));
}

static int read_name(void *into, const char *name)
{
    return keep(into, tinker_expression_symbol(name));
}

static int add_node(TreeMaker *maker, TinkerExpressionKind kind, const char *name, const int *handles, int count)
{
    TinkerExpression *parts[TINKER_MOST_ARGUMENTS];
    for (int i = 0; i < count; i++)
        parts[i] = tinker_expression_ref(at(maker, handles[i]));
    return keep(maker, tinker_expression_node(kind, name, parts, count));
}

/* a + b + c is one sum of three, so that long sums are not deep. */
static int extend(TreeMaker *maker, TinkerExpressionKind kind, int a, int b)
{
    const TinkerExpression *first = at(maker, a);
    const int handles[] = {a, b};
    if (first->kind != kind) return add_node(maker, kind, NULL, handles, 2);
    g_autofree TinkerExpression **parts = g_new(TinkerExpression *, (gsize)first->count + 1);
    for (int i = 0; i < first->count; i++)
        parts[i] = tinker_expression_ref(first->parts[i]);
    parts[first->count] = tinker_expression_ref(at(maker, b));
    TinkerExpression *longer = tinker_expression_node(kind, NULL, parts, first->count + 1);
    /* the shorter one is gone, so that a long sum takes no more memory than its terms */
    tinker_expression_unref(g_ptr_array_index(maker->nodes, a));
    maker->nodes->pdata[a] = longer;
    return a;
}

static int read_operation(void *into, TinkerOperation operation, int a, int b)
{
    TreeMaker *maker = into;
    const int handles[] = {a, b};
    switch (operation) {
    case TINKER_OP_NEGATE:
        return add_node(maker, TINKER_EXPRESSION_NEGATIVE, NULL, handles, 1);
    case TINKER_OP_SUBTRACT:
        return extend(maker, TINKER_EXPRESSION_SUM, a, add_node(maker, TINKER_EXPRESSION_NEGATIVE, NULL, &b, 1));
    case TINKER_OP_ADD:
        return extend(maker, TINKER_EXPRESSION_SUM, a, b);
    case TINKER_OP_MULTIPLY:
        return extend(maker, TINKER_EXPRESSION_PRODUCT, a, b);
    case TINKER_OP_DIVIDE:
        return add_node(maker, TINKER_EXPRESSION_QUOTIENT, NULL, handles, 2);
    default:
        return add_node(maker, TINKER_EXPRESSION_POWER, NULL, handles, 2);
    }
}

static int read_comparison(void *into, TinkerComparison comparison, int a, int b)
{
    static const char *const signs[] = {
        [TINKER_COMPARE_AT_MOST] = "<=", [TINKER_COMPARE_AT_LEAST] = ">=", [TINKER_COMPARE_EQUAL] = "==",
        [TINKER_COMPARE_UNEQUAL] = "!=", [TINKER_COMPARE_BELOW] = "<",     [TINKER_COMPARE_ABOVE] = ">",
    };
    const int handles[] = {a, b};
    return add_node(into, TINKER_EXPRESSION_COMPARISON, signs[comparison], handles, 2);
}

static int read_function(void *into, const TinkerFunction *function, const int *arguments)
{
    return add_node(into, TINKER_EXPRESSION_FUNCTION, function->name, arguments, function->arguments);
}

static int read_condition(G_GNUC_UNUSED void *into, int value)
{
    return value;
}

static void enter_branch(G_GNUC_UNUSED void *into, G_GNUC_UNUSED int truth, G_GNUC_UNUSED gboolean taken) {}

static void leave_branch(G_GNUC_UNUSED void *into) {}

static const TinkerReader reader = {
    .has_room = has_room,
    .number = read_number,
    .time = read_time,
    .name = read_name,
    .operation = read_operation,
    .comparison = read_comparison,
    .function = read_function,
    .condition = read_condition,
    .enter_branch = enter_branch,
    .leave_branch = leave_branch,
};

static TinkerExpression *parse(const char *text, const TinkerReadable *names, GError **error)
{
    g_autoptr(GPtrArray) nodes = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
    TreeMaker maker = {nodes, 0};
    const int value = tinker_expression_read(text, names, &reader, &maker, error);
    return value == TINKER_READER_FAILED ? NULL : tinker_expression_ref(at(&maker, value));
}

TinkerExpression *tinker_expression_parse(const char *text, const char *const *names, GError **error)
{
    return parse(text, &(TinkerReadable){.names = names}, error);
}

TinkerExpression *tinker_expression_parse_quantities(const char *text, TinkerReferenceFunc refer, void *data,
                                                     GError **error)
{
    return parse(text, &(TinkerReadable){.refer = refer, .data = data}, error);
}

TinkerExpression *tinker_expression_number(double number)
{
    TinkerExpression *node = tinker_expression_node(TINKER_EXPRESSION_NUMBER, NULL, NULL, 0);
    node->number = number;
    return node;
}

TinkerExpression *tinker_expression_symbol(const char *name)
{
    return tinker_expression_node(TINKER_EXPRESSION_SYMBOL, name, NULL, 0);
}

TinkerExpression *tinker_expression_node(TinkerExpressionKind kind, const char *name, TinkerExpression *const *parts,
                                         int count)
{
    TinkerExpression *node = g_malloc0(sizeof *node + (gsize)count * sizeof(TinkerExpression *));
    g_atomic_ref_count_init(&node->references);
    node->kind = kind;
    node->name = g_intern_string(name);
    node->count = count;
    for (int i = 0; i < count; i++) {
        node->parts[i] = parts[i];
        node->depth = MAX(node->depth, parts[i]->depth + 1);
    }
    return node;
}

TinkerExpression *tinker_expression_ref(const TinkerExpression *expression)
{
    TinkerExpression *shared = (TinkerExpression *)expression;
    g_atomic_ref_count_inc(&shared->references);
    return shared;
}

void tinker_expression_unref(TinkerExpression *expression)
{
    if (!g_atomic_ref_count_dec(&expression->references)) return;
    for (int i = 0; i < expression->count; i++)
        tinker_expression_unref(expression->parts[i]);
    g_free(expression);
}

gboolean tinker_expression_equal(const TinkerExpression *a, const TinkerExpression *b)
{
    if (a == b) return TRUE;
    if (a->kind != b->kind || a->count != b->count || a->name != b->name) return FALSE;
    if (a->kind == TINKER_EXPRESSION_NUMBER && a->number != b->number) return FALSE;
    for (int i = 0; i < a->count; i++)
        if (!tinker_expression_equal(a->parts[i], b->parts[i])) return FALSE;
    return TRUE;
}

/* The signs and functions have their meaning in one place only, the compiler: a program of the node over constants is
 * folded into the number. */
static double fold(const TinkerExpression *node, const double *values)
{
    static const char *const signs[] = {"<=", ">=", "==", "!=", "<", ">", NULL};
    g_autoptr(TinkerProgram) program = tinker_program_new();
    TinkerBuilder builder = {program, -1};
    int handles[TINKER_MOST_ARGUMENTS] = {0};
    for (int i = 0; i < node->count; i++)
        handles[i] = tinker_build(&builder, TINKER_OP_CONSTANT, -1, -1, -1, values[i]);
    int result = -1;
    for (int i = 0; node->kind == TINKER_EXPRESSION_COMPARISON && signs[i] != NULL; i++)
        if (strcmp(signs[i], node->name) == 0)
            result = tinker_build_comparison(&builder, (TinkerComparison)i, handles[0], handles[1]);
    if (node->kind == TINKER_EXPRESSION_FUNCTION)
        result = tinker_build_function(&builder, tinker_function_lookup(node->name), handles);
    g_assert(result >= 0);
    int count;
    return tinker_program_code(program, &count)[result].number;
}

double tinker_expression_apply(const TinkerExpression *node, const double *values)
{
    double value = node->count > 0 ? values[0] : node->number;
    switch (node->kind) {
    case TINKER_EXPRESSION_SUM:
        for (int i = 1; i < node->count; i++)
            value += values[i];
        return value;
    case TINKER_EXPRESSION_PRODUCT:
        for (int i = 1; i < node->count; i++)
            value *= values[i];
        return value;
    case TINKER_EXPRESSION_NEGATIVE:
        return -value;
    case TINKER_EXPRESSION_QUOTIENT:
        return value / values[1];
    case TINKER_EXPRESSION_POWER:
        return pow(value, values[1]);
    case TINKER_EXPRESSION_FUNCTION:
        if (strcmp(node->name, "if") == 0) return value != 0 ? values[1] : values[2];
        return fold(node, values);
    case TINKER_EXPRESSION_COMPARISON:
        return fold(node, values);
    default:
        return value;
    }
}

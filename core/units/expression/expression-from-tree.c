/* From trees to programs. An argument is an instruction "time" with its number, so that no function has a meaning of
 * its own here. */
#include <string.h>

#include "units/expression/expression-program.h"

#define MOST_PRODUCT 16 /* powers up to this one are products */

typedef struct {
    TinkerBuilder builder;
    const char *const *names;
    int count;
    guint most;        /* instructions */
    GHashTable *known; /* node to instruction + 1 */
    gboolean failed;   /* too long, or a name that is not known */
} Compiler;

static int compile(Compiler *compiler, const TinkerExpression *node);

static int argument(Compiler *compiler, const char *name)
{
    for (int i = 0; i < compiler->count; i++)
        if (strcmp(compiler->names[i], name) == 0)
            return tinker_build(&compiler->builder, TINKER_OP_TIME, -1, -1, -1, i);
    compiler->failed = TRUE;
    return tinker_build(&compiler->builder, TINKER_OP_CONSTANT, -1, -1, -1, 0);
}

/* a op b op c ... */
static int chain(Compiler *compiler, const TinkerExpression *node, TinkerOperation operation)
{
    int result = compile(compiler, node->parts[0]);
    for (int i = 1; i < node->count; i++) {
        const TinkerExpression *part = node->parts[i];
        const gboolean minus = operation == TINKER_OP_ADD && part->kind == TINKER_EXPRESSION_NEGATIVE;
        const int next = compile(compiler, minus ? part->parts[0] : part);
        result = tinker_build(&compiler->builder, minus ? TINKER_OP_SUBTRACT : operation, result, next, -1, 0);
    }
    return result;
}

static int binary(Compiler *compiler, TinkerOperation operation, int a, int b)
{
    return tinker_build(&compiler->builder, operation, a, b, -1, 0);
}

/* x^n by squaring: off by (n - 1) / 2 ulp at most. */
static int whole_power(Compiler *compiler, int x, int n)
{
    if (n == 1) return x;
    const int half = whole_power(compiler, x, n / 2);
    const int square = binary(compiler, TINKER_OP_MULTIPLY, half, half);
    return n % 2 == 0 ? square : binary(compiler, TINKER_OP_MULTIPLY, square, x);
}

/* Small powers, of halves too, as products and a root, which are about as exact and much faster. */
static int power(Compiler *compiler, const TinkerExpression *node)
{
    TinkerBuilder *builder = &compiler->builder;
    const int base = compile(compiler, node->parts[0]);
    const TinkerExpression *exponent = node->parts[1];
    const double n = exponent->kind == TINKER_EXPRESSION_NUMBER ? fabs(exponent->number) : NAN;
    if (!(n > 0 && n <= MOST_PRODUCT && 2 * n == floor(2 * n)))
        return binary(compiler, TINKER_OP_POWER, base, compile(compiler, exponent));
    int result = n >= 1 ? whole_power(compiler, base, (int)n) : -1;
    if (n != floor(n)) {
        const int root = tinker_build(builder, TINKER_OP_SQRT, base, -1, -1, 0);
        result = result >= 0 ? binary(compiler, TINKER_OP_MULTIPLY, result, root) : root;
    }
    if (exponent->number > 0) return result;
    const int one = tinker_build(builder, TINKER_OP_CONSTANT, -1, -1, -1, 1);
    return binary(compiler, TINKER_OP_DIVIDE, one, result);
}

static int function(Compiler *compiler, const TinkerExpression *node)
{
    int handles[TINKER_MOST_ARGUMENTS] = {0};
    for (int i = 0; i < node->count; i++)
        handles[i] = compile(compiler, node->parts[i]);
    if (strcmp(node->name, "if") == 0)
        handles[0] = tinker_build(&compiler->builder, TINKER_OP_TRUTH, handles[0], -1, -1, 0);
    return tinker_build_function(&compiler->builder, tinker_function_lookup(node->name), handles);
}

static int comparison(Compiler *compiler, const TinkerExpression *node)
{
    static const char *const signs[] = {
        [TINKER_COMPARE_AT_MOST] = "<=", [TINKER_COMPARE_AT_LEAST] = ">=", [TINKER_COMPARE_EQUAL] = "==",
        [TINKER_COMPARE_UNEQUAL] = "!=", [TINKER_COMPARE_BELOW] = "<",     [TINKER_COMPARE_ABOVE] = ">",
    };
    const int a = compile(compiler, node->parts[0]), b = compile(compiler, node->parts[1]);
    int which = 0;
    while (strcmp(signs[which], node->name) != 0)
        which++;
    return tinker_build_comparison(&compiler->builder, (TinkerComparison)which, a, b);
}

static int compile_node(Compiler *compiler, const TinkerExpression *node)
{
    TinkerBuilder *builder = &compiler->builder;
    switch (node->kind) {
    case TINKER_EXPRESSION_NUMBER:
        return tinker_build(builder, TINKER_OP_CONSTANT, -1, -1, -1, node->number);
    case TINKER_EXPRESSION_SYMBOL:
        return argument(compiler, node->name);
    case TINKER_EXPRESSION_SUM:
        return chain(compiler, node, TINKER_OP_ADD);
    case TINKER_EXPRESSION_PRODUCT:
        return chain(compiler, node, TINKER_OP_MULTIPLY);
    case TINKER_EXPRESSION_NEGATIVE:
        return tinker_build(builder, TINKER_OP_NEGATE, compile(compiler, node->parts[0]), -1, -1, 0);
    case TINKER_EXPRESSION_QUOTIENT:
        return chain(compiler, node, TINKER_OP_DIVIDE);
    case TINKER_EXPRESSION_POWER:
        return power(compiler, node);
    case TINKER_EXPRESSION_COMPARISON:
        return comparison(compiler, node);
    default:
        return function(compiler, node);
    }
}

static int compile(Compiler *compiler, const TinkerExpression *node)
{
    const int known = GPOINTER_TO_INT(g_hash_table_lookup(compiler->known, node));
    if (known > 0) return known - 1;
    compiler->failed = compiler->failed || compiler->builder.program->code->len > compiler->most;
    if (compiler->failed) return 0;
    const int result = compile_node(compiler, node);
    g_hash_table_insert(compiler->known, (void *)node, GINT_TO_POINTER(result + 1));
    return result;
}

TinkerProgram *tinker_program_of_tree(const TinkerExpression *expression, const char *const *names, int count,
                                      guint most)
{
    g_autoptr(TinkerProgram) program = tinker_program_new();
    g_autoptr(GHashTable) known = g_hash_table_new(NULL, NULL);
    Compiler compiler = {{program, -1}, names, count, most, known, FALSE};
    tinker_build(&compiler.builder, TINKER_OP_CONSTANT, -1, -1, -1, 0); /* what a failure answers */
    const int value = compile(&compiler, expression);
    if (compiler.failed || program->code->len > most) return NULL;
    tinker_program_finish(program, value);
    return g_steal_pointer(&program);
}

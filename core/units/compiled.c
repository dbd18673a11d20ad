/* Compiling trees to programs, and working programs out with numbers alone. The instructions are those of waveforms; an
 * argument is an instruction "time" with its number, so that no function has a meaning of its own here. */
#include "units/compiled.h"

#include <string.h>

#include "units/expression-private.h"

#define MOST_INSTRUCTIONS 1024 /* results stand on the stack */

struct _TinkerCompiled {
    int count;
    TinkerInstruction code[];
};

typedef struct {
    TinkerBuilder builder;
    const char *const *names;
    int count;
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

/* Small whole powers as products, which are as exact and much faster. */
static int power(Compiler *compiler, const TinkerExpression *node)
{
    const int base = compile(compiler, node->parts[0]);
    const TinkerExpression *exponent = node->parts[1];
    const double n = exponent->kind == TINKER_EXPRESSION_NUMBER ? exponent->number : 0;
    if (n != 2 && n != 3 && n != 4)
        return tinker_build(&compiler->builder, TINKER_OP_POWER, base, compile(compiler, exponent), -1, 0);
    const int square = tinker_build(&compiler->builder, TINKER_OP_MULTIPLY, base, base, -1, 0);
    if (n == 2) return square;
    return tinker_build(&compiler->builder, TINKER_OP_MULTIPLY, square, n == 3 ? base : square, -1, 0);
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
    compiler->failed = compiler->failed || compiler->builder.program->code->len > MOST_INSTRUCTIONS;
    if (compiler->failed) return 0;
    const int result = compile_node(compiler, node);
    g_hash_table_insert(compiler->known, (void *)node, GINT_TO_POINTER(result + 1));
    return result;
}

TinkerCompiled *tinker_compiled_new(const TinkerExpression *expression, const char *const *names, int count)
{
    g_autoptr(TinkerProgram) program = tinker_program_new();
    g_autoptr(GHashTable) known = g_hash_table_new(NULL, NULL);
    Compiler compiler = {{program, -1}, names, count, known, FALSE};
    tinker_build(&compiler.builder, TINKER_OP_CONSTANT, -1, -1, -1, 0); /* what a failure answers */
    const int value = compile(&compiler, expression);
    if (compiler.failed || program->code->len > MOST_INSTRUCTIONS) return NULL;
    tinker_program_finish(program, value);
    int length;
    const TinkerInstruction *code = tinker_program_code(program, &length);
    TinkerCompiled *compiled = g_malloc(sizeof *compiled + (gsize)length * sizeof *code);
    compiled->count = length;
    memcpy(compiled->code, code, (gsize)length * sizeof *code);
    return compiled;
}

void tinker_compiled_free(TinkerCompiled *compiled)
{
    g_free(compiled);
}

/* The operations that are not among the common ones are asked where they have their meaning. */
static double apply(const TinkerInstruction *instruction, const double *results)
{
    const TinkerJet a = {results[instruction->a], 0, 0};
    const TinkerJet b = {instruction->b >= 0 ? results[instruction->b] : 0, 0, 0};
    return tinker_jet_apply(instruction->operation, &a, &b, instruction->c >= 0 ? results[instruction->c] : 0).value;
}

/* Laws are called at every evaluation of a run, and are mostly made of the operations that stand in the loop. */
double tinker_compiled_value(const TinkerCompiled *compiled, const double *arguments)
{
    double results[MOST_INSTRUCTIONS + 1], last = 0;
    const TinkerInstruction *code = compiled->code;
    for (int i = 0; i < compiled->count; i++) {
        const TinkerInstruction *at = &code[i];
        switch (at->operation) {
        case TINKER_OP_CONSTANT:
            last = at->number;
            break;
        case TINKER_OP_TIME:
            last = arguments[(int)at->number];
            break;
        case TINKER_OP_SWITCH:
        case TINKER_OP_TRUTH:
            last = tinker_instruction_cell(at, results[at->a]);
            break;
        case TINKER_OP_CHOOSE:
            last = results[results[at->c] < 0 ? at->a : at->b];
            break;
        case TINKER_OP_NEGATE:
            last = -results[at->a];
            break;
        case TINKER_OP_ADD:
            last = results[at->a] + results[at->b];
            break;
        case TINKER_OP_SUBTRACT:
            last = results[at->a] - results[at->b];
            break;
        case TINKER_OP_MULTIPLY:
            last = results[at->a] * results[at->b];
            break;
        case TINKER_OP_DIVIDE:
            last = results[at->a] / results[at->b];
            break;
        case TINKER_OP_POWER:
            last = pow(results[at->a], results[at->b]);
            break;
        case TINKER_OP_SQRT:
            last = sqrt(results[at->a]);
            break;
        default:
            last = apply(at, results);
        }
        results[i] = last;
    }
    return last;
}

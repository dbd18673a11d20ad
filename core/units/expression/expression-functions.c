/* The functions and comparisons that an expression may use, as code of smooth instructions and cells. */
#include <string.h>

#include "units/expression/expression-program.h"

#define PI 3.14159265358979323846

static int constant(TinkerBuilder *builder, double number)
{
    return tinker_build(builder, TINKER_OP_CONSTANT, -1, -1, -1, number);
}

static int unary(TinkerBuilder *builder, TinkerOperation operation, int a)
{
    return tinker_build(builder, operation, a, -1, -1, 0);
}

static int binary(TinkerBuilder *builder, TinkerOperation operation, int a, int b)
{
    return tinker_build(builder, operation, a, b, -1, 0);
}

static int choose(TinkerBuilder *builder, int cell, int below, int above)
{
    return tinker_build(builder, TINKER_OP_CHOOSE, below, above, cell, 0);
}

/* The cell of x; a period of 0 is the single level 0. */
static int cell(TinkerBuilder *builder, int x, double period)
{
    return tinker_build(builder, TINKER_OP_SWITCH, x, -1, -1, period);
}

/* 0 below 0, else 1. */
static int step(TinkerBuilder *builder, int x)
{
    return binary(builder, TINKER_OP_ADD, constant(builder, 1), cell(builder, x, 0));
}

static int not(TinkerBuilder * builder, int truth)
{
    return binary(builder, TINKER_OP_SUBTRACT, constant(builder, 1), truth);
}

/* a >= b */
static int reaches(TinkerBuilder *builder, int a, int b)
{
    return step(builder, binary(builder, TINKER_OP_SUBTRACT, a, b));
}

static int build_atan2(TinkerBuilder *builder, const int *arguments)
{
    const int side = cell(builder, arguments[0], 0);
    return tinker_build(builder, TINKER_OP_ATAN2, arguments[0], arguments[1], side, 0);
}

static int build_abs(TinkerBuilder *builder, const int *arguments)
{
    const int x = arguments[0];
    return choose(builder, cell(builder, x, 0), unary(builder, TINKER_OP_NEGATE, x), x);
}

static int build_floor(TinkerBuilder *builder, const int *arguments)
{
    return cell(builder, arguments[0], 1);
}

static int build_min(TinkerBuilder *builder, const int *arguments)
{
    const int difference = binary(builder, TINKER_OP_SUBTRACT, arguments[0], arguments[1]);
    return choose(builder, cell(builder, difference, 0), arguments[0], arguments[1]);
}

static int build_max(TinkerBuilder *builder, const int *arguments)
{
    const int difference = binary(builder, TINKER_OP_SUBTRACT, arguments[0], arguments[1]);
    return choose(builder, cell(builder, difference, 0), arguments[1], arguments[0]);
}

static int build_mod(TinkerBuilder *builder, const int *arguments)
{
    const int quotient = binary(builder, TINKER_OP_DIVIDE, arguments[0], arguments[1]);
    const int whole = binary(builder, TINKER_OP_MULTIPLY, arguments[1], cell(builder, quotient, 1));
    return binary(builder, TINKER_OP_SUBTRACT, arguments[0], whole);
}

static int build_step(TinkerBuilder *builder, const int *arguments)
{
    return step(builder, arguments[0]);
}

static int build_pulse(TinkerBuilder *builder, const int *arguments)
{
    const int begun = reaches(builder, arguments[0], arguments[1]);
    const int ended = reaches(builder, arguments[0], arguments[2]);
    return binary(builder, TINKER_OP_MULTIPLY, begun, not(builder, ended));
}

static int build_ramp(TinkerBuilder *builder, const int *arguments)
{
    const int x = arguments[0];
    return choose(builder, cell(builder, x, 0), constant(builder, 0), x);
}

static int build_square(TinkerBuilder *builder, const int *arguments)
{
    return unary(builder, TINKER_OP_PARITY, cell(builder, arguments[0], PI));
}

/* the condition is its truth already, see parse_arguments */
static int build_if(TinkerBuilder *builder, const int *arguments)
{
    return choose(builder, arguments[0], arguments[2], arguments[1]);
}

/* x/pi - 1 in the first period, starting again at each multiple of 2 pi */
static int build_sawtooth(TinkerBuilder *builder, const int *arguments)
{
    const int periods = cell(builder, arguments[0], 2 * PI);
    const int halves = binary(builder, TINKER_OP_DIVIDE, arguments[0], constant(builder, PI));
    const int passed = binary(builder, TINKER_OP_MULTIPLY, constant(builder, 2), periods);
    const int since = binary(builder, TINKER_OP_SUBTRACT, halves, passed);
    return binary(builder, TINKER_OP_SUBTRACT, since, constant(builder, 1));
}

/* 1 where a == b over a whole piece: an isolated time at which two functions meet is nothing that lasts. */
static int equals(TinkerBuilder *builder, int a, int b)
{
    const int differs = unary(builder, TINKER_OP_TRUTH, binary(builder, TINKER_OP_SUBTRACT, a, b));
    return choose(builder, differs, constant(builder, 1), constant(builder, 0));
}

int tinker_build(TinkerBuilder *builder, TinkerOperation operation, int a, int b, int c, double number)
{
    return tinker_program_emit(builder->program, (TinkerInstruction){operation, a, b, c, builder->guard, number});
}

int tinker_build_comparison(TinkerBuilder *builder, TinkerComparison comparison, int a, int b)
{
    switch (comparison) {
    case TINKER_COMPARE_AT_MOST:
        return reaches(builder, b, a);
    case TINKER_COMPARE_AT_LEAST:
        return reaches(builder, a, b);
    case TINKER_COMPARE_EQUAL:
        return equals(builder, a, b);
    case TINKER_COMPARE_UNEQUAL:
        return not(builder, equals(builder, a, b));
    case TINKER_COMPARE_BELOW:
        return not(builder, reaches(builder, a, b));
    case TINKER_COMPARE_ABOVE:
        return not(builder, reaches(builder, b, a));
    }
    g_return_val_if_reached(a);
}

int tinker_build_function(TinkerBuilder *builder, const TinkerFunction *function, const int *arguments)
{
    if (function->build != NULL) return function->build(builder, arguments);
    return unary(builder, function->operation, arguments[0]);
}

const TinkerFunction *tinker_function_lookup(const char *name)
{
    for (const TinkerFunction *function = tinker_functions; function->name != NULL; function++)
        if (strcmp(function->name, name) == 0) return function;
    return NULL;
}

const TinkerFunction tinker_functions[] = {
    {"sin", 1, "sin(x)", TINKER_OP_SIN, NULL},
    {"cos", 1, "cos(x)", TINKER_OP_COS, NULL},
    {"tan", 1, "tan(x)", TINKER_OP_TAN, NULL},
    {"asin", 1, "asin(x)", TINKER_OP_ASIN, NULL},
    {"acos", 1, "acos(x)", TINKER_OP_ACOS, NULL},
    {"atan", 1, "atan(x)", TINKER_OP_ATAN, NULL},
    {"atan2", 2, "atan2(y, x)", 0, build_atan2},
    {"sinh", 1, "sinh(x)", TINKER_OP_SINH, NULL},
    {"cosh", 1, "cosh(x)", TINKER_OP_COSH, NULL},
    {"tanh", 1, "tanh(x)", TINKER_OP_TANH, NULL},
    {"exp", 1, "exp(x)", TINKER_OP_EXP, NULL},
    {"log", 1, "log(x)", TINKER_OP_LOG, NULL},
    {"sqrt", 1, "sqrt(x)", TINKER_OP_SQRT, NULL},
    {"abs", 1, "abs(x)", 0, build_abs},
    {"floor", 1, "floor(x)", 0, build_floor},
    {"min", 2, "min(a, b)", 0, build_min},
    {"max", 2, "max(a, b)", 0, build_max},
    {"mod", 2, "mod(a, b)", 0, build_mod},
    {"step", 1, "step(x)", 0, build_step},
    {"pulse", 3, "pulse(t, a, b)", 0, build_pulse},
    {"ramp", 1, "ramp(x)", 0, build_ramp},
    {"square", 1, "square(x)", 0, build_square},
    {"sawtooth", 1, "sawtooth(x)", 0, build_sawtooth},
    {"if", 3, "if(c, a, b)", 0, build_if},
    {NULL, 0, NULL, 0, NULL},
};

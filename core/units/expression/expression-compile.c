/* From text to a program: the reader that writes instructions. */
#include "units/expression/expression-program.h"

#define MOST_INSTRUCTIONS  32768
#define SHIFT_INSTRUCTIONS 3 /* of a shifted time, so that what was read once can be shifted */
#define MOST_BRANCHES      256

typedef struct {
    TinkerBuilder builder;
    int time;   /* the instruction that `t` means where time is shifted; -1 where it is not */
    int *outer; /* guards around the branch that is read, the innermost last */
    int branches;
} Compiler;

static gboolean has_room(void *into)
{
    const Compiler *compiler = into;
    const guint most = MOST_INSTRUCTIONS + (compiler->time >= 0 ? SHIFT_INSTRUCTIONS : 0);
    return compiler->builder.program->code->len <= most && compiler->branches < MOST_BRANCHES;
}

static int number(void *into, double value)
{
    return tinker_build(&((Compiler *)into)->builder, TINKER_OP_CONSTANT, -1, -1, -1, value);
}

static int current_time(void *into)
{
    Compiler *compiler = into;
    if (compiler->time >= 0) return compiler->time;
    return tinker_build(&compiler->builder, TINKER_OP_TIME, -1, -1, -1, 0);
}

static int operation(void *into, TinkerOperation which, int a, int b)
{
    return tinker_build(&((Compiler *)into)->builder, which, a, b, -1, 0);
}

static int comparison(void *into, TinkerComparison which, int a, int b)
{
    return tinker_build_comparison(&((Compiler *)into)->builder, which, a, b);
}

static int function(void *into, const TinkerFunction *which, const int *arguments)
{
    return tinker_build_function(&((Compiler *)into)->builder, which, arguments);
}

static int condition(void *into, int value)
{
    return tinker_build(&((Compiler *)into)->builder, TINKER_OP_TRUTH, value, -1, -1, 0);
}

static void enter_branch(void *into, int truth, gboolean taken)
{
    Compiler *compiler = into;
    TinkerBuilder *builder = &compiler->builder;
    compiler->outer[compiler->branches++] = builder->guard;
    builder->guard = tinker_program_add_guard(builder->program, (TinkerGuard){truth, builder->guard, taken});
}

static void leave_branch(void *into)
{
    Compiler *compiler = into;
    compiler->builder.guard = compiler->outer[--compiler->branches];
}

/* t + shift, once for all places that name t. */
static void build_shifted_time(Compiler *compiler, double shift)
{
    const int now = current_time(compiler), offset = number(compiler, shift);
    compiler->time = operation(compiler, TINKER_OP_ADD, now, offset);
}

static const TinkerReader reader = {
    .has_room = has_room,
    .number = number,
    .time = current_time,
    .operation = operation,
    .comparison = comparison,
    .function = function,
    .condition = condition,
    .enter_branch = enter_branch,
    .leave_branch = leave_branch,
};

TinkerProgram *tinker_program_parse(const char *text, double shift, GError **error)
{
    g_autoptr(TinkerProgram) program = tinker_program_new();
    int outer[MOST_BRANCHES + 1];
    Compiler compiler = {.builder = {program, -1}, .time = -1, .outer = outer};
    if (shift != 0) build_shifted_time(&compiler, shift);
    const int value = tinker_expression_read(text, NULL, &reader, &compiler, error);
    if (value == TINKER_READER_FAILED) return NULL;
    tinker_program_finish(program, value);
    return g_steal_pointer(&program);
}

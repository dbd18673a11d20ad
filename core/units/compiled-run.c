/* Working programs out: at one place, and at many at once, each step for a block of them before the next. Both do the
 * same operations in the same order, so they give the same bits. */
#include <string.h>

#include "units/compiled-private.h"

#define LANES          64 /* of a block: all that is worked on stays in the first cache */
#define PART           4  /* that a step works on side by side; the rest one by one */
#define LEAST_PLACES   8
#define MOST_REGISTERS 24 /* of blocks; programs that want more are worked out place by place */
#define MOST_NUMBERS   64 /* that are the same for all places, likewise */

static double cell_of(double argument, double period)
{
    return tinker_instruction_cell(&(TinkerInstruction){.operation = TINKER_OP_SWITCH, .number = period}, argument);
}

static double angle_of(double y, double x, double cell)
{
    const TinkerJet a = {y, 0, 0}, b = {x, 0, 0};
    return tinker_jet_apply(TINKER_OP_ATAN2, &a, &b, cell).value;
}

static double other(TinkerOperation operation, double a, double b, double c)
{
    switch (operation) {
    case TINKER_OP_TRUTH:
        return a != 0 ? 0 : -1;
    case TINKER_OP_PARITY:
        return fmod(a, 2) == 0 ? 1 : -1;
    case TINKER_OP_POWER:
        return pow(a, b);
    case TINKER_OP_ATAN2:
        return angle_of(a, b, c);
    case TINKER_OP_SIN:
        return sin(a);
    case TINKER_OP_COS:
        return cos(a);
    case TINKER_OP_TAN:
        return tan(a);
    case TINKER_OP_ASIN:
        return asin(a);
    case TINKER_OP_ACOS:
        return acos(a);
    case TINKER_OP_ATAN:
        return atan(a);
    case TINKER_OP_SINH:
        return sinh(a);
    case TINKER_OP_COSH:
        return cosh(a);
    case TINKER_OP_TANH:
        return tanh(a);
    case TINKER_OP_EXP:
        return exp(a);
    case TINKER_OP_LOG:
        return log(a);
    default:
        g_return_val_if_reached(a);
    }
}

/* The steps that are more than a call, once for one place and once for blocks: a, b and c are what a step reads. */
#define ARITHMETIC_STEPS(EACH)                                                                                         \
    EACH(TINKER_STEP_ADD, a + b)                                                                                       \
    EACH(TINKER_STEP_SUBTRACT, a - b)                                                                                  \
    EACH(TINKER_STEP_MULTIPLY, a *b)                                                                                   \
    EACH(TINKER_STEP_DIVIDE, a / b)                                                                                    \
    EACH(TINKER_STEP_SQUARE, a *a)                                                                                     \
    EACH(TINKER_STEP_CUBE, a *a *a)                                                                                    \
    EACH(TINKER_STEP_TIMES_ADD, a *b + c)                                                                              \
    EACH(TINKER_STEP_TIMES_LESS, a *b - c)                                                                             \
    EACH(TINKER_STEP_LESS_TIMES, c - a * b)                                                                            \
    EACH(TINKER_STEP_NEGATE, -a)                                                                                       \
    EACH(TINKER_STEP_SQRT, sqrt(a))                                                                                    \
    EACH(TINKER_STEP_CHOOSE, c < 0 ? a : b)                                                                            \
    EACH(TINKER_STEP_CELL, cell_of(a, b))

#define ONE_CASE(kind_, latest_, a_, b_, c_, value_)                                                                   \
    case TINKER_LATEST_COUNT *kind_ + latest_: {                                                                       \
        const double a = a_, b = b_, c = c_;                                                                           \
        (void)b, (void)c;                                                                                              \
        latest = (value_);                                                                                             \
        break;                                                                                                         \
    }
#define AT_ONE_PLACE(kind_, value_)                                                                                    \
    ONE_CASE(kind_, TINKER_LATEST_NONE, entry[at->a], entry[at->b], entry[at->c], value_)                              \
    ONE_CASE(kind_, TINKER_LATEST_A, latest, entry[at->b], entry[at->c], value_)                                       \
    ONE_CASE(kind_, TINKER_LATEST_B, entry[at->a], latest, entry[at->c], value_)                                       \
    ONE_CASE(kind_, TINKER_LATEST_C, entry[at->a], entry[at->b], latest, value_)

/* Loops that are to stay as they are written. Clang knows no such thing of one function. */
#ifdef __clang__
#define KEEP_LOOPS
#else
#define KEEP_LOOPS __attribute__((optimize("no-tree-loop-distribute-patterns", "no-tree-vectorize")))
#endif

/* Arguments and numbers are few: a call of the C library would take longer than the loops. */
KEEP_LOOPS double tinker_compiled_value(const TinkerCompiled *compiled, const double *arguments)
{
    double entry[TINKER_MOST_ENTRIES], latest = 0;
    const TinkerStep *at = compiled->step, *end = at + compiled->steps;
    for (int i = 0; i < compiled->arguments; i++)
        entry[i] = arguments[i];
    memcpy(entry + compiled->arguments, compiled->number, TINKER_USUAL_NUMBERS * sizeof(double));
    for (int i = TINKER_USUAL_NUMBERS; i < compiled->numbers; i++)
        entry[compiled->arguments + i] = compiled->number[i];
    if (at == end) return entry[compiled->answer];
    do {
        switch (at->code) {
            ARITHMETIC_STEPS(AT_ONE_PLACE)
        default:
            latest = other((TinkerOperation)(at->code / TINKER_LATEST_COUNT - TINKER_STEP_OTHER), entry[at->a],
                           entry[at->b], entry[at->c]);
        }
        entry[at->to] = latest;
    } while (++at < end);
    return latest;
}

#define IN_LANE(i_, value_)                                                                                            \
    {                                                                                                                  \
        const double a = first[i_], b = second[i_], c = third[i_];                                                     \
        (void)b, (void)c;                                                                                              \
        to[i_] = (value_);                                                                                             \
    }
#define IN_BLOCK(kind_, value_)                                                                                        \
    case kind_:                                                                                                        \
        for (int part = 0; part < parts; part += PART)                                                                 \
            for (int i = part; i < part + PART; i++)                                                                   \
                IN_LANE(i, value_)                                                                                     \
        for (int i = parts; i < lanes; i++)                                                                            \
            IN_LANE(i, value_)                                                                                         \
        break;

/* No step writes what it reads. */
__attribute__((always_inline)) static inline void run_block(const TinkerCompiled *compiled, double *const *entry,
                                                            int lanes)
{
    const int parts = lanes / PART * PART;
    const TinkerStep *end = compiled->step + compiled->steps;
    for (const TinkerStep *at = compiled->step; at < end; at++) {
        const int kind = at->code / TINKER_LATEST_COUNT;
        const double *restrict first = entry[at->a], *restrict second = entry[at->b], *restrict third = entry[at->c];
        double *restrict to = entry[at->to];
        switch (kind) {
            ARITHMETIC_STEPS(IN_BLOCK)
        default:
            for (int i = 0; i < lanes; i++)
                to[i] = other((TinkerOperation)(kind - TINKER_STEP_OTHER), first[i], second[i], third[i]);
        }
    }
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) static void run_block_avx2(const TinkerCompiled *compiled, double *const *entry,
                                                           int lanes)
{
    run_block(compiled, entry, lanes);
}
#endif

static void run_block_anywhere(const TinkerCompiled *compiled, double *const *entry, int lanes)
{
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) {
        run_block_avx2(compiled, entry, lanes);
        return;
    }
#endif
    run_block(compiled, entry, lanes);
}

/* The memory of a block: columns of the caller's, and columns here. */
typedef struct {
    double *entry[TINKER_TYPED_MOST_ARGUMENTS + MOST_NUMBERS + MOST_REGISTERS];
    double own[MOST_REGISTERS][LANES], alike[TINKER_TYPED_MOST_ARGUMENTS + MOST_NUMBERS][LANES];
    int filled; /* of `alike` */
} Block;

static double *all_alike(Block *block, double value, int count)
{
    double *column = block->alike[block->filled++];
    for (int i = 0; i < count; i++)
        column[i] = value;
    return column;
}

static void run_blocks(const TinkerCompiled *compiled, Block *block, const TinkerColumns *columns, double *results)
{
    double **entry = block->entry, **number = entry + compiled->arguments;
    for (int first = 0, lanes; first < columns->count; first += lanes) {
        lanes = MIN(LANES, columns->count - first);
        for (int i = 0; i < compiled->arguments; i++)
            if (columns->arguments[i] != NULL) entry[i] = (double *)columns->arguments[i] + first;
        for (int i = 0; columns->numbers != NULL && i < compiled->numbers; i++)
            number[i] = (double *)columns->numbers + (gsize)i * (gsize)columns->stride + first;
        if (compiled->steps > 0) entry[compiled->answer] = results + first;
        run_block_anywhere(compiled, entry, lanes);
        if (compiled->steps == 0) memcpy(results + first, entry[compiled->answer], (gsize)lanes * sizeof(double));
    }
}

gboolean tinker_compiled_values(const TinkerCompiled *compiled, const TinkerColumns *columns, double *results)
{
    if (columns->count < LEAST_PLACES || compiled->registers > MOST_REGISTERS || compiled->numbers > MOST_NUMBERS ||
        compiled->arguments > TINKER_TYPED_MOST_ARGUMENTS)
        return FALSE;
    Block block;
    const int lanes = MIN(columns->count, LANES);
    block.filled = 0;
    for (int i = 0; i < compiled->arguments; i++)
        if (columns->arguments[i] == NULL) block.entry[i] = all_alike(&block, columns->uniform[i], lanes);
    for (int i = 0; columns->numbers == NULL && i < compiled->numbers; i++)
        block.entry[compiled->arguments + i] = all_alike(&block, compiled->number[i], lanes);
    for (int i = 0; i < compiled->registers; i++)
        block.entry[compiled->arguments + compiled->numbers + i] = block.own[i];
    run_blocks(compiled, &block, columns, results);
    return TRUE;
}

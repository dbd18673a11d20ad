/* Working programs out: at one place, and at many at once, each step for a block of them before the next. Both do the
 * same operations in the same order, so they give the same bits. */
#include <string.h>

#include "units/compiled/compiled-private.h"

#define LANES          64 /* of a block: all that is worked on stays in the first cache */
#define PART           4  /* that a step works on side by side */
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

/* The steps that are more than a call, once for one place and once for blocks: a to d are what a step reads. Those of
 * arithmetic are worked out of several lanes at once. */
#define ARITHMETIC_STEPS(EACH)                                                                                         \
    EACH(TINKER_STEP_ADD, a + b)                                                                                       \
    EACH(TINKER_STEP_SUBTRACT, a - b)                                                                                  \
    EACH(TINKER_STEP_MULTIPLY, a *b)                                                                                   \
    EACH(TINKER_STEP_DIVIDE, a / b)                                                                                    \
    EACH(TINKER_STEP_SQUARE, a *a)                                                                                     \
    EACH(TINKER_STEP_CUBE, a *a *a)                                                                                    \
    EACH(TINKER_STEP_TIMES_ADD, a *b + c)                                                                              \
    EACH(TINKER_STEP_TIMES_SQUARE_ADD, a *(b * b) + c)                                                                 \
    EACH(TINKER_STEP_TIMES_CUBE_ADD, a *(b * b * b) + c)                                                               \
    EACH(TINKER_STEP_TIMES_LESS, a *b - c)                                                                             \
    EACH(TINKER_STEP_LESS_TIMES, c - a * b)                                                                            \
    EACH(TINKER_STEP_PRODUCTS, a *b + c * d)                                                                           \
    EACH(TINKER_STEP_PRODUCTS_SQUARE, a *b + c * (d * d))                                                              \
    EACH(TINKER_STEP_PRODUCTS_CUBE, a *b + c * (d * d * d))                                                            \
    EACH(TINKER_STEP_NEGATE, -a)
#define CHOICE_STEPS(EACH)                                                                                             \
    EACH(TINKER_STEP_SQRT, sqrt(a))                                                                                    \
    EACH(TINKER_STEP_CHOOSE, c < 0 ? a : b)

#define ONE_CASE(kind_, latest_, a_, b_, c_, d_, value_)                                                               \
    case TINKER_LATEST_COUNT *kind_ + latest_: {                                                                       \
        const double a = a_, b = b_, c = c_, d = d_;                                                                   \
        (void)b, (void)c, (void)d;                                                                                     \
        latest = (value_);                                                                                             \
        break;                                                                                                         \
    }
#define AT_ONE_PLACE(kind_, value_)                                                                                    \
    ONE_CASE(kind_, TINKER_LATEST_NONE, entry[at->a], entry[at->b], entry[at->c], entry[at->d], value_)                \
    ONE_CASE(kind_, TINKER_LATEST_A, latest, entry[at->b], entry[at->c], entry[at->d], value_)                         \
    ONE_CASE(kind_, TINKER_LATEST_B, entry[at->a], latest, entry[at->c], entry[at->d], value_)                         \
    ONE_CASE(kind_, TINKER_LATEST_C, entry[at->a], entry[at->b], latest, entry[at->d], value_)                         \
    ONE_CASE(kind_, TINKER_LATEST_D, entry[at->a], entry[at->b], entry[at->c], latest, value_)

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
            CHOICE_STEPS(AT_ONE_PLACE)
            AT_ONE_PLACE(TINKER_STEP_CELL, cell_of(a, b))
        default:
            latest = other((TinkerOperation)(at->code / TINKER_LATEST_COUNT - TINKER_STEP_OTHER), entry[at->a],
                           entry[at->b], entry[at->c]);
        }
        entry[at->to] = latest;
    } while (++at < end);
    return latest;
}

/* Neighbouring lanes side by side, wherever they begin in memory. */
typedef double Part __attribute__((vector_size(PART * sizeof(double)), aligned(sizeof(double)), may_alias));
typedef double Pair __attribute__((vector_size(2 * sizeof(double)), aligned(sizeof(double)), may_alias));

#define TOGETHER(type_, value_)                                                                                        \
    do {                                                                                                               \
        const type_ a = *(const type_ *)(first + i), b = *(const type_ *)(second + i);                                 \
        const type_ c = *(const type_ *)(third + i), d = *(const type_ *)(fourth + i);                                 \
        (void)b, (void)c, (void)d;                                                                                     \
        *(type_ *)(to + i) = (value_);                                                                                 \
        i += (gssize)(sizeof(type_) / sizeof(double));                                                                 \
    } while (0)

/* Only a step that reads a column looks up where it is. */
#define WITH_COLUMNS(kind_, loops_)                                                                                    \
    case kind_: {                                                                                                      \
        const double *const first = entry[at->a], *const second = entry[at->b];                                        \
        const double *const third = entry[at->c], *const fourth = entry[at->d];                                        \
        (void)second, (void)third, (void)fourth;                                                                       \
        loops_;                                                                                                        \
        break;                                                                                                         \
    }

/* What the parts leave is a pair, or one, or both: were a lane written twice, the next step would wait to read it. */
#define IN_BLOCK(kind_, value_)                                                                                        \
    WITH_COLUMNS(kind_, while (i < parts) TOGETHER(Part, value_); if ((lanes & 2) != 0) TOGETHER(Pair, value_);        \
                 if ((lanes & 1) != 0) TOGETHER(double, value_))
#define ONE_BY_ONE(kind_, value_) WITH_COLUMNS(kind_, while (i < lanes) TOGETHER(double, value_))

/* Steps that are calls. */
__attribute__((noinline)) static void call_in_block(const TinkerStep *at, double *const *entry, gssize lanes)
{
    const int kind = at->code / TINKER_LATEST_COUNT;
    const double *first = entry[at->a], *second = entry[at->b], *third = entry[at->c];
    double *to = entry[at->to];
    for (gssize i = 0; i < lanes; i++)
        to[i] = kind == TINKER_STEP_CELL
                    ? cell_of(first[i], second[i])
                    : other((TinkerOperation)(kind - TINKER_STEP_OTHER), first[i], second[i], third[i]);
}

/* No step writes what it reads. */
__attribute__((always_inline)) static inline void run_block(const TinkerCompiled *compiled, double *const *entry,
                                                            gssize lanes)
{
    const gssize parts = lanes & -PART;
    const TinkerStep *end = compiled->step + compiled->steps;
    for (const TinkerStep *at = compiled->step; at < end; at++) {
        double *const to = entry[at->to];
        gssize i = 0;
        switch (at->code / TINKER_LATEST_COUNT) {
            ARITHMETIC_STEPS(IN_BLOCK)
            CHOICE_STEPS(ONE_BY_ONE)
        default:
            call_in_block(at, entry, lanes);
        }
    }
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) static void run_block_avx2(const TinkerCompiled *compiled, double *const *entry,
                                                           gssize lanes)
{
    run_block(compiled, entry, lanes);
}
#endif

static void run_block_anywhere(const TinkerCompiled *compiled, double *const *entry, gssize lanes)
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

/* Blocks of LANES, the last one of what is left. Arguments, numbers and registers are few. */
KEEP_LOOPS static void run_blocks(const TinkerCompiled *compiled, const TinkerColumns *columns, double *results)
{
    Block block;
    const int lanes = MIN(columns->count, LANES);
    double **entry = block.entry, **number = entry + compiled->arguments, **own = number + compiled->numbers;
    block.filled = 0;
    for (int i = 0; i < compiled->arguments; i++)
        entry[i] = columns->arguments[i] != NULL ? (double *)columns->arguments[i] + columns->first
                                                 : all_alike(&block, columns->uniform[i], lanes);
    double *column = (double *)columns->numbers;
    for (int i = 0; column != NULL && i < compiled->numbers; i++, column += columns->stride)
        number[i] = column;
    for (int i = 0; column == NULL && i < compiled->numbers; i++)
        number[i] = all_alike(&block, compiled->number[i], lanes);
    for (int i = 0; i < compiled->registers; i++)
        own[i] = block.own[i];
    for (int left = columns->count;; left -= LANES) {
        entry[compiled->answer] = results;
        run_block_anywhere(compiled, entry, MIN(LANES, left));
        if (left <= LANES) return;
        results += LANES;
        for (int i = 0; i < compiled->arguments; i++)
            entry[i] += columns->arguments[i] != NULL ? LANES : 0;
        for (int i = 0; columns->numbers != NULL && i < compiled->numbers; i++)
            number[i] += LANES;
    }
}

/* What needs no step: an argument or a number. */
static void copy_answer(const TinkerCompiled *compiled, const TinkerColumns *columns, double *results)
{
    const int number = compiled->answer - compiled->arguments; /* negative: an argument */
    const double *column = number < 0 ? columns->arguments[compiled->answer] : columns->numbers;
    const gssize from = number < 0 ? (gssize)columns->first : (gssize)number * columns->stride;
    if (column != NULL) {
        memcpy(results, column + from, (gsize)columns->count * sizeof(double));
        return;
    }
    const double value = number < 0 ? columns->uniform[compiled->answer] : compiled->number[number];
    for (int i = 0; i < columns->count; i++)
        results[i] = value;
}

static gboolean fits(const TinkerCompiled *compiled)
{
    return compiled->registers <= MOST_REGISTERS && compiled->numbers <= MOST_NUMBERS &&
           compiled->arguments <= TINKER_TYPED_MOST_ARGUMENTS;
}

gboolean tinker_compiled_values(const TinkerCompiled *compiled, const TinkerColumns *columns, double *results)
{
    if (!fits(compiled)) return FALSE;
    if (compiled->steps == 0)
        copy_answer(compiled, columns, results);
    else
        run_blocks(compiled, columns, results);
    return TRUE;
}

gboolean tinker_compiled_has_row(const TinkerCompiled *compiled, int count)
{
    return fits(compiled) && count <= LANES;
}

/* A call of the C library would take longer than these loops. */
static inline void copy_few(const double *restrict column, int count, double *restrict results)
{
    int i = 0;
    for (; i + PART <= count; i += PART)
        *(Part *)(results + i) = *(const Part *)(column + i);
    for (; i < count; i++)
        results[i] = column[i];
}

KEEP_LOOPS static void fill_few(double *column, int count, double value)
{
    for (int i = 0; i < count; i++)
        column[i] = value;
}

/* As little as can be: nothing is laid out but where all columns are. */
KEEP_LOOPS void tinker_compiled_row(const TinkerCompiled *compiled, const double *const *arguments,
                                    const double *uniform, const double *numbers, int count, double *results)
{
    double own[MOST_REGISTERS][LANES], alike[TINKER_TYPED_MOST_ARGUMENTS][LANES];
    double *entry[TINKER_TYPED_MOST_ARGUMENTS + MOST_NUMBERS + MOST_REGISTERS], **next = entry;
    for (int i = 0; i < compiled->arguments; i++) {
        if (arguments[i] == NULL) fill_few(alike[i], count, uniform[i]);
        *next++ = arguments[i] != NULL ? (double *)arguments[i] : alike[i];
    }
    for (int i = 0; i < compiled->numbers; i++, numbers += count)
        *next++ = (double *)numbers;
    if (compiled->steps == 0) {
        copy_few(entry[compiled->answer], count, results);
        return;
    }
    for (int i = 0; i < compiled->registers; i++)
        *next++ = own[i];
    entry[compiled->answer] = results;
    run_block_anywhere(compiled, entry, count);
}

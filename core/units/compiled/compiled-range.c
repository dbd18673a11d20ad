/* What a program answers over a box of arguments: an enclosure, and whether it is gentle there. The steps are those of
 * compiled-run.c, each once, with intervals for numbers.
 *
 * Gentle is what a few places within the box tell: nothing switches there, and no function whose course is a matter of
 * its argument's size runs through much of it: an exponential grows by less than e^GENTLE, a divisor by less than
 * RATIO. Sums, products and roots of something gentle are gentle. */
#include <float.h>
#include <math.h>

#include "units/compiled/compiled-private.h"

#define GENTLE 4.0
#define RATIO  8.0
#define ENDED  20.0 /* tanh is +-1 beyond it */
#define POINT  (8 * DBL_EPSILON)
#define TWO_PI 6.28318530717958647692

/* Short names for what every line here does. */
#define ADD(x, y) tinker_interval_add(x, y)
#define SUB(x, y) tinker_interval_subtract(x, y)
#define MUL(x, y) tinker_interval_multiply(x, y)
#define SQUARE(x) tinker_interval_power(x, 2)
#define CUBE(x)   tinker_interval_power(x, 3)

static gboolean is_narrow(TinkerInterval x, double width)
{
    return x.high - x.low <= width;
}

/* The largest of |x| over the smallest; INFINITY where that is 0. */
static double ratio_of(TinkerInterval x)
{
    if (!tinker_interval_excludes_zero(x)) return INFINITY;
    return x.low > 0 ? x.high / x.low : x.low / x.high;
}

/* The cell of both ends; where they differ it switches within. What is no wider than its rounding is one number. */
static TinkerInterval cells_of(TinkerInterval x, double period, gboolean *gentle)
{
    const TinkerInstruction is = {.operation = TINKER_OP_SWITCH, .number = period};
    if (!isfinite(x.low) || !isfinite(x.high)) {
        *gentle = FALSE;
        return period > 0 ? tinker_interval_entire() : (TinkerInterval){-1, 0};
    }
    if (x.high - x.low <= POINT * fmax(fabs(x.low), fabs(x.high)) || x.high - x.low < DBL_MIN)
        return tinker_interval_point(tinker_instruction_cell(&is, 0.5 * (x.low + x.high)));
    const TinkerInterval cells = {tinker_instruction_cell(&is, x.low), tinker_instruction_cell(&is, x.high)};
    *gentle = *gentle && cells.low == cells.high;
    return cells;
}

static TinkerInterval truth_of(TinkerInterval x, gboolean *gentle)
{
    if (tinker_interval_excludes_zero(x)) return tinker_interval_point(0);
    if (x.low == 0 && x.high == 0) return tinker_interval_point(-1);
    *gentle = FALSE;
    return (TinkerInterval){-1, 0};
}

static TinkerInterval choice_of(TinkerInterval a, TinkerInterval b, TinkerInterval cell)
{
    if (cell.high < 0) return a;
    if (cell.low >= 0) return b;
    return (TinkerInterval){fmin(a.low, b.low), fmax(a.high, b.high)};
}

static TinkerInterval power_of(TinkerInterval x, TinkerInterval exponent, gboolean *gentle)
{
    const double most = fmax(fabs(exponent.low), fabs(exponent.high));
    const gboolean is_product = exponent.low == exponent.high && most <= GENTLE && exponent.low >= 0;
    *gentle = *gentle && (is_product || (x.low > 0 && most * log(ratio_of(x)) <= GENTLE));
    if (exponent.low == exponent.high) return tinker_interval_power(x, exponent.low);
    return tinker_interval_exp(MUL(exponent, tinker_interval_log(x)));
}

static TinkerInterval angle_of(TinkerInterval y, TinkerInterval x, TinkerInterval cell, gboolean *gentle)
{
    const TinkerInterval none = tinker_interval_point(0);
    const TinkerRangeJet a = {y, none, none}, b = {x, none, none};
    if (cell.low == cell.high) return tinker_range_jet_apply(TINKER_OP_ATAN2, &a, &b, cell.low).value;
    *gentle = FALSE;
    return (TinkerInterval){-TWO_PI, TWO_PI};
}

static gboolean is_gentle(TinkerOperation operation, TinkerInterval x)
{
    switch (operation) {
    case TINKER_OP_TANH:
        return is_narrow(x, 2) || x.low > ENDED || x.high < -ENDED;
    case TINKER_OP_ATAN:
        return is_narrow(x, 2) || ratio_of(x) <= RATIO;
    case TINKER_OP_LOG:
        return x.low > 0 && ratio_of(x) <= RATIO;
    case TINKER_OP_TAN:
        return is_narrow(x, 1);
    case TINKER_OP_EXP:
        return is_narrow(x, GENTLE) || x.high < log(DBL_MIN);
    default:
        return is_narrow(x, GENTLE);
    }
}

static TinkerInterval function_of(TinkerOperation operation, TinkerInterval x, gboolean *gentle)
{
    static TinkerInterval (*const functions[])(TinkerInterval) = {
        [TINKER_OP_SIN] = tinker_interval_sin,   [TINKER_OP_COS] = tinker_interval_cos,
        [TINKER_OP_TAN] = tinker_interval_tan,   [TINKER_OP_ASIN] = tinker_interval_asin,
        [TINKER_OP_ACOS] = tinker_interval_acos, [TINKER_OP_ATAN] = tinker_interval_atan,
        [TINKER_OP_SINH] = tinker_interval_sinh, [TINKER_OP_COSH] = tinker_interval_cosh,
        [TINKER_OP_TANH] = tinker_interval_tanh, [TINKER_OP_EXP] = tinker_interval_exp,
        [TINKER_OP_LOG] = tinker_interval_log,
    };
    *gentle = *gentle && is_gentle(operation, x);
    return functions[operation](x);
}

static TinkerInterval other(TinkerOperation operation, const TinkerInterval *a, const TinkerInterval *b,
                            const TinkerInterval *c, gboolean *gentle)
{
    switch (operation) {
    case TINKER_OP_TRUTH:
        return truth_of(*a, gentle);
    case TINKER_OP_PARITY:
        if (a->low != a->high) return (TinkerInterval){-1, 1};
        return tinker_interval_point(fmod(a->low, 2) == 0 ? 1 : -1);
    case TINKER_OP_POWER:
        return power_of(*a, *b, gentle);
    case TINKER_OP_ATAN2:
        return angle_of(*a, *b, *c, gentle);
    default:
        return function_of(operation, *a, gentle);
    }
}

static TinkerInterval divide(TinkerInterval a, TinkerInterval b, gboolean *gentle)
{
    *gentle = *gentle && ratio_of(b) <= RATIO;
    return tinker_interval_divide(a, b);
}

static TinkerInterval apply(const TinkerStep *at, const TinkerInterval *entry, gboolean *gentle)
{
    const TinkerInterval a = entry[at->a], b = entry[at->b], c = entry[at->c], d = entry[at->d];
    switch (at->code / TINKER_LATEST_COUNT) {
    case TINKER_STEP_ADD:
        return ADD(a, b);
    case TINKER_STEP_SUBTRACT:
        return SUB(a, b);
    case TINKER_STEP_MULTIPLY:
        return MUL(a, b);
    case TINKER_STEP_DIVIDE:
        return divide(a, b, gentle);
    case TINKER_STEP_SQUARE:
        return SQUARE(a);
    case TINKER_STEP_CUBE:
        return CUBE(a);
    case TINKER_STEP_TIMES_ADD:
        return ADD(MUL(a, b), c);
    case TINKER_STEP_TIMES_SQUARE_ADD:
        return ADD(MUL(a, SQUARE(b)), c);
    case TINKER_STEP_TIMES_CUBE_ADD:
        return ADD(MUL(a, CUBE(b)), c);
    case TINKER_STEP_TIMES_LESS:
        return SUB(MUL(a, b), c);
    case TINKER_STEP_LESS_TIMES:
        return SUB(c, MUL(a, b));
    case TINKER_STEP_PRODUCTS:
        return ADD(MUL(a, b), MUL(c, d));
    case TINKER_STEP_PRODUCTS_SQUARE:
        return ADD(MUL(a, b), MUL(c, SQUARE(d)));
    case TINKER_STEP_PRODUCTS_CUBE:
        return ADD(MUL(a, b), MUL(c, CUBE(d)));
    case TINKER_STEP_NEGATE:
        return tinker_interval_negate(a);
    case TINKER_STEP_SQRT:
        return tinker_interval_sqrt(a);
    case TINKER_STEP_CHOOSE:
        return choice_of(a, b, c);
    case TINKER_STEP_CELL:
        return cells_of(a, b.low, gentle);
    default:
        return other((TinkerOperation)(at->code / TINKER_LATEST_COUNT - TINKER_STEP_OTHER), &a, &b, &c, gentle);
    }
}

/* What an entry is made of. */
enum { OF_NUMBERS = 0, OF_DECIDED = 1, OF_OTHERS = 2 };

/* What an argument alone decides, worked out at one place of its interval. */
typedef struct {
    TinkerInterval at[TINKER_MOST_ENTRIES];
    guint8 made_of[TINKER_MOST_ENTRIES];
} Decided;

static void decide(Decided *decided, const TinkerStep *at)
{
    gboolean gentle = TRUE;
    decided->made_of[at->to] =
        decided->made_of[at->a] | decided->made_of[at->b] | decided->made_of[at->c] | decided->made_of[at->d];
    if ((decided->made_of[at->to] & OF_OTHERS) == 0) decided->at[at->to] = apply(at, decided->at, &gentle);
}

static gboolean is_decided(const Decided *decided, const TinkerStep *at)
{
    return at->code / TINKER_LATEST_COUNT == TINKER_STEP_CELL && decided->made_of[at->to] == OF_DECIDED;
}

gboolean tinker_compiled_enclose(const TinkerCompiled *compiled, const TinkerInterval *arguments, int decided_by,
                                 TinkerInterval *result)
{
    TinkerInterval entry[TINKER_MOST_ENTRIES];
    Decided decided;
    gboolean gentle = TRUE;
    for (int i = 0; i < compiled->arguments; i++) {
        entry[i] = arguments[i];
        decided.made_of[i] = i == decided_by ? OF_DECIDED : OF_OTHERS;
        decided.at[i] = tinker_interval_point(arguments[i].low + 0.5 * (arguments[i].high - arguments[i].low));
    }
    for (int i = 0, at = compiled->arguments; i < compiled->numbers; i++, at++) {
        entry[at] = decided.at[at] = tinker_interval_point(compiled->number[i]);
        decided.made_of[at] = OF_NUMBERS;
    }
    for (int i = 0; i < compiled->steps; i++) {
        const TinkerStep *at = &compiled->step[i];
        if (decided_by >= 0) decide(&decided, at);
        const gboolean known = decided_by >= 0 && is_decided(&decided, at);
        entry[at->to] = known ? decided.at[at->to] : apply(at, entry, &gentle);
    }
    *result = entry[compiled->answer];
    return gentle && !tinker_interval_is_empty(*result);
}

gboolean tinker_compiled_is_always_gentle(const TinkerCompiled *compiled)
{
    for (int i = 0; i < compiled->steps; i++) {
        const TinkerStep *at = &compiled->step[i];
        const int kind = at->code / TINKER_LATEST_COUNT, divisor = (int)at->b - compiled->arguments;
        const gboolean by_number = kind == TINKER_STEP_DIVIDE && divisor >= 0 && divisor < compiled->numbers;
        if (kind == TINKER_STEP_CELL || kind >= TINKER_STEP_OTHER || (kind == TINKER_STEP_DIVIDE && !by_number))
            return FALSE;
    }
    return TRUE;
}

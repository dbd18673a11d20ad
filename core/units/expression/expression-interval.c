/* Enclosing a program over an interval of time: the same rules as for jets, on intervals. What the search for breaks
 * needs: a range without zero excludes a root, a derivative without zero leaves one at most, a second derivative
 * without zero leaves two. */
#include <math.h>

#include "units/expression/expression-program.h"

#define PI 3.14159265358979323846

/* Short names for what every line here does. */
#define ADD(x, y)    tinker_interval_add(x, y)
#define SUB(x, y)    tinker_interval_subtract(x, y)
#define MUL(x, y)    tinker_interval_multiply(x, y)
#define DIV(x, y)    tinker_interval_divide(x, y)
#define SCALE(x, f)  tinker_interval_scale(x, f)
#define SQUARE(x)    tinker_interval_power(x, 2)
#define NEGATE(x)    tinker_interval_negate(x)
#define POINT(value) tinker_interval_point(value)

typedef struct {
    TinkerInterval value, slope, bend; /* phi, phi', phi'' over an argument's range */
} Enclosed;

static gboolean is_zero(TinkerInterval x)
{
    return x.low == 0 && x.high == 0;
}

static TinkerRangeJet constant(double value)
{
    return (TinkerRangeJet){POINT(value), POINT(0), POINT(0)};
}

static TinkerRangeJet chain(const TinkerRangeJet *u, const Enclosed *phi)
{
    if (is_zero(u->first) && is_zero(u->second)) return (TinkerRangeJet){phi->value, POINT(0), POINT(0)};
    return (TinkerRangeJet){phi->value, MUL(phi->slope, u->first),
                            ADD(MUL(phi->bend, SQUARE(u->first)), MUL(phi->slope, u->second))};
}

/* Derivatives are unbounded where the argument reaches the edge of the domain [low, high]. */
static Enclosed within(Enclosed phi, TinkerInterval x, double low, double high)
{
    if (x.low > low && x.high < high) return phi;
    return (Enclosed){phi.value, tinker_interval_entire(), tinker_interval_entire()};
}

/* 1/sqrt(1 - x^2) and its derivative x / sqrt(1 - x^2)^3. */
static Enclosed arc(TinkerInterval value, TinkerInterval x, double sign)
{
    const TinkerInterval y = DIV(POINT(sign), tinker_interval_sqrt(MUL(SUB(POINT(1), x), ADD(POINT(1), x))));
    return within((Enclosed){value, y, MUL(x, tinker_interval_power(y, 3))}, x, -1, 1);
}

static Enclosed enclose_function(TinkerOperation operation, TinkerInterval x)
{
    TinkerInterval y, z;
    switch (operation) {
    case TINKER_OP_SIN:
        y = tinker_interval_sin(x);
        return (Enclosed){y, tinker_interval_cos(x), NEGATE(y)};
    case TINKER_OP_COS:
        y = tinker_interval_cos(x);
        return (Enclosed){y, NEGATE(tinker_interval_sin(x)), NEGATE(y)};
    case TINKER_OP_TAN:
        y = tinker_interval_tan(x);
        z = ADD(POINT(1), SQUARE(y));
        return (Enclosed){y, z, SCALE(MUL(y, z), 2)};
    case TINKER_OP_ASIN:
        return arc(tinker_interval_asin(x), x, 1);
    case TINKER_OP_ACOS:
        return arc(tinker_interval_acos(x), x, -1);
    case TINKER_OP_ATAN:
        y = DIV(POINT(1), ADD(POINT(1), SQUARE(x)));
        return (Enclosed){tinker_interval_atan(x), y, SCALE(MUL(x, SQUARE(y)), -2)};
    case TINKER_OP_SINH:
        y = tinker_interval_sinh(x);
        return (Enclosed){y, tinker_interval_cosh(x), y};
    case TINKER_OP_COSH:
        y = tinker_interval_cosh(x);
        return (Enclosed){y, tinker_interval_sinh(x), y};
    case TINKER_OP_TANH:
        y = tinker_interval_tanh(x);
        z = DIV(POINT(1), SQUARE(tinker_interval_cosh(x)));
        return (Enclosed){y, z, SCALE(MUL(y, z), -2)};
    case TINKER_OP_EXP:
        y = tinker_interval_exp(x);
        return (Enclosed){y, y, y};
    case TINKER_OP_LOG:
        y = DIV(POINT(1), x);
        return within((Enclosed){tinker_interval_log(x), y, NEGATE(SQUARE(y))}, x, 0, INFINITY);
    case TINKER_OP_SQRT:
        y = tinker_interval_sqrt(x);
        z = DIV(POINT(0.5), y);
        return within((Enclosed){y, z, NEGATE(DIV(SCALE(z, 0.5), x))}, x, 0, INFINITY);
    default:
        g_return_val_if_reached(((Enclosed){x, x, x}));
    }
}

static TinkerRangeJet multiply(const TinkerRangeJet *a, const TinkerRangeJet *b)
{
    return (TinkerRangeJet){
        MUL(a->value, b->value), ADD(MUL(a->first, b->value), MUL(a->value, b->first)),
        ADD(ADD(MUL(a->second, b->value), SCALE(MUL(a->first, b->first), 2)), MUL(a->value, b->second))};
}

static TinkerRangeJet divide(const TinkerRangeJet *a, const TinkerRangeJet *b)
{
    TinkerRangeJet q;
    q.value = DIV(a->value, b->value);
    q.first = DIV(SUB(a->first, MUL(q.value, b->first)), b->value);
    q.second = DIV(SUB(SUB(a->second, SCALE(MUL(q.first, b->first), 2)), MUL(q.value, b->second)), b->value);
    return q;
}

static TinkerRangeJet power(const TinkerRangeJet *a, const TinkerRangeJet *b)
{
    if (b->value.low == b->value.high && is_zero(b->first) && is_zero(b->second)) {
        const double n = b->value.low;
        const Enclosed phi = {tinker_interval_power(a->value, n), SCALE(tinker_interval_power(a->value, n - 1), n),
                              SCALE(tinker_interval_power(a->value, n - 2), n * (n - 1))};
        const Enclosed all = floor(n) == n ? phi : within(phi, a->value, 0, INFINITY);
        return chain(a, &all);
    }
    const Enclosed log_phi = enclose_function(TINKER_OP_LOG, a->value);
    const TinkerRangeJet logarithm = chain(a, &log_phi);
    const TinkerRangeJet h = multiply(b, &logarithm);
    const Enclosed exp_phi = enclose_function(TINKER_OP_EXP, h.value);
    return chain(&h, &exp_phi);
}

/* The angle itself from the quadrant formulas that hold over the whole box; the half turn of the cell otherwise. */
static TinkerInterval angle_value(TinkerInterval y, TinkerInterval x, double cell)
{
    if (tinker_interval_is_empty(x) || tinker_interval_is_empty(y)) return tinker_interval_empty();
    if (x.low > 0) return tinker_interval_atan(DIV(y, x));
    if (tinker_interval_excludes_zero(y)) {
        const double quarter = y.low > 0 ? PI / 2 : -PI / 2;
        const TinkerInterval base = {nextafter(quarter, -INFINITY), nextafter(quarter, INFINITY)};
        return SUB(base, tinker_interval_atan(DIV(x, y)));
    }
    /* y is on the side of its cell but for rounding, and then the angle goes on beyond the cut */
    return cell < 0 ? (TinkerInterval){-2 * PI, PI} : (TinkerInterval){-PI, 2 * PI};
}

static TinkerRangeJet angle(const TinkerRangeJet *y, const TinkerRangeJet *x, double cell)
{
    const TinkerInterval square = ADD(SQUARE(x->value), SQUARE(y->value));
    const TinkerInterval growth = ADD(MUL(x->value, x->first), MUL(y->value, y->first));
    TinkerRangeJet result;
    result.value = angle_value(y->value, x->value, cell);
    result.first = DIV(SUB(MUL(x->value, y->first), MUL(y->value, x->first)), square);
    result.second = SUB(DIV(SUB(MUL(x->value, y->second), MUL(y->value, x->second)), square),
                        SCALE(DIV(MUL(result.first, growth), square), 2));
    return result;
}

static TinkerRangeJet enclose_one(const TinkerProgramState *state, const TinkerInstruction *code, int index,
                                  TinkerInterval time)
{
    const TinkerInstruction *instruction = &code[index];
    const TinkerRangeJet *ranges = state->ranges;
    switch (instruction->operation) {
    case TINKER_OP_CONSTANT:
        return constant(instruction->number);
    case TINKER_OP_TIME:
        return (TinkerRangeJet){time, POINT(1), POINT(0)};
    case TINKER_OP_SWITCH:
    case TINKER_OP_TRUTH:
        return constant(state->cells[index]);
    case TINKER_OP_CHOOSE:
        return ranges[state->cells[instruction->c] < 0 ? instruction->a : instruction->b];
    default:
        break;
    }
    const TinkerRangeJet *b = instruction->b >= 0 ? &ranges[instruction->b] : NULL;
    const double cell = instruction->c >= 0 ? state->cells[instruction->c] : 0;
    return tinker_range_jet_apply(instruction->operation, &ranges[instruction->a], b, cell);
}

TinkerRangeJet tinker_program_enclose(const TinkerProgramState *state, double low, double high)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(state->program, &count);
    for (int i = 0; i < state->live_count; i++)
        state->ranges[state->live[i]] = enclose_one(state, code, state->live[i], (TinkerInterval){low, high});
    return state->ranges[state->root];
}

TinkerRangeJet tinker_range_jet_apply(TinkerOperation operation, const TinkerRangeJet *a, const TinkerRangeJet *b,
                                      double cell)
{
    switch (operation) {
    case TINKER_OP_PARITY:
        return constant(fmod(a->value.low, 2) == 0 ? 1 : -1);
    case TINKER_OP_NEGATE:
        return (TinkerRangeJet){NEGATE(a->value), NEGATE(a->first), NEGATE(a->second)};
    case TINKER_OP_ADD:
        return (TinkerRangeJet){ADD(a->value, b->value), ADD(a->first, b->first), ADD(a->second, b->second)};
    case TINKER_OP_SUBTRACT:
        return (TinkerRangeJet){SUB(a->value, b->value), SUB(a->first, b->first), SUB(a->second, b->second)};
    case TINKER_OP_MULTIPLY:
        return multiply(a, b);
    case TINKER_OP_DIVIDE:
        return divide(a, b);
    case TINKER_OP_POWER:
        return power(a, b);
    case TINKER_OP_ATAN2:
        return angle(a, b, cell);
    default: {
        const Enclosed phi = enclose_function(operation, a->value);
        return chain(a, &phi);
    }
    }
}

/* Jets: value, first and second derivative carried forward together (A. Griewank, A. Walther, Evaluating Derivatives,
 * SIAM 2008, chapter 13). */
#include <math.h>

#include "units/expression/expression-program.h"

#define PI 3.14159265358979323846

/* phi(u): phi, phi', phi'' at u, and the chain rule. */
static TinkerJet chain(const TinkerJet *u, double phi, double slope, double bend)
{
    /* where u stands still so does phi(u), even where its slope is infinite, as of a root at 0 */
    if (u->first == 0 && u->second == 0) return (TinkerJet){phi, 0, 0};
    return (TinkerJet){phi, slope * u->first, bend * u->first * u->first + slope * u->second};
}

static TinkerJet apply_function(TinkerOperation operation, const TinkerJet *u)
{
    const double x = u->value;
    double y;
    switch (operation) {
    case TINKER_OP_SIN:
        return chain(u, sin(x), cos(x), -sin(x));
    case TINKER_OP_COS:
        return chain(u, cos(x), -sin(x), -cos(x));
    case TINKER_OP_TAN:
        y = tan(x);
        return chain(u, y, 1 + y * y, 2 * y * (1 + y * y));
    case TINKER_OP_ASIN:
        y = 1 / sqrt((1 - x) * (1 + x));
        return chain(u, asin(x), y, x * y * y * y);
    case TINKER_OP_ACOS:
        y = 1 / sqrt((1 - x) * (1 + x));
        return chain(u, acos(x), -y, -x * y * y * y);
    case TINKER_OP_ATAN:
        y = 1 / (1 + x * x);
        return chain(u, atan(x), y, -2 * x * y * y);
    case TINKER_OP_SINH:
        return chain(u, sinh(x), cosh(x), sinh(x));
    case TINKER_OP_COSH:
        return chain(u, cosh(x), sinh(x), cosh(x));
    case TINKER_OP_TANH:
        y = 1 / cosh(x);
        return chain(u, tanh(x), y * y, -2 * tanh(x) * y * y);
    case TINKER_OP_EXP:
        y = exp(x);
        return chain(u, y, y, y);
    case TINKER_OP_LOG:
        return chain(u, log(x), x >= 0 ? 1 / x : NAN, x >= 0 ? -1 / (x * x) : NAN);
    case TINKER_OP_SQRT:
        y = sqrt(x);
        return chain(u, y, 0.5 / y, -0.25 / (x * y));
    default:
        g_return_val_if_reached(*u);
    }
}

static TinkerJet multiply(const TinkerJet *a, const TinkerJet *b)
{
    return (TinkerJet){a->value * b->value, a->first * b->value + a->value * b->first,
                       a->second * b->value + 2 * a->first * b->first + a->value * b->second};
}

/* From a = q b and its derivatives. */
static TinkerJet divide(const TinkerJet *a, const TinkerJet *b)
{
    TinkerJet q;
    q.value = a->value / b->value;
    q.first = (a->first - q.value * b->first) / b->value;
    q.second = (a->second - 2 * q.first * b->first - q.value * b->second) / b->value;
    return q;
}

/* factor * x^exponent, 0 where the factor is, whatever the power. */
static double scaled_power(double factor, double x, double exponent)
{
    return factor == 0 ? 0 : factor * pow(x, exponent);
}

static TinkerJet power(const TinkerJet *a, const TinkerJet *b)
{
    const double x = a->value, n = b->value, value = pow(x, n);
    if (b->first == 0 && b->second == 0)
        return chain(a, value, scaled_power(n, x, n - 1), scaled_power(n * (n - 1), x, n - 2));
    /* a^b = exp(h) with h = b log(a) */
    const TinkerJet logarithm = apply_function(TINKER_OP_LOG, a);
    const TinkerJet h = multiply(b, &logarithm);
    return (TinkerJet){value, value * h.first, value * (h.first * h.first + h.second)};
}

/* The angle of (x, y): its rate is (x y' - y x') / (x^2 + y^2). Behind the cut, where y has crossed to the other side
 * of the one that `cell` names, the angle goes on smoothly beyond pi or -pi. */
static TinkerJet angle(const TinkerJet *y, const TinkerJet *x, double cell)
{
    const double square = x->value * x->value + y->value * y->value;
    TinkerJet result;
    result.value = atan2(y->value, x->value);
    if (x->value < 0 && cell < 0 && result.value > 0) result.value -= 2 * PI;
    if (x->value < 0 && cell >= 0 && result.value < 0) result.value += 2 * PI;
    result.first = (x->value * y->first - y->value * x->first) / square;
    result.second = (x->value * y->second - y->value * x->second) / square -
                    2 * result.first * (x->value * x->first + y->value * y->first) / square;
    return result;
}

double tinker_instruction_cell(const TinkerInstruction *instruction, double argument)
{
    if (instruction->operation == TINKER_OP_TRUTH) return argument != 0 ? 0 : -1;
    if (instruction->number != 0) return floor(argument / instruction->number);
    return argument < 0 ? -1 : 0;
}

double tinker_instruction_decide(const TinkerInstruction *instruction, const TinkerJet *argument)
{
    if (instruction->operation == TINKER_OP_TRUTH)
        return argument->value != 0 || argument->first != 0 || argument->second != 0 ? 0 : -1;
    const double cell = tinker_instruction_cell(instruction, argument->value);
    const gboolean touches = cell * instruction->number == argument->value && argument->first == 0;
    return touches && argument->second < 0 ? cell - 1 : cell;
}

TinkerJet tinker_jet_apply(TinkerOperation operation, const TinkerJet *a, const TinkerJet *b, double cell)
{
    switch (operation) {
    case TINKER_OP_PARITY:
        return (TinkerJet){fmod(a->value, 2) == 0 ? 1 : -1, 0, 0};
    case TINKER_OP_NEGATE:
        return (TinkerJet){-a->value, -a->first, -a->second};
    case TINKER_OP_ADD:
        return (TinkerJet){a->value + b->value, a->first + b->first, a->second + b->second};
    case TINKER_OP_SUBTRACT:
        return (TinkerJet){a->value - b->value, a->first - b->first, a->second - b->second};
    case TINKER_OP_MULTIPLY:
        return multiply(a, b);
    case TINKER_OP_DIVIDE:
        return divide(a, b);
    case TINKER_OP_POWER:
        return power(a, b);
    case TINKER_OP_ATAN2:
        return angle(a, b, cell);
    default:
        return apply_function(operation, a);
    }
}

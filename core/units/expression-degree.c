/* Which expressions are polynomials of t between their switches. */
#include <math.h>

#include "units/expression-private.h"

#define NO_POLYNOMIAL 1000

static int degree_of_power(const TinkerInstruction *code, const TinkerInstruction *power, int base, int exponent)
{
    const TinkerInstruction *number = &code[power->b];
    if (base == 0 && exponent == 0) return 0;
    if (number->operation != TINKER_OP_CONSTANT || number->number < 0 || number->number > 3 ||
        number->number != floor(number->number))
        return NO_POLYNOMIAL;
    return base * (int)number->number;
}

static int degree_of(const TinkerInstruction *code, const int *degrees, int index)
{
    const TinkerInstruction *instruction = &code[index];
    const int a = instruction->a >= 0 ? degrees[instruction->a] : 0;
    const int b = instruction->b >= 0 ? degrees[instruction->b] : 0;
    switch (instruction->operation) {
    case TINKER_OP_CONSTANT:
    case TINKER_OP_SWITCH:
    case TINKER_OP_TRUTH:
    case TINKER_OP_PARITY:
        return 0;
    case TINKER_OP_TIME:
        return 1;
    case TINKER_OP_NEGATE:
        return a;
    case TINKER_OP_CHOOSE:
    case TINKER_OP_ADD:
    case TINKER_OP_SUBTRACT:
        return MAX(a, b);
    case TINKER_OP_MULTIPLY:
        return a + b;
    case TINKER_OP_DIVIDE:
        return b == 0 ? a : NO_POLYNOMIAL;
    case TINKER_OP_POWER:
        return degree_of_power(code, instruction, a, b);
    default: /* functions */
        return a == 0 && b == 0 ? 0 : NO_POLYNOMIAL;
    }
}

int tinker_program_degree(const TinkerProgram *program)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(program, &count);
    g_autofree int *degrees = g_new0(int, count);
    for (int i = 0; i < count; i++)
        degrees[i] = MIN(degree_of(code, degrees, i), NO_POLYNOMIAL);
    return degrees[count - 1];
}

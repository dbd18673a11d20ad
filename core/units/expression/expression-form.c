/* Expressions as sums of a polynomial of t and of harmonics, within a piece: what a linear system can be stepped with
 * exactly. First whether a program has that form whatever the piece, then the form itself, carried from instruction to
 * instruction. */
#include "units/expression/expression-form.h"

#include <math.h>
#include <string.h>

/* What a form amounts to at most: the degree of its polynomial, -1 where there is none, and how many harmonics. */
typedef struct {
    int degree, harmonics;
} Shape;

#define MOST_DEGREE 3
#define NO_FORM     1000

static const Shape no_shape = {NO_FORM, NO_FORM};

static gboolean has_shape(Shape shape)
{
    return shape.degree <= MOST_DEGREE && shape.harmonics <= TINKER_MOST_HARMONICS;
}

static gboolean is_constant(Shape shape)
{
    return shape.degree == 0 && shape.harmonics == 0;
}

static Shape shape_of_product(Shape a, Shape b)
{
    if (is_constant(a)) return b;
    if (is_constant(b)) return a;
    if (a.harmonics == 0 && b.harmonics == 0) return (Shape){a.degree + b.degree, 0};
    if (a.degree > 0 || b.degree > 0) return no_shape;
    const int of_a = b.degree == 0 ? a.harmonics : 0, of_b = a.degree == 0 ? b.harmonics : 0;
    return (Shape){a.degree == 0 && b.degree == 0 ? 0 : -1, 2 * a.harmonics * b.harmonics + of_a + of_b};
}

static Shape shape_of_power(const TinkerInstruction *exponent, Shape base, Shape power)
{
    if (is_constant(base) && is_constant(power)) return base;
    if (exponent->operation != TINKER_OP_CONSTANT) return no_shape;
    if (exponent->number != 1 && exponent->number != 2 && exponent->number != 3) return no_shape;
    Shape shape = base;
    for (int i = 1; i < (int)exponent->number; i++)
        shape = shape_of_product(shape, base);
    return shape;
}

static Shape shape_of(const TinkerInstruction *code, const Shape *shapes, int index)
{
    const TinkerInstruction *instruction = &code[index];
    const Shape a = instruction->a >= 0 ? shapes[instruction->a] : (Shape){0, 0};
    const Shape b = instruction->b >= 0 ? shapes[instruction->b] : (Shape){0, 0};
    if (!has_shape(a) || !has_shape(b)) return no_shape;
    switch (instruction->operation) {
    case TINKER_OP_CONSTANT:
    case TINKER_OP_SWITCH:
    case TINKER_OP_TRUTH:
    case TINKER_OP_PARITY:
        return (Shape){0, 0};
    case TINKER_OP_TIME:
        return (Shape){1, 0};
    case TINKER_OP_NEGATE:
        return a;
    case TINKER_OP_CHOOSE:
        return (Shape){MAX(a.degree, b.degree), MAX(a.harmonics, b.harmonics)};
    case TINKER_OP_ADD:
    case TINKER_OP_SUBTRACT:
        return (Shape){MAX(a.degree, b.degree), a.harmonics + b.harmonics};
    case TINKER_OP_MULTIPLY:
        return shape_of_product(a, b);
    case TINKER_OP_DIVIDE:
        return is_constant(b) ? a : no_shape;
    case TINKER_OP_POWER:
        return shape_of_power(&code[instruction->b], a, b);
    case TINKER_OP_SIN:
    case TINKER_OP_COS:
        if (is_constant(a)) return a;
        return a.degree <= 1 && a.harmonics == 0 ? (Shape){-1, 1} : no_shape;
    default: /* other functions */
        return is_constant(a) && is_constant(b) ? a : no_shape;
    }
}

/* A switch is decided by its argument, whatever that is like. */
static gboolean switches(const TinkerInstruction *instruction)
{
    return instruction->operation == TINKER_OP_SWITCH || instruction->operation == TINKER_OP_TRUTH;
}

int tinker_program_harmonics(const TinkerProgram *program)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(program, &count);
    g_autofree Shape *shapes = g_new0(Shape, count);
    for (int i = 0; i < count; i++)
        shapes[i] = switches(&code[i]) ? (Shape){0, 0} : shape_of(code, shapes, i);
    const Shape shape = shapes[count - 1];
    return has_shape(shape) ? shape.harmonics : -1;
}

/* Forms ------------------------------------------------------------------------------------------------------------ */

static void add_scaled(TinkerForm *form, const TinkerForm *other, double factor)
{
    for (int k = 0; k <= MOST_DEGREE; k++)
        form->polynomial[k] += factor * other->polynomial[k];
    for (int i = 0; i < other->count && form->count < TINKER_MOST_HARMONICS; i++) {
        TinkerHarmonic harmonic = other->harmonics[i];
        harmonic.amplitude *= factor;
        form->harmonics[form->count++] = harmonic;
    }
}

static void add_harmonic(TinkerForm *form, double amplitude, double frequency, double phase)
{
    if (form->count < TINKER_MOST_HARMONICS)
        form->harmonics[form->count++] = (TinkerHarmonic){amplitude, frequency, phase};
}

/* sin x sin y = (cos(x - y) - cos(x + y)) / 2 */
static TinkerForm product(const TinkerForm *a, const TinkerForm *b)
{
    TinkerForm form = {0};
    for (int i = 0; i <= MOST_DEGREE; i++)
        for (int k = 0; i + k <= MOST_DEGREE; k++)
            form.polynomial[i + k] += a->polynomial[i] * b->polynomial[k];
    TinkerForm a_only = {.count = a->count}, b_only = {.count = b->count};
    memcpy(a_only.harmonics, a->harmonics, sizeof(a->harmonics));
    memcpy(b_only.harmonics, b->harmonics, sizeof(b->harmonics));
    if (b->polynomial[0] != 0) add_scaled(&form, &a_only, b->polynomial[0]);
    if (a->polynomial[0] != 0) add_scaled(&form, &b_only, a->polynomial[0]);
    for (int i = 0; i < a->count; i++) {
        for (int k = 0; k < b->count; k++) {
            const TinkerHarmonic *x = &a->harmonics[i], *y = &b->harmonics[k];
            const double half = 0.5 * x->amplitude * y->amplitude;
            add_harmonic(&form, half, x->frequency - y->frequency, x->phase - y->phase + G_PI_2);
            add_harmonic(&form, -half, x->frequency + y->frequency, x->phase + y->phase + G_PI_2);
        }
    }
    return form;
}

static TinkerForm constant(double value)
{
    return (TinkerForm){.polynomial = {value}};
}

static TinkerForm power(const TinkerForm *base, const TinkerForm *exponent)
{
    const double n = exponent->polynomial[0];
    if (n != 1 && n != 2 && n != 3) return constant(pow(base->polynomial[0], n));
    TinkerForm form = *base;
    for (int i = 1; i < (int)n; i++)
        form = product(&form, base);
    return form;
}

static gboolean stands_still(const TinkerForm *form)
{
    return form->polynomial[1] == 0 && form->count == 0;
}

static TinkerForm sine(const TinkerForm *argument, double quarter)
{
    if (stands_still(argument))
        return constant(quarter != 0 ? cos(argument->polynomial[0]) : sin(argument->polynomial[0]));
    TinkerForm form = {0};
    add_harmonic(&form, 1, argument->polynomial[1], argument->polynomial[0] + quarter);
    return form;
}

static TinkerForm form_of(const TinkerProgramState *state, const TinkerForm *forms,
                          const TinkerInstruction *instruction, double cell, double t)
{
    const TinkerForm zero = {0};
    const TinkerForm *a = instruction->a >= 0 ? &forms[instruction->a] : &zero;
    const TinkerForm *b = instruction->b >= 0 ? &forms[instruction->b] : &zero;
    TinkerForm form = *a;
    switch (instruction->operation) {
    case TINKER_OP_CONSTANT:
        return constant(instruction->number);
    case TINKER_OP_TIME:
        return (TinkerForm){.polynomial = {t, 1}};
    case TINKER_OP_SWITCH:
    case TINKER_OP_TRUTH:
        return constant(cell);
    case TINKER_OP_CHOOSE:
        return state->cells[instruction->c] < 0 ? *a : *b;
    case TINKER_OP_ADD:
        add_scaled(&form, b, 1);
        return form;
    case TINKER_OP_SUBTRACT:
        add_scaled(&form, b, -1);
        return form;
    case TINKER_OP_MULTIPLY:
        return product(a, b);
    case TINKER_OP_NEGATE:
        form = zero;
        add_scaled(&form, a, -1);
        return form;
    case TINKER_OP_DIVIDE:
        form = zero;
        add_scaled(&form, a, 1 / b->polynomial[0]);
        return form;
    case TINKER_OP_POWER:
        return power(a, b);
    case TINKER_OP_SIN:
        return sine(a, 0);
    case TINKER_OP_COS:
        return sine(a, G_PI_2);
    default: { /* of constants alone */
        const TinkerJet left = {a->polynomial[0], 0, 0}, right = {b->polynomial[0], 0, 0};
        return constant(tinker_jet_apply(instruction->operation, &left, &right, cell).value);
    }
    }
}

void tinker_program_form(const TinkerProgramState *state, double t, TinkerForm *form)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(state->program, &count);
    g_autofree TinkerForm *forms = g_new0(TinkerForm, count);
    for (int i = 0; i < state->live_count; i++) {
        const int index = state->live[i];
        const TinkerInstruction *instruction = &code[index];
        const double cell = switches(instruction) ? state->cells[index]
                            : instruction->c >= 0 ? state->cells[instruction->c]
                                                  : 0;
        forms[index] = form_of(state, forms, instruction, cell, t);
    }
    *form = forms[state->root];
}

/* From instructions to steps, without changing a bit of what they answer: what is worked out twice is worked out once,
 * a product that is only added to something is one step with that, and registers are used again. */
#include <string.h>

#include "units/compiled/compiled-private.h"

#define MOST_STEPS 1024 /* of a program before it is put together */

/* An instruction on its way. Entries are those of the draft itself. */
typedef struct {
    TinkerInstruction is;
    int d;     /* what a step reads besides; -1: nothing */
    int kind;  /* of the step; NO_STEP: an argument, a number, or a part of another step */
    int uses;  /* by others and as the answer */
    int last;  /* the last one that uses it */
    int entry; /* of the machine */
} Draft;

#define NO_STEP (-1)

typedef struct {
    Draft *draft;
    int count, arguments, steps, registers;
    GArray *numbers; /* of double */
} Assembly;

static gboolean is_same(const TinkerInstruction *left, const TinkerInstruction *right)
{
    return left->operation == right->operation && left->a == right->a && left->b == right->b && left->c == right->c &&
           memcmp(&left->number, &right->number, sizeof left->number) == 0;
}

static int moved_to(const int *moved, int operand)
{
    return operand >= 0 ? moved[operand] : operand;
}

static void take(Assembly *to, const TinkerInstruction *code, int length)
{
    g_autofree int *moved = g_new(int, (gsize)length);
    for (int i = 0; i < length; i++) {
        TinkerInstruction at = code[i];
        at.a = moved_to(moved, at.a);
        at.b = moved_to(moved, at.b);
        at.c = moved_to(moved, at.c);
        int place = 0;
        while (place < to->count && !is_same(&to->draft[place].is, &at))
            place++;
        if (place == to->count) to->draft[to->count++] = (Draft){.is = at, .d = -1};
        moved[i] = place;
    }
    to->count = moved[length - 1] + 1; /* the last one is the answer, and asks for none behind it */
}

static int kind_of(TinkerOperation operation)
{
    switch (operation) {
    case TINKER_OP_CONSTANT:
    case TINKER_OP_TIME:
        return NO_STEP;
    case TINKER_OP_ADD:
        return TINKER_STEP_ADD;
    case TINKER_OP_SUBTRACT:
        return TINKER_STEP_SUBTRACT;
    case TINKER_OP_MULTIPLY:
        return TINKER_STEP_MULTIPLY;
    case TINKER_OP_DIVIDE:
        return TINKER_STEP_DIVIDE;
    case TINKER_OP_NEGATE:
        return TINKER_STEP_NEGATE;
    case TINKER_OP_SQRT:
        return TINKER_STEP_SQRT;
    case TINKER_OP_CHOOSE:
        return TINKER_STEP_CHOOSE;
    case TINKER_OP_SWITCH:
        return TINKER_STEP_CELL;
    default:
        return TINKER_STEP_OTHER + (int)operation;
    }
}

static void count_uses(Assembly *assembly)
{
    for (int i = 0; i < assembly->count; i++)
        assembly->draft[i].uses = i == assembly->count - 1;
    for (int i = assembly->count - 1; i >= 0; i--) {
        const TinkerInstruction *at = &assembly->draft[i].is;
        const int operands[] = {at->a, at->b, at->c};
        for (gsize k = 0; k < G_N_ELEMENTS(operands); k++)
            if (operands[k] >= 0 && assembly->draft[i].uses > 0) assembly->draft[operands[k]].uses++;
    }
}

static void count_arguments(Assembly *assembly)
{
    for (int i = 0; i < assembly->count; i++) {
        const Draft *at = &assembly->draft[i];
        if (at->uses > 0 && at->is.operation == TINKER_OP_TIME)
            assembly->arguments = MAX(assembly->arguments, 1 + (int)at->is.number);
    }
}

static void find_powers(Assembly *assembly)
{
    for (int i = 0; i < assembly->count; i++) {
        Draft *at = &assembly->draft[i];
        if (at->uses == 0 || at->kind != TINKER_STEP_MULTIPLY) continue;
        Draft *first = &assembly->draft[at->is.a];
        if (at->is.a == at->is.b) {
            at->kind = TINKER_STEP_SQUARE;
        } else if (first->kind == TINKER_STEP_SQUARE && first->uses == 1 && first->is.a == at->is.b) {
            at->kind = TINKER_STEP_CUBE;
            at->is.a = at->is.b;
            first->kind = NO_STEP;
            first->uses = 0;
        } else {
            continue;
        }
        at->is.b = -1;
    }
}

/* What only one other asks for, and is of this kind; else NULL. */
static Draft *single(Assembly *assembly, int operand, TinkerStepKind kind)
{
    Draft *part = &assembly->draft[operand];
    return part->kind == (int)kind && part->uses == 1 ? part : NULL;
}

/* Two factors and what is added to their product. */
static void join(Draft *whole, Draft *product, TinkerStepKind kind, int rest)
{
    whole->kind = (int)kind;
    whole->is.a = product->is.a;
    whole->is.b = product->is.b;
    whole->is.c = rest;
    product->kind = NO_STEP;
    product->uses = 0;
}

static void exchange(int *a, int *b)
{
    const int kept = *a;
    *a = *b;
    *b = kept;
}

/* Takes a power that is the factor `of` of a step, or becomes it, into the step: its kind grows by the power less 1. */
static void join_power(Assembly *assembly, Draft *whole, int *other, int *of)
{
    for (int turn = 0; turn < 2; turn++) {
        for (TinkerStepKind kind = TINKER_STEP_SQUARE; kind <= TINKER_STEP_CUBE; kind++) {
            Draft *power = single(assembly, *of, kind);
            if (power == NULL) continue;
            whole->kind += 1 + (int)(kind - TINKER_STEP_SQUARE);
            *of = power->is.a;
            power->kind = NO_STEP;
            power->uses = 0;
            return;
        }
        exchange(other, of);
    }
}

/* a b + c, or a b + c d. */
static void join_sum(Assembly *assembly, Draft *at)
{
    Draft *first = single(assembly, at->is.a, TINKER_STEP_MULTIPLY);
    Draft *second = single(assembly, at->is.b, TINKER_STEP_MULTIPLY);
    if (first == NULL && second == NULL) return;
    if (first == NULL || second == NULL) {
        join(at, first != NULL ? first : second, TINKER_STEP_TIMES_ADD, first != NULL ? at->is.b : at->is.a);
        join_power(assembly, at, &at->is.a, &at->is.b);
        return;
    }
    at->d = second->is.b;
    const int third = second->is.a;
    second->kind = NO_STEP;
    second->uses = 0;
    join(at, first, TINKER_STEP_PRODUCTS, third);
    join_power(assembly, at, &at->is.c, &at->d);
    if (at->kind != TINKER_STEP_PRODUCTS) return;
    exchange(&at->is.a, &at->is.c);
    exchange(&at->is.b, &at->d);
    join_power(assembly, at, &at->is.c, &at->d);
}

static void join_difference(Assembly *assembly, Draft *at)
{
    Draft *first = single(assembly, at->is.a, TINKER_STEP_MULTIPLY);
    Draft *second = single(assembly, at->is.b, TINKER_STEP_MULTIPLY);
    if (second != NULL)
        join(at, second, TINKER_STEP_LESS_TIMES, at->is.a);
    else if (first != NULL)
        join(at, first, TINKER_STEP_TIMES_LESS, at->is.b);
}

static void join_products(Assembly *assembly)
{
    for (int i = 0; i < assembly->count; i++) {
        Draft *at = &assembly->draft[i];
        if (at->uses == 0) continue;
        if (at->kind == TINKER_STEP_ADD) join_sum(assembly, at);
        if (at->kind == TINKER_STEP_SUBTRACT) join_difference(assembly, at);
    }
}

static guint16 number_entry(Assembly *assembly, double number)
{
    for (guint i = 0; i < assembly->numbers->len; i++)
        if (memcmp(&g_array_index(assembly->numbers, double, i), &number, sizeof number) == 0)
            return (guint16)(assembly->arguments + (int)i);
    g_array_append_val(assembly->numbers, number);
    return (guint16)(assembly->arguments + (int)assembly->numbers->len - 1);
}

/* The entries of arguments and numbers; a cell's period is a number, too. */
static void place_leaves(Assembly *assembly)
{
    for (int i = 0; i < assembly->count; i++) {
        Draft *at = &assembly->draft[i];
        if (at->uses == 0) continue;
        if (at->is.operation == TINKER_OP_CONSTANT) at->entry = number_entry(assembly, at->is.number);
        if (at->is.operation == TINKER_OP_TIME) at->entry = (guint16)at->is.number;
        assembly->steps += at->kind != NO_STEP;
        const int operands[] = {at->is.a, at->is.b, at->is.c, at->d};
        for (gsize k = 0; k < G_N_ELEMENTS(operands); k++)
            if (operands[k] >= 0) assembly->draft[operands[k]].last = i;
    }
    assembly->draft[assembly->count - 1].last = assembly->count;
}

/* What is not there is read as something that is. */
static guint16 entry_of(const Assembly *assembly, int operand, int otherwise)
{
    return assembly->draft[operand >= 0 ? operand : otherwise].entry;
}

/* A register that nothing waits for any longer is given to the next: `ends` says of each until when it is waited for.
 */
static int free_register(Assembly *assembly, int *ends, int now, int last)
{
    int found = 0;
    while (found < assembly->registers && ends[found] >= now)
        found++;
    assembly->registers = MAX(assembly->registers, found + 1);
    ends[found] = last;
    return found;
}

static TinkerLatest latest_of(const Draft *draft, int before)
{
    if (before < 0) return TINKER_LATEST_NONE;
    if (draft->is.a == before) return TINKER_LATEST_A;
    if (draft->is.b == before) return TINKER_LATEST_B;
    if (draft->is.c == before) return TINKER_LATEST_C;
    return draft->d == before ? TINKER_LATEST_D : TINKER_LATEST_NONE;
}

static void write_steps(Assembly *assembly, TinkerStep *steps)
{
    g_autofree int *ends = g_new(int, (guint)assembly->count);
    const int first = assembly->arguments + (int)assembly->numbers->len;
    int before = -1;
    for (int i = 0; i < assembly->count; i++) {
        Draft *at = &assembly->draft[i];
        if (at->uses == 0 || at->kind == NO_STEP) continue;
        const guint16 to = (guint16)(first + free_register(assembly, ends, i, at->last));
        *steps++ = (TinkerStep){
            .code = (guint16)(TINKER_LATEST_COUNT * at->kind + (int)latest_of(at, before)),
            .to = to,
            .a = entry_of(assembly, at->is.a, at->is.a),
            .b = at->kind == TINKER_STEP_CELL ? number_entry(assembly, at->is.number)
                                              : entry_of(assembly, at->is.b, at->is.a),
            .c = entry_of(assembly, at->is.c, at->is.a),
            .d = entry_of(assembly, at->d, at->is.a),
        };
        at->entry = to;
        before = i;
    }
}

/* NULL: it has more entries than there may be. (transfer full) */
static TinkerCompiled *assemble(const TinkerInstruction *code, int length)
{
    g_autofree Draft *draft = g_new0(Draft, (gsize)length);
    g_autoptr(GArray) numbers = g_array_new(FALSE, FALSE, sizeof(double));
    Assembly assembly = {.draft = draft, .numbers = numbers};
    take(&assembly, code, length);
    for (int i = 0; i < assembly.count; i++)
        draft[i].kind = kind_of(draft[i].is.operation);
    count_uses(&assembly);
    count_arguments(&assembly);
    find_powers(&assembly);
    join_products(&assembly);
    for (int i = 0; i < assembly.count; i++)
        if (draft[i].uses > 0 && draft[i].kind == TINKER_STEP_CELL) number_entry(&assembly, draft[i].is.number);
    place_leaves(&assembly);
    const gsize size = sizeof(TinkerCompiled) + (gsize)assembly.steps * sizeof(TinkerStep);
    const gsize aligned = (size + sizeof(double) - 1) / sizeof(double) * sizeof(double);
    TinkerCompiled *compiled = g_malloc0(aligned + MAX(numbers->len, TINKER_USUAL_NUMBERS) * sizeof(double));
    write_steps(&assembly, compiled->step);
    if (assembly.arguments + (int)numbers->len + assembly.registers > TINKER_MOST_ENTRIES) {
        g_free(compiled);
        return NULL;
    }
    double *own = (double *)(void *)((char *)compiled + aligned);
    if (numbers->len > 0) memcpy(own, numbers->data, numbers->len * sizeof(double));
    compiled->arguments = assembly.arguments;
    compiled->numbers = (int)numbers->len;
    compiled->registers = assembly.registers;
    compiled->steps = assembly.steps;
    compiled->answer = draft[assembly.count - 1].entry;
    compiled->number = own;
    return compiled;
}

TinkerCompiled *tinker_compiled_new(const TinkerExpression *expression, const char *const *names, int count)
{
    g_autoptr(TinkerProgram) program = tinker_program_of_tree(expression, names, count, MOST_STEPS);
    if (program == NULL) return NULL;
    int length;
    const TinkerInstruction *code = tinker_program_code(program, &length);
    return assemble(code, length);
}

void tinker_compiled_free(TinkerCompiled *compiled)
{
    g_free(compiled);
}

const double *tinker_compiled_numbers(const TinkerCompiled *compiled, int *count)
{
    *count = compiled->numbers;
    return compiled->number;
}

gboolean tinker_compiled_alike(const TinkerCompiled *a, const TinkerCompiled *b)
{
    return a->arguments == b->arguments && a->numbers == b->numbers && a->registers == b->registers &&
           a->steps == b->steps && a->answer == b->answer &&
           memcmp(a->step, b->step, (gsize)a->steps * sizeof(TinkerStep)) == 0;
}

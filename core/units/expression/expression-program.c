/* Putting a program together: instructions with constant operands are folded at once, and in the end those that the
 * value does not need are thrown away, so that they cost nothing and cause no breaks. */
#include "units/expression/expression-program.h"

static const TinkerInstruction *instruction_at(const TinkerProgram *program, int index)
{
    return &g_array_index(program->code, TinkerInstruction, index);
}

static const TinkerInstruction *constant_at(const TinkerProgram *program, int index)
{
    if (index < 0) return NULL;
    const TinkerInstruction *instruction = instruction_at(program, index);
    return instruction->operation == TINKER_OP_CONSTANT ? instruction : NULL;
}

static int append(TinkerProgram *program, TinkerInstruction instruction)
{
    g_array_append_val(program->code, instruction);
    return (int)program->code->len - 1;
}

/* The value of an instruction whose operands are constants. */
static double fold(const TinkerProgram *program, const TinkerInstruction *instruction)
{
    const TinkerJet a = {constant_at(program, instruction->a)->number, 0, 0};
    if (instruction->operation == TINKER_OP_SWITCH || instruction->operation == TINKER_OP_TRUTH)
        return tinker_instruction_cell(instruction, a.value);
    const TinkerInstruction *second = constant_at(program, instruction->b);
    const TinkerInstruction *third = constant_at(program, instruction->c);
    const TinkerJet b = {second != NULL ? second->number : 0, 0, 0};
    return tinker_jet_apply(instruction->operation, &a, &b, third != NULL ? third->number : 0).value;
}

/* Marks what the last instruction needs, the arguments of switches included. */
static void mark_needed(const TinkerProgram *program, int value, gboolean *needed)
{
    needed[value] = TRUE;
    for (int i = value; i >= 0; i--) {
        if (!needed[i]) continue;
        const TinkerInstruction *instruction = instruction_at(program, i);
        const int operands[] = {instruction->a, instruction->b, instruction->c};
        for (gsize j = 0; j < G_N_ELEMENTS(operands); j++)
            if (operands[j] >= 0) needed[operands[j]] = TRUE;
    }
}

TinkerProgram *tinker_program_new(void)
{
    TinkerProgram *program = g_new0(TinkerProgram, 1);
    program->code = g_array_new(FALSE, FALSE, sizeof(TinkerInstruction));
    program->guards = g_array_new(FALSE, FALSE, sizeof(TinkerGuard));
    return program;
}

int tinker_program_emit(TinkerProgram *program, TinkerInstruction instruction)
{
    const TinkerInstruction *chooser = constant_at(program, instruction.c);
    if (instruction.operation == TINKER_OP_CHOOSE) {
        if (chooser == NULL) return append(program, instruction);
        return chooser->number < 0 ? instruction.a : instruction.b;
    }
    const gboolean leaf = instruction.operation == TINKER_OP_CONSTANT || instruction.operation == TINKER_OP_TIME;
    const gboolean constant = !leaf && constant_at(program, instruction.a) != NULL &&
                              (instruction.b < 0 || constant_at(program, instruction.b) != NULL) &&
                              (instruction.c < 0 || chooser != NULL);
    if (!constant) return append(program, instruction);
    const double value = fold(program, &instruction);
    return append(program, (TinkerInstruction){TINKER_OP_CONSTANT, -1, -1, -1, instruction.guard, value});
}

int tinker_program_add_guard(TinkerProgram *program, TinkerGuard guard)
{
    g_array_append_val(program->guards, guard);
    return (int)program->guards->len - 1;
}

void tinker_program_finish(TinkerProgram *program, int value)
{
    g_autofree gboolean *needed = g_new0(gboolean, program->code->len);
    g_autofree int *moved = g_new(int, program->code->len);
    mark_needed(program, value, needed);
    /* a guard's own condition stands before what it guards, and is needed where that is: CHOOSE names both */
    guint kept = 0;
    for (int i = 0; i <= value; i++) {
        if (!needed[i]) continue;
        TinkerInstruction instruction = *instruction_at(program, i);
        int *operands[] = {&instruction.a, &instruction.b, &instruction.c};
        for (gsize j = 0; j < G_N_ELEMENTS(operands); j++)
            if (*operands[j] >= 0) *operands[j] = moved[*operands[j]];
        moved[i] = (int)kept;
        g_array_index(program->code, TinkerInstruction, kept++) = instruction;
    }
    for (guint i = 0; i < program->guards->len; i++) {
        TinkerGuard *guard = &g_array_index(program->guards, TinkerGuard, i);
        guard->truth = needed[guard->truth] ? moved[guard->truth] : -1;
    }
    g_array_set_size(program->code, kept);
}

void tinker_program_free(TinkerProgram *program)
{
    g_array_unref(program->code);
    g_array_unref(program->guards);
    g_free(program);
}

const TinkerInstruction *tinker_program_code(const TinkerProgram *program, int *count)
{
    *count = (int)program->code->len;
    return (const TinkerInstruction *)(void *)program->code->data;
}

gboolean tinker_program_switches(const TinkerProgram *program)
{
    for (guint i = 0; i < program->code->len; i++)
        if (instruction_at(program, (int)i)->operation == TINKER_OP_SWITCH) return TRUE;
    return FALSE;
}

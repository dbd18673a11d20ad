/* Evaluating a program: value, first and second derivative carried forward together (jets, see A. Griewank, A. Walther,
 * Evaluating Derivatives, SIAM 2008, chapter 13), within the cells of a piece. */
#include <math.h>
#include <string.h>

#include "units/expression/expression-program.h"

static void mark(guint8 *marks, int index)
{
    if (index >= 0) marks[index] = TRUE;
}

static TinkerJet evaluate_one(const TinkerProgramState *state, const TinkerInstruction *code, int index, double t)
{
    const TinkerInstruction *instruction = &code[index];
    const TinkerJet *jets = state->jets;
    switch (instruction->operation) {
    case TINKER_OP_CONSTANT:
        return (TinkerJet){instruction->number, 0, 0};
    case TINKER_OP_TIME:
        return (TinkerJet){t, 1, 0};
    case TINKER_OP_SWITCH:
    case TINKER_OP_TRUTH:
        return (TinkerJet){state->cells[index], 0, 0};
    case TINKER_OP_CHOOSE:
        return jets[state->cells[instruction->c] < 0 ? instruction->a : instruction->b];
    default:
        break;
    }
    const TinkerJet *b = instruction->b >= 0 ? &jets[instruction->b] : NULL;
    const double cell = instruction->c >= 0 ? state->cells[instruction->c] : 0;
    return tinker_jet_apply(instruction->operation, &jets[instruction->a], b, cell);
}

static gboolean switches(const TinkerInstruction *instruction)
{
    return instruction->operation == TINKER_OP_SWITCH || instruction->operation == TINKER_OP_TRUTH;
}

void tinker_program_state_init(TinkerProgramState *state, const TinkerProgram *program, gboolean searching)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(program, &count);
    *state = (TinkerProgramState){
        .program = program,
        .cells = g_new0(double, count),
        .marks = g_new0(guint8, count),
        .live = g_new0(int, count),
        .jets = g_new0(TinkerJet, count),
        .ranges = searching ? g_new0(TinkerRangeJet, count) : NULL,
        .affine = searching ? g_new0(TinkerAffine, count) : NULL,
    };
    /* a switch with a constant argument was folded into the constant of its cell */
    for (int i = 0; i < count; i++)
        if (code[i].operation == TINKER_OP_CONSTANT) state->cells[i] = code[i].number;
}

void tinker_program_state_clear(TinkerProgramState *state)
{
    g_free(state->cells);
    g_free(state->marks);
    g_free(state->live);
    g_free(state->jets);
    g_free(state->ranges);
    g_free(state->affine);
}

void tinker_program_decide(TinkerProgramState *state, double inside)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(state->program, &count);
    for (int i = 0; i < count; i++) {
        if (switches(&code[i])) state->cells[i] = tinker_instruction_decide(&code[i], &state->jets[code[i].a]);
        state->jets[i] = evaluate_one(state, code, i, inside);
    }
    tinker_program_select(state, count - 1);
}

void tinker_program_select(TinkerProgramState *state, int root)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(state->program, &count);
    memset(state->marks, 0, (gsize)root + 1);
    state->marks[root] = TRUE;
    for (int i = root; i >= 0; i--) {
        if (!state->marks[i] || switches(&code[i])) continue;
        if (code[i].operation == TINKER_OP_CHOOSE) {
            mark(state->marks, state->cells[code[i].c] < 0 ? code[i].a : code[i].b);
        } else {
            mark(state->marks, code[i].a);
            mark(state->marks, code[i].b);
        }
    }
    state->root = root;
    state->live_count = 0;
    for (int i = 0; i <= root; i++)
        if (state->marks[i]) state->live[state->live_count++] = i;
}

TinkerJet tinker_program_evaluate(const TinkerProgramState *state, double t)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(state->program, &count);
    for (int i = 0; i < state->live_count; i++)
        state->jets[state->live[i]] = evaluate_one(state, code, state->live[i], t);
    return state->jets[state->root];
}

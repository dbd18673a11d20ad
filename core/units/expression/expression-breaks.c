/* The next break of a program: the first time at which one of its switches changes its cell.
 *
 * The switches are gone through in the order of the program, so those that an argument depends on come before it. The
 * horizon shrinks to the earliest break so far; up to there all earlier switches keep their cells, and the argument of
 * the next one is smooth. An argument that is affine in t is solved for. Any other is walked along in intervals over
 * which enclosures decide:
 *     the range stays in one cell       nothing happens,
 *     the derivative has no zero        the cells at the two ends say all,
 *     the second derivative has none    the cells at the ends and at the extremum say all, if it is in one,
 * and an interval that is not decided is halved, down to 4 ulp. Cells at single times count only where rounding cannot
 * have made them, so a function that touches a level, or is nothing but noise about it, gives no break.
 * The work is bounded: behind MOST_WORK instructions the rest of the horizon is looked at in SAMPLES places. */
#include <math.h>

#include "units/expression/expression-program.h"
#include "units/expression/time-inside.h"

#define BEYOND    64     /* ulp of the horizon: looked at as well, since a break at the horizon shows only behind it */
#define MOST_WORK 500000 /* instructions enclosed in one search, some hundredths of a second */
#define SAMPLES   1024
#define UNDEFINED (-HUGE_VAL) /* the cell of an argument that is no number */

/* Walks along the argument of one switch. */
typedef struct {
    TinkerProgramState *state; /* the argument is selected */
    const TinkerInstruction *instruction;
    gint64 *work_left;
    double cell;    /* the last that was certain */
    double since;   /* where that was */
    gboolean known; /* whether there was one yet */
} Walk;

/* The cell of all values in a range; FALSE where there are several. */
static gboolean certain_cell(const TinkerInstruction *instruction, TinkerInterval range, double *cell)
{
    if (tinker_interval_is_empty(range)) {
        *cell = UNDEFINED;
        return TRUE;
    }
    *cell = tinker_instruction_cell(instruction, range.low);
    return isfinite(range.low) && isfinite(range.high) && *cell == tinker_instruction_cell(instruction, range.high);
}

static double cell_at(const Walk *walk, double t)
{
    const double argument = tinker_program_evaluate(walk->state, t).value;
    return isnan(argument) ? UNDEFINED : tinker_instruction_cell(walk->instruction, argument);
}

static TinkerRangeJet enclose(Walk *walk, double low, double high)
{
    *walk->work_left -= walk->state->live_count;
    return tinker_program_enclose(walk->state, low, high);
}

/* Bisects down to neighbours: the first time at which the cell is no longer that at `low`. */
static double refine(const Walk *walk, double low, double high)
{
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return high;
        if (cell_at(walk, middle) == walk->cell) {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/* Takes note of the cell at t; TRUE with the break where it is another than before. */
static gboolean note(Walk *walk, double cell, double t, double *found)
{
    if (walk->known && cell != walk->cell) {
        *found = refine(walk, walk->since, t);
        return TRUE;
    }
    walk->known = TRUE;
    walk->cell = cell;
    walk->since = t;
    return FALSE;
}

static gboolean is_certain(Walk *walk, double t, double *cell)
{
    const TinkerRangeJet jet = enclose(walk, t, t);
    return certain_cell(walk->instruction, jet.value, cell);
}

static gboolean visit(Walk *walk, double t, double *found)
{
    double cell;
    return is_certain(walk, t, &cell) && note(walk, cell, t, found);
}

/* Where the derivative changes its sign; it has one zero at most. */
static double extremum(const Walk *walk, double low, double high)
{
    const gboolean rising = tinker_program_evaluate(walk->state, low).first > 0;
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return high;
        if ((tinker_program_evaluate(walk->state, middle).first > 0) == rising) {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/* About an extremum that touches a level: the cells on both sides of it, as near to it as they are certain, and at the
 * end. */
static void visit_around(Walk *walk, double low, double at, double high, double *found)
{
    for (int side = -1; side <= 1; side += 2) {
        const double room = side < 0 ? at - low : high - at;
        double offset = tinker_ulps(fmax(fabs(at), room), TINKER_MERGED), cell = UNDEFINED;
        while (offset < room && !is_certain(walk, at + side * offset, &cell))
            offset *= 2;
        if (offset < room && note(walk, cell, at + side * offset, found)) return;
    }
    visit(walk, high, found);
}

/* Looks at [low, high]; FALSE where it has to be halved. *found is set where there is a break. */
static gboolean decide(Walk *walk, double low, double high, double *found)
{
    double cell;
    const TinkerRangeJet jet = enclose(walk, low, high);
    /* an unbounded derivative tells of a pole, or of the edge of a domain: no range says then what is in between */
    if (isinf(jet.first.low) || isinf(jet.first.high)) return FALSE;
    if (certain_cell(walk->instruction, jet.value, &cell)) {
        note(walk, cell, high, found);
        return TRUE;
    }
    if (tinker_interval_excludes_zero(jet.first)) {
        visit(walk, high, found);
        return TRUE;
    }
    if (tinker_interval_excludes_zero(jet.second)) {
        const double at = extremum(walk, low, high);
        if (!is_certain(walk, at, &cell))
            visit_around(walk, low, at, high, found);
        else if (!note(walk, cell, at, found))
            visit(walk, high, found);
        return TRUE;
    }
    return FALSE;
}

static double sample(Walk *walk, double from, double horizon)
{
    double found = INFINITY;
    if (!isfinite(horizon)) return found;
    for (int i = 1; i <= SAMPLES; i++)
        if (visit(walk, from + (horizon - from) * i / SAMPLES, &found)) return found;
    return INFINITY;
}

/* The first time behind t, in growing steps, at which the cell is certain: t may be a break, and the cell uncertain as
 * far as rounding reaches from it. Answers `horizon` where there is none. */
static double leave(Walk *walk, double t, double horizon)
{
    double found;
    for (double offset = tinker_ulps(t, TINKER_MERGED); t + offset < horizon; offset *= 2) {
        visit(walk, t + offset, &found);
        if (walk->known) return t + offset;
    }
    return horizon;
}

static double walk_along(Walk *walk, double t, double horizon)
{
    double found = INFINITY;
    const double limit = horizon;
    if (isfinite(horizon)) horizon += tinker_ulps(horizon, BEYOND);
    double at = leave(walk, t, horizon);
    double width = isfinite(horizon) ? horizon - at : fmax(1, fabs(t));
    while (at < horizon && isfinite(at)) {
        if (*walk->work_left <= 0) return sample(walk, at, limit);
        const double end = fmin(at + width, horizon);
        const gboolean smallest = end - at <= tinker_ulps(fmax(fabs(at), fabs(end)), TINKER_MERGED);
        if (decide(walk, at, end, &found) || smallest) {
            if (isfinite(found)) return found <= limit ? found : INFINITY;
            at = end;
            width *= 2;
        } else {
            width = (end - at) / 2;
        }
    }
    return INFINITY;
}

static TinkerAffine affine_of(const TinkerProgramState *state, const TinkerInstruction *code,
                              const TinkerAffine *affine, int index)
{
    const TinkerInstruction *instruction = &code[index];
    const TinkerAffine none = {FALSE, 0, 0};
    if (instruction->operation == TINKER_OP_CONSTANT) return (TinkerAffine){TRUE, 0, instruction->number};
    if (instruction->operation == TINKER_OP_TIME) return (TinkerAffine){TRUE, 1, 0};
    if (instruction->operation == TINKER_OP_SWITCH || instruction->operation == TINKER_OP_TRUTH)
        return (TinkerAffine){TRUE, 0, state->cells[index]};
    if (instruction->operation == TINKER_OP_CHOOSE)
        return affine[state->cells[instruction->c] < 0 ? instruction->a : instruction->b];

    const TinkerAffine a = affine[instruction->a];
    const TinkerAffine b = instruction->b >= 0 ? affine[instruction->b] : (TinkerAffine){TRUE, 0, 0};
    if (!a.valid || !b.valid) return none;
    switch (instruction->operation) {
    case TINKER_OP_NEGATE:
        return (TinkerAffine){TRUE, -a.slope, -a.offset};
    case TINKER_OP_ADD:
        return (TinkerAffine){TRUE, a.slope + b.slope, a.offset + b.offset};
    case TINKER_OP_SUBTRACT:
        return (TinkerAffine){TRUE, a.slope - b.slope, a.offset - b.offset};
    case TINKER_OP_MULTIPLY:
        if (a.slope != 0 && b.slope != 0) return none;
        return (TinkerAffine){TRUE, a.slope * b.offset + a.offset * b.slope, a.offset * b.offset};
    case TINKER_OP_DIVIDE:
        return b.slope == 0 ? (TinkerAffine){TRUE, a.slope / b.offset, a.offset / b.offset} : none;
    default:
        break;
    }
    if (a.slope != 0 || b.slope != 0) return none;
    const TinkerJet x = {a.offset, 0, 0}, y = {b.offset, 0, 0};
    const double cell = instruction->c >= 0 ? state->cells[instruction->c] : 0;
    return (TinkerAffine){TRUE, 0, tinker_jet_apply(instruction->operation, &x, &y, cell).value};
}

/* The first time after t at which slope * t + offset is at a level. */
static double affine_break(const TinkerInstruction *instruction, TinkerAffine affine, double t)
{
    const double after = t + tinker_ulps(t, TINKER_MERGED);
    if (affine.slope == 0 || !isfinite(affine.slope) || !isfinite(affine.offset)) return INFINITY;
    const double period = instruction->number;
    if (period == 0) {
        const double root = -affine.offset / affine.slope;
        return root > after ? root : INFINITY;
    }
    const double direction = affine.slope > 0 ? 1 : -1;
    double level = floor((affine.slope * after + affine.offset) / period) - direction;
    /* the level behind `after` is the third at the latest */
    for (int i = 0; i < 5; i++, level += direction) {
        const double root = (level * period - affine.offset) / affine.slope;
        if (root > after) return root;
    }
    /* more levels than doubles lie there: the next time that can be told from t is beside one of them */
    return fabs(period / affine.slope) <= tinker_ulps(t, TINKER_MERGED) ? t + tinker_ulps(t, 2 * TINKER_MERGED)
                                                                        : INFINITY;
}

static gboolean guard_holds(const TinkerProgramState *state, int guard)
{
    while (guard >= 0) {
        const TinkerGuard *branch = &g_array_index(state->program->guards, TinkerGuard, guard);
        if (branch->truth >= 0 && (state->cells[branch->truth] >= 0) != branch->taken) return FALSE;
        guard = branch->parent;
    }
    return TRUE;
}

/* The first break of one switch whose argument is selected. */
static double switch_break(TinkerProgramState *state, const TinkerInstruction *code, TinkerAffine *affine, int index,
                           double t, double horizon, gint64 *work_left)
{
    for (int i = 0; i < state->live_count; i++)
        affine[state->live[i]] = affine_of(state, code, affine, state->live[i]);
    if (affine[state->root].valid) return affine_break(&code[index], affine[state->root], t);
    Walk walk = {.state = state, .instruction = &code[index], .work_left = work_left};
    return walk_along(&walk, t, horizon);
}

double tinker_program_next_break(TinkerProgramState *state, double t, double horizon)
{
    int count;
    const TinkerInstruction *code = tinker_program_code(state->program, &count);
    TinkerAffine *affine = state->affine;
    gint64 work_left = MOST_WORK;
    double found = INFINITY;
    for (int i = 0; i < count; i++) {
        const gboolean truth = code[i].operation == TINKER_OP_TRUTH;
        if (!truth && code[i].operation != TINKER_OP_SWITCH) continue;
        if (!guard_holds(state, code[i].guard)) continue;

        tinker_program_select(state, code[i].a);
        if (!truth) {
            const double first = switch_break(state, code, affine, i, t, horizon, &work_left);
            if (first <= horizon) horizon = found = fmin(found, first);
        }
        const double inside = tinker_time_inside(t, isfinite(horizon) ? horizon : t + fmax(1, fabs(t)));
        const TinkerJet argument = tinker_program_evaluate(state, inside);
        state->cells[i] = tinker_instruction_decide(&code[i], &argument);
    }
    return found;
}

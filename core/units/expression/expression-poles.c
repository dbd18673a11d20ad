/* Where a program's value leaves the numbers: poles, and the edges of where it is defined.
 *
 * Only a few operations lead there, each where something comes to 0: a divisor, the base of a power, the argument of
 * log and sqrt, the cosine of that of tan, 1 - x^2 of asin and acos. These are walked along as the arguments of
 * switches are: an interval over which the enclosure excludes 0 holds none, one over which the derivative has no zero
 * holds one where the signs at its ends differ, any other is halved, down to 4 ulp. So a divisor that only touches 0 is
 * found as well. A place that is found counts where the value of the whole program grows towards it, from either side,
 * or is no number behind it: sin(t) / t passes. What grows is told by three places, each a hundred times as near as the
 * one before: a function that is bounded changes less and less between them, a logarithm by the same, a pole by more.
 */
#include <math.h>

#include "units/expression/expression-program.h"

#define BESIDE    64 /* ulp: what is looked for goes on behind a place that is none */
#define MOST_WORK 50000
/* The first of the three places, as a share of the way there. */
#define NEAR 1e-3
/* Of the change from the first to the second: what that from the second to the third is at least; and of the value,
 * which is rounded. */
#define GROWS   0.75
#define NOTICED 1e-3

/* What of an instruction's argument must not come to 0. */
typedef enum { NOTHING, ITSELF, COSINE, ROOM } Danger;

typedef struct {
    TinkerProgramState *state; /* the argument is selected while it is walked along */
    Danger danger;
    int value; /* the program's last instruction */
    gint64 work_left;
} Search;

static Danger danger_of(const TinkerInstruction *code, const TinkerInstruction *instruction, int *argument)
{
    const TinkerInstruction *second = instruction->b >= 0 ? &code[instruction->b] : NULL;
    gboolean constant = second != NULL && second->operation == TINKER_OP_CONSTANT;
    *argument = instruction->a;
    switch (instruction->operation) {
    case TINKER_OP_DIVIDE:
        *argument = instruction->b;
        return constant && second->number != 0 ? NOTHING : ITSELF;
    case TINKER_OP_POWER:
        return constant && second->number >= 0 && floor(second->number) == second->number ? NOTHING : ITSELF;
    case TINKER_OP_LOG:
    case TINKER_OP_SQRT:
        return ITSELF;
    case TINKER_OP_TAN:
        return COSINE;
    case TINKER_OP_ASIN:
    case TINKER_OP_ACOS:
        return ROOM;
    default:
        return NOTHING;
    }
}

static TinkerJet look(const Search *search, double t)
{
    const TinkerJet one = {1, 0, 0};
    TinkerJet jet = tinker_program_evaluate(search->state, t);
    if (search->danger == COSINE) return tinker_jet_apply(TINKER_OP_COS, &jet, NULL, 0);
    if (search->danger != ROOM) return jet;
    jet = tinker_jet_apply(TINKER_OP_MULTIPLY, &jet, &jet, 0);
    return tinker_jet_apply(TINKER_OP_SUBTRACT, &one, &jet, 0);
}

static TinkerRangeJet enclose(Search *search, double low, double high)
{
    const TinkerRangeJet one = {tinker_interval_point(1), tinker_interval_point(0), tinker_interval_point(0)};
    TinkerRangeJet range = tinker_program_enclose(search->state, low, high);
    search->work_left -= search->state->live_count;
    if (search->danger == COSINE) return tinker_range_jet_apply(TINKER_OP_COS, &range, NULL, 0);
    if (search->danger != ROOM) return range;
    range = tinker_range_jet_apply(TINKER_OP_MULTIPLY, &range, &range, 0);
    return tinker_range_jet_apply(TINKER_OP_SUBTRACT, &one, &range, 0);
}

/* Down to neighbours: the first time at which the sign is no longer that at `low`. */
static double refine(const Search *search, double low, double high)
{
    const gboolean above = look(search, low).value > 0;
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return high;
        if ((look(search, middle).value > 0) == above) {
            low = middle;
        } else {
            high = middle;
        }
    }
}

static gboolean changes_sign(const Search *search, double low, double high)
{
    return look(search, low).value > 0 ? !(look(search, high).value > 0) : look(search, high).value > 0;
}

/* The first place behind t, up to `end`, at which the argument comes to 0; INFINITY for none. */
static double next_zero(Search *search, double t, double end)
{
    double at = t + tinker_ulps(t, TINKER_MERGED), width = end - at;
    while (at < end && search->work_left > 0) {
        const double to = fmin(at + width, end);
        const TinkerRangeJet range = enclose(search, at, to);
        const gboolean bounded = isfinite(range.first.low) && isfinite(range.first.high);
        const gboolean constant = range.value.low == 0 && range.value.high == 0; /* as max(0, t - 2) before 2 */
        const gboolean none =
            constant || tinker_interval_is_empty(range.value) || tinker_interval_excludes_zero(range.value);
        const gboolean straight = !none && bounded && tinker_interval_excludes_zero(range.first);
        if (straight && changes_sign(search, at, to)) return refine(search, at, to);
        if (!none && !straight && to - at <= tinker_ulps(fmax(fabs(at), fabs(to)), TINKER_MERGED)) return to;
        if (none || straight) {
            at = to;
            width *= 2;
        } else {
            width = (to - at) / 2;
        }
    }
    return INFINITY;
}

/* Whether the program's value grows from one side towards a place. The last look is not so near that what cancels in a
 * value with a limit, such as (1 - cos(x))/x^2, is rounding. */
static gboolean grows(const TinkerProgramState *state, double place, double offset)
{
    double value[3];
    for (int i = 0; i < 3; i++, offset /= 10)
        value[i] = tinker_program_evaluate(state, place + offset).value;
    if (!isfinite(value[2])) return TRUE;
    const double change = fabs(value[2] - value[1]);
    return change > GROWS * fabs(value[1] - value[0]) && change > NOTICED * fabs(value[2]);
}

/* Behind the end of the piece another branch may hold. */
static gboolean is_pole(Search *search, double t, double place, double end)
{
    const double before = NEAR * (place - t), behind = fmin(before, 0.5 * (end - place));
    tinker_program_select(search->state, search->value);
    return grows(search->state, place, -before) || (behind > 0 && grows(search->state, place, behind));
}

static double first_pole(Search *search, int argument, double t, double end)
{
    double from = t;
    for (;;) {
        tinker_program_select(search->state, argument);
        const double place = next_zero(search, from, end);
        if (!(place <= end) || is_pole(search, t, place, end)) return place;
        from = place + tinker_ulps(place, BESIDE);
    }
}

double tinker_program_next_pole(TinkerProgramState *state, double t, double end)
{
    int count, argument;
    const TinkerInstruction *code = tinker_program_code(state->program, &count);
    Search search = {.state = state, .value = count - 1};
    double found = INFINITY;
    gboolean decided = FALSE;
    for (int i = 0; i < count; i++) {
        search.danger = danger_of(code, &code[i], &argument);
        if (search.danger == NOTHING) continue;
        if (!decided) tinker_program_decide(state, t + (end - t) / 2);
        decided = TRUE;
        search.work_left = MOST_WORK;
        found = fmin(found, first_pole(&search, argument, t, fmin(found, end)));
    }
    return found;
}

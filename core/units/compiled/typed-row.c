/* Laws of many instances: those that differ in their numbers alone stand in rows, with the numbers beside one another,
 * so that they are worked out together. */
#include <string.h>

#include "units/compiled/compiled.h"
#include "units/compiled/typed-energy.h"

#define LINE           64 /* bytes, of the processor's cache: few numbers that begin amid one take a fifth longer */
#define LEAST_TOGETHER 8  /* fewer are worked out one by one, which is faster */

struct _TinkerTypedRow {
    int users, count;
    TinkerTypedLaw **place; /* where they are told of: that of member i at i * stride. Borrowed, and perhaps gone */
    int stride;
    int programs;      /* of each member: the value, the slopes, the curvatures */
    gboolean is_short; /* all have the shorter way for so many (tinker_compiled_has_row) */
    double **numbers;  /* by program; of each by number, then by member */
    struct TinkerTypedLaw member[];
};

static int programs_of(const TinkerTypedLaw *law)
{
    return 1 + law->count + law->count * law->count;
}

static const TinkerCompiled *program_at(const TinkerTypedLaw *law, int which)
{
    if (which == 0) return law->value;
    return which <= law->count ? law->slopes[which - 1] : law->curvatures[which - 1 - law->count];
}

static inline int which_of(const TinkerTypedLaw *law, int by, int and_by)
{
    return by < 0 ? 0 : and_by < 0 ? 1 + by : 1 + law->count + by * law->count + and_by;
}

static gboolean are_alike(const TinkerTypedLaw *a, const TinkerTypedLaw *b)
{
    if (a->count != b->count) return FALSE;
    for (int which = 0; which < programs_of(a); which++)
        if (!tinker_compiled_alike(program_at(a, which), program_at(b, which))) return FALSE;
    return TRUE;
}

static double *numbers_of(const TinkerTypedRow *row, int which)
{
    int count;
    tinker_compiled_numbers(program_at(row->member, which), &count);
    double *numbers = g_aligned_alloc((gsize)MAX(count, 1) * (gsize)row->count, sizeof(double), LINE);
    for (int member = 0; member < row->count; member++) {
        const double *own = tinker_compiled_numbers(program_at(&row->member[member], which), &count);
        for (int i = 0; i < count; i++)
            numbers[i * row->count + member] = own[i];
    }
    return numbers;
}

static void put_into_row(TinkerTypedLaw **laws, int stride, int count)
{
    TinkerTypedRow *row = g_malloc(sizeof *row + (gsize)count * sizeof(TinkerTypedLaw));
    row->users = row->count = count;
    row->place = laws;
    row->stride = stride;
    row->programs = programs_of(laws[0]);
    for (int i = 0; i < count; i++) {
        row->member[i] = *laws[i * stride];
        row->member[i].row = row;
        row->member[i].member = i;
        g_free(laws[i * stride]);
        laws[i * stride] = &row->member[i];
    }
    row->numbers = g_new(double *, (gsize)row->programs);
    row->is_short = TRUE;
    for (int which = 0; which < row->programs; which++) {
        row->numbers[which] = numbers_of(row, which);
        row->is_short = row->is_short && tinker_compiled_has_row(program_at(row->member, which), count);
    }
}

void tinker_typed_join(TinkerTypedLaw **laws, int stride, int count)
{
    for (int first = 0, end; first < count; first = end) {
        end = first + 1;
        if (laws[first * stride] == NULL) continue;
        while (end < count && laws[end * stride] != NULL && are_alike(laws[first * stride], laws[end * stride]))
            end++;
        if (end - first >= LEAST_TOGETHER) put_into_row(laws + first * stride, stride, end - first);
    }
}

static void free_row(TinkerTypedRow *row)
{
    if (--row->users > 0) return;
    for (int which = 0; which < row->programs; which++)
        g_aligned_free(row->numbers[which]);
    g_free(row->numbers);
    g_free(row);
}

void tinker_typed_free(TinkerTypedLaw *law)
{
    if (law == NULL) return;
    tinker_compiled_free(law->value);
    for (int i = 0; i < law->count; i++)
        tinker_compiled_free(law->slopes[i]);
    for (int i = 0; i < law->count * law->count; i++)
        tinker_compiled_free(law->curvatures[i]);
    tinker_typed_energy_free(law->energy);
    g_free(law->slopes);
    g_free(law->curvatures);
    if (law->row != NULL)
        free_row(law->row);
    else
        g_free(law);
}

/* How many from `first` on stand in a row as they are told of, or are one law, which `one` says. */
static int run_of(const TinkerTypedQuestion *question, const TinkerTypedLaw *const *laws, int left, gboolean *one)
{
    const TinkerTypedLaw *law = laws[0];
    const TinkerTypedRow *row = law->row;
    const gssize stride = question->stride;
    *one = stride == 0 || row == NULL;
    if (stride == 0) return left;
    if (row != NULL) {
        const TinkerTypedLaw *const *place = (const TinkerTypedLaw *const *)row->place + law->member * stride;
        return row->stride == stride && place == laws ? MIN(left, row->count - law->member) : 1;
    }
    int count = 1;
    while (count < left && laws[count * stride] == law)
        count++;
    return count;
}

static gboolean ask_together(const TinkerTypedQuestion *question, const TinkerTypedLaw *law, int first, int count,
                             gboolean one, int which, double *results)
{
    if (count < LEAST_TOGETHER) return FALSE;
    TinkerColumns columns = {
        .count = count, .first = first, .arguments = question->arguments, .uniform = question->uniform};
    if (!one) {
        columns.numbers = law->row->numbers[which] + law->member;
        columns.stride = law->row->count;
    }
    return tinker_compiled_values(program_at(law, which), &columns, results + first);
}

static void ask_one_by_one(const TinkerTypedQuestion *question, int first, int count, int which, double *results)
{
    double at[TINKER_TYPED_MOST_ARGUMENTS];
    for (int i = first; i < first + count; i++) {
        const TinkerTypedLaw *law = question->laws[(gsize)i * (gsize)question->stride];
        for (int k = 0; k < law->count; k++)
            at[k] = question->arguments[k] != NULL ? question->arguments[k][i] : question->uniform[k];
        results[i] = tinker_compiled_value(program_at(law, which), at);
    }
}

/* Answers those from `first` on that can be asked in one way, and says how many they were. */
static G_NO_INLINE int ask_run(const TinkerTypedQuestion *question, int first, int by, int and_by, double *results)
{
    const TinkerTypedLaw *const *laws = question->laws + (gssize)first * question->stride, *law = *laws;
    const int which = which_of(law, by, and_by);
    gboolean one;
    const int count = run_of(question, laws, question->count - first, &one);
    if (!ask_together(question, law, first, count, one, which, results))
        ask_one_by_one(question, first, count, which, results);
    return count;
}

static gboolean are_none(const void *a, const void *b, const void *c, const void *d)
{
    return ((guintptr)a | (guintptr)b | (guintptr)c | (guintptr)d) == 0;
}

/* The first from `first` on that has a law; many a batch has none at all, so four are looked at at once. */
static int next_law(const TinkerTypedQuestion *question, int first)
{
    const gssize stride = question->stride;
    const int count = question->count;
    const TinkerTypedLaw *const *law = question->laws + first * stride;
    for (; first + 4 <= count && are_none(law[0], law[stride], law[2 * stride], law[3 * stride]); first += 4)
        law += 4 * stride;
    for (; first < count && *law == NULL; first++)
        law += stride;
    return first;
}

static G_NO_INLINE void ask_runs(const TinkerTypedQuestion *question, int by, int and_by, double *results)
{
    for (int first = next_law(question, 0); first < question->count; first = next_law(question, first))
        first += ask_run(question, first, by, and_by, results);
}

/* Whether it is to all of a row, as they are told of, and few: so a batch asks. */
static inline gboolean is_to_short_row(const TinkerTypedQuestion *question, const TinkerTypedRow *row)
{
    return row != NULL && (const TinkerTypedLaw *const *)row->place == question->laws &&
           row->stride == question->stride && row->count == question->count && row->is_short;
}

/* Of few laws, what comes before they are worked out takes as long as that: so there is a short way for what is asked
 * most, all of a row. */
void tinker_typed_ask(const TinkerTypedQuestion *question, int by, int and_by, double *results)
{
    const TinkerTypedLaw *law = question->count > 0 ? question->laws[0] : NULL;
    if (law == NULL || !is_to_short_row(question, law->row)) {
        ask_runs(question, by, and_by, results);
        return;
    }
    const int which = which_of(law, by, and_by);
    tinker_compiled_row(program_at(law, which), question->arguments, question->uniform, law->row->numbers[which],
                        question->count, results);
}

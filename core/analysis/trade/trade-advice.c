/* The advice: of what was measured, and of settings between two measured ones that are then measured as well, the
 * cheapest that keeps to the error, or the most accurate within the budget. As it is picked among measurements, it
 * costs no more than the best of them. */
#include <math.h>

#include "analysis/trade/trade-private.h"

#define OCTAVE        2.0  /* no further from a measured setting than this factor */
#define MARGIN        0.85 /* of the error or the budget: what an interpolation aims at */
#define WORTH_A_TRIAL 0.95 /* of the present best: what a trial must promise */
#define MOST_TRIALS   4
#define SAME          1.02 /* times within this factor are the same */

typedef struct {
    TinkerTradeMethod *method;
    guint place; /* its row, or the row that a trial is to stand before */
    TinkerTradeSetting setting;
    double wall_s, error; /* measured or forecast */
} Choice;

/* What a row may be off by: no less than the reference's own limit. */
static double bound(const TinkerTrade *trade, const TinkerTradeRow *row)
{
    return fmax(row->error, trade->reference.level);
}

/* Whether `a` is the better choice: keeping to the wish first, then the cheaper, or the more accurate one. */
static gboolean is_better(const TinkerTradeOptions *options, const Choice *a, const Choice *b)
{
    gboolean by_budget = options->budget > 0;
    gboolean a_meets = by_budget ? a->wall_s <= options->budget : a->error <= options->error;
    gboolean b_meets = by_budget ? b->wall_s <= options->budget : b->error <= options->error;
    if (a_meets != b_meets) return a_meets;
    /* Where the wish is met the other quantity counts; where it is not, the one that was wished for. */
    gboolean by_wall = by_budget != a_meets;
    double first = by_wall ? a->wall_s : a->error, second = by_wall ? b->wall_s : b->error;
    if (first * SAME < second || second * SAME < first) return first < second;
    return by_wall ? a->error < b->error : a->wall_s < b->wall_s;
}

static Choice choice_of(const TinkerTrade *trade, TinkerTradeMethod *method, guint place)
{
    const TinkerTradeRow *row = &g_array_index(method->rows, TinkerTradeRow, place);
    return (Choice){method, place, row->setting, row->wall_s, bound(trade, row)};
}

static gboolean find_best(const TinkerTradeOptions *options, const TinkerTrade *trade, Choice *best)
{
    gboolean found = FALSE;
    for (guint m = 0; m < trade->methods->len; m++) {
        TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++) {
            Choice choice = choice_of(trade, method, i);
            if (isnan(choice.error) || isnan(g_array_index(method->rows, TinkerTradeRow, i).error)) continue;
            if (found && !is_better(options, &choice, best)) continue;
            *best = choice;
            found = TRUE;
        }
    }
    return found;
}

/* Between settings ------------------------------------------------------------------------------------------------- */

/* Two significant digits, away from the coarser side: 0.0123456 becomes 0.012. */
static double rounded_down(double value)
{
    int decade = (int)floor(log10(value));
    char text[32];
    g_snprintf(text, sizeof text, "%de%d", (int)floor(value * pow(10, 1 - decade) * (1 + 1e-12)), decade - 1);
    return g_ascii_strtod(text, NULL);
}

/* Where on the straight line between two rows, in logarithms, a quantity takes a value: 0 at the coarse one, 1 at the
 * fine. */
static double share_at(double coarse, double fine, double value)
{
    return log(coarse / value) / log(coarse / fine);
}

static double between(double coarse, double fine, double share)
{
    return coarse * pow(fine / coarse, share);
}

/* A setting between rows `place` - 1 and `place`, of which the first misses the wish by being too coarse or the second
 * by being too slow. */
static gboolean interpolate(const TinkerTradeOptions *options, const TinkerTrade *trade, TinkerTradeMethod *method,
                            guint place, Choice *choice)
{
    Choice coarse = choice_of(trade, method, place - 1), fine = choice_of(trade, method, place);
    if (!(coarse.error > fine.error && fine.wall_s > coarse.wall_s)) return FALSE;
    double share;
    if (options->budget > 0) {
        if (!(coarse.wall_s <= options->budget && fine.wall_s > options->budget)) return FALSE;
        share = share_at(coarse.wall_s, fine.wall_s, fmax(MARGIN * options->budget, coarse.wall_s));
    } else {
        if (!(fine.error <= options->error && coarse.error > options->error)) return FALSE;
        share = share_at(coarse.error, fine.error, fmax(MARGIN * options->error, fine.error));
    }
    double value = between(coarse.setting.value, fine.setting.value, CLAMP(share, 0, 1));
    value = options->budget > 0 ? fmax(value, coarse.setting.value / OCTAVE) : fmin(value, fine.setting.value * OCTAVE);
    value = rounded_down(value);
    if (!(value < coarse.setting.value && value > fine.setting.value)) return FALSE;
    share = share_at(coarse.setting.value, fine.setting.value, value);
    *choice = (Choice){method,
                       place,
                       {method->id, fine.setting.adaptive, value},
                       between(coarse.wall_s, fine.wall_s, share),
                       between(coarse.error, fine.error, share)};
    return TRUE;
}

/* The most promising setting between measured ones that was not tried before. */
static gboolean find_trial(const TinkerTradeOptions *options, const TinkerTrade *trade, const GArray *tried,
                           Choice *trial)
{
    gboolean found = FALSE;
    for (guint m = 0; m < trade->methods->len; m++) {
        TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        gboolean again = FALSE;
        for (guint i = 0; i < tried->len; i++)
            again = again || g_array_index(tried, TinkerTradeMethod *, i) == method;
        for (guint i = 1; !again && i < method->rows->len; i++) {
            Choice choice;
            if (!interpolate(options, trade, method, i, &choice)) continue;
            if (found && !is_better(options, &choice, trial)) continue;
            *trial = choice;
            found = TRUE;
        }
    }
    return found;
}

/* Measures what lies between; what proves to be the best yet enters the rows. Each method is tried once. */
static void try_between(TinkerTradeBench *bench, const TinkerTradeStandard *standard, TinkerTrade *trade, Choice *best)
{
    const TinkerTradeOptions *options = bench->options;
    g_autoptr(GArray) tried = g_array_new(FALSE, FALSE, sizeof(TinkerTradeMethod *));
    Choice trial;
    while (tried->len < MOST_TRIALS && !bench->cancelled && find_trial(options, trade, tried, &trial)) {
        Choice hoped = trial;
        if (options->budget <= 0) hoped.wall_s /= WORTH_A_TRIAL;
        if (!is_better(options, &hoped, best)) return;
        g_array_append_val(tried, trial.method);
        TinkerTradeRow row;
        tinker_trade_measure(bench, standard, trial.setting, 20 * trial.wall_s + 0.5, &row);
        trial.wall_s = row.wall_s;
        trial.error = bound(trade, &row);
        if (isnan(row.error) || bench->cancelled || !is_better(options, &trial, best)) {
            tinker_trade_row_clear(&row);
            continue;
        }
        g_array_insert_val(trial.method->rows, trial.place, row);
        *best = trial;
    }
}

void tinker_trade_advise(TinkerTradeBench *bench, const TinkerTradeStandard *standard, TinkerTrade *trade)
{
    const TinkerTradeOptions *options = bench->options;
    Choice best;
    if (!find_best(options, trade, &best)) return;
    try_between(bench, standard, trade, &best);
    TinkerTradeRow *row = &g_array_index(best.method->rows, TinkerTradeRow, best.place);
    row->advised = TRUE;
    trade->advice.row = *row;
    trade->advice.row.note = NULL;
    gboolean met = options->budget > 0 ? row->wall_s <= options->budget : bound(trade, row) <= options->error;
    trade->advice.kind = met ? TINKER_TRADE_ADVICE_MET : TINKER_TRADE_ADVICE_NEAREST;
}

/* The sweep of one method, from coarse to fine: steps halve, tolerances fall by tens, until the error stops falling, is
 * below what the reference is confirmed to, or the next run would take longer than there is time. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/trade/trade-private.h"
#include "physics/model/model.h"

#define COARSEST_STEPS    4 /* of a run at the largest step */
#define MOST_HALVINGS     60
#define LARGEST_TOLERANCE 1e-3
#define LEAST_TOLERANCE   0.9e-12
#define MEANINGLESS       1.0  /* an error as large as the motion itself */
#define CONVERGING        1e-2 /* below it, an error that does not fall will not fall */
#define FALLING           0.6  /* of the error before */
#define RUNS_A_ROW        4    /* one with samples and the timed ones */
#define SHARE_OF_FIRST    0.4  /* of a method's time: for a first run that does not end */

void tinker_trade_row_clear(gpointer row)
{
    g_clear_pointer(&((TinkerTradeRow *)row)->note, g_free);
}

/* The run did end; how far it is from the truth, and how long it takes. */
static void fill_row(TinkerTradeBench *bench, const TinkerTradeStandard *standard, const TinkerTrajectory *trajectory,
                     TinkerTradeRow *row)
{
    const TinkerTradeReference *reference = standard->reference;
    row->error = tinker_trade_bench_distance(bench, standard->truth, trajectory, standard->samples, reference->extent,
                                             reference->speed);
    row->at_limit = row->error <= reference->level;
    row->mean_step = bench->duration / (double)MAX(trajectory->steps, 1);
    row->evaluations = trajectory->evaluations;
    row->energy_error = trajectory->energy_error;
    row->constraint_error = trajectory->constraint_error;
    row->wall_s = tinker_trade_bench_time(bench, row->setting, trajectory->wall_s, &row->repeats);
    if (isnan(row->wall_s)) row->wall_s = trajectory->wall_s;
}

TinkerTradeEnd tinker_trade_measure(TinkerTradeBench *bench, const TinkerTradeStandard *standard,
                                    TinkerTradeSetting setting, double most, TinkerTradeRow *row)
{
    g_auto(TinkerTrajectory) trajectory = {0};
    g_autoptr(GError) failure = NULL;
    *row =
        (TinkerTradeRow){.setting = setting, .wall_s = NAN, .error = NAN, .energy_error = NAN, .constraint_error = NAN};
    if (tinker_trade_bench_sample(bench, setting, most, &trajectory, &failure)) {
        fill_row(bench, standard, &trajectory, row);
        return TINKER_TRADE_DONE;
    }
    if (g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) {
        row->note = g_strdup_printf(_("%s: it takes more than the %.2g s that it was given"), failure->message, most);
        return TINKER_TRADE_STOPPED;
    }
    row->note = g_strdup(failure->message);
    gboolean of_run = g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN);
    return of_run ? TINKER_TRADE_FAILED : TINKER_TRADE_UNSUITABLE;
}

static TinkerTradeRow *last_row(const TinkerTradeMethod *method, guint back)
{
    return method->rows->len > back ? &g_array_index(method->rows, TinkerTradeRow, method->rows->len - 1 - back) : NULL;
}

/* Whether nothing can be learnt from it but that finer settings are needed. */
static gboolean is_useless(const TinkerTradeRow *row)
{
    return !(row->error < MEANINGLESS);
}

/* Adds a row. At the coarse end the finest failure, and the finest run that is off by the motion itself, tell enough.
 */
static void add_row(TinkerTradeMethod *method, TinkerTradeRow row)
{
    const TinkerTradeRow *before = last_row(method, 0);
    gboolean any_useful = FALSE;
    for (guint i = 0; i < method->rows->len; i++)
        any_useful = any_useful || !is_useless(last_row(method, i));
    gboolean alike = before != NULL && is_useless(&row) && isnan(before->error) == isnan(row.error);
    if (alike && !any_useful) g_array_remove_index(method->rows, method->rows->len - 1);
    g_array_append_val(method->rows, row);
}

static gboolean falls(const TinkerTradeRow *from, const TinkerTradeRow *to)
{
    return !(from->error < CONVERGING) || to->error < FALLING * from->error;
}

/* Whether finer settings have nothing more to give. */
static gboolean is_exhausted(const TinkerTradeMethod *method)
{
    const TinkerTradeRow *last = last_row(method, 0), *before = last_row(method, 1), *third = last_row(method, 2);
    if (last->at_limit && before != NULL && before->at_limit) return TRUE;
    if (third == NULL || isnan(last->error)) return FALSE;
    return !falls(before, last) && !falls(third, before);
}

/* What the next row takes, by the last two; 0 where nothing is known. */
static double forecast(const TinkerTradeMethod *method, gboolean adaptive)
{
    const TinkerTradeRow *last = last_row(method, 0), *before = last_row(method, 1);
    if (last == NULL || isnan(last->wall_s)) return 0;
    double factor = adaptive ? 1.6 : 2.0;
    if (adaptive && before != NULL && before->wall_s > 0) factor = CLAMP(last->wall_s / before->wall_s, 1.2, 4.0);
    return RUNS_A_ROW * factor * last->wall_s;
}

/* The time of the next row: all that is left, but of a method that has shown nothing yet. */
static double allowance(const TinkerTradeMethod *method, double left)
{
    gboolean unknown = method->rows->len == 0 || is_useless(last_row(method, 0));
    return unknown ? SHARE_OF_FIRST * left : left;
}

void tinker_trade_sweep(TinkerTradeBench *bench, const TinkerTradeStandard *standard, TinkerTradeMethod *method,
                        double seconds)
{
    gboolean adaptive = (method->integrator->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    gboolean exact = (method->integrator->flags & TINKER_INTEGRATOR_LINEAR) != 0;
    double begun = tinker_trade_bench_elapsed(bench);
    TinkerTradeSetting setting = {method->id, adaptive,
                                  adaptive ? LARGEST_TOLERANCE : bench->duration / COARSEST_STEPS};
    if (exact) setting.value = 0;
    for (int run = 0; run < MOST_HALVINGS && !(adaptive && setting.value < LEAST_TOLERANCE); run++) {
        double left = begun + seconds - tinker_trade_bench_elapsed(bench);
        method->out_of_time = method->rows->len > 0 && (left <= 0 || forecast(method, adaptive) > left);
        if (method->out_of_time || tinker_trade_bench_look(bench)) return;
        TinkerTradeRow row;
        TinkerTradeEnd end = tinker_trade_measure(bench, standard, setting, allowance(method, left), &row);
        if (bench->cancelled) {
            tinker_trade_row_clear(&row);
            return;
        }
        add_row(method, row);
        method->out_of_time = end == TINKER_TRADE_STOPPED;
        if (exact || end == TINKER_TRADE_STOPPED || end == TINKER_TRADE_UNSUITABLE || is_exhausted(method)) return;
        setting.value /= adaptive ? 10 : 2;
    }
}

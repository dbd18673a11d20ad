/* Tables in memory: linear between rows, along a natural cubic spline, or as an acceleration that is integrated
 * exactly, since the integrals of a line are polynomials. */
#include <math.h>

#include "units/waveform/table-private.h"
#include "units/waveform/times.h"

static gboolean lack_memory(const char *work, const TinkerTable *table, GError **error)
{
    g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE,
                "there is no memory to %s a table of %" G_GSIZE_FORMAT " rows", work, table->rows);
    return FALSE;
}

/* Velocity and place at each row from those at the row before. Sums are compensated (A. Neumaier, ZAMM 54, 1974): a
 * record has millions of rows. */
static gboolean integrate(TinkerTable *table, GError **error)
{
    table->speeds = g_try_new0(double, table->rows);
    table->places = g_try_new0(double, table->rows);
    if (table->speeds == NULL || table->places == NULL) return lack_memory("integrate", table, error);
    double speed = 0, speed_rest = 0, place = 0, place_rest = 0;
    for (gsize i = 1; i < table->rows; i++) {
        const double step = table->times[i] - table->times[i - 1];
        const double before = table->values[i - 1], after = table->values[i];
        const double travel = step * (table->speeds[i - 1] + step * (before / 3 + after / 6));
        const double gain = step * (before / 2 + after / 2);
        const double new_place = place + travel, new_speed = speed + gain;
        place_rest += fabs(place) >= fabs(travel) ? (place - new_place) + travel : (travel - new_place) + place;
        speed_rest += fabs(speed) >= fabs(gain) ? (speed - new_speed) + gain : (gain - new_speed) + speed;
        place = new_place;
        speed = new_speed;
        table->places[i] = place + place_rest;
        table->speeds[i] = speed + speed_rest;
    }
    return TRUE;
}

/* Second derivatives at the rows, from the equations of a C2 cubic with zero ones at both ends, solved by elimination:
 * h0 m0 + 2 (h0 + h1) m1 + h1 m2 = 6 (slope1 - slope0). C. de Boor, A Practical Guide to Splines, chapter IV. NULL:
 * there is no memory. */
static double *spline_bends(const TinkerTable *table)
{
    g_autofree double *bends = g_try_new0(double, table->rows), *ratios = g_try_new0(double, table->rows);
    if (bends == NULL || ratios == NULL) return NULL;
    for (gsize i = 1; i + 1 < table->rows; i++) {
        const double before = table->times[i] - table->times[i - 1];
        const double after = table->times[i + 1] - table->times[i];
        const double slope_before = (table->values[i] - table->values[i - 1]) / before;
        const double slope_after = (table->values[i + 1] - table->values[i]) / after;
        const double pivot = 2 * (before + after) - before * ratios[i - 1];
        ratios[i] = after / pivot;
        bends[i] = (6 * (slope_after - slope_before) - before * bends[i - 1]) / pivot;
    }
    for (gsize i = table->rows - 1; i-- > 1;)
        bends[i] -= ratios[i] * bends[i + 1];
    return g_steal_pointer(&bends);
}

static gboolean check_rows(const double *times, const double *values, gsize rows, GError **error)
{
    if (rows == 0 || rows > TINKER_TABLE_MOST_ROWS) {
        g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE,
                    "a table has 1 to %d rows, this one has %" G_GSIZE_FORMAT, TINKER_TABLE_MOST_ROWS, rows);
        return FALSE;
    }
    for (gsize i = 0; i < rows; i++) {
        if (!isfinite(times[i]) || !isfinite(values[i])) {
            g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE,
                        "row %" G_GSIZE_FORMAT ": time and value must be finite numbers", i + 1);
            return FALSE;
        }
        if (i > 0 && times[i] <= times[i - 1]) {
            g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE,
                        "row %" G_GSIZE_FORMAT ": the time %g must be greater than %g in the row before", i + 1,
                        times[i], times[i - 1]);
            return FALSE;
        }
    }
    return TRUE;
}

static void evaluate_linear(const TinkerTable *table, gsize piece, double t, double result[3])
{
    const double step = table->times[piece] - table->times[piece - 1];
    const double slope = (table->values[piece] - table->values[piece - 1]) / step;
    /* from the nearer row, so that both rows are met to the bit */
    const gsize near = t - table->times[piece - 1] < step / 2 ? piece - 1 : piece;
    result[0] = table->values[near] + slope * (t - table->times[near]);
    result[1] = slope;
    result[2] = 0;
}

static void evaluate_spline(const TinkerTable *table, gsize piece, double t, double result[3])
{
    const double step = table->times[piece] - table->times[piece - 1];
    const double left = table->bends[piece - 1], right = table->bends[piece];
    const double b = (t - table->times[piece - 1]) / step, a = (table->times[piece] - t) / step;
    const double slope = (table->values[piece] - table->values[piece - 1]) / step;
    result[0] = a * table->values[piece - 1] + b * table->values[piece] +
                ((a * a - 1) * a * left + (b * b - 1) * b * right) * step * step / 6;
    result[1] = slope + ((3 * b * b - 1) * right - (3 * a * a - 1) * left) * step / 6;
    result[2] = a * left + b * right;
}

/* What an acceleration, linear from the row before on, has grown to. */
static void evaluate_acceleration(const TinkerTable *table, gsize piece, double t, double result[3])
{
    if (piece == 0) {
        result[0] = result[1] = result[2] = 0;
        return;
    }
    const gsize row = piece - 1;
    const double since = t - table->times[row];
    double start = 0, growth = 0;
    if (piece < table->rows) {
        start = table->values[row];
        growth = (table->values[piece] - start) / (table->times[piece] - table->times[row]);
    }
    result[0] = table->places[row] + since * (table->speeds[row] + since * (start / 2 + since * growth / 6));
    result[1] = table->speeds[row] + since * (start + since * growth / 2);
    result[2] = start + since * growth;
}

TinkerTable *tinker_table_new(double *times, double *values, gsize rows, TinkerTableKind kind, GError **error)
{
    TinkerTable *table = g_new0(TinkerTable, 1);
    *table = (TinkerTable){.rows = rows, .times = times, .values = values, .kind = kind, .scale = 1};
    const gboolean good =
        check_rows(times, values, rows, error) && (kind != TINKER_TABLE_ACCELERATION || integrate(table, error));
    if (good) return table;
    tinker_table_free(table);
    return NULL;
}

void tinker_table_free(TinkerTable *table)
{
    g_free(table->times);
    g_free(table->values);
    g_free(table->speeds);
    g_free(table->places);
    g_free(table->bends);
    g_free(table);
}

gboolean tinker_table_prepare_spline(TinkerTable *table, GError **error)
{
    static GMutex preparing;
    g_mutex_lock(&preparing);
    if (table->bends == NULL) table->bends = spline_bends(table);
    g_mutex_unlock(&preparing);
    return table->bends != NULL || lack_memory("draw a smooth curve through", table, error);
}

gsize tinker_table_piece(const TinkerTable *table, double t)
{
    return tinker_times_until(table->times, table->rows, t);
}

void tinker_table_evaluate(const TinkerTable *table, gsize piece, gboolean smooth, double t, double result[3])
{
    if (table->kind == TINKER_TABLE_ACCELERATION) {
        evaluate_acceleration(table, piece, t, result);
    } else if (piece == 0 || piece == table->rows) {
        result[0] = table->values[piece == 0 ? 0 : table->rows - 1];
        result[1] = result[2] = 0;
    } else if (smooth) {
        evaluate_spline(table, piece, t, result);
    } else {
        evaluate_linear(table, piece, t, result);
    }
}

/* Extrema of a cubic piece are the roots of a quadratic; its mean is integrated exactly, its square by four nodes of
 * Gauss, which are exact to degree 7. */
#include <math.h>

#include "measure/curve-pieces.h"
#include "measure/statistics-private.h"

#define OF_VALUES 5 /* mean, rms, least, greatest, amplitude */
/* Of the whole range: smaller ways between two extrema are ripple of rounding. */
#define RIPPLE 1e-9
/* Of what the curve may be off by: smaller ways at both ends, as of a swing that has died away, tell nothing. */
#define CERTAIN 10.0

/* What is found on the way through the pieces. */
typedef struct {
    double mean, square, least, greatest;
    double slope;    /* dy/dt at the end of the piece before; NAN: there is none */
    GArray *extrema; /* of double: time and value in turn */
} Sums;

static void note(Sums *sums, double value)
{
    sums->least = fmin(sums->least, value);
    sums->greatest = fmax(sums->greatest, value);
}

/* A kink between two pieces is an extremum where the curve turns back there. */
static void add_kink(Sums *sums, const TinkerCurvePiece *piece)
{
    const double extremum[2] = {piece->start, piece->a};
    if (sums->slope * piece->b < 0) g_array_append_vals(sums->extrema, extremum, 2);
}

/* Straight up or down, at one time. Each of its ends may be an extremum. */
static void add_jump(Sums *sums, double time, double before, double behind)
{
    const double extremum[2] = {time, before};
    if (before == behind) return;
    note(sums, before);
    note(sums, behind);
    if (sums->slope * (behind - before) < 0) g_array_append_vals(sums->extrema, extremum, 2);
    sums->slope = behind - before;
}

static void add_piece(Sums *sums, const TinkerCurvePiece *piece, double from, double to)
{
    static const double nodes[2] = {0.33998104358485626480, 0.86113631159405257522};
    static const double weights[2] = {0.65214515486254614263, 0.34785484513745385737};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    for (int k = 0; k < 4; k++) {
        const double y = tinker_curve_piece_value(piece, middle + (k % 2 ? half : -half) * nodes[k / 2]);
        sums->mean += piece->width * half * weights[k / 2] * y;
        sums->square += piece->width * half * weights[k / 2] * y * y;
    }
    note(sums, tinker_curve_piece_value(piece, from));
    note(sums, tinker_curve_piece_value(piece, to));
    double roots[2];
    tinker_curve_piece_level(piece, roots);
    for (int k = 0; k < 2; k++) {
        if (!(roots[k] > from && roots[k] <= to)) continue;
        const double extremum[2] = {piece->start + roots[k] * piece->width, tinker_curve_piece_value(piece, roots[k])};
        note(sums, extremum[1]);
        g_array_append_vals(sums->extrema, extremum, 2);
    }
}

/* What of a piece lies between the two times. */
static void add_part(Sums *sums, const TinkerCurvePiece *piece, double from, double to)
{
    const double start = fmax(0, (from - piece->start) / piece->width),
                 end = fmin(1, (to - piece->start) / piece->width);
    if (!(start < end)) return;
    if (start == 0) add_kink(sums, piece);
    add_piece(sums, piece, start, end);
    sums->slope = tinker_curve_piece_end_slope(piece);
}

/* Extrema that are no ripple: a way back that is too small takes both its ends away. */
static void drop_ripple(Sums *sums)
{
    const double least = RIPPLE * (sums->greatest - sums->least);
    double *all = (double *)(gpointer)sums->extrema->data;
    guint kept = 0;
    for (guint i = 0; i + 1 < sums->extrema->len; i += 2) {
        if (kept >= 2 && fabs(all[i + 1] - all[kept - 1]) <= least) {
            kept -= 2;
            continue;
        }
        all[kept++] = all[i];
        all[kept++] = all[i + 1];
    }
    g_array_set_size(sums->extrema, kept);
}

/* Of both ends, as far as ways are not certain; each goes with the extremum at its outer end. */
static void drop_uncertain_ends(Sums *sums, double band)
{
    const double least = CERTAIN * band;
    GArray *extrema = sums->extrema;
    while (extrema->len >= 4 && fabs(g_array_index(extrema, double, extrema->len - 1) -
                                     g_array_index(extrema, double, extrema->len - 3)) < least)
        g_array_set_size(extrema, extrema->len - 2);
    guint first = 0;
    while (first + 3 < extrema->len &&
           fabs(g_array_index(extrema, double, first + 3) - g_array_index(extrema, double, first + 1)) < least)
        first += 2;
    if (first > 0) g_array_remove_range(extrema, 0, first);
}

static TinkerStatistics measure(const TinkerCurveSamples *samples, double from, double to, double band)
{
    Sums sums = {0, 0, INFINITY, -INFINITY, NAN, g_array_new(FALSE, FALSE, sizeof(double))};
    for (gsize i = 0; i + 1 < samples->count; i++) {
        const double start = samples->times[i], end = samples->times[i + 1];
        if (start == end && start > from && start < to)
            add_jump(&sums, start, samples->values[i], samples->values[i + 1]);
        if (end <= from || start >= to || !(end > start)) continue;
        TinkerCurvePiece pieces[2];
        const guint count = tinker_curve_pieces(samples, i, pieces);
        for (guint k = 0; k < count; k++)
            add_part(&sums, &pieces[k], from, to);
    }
    drop_ripple(&sums);
    drop_uncertain_ends(&sums, band);
    TinkerStatistics result = {.mean = {sums.mean / (to - from), band},
                               .rms = {sqrt(sums.square / (to - from)), band},
                               .least = {sums.least, band},
                               .greatest = {sums.greatest, band},
                               .amplitude = {0.5 * (sums.greatest - sums.least), band}};
    tinker_find_swings(sums.extrema, band, &result);
    g_array_unref(sums.extrema);
    return result;
}

/* What is unknown between events (between-events.c). The root mean square is off by no more than that of what the curve
 * is, and by the mean of what its square is off by, over the rms itself. */
static void add_between_events(const TinkerCurveSamples *samples, double from, double to, TinkerStatistics *found)
{
    const double *times = samples->times, *values = samples->values;
    double bends[2], area = 0, square = 0, moment = 0, above = 0, below = 0;
    tinker_bends(samples, bends);
    const double bend = fmax(-bends[0], bends[1]);
    for (gsize i = 0; i + 1 < samples->count; i++) {
        if (times[i + 1] <= from || times[i] >= to || !tinker_is_between_events(samples, i)) continue;
        const double h = times[i + 1] - times[i];
        const double largest = fmax(fabs(values[i]), fabs(values[i + 1]));
        area += bend * h * h * h / 12;
        moment += largest * bend * h * h * h / 12;
        square += bend * bend * h * h * h * h * h / 120;
        above = fmax(above, fmax(values[i], values[i + 1]) - bends[0] * h * h / 8 - found->greatest.value);
        below = fmax(below, found->least.value - fmin(values[i], values[i + 1]) + bends[1] * h * h / 8);
    }
    found->mean.error += area / (to - from);
    found->rms.error += fmin(sqrt(square / (to - from)), (2 * moment + square) / (to - from) / fabs(found->rms.value));
    found->greatest.error += above;
    found->least.error += below;
    found->amplitude.error += 0.5 * (above + below);
}

/* What the samples tell only as they are, and every second of them would not, has no error that is known. */
static void forget_untold(TinkerStatistics *found)
{
    const TinkerStatistic none = {NAN, NAN};
    if (found->no_period == TINKER_SWINGS_GOOD && !isfinite(found->period.error)) {
        found->period = none;
        found->no_period = TINKER_SWINGS_COARSE;
    }
    if (found->no_damping == TINKER_SWINGS_GOOD && isfinite(found->decrement.value) &&
        !isfinite(found->decrement.error)) {
        found->decrement = found->damping = none;
        found->no_damping = TINKER_SWINGS_COARSE;
    }
}

gboolean tinker_statistics(const double *times, const double *values, gsize count, double from, double to, double band,
                           TinkerStatistics *statistics)
{
    if (count / 2 + 1 < TINKER_CURVE_LEAST || !(to > from)) return FALSE;
    g_autofree double *room = NULL;
    const TinkerCurveSamples fine = {times, values, count}, coarse = tinker_every_second(&fine, &room);
    *statistics = measure(&fine, from, to, band);
    const TinkerStatistics rough = measure(&coarse, from, to, band);
    TinkerStatistic *all[] = {&statistics->mean,      &statistics->rms,       &statistics->least,
                              &statistics->greatest,  &statistics->amplitude, &statistics->period,
                              &statistics->decrement, &statistics->damping};
    const TinkerStatistic *others[] = {&rough.mean,      &rough.rms,    &rough.least,     &rough.greatest,
                                       &rough.amplitude, &rough.period, &rough.decrement, &rough.damping};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++)
        all[i]->error += fabs(all[i]->value - others[i]->value);
    for (gsize i = 0; i < OF_VALUES; i++)
        all[i]->error +=
            TINKER_STATISTIC_ROUNDING * fmax(fabs(statistics->least.value), fabs(statistics->greatest.value));
    add_between_events(&fine, from, to, statistics);
    forget_untold(statistics);
    return TRUE;
}

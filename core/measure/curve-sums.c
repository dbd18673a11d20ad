/* Extrema of a cubic piece are the roots of a quadratic; its mean is integrated exactly, its square by four nodes of
 * Gauss, which are exact to degree 7. */
#include <math.h>

#include "measure/statistics-private.h"

/* Of the whole range: smaller ways between two extrema are ripple of rounding, and a piece that changes by less is
 * level. */
#define RIPPLE 1e-9
/* Of what the curve may be off by: smaller ways at both ends, as of a swing that has died away, tell nothing. */
#define CERTAIN 10.0
/* What is 0 at both ends of a piece, there level, and 1 in its middle is 16 s^2 (1 - s)^2, and rises at most by this.
 */
#define STEEPEST 3.08

typedef struct {
    TinkerCurveSums *sums;
    double slope;     /* dy/dt at the end of the last piece, or of the sign of `way` at a level; NAN: there is none */
    double way;       /* y: from the last extremum in the last piece, or its start, to its end */
    double level;     /* y: what changes by less is level */
    double since;     /* s: the curve is level from there on; NAN: it is not */
    double off_since; /* s: how far off that may be */
    double at;        /* y: where it is level */
    double unclear;   /* y: what changes by less in the last piece that is not level may be that */
    double width;     /* s: from the last sample to the next */
    double off;       /* y: of the curve there */
    gboolean is_open; /* whether no more than values at samples are known there, and the last is none of an event */
} Walk;

static void note(const Walk *walk, double value, double off)
{
    TinkerCurveSums *sums = walk->sums;
    sums->least = fmin(sums->least, value);
    sums->greatest = fmax(sums->greatest, value);
    sums->below = fmin(sums->below, value - off);
    sums->above = fmax(sums->above, value + off);
}

static void add_extremum(const Walk *walk, double time, double value, double off_time, double off)
{
    const TinkerExtremum extremum = {time, value, fmin(off_time, walk->width), off};
    g_array_append_val(walk->sums->extrema, extremum);
}

/* Where the curve leaves what was level, some way up or down: of an extremum that is flat the middle counts. */
static void leave_level(Walk *walk, double time, double value, double way, double off_time)
{
    if (walk->slope * way < 0)
        add_extremum(walk, 0.5 * (walk->since + time), value, 0.5 * (walk->off_since + off_time), walk->off);
    walk->since = NAN;
}

/* Where the curve comes to be level. An extremum that rounding put there is none: the level is. */
static void enter_level(Walk *walk, const TinkerCurvePiece *piece)
{
    GArray *extrema = walk->sums->extrema;
    while (extrema->len > 0 &&
           fabs(g_array_index(extrema, TinkerExtremum, extrema->len - 1).value - piece->a) <= walk->unclear)
        g_array_set_size(extrema, extrema->len - 1);
    walk->since = piece->start;
    walk->off_since = walk->is_open ? walk->width : 0;
    walk->at = piece->a;
    walk->slope = walk->way;
}

/* A kink between two pieces is an extremum where the curve turns back there. */
static void add_kink(const Walk *walk, const TinkerCurvePiece *piece)
{
    const double slope = piece->b / piece->width, turn = fabs(slope - walk->slope);
    const double off_time = walk->is_open ? walk->width : 2 * walk->off / turn;
    if (walk->slope * slope < 0) add_extremum(walk, piece->start, piece->a, off_time, walk->off);
}

/* Straight up or down, at one time. Each of its ends may be an extremum. */
static void add_jump(Walk *walk, double time, double before, double behind)
{
    if (fabs(behind - before) <= walk->level) return;
    note(walk, before, 0);
    note(walk, behind, 0);
    if (isnan(walk->since)) {
        walk->since = time;
        walk->off_since = 0;
    }
    leave_level(walk, time, before, behind - before, 0);
    walk->slope = walk->way = behind - before;
}

/* Where a curve of this y'' is level moves by as much as its slope is off over y''. */
static void add_root(const Walk *walk, const TinkerCurvePiece *piece, double s)
{
    const double value = tinker_curve_piece_value(piece, s);
    const double bend = fabs(2 * piece->c + 6 * piece->d * s) / piece->width;
    note(walk, value, walk->off);
    add_extremum(walk, piece->start + s * piece->width, value, STEEPEST * walk->off / bend, walk->off);
}

static void add_piece(const Walk *walk, const TinkerCurvePiece *piece, double from, double to)
{
    static const double nodes[2] = {0.33998104358485626480, 0.86113631159405257522};
    static const double weights[2] = {0.65214515486254614263, 0.34785484513745385737};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    for (int k = 0; k < 4; k++) {
        const double y = tinker_curve_piece_value(piece, middle + (k % 2 ? half : -half) * nodes[k / 2]);
        const double time = piece->width * half * weights[k / 2];
        walk->sums->mean += time * y;
        walk->sums->square += time * y * y;
        walk->sums->off += time * walk->off;
        walk->sums->off_square += time * walk->off * (2 * fabs(y) + walk->off);
    }
    note(walk, tinker_curve_piece_value(piece, from), walk->off);
    note(walk, tinker_curve_piece_value(piece, to), walk->off);
}

/* The extrema within a piece, and what is level before it, which ends with the way to the first of them that is away
 * from there, or to the end; notes the way from the last one. */
static void add_extrema(Walk *walk, const TinkerCurvePiece *piece, double from, double to)
{
    const double end = tinker_curve_piece_value(piece, to), off_time = walk->is_open ? walk->width : 0;
    double roots[2], last = tinker_curve_piece_value(piece, from);
    tinker_curve_piece_level(piece, roots);
    for (int k = 0; k < 2; k++) {
        if (!(roots[k] > from && roots[k] <= to)) continue;
        const double value = tinker_curve_piece_value(piece, roots[k]);
        if (!isnan(walk->since) && fabs(value - piece->a) <= walk->unclear) continue;
        if (!isnan(walk->since)) leave_level(walk, piece->start, piece->a, value - piece->a, off_time);
        add_root(walk, piece, roots[k]);
        if (fabs(value - end) > walk->unclear) last = value;
    }
    if (!isnan(walk->since)) leave_level(walk, piece->start, piece->a, end - piece->a, off_time);
    walk->way = end - last;
}

/* Whether a piece changes by no more than rounding, and is where the curve has been level, if it has. */
static gboolean is_level(const Walk *walk, const TinkerCurvePiece *piece)
{
    const double change = fabs(piece->b) + fabs(piece->c) + fabs(piece->d);
    return change <= walk->level && (isnan(walk->since) || fabs(piece->a - walk->at) + change <= walk->level);
}

/* What of a piece lies between the two times. */
static void add_part(Walk *walk, const TinkerCurvePiece *piece, double from, double to)
{
    const double start = fmax(0, (from - piece->start) / piece->width),
                 end = fmin(1, (to - piece->start) / piece->width);
    if (!(start < end)) return;
    add_piece(walk, piece, start, end);
    const gboolean was_level = !isnan(walk->since);
    if (is_level(walk, piece)) {
        if (!was_level) enter_level(walk, piece);
        return;
    }
    walk->unclear = fmax(walk->level, walk->off);
    if (!was_level && start == 0) add_kink(walk, piece);
    add_extrema(walk, piece, start, end);
    walk->slope = tinker_curve_piece_end_slope(piece);
}

/* Extrema that are no ripple: a way back that is too small, or less than what is open between samples, takes both its
 * ends away. */
static void drop_ripple(TinkerCurveSums *sums)
{
    const double least = RIPPLE * (sums->greatest - sums->least);
    TinkerExtremum *all = (TinkerExtremum *)(gpointer)sums->extrema->data;
    guint kept = 0;
    for (guint i = 0; i < sums->extrema->len; i++) {
        const double open = kept >= 1 ? fmin(all[i].off_value, all[kept - 1].off_value) : 0;
        if (kept >= 1 && fabs(all[i].value - all[kept - 1].value) <= fmax(least, open))
            kept--;
        else
            all[kept++] = all[i];
    }
    g_array_set_size(sums->extrema, kept);
}

/* Of both ends, as far as ways are not certain; each goes with the extremum at its outer end. */
static void drop_uncertain_ends(GArray *extrema, double band)
{
    const double least = CERTAIN * band;
    while (extrema->len >= 2 && tinker_extremum_way(extrema, extrema->len - 2) < least)
        g_array_set_size(extrema, extrema->len - 1);
    guint first = 0;
    while (first + 1 < extrema->len && tinker_extremum_way(extrema, first) < least)
        first++;
    if (first > 0) g_array_remove_range(extrema, 0, first);
}

/* y: what is no change, between the two times. */
static double level_of(const TinkerCurveSamples *samples, double from, double to)
{
    double least = INFINITY, greatest = -INFINITY;
    for (gsize i = 0; i < samples->count; i++) {
        if (samples->times[i] < from || samples->times[i] > to) continue;
        least = fmin(least, samples->values[i]);
        greatest = fmax(greatest, samples->values[i]);
    }
    return greatest > least ? RIPPLE * (greatest - least) : 0;
}

TinkerCurveSums tinker_curve_sums(const TinkerCurveSamples *samples, const double *off, double from, double to,
                                  double band)
{
    TinkerCurveSums sums = {.least = INFINITY,
                            .greatest = -INFINITY,
                            .below = INFINITY,
                            .above = -INFINITY,
                            .extrema = g_array_new(FALSE, FALSE, sizeof(TinkerExtremum))};
    Walk walk = {.sums = &sums, .slope = NAN, .way = NAN, .level = level_of(samples, from, to), .since = NAN};
    for (gsize i = 0; i + 1 < samples->count; i++) {
        const double start = samples->times[i], end = samples->times[i + 1];
        if (start == end && start > from && start < to)
            add_jump(&walk, start, samples->values[i], samples->values[i + 1]);
        if (end <= from || start >= to || !(end > start)) continue;
        TinkerCurvePiece pieces[2];
        const guint count = tinker_curve_pieces(samples, i, pieces);
        walk.width = fmax(end - start, i > 0 ? start - samples->times[i - 1] : 0);
        walk.off = off[i];
        walk.is_open = tinker_is_between_events(samples, i) && !(i > 0 && samples->times[i - 1] == start);
        for (guint k = 0; k < count; k++)
            add_part(&walk, &pieces[k], from, to);
    }
    drop_ripple(&sums);
    drop_uncertain_ends(sums.extrema, band);
    return sums;
}

void tinker_curve_sums_clear(TinkerCurveSums *sums)
{
    g_clear_pointer(&sums->extrema, g_array_unref);
}

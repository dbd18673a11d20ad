/* Edges whose ends pass each other: with a length or a tension of its own an edge pushes the other way beyond d =
 * 0, so the equations hold up to there only.
 *
 * Mostly nothing has to be looked at: energy bounds the modes, these the way that d can go. Where d = 0 is within
 * reach the step is halved until on each piece either d stays away from 0 (it leaves its chord by at most |d''|
 * h^2 / 8), or d' keeps its sign and d has the same sign at both ends, so that no pair of passings is missed; the
 * piece with the passing is halved until d changes by rounding only. States on the way come from exact
 * propagators, one for each level of halving.
 *
 * Where d only touches 0, to rounding, the equations go on as they are; but which way the ends part there is decided by
 * rounding, and somebody may want to know. So a step ends on that as well, once for each time that d comes there.
 */
#include <float.h>
#include <math.h>
#include <string.h>

#include "numerics/exact/exact-private.h"

#define DEEPEST          60
#define MOST_EVALUATIONS 200000
/* Of the rounding of d: an edge meets 0 within so much of it, and has left it beyond so much. */
#define MEETS 8.0
#define LEFT  1e4

/* From a state, the signals having `values` there, on for h. */
typedef struct {
    TinkerExactPart *part;
    const double *z;
    TinkerExactValues *values;
    double h;
} Reach;

static double signal_force(const Reach *reach, int32_t j)
{
    const TinkerExactPart *part = reach->part;
    double force = 0.0;
    for (int32_t s = 0; s < part->signal_count; s++) {
        const TinkerExactSignal *signal = &part->signals[s];
        const TinkerLinearInput *input = &part->inputs[signal->input];
        TinkerExactValues rates;
        tinker_exact_derivative(input, reach->values[s], rates);
        force += fabs(signal->by_value[j]) * tinker_exact_bound(input, reach->values[s], reach->h);
        force += fabs(signal->by_rate[j]) * tinker_exact_bound(input, rates, reach->h);
    }
    return force;
}

/* The root of twice the energy that mode j has about where the constant force holds it. */
static double mode_energy(const Reach *reach, int32_t j)
{
    const TinkerExactPart *part = reach->part;
    double offset = part->omega[j] > 0.0 ? reach->z[j] - part->push[j] / part->omega[j] : 0.0;
    return hypot(offset, reach->z[part->n + j]);
}

/* How much energy every mode can have within the reach, and how much of d'' it can make: by its own energy, and what
 * signals add to it; of coupled modes by that of all. */
static void bound_modes(const Reach *reach)
{
    TinkerExactPart *part = reach->part;
    double h = fabs(reach->h), all = 0.0, forced = 0.0;
    gboolean grows = FALSE;
    for (int32_t j = 0; j < part->n; j++) {
        double force = signal_force(reach, j), energy = mode_energy(reach, j);
        if (part->omega[j] == 0.0) force += fabs(part->push[j]);
        if (part->coupled) {
            all = hypot(all, energy);
            forced = hypot(forced, force);
            grows = grows || part->decay[(gsize)j * (gsize)part->n + j] < 0.0;
            continue;
        }
        energy += h * force;
        if (part->decay[j] < 0.0) energy *= exp(-part->decay[j] * h);
        part->energy[j] = energy;
        part->bend[j] = (part->omega[j] + fabs(part->decay[j])) * energy + force;
    }
    for (int32_t j = 0; part->coupled && j < part->n; j++) {
        part->energy[j] = grows ? INFINITY : all + h * forced;
        part->bend[j] = part->rate * part->energy[j] + forced;
    }
}

/* Whether edge e can get to d = 0 within the reach of bounded modes, before the time t; sets the bound on d'' and how
 * far rounding may move d, of the anchors by rounding of t. `*lasting` is cleared where the answer depends on h. */
static gboolean can_pass(const Reach *reach, double t, int32_t e, gboolean *lasting)
{
    const TinkerExactPart *part = reach->part;
    TinkerExactEdge *edge = &reach->part->edges[e];
    const double *row = part->elongation + (gsize)e * (gsize)part->n;
    double centre = edge->place, here = centre, way = 0.0, bend = 0.0, size = 0.0, drift = 0.0;
    double free_way = 0.0, square_way = 0.0, square_speed = 0.0, speed = 0.0;
    for (int32_t j = 0; j < part->n; j++) {
        if (row[j] == 0.0) continue;
        double share = row[j] * (reach->z[j] / tinker_linear_scale(part->omega[j]));
        here += share;
        size += fabs(share);
        bend += fabs(row[j]) * part->bend[j];
        speed += fabs(row[j]) * part->energy[j];
        square_speed += row[j] * row[j];
        if (part->omega[j] > 0.0) {
            centre += row[j] * (part->push[j] / part->omega[j] / part->omega[j]);
            way += fabs(row[j]) * (part->energy[j] / part->omega[j]);
            square_way += row[j] / part->omega[j] * (row[j] / part->omega[j]);
        } else {
            *lasting = FALSE;
            centre += row[j] * reach->z[j];
            free_way += fabs(row[j]) * fabs(reach->h) * part->energy[j];
        }
    }
    if (part->coupled && part->n > 0) { /* all modes share one energy: by Cauchy and Schwarz */
        way = part->energy[0] * sqrt(square_way);
        speed = part->energy[0] * sqrt(square_speed);
    }
    way += free_way;
    for (int32_t m = 0; edge->moved && m < part->move_count; m++) {
        const TinkerExactMove *move = &part->moves[m];
        if (move->edge != e) continue;
        const TinkerLinearInput *input = &part->inputs[part->signals[move->signal].input];
        TinkerExactValues rates, seconds;
        tinker_exact_derivative(input, reach->values[move->signal], rates);
        tinker_exact_derivative(input, rates, seconds);
        way += fabs(move->factor) * tinker_exact_bound(input, reach->values[move->signal], reach->h);
        bend += fabs(move->factor) * tinker_exact_bound(input, seconds, reach->h);
        drift += fabs(move->factor) * tinker_exact_bound(input, rates, reach->h);
        here += move->factor * reach->values[move->signal][0];
    }
    edge->limit = fmax(bend, DBL_MIN);
    edge->noise = DBL_EPSILON * ((4.0 + part->n) * (fabs(edge->place) + size) + 8.0 * t * drift);
    if (edge->sign * centre - MEETS * edge->noise > way) return FALSE;
    *lasting = FALSE; /* what it cannot reach within h it may reach later */
    return !(edge->sign * here - MEETS * edge->noise > fabs(reach->h) * (speed + drift));
}

/* Whether any edge can; those that cannot get a limit of 0. */
static gboolean look_ahead(const Reach *reach, double t, gboolean *lasting)
{
    TinkerExactPart *part = reach->part;
    gboolean any = FALSE;
    bound_modes(reach);
    for (int32_t e = 0; e < part->edge_count; e++) {
        if (!part->edges[e].watched) continue;
        gboolean can = can_pass(reach, t, e, lasting);
        if (!can) part->edges[e].limit = 0.0;
        any = any || can;
    }
    return any;
}

/* d and d' (times the sign) of an edge in a state. */
static void measure(const TinkerExactPart *part, int32_t e, const double *z, TinkerExactValues *values, double *d,
                    double *rate)
{
    const TinkerExactEdge *edge = &part->edges[e];
    gsize n = (gsize)part->n;
    const double *row = part->elongation + (gsize)e * n;
    *d = edge->place;
    *rate = 0.0;
    for (gsize j = 0; j < n; j++) {
        *d += row[j] * (z[j] / tinker_linear_scale(part->omega[j]));
        *rate += row[j] * z[n + j];
    }
    for (int32_t m = 0; edge->moved && m < part->move_count; m++) {
        const TinkerExactMove *move = &part->moves[m];
        if (move->edge != e) continue;
        TinkerExactValues rates;
        tinker_exact_derivative(&part->inputs[part->signals[move->signal].input], values[move->signal], rates);
        *d += move->factor * values[move->signal][0];
        *rate += move->factor * rates[0];
    }
    *d *= edge->sign;
    *rate *= edge->sign;
}

typedef enum { STAYS, MEETS_HERE, UNCLEAR, PASSES, PASSES_HERE } Verdict;

/* Of an edge that does not pass within a piece of the length h. */
static Verdict judge_edge(const TinkerExactEdge *edge, double h)
{
    double least = fmin(edge->now, edge->ahead), bend = edge->limit * h * h / 8.0;
    gboolean straight = edge->now >= -edge->noise && fabs(edge->rate) > edge->limit * fabs(h);
    if (straight || least - MEETS * edge->noise > bend) return STAYS;
    if (edge->met) return least + edge->noise > bend ? STAYS : UNCLEAR;
    return fmax(edge->now, edge->ahead) <= 2.0 * MEETS * edge->noise ? MEETS_HERE : UNCLEAR;
}

/* Of a piece of the length h, from what edges measured at its start (now, rate) to what they measure at its end. A
 * passing is found where the piece is so short that d changes by rounding only. */
static Verdict judge(TinkerExactPart *part, const double *z, TinkerExactValues *values, double h)
{
    Verdict verdict = STAYS;
    for (int32_t e = 0; e < part->edge_count; e++) {
        TinkerExactEdge *edge = &part->edges[e];
        if (!edge->watched || edge->limit == 0.0) continue;
        double rate;
        measure(part, e, z, values, &edge->ahead, &rate);
        if (edge->ahead < -edge->noise) {
            double change = fabs(h) * (fabs(edge->rate) + fabs(h) * edge->limit);
            if (change > 0.5 * edge->noise) return PASSES;
            verdict = PASSES_HERE;
            continue;
        }
        verdict = MAX(verdict, judge_edge(edge, h));
    }
    return verdict;
}

/* Makes a state the start of what comes next. */
static void stand_at(TinkerExactPart *part, const double *z, TinkerExactValues *values)
{
    for (int32_t e = 0; e < part->edge_count; e++) {
        TinkerExactEdge *edge = &part->edges[e];
        if (!edge->watched || edge->limit == 0.0) continue;
        measure(part, e, z, values, &edge->now, &edge->rate);
        if (edge->now > LEFT * edge->noise) edge->met = FALSE;
    }
}

static void mark(TinkerExactPart *part)
{
    for (int32_t e = 0; e < part->edge_count; e++) {
        TinkerExactEdge *edge = &part->edges[e];
        gboolean looked_at = edge->watched && edge->limit != 0.0;
        edge->due = looked_at && edge->ahead < -edge->noise;
        edge->meets = looked_at && !edge->due && edge->ahead <= 2.0 * MEETS * edge->noise;
    }
}

/* The search itself, as far as it gets with so many evaluations; the state at the start of the present piece is in the
 * scratch, that at its end behind it. What is within reach is bounded anew for every piece: over a long step a signal
 * or a fast motion that dies away would leave bounds, and so pieces, that are far too small. */
static double search(TinkerExactPart *part, const TinkerSignal *signals, double t, double h)
{
    double *here = part->scratch, *there = here + 2 * part->n;
    int level = 0;
    int64_t at = 0, whole = (int64_t)1 << DEEPEST;
    memcpy(here, part->z, 2 * (gsize)part->n * sizeof *here);
    for (int32_t count = 0; at < whole && count < MOST_EVALUATIONS; count++) {
        double length = ldexp(h, -level), start = t + h * ((double)at / (double)whole);
        const TinkerExactSlot *slot = tinker_exact_slot(part, length, 0.0, TRUE, FALSE);
        if (!slot) return h;
        tinker_exact_part_values(part, signals, start, part->ahead);
        gboolean lasting = FALSE;
        if (look_ahead(&(Reach){part, here, part->ahead, length}, fabs(t) + fabs(h), &lasting))
            stand_at(part, here, part->ahead);
        tinker_exact_part_drive(part, part->ahead);
        tinker_exact_part_advance(part, slot, here, there);
        tinker_exact_part_values(part, signals, start + length, part->ahead);
        Verdict verdict = judge(part, there, part->ahead, length);
        if ((verdict == PASSES || verdict == UNCLEAR) && level < DEEPEST) {
            level++;
            continue;
        }
        at += whole >> level;
        if (verdict == PASSES || verdict == PASSES_HERE || verdict == MEETS_HERE) {
            mark(part);
            part->landed = TRUE;
            return h * ((double)at / (double)whole);
        }
        memcpy(here, there, 2 * (gsize)part->n * sizeof *here);
        while (level > 0 && at % (whole >> (level - 1)) == 0)
            level--;
    }
    return at > 0 ? h * ((double)at / (double)whole) : h;
}

double tinker_exact_part_passing(TinkerExactPart *part, const TinkerSignal *signals, double t, double h)
{
    part->landed = FALSE;
    if (part->watched == 0 || part->quiet) return h;
    gboolean lasting = part->signal_count == 0;
    if (look_ahead(&(Reach){part, part->z, part->values, h}, fabs(t) + fabs(h), &lasting))
        return search(part, signals, t, h);
    for (int32_t j = 0; j < part->n; j++)
        if (part->decay[part->coupled ? (gsize)j * (gsize)part->n + j : (gsize)j] < 0.0) lasting = FALSE;
    part->quiet = lasting;
    return h;
}

/* Taking one part over a step: from places to modes, through the propagator, and back. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "numerics/exact/exact-private.h"
#include "numerics/exact/linear-dense.h"
#include "numerics/integrate/signal.h"

static double end_of(const TinkerExactPart *part, int32_t end, const double *x)
{
    return end >= 0 ? x[end] : part->linear->anchors[-1 - end];
}

/* d and its rate where the part starts, and which side of 0 that is. Within rounding of 0 it is where d goes. */
static void place_edge(TinkerExactPart *part, int32_t e, const double *q, const double *v)
{
    TinkerExactEdge *mine = &part->edges[e];
    const TinkerLinearEdge *edge = &part->linear->edges[mine->edge];
    double a = end_of(part, edge->a, q), b = end_of(part, edge->b, q), moved = 0.0, rate = 0.0,
           reach = fabs(a) + fabs(b);
    if (edge->b >= 0) rate += v[edge->b];
    if (edge->a >= 0) rate -= v[edge->a];
    for (int32_t k = 0; k < part->move_count; k++) {
        const TinkerExactMove *move = &part->moves[k];
        if (move->edge != e) continue;
        TinkerExactValues rates;
        double *values = part->values[move->signal];
        tinker_exact_derivative(&part->inputs[part->signals[move->signal].input], values, rates);
        moved += move->factor * values[0];
        rate += move->factor * rates[0];
        reach += fabs(move->factor * values[0]);
    }
    mine->place = b - a;
    mine->due = mine->meets = mine->met = FALSE;
    double d = mine->place + moved;
    if (fabs(d) > 64.0 * DBL_EPSILON * reach) {
        mine->sign = copysign(1.0, d);
    } else {
        if (mine->watched) mine->place = -moved;
        mine->sign = rate < 0.0 ? -1.0 : 1.0;
        mine->met = TRUE;
    }
}

void tinker_exact_part_set_constant_forces(TinkerExactPart *part)
{
    gsize n = (gsize)part->n;
    part->quiet = FALSE;
    memcpy(part->push, part->load, n * sizeof *part->push);
    for (int32_t e = 0; e < part->edge_count; e++) {
        TinkerExactEdge *mine = &part->edges[e];
        const TinkerLinearEdge *edge = &part->linear->edges[mine->edge];
        mine->pull = mine->sign * edge->tension + edge->stiffness * (mine->place - mine->sign * edge->length);
        if (mine->pull == 0.0) continue;
        const double *row = part->elongation + (gsize)e * n;
        for (gsize j = 0; j < n; j++)
            part->push[j] -= mine->pull * row[j];
    }
}

void tinker_exact_part_values(TinkerExactPart *part, const TinkerSignal *signals, double t, TinkerExactValues *values)
{
    for (int32_t s = 0; s < part->signal_count; s++)
        tinker_signal_values(&signals[part->signals[s].id], t, values[s]);
}

void tinker_exact_part_start(TinkerExactPart *part, const double *q, const double *v, const TinkerSignal *signals,
                             double t)
{
    int32_t n = part->n;
    for (int32_t i = 0; i < n; i++) {
        part->reference[i] = q[part->coordinates[i]];
        part->speed[i] = v[part->coordinates[i]];
    }
    memset(part->z, 0, (gsize)n * sizeof *part->z);
    tinker_dense_apply(n, n, part->weigh, part->speed, part->z + n);
    tinker_exact_part_values(part, signals, t, part->values);
    for (int32_t e = 0; e < part->edge_count; e++)
        place_edge(part, e, q, v);
    tinker_exact_part_set_constant_forces(part);
}

static void drive_modes(TinkerExactPart *part, TinkerExactValues *values)
{
    gsize n = (gsize)part->n;
    memset(part->amplitude, 0, (gsize)part->entries * n * sizeof *part->amplitude);
    memcpy(part->amplitude, part->push, n * sizeof *part->amplitude);
    for (int32_t s = 0; s < part->signal_count; s++) {
        const TinkerExactSignal *signal = &part->signals[s];
        const TinkerLinearInput *input = &part->inputs[signal->input];
        TinkerExactValues rates;
        tinker_exact_derivative(input, values[s], rates);
        for (int32_t r = 0; r < input->count; r++) {
            double *to = part->amplitude + (gsize)(input->first + r) * n;
            for (gsize j = 0; j < n; j++)
                to[j] += signal->by_value[j] * values[s][r] + signal->by_rate[j] * rates[r];
        }
    }
}

void tinker_exact_part_drive(TinkerExactPart *part, TinkerExactValues *values)
{
    if (!part->coupled) {
        drive_modes(part, values);
        return;
    }
    int32_t fixed = 0;
    for (int32_t j = 0; j < part->n; j++)
        if (part->omega[j] == 0.0) part->amplitude[fixed++] = part->push[j];
    for (int32_t s = 0; s < part->signal_count; s++) {
        const TinkerLinearInput *input = &part->inputs[part->signals[s].input];
        memcpy(part->amplitude + input->first, values[s], (gsize)input->count * sizeof(double));
    }
}

static void advance_modes(const TinkerExactPart *part, const TinkerExactSlot *slot, const double *restrict from,
                          double *restrict to)
{
    gsize n = (gsize)part->n, entries = (gsize)part->entries;
    const double *f = slot->propagator, *a = part->amplitude;
    for (gsize j = 0; j < n; j++) {
        double y = from[j], w = from[n + j];
        double dy = f[j] * y + f[n + j] * w, dw = f[2 * n + j] * y + f[3 * n + j] * w;
        for (gsize r = 0; r < entries; r++) {
            dy += slot->response[r * n + j] * a[r * n + j];
            dw += slot->response[(entries + r) * n + j] * a[r * n + j];
        }
        to[j] = y + dy;
        to[n + j] = w + dw;
    }
}

/* Coupled modes with stiffness move about where the constant force holds them; that shift is part of the vector. */
static void gather(TinkerExactPart *part, const double *z, double *vector)
{
    int32_t n = part->n;
    for (int32_t j = 0; j < n; j++) {
        vector[j] = part->omega[j] > 0.0 ? z[j] - part->push[j] / part->omega[j] : z[j];
        vector[n + j] = z[n + j];
    }
    memcpy(vector + 2 * n, part->amplitude, (gsize)part->entries * sizeof *vector);
}

void tinker_exact_part_advance(TinkerExactPart *part, const TinkerExactSlot *slot, const double *from, double *to)
{
    if (!part->coupled) {
        advance_modes(part, slot, from, to);
        return;
    }
    int32_t n = part->n, d = 2 * n + part->entries;
    double *vector = part->amplitude + part->entries;
    gather(part, from, vector);
    double *change = part->work;
    tinker_dense_apply(2 * n, d, slot->propagator, vector, change);
    for (int32_t i = 0; i < 2 * n; i++)
        to[i] = from[i] + change[i];
}

/* A piece of a step from its own start; the values there must be set. */
static void advance_piece(TinkerExactPart *part, const TinkerExactSlot *slot, const double *from, double *to,
                          double *books)
{
    tinker_exact_part_drive(part, part->values);
    tinker_exact_part_advance(part, slot, from, to);
    if (books && part->booked) tinker_exact_part_book(part, slot, from, to, books);
}

/* Whether a propagator for any time is a few closed forms. */
static gboolean is_closed(const TinkerExactPart *part)
{
    return !part->coupled && part->signal_count == 0;
}

/* Whether it is so short that the series of the one vector is cheaper than a propagator. Books have none. */
static gboolean is_short(const TinkerExactPart *part, double h, gboolean booked)
{
    return !booked && !is_closed(part) && part->rate * fabs(h) <= TINKER_LINEAR_SERIES_REACH;
}

static void go_by_series(TinkerExactPart *part, const TinkerSignal *signals, double t, double h, const double *from,
                         double *to)
{
    int32_t n = part->n;
    double *vector = part->amplitude + part->entries;
    tinker_exact_part_values(part, signals, t, part->values);
    tinker_exact_part_drive(part, part->values);
    if (part->coupled) gather(part, from, vector);
    tinker_exact_part_series(part, h, part->coupled ? vector : from, part->amplitude, to);
    for (int32_t i = 0; i < 2 * n; i++)
        to[i] += from[i];
}

/* Coupled modes go by halves of the step, quarters and so on, whose propagators are there already after a few times:
 * a new one for every place would cost as much as a new step length. What is left in the end is short. */
static const double *go_by_levels(TinkerExactPart *part, const TinkerSignal *signals, double t_from, double h,
                                  double tolerance, double *books)
{
    const double *from = part->from;
    double *to = part->scratch, *other = part->scratch + 2 * part->n, rest = h, piece = 0.5 * part->length;
    for (int level = 1; level < TINKER_EXACT_MOST_LEVELS && fabs(rest) > tolerance; level++, piece *= 0.5) {
        if (is_short(part, rest, books && part->booked)) {
            go_by_series(part, signals, t_from + (h - rest), rest, from, to);
            return to;
        }
        if (fabs(rest) < fabs(piece)) continue;
        const TinkerExactSlot *slot = tinker_exact_slot(part, piece, 0.0, TRUE, books && part->booked);
        if (!slot) return NULL;
        tinker_exact_part_values(part, signals, t_from + (h - rest), part->values);
        rest -= piece;
        tinker_exact_part_values(part, signals, t_from + (h - rest), part->ahead);
        advance_piece(part, slot, from, to, books);
        from = to;
        to = other;
        other = (double *)from;
    }
    return from;
}

const double *tinker_exact_part_inside(TinkerExactPart *part, const TinkerSignal *signals, double t_from, double h,
                                       double tolerance, double *books)
{
    gboolean booked = books && part->booked;
    if (is_short(part, h, booked)) {
        go_by_series(part, signals, t_from, h, part->from, part->scratch);
        return part->scratch;
    }
    if (part->coupled && tinker_exact_has_levels(part) && fabs(h) < fabs(part->length))
        return go_by_levels(part, signals, t_from, h, tolerance, books);
    /* A length of 0 marks an empty propagator. */
    const TinkerExactSlot *slot = tinker_exact_slot(part, h == 0.0 ? DBL_MIN : h, 0.0, TRUE, booked);
    if (!slot) return NULL;
    tinker_exact_part_values(part, signals, t_from, part->values);
    tinker_exact_part_values(part, signals, t_from + h, part->ahead);
    advance_piece(part, slot, part->from, part->scratch, books);
    return part->scratch;
}

void tinker_exact_part_write(TinkerExactPart *part, const double *z, double *q, double *v)
{
    int32_t n = part->n;
    double *eta = part->before;
    for (int32_t j = 0; j < n; j++)
        eta[j] = z[j] / tinker_linear_scale(part->omega[j]);
    tinker_dense_apply(n, n, part->shape, eta, part->place);
    tinker_dense_apply(n, n, part->shape, z + n, part->speed);
    for (int32_t i = 0; i < n; i++) {
        q[part->coordinates[i]] = part->reference[i] + part->place[i];
        v[part->coordinates[i]] = part->speed[i];
    }
}

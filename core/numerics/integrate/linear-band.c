/* Loads and steps of a linear system whose matrices are at hand by diagonals (linear-band-matrices.c). */
#include <math.h>
#include <string.h>

#include "numerics/integrate/linear-band-private.h"

/* Of a step in which edges turn round. */
#define MOST_TURNS 8

/* Loads ---------------------------------------------------------------------------------------------------------- */

static void signal_at(const TinkerSignal *signal, double t, double *value, double *rate)
{
    double values[4];
    tinker_signal_values(signal, t, values);
    *value = values[0];
    *rate = signal->kind == TINKER_SIGNAL_HARMONIC ? signal->coefficient[1] * values[1] : values[1];
}

/* What does not change while no edge turns round: constant loads, pushes, springs to unmoved anchors. */
static void find_steady(TinkerLinearBand *self)
{
    const TinkerLinearSystem *linear = self->linear;
    memset(self->steady, 0, sizeof(double) * (gsize)self->n);
    for (int32_t i = 0; i < linear->load_count; i++)
        self->steady[self->place[linear->loads[i].target]] += linear->loads[i].force;
    for (int32_t i = 0; i < self->turning_count; i++) {
        const TinkerTurningEdge *edge = &self->turning[i];
        if (edge->a >= 0) self->steady[edge->a] += edge->sign * edge->push;
        if (edge->b >= 0) self->steady[edge->b] -= edge->sign * edge->push;
    }
    for (int32_t e = 0; e < linear->edge_count; e++) {
        const TinkerLinearEdge *edge = &linear->edges[e];
        if (edge->a >= 0 && edge->b < 0)
            self->steady[self->place[edge->a]] += edge->stiffness * linear->anchors[-1 - edge->b];
        if (edge->b >= 0 && edge->a < 0)
            self->steady[self->place[edge->b]] += edge->stiffness * linear->anchors[-1 - edge->a];
    }
}

static void add_motions(TinkerLinearBand *self, double t)
{
    const TinkerLinearSystem *linear = self->linear;
    for (int32_t k = 0; k < linear->anchor_count; k++)
        self->anchor_move[k] = self->anchor_rate[k] = 0;
    for (int32_t i = 0; i < linear->motion_count; i++) {
        const TinkerSignalUse *use = &linear->motions[i];
        double value, rate;
        signal_at(&self->signals[use->signal], t, &value, &rate);
        self->anchor_move[use->target] += use->factor * value;
        self->anchor_rate[use->target] += use->factor * rate;
    }
    for (int32_t k = 0; k < linear->anchor_count; k++)
        self->anchor[k] = linear->anchors[k] + self->anchor_move[k];
    for (int32_t e = 0; e < linear->edge_count; e++) {
        const TinkerLinearEdge *edge = &linear->edges[e];
        if ((edge->a >= 0) == (edge->b >= 0)) continue;
        int32_t anchor = -1 - MIN(edge->a, edge->b);
        self->load[self->place[MAX(edge->a, edge->b)]] +=
            edge->stiffness * self->anchor_move[anchor] + edge->damping * self->anchor_rate[anchor];
    }
}

/* Answers the forces at t beside those of springs and dampers. */
static const double *loads_at(TinkerLinearBand *self, double t)
{
    const TinkerLinearSystem *linear = self->linear;
    if (linear->force_count == 0 && linear->motion_count == 0) return self->steady;
    memcpy(self->load, self->steady, sizeof(double) * (gsize)self->n);
    for (int32_t i = 0; i < linear->force_count; i++) {
        const TinkerSignalUse *use = &linear->forces[i];
        double value, rate;
        signal_at(&self->signals[use->signal], t, &value, &rate);
        self->load[self->place[use->target]] += use->factor * value;
    }
    if (linear->motion_count > 0) add_motions(self, t);
    return self->load;
}

/* Brings the signs of d up to the places `at`; TRUE where one changed. */
static gboolean turn(TinkerLinearBand *self, const double *at)
{
    gboolean turned = FALSE;
    for (int32_t i = 0; i < self->turning_count; i++) {
        TinkerTurningEdge *edge = &self->turning[i];
        double a = edge->a >= 0 ? at[edge->a] : self->anchor[-1 - edge->a];
        double b = edge->b >= 0 ? at[edge->b] : self->anchor[-1 - edge->b];
        if ((b - a) * edge->sign > 0 || b == a) continue;
        edge->sign = b > a ? 1 : -1;
        turned = TRUE;
    }
    if (turned) find_steady(self);
    return turned;
}

TinkerStatus tinker_linear_band_enter(TinkerLinearBand *self, double t, const double *q)
{
    const TinkerLinearSystem *linear = self->linear;
    if (linear->signal_count > 0) {
        TinkerStatus status = self->system->signals(self->system->context, self->signals);
        if (status != TINKER_OK) return status;
    }
    for (int32_t k = 0; k < linear->anchor_count; k++)
        self->anchor[k] = linear->anchors[k];
    for (int32_t i = 0; i < self->turning_count; i++)
        self->turning[i].sign = 0;
    for (int32_t i = 0; i < self->n; i++)
        self->at[self->place[i]] = q[i];
    find_steady(self);
    loads_at(self, t);
    turn(self, self->at);
    return TINKER_OK;
}

/* Steps ---------------------------------------------------------------------------------------------------------- */

gboolean tinker_linear_band_factor(TinkerLinearBand *self, const TinkerNewmarkWeights *w, double h)
{
    double by_mass = 1 - w->mean_acceleration, by_v = (1 - w->mean_force) * h * w->gamma;
    double by_q = (1 - w->mean_force) * h * h * w->beta;
    TinkerBandedLdl *ldl = &self->ldl;
    for (int32_t p = 0; p < self->n; p++) {
        ldl->pivots[p] = by_mass * self->mass[p] + by_v * self->damping[p] + by_q * self->stiffness[p];
        for (int32_t k = 1; k <= MIN(self->width, p); k++) {
            gsize entry = (gsize)k * self->stride + (gsize)(p - k);
            ldl->rows[(gsize)p * (gsize)self->width + (gsize)(self->width - k)] =
                by_v * self->damping[entry] + by_q * self->stiffness[entry];
        }
    }
    return tinker_banded_ldl_factor(ldl);
}

/* x -= matrix y. */
static inline void subtract_product(int32_t n, int32_t width, gsize stride, const double *restrict matrix,
                                    const double *restrict y, double *restrict x)
{
    for (int32_t p = 0; p < n; p++)
        x[p] -= matrix[p] * y[p];
    for (int32_t k = 1; k <= width; k++) {
        const double *restrict diagonal = matrix + (gsize)k * stride;
        for (int32_t p = 0; p < n; p++)
            x[p] -= diagonal[p] * y[p + k] + diagonal[p - k] * y[p - k];
    }
}

/* What a step reads and writes in the order of the coordinates. */
typedef struct {
    const double *q, *v, *a, *behind;
    double *x, *to_q, *to_v;
    double h, old_q, new_q, old_v, new_v;
} Move;

static inline __attribute__((always_inline)) void predict(const TinkerLinearBand *self, const Move *move,
                                                          const int32_t *order)
{
    const double *restrict q = move->q, *restrict v = move->v, *restrict a = move->a;
    double *restrict to_q = self->q, *restrict to_v = self->v, h = move->h, old_q = move->old_q, old_v = move->old_v;
    for (int32_t p = 0; p < self->n; p++) {
        int32_t i = order != NULL ? order[p] : p;
        to_q[p] = q[i] + (h * v[i] + old_q * a[i]);
        to_v[p] = v[i] + old_v * a[i];
    }
}

/* (1 - mean_force) F + M (mean_force behind - mean_acceleration a), with F in x. */
static inline __attribute__((always_inline)) void weigh(const TinkerLinearBand *self, const TinkerNewmarkWeights *w,
                                                        const Move *move, const int32_t *order)
{
    const double *restrict a = move->a, *restrict behind = move->behind, *restrict mass = self->mass;
    double *restrict x = self->x, by_a = w->mean_acceleration, by_behind = w->mean_force;
    for (int32_t p = 0; p < self->n; p++) {
        int32_t i = order != NULL ? order[p] : p;
        x[p] = (1 - by_behind) * x[p] + mass[p] * (by_behind * behind[i] - by_a * a[i]);
    }
}

static inline __attribute__((always_inline)) void arrive(const TinkerLinearBand *self, const Move *move,
                                                         const int32_t *order)
{
    const double *restrict found = self->x, *restrict from_q = self->q, *restrict from_v = self->v;
    double *restrict x = move->x, *restrict to_q = move->to_q, *restrict to_v = move->to_v, *restrict at = self->at;
    double new_q = move->new_q, new_v = move->new_v;
    for (int32_t p = 0; p < self->n; p++) {
        int32_t i = order != NULL ? order[p] : p;
        x[i] = found[p];
        to_q[i] = at[p] = from_q[p] + new_q * found[p];
        to_v[i] = from_v[p] + new_v * found[p];
    }
}

static void work_out(TinkerLinearBand *self, const TinkerNewmarkWeights *w, const Move *move, const double *load)
{
    memcpy(self->x, load, sizeof(double) * (gsize)self->n);
    if (self->width == 1) { /* a chain: the compiler knows the loops' lengths */
        subtract_product(self->n, 1, self->stride, self->stiffness, self->q, self->x);
        if (self->damped) subtract_product(self->n, 1, self->stride, self->damping, self->v, self->x);
    } else {
        subtract_product(self->n, self->width, self->stride, self->stiffness, self->q, self->x);
        if (self->damped) subtract_product(self->n, self->width, self->stride, self->damping, self->v, self->x);
    }
    if (w->mean_force != 0 || w->mean_acceleration != 0) {
        if (self->order != NULL)
            weigh(self, w, move, self->order);
        else
            weigh(self, w, move, NULL);
    }
    tinker_banded_ldl_solve(&self->ldl, self->x);
    if (self->order != NULL)
        arrive(self, move, self->order);
    else
        arrive(self, move, NULL);
}

void tinker_linear_band_step(TinkerLinearBand *self, const TinkerNewmarkWeights *w, double h, double t,
                             const TinkerBandStart *start, double *x, double *q, double *v)
{
    Move move = {start->q,        start->v,           start->a,    start->behind, x, q, v, h, h * h * (0.5 - w->beta),
                 h * h * w->beta, h * (1 - w->gamma), h * w->gamma};
    if (self->order != NULL)
        predict(self, &move, self->order);
    else
        predict(self, &move, NULL);
    work_out(self, w, &move, loads_at(self, t));
    for (int turns = 0; turns < MOST_TURNS && turn(self, self->at); turns++)
        work_out(self, w, &move, loads_at(self, t));
}

/* Weighted sums of the accelerations and powers of stages. */
#include "numerics/integrate/explicit-rk-private.h"

#include <math.h>
#include <string.h>

#define LANES 4
#define FOURS 2 /* that are summed at once, in registers */

/* Numbers side by side. GCC 12 does not vectorise the sums by itself, as their inner loop is short; the operations and
 * their order are those of the plain loop. */
typedef double Four __attribute__((vector_size(LANES * sizeof(double))));

RkRow rk_make_row(const TinkerTableau *tableau, const double *weights)
{
    RkRow row = {0};
    int stages = tableau->stages + 1 + tableau->extra_stages;
    for (int j = 0; j < stages; j++) {
        double q = 0.0;
        for (int k = j + 1; k < stages; k++) /* no stage is made of itself or later ones */
            q += weights[k] * tableau->a[k][j];
        if (fabs(q) < 1e-14) q = 0.0; /* a simplifying assumption of the method, up to rounding */
        if (q == 0.0 && weights[j] == 0.0) continue;
        row.stage[row.count] = j;
        row.weight[row.count++] = (RkPair){q, weights[j]};
    }
    return row;
}

/* From `first` on `fours` times four entries: with h^2 sum_j wq_j a_j and h sum_j wv_j a_j,
 * q_out = q + (drift v + sum), v_out = v + sum. */
static inline __attribute__((always_inline)) void combine_fours(const RkStepper *stepper, const RkRow *row, double h,
                                                                const RkOnto *onto, int32_t first, const int fours)
{
    Four q_sum[FOURS] = {{0.0}}, v_sum[FOURS] = {{0.0}};
    for (int j = 0; j < row->count; j++) {
        const double *each = stepper->a[row->stage[j]] + first, of_q = row->weight[j][0], of_v = row->weight[j][1];
        for (int k = 0; k < fours; k++) {
            Four term;
            memcpy(&term, each + LANES * k, sizeof term);
            q_sum[k] += of_q * term;
            v_sum[k] += of_v * term;
        }
    }
    for (int k = 0; k < fours; k++, first += LANES) {
        Four q = (h * h) * q_sum[k], v = h * v_sum[k];
        if (onto->q != NULL) {
            Four from_q, from_v;
            memcpy(&from_q, onto->q + first, sizeof from_q);
            memcpy(&from_v, onto->v + first, sizeof from_v);
            q = from_q + (onto->drift * from_v + q);
            v = from_v + v;
        }
        memcpy(onto->q_out + first, &q, sizeof q);
        memcpy(onto->v_out + first, &v, sizeof v);
    }
}

/* The same of one entry, with both sums side by side. */
static inline __attribute__((always_inline)) void combine_one(const RkStepper *stepper, const RkRow *row, double h,
                                                              const RkOnto *onto, int32_t i)
{
    RkPair sum = {0.0, 0.0};
    for (int j = 0; j < row->count; j++) {
        double term = stepper->a[row->stage[j]][i];
        sum += row->weight[j] * (RkPair){term, term};
    }
    sum *= (RkPair){h * h, h};
    if (onto->q != NULL) sum = (RkPair){onto->q[i] + (onto->drift * onto->v[i] + sum[0]), onto->v[i] + sum[1]};
    onto->q_out[i] = sum[0];
    onto->v_out[i] = sum[1];
}

TINKER_VARIANTS void rk_combine(const RkStepper *stepper, const RkRow *row, double h, const RkOnto *onto)
{
    int32_t n = stepper->system->size, i = 0;
    for (; i + FOURS * LANES <= n; i += FOURS * LANES)
        combine_fours(stepper, row, h, onto, i, FOURS);
    for (; i + LANES <= n; i += LANES)
        combine_fours(stepper, row, h, onto, i, 1);
    for (; i < n; i++)
        combine_one(stepper, row, h, onto, i);
}

void rk_sum_powers(const RkStepper *stepper, int stages, const double *weights, double h, const double *from,
                   double *books)
{
    for (int32_t i = 0; i < stepper->system->books; i++) {
        double sum = 0.0;
        for (int j = 0; j < stages; j++)
            if (weights[j] != 0.0) sum += weights[j] * stepper->power[j][i];
        books[i] = from[i] + h * sum;
    }
}

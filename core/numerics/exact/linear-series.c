/* The state a short time ahead, by the series of the exponential on one vector:
 *
 *     exp(A h) z - z = sum_k (A h)^k z / k!
 *
 * A product with A for each term in place of the matrix itself. Source: A. H. Al-Mohy, N. J. Higham, "Computing the
 * action of the matrix exponential", SIAM J. Sci. Comput. 33 (2011) 488-511, (3.10), without its steps: the time is
 * short. */
#include <math.h>
#include <string.h>

#include "numerics/exact/linear-response.h"

#define ROUNDING 0x1p-56 /* of the vector: terms below it are left out */
/* A polynomial input reaches the state with so many terms' delay, whatever its rate. */
#define POLYNOMIAL_TERMS 4

/* out = h A x. */
static void times_vector(const TinkerLinearOscillators *o, double h, const double *restrict x, double *restrict out)
{
    int32_t n = o->size;
    const double *speed = x + n, *r = x + 2 * n;
    for (int32_t i = 0; i < n; i++) {
        double pull = o->omega[i] * x[i], push = 0.0;
        for (int32_t j = 0; j < n; j++)
            pull += o->damping[(gsize)i * n + j] * speed[j];
        for (int32_t k = 0; k < o->entries; k++)
            push += o->drive[(gsize)i * o->entries + k] * r[k];
        out[i] = h * (tinker_linear_scale(o->omega[i]) * speed[i]);
        out[n + i] = h * (push - pull);
    }
    for (int32_t b = 0; b < o->input_count; b++) {
        const TinkerLinearInput *input = &o->inputs[b];
        const double *from = r + input->first;
        double *to = out + 2 * n + input->first;
        for (int32_t k = 0; k < input->count; k++)
            to[k] = input->count == 4 && k < 3 ? h * from[k + 1] : 0.0;
        if (input->count != 2) continue;
        to[0] = h * (input->rate * from[1]);
        to[1] = -h * (input->rate * from[0]);
    }
}

void tinker_linear_series(const TinkerLinearOscillators *o, double rate, double h, const double *z, double *change,
                          double *work)
{
    int32_t n = 2 * o->size;
    gsize d = (gsize)(n + o->entries);
    double *term = work, *next = work + d, size = 1.0;
    int32_t left = POLYNOMIAL_TERMS;
    memcpy(term, z, d * sizeof *term);
    memset(change, 0, (gsize)n * sizeof *change);
    for (int32_t k = 1; size > ROUNDING || left-- > 0; k++) {
        times_vector(o, h / k, term, next);
        for (int32_t i = 0; i < n; i++)
            change[i] += next[i];
        double *kept = term;
        term = next;
        next = kept;
        size *= fmax(rate * fabs(h), 0x1p-10) / k;
    }
}

/* The augmented exponential by a series over a short time and doublings: with F = exp(A h) - I
 *
 *     F <- 2F + F F,    W <- W + E^T W E,    P <- P + (exp(N h))^T P E,    E = I + F
 *
 * for the state, the integrals of quadratic forms and the moments with the inputs. F itself, not I + F, is
 * carried, so that slow motion keeps its digits beside fast (N. J. Higham, Functions of Matrices, SIAM 2008,
 * 10.6.2 and 10.7.4). The series of W is that of the Lyapunov operator: W = sum h^(k+1) / (k+1)! L^k(W0), L(X) =
 * A^T X + X A; that of P likewise. What has a closed form, a single oscillator and the inputs, is put in anew at
 * every doubling.
 */
#include "numerics/exact/linear-response.h"

#include <math.h>
#include <string.h>

#include "numerics/exact/linear-dense.h"

#define SERIES_TERMS   16
#define SERIES_REACH   0.5 /* rate * h that the series is used up to */
#define MOST_DOUBLINGS 1000

static int32_t dimension(const TinkerLinearOscillators *o)
{
    return 2 * o->size + o->entries;
}

static int32_t largest(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

int32_t tinker_linear_moment_rows(const TinkerLinearOscillators *o)
{
    int32_t rows = 0;
    for (int32_t i = 0; i < o->moment_count; i++)
        rows += o->inputs[o->moments[i].input].count;
    return rows;
}

gsize tinker_linear_response_work(const TinkerLinearOscillators *o)
{
    gsize d = (gsize)dimension(o), rows = (gsize)largest((int32_t)d, tinker_linear_moment_rows(o));
    return 2 * rows * d;
}

double tinker_linear_rate(const TinkerLinearOscillators *o)
{
    double rate = 0.0;
    for (int32_t i = 0; i < o->size; i++) {
        double row = o->omega[i];
        for (int32_t j = 0; j < o->size; j++)
            row += fabs(o->damping[(gsize)i * o->size + j]);
        rate = fmax(rate, row);
    }
    for (int32_t i = 0; i < o->input_count; i++)
        if (o->inputs[i].count == 2) rate = fmax(rate, fabs(o->inputs[i].rate));
    return rate;
}

int32_t tinker_linear_doublings(double rate, double h)
{
    double ratio = rate * fabs(h) / SERIES_REACH;
    return ratio > 1.0 ? (int32_t)ceil(fmin(log2(ratio), MOST_DOUBLINGS + 1.0)) : 0;
}

void tinker_linear_input_gain(const TinkerLinearInput *input, double h, double *gain)
{
    if (input->count == 1) {
        gain[0] = 0.0;
    } else if (input->count == 2) {
        double half = sin(0.5 * input->rate * h), sine = sin(input->rate * h);
        gain[0] = gain[3] = -2.0 * half * half;
        gain[1] = sine;
        gain[2] = -sine;
    } else {
        double taylor[4] = {0.0, h, h * h / 2.0, h * h * h / 6.0};
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++)
                gain[4 * i + j] = j > i ? taylor[j - i] : 0.0;
    }
}

/* x N, added to `out`, for the entries' columns of `rows` rows. */
static void times_inputs(const TinkerLinearOscillators *o, int32_t rows, const double *x, double *out)
{
    int32_t d = dimension(o);
    for (int32_t b = 0; b < o->input_count; b++) {
        const TinkerLinearInput *input = &o->inputs[b];
        int32_t at = 2 * o->size + input->first;
        for (int32_t i = 0; i < rows; i++) {
            const double *from = x + (gsize)i * d + at;
            double *to = out + (gsize)i * d + at;
            if (input->count == 2) {
                to[0] -= input->rate * from[1];
                to[1] += input->rate * from[0];
            }
            for (int32_t k = 1; input->count == 4 && k < 4; k++)
                to[k] += from[k - 1];
        }
    }
}

/* out = x A. */
static void times_system(const TinkerLinearOscillators *o, int32_t rows, const double *x, double *out)
{
    int32_t n = o->size, d = dimension(o);
    TinkerDense velocities = tinker_dense(x + n, d);
    tinker_dense_multiply(rows, n, n, velocities, tinker_dense(o->damping, n), out + n, d, 0);
    if (o->entries > 0)
        tinker_dense_multiply(rows, n, o->entries, velocities, tinker_dense(o->drive, o->entries), out + 2 * n, d, 0);
    for (int32_t i = 0; i < rows; i++) {
        const double *from = x + (gsize)i * d;
        double *to = out + (gsize)i * d;
        for (int32_t j = 0; j < n; j++) {
            to[j] = -o->omega[j] * from[n + j];
            to[n + j] = tinker_linear_scale(o->omega[j]) * from[j] - to[n + j];
        }
    }
    times_inputs(o, rows, x, out);
}

static void scale_all(gsize count, double factor, double *restrict x)
{
    for (gsize i = 0; i < count; i++)
        x[i] *= factor;
}

static void put_closed_forms(const TinkerLinearOscillators *o, double h, double *f)
{
    int32_t n = o->size, d = dimension(o);
    if (n == 1) {
        double propagator[4];
        tinker_linear_oscillator(o->omega[0], o->damping[0], h, propagator);
        f[0] = propagator[0];
        f[1] = propagator[1];
        f[d] = propagator[2];
        f[d + 1] = propagator[3];
    }
    for (int32_t b = 0; b < o->input_count; b++) {
        double gain[16];
        int32_t count = o->inputs[b].count, at = 2 * n + o->inputs[b].first;
        tinker_linear_input_gain(&o->inputs[b], h, gain);
        for (int32_t i = 0; i < count; i++)
            for (int32_t j = 0; j < count; j++)
                f[(gsize)(at + i) * d + at + j] = gain[i * count + j];
    }
}

/* F <- h/k (I + F) A, from the last term to the first. */
static void begin_propagator(const TinkerLinearOscillators *o, double h, double *f, double *work)
{
    int32_t d = dimension(o);
    gsize count = (gsize)d * (gsize)d;
    memset(f, 0, count * sizeof *f);
    for (int32_t k = SERIES_TERMS; k > 0; k--) {
        for (int32_t i = 0; i < d; i++)
            f[(gsize)i * d + i] += 1.0;
        times_system(o, d, f, work);
        scale_all(count, h / k, work);
        memcpy(f, work, count * sizeof *f);
    }
    put_closed_forms(o, h, f);
}

/* Sums the terms of W: term <- (A^T term + term A) h / (k + 1). */
static void begin_form(const TinkerLinearOscillators *o, const double *form, double h, double *w, double *work)
{
    int32_t n = o->size, d = dimension(o);
    gsize count = (gsize)d * (gsize)d;
    double *term = work, *product = work + count;
    memset(term, 0, count * sizeof *term);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            term[(gsize)(n + i) * d + n + j] = h * form[(gsize)i * n + j];
    memcpy(w, term, count * sizeof *w);
    for (int32_t k = 1; k <= SERIES_TERMS; k++) {
        times_system(o, d, term, product);
        for (int32_t i = 0; i < d; i++) {
            for (int32_t j = 0; j < d; j++) {
                term[(gsize)i * d + j] = (product[(gsize)i * d + j] + product[(gsize)j * d + i]) * (h / (k + 1));
                w[(gsize)i * d + j] += term[(gsize)i * d + j];
            }
        }
    }
}

/* Adds N^T term to `out`, input by input. */
static void inputs_times(const TinkerLinearOscillators *o, const double *term, double *out)
{
    int32_t d = dimension(o), row = 0;
    for (int32_t m = 0; m < o->moment_count; m++) {
        const TinkerLinearInput *input = &o->inputs[o->moments[m].input];
        for (int32_t j = 0; j < d; j++) {
            const double *from = term + (gsize)row * d + j;
            double *to = out + (gsize)row * d + j;
            if (input->count == 2) {
                to[0] -= input->rate * from[d];
                to[d] += input->rate * from[0];
            }
            for (int32_t k = 1; input->count == 4 && k < 4; k++)
                to[(gsize)k * d] += from[(gsize)(k - 1) * d];
        }
        row += input->count;
    }
}

static void begin_moments(const TinkerLinearOscillators *o, double h, double *p, double *work)
{
    int32_t n = o->size, d = dimension(o), rows = tinker_linear_moment_rows(o), row = 0;
    gsize count = (gsize)rows * (gsize)d;
    double *term = work, *product = work + count;
    memset(term, 0, count * sizeof *term);
    for (int32_t m = 0; m < o->moment_count; m++) {
        for (int32_t j = 0; j < n; j++)
            term[(gsize)row * d + n + j] = h * o->moments[m].direction[j];
        row += o->inputs[o->moments[m].input].count;
    }
    memcpy(p, term, count * sizeof *p);
    for (int32_t k = 1; k <= SERIES_TERMS; k++) {
        times_system(o, rows, term, product);
        inputs_times(o, term, product);
        for (gsize i = 0; i < count; i++) {
            term[i] = product[i] * (h / (k + 1));
            p[i] += term[i];
        }
    }
}

/* W <- W + E^T W E, with E^T X = X + F^T X. */
static void double_form(int32_t d, const double *f, double *w, double *work)
{
    gsize count = (gsize)d * (gsize)d;
    memcpy(work, w, count * sizeof *work);
    tinker_dense_multiply(d, d, d, tinker_dense(w, d), tinker_dense(f, d), work, d, 1);
    for (gsize i = 0; i < count; i++)
        w[i] += work[i];
    tinker_dense_multiply(d, d, d, tinker_dense_transposed(f, d), tinker_dense(work, d), w, d, 1);
}

static void double_moments(const TinkerLinearOscillators *o, double h, const double *f, double *p, double *work)
{
    int32_t d = dimension(o), rows = tinker_linear_moment_rows(o), row = 0;
    memcpy(work, p, (gsize)rows * (gsize)d * sizeof *work);
    tinker_dense_multiply(rows, d, d, tinker_dense(p, d), tinker_dense(f, d), work, d, 1);
    for (int32_t m = 0; m < o->moment_count; m++) {
        const TinkerLinearInput *input = &o->inputs[o->moments[m].input];
        double gain[16];
        int32_t count = input->count;
        tinker_linear_input_gain(input, h, gain);
        double *to = p + (gsize)row * d, *from = work + (gsize)row * d;
        for (gsize i = 0; i < (gsize)count * (gsize)d; i++)
            to[i] += from[i];
        tinker_dense_multiply(count, count, d, tinker_dense_transposed(gain, count), tinker_dense(from, d), to, d, 1);
        row += count;
    }
}

static void double_propagator(int32_t d, double *f, double *work)
{
    gsize count = (gsize)d * (gsize)d;
    tinker_dense_multiply(d, d, d, tinker_dense(f, d), tinker_dense(f, d), work, d, 0);
    for (gsize i = 0; i < count; i++)
        f[i] = 2.0 * f[i] + work[i];
}

gboolean tinker_linear_response(const TinkerLinearOscillators *o, double rate, double h, double *propagator,
                                double *const *forms, double *moments, double *work)
{
    int32_t d = dimension(o), doublings = tinker_linear_doublings(rate, h);
    if (doublings > MOST_DOUBLINGS) return FALSE;
    double part = ldexp(h, -doublings);
    begin_propagator(o, part, propagator, work);
    for (int32_t i = 0; i < o->form_count; i++)
        begin_form(o, o->forms[i], part, forms[i], work);
    if (o->moment_count > 0) begin_moments(o, part, moments, work);
    for (int32_t k = 0; k < doublings; k++) {
        for (int32_t i = 0; i < o->form_count; i++)
            double_form(d, propagator, forms[i], work);
        if (o->moment_count > 0) double_moments(o, part, propagator, moments, work);
        double_propagator(d, propagator, work);
        part *= 2.0;
        put_closed_forms(o, part, propagator);
    }
    return TRUE;
}

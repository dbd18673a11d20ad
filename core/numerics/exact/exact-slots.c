/* Propagators by the length of the step: worked out where a length is new, found again where it is not. */
#include <math.h>
#include <string.h>

#include "numerics/exact/exact-private.h"
#include "numerics/exact/linear-dense.h"

#define SERIES_TERMS 16

static gsize dimension(const TinkerExactPart *part)
{
    return part->coupled ? 2 * (gsize)part->n + (gsize)part->entries : 2 + (gsize)part->entries;
}

static TinkerLinearOscillators coupled_oscillators(const TinkerExactPart *part, gboolean with_books)
{
    TinkerLinearOscillators o = {.size = part->n,
                                 .input_count = part->input_count,
                                 .entries = part->entries,
                                 .omega = part->omega,
                                 .damping = part->decay,
                                 .drive = part->drive,
                                 .inputs = part->inputs,
                                 .moments = part->moments};
    if (with_books) {
        o.form_count = 2;
        o.forms[0] = part->damping[0];
        o.forms[1] = part->damping[1];
        o.moment_count = part->power_count;
    }
    return o;
}

static TinkerLinearOscillators single_oscillator(const TinkerExactPart *part, int32_t j, gboolean with_books)
{
    TinkerLinearOscillators o = {.size = 1,
                                 .input_count = part->input_count,
                                 .entries = part->entries,
                                 .omega = part->omega + j,
                                 .damping = part->decay + j,
                                 .drive = part->drive,
                                 .inputs = part->inputs,
                                 .moments = part->moments};
    if (with_books) {
        o.form_count = 1;
        o.forms[0] = part->unit;
        o.moment_count = part->input_count;
    }
    return o;
}

static gsize moment_doubles(const TinkerExactPart *part)
{
    if (!part->coupled) return (gsize)part->n * (gsize)part->entries * dimension(part);
    TinkerLinearOscillators o = coupled_oscillators(part, TRUE);
    return (gsize)tinker_linear_moment_rows(&o) * dimension(part);
}

static gsize work_doubles(const TinkerExactPart *part)
{
    gsize d = dimension(part), gram = 2 * (gsize)part->basis_entries * (gsize)part->basis_entries;
    TinkerLinearOscillators o =
        part->coupled ? coupled_oscillators(part, part->booked) : single_oscillator(part, 0, part->booked);
    return MAX(gram, d * d + tinker_linear_response_work(&o));
}

gsize tinker_exact_slot_doubles(const TinkerExactPart *part)
{
    gsize n = (gsize)part->n, d = dimension(part), entries = (gsize)part->entries;
    gsize doubles = part->coupled ? d * d : (4 + 2 * entries) * n;
    if (!part->booked) return doubles;
    gsize forms = part->coupled ? 2 * d * d : n * d * d, basis = (gsize)part->basis_entries;
    return doubles + forms + moment_doubles(part) + basis * basis;
}

gboolean tinker_exact_slots_prepare(TinkerExactPart *part)
{
    gsize needed = work_doubles(part);
    if (needed > part->work_size) {
        g_free(part->work);
        part->work = g_try_malloc_n(needed, sizeof(double));
        part->work_size = part->work ? needed : 0;
    }
    if (!part->work) return FALSE;
    gsize each = tinker_exact_slot_doubles(part), d = dimension(part), n = (gsize)part->n;
    for (int32_t i = 0; i < part->slot_count; i++) {
        TinkerExactSlot *slot = &part->slots[i];
        *slot = (TinkerExactSlot){.propagator = part->slot_memory + (gsize)i * each};
        slot->response = slot->propagator + 4 * n;
        slot->forms = slot->propagator + (part->coupled ? d * d : (4 + 2 * (gsize)part->entries) * n);
        slot->moments = slot->forms + (part->coupled ? 2 : n) * d * d;
        slot->gram = slot->moments + moment_doubles(part);
    }
    part->rate = 0.0;
    for (int32_t j = 0; j < part->n; j++) {
        TinkerLinearOscillators o =
            part->coupled ? coupled_oscillators(part, FALSE) : single_oscillator(part, j, FALSE);
        part->rate = fmax(part->rate, tinker_linear_rate(&o));
        if (part->coupled) break;
    }
    return TRUE;
}

/* Adds N^T x N-wise: out = N^T x + x N for the inputs' functions; x is symmetric. */
static void step_gram(const TinkerExactPart *part, const double *x, double *out)
{
    gsize b = (gsize)part->basis_entries;
    memset(out, 0, b * b * sizeof *out);
    for (int32_t k = 0; k < part->basis_count; k++) {
        const TinkerLinearInput *input = &part->basis[k];
        gsize at = (gsize)input->first;
        for (gsize i = 0; i < b; i++) {
            if (input->count == 2) {
                out[i * b + at] -= input->rate * x[i * b + at + 1];
                out[i * b + at + 1] += input->rate * x[i * b + at];
            }
            for (gsize r = 1; input->count == 4 && r < 4; r++)
                out[i * b + at + r] += x[i * b + at + r - 1];
        }
    }
    for (gsize i = 0; i < b; i++) {
        for (gsize j = 0; j <= i; j++) {
            double sum = out[i * b + j] + out[j * b + i];
            out[i * b + j] = out[j * b + i] = sum;
        }
    }
}

/* x <- x + S^T x S, S = exp(N h), input pair by input pair. */
static void double_gram(const TinkerExactPart *part, double h, double *x, double *shifted)
{
    gsize b = (gsize)part->basis_entries;
    for (int pass = 0; pass < 2; pass++) {
        const double *from = pass == 0 ? x : shifted;
        double *to = pass == 0 ? shifted : shifted + b * b;
        memcpy(to, from, b * b * sizeof *to);
        for (int32_t k = 0; k < part->basis_count; k++) {
            double gain[16];
            int32_t count = part->basis[k].count;
            gsize at = (gsize)part->basis[k].first;
            tinker_linear_input_gain(&part->basis[k], h, gain);
            if (pass == 0)
                tinker_dense_multiply((int32_t)b, count, count, tinker_dense(from + at, (int32_t)b),
                                      tinker_dense(gain, count), to + at, (int32_t)b, 1);
            else
                tinker_dense_multiply(count, count, (int32_t)b, tinker_dense_transposed(gain, count),
                                      tinker_dense(from + at * b, (int32_t)b), to + at * b, (int32_t)b, 1);
        }
    }
    for (gsize i = 0; i < b * b; i++)
        x[i] += shifted[b * b + i];
}

/* Integrals over h of the products of the inputs' functions, by the same series and doublings as the propagator. */
static void build_gram(TinkerExactPart *part, double h, double *gram)
{
    gsize b = (gsize)part->basis_entries;
    double rate = 0.0, *term = part->work, *next = term + b * b;
    for (int32_t k = 0; k < part->basis_count; k++)
        rate = fmax(rate, fabs(part->basis[k].rate));
    int32_t doublings = tinker_linear_doublings(rate, h);
    double length = ldexp(h, -doublings);
    memset(term, 0, b * b * sizeof *term);
    for (int32_t k = 0; k < part->basis_count; k++)
        for (int32_t l = 0; l < part->basis_count; l++)
            term[(gsize)part->basis[k].first * b + (gsize)part->basis[l].first] = length;
    memcpy(gram, term, b * b * sizeof *gram);
    for (int32_t k = 1; k <= SERIES_TERMS; k++) {
        step_gram(part, term, next);
        for (gsize i = 0; i < b * b; i++) {
            term[i] = next[i] * (length / (k + 1));
            gram[i] += term[i];
        }
    }
    for (int32_t k = 0; k < doublings; k++, length *= 2.0)
        double_gram(part, length, gram, part->work);
}

/* Mode by mode; a mode that only a constant pushes, in closed form. */
static gboolean build_mode(TinkerExactPart *part, int32_t j, double h, gboolean with_books, TinkerExactSlot *slot)
{
    gsize n = (gsize)part->n, d = dimension(part), entries = (gsize)part->entries;
    double closed[4], push[2], *whole = part->work;
    tinker_linear_oscillator(part->omega[j], part->decay[j], h, closed);
    tinker_linear_push(part->omega[j], part->decay[j], h, closed, push);
    for (int k = 0; k < 4; k++)
        slot->propagator[(gsize)k * n + j] = closed[k];
    if (entries > 1 || with_books) {
        TinkerLinearOscillators o = single_oscillator(part, j, with_books);
        double *forms[1] = {slot->forms + (gsize)j * d * d};
        double *moments = slot->moments + (gsize)j * entries * d;
        if (!tinker_linear_response(&o, tinker_linear_rate(&o), h, whole, forms, moments, whole + d * d)) return FALSE;
        for (gsize row = 0; row < 2; row++)
            for (gsize r = 0; r < entries; r++)
                slot->response[(row * entries + r) * n + j] = whole[row * d + 2 + r];
    }
    slot->response[j] = push[0];
    slot->response[entries * n + j] = push[1];
    return TRUE;
}

static gboolean build(TinkerExactPart *part, double h, gboolean with_books, TinkerExactSlot *slot)
{
    slot->h = 0.0;
    slot->with_books = with_books;
    if (part->coupled) {
        gsize d = dimension(part);
        double *forms[2] = {slot->forms, slot->forms + d * d};
        TinkerLinearOscillators o = coupled_oscillators(part, with_books);
        if (!tinker_linear_response(&o, part->rate, h, slot->propagator, forms, slot->moments, part->work))
            return FALSE;
    } else {
        for (int32_t j = 0; j < part->n; j++)
            if (!build_mode(part, j, h, with_books, slot)) return FALSE;
    }
    if (with_books && part->move_count > 0) build_gram(part, h, slot->gram);
    slot->h = h;
    return TRUE;
}

void tinker_exact_part_series(TinkerExactPart *part, double h, const double *z, const double *inputs, double *to)
{
    gsize n = (gsize)part->n, entries = (gsize)part->entries;
    if (part->coupled) {
        TinkerLinearOscillators o = coupled_oscillators(part, FALSE);
        tinker_linear_series(&o, part->rate, h, z, to, part->work);
        return;
    }
    double *vector = part->work, *change = vector + 2 + entries, *work = change + 2;
    for (gsize j = 0; j < n; j++) {
        TinkerLinearOscillators o = single_oscillator(part, (int32_t)j, FALSE);
        vector[0] = z[j];
        vector[1] = z[n + j];
        for (gsize r = 0; r < entries; r++)
            vector[2 + r] = inputs[r * n + j];
        tinker_linear_series(&o, part->rate, h, vector, change, work);
        to[j] = change[0];
        to[n + j] = change[1];
    }
}

const TinkerExactSlot *tinker_exact_slot(TinkerExactPart *part, double h, double tolerance, gboolean scratch,
                                         gboolean with_books)
{
    int32_t first = scratch ? part->step_slots : 0, end = scratch ? part->slot_count : part->step_slots;
    TinkerExactSlot *oldest = &part->slots[first], *nearest = NULL;
    for (int32_t i = first; i < end; i++) {
        TinkerExactSlot *slot = &part->slots[i];
        gboolean usable = slot->h != 0.0 && fabs(slot->h - h) <= tolerance && (slot->with_books || !with_books);
        if (usable && (!nearest || fabs(slot->h - h) < fabs(nearest->h - h))) nearest = slot;
        if (slot->used < oldest->used) oldest = slot;
    }
    if (!nearest) {
        if (!build(part, h, with_books, oldest)) return NULL;
        nearest = oldest;
    }
    nearest->used = ++part->clock;
    return nearest;
}

/* Equally spaced samples in bulk. A part that nothing but constants drives goes mode by mode, eight samples at a
 * time from one state, which the compiler turns into vectors; anything else is stepped. */
#include "numerics/exact/exact.h"

#include <math.h>
#include <string.h>

#include "numerics/exact/exact-private.h"
#include "numerics/exact/linear-dense.h"
#include "numerics/integrate/stepping.h"

#define LANES 8
#define BLOCK 256 /* samples that stay in the cache */

typedef struct {
    double f[4][LANES]; /* of 1 to LANES steps: F00, F01, F10, F11 */
} Lanes;

static void find_lanes(const TinkerExactPart *part, int32_t j, double dt, Lanes *lanes)
{
    for (int k = 0; k < LANES; k++) {
        double f[4];
        tinker_linear_oscillator(part->omega[j], part->decay[j], (k + 1) * dt, f);
        for (int i = 0; i < 4; i++)
            lanes->f[i][k] = f[i];
    }
}

/* `count` states after (y, w), which move on to the last of them; `count` is a multiple of LANES. */
TINKER_VARIANTS
static void run_lanes(const Lanes *restrict lanes, int32_t count, double *state, double *restrict ys,
                      double *restrict ws)
{
    double y = state[0], w = state[1], f[4];
    for (int i = 0; i < 4; i++)
        f[i] = lanes->f[i][LANES - 1];
    for (int32_t i = 0; i < count; i += LANES) {
        for (int k = 0; k < LANES; k++) {
            ys[i + k] = y + (lanes->f[0][k] * y + lanes->f[1][k] * w);
            ws[i + k] = w + (lanes->f[2][k] * y + lanes->f[3][k] * w);
        }
        double next = y + (f[0] * y + f[1] * w);
        w = w + (f[2] * y + f[3] * w);
        y = next;
    }
    state[0] = y;
    state[1] = w;
}

/* Where nothing drives the part but constants on modes with stiffness: those only shift what the modes move about. */
static gboolean is_plain(const TinkerExactPart *part)
{
    if (part->coupled || part->signal_count > 0) return FALSE;
    for (int32_t j = 0; j < part->n; j++)
        if (part->omega[j] == 0.0 && part->push[j] != 0.0) return FALSE;
    return TRUE;
}

typedef struct {
    Lanes *lanes;                   /* n */
    double *ys, *ws;                /* n x BLOCK */
    double *places, *speeds, *rest; /* n x BLOCK, n x BLOCK, n */
} Bulk;

static void run_block(const TinkerExactPart *part, Bulk *bulk, double *z, int32_t count)
{
    int32_t n = part->n, lanes = (count + LANES - 1) / LANES * LANES;
    for (int32_t j = 0; j < n; j++) {
        double state[2] = {z[j], z[n + j]}, *ys = bulk->ys + (gsize)j * BLOCK;
        run_lanes(&bulk->lanes[j], lanes, state, ys, bulk->ws + (gsize)j * BLOCK);
        z[j] = state[0];
        z[n + j] = state[1];
        double to_place = 1.0 / tinker_linear_scale(part->omega[j]);
        for (int32_t k = 0; k < count; k++)
            ys[k] *= to_place;
    }
    TinkerDense shape = tinker_dense(part->shape, n);
    tinker_dense_multiply(n, n, count, shape, tinker_dense(bulk->ys, BLOCK), bulk->places, BLOCK, 0);
    tinker_dense_multiply(n, n, count, shape, tinker_dense(bulk->ws, BLOCK), bulk->speeds, BLOCK, 0);
}

static void scatter(const TinkerExactPart *part, const Bulk *bulk, int32_t count, double *x, double *u)
{
    gsize size = (gsize)part->linear->size;
    for (int32_t i = 0; i < part->n; i++) {
        const double *restrict place = bulk->places + (gsize)i * BLOCK, *restrict speed =
                                                                            bulk->speeds + (gsize)i * BLOCK;
        double centre = bulk->rest[i], *restrict to = x + part->coordinates[i],
               *restrict rate = u + part->coordinates[i];
        for (int32_t k = 0; k < count; k++) {
            to[(gsize)k * size] = centre + place[k];
            rate[(gsize)k * size] = speed[k];
        }
    }
}

static gboolean run_plain(TinkerExactPart *part, double dt, gint64 count, double *x, double *u)
{
    gsize n = (gsize)part->n, size = (gsize)part->linear->size;
    g_autofree double *memory = g_try_malloc0_n(4 * n * BLOCK + 2 * n, sizeof(double));
    g_autofree Lanes *lanes = g_try_malloc_n(n, sizeof *lanes);
    if (!memory || !lanes) return FALSE;
    Bulk bulk = {
        lanes, memory, memory + n * BLOCK, memory + 2 * n * BLOCK, memory + 3 * n * BLOCK, memory + 4 * n * BLOCK};
    double *about = bulk.rest + n;
    for (gsize j = 0; j < n; j++) {
        find_lanes(part, (int32_t)j, dt, &lanes[j]);
        double push = part->omega[j] > 0.0 ? part->push[j] / part->omega[j] : 0.0;
        part->z[j] -= push;
        about[j] = push / tinker_linear_scale(part->omega[j]);
    }
    tinker_dense_apply(part->n, part->n, part->shape, about, bulk.rest);
    for (gsize i = 0; i < n; i++)
        bulk.rest[i] += part->reference[i];
    for (gint64 done = 0; done < count; done += BLOCK) {
        int32_t block = (int32_t)MIN(count - done, BLOCK);
        run_block(part, &bulk, part->z, block);
        scatter(part, &bulk, block, x + (gsize)done * size, u + (gsize)done * size);
    }
    return TRUE;
}

static gboolean run_steps(TinkerExactPart *part, const TinkerSignal *signals, double t0, double dt, gint64 count,
                          double *x, double *u)
{
    gsize size = (gsize)part->linear->size, n = (gsize)part->n;
    const TinkerExactSlot *slot = tinker_exact_slot(part, dt, 0.0, FALSE, FALSE);
    if (!slot) return FALSE;
    for (gint64 k = 0; k < count; k++) {
        tinker_exact_part_values(part, signals, t0 + (double)k * dt, part->values);
        tinker_exact_part_drive(part, part->values);
        memcpy(part->from, part->z, 2 * n * sizeof *part->z);
        tinker_exact_part_advance(part, slot, part->from, part->z);
        tinker_exact_part_write(part, part->z, x + (gsize)k * size, u + (gsize)k * size);
    }
    return TRUE;
}

/* Samples 1 ... count of one part. */
static gint64 run_part(TinkerExactPart *part, const TinkerSignal *signals, double t0, const double *q, const double *v,
                       double dt, gint64 count, double *x, double *u)
{
    if (!tinker_exact_part_enter(part, signals)) return -1;
    tinker_exact_part_start(part, q, v, signals, t0);
    double whole = dt * (double)count, passing = tinker_exact_part_passing(part, signals, t0, whole);
    if (fabs(passing) < fabs(whole)) count = (gint64)floor(passing / dt);
    if (count == 0) return 0;
    if (is_plain(part)) return run_plain(part, dt, count, x, u) ? count : -1;
    return run_steps(part, signals, t0, dt, count, x, u) ? count : -1;
}

gint64 tinker_exact_samples(const TinkerSystem *system, double t0, const double *q, const double *v, double dt,
                            gint64 count, double *x, double *u)
{
    const TinkerLinearSystem *linear = system->linear;
    if (!linear || count <= 0) return 0;
    TinkerSystem bookless = *system;
    bookless.books = 0;
    g_autoptr(TinkerLinearParts) parts = tinker_linear_parts_new(linear);
    g_autofree TinkerSignal *signals = g_try_malloc0_n((gsize)MAX(linear->signal_count, 1), sizeof *signals);
    if (!signals) return 0;
    if (linear->signal_count > 0 && system->signals(system->context, signals) != TINKER_OK) return 0;
    gsize size = (gsize)linear->size;
    memcpy(x, q, size * sizeof *x);
    memcpy(u, v, size * sizeof *u);
    gint64 most = count - 1;
    for (int32_t k = 0; k < parts->count && most > 0; k++) {
        TinkerExactPart *part = tinker_exact_part_new(&bookless, parts, k);
        gint64 done = part ? run_part(part, signals, t0, q, v, dt, most, x + size, u + size) : -1;
        tinker_exact_part_free(part);
        if (done < 0) return 0;
        most = done;
    }
    return most + 1;
}

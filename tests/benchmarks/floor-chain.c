/* A chain in Cartesian coordinates. With d the vector along rod k and u the difference of its ends' velocities, the
 * multipliers (tension over length) solve the tridiagonal system
 *
 *   -d[k].d[k-1] m[k-1] + w[k] d[k].d[k] m[k] - d[k].d[k+1] m[k+1] = r[k],   w[0] = 1, else 2,
 *
 * with r = u.u, less g d_y for the first rod, for accelerations, d.u for the return of velocities and (d.d -
 * length^2)/2 for that of positions. Mass k then gets m[k+1] d[k+1] - m[k] d[k]. */
#include "floors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GRAVITY 9.81

typedef struct {
    double x, y;
} Vector;

struct FloorChain {
    int n;
    double length;
    Vector *start, *q, *v;               /* of each mass */
    Vector *qs, *vs, *a1, *a2, *a3, *a4; /* stages */
    Vector *d;                           /* along each rod; one more, 0 */
    double *m;                           /* multipliers; one more, 0 */
    double *factor, *inverse;
    Vector memory[];
};

FloorChain *floor_chain_new(int rods, const double *angles, double rod_length)
{
    size_t n = (size_t)rods;
    FloorChain *chain = calloc(1, sizeof *chain + 12 * (n + 2) * sizeof(Vector));
    Vector **const arrays[] = {&chain->start, &chain->q,  &chain->v,  &chain->qs, &chain->vs,
                               &chain->a1,    &chain->a2, &chain->a3, &chain->a4, &chain->d};
    Vector *next = chain->memory;
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++, next += n + 1)
        *arrays[i] = next;
    chain->m = (double *)next;
    chain->factor = chain->m + n + 1;
    chain->inverse = chain->factor + n + 1;
    chain->n = rods;
    chain->length = rod_length;
    Vector at = {0, 0};
    for (size_t i = 0; i < n; i++) {
        at = (Vector){at.x + rod_length * sin(angles[i]), at.y - rod_length * cos(angles[i])};
        chain->start[i] = at;
    }
    floor_chain_reset(chain);
    return chain;
}

void floor_chain_free(FloorChain *chain)
{
    free(chain);
}

void floor_chain_reset(FloorChain *chain)
{
    memcpy(chain->q, chain->start, (size_t)chain->n * sizeof(Vector));
    memset(chain->v, 0, (size_t)chain->n * sizeof(Vector));
}

static double dot(Vector a, Vector b)
{
    return a.x * b.x + a.y * b.y;
}

static void find_rods(FloorChain *chain, const Vector *q)
{
    Vector before = {0, 0};
    for (int k = 0; k < chain->n; k++) {
        chain->d[k] = (Vector){q[k].x - before.x, q[k].y - before.y};
        before = q[k];
    }
}

/* Factors the matrix and solves for the right-hand side in `m`, in one pass down and one up. */
static void solve(FloorChain *chain)
{
    const Vector *d = chain->d;
    double *m = chain->m, above = 0, multiplied = 0, known = 0;
    for (int k = 0; k < chain->n; k++) {
        double off = dot(d[k], d[k + 1]);
        double inverse = 1.0 / ((k > 0 ? 2.0 : 1.0) * dot(d[k], d[k]) - multiplied * above);
        chain->inverse[k] = inverse;
        known = (m[k] + above * known) * inverse;
        m[k] = known;
        multiplied = off * inverse;
        chain->factor[k] = multiplied;
        above = off;
    }
    for (int k = chain->n - 2; k >= 0; k--)
        m[k] += chain->factor[k] * m[k + 1];
}

/* Solves with the factor at hand; the d it is of may have changed since, by a step's error. */
static void solve_again(FloorChain *chain)
{
    double *m = chain->m;
    for (int k = 1; k < chain->n; k++)
        m[k] += chain->factor[k - 1] * m[k - 1];
    for (int k = 0; k < chain->n; k++)
        m[k] *= chain->inverse[k];
    for (int k = chain->n - 2; k >= 0; k--)
        m[k] += chain->factor[k] * m[k + 1];
}

static void add_impulses(const FloorChain *chain, Vector *to)
{
    const Vector *d = chain->d;
    const double *m = chain->m;
    for (int k = 0; k < chain->n; k++) {
        to[k].x += m[k + 1] * d[k + 1].x - m[k] * d[k].x;
        to[k].y += m[k + 1] * d[k + 1].y - m[k] * d[k].y;
    }
}

static void accelerations(FloorChain *chain, const Vector *q, const Vector *v, Vector *a)
{
    Vector before = {0, 0};
    find_rods(chain, q);
    for (int k = 0; k < chain->n; k++) {
        Vector u = {v[k].x - before.x, v[k].y - before.y};
        chain->m[k] = dot(u, u);
        a[k] = (Vector){0, -GRAVITY};
        before = v[k];
    }
    chain->m[0] -= GRAVITY * chain->d[0].y;
    solve(chain);
    add_impulses(chain, a);
}

/* Newton steps; the first with the last stage's factor, which is off by the stage's error alone. */
static void return_positions(FloorChain *chain)
{
    double square = chain->length * chain->length;
    for (int step = 0; step < 20; step++) {
        double worst = 0;
        find_rods(chain, chain->q);
        for (int k = 0; k < chain->n; k++) {
            chain->m[k] = 0.5 * (dot(chain->d[k], chain->d[k]) - square);
            worst = fmax(worst, fabs(chain->m[k]));
        }
        if (worst <= 1e-14 * square + 4e-15 * chain->length) return;
        if (step == 0)
            solve_again(chain);
        else
            solve(chain);
        add_impulses(chain, chain->q);
    }
}

static void return_velocities(FloorChain *chain)
{
    Vector before = {0, 0};
    for (int k = 0; k < chain->n; k++) {
        Vector u = {chain->v[k].x - before.x, chain->v[k].y - before.y};
        chain->m[k] = dot(chain->d[k], u);
        before = chain->v[k];
    }
    solve(chain);
    add_impulses(chain, chain->v);
}

static void stage(FloorChain *chain, double hv, double haa, double ha, const Vector *b, const Vector *a)
{
    const Vector *restrict q = chain->q, *restrict v = chain->v;
    Vector *restrict qs = chain->qs, *restrict vs = chain->vs;
    for (int k = 0; k < chain->n; k++) {
        qs[k] = (Vector){q[k].x + hv * v[k].x + haa * b[k].x, q[k].y + hv * v[k].y + haa * b[k].y};
        vs[k] = (Vector){v[k].x + ha * a[k].x, v[k].y + ha * a[k].y};
    }
}

static void advance(FloorChain *chain, double h)
{
    const Vector *restrict a1 = chain->a1, *restrict a2 = chain->a2, *restrict a3 = chain->a3, *restrict a4 = chain->a4;
    Vector *restrict q = chain->q, *restrict v = chain->v;
    for (int k = 0; k < chain->n; k++) {
        double x = a2[k].x + a3[k].x, y = a2[k].y + a3[k].y;
        q[k].x += h * v[k].x + h * h / 6.0 * (a1[k].x + x);
        q[k].y += h * v[k].y + h * h / 6.0 * (a1[k].y + y);
        v[k].x += h / 6.0 * (a1[k].x + 2.0 * x + a4[k].x);
        v[k].y += h / 6.0 * (a1[k].y + 2.0 * y + a4[k].y);
    }
}

void floor_chain_steps(FloorChain *chain, double h, long steps)
{
    for (long i = 0; i < steps; i++) {
        accelerations(chain, chain->q, chain->v, chain->a1);
        stage(chain, 0.5 * h, 0.0, 0.5 * h, chain->a1, chain->a1);
        accelerations(chain, chain->qs, chain->vs, chain->a2);
        stage(chain, 0.5 * h, 0.25 * h * h, 0.5 * h, chain->a1, chain->a2);
        accelerations(chain, chain->qs, chain->vs, chain->a3);
        stage(chain, h, 0.5 * h * h, h, chain->a2, chain->a3);
        accelerations(chain, chain->qs, chain->vs, chain->a4);
        advance(chain, h);
        return_positions(chain);
        return_velocities(chain);
    }
}

double floor_chain_error(const FloorChain *chain)
{
    Vector before = {0, 0};
    double worst = 0;
    for (int k = 0; k < chain->n; k++) {
        double length = hypot(chain->q[k].x - before.x, chain->q[k].y - before.y);
        worst = fmax(worst, fabs(length / chain->length - 1.0));
        before = chain->q[k];
    }
    return worst;
}

/* Hermite interpolation over a step. With s = (t - t0) / h the polynomials are written as a Taylor series about the
 * start plus what is left over at the end, so that no digits of a large q are lost. */
#include "numerics/integrate/hermite.h"

#include "numerics/integrate/stepping.h"

static void take_end(TinkerHermiteEnd *end, size_t n, size_t m, double **next)
{
    end->q = tinker_take(next, n);
    end->v = tinker_take(next, n);
    end->a = tinker_take(next, n);
    end->books = tinker_take(next, m);
    end->power = tinker_take(next, m);
}

static int same(int32_t count, const double *left, const double *right)
{
    return count == 0 || memcmp(left, right, (size_t)count * sizeof *left) == 0;
}

static void keep(const TinkerSystem *system, TinkerHermiteEnd *end, const TinkerState *state)
{
    end->t = state->t;
    tinker_copy(system->size, state->q, end->q);
    tinker_copy(system->size, state->v, end->v);
    tinker_copy(system->books, state->books, end->books);
    end->values_known = 1;
}

static TinkerStatus find_slopes(const TinkerSystem *system, TinkerHermiteEnd *end)
{
    if (end->slopes_known) return TINKER_OK;
    TinkerStatus status =
        system->acceleration(system->context, end->t, end->q, end->v, end->a, system->books > 0 ? end->power : NULL);
    end->slopes_known = status == TINKER_OK;
    return status;
}

/* rate may be NULL. */
static void quintic(const TinkerHermite *hermite, double h, double s, double *restrict q, double *restrict rate)
{
    const TinkerHermiteEnd *from = &hermite->from, *to = &hermite->to;
    double half_square = 0.5 * h * h, square = h * h;
    for (int32_t i = 0; i < hermite->system->size; i++) {
        double step = h * from->v[i], bend = half_square * from->a[i];
        double d = to->q[i] - from->q[i] - step - bend;
        double slope = h * (to->v[i] - from->v[i]) - square * from->a[i];
        double curve = half_square * (to->a[i] - from->a[i]);
        double c3 = 10.0 * d - 4.0 * slope + curve;
        double c4 = -15.0 * d + 7.0 * slope - 2.0 * curve;
        double c5 = 6.0 * d - 3.0 * slope + curve;
        q[i] = from->q[i] + s * (step + s * (bend + s * (c3 + s * (c4 + s * c5))));
        if (rate != NULL) rate[i] = from->v[i] + s / h * (2.0 * bend + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5)));
    }
}

static void cubic(int32_t count, double h, double s, const double *y0, const double *f0, const double *y1,
                  const double *f1, double *restrict y)
{
    for (int32_t i = 0; i < count; i++) {
        double step = h * f0[i], d = y1[i] - y0[i] - step, slope = h * (f1[i] - f0[i]);
        y[i] = y0[i] + s * (step + s * (3.0 * d - slope + s * (slope - 2.0 * d)));
    }
}

size_t tinker_hermite_doubles(int32_t n, int32_t m)
{
    return 6 * (size_t)n + 4 * (size_t)m;
}

void tinker_hermite_init(TinkerHermite *hermite, const TinkerSystem *system, double **next)
{
    hermite->system = system;
    take_end(&hermite->from, (size_t)system->size, (size_t)system->books, next);
    take_end(&hermite->to, (size_t)system->size, (size_t)system->books, next);
    tinker_hermite_forget(hermite);
}

void tinker_hermite_forget(TinkerHermite *hermite)
{
    hermite->from.values_known = hermite->from.slopes_known = 0;
    hermite->to.values_known = hermite->to.slopes_known = 0;
}

void tinker_hermite_start(TinkerHermite *hermite, const TinkerState *state)
{
    TinkerHermiteEnd *from = &hermite->from, *to = &hermite->to;
    int32_t n = hermite->system->size;
    from->slopes_known = to->slopes_known && to->t == state->t && same(n, to->q, state->q) && same(n, to->v, state->v);
    if (from->slopes_known) {
        double *a = from->a, *power = from->power;
        from->a = to->a;
        from->power = to->power;
        to->a = a;
        to->power = power;
    }
    keep(hermite->system, from, state);
    to->values_known = to->slopes_known = 0;
}

void tinker_hermite_finish(TinkerHermite *hermite, const TinkerState *state)
{
    keep(hermite->system, &hermite->to, state);
    hermite->to.slopes_known = 0;
}

void tinker_hermite_restore(const TinkerHermite *hermite, TinkerState *state)
{
    state->t = hermite->from.t;
    tinker_copy(hermite->system->size, hermite->from.q, state->q);
    tinker_copy(hermite->system->size, hermite->from.v, state->v);
    tinker_copy(hermite->system->books, hermite->from.books, state->books);
}

static TinkerStatus find_both_slopes(TinkerHermite *hermite)
{
    if (!hermite->from.values_known || !hermite->to.values_known) return TINKER_FAILED;
    TinkerStatus status = find_slopes(hermite->system, &hermite->from);
    return status == TINKER_OK ? find_slopes(hermite->system, &hermite->to) : status;
}

TinkerStatus tinker_hermite_interpolate(TinkerHermite *hermite, double t, double *q, double *v, double *books)
{
    const TinkerHermiteEnd *from = &hermite->from, *to = &hermite->to;
    TinkerStatus status = find_both_slopes(hermite);
    if (status != TINKER_OK) return status;
    double h = to->t - from->t, s = (t - from->t) / h;
    quintic(hermite, h, s, q, NULL);
    cubic(hermite->system->size, h, s, from->v, from->a, to->v, to->a, v);
    if (books) cubic(hermite->system->books, h, s, from->books, from->power, to->books, to->power, books);
    return TINKER_OK;
}

TinkerStatus tinker_hermite_place_and_rate(TinkerHermite *hermite, double t, double *q, double *rate)
{
    TinkerStatus status = find_both_slopes(hermite);
    if (status != TINKER_OK) return status;
    double h = hermite->to.t - hermite->from.t;
    quintic(hermite, h, (t - hermite->from.t) / h, q, rate);
    return TINKER_OK;
}

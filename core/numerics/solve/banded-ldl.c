/* Row by row: with G = L D, g_ij = a_ij - sum_k g_ik l_jk, l_ij = g_ij / d_j, d_i = a_ii - sum_k g_ik l_ik. */
#include "numerics/solve/banded-ldl.h"

#include <math.h>
#include <string.h>

void tinker_banded_ldl_init(TinkerBandedLdl *ldl, int32_t size, int32_t width)
{
    *ldl = (TinkerBandedLdl){
        .size = size,
        .width = width,
        .pivots = g_new0(double, MAX(size, 1)),
        .rows = g_new0(double, (gsize)size *(gsize)width + 1),
        .upper = width == 1 ? g_new0(double, MAX(size, 1)) : NULL,
    };
}

void tinker_banded_ldl_clear(TinkerBandedLdl *ldl)
{
    g_free(ldl->pivots);
    g_free(ldl->rows);
    g_free(ldl->upper);
    *ldl = (TinkerBandedLdl){0};
}

void tinker_banded_ldl_reset(TinkerBandedLdl *ldl)
{
    memset(ldl->pivots, 0, sizeof(double) * (gsize)ldl->size);
    memset(ldl->rows, 0, sizeof(double) * (gsize)ldl->size * (gsize)ldl->width);
}

static gboolean invert(double *pivot)
{
    *pivot = 1.0 / *pivot;
    return isfinite(*pivot) && *pivot != 0;
}

/* Row i: `rows` holds l_ik of the rows above. The product runs over the columns that both rows have. */
static gboolean factor_row(TinkerBandedLdl *ldl, int32_t i)
{
    int32_t w = ldl->width;
    double *row = ldl->rows + (gsize)i * (gsize)w, pivot = ldl->pivots[i];
    for (int32_t k = MAX(0, w - i); k < w; k++) {
        int32_t j = i - w + k;
        const double *above = ldl->rows + (gsize)j * (gsize)w;
        double sum = row[k];
        for (int32_t m = MAX(0, w - i); m < k; m++)
            sum -= row[m] * above[m + w - k];
        row[k] = sum;
    }
    for (int32_t k = MAX(0, w - i); k < w; k++) {
        double factor = row[k] * ldl->pivots[i - w + k];
        pivot -= row[k] * factor;
        row[k] = factor;
    }
    ldl->pivots[i] = pivot;
    return invert(&ldl->pivots[i]);
}

/* l_i = a_i,i-1 / d_i-1 from above to the middle, u_i = a_i,i+1 / d_i+1 from below. */
static gboolean factor_tridiagonal(TinkerBandedLdl *ldl)
{
    int32_t n = ldl->size, middle = n / 2;
    double *d = ldl->pivots, *lower = ldl->rows, *upper = ldl->upper;
    gboolean sound = TRUE;
    for (int32_t i = 0; i < middle; i++) {
        sound &= invert(&d[i]);
        double entry = lower[i + 1];
        lower[i + 1] = entry * d[i];
        d[i + 1] -= entry * lower[i + 1];
    }
    for (int32_t i = n - 1; i > middle; i--) {
        sound &= invert(&d[i]);
        upper[i - 1] = lower[i] * d[i];
        d[i - 1] -= lower[i] * upper[i - 1];
    }
    return (n == 0 || invert(&d[middle])) && sound;
}

gboolean tinker_banded_ldl_factor(TinkerBandedLdl *ldl)
{
    if (ldl->width == 1) return factor_tridiagonal(ldl);
    for (int32_t i = 0; i < ldl->size; i++)
        if (!factor_row(ldl, i)) return FALSE;
    return TRUE;
}

static void solve_tridiagonal(const TinkerBandedLdl *ldl, double *restrict x)
{
    int32_t n = ldl->size, middle = n / 2;
    const double *restrict inverse = ldl->pivots, *restrict lower = ldl->rows, *restrict upper = ldl->upper;
    if (n == 0) return;
    /* there are `middle` rows above the middle, and as many or one less below */
    int32_t below = n - 1 - middle;
    double first = 0, last = 0;
    for (int32_t i = 0; i < below; i++) {
        first = x[i] - lower[i] * first;
        last = x[n - 1 - i] - upper[n - 1 - i] * last;
        x[i] = first;
        x[n - 1 - i] = last;
    }
    for (int32_t i = below; i < middle; i++)
        x[i] = first = x[i] - lower[i] * first;
    x[middle] -= lower[middle] * first + upper[middle] * last;
    first = last = x[middle] * inverse[middle];
    x[middle] = first;
    for (int32_t i = 1; i <= below; i++) {
        first = x[middle - i] * inverse[middle - i] - lower[middle - i + 1] * first;
        last = x[middle + i] * inverse[middle + i] - upper[middle + i - 1] * last;
        x[middle - i] = first;
        x[middle + i] = last;
    }
    if (middle > below) x[0] = x[0] * inverse[0] - lower[1] * first;
}

/* What the `count` rows before row i, at most w, and those behind it take off x_i. */
static inline double behind(int32_t count, int32_t w, const double *restrict row, const double *restrict x)
{
    double sum = x[0];
    for (int32_t m = count; m > 0; m--)
        sum -= row[w - m] * x[-m];
    return sum;
}

static inline double ahead(int32_t count, int32_t w, const double *restrict row, const double *restrict x)
{
    double sum = x[0];
    for (int32_t m = count; m > 0; m--)
        sum -= row[m * w + w - m] * x[m];
    return sum;
}

/* Rows that have all their w neighbours are gone through with a number that the compiler may know. */
static inline void solve_band(int32_t n, int32_t w, const double *restrict rows, const double *restrict inverse,
                              double *restrict x)
{
    const int32_t edge = MIN(w, n);
    for (int32_t i = 0; i < edge; i++)
        x[i] = behind(i, w, rows + (gsize)i * (gsize)w, x + i);
    for (int32_t i = edge; i < n; i++)
        x[i] = behind(w, w, rows + (gsize)i * (gsize)w, x + i);
    for (int32_t i = 0; i < n; i++)
        x[i] *= inverse[i];
    for (int32_t i = n - 1; i >= n - edge; i--)
        x[i] = ahead(n - 1 - i, w, rows + (gsize)i * (gsize)w, x + i);
    for (int32_t i = n - edge - 1; i >= 0; i--)
        x[i] = ahead(w, w, rows + (gsize)i * (gsize)w, x + i);
}

void tinker_banded_ldl_solve(const TinkerBandedLdl *ldl, double *b)
{
    if (ldl->width == 1)
        solve_tridiagonal(ldl, b);
    else if (ldl->width == 3) /* a chain in the plane: the compiler unrolls it */
        solve_band(ldl->size, 3, ldl->rows, ldl->pivots, b);
    else
        solve_band(ldl->size, ldl->width, ldl->rows, ldl->pivots, b);
}

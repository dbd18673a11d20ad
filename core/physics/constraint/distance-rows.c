/* Rows that keep a distance between two points.
 *
 * With d = x_b - x_a, L = |d|, n = d / L and w = v_b - v_a:
 *     g = L - length,  J = dg/dx = (-n, n),  drift = (n x w)^2 / L,
 * derived in plugins/rod. 1 / L is worked out as L (1 / L^2), so that the division does not wait for the square root.
 *
 * On x86-64 two rows, or with AVX2 four, are worked out at once from packed points: a compiler turns points, which are
 * rows of four doubles each, into columns with twice the effort. All do the same operations in the same order, so they
 * give the same bits. Where some L^2 leaves the range of a double, all rows are done again, one by one. */
#include "physics/constraint/distance-rows.h"

#include <math.h>
#include <tinker/kernels.h>

/* Where the rows go. */
typedef struct {
    double *g, *jacobian, *drift;
} Results;

static void write_row(double *jacobian, double nx, double ny)
{
    jacobian[0] = -nx;
    jacobian[1] = -ny;
    jacobian[2] = nx;
    jacobian[3] = ny;
}

/* Answers whether L^2 is in range; else the row is to be done again. */
static inline gboolean one_row(const TinkerDistances *rows, const TinkerPoint *points, int32_t i, const Results *to)
{
    const TinkerPoint *a = &points[rows->ends[2 * i]], *b = &points[rows->ends[2 * i + 1]];
    double dx = b->x - a->x, dy = b->y - a->y, square = dx * dx + dy * dy;
    double distance = sqrt(square), inverse = distance * (1.0 / square);
    double nx = dx * inverse, ny = dy * inverse;
    double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
    to->g[i] = distance - rows->length[i];
    write_row(to->jacobian + 4 * (gsize)i, nx, ny);
    to->drift[i] = across * across * inverse;
    return square >= TINKER_LEAST_SQUARE && square <= TINKER_GREATEST_SQUARE;
}

/* One row that is immensely long or short. Where the ends coincide it has no direction, and can exert nothing; its g
 * says how wrong that is. */
static void row_out_of_range(const TinkerDistances *rows, const TinkerPoint *points, int32_t i, const Results *to)
{
    const TinkerPoint *a = &points[rows->ends[2 * i]], *b = &points[rows->ends[2 * i + 1]];
    double dx = b->x - a->x, dy = b->y - a->y, distance = hypot(dx, dy);
    double nx = distance == 0 ? 0.0 : dx / distance, ny = distance == 0 ? 0.0 : dy / distance;
    double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
    to->g[i] = distance - rows->length[i];
    write_row(to->jacobian + 4 * (gsize)i, nx, ny);
    to->drift[i] = distance == 0 ? 0.0 : across / distance * across;
}

static G_NO_INLINE gboolean rows_with_care(const TinkerDistances *rows, const TinkerPoint *points, const Results *to,
                                           double *miss)
{
    double zeros = 0;
    for (int32_t i = 0; i < rows->count; i++) {
        if (!one_row(rows, points, i, to)) row_out_of_range(rows, points, i, to);
        zeros += 0.0 * (to->g[i] + to->drift[i]); /* unless one is not finite */
        *miss = MAX(*miss, fabs(to->g[i]) * rows->inverse_scale[i]);
    }
    return zeros == 0;
}

#if defined(__x86_64__)
#include <immintrin.h>

/* What is asked about all rows, of two of them at a time. */
typedef struct {
    __m128d in_range, zeros, miss;
} Pair;

static inline __m128d magnitude(__m128d x)
{
    return _mm_andnot_pd(_mm_set1_pd(-0.0), x);
}

static inline void two_rows(const TinkerDistances *rows, const TinkerPoint *points, int32_t i, const Results *to,
                            Pair *all)
{
    const __m128d one = _mm_set1_pd(1.0), signs = _mm_set1_pd(-0.0);
    const int32_t *ends = rows->ends + 2 * (gsize)i;
    __m128d place[2], speed[2];
    for (int k = 0; k < 2; k++) {
        const TinkerPoint *a = &points[ends[2 * k]], *b = &points[ends[2 * k + 1]];
        place[k] = _mm_sub_pd(_mm_loadu_pd(&b->x), _mm_loadu_pd(&a->x));
        speed[k] = _mm_sub_pd(_mm_loadu_pd(&b->vx), _mm_loadu_pd(&a->vx));
    }
    const __m128d dx = _mm_unpacklo_pd(place[0], place[1]), dy = _mm_unpackhi_pd(place[0], place[1]);
    const __m128d du = _mm_unpacklo_pd(speed[0], speed[1]), dv = _mm_unpackhi_pd(speed[0], speed[1]);
    const __m128d square = _mm_add_pd(_mm_mul_pd(dx, dx), _mm_mul_pd(dy, dy));
    const __m128d distance = _mm_sqrt_pd(square), inverse = _mm_mul_pd(distance, _mm_div_pd(one, square));
    const __m128d nx = _mm_mul_pd(dx, inverse), ny = _mm_mul_pd(dy, inverse);
    const __m128d across = _mm_sub_pd(_mm_mul_pd(nx, dv), _mm_mul_pd(ny, du));
    const __m128d g = _mm_sub_pd(distance, _mm_loadu_pd(rows->length + i));
    const __m128d drift = _mm_mul_pd(_mm_mul_pd(across, across), inverse);
    const __m128d n[2] = {_mm_unpacklo_pd(nx, ny), _mm_unpackhi_pd(nx, ny)};
    for (int k = 0; k < 2; k++) {
        _mm_storeu_pd(to->jacobian + 4 * (gsize)(i + k), _mm_xor_pd(n[k], signs));
        _mm_storeu_pd(to->jacobian + 4 * (gsize)(i + k) + 2, n[k]);
    }
    _mm_storeu_pd(to->g + i, g);
    _mm_storeu_pd(to->drift + i, drift);
    const __m128d in_range = _mm_and_pd(_mm_cmpge_pd(square, _mm_set1_pd(TINKER_LEAST_SQUARE)),
                                        _mm_cmple_pd(square, _mm_set1_pd(TINKER_GREATEST_SQUARE)));
    all->in_range = _mm_and_pd(all->in_range, in_range);
    all->zeros = _mm_add_pd(all->zeros, _mm_mul_pd(_mm_setzero_pd(), _mm_add_pd(g, drift)));
    all->miss = _mm_max_pd(all->miss, _mm_mul_pd(magnitude(g), _mm_loadu_pd(rows->inverse_scale + i)));
}

/* Two rows or more. The last two overlap those before where need be: they come out the same. The loop has copies of
 * where things are, which no store into the results can change. */
static gboolean rows_by_twos(const TinkerDistances *rows, const TinkerPoint *points, const Results *to, double *miss)
{
    const TinkerDistances from = *rows;
    const Results into = *to;
    Pair all = {_mm_cmpeq_pd(_mm_setzero_pd(), _mm_setzero_pd()), _mm_setzero_pd(), _mm_set1_pd(*miss)};
    for (int32_t i = 0; i + 2 <= from.count; i += 2)
        two_rows(&from, points, i, &into, &all);
    if (from.count % 2 != 0) two_rows(&from, points, from.count - 2, &into, &all);
    if (G_UNLIKELY(_mm_movemask_pd(all.in_range) != 3)) return rows_with_care(rows, points, to, miss);
    *miss = _mm_cvtsd_f64(_mm_max_sd(all.miss, _mm_unpackhi_pd(all.miss, all.miss)));
    return _mm_movemask_pd(_mm_cmpeq_pd(all.zeros, _mm_setzero_pd())) == 3;
}

#define AVX2 __attribute__((target("avx2")))

/* What four rows side by side have in common. */
typedef struct {
    __m256d in_range, zeros, miss;
} Four;

/* Places and speeds are read apart, as they may just have been written so: a wider read would wait for both. */
AVX2 __attribute__((always_inline)) static inline void four_rows(const TinkerDistances *rows, const TinkerPoint *points,
                                                                 int32_t i, const Results *to, Four *all)
{
    const __m256d one = _mm256_set1_pd(1.0), signs = _mm256_set_pd(0.0, 0.0, -0.0, -0.0);
    const __m256d least = _mm256_set1_pd(TINKER_LEAST_SQUARE), greatest = _mm256_set1_pd(TINKER_GREATEST_SQUARE);
    const int32_t *ends = rows->ends + 2 * (gsize)i;
    __m128d place[4], speed[4];
    for (int k = 0; k < 4; k++) {
        const TinkerPoint *a = &points[ends[2 * k]], *b = &points[ends[2 * k + 1]];
        place[k] = _mm_sub_pd(_mm_loadu_pd(&b->x), _mm_loadu_pd(&a->x));
        speed[k] = _mm_sub_pd(_mm_loadu_pd(&b->vx), _mm_loadu_pd(&a->vx));
    }
    const __m256d even_places = _mm256_set_m128d(place[2], place[0]);
    const __m256d odd_places = _mm256_set_m128d(place[3], place[1]);
    const __m256d even_speeds = _mm256_set_m128d(speed[2], speed[0]);
    const __m256d odd_speeds = _mm256_set_m128d(speed[3], speed[1]);
    const __m256d dx = _mm256_unpacklo_pd(even_places, odd_places);
    const __m256d dy = _mm256_unpackhi_pd(even_places, odd_places);
    const __m256d du = _mm256_unpacklo_pd(even_speeds, odd_speeds);
    const __m256d dv = _mm256_unpackhi_pd(even_speeds, odd_speeds);
    const __m256d square = _mm256_add_pd(_mm256_mul_pd(dx, dx), _mm256_mul_pd(dy, dy));
    const __m256d distance = _mm256_sqrt_pd(square);
    const __m256d inverse = _mm256_mul_pd(distance, _mm256_div_pd(one, square));
    const __m256d nx = _mm256_mul_pd(dx, inverse), ny = _mm256_mul_pd(dy, inverse);
    const __m256d across = _mm256_sub_pd(_mm256_mul_pd(nx, dv), _mm256_mul_pd(ny, du));
    const __m256d g = _mm256_sub_pd(distance, _mm256_loadu_pd(rows->length + i));
    const __m256d drift = _mm256_mul_pd(_mm256_mul_pd(across, across), inverse);
    const __m256d even = _mm256_unpacklo_pd(nx, ny), odd = _mm256_unpackhi_pd(nx, ny);
    const __m256d n[4] = {_mm256_permute2f128_pd(even, even, 0x00), _mm256_permute2f128_pd(odd, odd, 0x00),
                          _mm256_permute2f128_pd(even, even, 0x11), _mm256_permute2f128_pd(odd, odd, 0x11)};
    for (int k = 0; k < 4; k++)
        _mm256_storeu_pd(to->jacobian + 4 * (gsize)(i + k), _mm256_xor_pd(n[k], signs));
    _mm256_storeu_pd(to->g + i, g);
    _mm256_storeu_pd(to->drift + i, drift);
    const __m256d in_range =
        _mm256_and_pd(_mm256_cmp_pd(square, least, _CMP_GE_OQ), _mm256_cmp_pd(square, greatest, _CMP_LE_OQ));
    const __m256d size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), g);
    all->in_range = _mm256_and_pd(all->in_range, in_range);
    all->zeros = _mm256_add_pd(all->zeros, _mm256_mul_pd(_mm256_setzero_pd(), _mm256_add_pd(g, drift)));
    all->miss = _mm256_max_pd(all->miss, _mm256_mul_pd(size, _mm256_loadu_pd(rows->inverse_scale + i)));
}

/* Four rows or more, likewise. */
AVX2 static gboolean rows_by_fours(const TinkerDistances *rows, const TinkerPoint *points, const Results *to,
                                   double *miss)
{
    const TinkerDistances from = *rows;
    const Results into = *to;
    const __m256d zero = _mm256_setzero_pd();
    Four all = {_mm256_cmp_pd(zero, zero, _CMP_EQ_OQ), zero, _mm256_set1_pd(*miss)};
    for (int32_t i = 0; i + 4 <= from.count; i += 4)
        four_rows(&from, points, i, &into, &all);
    if (from.count % 4 != 0) four_rows(&from, points, from.count - 4, &into, &all);
    if (G_UNLIKELY(_mm256_movemask_pd(all.in_range) != 15)) return rows_with_care(rows, points, to, miss);
    double most[4];
    _mm256_storeu_pd(most, all.miss);
    *miss = MAX(MAX(most[0], most[1]), MAX(most[2], most[3]));
    return _mm256_movemask_pd(_mm256_cmp_pd(all.zeros, zero, _CMP_EQ_OQ)) == 15;
}
#endif

gboolean tinker_distance_rows(const TinkerDistances *rows, const TinkerPoint *points, double *g, double *jacobian,
                              double *drift, double *miss)
{
    const Results to = {g, jacobian, drift};
#if defined(__x86_64__)
    if (rows->count >= 4 && __builtin_cpu_supports("avx2")) return rows_by_fours(rows, points, &to, miss);
    if (rows->count >= 2) return rows_by_twos(rows, points, &to, miss);
#endif
    return rows_with_care(rows, points, &to, miss);
}

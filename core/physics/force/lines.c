/* Merged linear laws between pairs of points: the innermost loop of most scenes.
 *
 *   d = x_b - x_a,  L = |d|,  rate = d . (v_b - v_a) / L,
 *   T = tension + stiffness (L - length) + damping rate,   force on a: T d / L, on b the opposite.
 *
 * Where L is 0 the direction is undefined and the pair exerts nothing for that instant. 1 / L is worked out as L (1 /
 * L^2), so that the division does not wait for the square root.
 *
 * On x86-64 with AVX2 four lines are worked out at once from packed points; the baseline is plain scalar code, which is
 * faster there than four-wide vectors made of pairs. Both do the same operations in the same order, so they give the
 * same bits; forces are added one line after the other.
 */
#include <math.h>
#include <tinker/kernels.h>

#include "physics/force/forces.h"
#include "physics/model/model-data.h"

static inline gboolean is_ordinary(double square)
{
    return square >= TINKER_LEAST_SQUARE && square <= TINKER_GREATEST_SQUARE;
}

static inline double add_line(const TinkerMergedLines *lines, const int32_t *slots, int32_t i,
                              const TinkerPoint *points, double *force)
{
    const TinkerPoint *a = &points[lines->a[i]], *b = &points[lines->b[i]];
    double dx = b->x - a->x, dy = b->y - a->y, du = b->vx - a->vx, dv = b->vy - a->vy;
    double square = dx * dx + dy * dy;
    double length = sqrt(square);
    double inverse = length * (1.0 / square);
    if (G_UNLIKELY(!is_ordinary(square))) inverse = square > 0 ? 1.0 / length : 0.0;
    if (G_UNLIKELY(square < lines->watched_square)) atomic_store_explicit(lines->came_near, TRUE, memory_order_relaxed);
    double rate = (dx * du + dy * dv) * inverse;
    double resistance = lines->damping[i] * rate;
    double tension = lines->tension[i] + lines->stiffness[i] * (length - lines->length[i]) + resistance;
    double scale = tension * inverse;
    double fx = scale * dx, fy = scale * dy;
    double *on_a = force + 2 * (gsize)lines->a[i], *on_b = force + 2 * (gsize)slots[i];
    on_a[0] += fx;
    on_a[1] += fy;
    on_b[0] -= fx;
    on_b[1] -= fy;
    return resistance * rate;
}

static double add_range(const TinkerMergedLines *lines, const int32_t *slots, int32_t first, int32_t end,
                        const TinkerPoint *points, double *force, double taken)
{
    for (int32_t i = first; i < end; i++)
        taken += add_line(lines, slots, i, points, force);
    return taken;
}

#if defined(__x86_64__)
#include <immintrin.h>

typedef struct {
    __m256d x, y, vx, vy;
} Columns;

/* b - a of four lines, transposed from rows to columns. */
__attribute__((target("avx2"), always_inline)) static inline Columns differences(const int32_t *a, const int32_t *b,
                                                                                 const TinkerPoint *points)
{
    __m256d d[4];
    for (int k = 0; k < 4; k++)
        d[k] = _mm256_sub_pd(_mm256_loadu_pd(&points[b[k]].x), _mm256_loadu_pd(&points[a[k]].x));
    __m256d low01 = _mm256_unpacklo_pd(d[0], d[1]), high01 = _mm256_unpackhi_pd(d[0], d[1]);
    __m256d low23 = _mm256_unpacklo_pd(d[2], d[3]), high23 = _mm256_unpackhi_pd(d[2], d[3]);
    return (Columns){_mm256_permute2f128_pd(low01, low23, 0x20), _mm256_permute2f128_pd(high01, high23, 0x20),
                     _mm256_permute2f128_pd(low01, low23, 0x31), _mm256_permute2f128_pd(high01, high23, 0x31)};
}

__attribute__((target("avx2"), always_inline)) static inline void scatter(const int32_t *a, const int32_t *slots,
                                                                          __m256d fx, __m256d fy, double *force)
{
    __m256d low = _mm256_unpacklo_pd(fx, fy), high = _mm256_unpackhi_pd(fx, fy);
    __m128d f[4] = {_mm256_castpd256_pd128(low), _mm256_castpd256_pd128(high), _mm256_extractf128_pd(low, 1),
                    _mm256_extractf128_pd(high, 1)};
    for (int k = 0; k < 4; k++) {
        double *on_a = force + 2 * (gsize)a[k], *on_b = force + 2 * (gsize)slots[k];
        _mm_storeu_pd(on_a, _mm_add_pd(_mm_loadu_pd(on_a), f[k]));
        _mm_storeu_pd(on_b, _mm_sub_pd(_mm_loadu_pd(on_b), f[k]));
    }
}

__attribute__((target("avx2"))) static double add_forces_avx2(const TinkerMergedLines *lines, const int32_t *slots,
                                                              int32_t first, int32_t end, const TinkerPoint *points,
                                                              double *force)
{
    const __m256d one = _mm256_set1_pd(1.0);
    const __m256d least = _mm256_set1_pd(fmax(TINKER_LEAST_SQUARE, lines->watched_square));
    const __m256d greatest = _mm256_set1_pd(TINKER_GREATEST_SQUARE);
    /* as variables of their own: stores of vectors may alias what lines points to */
    const int32_t *const a = lines->a, *const b = lines->b;
    const double *const stiffness = lines->stiffness, *const lengths = lines->length;
    const double *const damping = lines->damping, *const tension = lines->tension;
    const gboolean any_damping = lines->any_damping;
    double taken = 0;
    int32_t i = first;
    for (; i + 4 <= end; i += 4) {
        Columns d = differences(a + i, b + i, points);
        __m256d square = _mm256_add_pd(_mm256_mul_pd(d.x, d.x), _mm256_mul_pd(d.y, d.y));
        __m256d ordinary =
            _mm256_and_pd(_mm256_cmp_pd(square, least, _CMP_GE_OQ), _mm256_cmp_pd(square, greatest, _CMP_LE_OQ));
        if (G_UNLIKELY(_mm256_movemask_pd(ordinary) != 15)) {
            taken = add_range(lines, slots, i, i + 4, points, force, taken);
            continue;
        }
        __m256d length = _mm256_sqrt_pd(square);
        __m256d inverse = _mm256_mul_pd(length, _mm256_div_pd(one, square));
        __m256d along = _mm256_add_pd(_mm256_mul_pd(d.x, d.vx), _mm256_mul_pd(d.y, d.vy));
        __m256d rate = _mm256_mul_pd(along, inverse);
        __m256d resistance = _mm256_mul_pd(_mm256_loadu_pd(damping + i), rate);
        __m256d stretch = _mm256_sub_pd(length, _mm256_loadu_pd(lengths + i));
        __m256d elastic =
            _mm256_add_pd(_mm256_loadu_pd(tension + i), _mm256_mul_pd(_mm256_loadu_pd(stiffness + i), stretch));
        __m256d scale = _mm256_mul_pd(_mm256_add_pd(elastic, resistance), inverse);
        scatter(a + i, slots + i, _mm256_mul_pd(scale, d.x), _mm256_mul_pd(scale, d.y), force);
        if (!any_damping) continue;
        double power[4];
        _mm256_storeu_pd(power, _mm256_mul_pd(resistance, rate));
        for (int k = 0; k < 4; k++)
            taken += power[k];
    }
    return add_range(lines, slots, i, end, points, force, taken);
}
#endif

double tinker_lines_add_range(const TinkerMergedLines *lines, const int32_t *slots, int32_t first, int32_t end,
                              const TinkerPoint *points, double *force)
{
#if defined(__x86_64__)
    if (end - first >= 4 && __builtin_cpu_supports("avx2"))
        return add_forces_avx2(lines, slots, first, end, points, force);
#endif
    return add_range(lines, slots, first, end, points, force, 0.0);
}

void tinker_lines_add_forces(const TinkerMergedLines *lines, const TinkerPoint *points, double *force, double *taken)
{
    double power = tinker_lines_add_range(lines, lines->b, 0, lines->count, points, force);
    if (taken != NULL) *taken = power;
}

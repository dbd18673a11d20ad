/* Rod: keeps a fixed distance between its ends, g = L - l = 0.
 *
 * With d = x_b - x_a, L = |d|, n = d / L and w = v_b - v_a:
 *     J = dg/dx = (-n, n),  dL/dt = n . w,
 *     d2L/dt2 = n . (a_b - a_a) + (|w|^2 - (n . w)^2) / L = n . (a_b - a_a) + (n x w)^2 / L,
 * so the drift is (n x w)^2 / L. The cross product is what is left of the difference before it, without its
 * cancellation where the ends move along the rod. */
#include <tinker/sdk.h>

enum { COLUMN_LENGTH };

enum { QUANTITY_TENSION, QUANTITY_LENGTH_ERROR };

/* Physics */

static void write_row(double *jacobian, double nx, double ny)
{
    jacobian[0] = -nx;
    jacobian[1] = -ny;
    jacobian[2] = nx;
    jacobian[3] = ny;
}

/* All rows, as plain arithmetic; the division does not wait for the square root. Answers whether some L^2 left the range of
 * a double; those rows are to be done again. */
static int rows_one_by_one(int32_t count, const TinkerPoint *restrict ends, const double *restrict length,
                           double *restrict g, double *restrict jacobian, double *restrict drift)
{
    int out_of_range = 0;
    for (int32_t i = 0; i < count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, square = dx * dx + dy * dy;
        const double distance = sqrt(square), inverse = distance * (1.0 / square);
        const double nx = dx * inverse, ny = dy * inverse;
        const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        out_of_range |= !(square >= TINKER_LEAST_SQUARE) | !(square <= TINKER_GREATEST_SQUARE);
        g[i] = distance - length[i];
        write_row(&jacobian[4 * i], nx, ny);
        drift[i] = across * across * inverse;
    }
    return out_of_range;
}

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>

/* Two rods at once, with the same operations in the same order, so with the same bits: a compiler turns ends, which are rows
 * of four doubles each, into columns with twice the effort. Answers as rows_one_by_one. */
static inline int two_rows(const TinkerPoint *restrict ends, const double *restrict length, double *restrict g,
                           double *restrict jacobian, double *restrict drift)
{
    const __m128d one = _mm_set1_pd(1.0), signs = _mm_set1_pd(-0.0);
    const __m128d place0 = _mm_sub_pd(_mm_loadu_pd(&ends[1].x), _mm_loadu_pd(&ends[0].x));
    const __m128d place1 = _mm_sub_pd(_mm_loadu_pd(&ends[3].x), _mm_loadu_pd(&ends[2].x));
    const __m128d speed0 = _mm_sub_pd(_mm_loadu_pd(&ends[1].vx), _mm_loadu_pd(&ends[0].vx));
    const __m128d speed1 = _mm_sub_pd(_mm_loadu_pd(&ends[3].vx), _mm_loadu_pd(&ends[2].vx));
    const __m128d dx = _mm_unpacklo_pd(place0, place1), dy = _mm_unpackhi_pd(place0, place1);
    const __m128d du = _mm_unpacklo_pd(speed0, speed1), dv = _mm_unpackhi_pd(speed0, speed1);
    const __m128d square = _mm_add_pd(_mm_mul_pd(dx, dx), _mm_mul_pd(dy, dy));
    const __m128d distance = _mm_sqrt_pd(square), inverse = _mm_mul_pd(distance, _mm_div_pd(one, square));
    const __m128d nx = _mm_mul_pd(dx, inverse), ny = _mm_mul_pd(dy, inverse);
    const __m128d across = _mm_sub_pd(_mm_mul_pd(nx, dv), _mm_mul_pd(ny, du));
    const __m128d n0 = _mm_unpacklo_pd(nx, ny), n1 = _mm_unpackhi_pd(nx, ny);
    _mm_storeu_pd(&jacobian[0], _mm_xor_pd(n0, signs));
    _mm_storeu_pd(&jacobian[2], n0);
    _mm_storeu_pd(&jacobian[4], _mm_xor_pd(n1, signs));
    _mm_storeu_pd(&jacobian[6], n1);
    _mm_storeu_pd(g, _mm_sub_pd(distance, _mm_loadu_pd(length)));
    _mm_storeu_pd(drift, _mm_mul_pd(_mm_mul_pd(across, across), inverse));
    const __m128d within = _mm_and_pd(_mm_cmpge_pd(square, _mm_set1_pd(TINKER_LEAST_SQUARE)),
                                      _mm_cmple_pd(square, _mm_set1_pd(TINKER_GREATEST_SQUARE)));
    return _mm_movemask_pd(within) != 3;
}

/* Two or more. The last two overlap those before where need be: they come out the same. */
static int rows_by_twos(int32_t count, const TinkerPoint *ends, const double *length, double *g, double *jacobian,
                        double *drift)
{
    int out_of_range = 0;
    for (int32_t i = 0; i + 2 <= count; i += 2)
        out_of_range |= two_rows(&ends[2 * i], &length[i], &g[i], &jacobian[4 * i], &drift[i]);
    const int32_t last = count - 2;
    if (count % 2 != 0)
        out_of_range |= two_rows(&ends[2 * last], &length[last], &g[last], &jacobian[4 * last], &drift[last]);
    return out_of_range;
}

/* Four rods at once, likewise. Their ends are read by halves, as they may just have been written so: a wider read would wait
 * for both. */
__attribute__((target("avx2"), always_inline)) static inline int
four_rows(const TinkerPoint *restrict ends, const double *restrict length, double *restrict g,
          double *restrict jacobian, double *restrict drift)
{
    const __m256d one = _mm256_set1_pd(1.0), signs = _mm256_set_pd(0.0, 0.0, -0.0, -0.0);
    const __m256d least = _mm256_set1_pd(TINKER_LEAST_SQUARE), greatest = _mm256_set1_pd(TINKER_GREATEST_SQUARE);
    __m128d place[4], speed[4];
    for (int k = 0; k < 4; k++) {
        const TinkerPoint *a = &ends[2 * k], *b = a + 1;
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
    _mm256_storeu_pd(g, _mm256_sub_pd(distance, _mm256_loadu_pd(length)));
    _mm256_storeu_pd(drift, _mm256_mul_pd(_mm256_mul_pd(across, across), inverse));
    const __m256d even = _mm256_unpacklo_pd(nx, ny), odd = _mm256_unpackhi_pd(nx, ny);
    const __m256d rows[4] = {_mm256_permute2f128_pd(even, even, 0x00), _mm256_permute2f128_pd(odd, odd, 0x00),
                             _mm256_permute2f128_pd(even, even, 0x11), _mm256_permute2f128_pd(odd, odd, 0x11)};
    for (int k = 0; k < 4; k++)
        _mm256_storeu_pd(&jacobian[4 * k], _mm256_xor_pd(rows[k], signs));
    const __m256d within =
        _mm256_and_pd(_mm256_cmp_pd(square, least, _CMP_GE_OQ), _mm256_cmp_pd(square, greatest, _CMP_LE_OQ));
    return _mm256_movemask_pd(within) != 15;
}

/* Four or more, likewise. */
__attribute__((target("avx2"))) static int rows_by_fours(int32_t count, const TinkerPoint *ends, const double *length,
                                                         double *g, double *jacobian, double *drift)
{
    int out_of_range = 0;
    for (int32_t i = 0; i + 4 <= count; i += 4)
        out_of_range |= four_rows(&ends[2 * i], &length[i], &g[i], &jacobian[4 * i], &drift[i]);
    const int32_t last = count - 4;
    if (count % 4 != 0)
        out_of_range |= four_rows(&ends[2 * last], &length[last], &g[last], &jacobian[4 * last], &drift[last]);
    return out_of_range;
}

static int rows_loop(int32_t count, const TinkerPoint *ends, const double *length, double *g, double *jacobian,
                     double *drift)
{
    if (count >= 4 && __builtin_cpu_supports("avx2")) return rows_by_fours(count, ends, length, g, jacobian, drift);
    if (count >= 2) return rows_by_twos(count, ends, length, g, jacobian, drift);
    return rows_one_by_one(count, ends, length, g, jacobian, drift);
}
#else
static int rows_loop(int32_t count, const TinkerPoint *ends, const double *length, double *g, double *jacobian,
                     double *drift)
{
    return rows_one_by_one(count, ends, length, g, jacobian, drift);
}
#endif

/* One row of a rod that is immensely long or short. Where the ends coincide it has no direction, and can exert nothing;
 * its g says how wrong that is. */
static void row_out_of_range(const TinkerPoint *a, const TinkerPoint *b, double length, double *g, double *jacobian,
                             double *drift)
{
    const double dx = b->x - a->x, dy = b->y - a->y, distance = hypot(dx, dy);
    const double nx = distance == 0.0 ? 0.0 : dx / distance, ny = distance == 0.0 ? 0.0 : dy / distance;
    const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
    *g = distance - length;
    write_row(jacobian, nx, ny);
    *drift = distance == 0.0 ? 0.0 : across / distance * across;
}

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    if (!rows_loop(batch->count, ends, length, g, jacobian, drift)) return TINKER_OK;
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, square = dx * dx + dy * dy;
        if (!(square >= TINKER_LEAST_SQUARE && square <= TINKER_GREATEST_SQUARE)) {
            row_out_of_range(a, b, length[i], &g[i], &jacobian[4 * i], &drift[i]);
        }
    }
    return TINKER_OK;
}

static TinkerStatus scale(TinkerBatch *batch, double *result)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = length[i];
    }
    return TINKER_OK;
}

static TinkerStatus check(TinkerBatch *batch)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        if (!(length[i] > 0.0)) return tinker_fail(batch, i, "length is 0; a rod needs a length above 0");
    }
    return TINKER_OK;
}

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    style->bar(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* Graphs */

/* The multiplier of g = L - l pushes the ends apart where it is positive: the tension is minus it. */
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    if (quantity == QUANTITY_TENSION) {
        if (input->multipliers == NULL) return tinker_fail(batch, 0, "the rod's force is not known yet");
        for (int32_t i = 0; i < batch->count; i++) {
            result[i] = -input->multipliers[i];
        }
        return TINKER_OK;
    }
    tinker_end_distances(batch->count, input->ends, result);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] -= length[i];
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Rod Properties", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.1, 10.0), .symbol = "l", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_STRUCTURAL, .description = "Distance that it keeps between its ends"},
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "length error", "Length Error", "How far its length is off", TINKER_DIMENSION_LENGTH),
};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .scale = scale, .check = check};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"length", "m", "ft"}, {"tension", "N", "lbf"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("rod", "Rod", TINKER_CONNECTOR), .summary = "Keeps a fixed distance between its ends",
     .formula = "|x2 - x1| = l", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.rod", "Rod", "0.1.0", "MIT", blocks)

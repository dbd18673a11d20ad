/* Rows that keep a distance, which the host works out: against their formulas in extended precision, for every number
 * of rows that is worked out in a different way; and which constraints they stand for. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/distance-rows.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

#define MOST_ROWS 11
#define POINTS    7

typedef struct {
    int32_t ends[2 * MOST_ROWS];
    double length[MOST_ROWS], inverse_scale[MOST_ROWS];
    TinkerPoint points[POINTS];
    double g[MOST_ROWS], jacobian[4 * MOST_ROWS], drift[MOST_ROWS], miss;
} Case;

static double value(GRand *random)
{
    return g_rand_double_range(random, -3, 3);
}

/* Rows between points of chance, some of which share one. */
static void make(Case *c, GRand *random)
{
    memset(c, 0, sizeof(*c));
    for (int i = 0; i < POINTS; i++)
        c->points[i] = (TinkerPoint){value(random), value(random), value(random), value(random)};
    for (int i = 0; i < MOST_ROWS; i++) {
        c->ends[2 * i] = g_rand_int_range(random, 0, POINTS);
        c->ends[2 * i + 1] = (c->ends[2 * i] + g_rand_int_range(random, 1, POINTS)) % POINTS;
        c->length[i] = fabs(value(random));
        c->inverse_scale[i] = g_rand_double_range(random, 0.1, 10);
    }
}

static gboolean evaluate(Case *c, int32_t count)
{
    TinkerDistances rows = {count, c->ends, c->length, c->inverse_scale};
    return tinker_distance_rows(&rows, c->points, c->g, c->jacobian, c->drift, &c->miss);
}

static void assert_near(double given, long double exact, long double size)
{
    g_assert_cmpfloat((double)fabsl(given - exact), <=, 16 * DBL_EPSILON * (double)size);
}

/* g = L - length, J = (-n, n), drift = (n x w)^2 / L. */
static void assert_row(const Case *c, int row)
{
    const TinkerPoint *a = &c->points[c->ends[2 * row]], *b = &c->points[c->ends[2 * row + 1]];
    long double dx = (long double)b->x - a->x, dy = (long double)b->y - a->y, length = hypotl(dx, dy);
    long double nx = dx / length, ny = dy / length;
    long double along_x = nx * ((long double)b->vy - a->vy), along_y = ny * ((long double)b->vx - a->vx);
    long double across = along_x - along_y, reach = fabsl(along_x) + fabsl(along_y);
    assert_near(c->g[row], length - c->length[row], length + c->length[row]);
    assert_near(c->jacobian[4 * row], -nx, 1);
    assert_near(c->jacobian[4 * row + 1], -ny, 1);
    assert_near(c->jacobian[4 * row + 2], nx, 1);
    assert_near(c->jacobian[4 * row + 3], ny, 1);
    assert_near(c->drift[row], across * across / length, reach * reach / length);
    g_assert_cmpfloat(c->miss, >=, fabs(c->g[row]) * c->inverse_scale[row]);
}

static void test_formulas(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(11);
    for (int32_t count = 0; count <= MOST_ROWS; count++) {
        Case c;
        make(&c, random);
        g_assert_true(evaluate(&c, count));
        double most = 0;
        for (int row = 0; row < count; row++) {
            assert_row(&c, row);
            most = MAX(most, fabs(c.g[row]) * c.inverse_scale[row]);
        }
        g_assert_cmpfloat(c.miss, ==, most);
        for (int row = count; row < MOST_ROWS; row++)
            g_assert_cmpfloat(c.g[row], ==, 0); /* nothing is written behind the last row */
    }
}

/* The number of rows does not change a bit of any. */
static void test_same_bits(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(12);
    Case all, few;
    make(&all, random);
    few = all;
    g_assert_true(evaluate(&all, MOST_ROWS));
    for (int32_t count = 1; count < MOST_ROWS; count++) {
        g_assert_true(evaluate(&few, count));
        g_assert_cmpmem(few.g, (gsize)count * sizeof(double), all.g, (gsize)count * sizeof(double));
        g_assert_cmpmem(few.drift, (gsize)count * sizeof(double), all.drift, (gsize)count * sizeof(double));
        g_assert_cmpmem(few.jacobian, 4 * (gsize)count * sizeof(double), all.jacobian,
                        4 * (gsize)count * sizeof(double));
    }
}

/* A 3-4-5 triangle whose squares leave the range of a double, at every place among others that are ordinary. */
static void test_extreme_lengths(void)
{
    static const double sizes[] = {1e-300, 1e-150, 1e150, 1e300};
    g_autoptr(GRand) random = g_rand_new_with_seed(13);
    for (gsize s = 0; s < G_N_ELEMENTS(sizes); s++)
        for (int32_t count = 1; count <= MOST_ROWS; count++)
            for (int32_t at = 0; at < count; at++) {
                Case c;
                make(&c, random);
                for (int i = 0; i < 2 * MOST_ROWS; i++)
                    c.ends[i] = i / 2 == at ? 5 + i % 2 : c.ends[i] % 5;
                for (int i = 0; i < MOST_ROWS; i++)
                    if (i != at && c.ends[2 * i] == c.ends[2 * i + 1]) c.ends[2 * i + 1] = (c.ends[2 * i] + 1) % 5;
                c.points[5] = (TinkerPoint){0, 0, 0, 0};
                c.points[6] = (TinkerPoint){3 * sizes[s], 4 * sizes[s], 0, 0};
                c.length[at] = 4 * sizes[s];
                g_assert_true(evaluate(&c, count));
                for (int row = 0; row < count; row++)
                    assert_row(&c, row);
            }
}

/* Where the ends coincide a row has no direction and its g tells how wrong that is; the others are not touched by it.
 */
static void test_coincident_ends(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(14);
    for (int32_t count = 1; count <= MOST_ROWS; count++) {
        Case c;
        make(&c, random);
        c.ends[2 * count - 1] = c.ends[2 * count - 2];
        g_assert_true(evaluate(&c, count));
        for (int row = 0; row < count - 1; row++)
            assert_row(&c, row);
        g_assert_cmpfloat(c.g[count - 1], ==, -c.length[count - 1]);
        g_assert_cmpfloat(c.drift[count - 1], ==, 0);
        for (int k = 4 * count - 4; k < 4 * count; k++)
            g_assert_cmpfloat(c.jacobian[k], ==, 0);
    }
}

/* A place or a speed that is not a finite number is told, whatever row it is in. */
static void test_not_finite(void)
{
    static const double values[] = {NAN, INFINITY, -INFINITY};
    g_autoptr(GRand) random = g_rand_new_with_seed(15);
    for (gsize i = 0; i < G_N_ELEMENTS(values); i++)
        for (int32_t count = 1; count <= MOST_ROWS; count++)
            for (int32_t row = 0; row < count; row++) {
                Case c;
                make(&c, random);
                TinkerPoint *point = &c.points[c.ends[2 * row]];
                *(i % 2 == 0 ? &point->x : &point->vy) = values[i];
                g_assert_false(evaluate(&c, count));
            }
}

/* g of two ties of the length 3, the second of which has a steepness, between ends that were moved 5 m apart. */
static void assert_ties(const char *steepness, gboolean worked_out, double second)
{
    g_autofree char *text =
        g_strdup_printf("{'type': 'mass', 'position': [0, 0]}, {'type': 'mass', 'position': [3, 0]},"
                        "{'type': 'mass', 'position': [3, 3]},"
                        "{'type': 'tie', 'ends': ['Mass 0', 'Mass 1'], 'length': 3, 'steepness': 1},"
                        "{'type': 'tie', 'ends': ['Mass 1', 'Mass 2'], 'length': 3, 'steepness': %s}",
                        steepness);
    g_autoptr(GError) error = NULL;
    TinkerScene *scene = physics_scene(NULL, text);
    TinkerModel *model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    const TinkerConstraints *all = &model->constraints;
    g_assert_cmpint(g_array_index(all->batches, TinkerConstraintBatch, 0).distances != NULL, ==, worked_out);
    g_assert_cmpint(tinker_model_set_time(model, 0.0), ==, TINKER_OK);
    g_autofree double *q = g_memdup2(model->q_start, 6 * sizeof(double));
    q[0] -= 2;
    q[5] += 2;
    tinker_model_set_state(model, q, model->v_start);
    g_assert_cmpint(tinker_constraints_evaluate(model), ==, TINKER_OK);
    g_assert_cmpfloat(all->g[0], ==, 2);
    g_assert_cmpfloat(all->g[1], ==, second);
    tinker_model_free(model);
    tinker_scene_free(scene);
}

/* A type whose blocks all keep a distance is worked out; where one does not, all are asked. */
static void test_who_is_asked(void)
{
    assert_ties("1", TRUE, 2);
    assert_ties("2", FALSE, 4);
}

/* What a start position misses is told with the place that would fit: here 4 of the 5 m that (4, 6) is from (1, 2). */
static void test_misfit(void)
{
    g_autoptr(PhysicsRun) run = physics_try(
        &(PhysicsOptions){0}, "{'type': 'support', 'position': [1, 2]},"
                              "{'type': 'mass', 'position': [4, 6]},"
                              "{'type': 'tie', 'ends': ['Support 0', 'Mass 0'], 'length': 4, 'steepness': 2}");
    physics_assert_refused(run, TINKER_MODEL_ERROR_SCENE, "Tie 0: the start positions miss it by 2 m",
                           "it fits with Mass 0 at about (3.4, 5.2) m", NULL);
}

static void add_tests(void)
{
    g_test_add_func("/physics/distance-rows/formulas", test_formulas);
    g_test_add_func("/physics/distance-rows/same-bits", test_same_bits);
    g_test_add_func("/physics/distance-rows/extreme-lengths", test_extreme_lengths);
    g_test_add_func("/physics/distance-rows/coincident-ends", test_coincident_ends);
    g_test_add_func("/physics/distance-rows/not-finite", test_not_finite);
    g_test_add_func("/physics/distance-rows/who-is-asked", test_who_is_asked);
    g_test_add_func("/physics/distance-rows/misfit", test_misfit);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

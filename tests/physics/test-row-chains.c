/* Rods that hang together in chains: what the solve along the chains gives satisfies the equations that it solves, put
 * together here in extended precision from the rows themselves. */
#include <math.h>
#include <string.h>

#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/constraint/constraints.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

typedef struct {
    int rods;
    gboolean held_first, held_last; /* an end that is a support */
} ChainCase;

static const ChainCase cases[] = {{1, TRUE, FALSE},  {1, FALSE, FALSE}, {2, TRUE, FALSE},  {2, FALSE, FALSE},
                                  {3, FALSE, FALSE}, {3, TRUE, TRUE},   {4, TRUE, TRUE},   {5, TRUE, FALSE},
                                  {8, FALSE, TRUE},  {9, TRUE, TRUE},   {600, TRUE, FALSE}};

/* Nodes of one chain, and its rods in an order and direction of chance; with the names of all others. */
static void add_chain(GString *text, GRand *random, int chain, const ChainCase *made)
{
    g_autofree int *order = g_new(int, made->rods);
    double x = 0, y = -3.0 * chain;
    for (int i = 0; i <= made->rods; i++) {
        gboolean held = (i == 0 && made->held_first) || (i == made->rods && made->held_last);
        g_string_append_printf(text, "{'type': '%s', 'name': 'N%d-%d', 'position': [%.17g, %.17g]%s",
                               held ? "support" : "mass", chain, i, x, y, held ? ", 'solid': false" : "");
        if (!held)
            g_string_append_printf(text, ", 'mass': %.17g, 'width': 0, 'height': 0",
                                   pow(10, g_rand_double_range(random, -1, 1)));
        g_string_append(text, "},");
        x += g_rand_double_range(random, 0.5, 1.5);
        y += g_rand_double_range(random, -1, 1);
    }
    for (int i = 0; i < made->rods; i++) {
        int j = g_rand_int_range(random, 0, i + 1);
        order[i] = order[j];
        order[j] = i;
    }
    for (int i = 0; i < made->rods; i++) {
        gboolean turned = g_rand_boolean(random);
        g_string_append_printf(text, "{'type': 'rod', 'ends': ['N%d-%d', 'N%d-%d']},", chain, order[i] + turned, chain,
                               order[i] + !turned);
    }
}

static TinkerModel *chains(GRand *random)
{
    g_autoptr(GString) text = g_string_new("{'type': 'mass', 'name': 'alone', 'position': [-9, 9]},");
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        add_chain(text, random, (int)i, &cases[i]);
    g_string_truncate(text, text->len - 1);
    g_autoptr(GError) error = NULL;
    TinkerModel *model = tinker_model_new(physics_scene(NULL, text->str), &error);
    g_assert_no_error(error);
    g_assert_nonnull(model->constraints.chains);
    return model;
}

static void free_model(TinkerModel *model)
{
    TinkerScene *scene = model->scene;
    tinker_model_free(model);
    tinker_scene_free(scene);
}

static double *vector(GRand *random, int32_t count, double size)
{
    double *x = g_new(double, count);
    for (int32_t i = 0; i < count; i++)
        x[i] = g_rand_double_range(random, -size, size);
    return x;
}

/* J u of a row, for a vector by body; supports are 0. */
static long double row_times(const TinkerModel *model, int32_t row, const double *u, long double *size)
{
    const TinkerConstraints *all = &model->constraints;
    long double sum = 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
        for (int k = 0; k < 2 && all->points[e] < model->bodies; k++) {
            long double product = (long double)all->jacobian[2 * e + k] * u[2 * all->points[e] + k];
            sum += product;
            *size += fabsl(product);
        }
    return sum;
}

/* J^T lambda on a coordinate. */
static void assert_impulses(const TinkerModel *model, const double *lambda, const double *before, const double *after)
{
    const TinkerConstraints *all = &model->constraints;
    gsize n = (gsize)model->coordinates;
    g_autofree long double *force = g_new0(long double, n), *size = g_new0(long double, n);
    for (int32_t e = 0; e < all->entries; e++)
        for (int k = 0; k < 2 && all->points[e] < model->bodies; k++) {
            long double part = (long double)all->jacobian[2 * e + k] * lambda[all->row_of[e]];
            force[2 * all->points[e] + k] += part;
            size[2 * all->points[e] + k] += fabsl(part);
        }
    for (gsize i = 0; i < n; i++) {
        long double change = force[i] / model->coordinate_mass[i], bound = size[i] / model->coordinate_mass[i];
        g_assert_cmpfloat((double)fabsl((long double)after[i] - before[i] - change), <=,
                          4e-15 * (double)(bound + fabsl((long double)before[i])));
    }
}

static void set_state(TinkerModel *model, const double *v)
{
    g_assert_cmpint(tinker_model_set_time(model, 0.0), ==, TINKER_OK);
    tinker_model_set_state(model, model->q_start, v);
    g_assert_cmpint(tinker_constraints_evaluate(model), ==, TINKER_OK);
}

/* The first solve factors, the second has the factor. */
static void test_accelerations(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(31);
    TinkerModel *model = chains(random);
    int32_t n = model->coordinates;
    g_autofree double *v = vector(random, n, 3);
    set_state(model, v);
    for (int solve = 0; solve < 2; solve++) {
        g_autofree double *given = vector(random, n, 10), *a = g_memdup2(given, (gsize)n * sizeof(double));
        g_assert_cmpfloat(tinker_constraints_accelerate(model, a), ==, 0);
        assert_impulses(model, model->constraints.lambda, given, a);
        for (int32_t row = 0; row < model->constraints.rows; row++) {
            long double size = fabsl((long double)model->constraints.drift[row]) + 10;
            long double left = row_times(model, row, a, &size) + model->constraints.drift[row];
            g_assert_cmpfloat((double)fabsl(left), <=, 1e-12 * (double)size);
        }
    }
    free_model(model);
}

static void test_velocities(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(32);
    TinkerModel *model = chains(random);
    int32_t n = model->coordinates;
    g_autofree double *given = vector(random, n, 3), *v = g_memdup2(given, (gsize)n * sizeof(double));
    gboolean moved;
    set_state(model, v);
    tinker_constraints_correct_velocities(model, v, FALSE, &moved);
    g_assert_true(moved);
    assert_impulses(model, model->constraints.lambda, given, v);
    for (int32_t row = 0; row < model->constraints.rows; row++) {
        long double size = 3;
        g_assert_cmpfloat((double)fabsl(row_times(model, row, v, &size)), <=, 1e-13 * (double)size);
    }
    free_model(model);
}

/* Bodies without rods stay where they are. */
static void test_positions(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(33);
    TinkerModel *model = chains(random);
    int32_t n = model->coordinates;
    g_autofree double *q = g_memdup2(model->q_start, (gsize)n * sizeof(double)), *off = vector(random, n, 1e-3);
    g_autofree double *v = g_new0(double, n);
    for (int32_t i = 2; i < n; i++)
        q[i] += off[i];
    gboolean moved;
    g_assert_cmpint(tinker_constraints_project_positions(model, 0.0, q, v, &moved), ==, TINKER_OK);
    g_assert_true(moved);
    g_assert_cmpmem(q, 2 * sizeof(double), model->q_start, 2 * sizeof(double));
    double position, velocity;
    g_assert_cmpint(tinker_constraints_errors(model, 0.0, q, v, &position, &velocity), ==, TINKER_OK);
    g_assert_cmpfloat(position, <=, 1e-12);
    free_model(model);
}

/* A ring and a body with three rods are left to the general solve. */
static void test_others(void)
{
    static const char *const others[] = {
        "{'type': 'mass', 'position': [0, 0]}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [0, "
        "1]},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}, {'type': 'rod', 'ends': ['Mass 1', 'Mass 2']},"
        "{'type': 'rod', 'ends': ['Mass 2', 'Mass 0']}",
        "{'type': 'mass', 'position': [0, 0]}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [0, "
        "1]},"
        "{'type': 'mass', 'position': [-1, 0]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 2']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 3']}"};
    for (gsize i = 0; i < G_N_ELEMENTS(others); i++) {
        g_autoptr(GError) error = NULL;
        TinkerModel *model = tinker_model_new(physics_scene(NULL, others[i]), &error);
        g_assert_no_error(error);
        g_assert_null(model->constraints.chains);
        free_model(model);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/row-chains/accelerations", test_accelerations);
    g_test_add_func("/physics/row-chains/velocities", test_velocities);
    g_test_add_func("/physics/row-chains/positions", test_positions);
    g_test_add_func("/physics/row-chains/others", test_others);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

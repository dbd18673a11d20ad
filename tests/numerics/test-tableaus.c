/* The published constants: order conditions, dense output, embedded methods. */
#include <math.h>

#include "numerics/integrate/explicit-rk.h"
#include "test-systems.h"

static int count_of(const TinkerTableau *tableau)
{
    return tableau->stages + 1 + tableau->extra_stages;
}

static void test_rows(gconstpointer data)
{
    const TinkerTableau *tableau = data;
    for (int i = 0; i < count_of(tableau); i++) {
        double sum = 0.0;
        for (int j = 0; j < count_of(tableau); j++) {
            sum += tableau->a[i][j];
            if (j >= i) g_assert_cmpfloat(tableau->a[i][j], ==, 0.0);
        }
        g_assert_cmpfloat(fabs(sum - tableau->c[i]), <, 2e-14);
    }
}

/* sum_i weights_i c_i^k */
static double moment(const TinkerTableau *tableau, const double *weights, int power)
{
    double sum = 0.0;
    for (int i = 0; i < count_of(tableau); i++)
        sum += weights[i] * pow(tableau->c[i], power);
    return sum;
}

/* sum_i weights_i (A^k 1)_i: the conditions of the tall trees. */
static double tall(const TinkerTableau *tableau, const double *weights, int power)
{
    double stage[TINKER_RK_STAGES_CAP], next[TINKER_RK_STAGES_CAP], sum = 0.0;
    for (int i = 0; i < TINKER_RK_STAGES_CAP; i++)
        stage[i] = 1.0;
    for (; power > 0; power--) {
        for (int i = 0; i < count_of(tableau); i++) {
            next[i] = 0.0;
            for (int j = 0; j < i; j++)
                next[i] += tableau->a[i][j] * stage[j];
        }
        for (int i = 0; i < count_of(tableau); i++)
            stage[i] = next[i];
    }
    for (int i = 0; i < count_of(tableau); i++)
        sum += weights[i] * stage[i];
    return sum;
}

/* Weights of y(s) that are of this order: bushy and tall trees. */
static void assert_weights(const TinkerTableau *tableau, const double *weights, double s, int order)
{
    for (int k = 0; k < order; k++) {
        g_assert_cmpfloat(fabs(moment(tableau, weights, k) - pow(s, k + 1) / (k + 1)), <, 1e-13);
        g_assert_cmpfloat(fabs(tall(tableau, weights, k) - pow(s, k + 1) / tgamma(k + 2)), <, 1e-13);
    }
}

static void test_order_conditions(gconstpointer data)
{
    const TinkerTableau *tableau = data;
    const double *b = tableau->a[tableau->stages];
    assert_weights(tableau, b, 1.0, tableau->order);
    /* and no more than that */
    g_assert_cmpfloat(fabs(tall(tableau, b, tableau->order) - 1.0 / tgamma(tableau->order + 2)), >, 1e-8);
}

static void test_embedded(gconstpointer data)
{
    const TinkerTableau *tableau = data;
    int order = tableau->order == 8 ? 5 : tableau->order - 1;
    double embedded[TINKER_RK_STAGES_CAP] = {0};
    for (int i = 0; i < count_of(tableau); i++)
        embedded[i] = tableau->a[tableau->stages][i] - tableau->error[i];
    assert_weights(tableau, embedded, 1.0, order);
    g_assert_cmpfloat(fabs(tall(tableau, embedded, order) - 1.0 / tgamma(order + 2)), >, 1e-6);
    if (!tableau->second_error) return;
    for (int i = 0; i < count_of(tableau); i++)
        embedded[i] = tableau->a[tableau->stages][i] - tableau->second_error[i];
    assert_weights(tableau, embedded, 1.0, 3);
}

static void test_dense_weights(gconstpointer data)
{
    const TinkerTableau *tableau = data;
    double weights[TINKER_RK_STAGES_CAP];
    for (int part = 0; part <= 10; part++) {
        double s = part / 10.0;
        tinker_tableau_dense_weights(tableau, s, weights);
        assert_weights(tableau, weights, s, tableau->order - 1);
    }
    for (int i = 0; i < count_of(tableau); i++)
        g_assert_cmpfloat(fabs(weights[i] - tableau->a[tableau->stages][i]), <, 1e-15);
}

static void test_joined_errors(void)
{
    g_assert_cmpfloat(tinker_tableau_join_errors(0.0, 0.0), ==, 0.0);
    g_assert_cmpfloat(fabs(tinker_tableau_join_errors(3.0, 40.0) - 9.0 / 5.0), <, 1e-15);
    g_assert_true(isnan(tinker_tableau_join_errors(NAN, 1.0)));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    const struct {
        const char *name;
        const TinkerTableau *tableau;
    } all[] = {
        {"dopri5", &tinker_tableau_dopri5}, {"dop853", &tinker_tableau_dop853}, {"kutta", &tinker_tableau_kutta}};
    const struct {
        const char *name;
        GTestDataFunc test;
    } tests[] = {{"rows", test_rows},
                 {"order-conditions", test_order_conditions},
                 {"embedded", test_embedded},
                 {"dense-weights", test_dense_weights}};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++)
        for (gsize j = 0; j < G_N_ELEMENTS(tests); j++) {
            g_autofree char *path = g_strdup_printf("/numerics/tableau/%s/%s", all[i].name, tests[j].name);
            g_test_add_data_func(path, all[i].tableau, tests[j].test);
        }
    g_test_add_func("/numerics/tableau/joined-errors", test_joined_errors);
    return g_test_run();
}

/* The kernel of merged lines: forces against extended precision, and the same bits whichever way it takes. */
#include <math.h>
#include <string.h>

#include "physics/force/forces.h"
#include "physics/model/model-data.h"

#define POINTS     37
#define MOST_LINES 203

typedef struct {
    int32_t a[MOST_LINES], b[MOST_LINES];
    double stiffness[MOST_LINES], length[MOST_LINES], damping[MOST_LINES], tension[MOST_LINES];
    TinkerPoint points[POINTS];
} Net;

static double pick(GRand *random, double size)
{
    return g_rand_double_range(random, -size, size) * pow(10, g_rand_double_range(random, -3, 3));
}

static void make_net(GRand *random, Net *net)
{
    for (int i = 0; i < POINTS; i++)
        net->points[i] = (TinkerPoint){pick(random, 1), pick(random, 1), pick(random, 5), pick(random, 5)};
    /* Two places that coincide: such a line has no direction. */
    net->points[1].x = net->points[0].x;
    net->points[1].y = net->points[0].y;
    for (int i = 0; i < MOST_LINES; i++) {
        net->a[i] = g_rand_int_range(random, 0, POINTS);
        net->b[i] = (net->a[i] + g_rand_int_range(random, 1, POINTS)) % POINTS;
        if (i % 17 == 0) net->a[i] = 0, net->b[i] = 1;
        net->stiffness[i] = fabs(pick(random, 100));
        net->length[i] = fabs(pick(random, 1));
        net->damping[i] = i % 3 == 0 ? 0 : fabs(pick(random, 10));
        net->tension[i] = i % 2 == 0 ? 0 : pick(random, 3);
    }
}

static TinkerMergedLines lines_of(Net *net, int first, int count, gboolean damped)
{
    return (TinkerMergedLines){
        .count = count,
        .a = net->a + first,
        .b = net->b + first,
        .stiffness = net->stiffness + first,
        .length = net->length + first,
        .damping = net->damping + first,
        .tension = net->tension + first,
        .any_damping = damped,
    };
}

/* One line at a time never takes the way of four at once. */
static void test_same_bits(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(20);
    Net *net = g_new0(Net, 1);
    for (int count = 0; count <= MOST_LINES; count += count < 12 ? 1 : 19) {
        make_net(random, net);
        double whole[2 * POINTS] = {0}, single[2 * POINTS] = {0}, taken = -1, sum = 0;
        TinkerMergedLines all = lines_of(net, 0, count, TRUE);
        tinker_lines_add_forces(&all, net->points, whole, &taken);
        for (int i = 0; i < count; i++) {
            double part;
            TinkerMergedLines one = lines_of(net, i, 1, TRUE);
            tinker_lines_add_forces(&one, net->points, single, &part);
            sum += part;
        }
        g_assert_cmpmem(whole, sizeof(whole), single, sizeof(single));
        g_assert_cmpmem(&taken, sizeof(taken), &sum, sizeof(sum));
        double quiet[2 * POINTS] = {0};
        tinker_lines_add_forces(&all, net->points, quiet, NULL);
        g_assert_cmpmem(whole, sizeof(whole), quiet, sizeof(quiet));
    }
    g_free(net);
}

/* Sums of the lines' forces in extended precision, and of sizes for the bound on their rounding. */
static void test_forces(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(21);
    Net *net = g_new0(Net, 1);
    make_net(random, net);
    double force[2 * POINTS] = {0}, taken;
    long double exact[2 * POINTS] = {0}, power = 0, sizes[2 * POINTS] = {0}, power_size = 0;
    TinkerMergedLines all = lines_of(net, 0, MOST_LINES, TRUE);
    tinker_lines_add_forces(&all, net->points, force, &taken);
    for (int i = 0; i < MOST_LINES; i++) {
        const TinkerPoint *a = &net->points[net->a[i]], *b = &net->points[net->b[i]];
        long double d[2] = {(long double)b->x - a->x, (long double)b->y - a->y};
        long double w[2] = {(long double)b->vx - a->vx, (long double)b->vy - a->vy}, length = hypotl(d[0], d[1]);
        if (length == 0) continue;
        long double rate = (d[0] * w[0] + d[1] * w[1]) / length;
        long double tension = net->tension[i] + net->stiffness[i] * (length - net->length[i]) + net->damping[i] * rate;
        long double size = fabsl(net->tension[i]) + net->stiffness[i] * (length + net->length[i]) +
                           net->damping[i] * hypotl(w[0], w[1]);
        for (int k = 0; k < 2; k++) {
            exact[2 * net->a[i] + k] += tension * d[k] / length;
            exact[2 * net->b[i] + k] -= tension * d[k] / length;
            sizes[2 * net->a[i] + k] += size;
            sizes[2 * net->b[i] + k] += size;
        }
        power += net->damping[i] * rate * rate;
        power_size += net->damping[i] * (w[0] * w[0] + w[1] * w[1]);
    }
    for (int k = 0; k < 2 * POINTS; k++)
        g_assert_cmpfloat((double)fabsl(force[k] - exact[k]), <=, 1e-14 * (double)sizes[k]);
    g_assert_cmpfloat((double)fabsl(taken - power), <=, 1e-14 * (double)power_size);
    g_free(net);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/physics/lines/same-bits", test_same_bits);
    g_test_add_func("/physics/lines/forces", test_forces);
    return g_test_run();
}

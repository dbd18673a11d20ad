/* Large nets of springs, whose forces threads share: the forces against extended precision, and the same bits however
 * many threads there are. */
#include <math.h>
#include <string.h>

#include "numerics/sharing/sharing.h"
#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

/* Enough masses that every loop over them is shared, enough springs that those are. */
#define SIDE 184

static double scatter(int number)
{
    double multiple = 0.7548776662466927 * number;
    return 0.2 * (multiple - floor(multiple) - 0.5);
}

static void add_spring(GString *text, int a, int b)
{
    g_string_append_printf(text, "{'type': 'spring', 'ends': ['M%d', 'M%d'], 'stiffness': %d, 'rest_length': 1.1},", a,
                           b, 50 + a % 7);
}

/* A square net on which a few masses are held by springs from a support, and a long spring joins its corners. */
static char *net(gboolean driven)
{
    GString *text = g_string_new("{'type': 'support', 'name': 'S', 'position': [-1, 0], 'solid': false},"
                                 "{'type': 'gravity'},");
    for (int i = 0; i < SIDE * SIDE; i++)
        g_string_append_printf(text,
                               "{'type': 'mass', 'name': 'M%d', 'mass': %d, 'position': [%.17g, %.17g], 'width': 0, "
                               "'height': 0},",
                               i, 1 + i % 3, i % SIDE + scatter(2 * i), i / SIDE + scatter(2 * i + 1));
    for (int i = 0; i < SIDE * SIDE; i++) {
        if (i % SIDE < SIDE - 1) add_spring(text, i, i + 1);
        if (i / SIDE < SIDE - 1) add_spring(text, i, i + SIDE);
        if (i % SIDE == 0)
            g_string_append_printf(text,
                                   "{'type': 'spring', 'ends': ['S', 'M%d'], 'stiffness': 9, 'rest_length': 1},"
                                   "{'type': 'damper', 'ends': ['S', 'M%d'], 'damping': 0.3},",
                                   i, i);
    }
    if (driven) g_string_append(text, "{'type': 'motor', 'ends': ['M7'], 'waveform': {'expression': '3*sin(t)'}},");
    add_spring(text, 0, SIDE * SIDE - 1);
    g_string_truncate(text, text->len - 1);
    return g_string_free(text, FALSE);
}

static void test_forces(void)
{
    g_autofree char *blocks = net(FALSE);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    TinkerModel *model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    g_assert_nonnull(model->line_parts);
    gsize n = (gsize)model->coordinates, all = 2 * (gsize)model->points;
    g_autofree double *v = g_new(double, n), *a = g_new(double, n);
    for (gsize i = 0; i < n; i++)
        v[i] = scatter((int)i + 5);
    g_assert_cmpint(tinker_model_set_time(model, 0.0), ==, TINKER_OK);
    tinker_model_set_state(model, model->q_start, v);
    tinker_share_set_threads(4);
    g_assert_cmpint(tinker_model_applied(model, a, TRUE), ==, TINKER_OK);
    g_autofree long double *exact = g_new0(long double, all), *size = g_new0(long double, all);
    long double taken = 0;
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < lines->count; i++) {
        const TinkerPoint *from = &model->point[lines->a[i]], *to = &model->point[lines->b[i]];
        long double d[2] = {(long double)to->x - from->x, (long double)to->y - from->y}, length = hypotl(d[0], d[1]);
        long double rate = (d[0] * ((long double)to->vx - from->vx) + d[1] * ((long double)to->vy - from->vy)) / length;
        long double tension =
            lines->tension[i] + lines->stiffness[i] * (length - lines->length[i]) + lines->damping[i] * rate;
        for (int k = 0; k < 2; k++) {
            exact[2 * lines->a[i] + k] += tension * d[k] / length;
            exact[2 * lines->b[i] + k] -= tension * d[k] / length;
            size[2 * lines->a[i] + k] += lines->stiffness[i] * (length + lines->length[i]) + lines->damping[i];
            size[2 * lines->b[i] + k] += lines->stiffness[i] * (length + lines->length[i]) + lines->damping[i];
        }
        taken += lines->damping[i] * rate * rate;
    }
    for (gsize i = 0; i < all; i++)
        g_assert_cmpfloat((double)fabsl(model->force[i] - exact[i]), <=, 1e-14 * (double)size[i]);
    g_assert_cmpfloat((double)fabsl(-model->book_power[TINKER_BOOK_DAMPERS] - taken), <=, 1e-13 * (double)taken);
    tinker_model_free(model);
}

/* With a motor there are forces besides those of lines. */
static void compare_runs(gconstpointer driven)
{
    const PhysicsOptions options = {.method = "rk4", .step = 0.01, .duration = 0.03, .interval = 0.03};
    g_autofree char *blocks = net(driven != NULL);
    tinker_share_set_threads(1);
    g_autoptr(PhysicsRun) alone = physics_run(&options, "%s", blocks);
    for (int threads = 2; threads <= 5; threads += 3) {
        tinker_share_set_threads(threads);
        g_autoptr(PhysicsRun) together = physics_run(&options, "%s", blocks);
        physics_assert_same_bits(alone, together);
        g_assert_cmpmem(alone->summary->books, sizeof(alone->summary->books), together->summary->books,
                        sizeof(together->summary->books));
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/threads/forces", test_forces);
    g_test_add_data_func("/physics/threads/same-bits", NULL, compare_runs);
    g_test_add_data_func("/physics/threads/same-bits-driven", "driven", compare_runs);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

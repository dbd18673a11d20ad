/* The trade against closed forms: orders, errors that are the true ones, and when there are none to tell. */
#include <math.h>
#include <string.h>

#include "trade-fixture.h"

#define MOST_RERUN 0.02 /* s: slower rows are not run again */

/* Given more time until it is fine enough: how long that is depends on the machine. */
static TinkerTrade *trade_until(TinkerScene *scene, TinkerTradeOptions *options,
                                gboolean (*is_fine)(const TinkerTrade *trade))
{
    for (;; options->seconds *= 4) {
        g_autoptr(TinkerTrade) trade = trade_of(scene, options);
        if (is_fine(trade) || options->seconds > 100) return g_steal_pointer(&trade);
    }
}

/* Orders ----------------------------------------------------------------------------------------------------------- */

static gboolean is_asymptotic(const TinkerTrade *trade)
{
    for (guint i = 0; i < trade->methods->len; i++)
        if (!((const TinkerTradeMethod *)g_ptr_array_index(trade->methods, i))->asymptotic) return FALSE;
    return TRUE;
}

static void test_orders(gconstpointer data)
{
    static const struct {
        const char *method;
        double order;
    } nominal[] = {{"semi-implicit-euler", 1}, {"verlet", 2}, {"rk4", 4}};
    static const char *const methods[] = {"semi-implicit-euler", "verlet", "rk4", NULL};
    const KnownMotion *motion = data;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = trade_options_for(motion->duration);
    options.methods = methods;
    options.seconds = 9;
    g_autoptr(TinkerTrade) trade = trade_until(scene, &options, is_asymptotic);
    g_assert_cmpuint(trade->methods->len, ==, 3);
    for (gsize i = 0; i < G_N_ELEMENTS(nominal); i++) {
        const TinkerTradeMethod *method = trade_method_of(trade, nominal[i].method);
        g_test_message("%s: %.3f", method->id, method->order);
        g_assert_true(method->asymptotic);
        physics_assert_near(method->id, method->order, nominal[i].order, 0.1);
    }
}

/* Errors ----------------------------------------------------------------------------------------------------------- */

#define LEVEL 1e-10 /* of the reference */

static gboolean has_level(const TinkerTrade *trade)
{
    return trade->reference.whole && trade->reference.level < LEVEL;
}

/* What is measured is the true error, to a factor of 2 above the reference's limit; and the limit is one. */
static void test_errors(gconstpointer data)
{
    const KnownMotion *motion = data;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = trade_options_for(motion->duration);
    g_autoptr(TinkerTrade) trade = trade_until(scene, &options, has_level);
    const TinkerTradeReference *reference = &trade->reference;
    g_assert_true(reference->whole);
    g_assert_cmpstr(reference->truth.method, !=, reference->witness.method);
    g_assert_cmpfloat(reference->level, <, LEVEL);
    physics_assert_near("extent", reference->extent, motion->extent, 0.03 * motion->extent);
    physics_assert_near("speed", reference->speed, motion->speed, 0.03 * motion->speed);
    int compared = 0;
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = trade_row_of(method, i);
            if (isnan(row->error) || row->wall_s > MOST_RERUN) continue;
            double truth = trade_true_error(motion, &row->setting, reference->extent, reference->speed);
            g_test_message("%s %g: %.3g, in truth %.3g", method->id, row->setting.value, row->error, truth);
            g_assert_cmpint(row->at_limit, ==, row->error <= reference->level);
            if (row->error > 10 * reference->level) {
                g_assert_cmpfloat(row->error, <, 2 * truth);
                g_assert_cmpfloat(truth, <, 2 * row->error);
                compared++;
            } else {
                g_assert_cmpfloat(truth, <, 20 * reference->level);
            }
        }
    }
    g_assert_cmpint(compared, >=, 20);
}

/* Two methods that part tell so, and up to when they agree: a double pendulum from high up. */
static void test_unpredictable(void)
{
    g_autoptr(TinkerScene) scene = physics_scene(
        NULL, "{'type': 'support', 'solid': false}, {'type': 'gravity'}, {'type': 'mass', 'position': [1, 1]},"
              "{'type': 'mass', 'position': [1.5, 1.8]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
              "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}");
    TinkerTradeOptions options = trade_options_for(60);
    options.seconds = 100; /* far more than it takes: the two methods are to part for no want of time */
    static const char *const methods[] = {"dop853", NULL};
    options.methods = methods;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    g_assert_false(trade->reference.whole);
    g_assert_false(trade->reference.predictable);
    g_assert_cmpfloat(trade->reference.until, <, 60);
    g_assert_cmpfloat(trade->reference.until, >, 1);
    g_assert_cmpfloat(trade->reference.level, <=, 1e-7);
    g_autofree char *text = tinker_trade_reference_text(trade);
    g_assert_nonnull(strstr(text, "the motion is not predictable"));
    /* Up to then errors fall; behind it, runs of any tolerance have nothing to do with one another. */
    const TinkerTradeMethod *method = trade_method_of(trade, "dop853");
    g_assert_cmpfloat(trade_row_of(method, method->rows->len - 1)->error, <, 1e-5);
}

/* What stands still has no error. */
static void test_rest(void)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, "{'type': 'mass', 'position': [3, 4]}");
    TinkerTradeOptions options = trade_options_for(1);
    options.seconds = 1;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeMethod *method = trade_method_of(trade, "rk4");
    g_assert_cmpuint(method->rows->len, >, 0);
    g_assert_cmpfloat(trade_row_of(method, 0)->error, ==, 0);
    g_assert_true(trade_row_of(method, 0)->at_limit);
    g_assert_true(isnan(method->order));
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
}

/* Of the steps that are too large the finest is listed, with the reason; those that are stable follow. */
static void test_diverging(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.1, 0]},"
                            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 1e6}");
    static const char *const methods[] = {"rk4", NULL};
    TinkerTradeOptions options = trade_options_for(1);
    options.methods = methods;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeMethod *method = trade_method_of(trade, "rk4");
    const TinkerTradeRow *first = trade_row_of(method, 0), *second = trade_row_of(method, 1);
    /* stable up to 2 sqrt(2) / 1000 s */
    g_assert_cmpfloat(first->setting.value, >, 2.8284e-3);
    g_assert_cmpfloat(first->setting.value, <=, 2 * 2.8285e-3);
    g_assert_true(isnan(first->error));
    g_assert_nonnull(strstr(first->note, "diverged"));
    g_assert_null(second->note);
    g_assert_false(isnan(second->error));
}

/* A method that does not take the scene has one row, which says why: a rod is not linear, and one without damping at
 * infinite frequency is refused where there are rods. */
static void test_unsuitable(void)
{
    static const char *const methods[] = {"generalized-alpha", "exact", NULL};
    g_autoptr(TinkerScene) scene = physics_scene(NULL, trade_motions[1].blocks);
    TinkerTradeOptions options = trade_options_for(1);
    options.seconds = 1;
    options.methods = methods;
    options.run.spectral_radius = 1;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    for (guint i = 0; i < G_N_ELEMENTS(methods) - 1; i++) {
        const TinkerTradeMethod *method = trade_method_of(trade, methods[i]);
        g_assert_cmpuint(method->rows->len, ==, 1);
        g_assert_true(isnan(trade_row_of(method, 0)->error));
        g_assert_nonnull(trade_row_of(method, 0)->note);
        g_test_message("%s", trade_row_of(method, 0)->note);
    }
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_NONE);
}

/* A disc on a torsional spring turns as a mass on a spring moves, whose place is the disc's radius of gyration times
 * the angle: their errors are alike, step for step. */
static void test_turning(void)
{
    static const char *const blocks[] = {
        "{'type': 'support', 'solid': false}, {'type': 'disc', 'mass': 2, 'radius': 0.5, 'position': [0, 0], "
        "'angular_velocity': 2, 'solid': false}, {'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
        "{'type': 'torsional-spring', 'ends': ['Support 0', 'Disc 0'], 'stiffness': 10}",
        "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 2, 'position': [0, 0], 'velocity': "
        "[0.70710678118654757, 0]}, {'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 80, "
        "'rest_length': 0}"};
    static const char *const methods[] = {"rk4", NULL};
    TinkerTradeOptions options = trade_options_for(2);
    options.methods = methods;
    g_autoptr(TinkerScene) turns = physics_scene(NULL, blocks[0]), moves = physics_scene(NULL, blocks[1]);
    g_autoptr(TinkerTrade) turning = trade_until(turns, &options, has_level),
                           moving = trade_until(moves, &options, has_level);
    const TinkerTradeMethod *disc = trade_method_of(turning, "rk4"), *mass = trade_method_of(moving, "rk4");
    guint compared = 0;
    physics_assert_near("extent", turning->reference.extent, moving->reference.extent, 1e-4);
    for (guint i = 0; i < disc->rows->len; i++)
        for (guint k = 0; k < mass->rows->len; k++) {
            const TinkerTradeRow *one = trade_row_of(disc, i), *other = trade_row_of(mass, k);
            if (one->setting.value != other->setting.value || !(other->error > 100 * LEVEL)) continue;
            physics_assert_near("error", one->error / other->error, 1, 1e-3);
            compared++;
        }
    g_assert_cmpuint(compared, >=, 3);
}

static void add_tests(void)
{
    for (gsize i = 0; i < TRADE_MOTIONS; i++) {
        g_autofree char *orders = g_strdup_printf("/trade/orders/%s", trade_motions[i].name);
        g_autofree char *errors = g_strdup_printf("/trade/errors/%s", trade_motions[i].name);
        g_test_add_data_func(orders, &trade_motions[i], test_orders);
        g_test_add_data_func(errors, &trade_motions[i], test_errors);
    }
    g_test_add_func("/trade/unpredictable", test_unpredictable);
    g_test_add_func("/trade/turning", test_turning);
    g_test_add_func("/trade/rest", test_rest);
    g_test_add_func("/trade/diverging", test_diverging);
    g_test_add_func("/trade/unsuitable", test_unsuitable);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

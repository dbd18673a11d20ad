/* The trade where bodies touch: contact as impulses is measured beside the methods, which have it by events. */
#include "analysis/trade/trade.h"

#include "physics-fixture.h"

/* Slides down a slope without a stop, from rest. */
#define SLIDE                                                                                                          \
    "{'type': 'gravity'}, {'type': 'support', 'orientation': 0.5, 'width': 60, 'height': 0, 'static_friction': 0.2, "  \
    "'dynamic_friction': 0.2}, {'type': 'mass', 'width': 0, 'height': 0}"
#define PENDULUM                                                                                                       \
    "{'type': 'gravity'}, {'type': 'support', 'width': 0.2}, {'type': 'mass', 'position': [1, -1]}, {'type': 'rod', "  \
    "'ends': ['Support 0', 'Mass 0']}"

static TinkerTrade *trade_of(const char *blocks, const char *const *methods, double seconds)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    TinkerTradeOptions options = {
        .run = {.duration = 1.5,
                .interval = 0.1,
                .method = "rk4",
                .step = 0.01,
                .tolerance = 1e-9,
                .spectral_radius = 0.8},
        .methods = methods,
        .error = 1e-6,
        .seconds = seconds,
    };
    g_autoptr(GError) error = NULL;
    TinkerTrade *trade = tinker_trade_new(scene, &options, &error);
    if (trade == NULL) g_error("%s", error->message);
    return trade;
}

static const TinkerTradeMethod *impulse_of(const TinkerTrade *trade)
{
    for (guint i = 0; i < trade->methods->len; i++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, i);
        if (g_str_equal(method->id, "impulse")) return method;
    }
    return NULL;
}

static void test_order(void)
{
    static const char *const methods[] = {"impulse", "rk4", NULL};
    g_autoptr(TinkerTrade) trade = trade_of(SLIDE, methods, 4);
    const TinkerTradeMethod *method = impulse_of(trade);
    g_assert_nonnull(method);
    g_assert_true(method->asymptotic);
    physics_assert_near("the order of impulses", method->order, 1, 0.1);
    for (guint i = 0; i < method->rows->len; i++) {
        const TinkerTradeRow *row = &g_array_index(method->rows, TinkerTradeRow, i);
        g_assert_cmpstr(row->setting.method, ==, "impulse");
        /* of the extent, 9.81 (sin 0.5 - 0.2 cos 0.5) 1.5^2 / 2 = 3.35 m, and the largest speed, 4.47 m/s: a half step
         * late */
        if (row->setting.value < 0.01) g_assert_cmpfloat(row->error, <, row->setting.value);
    }
}

static void test_where_bodies_touch(void)
{
    g_autoptr(TinkerTrade) slides = trade_of(SLIDE, NULL, 2), swings = trade_of(PENDULUM, NULL, 2);
    g_assert_nonnull(impulse_of(slides));
    g_assert_null(impulse_of(swings));
}

/* The advice as it is written into a scene. */
static void test_apply(void)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, SLIDE);
    const TinkerRunSettings *run = &tinker_scene_head(scene)->run;
    TinkerTrade trade = {.advice = {.kind = TINKER_TRADE_ADVICE_MET, .row = {.setting = {"impulse", FALSE, 0.004}}}};
    g_autofree char *method = g_strdup(run->method);
    tinker_trade_apply(&trade, scene);
    g_assert_cmpstr(run->contacts, ==, "impulse");
    g_assert_cmpstr(run->method, ==, method);
    g_assert_cmpfloat(run->step, ==, 0.004);
    g_assert_true(tinker_run_options_of(scene).impulses);
    trade.advice.row.setting = (TinkerTradeSetting){"verlet", FALSE, 0.002};
    tinker_trade_apply(&trade, scene);
    g_assert_cmpstr(run->contacts, ==, "events");
    g_assert_cmpstr(run->method, ==, "verlet");
    g_assert_false(tinker_run_options_of(scene).impulses);
}

static void add_tests(void)
{
    g_test_add_func("/analysis/trade-impulse/order", test_order);
    g_test_add_func("/analysis/trade-impulse/where-bodies-touch", test_where_bodies_touch);
    g_test_add_func("/analysis/trade-impulse/apply", test_apply);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

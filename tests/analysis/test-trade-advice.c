/* The advice of a trade: it is kept to by the closed form, also where the trade was ended early. */
#include <math.h>
#include <string.h>

#include "trade-fixture.h"

/* The advised run keeps to the error by the closed form, and no measured one that does is cheaper. */
static void test_advice(gconstpointer data)
{
    const KnownMotion *motion = data;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = trade_options_for(motion->duration);
    options.error = 3e-5;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeRow *advised = &trade->advice.row;
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpfloat(advised->error, <=, options.error);
    double truth = trade_true_error(motion, &advised->setting, trade->reference.extent, trade->reference.speed);
    g_assert_cmpfloat(truth, <=, options.error + trade->reference.level);
    guint marked = 0;
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = trade_row_of(method, i);
            if (row->advised) marked++;
            if (row->error <= options.error) g_assert_cmpfloat(advised->wall_s, <=, 2 * row->wall_s);
        }
    }
    g_assert_cmpuint(marked, ==, 1);

    tinker_trade_apply(trade, scene);
    const TinkerRunSettings *run = &tinker_scene_head(scene)->run;
    g_assert_cmpstr(run->method, ==, advised->setting.method);
    if (advised->setting.value > 0) /* else the method takes neither */
        g_assert_cmpfloat(advised->setting.adaptive ? run->tolerance : run->step, ==, advised->setting.value);
}

static void test_interpolated_advice(void)
{
    const KnownMotion *motion = &trade_motions[0];
    static const char *const methods[] = {"semi-implicit-euler", NULL};
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = trade_options_for(motion->duration);
    options.methods = methods;
    options.error = 1.9e-3;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeSetting *advised = &trade->advice.row.setting;
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpfloat(trade->advice.row.error, <=, options.error);
    g_assert_cmpfloat(trade_true_error(motion, advised, trade->reference.extent, trade->reference.speed), <=,
                      options.error);
    const TinkerTradeMethod *method = trade_method_of(trade, "semi-implicit-euler");
    for (guint i = 1; i < method->rows->len; i++)
        g_assert_cmpfloat(trade_row_of(method, i)->setting.value, <, trade_row_of(method, i - 1)->setting.value);
}

static void test_budget(void)
{
    const KnownMotion *motion = &trade_motions[1];
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = trade_options_for(motion->duration);
    options.budget = 0.01;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeRow *advised = &trade->advice.row;
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpfloat(advised->wall_s, <=, options.budget);
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = trade_row_of(method, i);
            if (!(row->wall_s <= options.budget) || row->at_limit) continue;
            g_assert_cmpfloat(1.1 * row->error, >=, advised->error);
        }
    }
    options.budget = 1e-9;
    static const char *const methods[] = {"rk4", NULL};
    options.methods = methods;
    options.seconds = 1;
    g_autoptr(TinkerTrade) hurried = trade_of(scene, &options);
    g_assert_cmpint(hurried->advice.kind, ==, TINKER_TRADE_ADVICE_NEAREST);
    g_autofree char *text = tinker_trade_advice_text(hurried, &options);
    g_assert_true(g_str_has_prefix(text, "Nothing measured runs within 1 ns. The fastest is rk4"));
}

static void test_unknown_method(void)
{
    static const char *const methods[] = {"verlet", "rk5", NULL};
    g_autoptr(TinkerScene) scene = physics_scene(NULL, trade_motions[0].blocks);
    TinkerTradeOptions options = trade_options_for(1);
    options.methods = methods;
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_trade_new(scene, &options, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD);
    g_assert_nonnull(strstr(error->message, "did you mean \"rk4\"?"));
}

static void keep_share(double share, void *data)
{
    double *kept = data;
    g_assert_cmpfloat(share, >=, *kept - 1e-12);
    g_assert_cmpfloat(share, <=, 1);
    *kept = share;
}

static gboolean is_half_way(void *data)
{
    return *(double *)data > 0.5;
}

static gboolean at_once(void *data)
{
    return TRUE;
}

static void test_cancel(void)
{
    static const char *const methods[] = {"rk4", "verlet", "dop853", NULL};
    g_autoptr(TinkerScene) scene = physics_scene(NULL, trade_motions[0].blocks);
    TinkerTradeOptions options = trade_options_for(trade_motions[0].duration);
    double share = 0;
    options.methods = methods;
    options.progress = keep_share;
    options.cancelled = is_half_way;
    options.data = &share;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    g_assert_true(trade->interrupted);
    g_assert_cmpuint(trade_method_of(trade, "rk4")->rows->len, >, 3);
    g_assert_cmpuint(trade_method_of(trade, "dop853")->rows->len, ==, 0);
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpstr(trade->advice.row.setting.method, ==, "rk4");

    options.progress = NULL;
    options.cancelled = at_once;
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_trade_new(scene, &options, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED);
}

static void add_tests(void)
{
    for (gsize i = 0; i < TRADE_MOTIONS; i++) {
        g_autofree char *advice = g_strdup_printf("/trade-advice/known/%s", trade_motions[i].name);
        g_test_add_data_func(advice, &trade_motions[i], test_advice);
    }
    g_test_add_func("/trade-advice/interpolated", test_interpolated_advice);
    g_test_add_func("/trade-advice/budget", test_budget);
    g_test_add_func("/trade-advice/unknown-method", test_unknown_method);
    g_test_add_func("/trade-advice/cancel", test_cancel);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

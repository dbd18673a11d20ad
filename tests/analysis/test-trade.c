/* The trade against closed forms: orders, errors that are the true ones, advice that is kept to. */
#include "analysis/trade/trade.h"

#include <math.h>
#include <string.h>

#include "physics-fixture.h"
#include "test-systems.h"

#define SAMPLES    500  /* of a trade that was given no times */
#define MOST_RERUN 0.02 /* s: slower rows are not run again */

/* A scene whose motion is known: place and velocity of "Mass 0", extent of the motion and largest speed. */
typedef struct {
    const char *name, *blocks;
    double duration;
    void (*exact)(double t, double state[4]);
    double extent, speed;
} KnownMotion;

/* Unit mass on a spring of 4 N/m at 2 m from its support along x; x(0) = 0.5, v(0) = 0.2. */
static void oscillator_state(double t, double state[4])
{
    state[0] = 0.5 * cos(2 * t) + 0.1 * sin(2 * t);
    state[2] = -1.0 * sin(2 * t) + 0.2 * cos(2 * t);
    state[1] = state[3] = 0;
}

/* Let go at rest, 2 rad from hanging down, on a rod of 1.3 m. */
static void pendulum_state(double t, double state[4])
{
    Pendulum pendulum;
    pendulum_init(&pendulum, 1.3, 9.81, 2.0, 0.0);
    pendulum_exact(&pendulum, t, state, state + 2);
}

/* Extents: the support at -2 m and the amplitude sqrt(0.26) m; the circle's width, and its height from the support's
 * side at 2 rad to the bottom. Speeds: 2 sqrt(0.26) m/s; that of a fall of 1.3 (1 - cos 2) m. */
static const KnownMotion motions[] = {
    {"oscillator",
     "{'type': 'support', 'solid': false, 'position': [-2, 0]}, {'type': 'mass', 'position': [0.5, 0], 'velocity': "
     "[0.2, 0]},"
     "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2, 'stiffness': 4}",
     6, oscillator_state, 2.509902, 1.019804},
    {"pendulum",
     "{'type': 'support', 'solid': false}, {'type': 'gravity'},"
     "{'type': 'mass', 'position': [1.1820866548733862, 0.5409908875112851]},"
     "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 1.3}",
     6, pendulum_state, 3.186, 6.010},
};

static TinkerTradeOptions options_for(double duration)
{
    return (TinkerTradeOptions){
        .run = {.duration = duration,
                .interval = 0.1,
                .method = "rk4",
                .step = 0.01,
                .tolerance = 1e-9,
                .spectral_radius = 0.8},
        .error = 1e-6,
        .seconds = 3,
    };
}

static TinkerTrade *trade_of(TinkerScene *scene, const TinkerTradeOptions *options)
{
    g_autoptr(GError) error = NULL;
    TinkerTrade *trade = tinker_trade_new(scene, options, &error);
    if (trade == NULL) g_error("%s", error->message);
    return trade;
}

static const TinkerTradeMethod *method_of(const TinkerTrade *trade, const char *id)
{
    for (guint i = 0; i < trade->methods->len; i++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, i);
        if (g_str_equal(method->id, id)) return method;
    }
    g_error("%s was not measured", id);
}

static const TinkerTradeRow *row_of(const TinkerTradeMethod *method, guint i)
{
    return &g_array_index(method->rows, TinkerTradeRow, i);
}

/* The error by the closed form, of a run of its own. */
static double true_error(const KnownMotion *motion, const TinkerTradeSetting *setting, double extent, double speed)
{
    double times[SAMPLES], largest = 0;
    for (int i = 0; i < SAMPLES; i++)
        times[i] = motion->duration * (i + 1) / SAMPLES;
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = setting->method,
                                                              .duration = motion->duration,
                                                              .step = setting->adaptive ? 0 : setting->value,
                                                              .tolerance = setting->adaptive ? setting->value : 0,
                                                              .at = times,
                                                              .at_count = SAMPLES,
                                                              .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy"},
                                            "%s", motion->blocks);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double exact[4], sum = 0;
        motion->exact(physics_time(run, i), exact);
        for (gsize k = 0; k < 4; k++) {
            double part = (physics_value(run, i, k) - exact[k]) / (k < 2 ? extent : speed);
            sum += part * part;
        }
        largest = fmax(largest, sqrt(sum));
    }
    return largest;
}

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
    TinkerTradeOptions options = options_for(motion->duration);
    options.methods = methods;
    options.seconds = 9;
    g_autoptr(TinkerTrade) trade = trade_until(scene, &options, is_asymptotic);
    g_assert_cmpuint(trade->methods->len, ==, 3);
    for (gsize i = 0; i < G_N_ELEMENTS(nominal); i++) {
        const TinkerTradeMethod *method = method_of(trade, nominal[i].method);
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
    TinkerTradeOptions options = options_for(motion->duration);
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
            const TinkerTradeRow *row = row_of(method, i);
            if (isnan(row->error) || row->wall_s > MOST_RERUN) continue;
            double truth = true_error(motion, &row->setting, reference->extent, reference->speed);
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
    TinkerTradeOptions options = options_for(60);
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
    const TinkerTradeMethod *method = method_of(trade, "dop853");
    g_assert_cmpfloat(row_of(method, method->rows->len - 1)->error, <, 1e-5);
}

/* What stands still has no error. */
static void test_rest(void)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, "{'type': 'mass', 'position': [3, 4]}");
    TinkerTradeOptions options = options_for(1);
    options.seconds = 1;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeMethod *method = method_of(trade, "rk4");
    g_assert_cmpuint(method->rows->len, >, 0);
    g_assert_cmpfloat(row_of(method, 0)->error, ==, 0);
    g_assert_true(row_of(method, 0)->at_limit);
    g_assert_true(isnan(method->order));
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
}

/* Advice ----------------------------------------------------------------------------------------------------------- */

/* The advised run keeps to the error by the closed form, and no measured one that does is cheaper. */
static void test_advice(gconstpointer data)
{
    const KnownMotion *motion = data;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = options_for(motion->duration);
    options.error = 3e-5;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeRow *advised = &trade->advice.row;
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpfloat(advised->error, <=, options.error);
    double truth = true_error(motion, &advised->setting, trade->reference.extent, trade->reference.speed);
    g_assert_cmpfloat(truth, <=, options.error + trade->reference.level);
    guint marked = 0;
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = row_of(method, i);
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
    const KnownMotion *motion = &motions[0];
    static const char *const methods[] = {"semi-implicit-euler", NULL};
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = options_for(motion->duration);
    options.methods = methods;
    options.error = 1.9e-3;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeSetting *advised = &trade->advice.row.setting;
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpfloat(trade->advice.row.error, <=, options.error);
    g_assert_cmpfloat(true_error(motion, advised, trade->reference.extent, trade->reference.speed), <=, options.error);
    const TinkerTradeMethod *method = method_of(trade, "semi-implicit-euler");
    for (guint i = 1; i < method->rows->len; i++)
        g_assert_cmpfloat(row_of(method, i)->setting.value, <, row_of(method, i - 1)->setting.value);
}

static void test_budget(void)
{
    const KnownMotion *motion = &motions[1];
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motion->blocks);
    TinkerTradeOptions options = options_for(motion->duration);
    options.budget = 0.01;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeRow *advised = &trade->advice.row;
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpfloat(advised->wall_s, <=, options.budget);
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = row_of(method, i);
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

/* Failures --------------------------------------------------------------------------------------------------------- */

/* Of the steps that are too large the finest is listed, with the reason; those that are stable follow. */
static void test_diverging(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.1, 0]},"
                            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 1e6}");
    static const char *const methods[] = {"rk4", NULL};
    TinkerTradeOptions options = options_for(1);
    options.methods = methods;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    const TinkerTradeMethod *method = method_of(trade, "rk4");
    const TinkerTradeRow *first = row_of(method, 0), *second = row_of(method, 1);
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
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motions[1].blocks);
    TinkerTradeOptions options = options_for(1);
    options.seconds = 1;
    options.methods = methods;
    options.run.spectral_radius = 1;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    for (guint i = 0; i < G_N_ELEMENTS(methods) - 1; i++) {
        const TinkerTradeMethod *method = method_of(trade, methods[i]);
        g_assert_cmpuint(method->rows->len, ==, 1);
        g_assert_true(isnan(row_of(method, 0)->error));
        g_assert_nonnull(row_of(method, 0)->note);
        g_test_message("%s", row_of(method, 0)->note);
    }
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_NONE);
}

static void test_unknown_method(void)
{
    static const char *const methods[] = {"verlet", "rk5", NULL};
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motions[0].blocks);
    TinkerTradeOptions options = options_for(1);
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
    g_autoptr(TinkerScene) scene = physics_scene(NULL, motions[0].blocks);
    TinkerTradeOptions options = options_for(motions[0].duration);
    double share = 0;
    options.methods = methods;
    options.progress = keep_share;
    options.cancelled = is_half_way;
    options.data = &share;
    g_autoptr(TinkerTrade) trade = trade_of(scene, &options);
    g_assert_true(trade->interrupted);
    g_assert_cmpuint(method_of(trade, "rk4")->rows->len, >, 3);
    g_assert_cmpuint(method_of(trade, "dop853")->rows->len, ==, 0);
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
    for (gsize i = 0; i < G_N_ELEMENTS(motions); i++) {
        g_autofree char *orders = g_strdup_printf("/trade/orders/%s", motions[i].name);
        g_autofree char *errors = g_strdup_printf("/trade/errors/%s", motions[i].name);
        g_autofree char *advice = g_strdup_printf("/trade/advice/%s", motions[i].name);
        g_test_add_data_func(orders, &motions[i], test_orders);
        g_test_add_data_func(errors, &motions[i], test_errors);
        g_test_add_data_func(advice, &motions[i], test_advice);
    }
    g_test_add_func("/trade/unpredictable", test_unpredictable);
    g_test_add_func("/trade/rest", test_rest);
    g_test_add_func("/trade/interpolated-advice", test_interpolated_advice);
    g_test_add_func("/trade/budget", test_budget);
    g_test_add_func("/trade/diverging", test_diverging);
    g_test_add_func("/trade/unsuitable", test_unsuitable);
    g_test_add_func("/trade/unknown-method", test_unknown_method);
    g_test_add_func("/trade/cancel", test_cancel);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}

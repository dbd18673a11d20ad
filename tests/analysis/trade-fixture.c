#include "trade-fixture.h"

#include <math.h>

#include "test-systems.h"

#define SAMPLES 500 /* of a trade that was given no times */

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
const KnownMotion trade_motions[TRADE_MOTIONS] = {
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

TinkerTradeOptions trade_options_for(double duration)
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

TinkerTrade *trade_of(TinkerScene *scene, const TinkerTradeOptions *options)
{
    g_autoptr(GError) error = NULL;
    TinkerTrade *trade = tinker_trade_new(scene, options, &error);
    if (trade == NULL) g_error("%s", error->message);
    return trade;
}

const TinkerTradeMethod *trade_method_of(const TinkerTrade *trade, const char *id)
{
    for (guint i = 0; i < trade->methods->len; i++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, i);
        if (g_str_equal(method->id, id)) return method;
    }
    g_error("%s was not measured", id);
}

const TinkerTradeRow *trade_row_of(const TinkerTradeMethod *method, guint i)
{
    return &g_array_index(method->rows, TinkerTradeRow, i);
}

double trade_true_error(const KnownMotion *motion, const TinkerTradeSetting *setting, double extent, double speed)
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

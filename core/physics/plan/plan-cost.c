/* What steps methods need for a tolerance, and what they miss by then; the operations of these are counted in
 * operations.c. The constants were measured once and never again, as there. */
#include "physics/plan/plan-cost.h"

#include <math.h>

#include "numerics/exact/exact.h"
#include "physics/impulse/impulse.h"
#include "physics/line/linear-form.h"
#include "physics/plan/operations.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/row-operations.h"
#include "physics/plan/tolerances.h"
#include "physics/system/method-call.h"

/* Newton steps of a step, before any are counted. */
#define CORRECTIONS 1.0
/* Nonlinear motion gets faster than its start: pendulums, chains and linkages of the bundled scenes by about this. */
#define NONLINEAR_HASTE 4.0
/* Local errors that a run adds up are measured over this many radians. */
#define CALIBRATION_RADIANS 628.0

/* Of adaptive methods, measured on an oscillator: steps a radian at the tolerance 1e-9, which go with the tolerance to
 * the power -1 / root; and the error after CALIBRATION_RADIANS in units of the tolerance. */
typedef struct {
    const char *id;
    double steps, root, error;
} Adaptive;

static const Adaptive adaptives[] = {
    {"dop853", 2.98, 8, 1.0},
    {"dopri5", 25.8, 5, 17.0},
};

/* Explicit, adaptive ----------------------------------------------------------------------------------------------- */

static Adaptive adaptive_of(const TinkerIntegrator *method)
{
    for (gsize i = 0; i < G_N_ELEMENTS(adaptives); i++)
        if (g_str_equal(adaptives[i].id, method->id)) return adaptives[i];
    return (Adaptive){method->id, 3.0, MAX(method->order, 1), 10.0};
}

/* The frequency that decides the steps: local errors of a part go with the root of its energy and with omega^(p + 1).
 * What holds less than the tolerance cannot miss by more. */
static double deciding_frequency(const TinkerIsland *island, const TinkerForecast *forecast, double order,
                                 double tolerance)
{
    double sum = 0, greatest = 0;
    for (int32_t i = 0; i < forecast->count; i++)
        if (forecast->parts[i].share > tolerance * tolerance) greatest = fmax(greatest, forecast->parts[i].omega);
    for (int32_t i = 0; i < forecast->count && greatest > 0; i++)
        if (forecast->parts[i].share > tolerance * tolerance)
            sum += sqrt(forecast->parts[i].share) * pow(forecast->parts[i].omega / greatest, order + 1);
    double frequency = greatest > 0 ? greatest * pow(sum, 1 / (order + 1)) : 0;
    double haste = island->linear != NULL ? 1.0 : NONLINEAR_HASTE;
    return fmax(frequency, fmax(forecast->drive, haste * forecast->speed_of_change));
}

/* Steps a second that stability asks for. An adaptive method whose limit on the imaginary axis is 0 or small creeps out
 * of its region there too slowly to matter: its limit on the real axis counts. */
static double stability_rate(const TinkerForecast *forecast, const TinkerIntegrator *method)
{
    double rate = 0;
    if (method->imaginary_limit >= 0)
        rate = forecast->omega_max / fmax(method->imaginary_limit, fmax(method->real_limit, 1e-3));
    if (method->real_limit > 0) rate = fmax(rate, forecast->damping_max / method->real_limit);
    return rate;
}

static void cost_adaptive(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                          const TinkerRunOptions *options, double tolerance, TinkerCost *cost)
{
    Adaptive known = adaptive_of(method);
    double duration = tinker_options_span(options),
           frequency = deciding_frequency(island, forecast, known.root, tolerance);
    double accuracy = frequency * known.steps * pow(1e-9 / tolerance, 1 / known.root);
    gboolean limited = (method->flags & TINKER_INTEGRATOR_EXPLICIT) != 0;
    double rate = fmax(accuracy, limited ? stability_rate(forecast, method) : 0);
    cost->steps = fmax(1.0, duration * rate);
    cost->evaluations = cost->steps * method->evaluations_per_step;
    cost->operations = tinker_operations_explicit(island, cost->steps, cost->evaluations) +
                       CORRECTIONS * cost->steps * tinker_row_operations_of_correction(island->model);
    cost->sample = tinker_operations_sample(island);
    cost->error = tolerance * known.error * fmax(1.0, frequency * duration / CALIBRATION_RADIANS);
}

double tinker_free_tolerance(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                             double tolerance)
{
    Adaptive known = adaptive_of(method);
    if (!(method->flags & TINKER_INTEGRATOR_EXPLICIT) || tolerance <= TINKER_FREE_TOLERANCE) return tolerance;
    double stability = stability_rate(forecast, method);
    double accuracy = known.steps * deciding_frequency(island, forecast, known.root, tolerance);
    if (!(stability > accuracy * pow(1e-9 / tolerance, 1 / known.root))) return tolerance;
    double free = tinker_round_down(1e-9 * pow(accuracy / stability, known.root));
    return fmin(tolerance, fmax(TINKER_FREE_TOLERANCE, free));
}

/* The method is tried on the oscillator: it may be a plugin's. */
static double step_error(const TinkerIntegrator *method, const TinkerRunOptions *options, TinkerOscillator oscillator,
                         double step)
{
    double error, duration = tinker_options_span(options);
    TINKER_CALL_VOID(error = tinker_step_error(method, options->spectral_radius, oscillator, step, duration),
                     .phase = "step", .method = method);
    return error;
}

/* Fixed steps ------------------------------------------------------------------------------------------------------ */

/* Of displacements, relative to those of the motion. Velocities of parts that are fast and hold little are off by more,
 * which is what a method that steps across them is for. */
static double fixed_error(const TinkerForecast *forecast, const TinkerIntegrator *method,
                          const TinkerRunOptions *options, double step)
{
    double square = 0, duration = tinker_options_span(options);
    method = tinker_method_without_contact(method);
    for (int32_t i = 0; i < forecast->count; i++) {
        const TinkerForecastPart *part = &forecast->parts[i];
        if (part->omega == 0) continue;
        TinkerOscillator oscillator = {part->omega * part->omega, part->damping};
        double error = step_error(method, options, oscillator, step);
        square += part->reach * fmin(error * error, 4);
    }
    /* what no part says: the motion turns, and what nothing holds is slowed down */
    const TinkerOscillator whole[] = {{forecast->turning * forecast->turning, 0}, {0, forecast->fading}};
    for (gsize i = 0; i < G_N_ELEMENTS(whole); i++) {
        if (whole[i].stiffness == 0 && whole[i].damping == 0) continue;
        double error = step_error(method, options, whole[i], step);
        square += fmin(error * error, 4);
    }
    return fmax(sqrt(square), 0x1p-52 * duration / step);
}

/* The fastest part whose error would be seen at all. */
static double fastest_seen(const TinkerForecast *forecast, double tolerance)
{
    double fastest = fmax(fmax(forecast->drive, forecast->fading), fmax(forecast->speed_of_change, forecast->turning));
    for (int32_t i = 0; i < forecast->count; i++)
        if (sqrt(forecast->parts[i].reach) > tolerance) fastest = fmax(fastest, forecast->parts[i].omega);
    return fastest;
}

/* The step at which a method of order p meets the tolerance: from the error at one step by its order, a few times, as
 * the order holds for small steps alone. */
static double wanted_step(const TinkerForecast *forecast, const TinkerIntegrator *method,
                          const TinkerRunOptions *options, double tolerance)
{
    double duration = tinker_options_span(options), frequency = fastest_seen(forecast, tolerance);
    if (!(frequency > 0)) return duration;
    double step = fmin(duration, 0.05 / frequency), most = fmin(duration, TINKER_LEAST_RESOLVED / frequency);
    for (int trial = 0; trial < 3; trial++) {
        double error = fixed_error(forecast, method, options, step);
        double factor = error > 0 ? pow(tolerance / error, 1.0 / MAX(method->order, 1)) : 10;
        step = fmin(most, step * CLAMP(factor, 1e-6, 10));
    }
    return step;
}

static void cost_fixed(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                       const TinkerRunOptions *options, double tolerance, TinkerCost *cost)
{
    gboolean implicit = (method->flags & TINKER_INTEGRATOR_IMPLICIT) != 0;
    if (!(cost->step > 0)) cost->step = wanted_step(forecast, method, options, tolerance);
    cost->steps = fmax(1.0, tinker_options_span(options) / cost->step);
    cost->evaluations = cost->steps * method->evaluations_per_step;
    cost->operations = implicit ? cost->steps * tinker_operations_implicit(island)
                                : tinker_operations_explicit(island, cost->steps, cost->evaluations);
    cost->operations += CORRECTIONS * cost->steps * tinker_row_operations_of_correction(island->model);
    cost->sample = tinker_operations_sample(island);
    cost->error = fixed_error(forecast, method, options, cost->step);
}

/* Exact ------------------------------------------------------------------------------------------------------------ */

double tinker_cost_interval(const TinkerIsland *island, const TinkerRunOptions *options)
{
    double span = tinker_options_span(options);
    return tinker_exact_interval(tinker_linear_form_system(island->linear), tinker_forecast_drive(island->linear),
                                 span > 0 ? span : 1.0);
}

static void cost_exact(const TinkerIsland *island, const TinkerRunOptions *options, TinkerCost *cost)
{
    const TinkerLinearSystem *linear = tinker_linear_form_system(island->linear);
    cost->steps = ceil(tinker_options_span(options) / tinker_cost_interval(island, options));
    cost->operations = tinker_operations_exact(island, cost->steps);
    cost->sample = tinker_operations_exact_sample(island);
    cost->error = tinker_exact_claimed_error(linear, tinker_options_span(options));
}

gboolean tinker_cost_of(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                        const TinkerRunOptions *options, double step, double tolerance, TinkerCost *cost)
{
    *cost = (TinkerCost){.step = step};
    if (method->flags & TINKER_INTEGRATOR_LINEAR) {
        if (island->linear == NULL || !tinker_exact_suits(tinker_linear_form_system(island->linear))) return FALSE;
        cost->step = 0;
        cost_exact(island, options, cost);
    } else if (tinker_method_is_adaptive(method)) {
        cost->step = 0;
        cost_adaptive(island, forecast, method, options, tolerance, cost);
    } else {
        cost_fixed(island, forecast, method, options, tolerance, cost);
    }
    return TRUE;
}

double tinker_round_down(double x)
{
    if (!(x > 0) || !isfinite(x)) return x;
    double unit = pow(10, floor(log10(x)) - 1), down = floor(x / unit * (1 + 1e-12)) * unit;
    /* by its decimal text, so that it is the number that is typed */
    g_autofree char *text = g_strdup_printf("%.1e", down);
    return g_ascii_strtod(text, NULL);
}

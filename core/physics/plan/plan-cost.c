/* Operation counts of whole runs. The constants were measured once, on one machine, by runs of an oscillator, of a
 * stiff chain of fifty masses and of the bundled scenes; they are written down here and never measured again, so that a
 * choice that rests on them is the same everywhere and always. One operation stands for TINKER_SECONDS_PER_OPERATION
 * there. */
#include <math.h>

#include "numerics/exact/exact.h"
#include "numerics/solve/sparse-ldl.h"
#include "physics/constraint/tolerances.h"
#include "physics/impulse/impulse.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/run-options.h"
#include "physics/plan/tolerances.h"
#include "physics/system/method-call.h"

/* Of one evaluation: whatever there is, and for each part of the model. */
#define PER_EVALUATION 140.0
#define PER_LINE       14.0
#define PER_BODY       8.0
#define PER_ASKED      80.0 /* an instance whose plugin is asked */
#define PER_FIELD_BODY 24.0 /* each asked field, a body */
#define PER_EDGE       8.0  /* of a linear form */
/* Of constraint rows: Jacobian, factor, solve; along a chain of rods, and of bodies that pins tie. */
#define PER_ROD_ROW 45.0
#define PER_PIN_ROW 110.0
/* Of rows that are solved by the general factor. */
#define PER_JACOBIAN 48.0 /* a row, by itself */
#define PER_PRODUCT  4.0  /* an entry's with another's */
#define PER_UPDATE   3.0  /* what a column takes off another of the factor */
#define PER_FILL     16.0 /* an entry of the factor, in each round of a solve */
#define PER_ENTRY    8.0  /* an entry of the Jacobian, likewise */
/* Solves within a run take fewer rounds than one for any motion; refining many rows adds a share of them. */
#define ROUNDS_WITHIN  0.6
#define REFINED_ROUNDS 1.5
/* Of one step: watching it, and for each coordinate the method's own sums over its stages. */
#define PER_STEP             60.0
#define PER_STAGE_COORDINATE 4.0
/* Bringing a step back onto constraint rows, and each Newton step for it. Of a chain, a row, whose factor is at hand;
 * of other rows this share of evaluating them. */
#define PER_ROD_PROJECTION 55.0
#define PER_ROD_CORRECTION 30.0
#define PER_PIN_PROJECTION 20.0
#define PER_PIN_CORRECTION 85.0
#define PROJECTION         0.5
#define CORRECTION         1.0
/* Newton steps of a step, before any are counted. */
#define CORRECTIONS 1.0
/* A sample: dense output. */
#define PER_SAMPLE            80.0
#define PER_SAMPLE_COORDINATE 10.0
/* It is brought onto constraint rows and its accelerations are solved for; then the step's factor is made once more. */
#define SAMPLE_ROWS 2.5
/* An exact solution under forces, or with uneven damping: its series, at a sample and twice in a step. */
#define PER_SERIES      5500.0
#define SERIES_PER_STEP 2.0
/* A state that is looked at in search of contacts. */
#define PER_LOOK 4000.0
/* Newton steps of an implicit method on a law that is not linear, and what the Jacobian costs in evaluations. */
#define NEWTON_STEPS   2.5
#define JACOBIAN_SHARE 4.0
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

static int32_t coordinates(const TinkerIsland *island)
{
    return island->linear != NULL ? tinker_linear_form_system(island->linear)->size : island->model->coordinates;
}

static double asked(const GArray *batches, double per_instance)
{
    double sum = 0;
    for (guint i = 0; i < batches->len; i++)
        sum += per_instance * g_array_index(batches, TinkerAskedBatch, i).batch->count;
    return sum;
}

/* Of the rounds of one solve beside the first. */
static double more_rounds(const TinkerConstraints *all)
{
    return ROUNDS_WITHIN * all->rounds * (all->rows < TINKER_REFINED_ROWS ? 1 : REFINED_ROUNDS);
}

/* Operations that rows take for once which their plugins are asked for. */
static double asked_rows(const TinkerConstraints *all)
{
    double called = 0;
    for (guint i = 0; all->rows > 0 && i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (part->distances == NULL && !part->coincident) called += PER_ASKED * part->batch->count;
    }
    return called;
}

/* Whether rows cost what those of a chain of rods do: each is of one or two points, and their factor has no fill. */
static gboolean are_of_rods(const TinkerConstraints *all)
{
    if (all->chains != NULL || all->rows == 0) return TRUE;
    return all->pin_chains == NULL && all->turn_count == 0 && all->entries <= 2 * all->rows &&
           tinker_sparse_ldl_fill(all->ldl) <= (gsize)all->rows;
}

/* Operations that constraint rows take for once: Jacobian, factor, solve. */
static double row_operations(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    const double called = asked_rows(all);
    if (are_of_rods(all)) return called + PER_ROD_ROW * all->rows;
    if (all->pin_chains != NULL) return called + PER_PIN_ROW * all->rows;
    const double products = (double)(all->product_count + all->turn_product_count),
                 updates = (double)tinker_sparse_ldl_updates(all->ldl), fill = (double)tinker_sparse_ldl_fill(all->ldl);
    return called + PER_JACOBIAN * all->rows + PER_PRODUCT * products + PER_UPDATE * updates +
           (1 + more_rounds(all)) * (PER_FILL * fill + PER_ENTRY * (all->entries + all->turn_count));
}

/* Operations that one Newton step towards constraint rows takes, and what comes before and behind them in a step. */
static double correction_operations(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (are_of_rods(all)) return asked_rows(all) + PER_ROD_CORRECTION * all->rows;
    if (all->pin_chains != NULL) return asked_rows(all) + PER_PIN_CORRECTION * all->rows;
    return CORRECTION * row_operations(model);
}

static double projection_operations(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (are_of_rods(all)) return asked_rows(all) + PER_ROD_PROJECTION * all->rows;
    if (all->pin_chains != NULL) return asked_rows(all) + PER_PIN_PROJECTION * all->rows;
    return PROJECTION * row_operations(model);
}

/* Operations of one evaluation of an island's accelerations. */
static double evaluation_cost(const TinkerIsland *island)
{
    const TinkerModel *model = island->model;
    if (island->linear != NULL) {
        const TinkerLinearSystem *linear = tinker_linear_form_system(island->linear);
        return PER_EVALUATION + PER_EDGE * linear->edge_count + 0.5 * PER_BODY * linear->size;
    }
    return PER_EVALUATION + PER_LINE * model->lines.count + PER_BODY * model->bodies +
           asked(model->asked_lines, PER_ASKED) + asked(model->asked_forces, PER_ASKED) +
           PER_FIELD_BODY * model->asked_fields->len * model->bodies + row_operations(model);
}

static double sample_operations(const TinkerIsland *island)
{
    return PER_SAMPLE + PER_SAMPLE_COORDINATE * coordinates(island) + SAMPLE_ROWS * row_operations(island->model);
}

/* Of so many steps with so many evaluations in them, less their Newton steps towards constraint rows. */
static double explicit_operations(const TinkerIsland *island, double steps, double evaluations)
{
    return steps * (PER_STEP + projection_operations(island->model)) +
           evaluations * (evaluation_cost(island) + PER_STAGE_COORDINATE * coordinates(island));
}

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
    cost->operations = explicit_operations(island, cost->steps, cost->evaluations) +
                       CORRECTIONS * cost->steps * correction_operations(island->model);
    cost->sample = sample_operations(island);
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

/* Of one solve: a chain or tree has a factor of its own size, a mesh one of about the square root's width. */
static double band_width(const TinkerIsland *island)
{
    const TinkerModel *model = island->model;
    double axes = island->linear != NULL && coordinates(island) == model->bodies ? 1 : 2, inner = 0;
    for (int32_t i = 0; i < model->lines.count; i++)
        inner += MAX(model->lines.a[i], model->lines.b[i]) < model->bodies;
    return inner < model->bodies ? axes : axes * sqrt((double)MAX(model->bodies, 1));
}

static double implicit_step_operations(const TinkerIsland *island)
{
    double n = coordinates(island), width = band_width(island), evaluation = evaluation_cost(island);
    double solve = n * (4 * width + 20), factor = n * (2 * width * width + 8);
    if (island->linear != NULL) return PER_STEP + evaluation + solve + PER_STAGE_COORDINATE * n;
    return PER_STEP + NEWTON_STEPS * ((1 + JACOBIAN_SHARE) * evaluation + factor + solve) +
           projection_operations(island->model) + PER_STAGE_COORDINATE * n;
}

static void cost_fixed(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                       const TinkerRunOptions *options, double tolerance, TinkerCost *cost)
{
    gboolean implicit = (method->flags & TINKER_INTEGRATOR_IMPLICIT) != 0;
    if (!(cost->step > 0)) cost->step = wanted_step(forecast, method, options, tolerance);
    cost->steps = fmax(1.0, tinker_options_span(options) / cost->step);
    cost->evaluations = cost->steps * method->evaluations_per_step;
    cost->operations = implicit ? cost->steps * implicit_step_operations(island)
                                : explicit_operations(island, cost->steps, cost->evaluations);
    cost->operations += CORRECTIONS * cost->steps * correction_operations(island->model);
    cost->sample = sample_operations(island);
    cost->error = fixed_error(forecast, method, options, cost->step);
}

/* Exact ------------------------------------------------------------------------------------------------------------ */

double tinker_cost_interval(const TinkerIsland *island, const TinkerRunOptions *options)
{
    double span = tinker_options_span(options);
    return tinker_exact_interval(tinker_linear_form_system(island->linear), tinker_forecast_drive(island->linear),
                                 span > 0 ? span : 1.0);
}

static double exact_operations(const TinkerIsland *island, double steps)
{
    double once = 0;
    double each = tinker_exact_operations(tinker_linear_form_system(island->linear), (gint64)steps, &once);
    return once + each + steps * PER_STEP;
}

/* A sample is one more propagator. */
static double exact_sample_operations(const TinkerIsland *island)
{
    return sample_operations(island) + tinker_exact_operations(tinker_linear_form_system(island->linear), 1, NULL);
}

static void cost_exact(const TinkerIsland *island, const TinkerRunOptions *options, TinkerCost *cost)
{
    const TinkerLinearSystem *linear = tinker_linear_form_system(island->linear);
    cost->steps = ceil(tinker_options_span(options) / tinker_cost_interval(island, options));
    cost->operations = exact_operations(island, cost->steps);
    cost->sample = exact_sample_operations(island);
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

static gboolean needs_series(const TinkerIsland *island)
{
    const TinkerLinearSystem *linear = tinker_linear_form_system(island->linear);
    return linear->force_count + linear->motion_count > 0 || !tinker_exact_is_proportional(linear);
}

TinkerCostRates tinker_cost_rates(const TinkerIsland *island, const TinkerIntegrator *method)
{
    TinkerCostRates rates = {.look = PER_LOOK, .correction = correction_operations(island->model)};
    if (method->flags & TINKER_INTEGRATOR_IMPLICIT) {
        rates.step = implicit_step_operations(island);
        return rates;
    }
    rates.evaluation = explicit_operations(island, 0, 1);
    if (!(method->flags & TINKER_INTEGRATOR_LINEAR)) {
        rates.step = explicit_operations(island, 1, 0);
        return rates;
    }
    const double series = needs_series(island) ? SERIES_PER_STEP * PER_SERIES : 0;
    rates.step = series + PER_STEP + tinker_exact_operations(tinker_linear_form_system(island->linear), 1, &rates.once);
    return rates;
}

double tinker_cost_counted(const TinkerCostRates *rates, const TinkerCounts *counts)
{
    return rates->once + rates->step * counts->steps + rates->evaluation * counts->evaluations +
           rates->look * counts->looks + rates->correction * counts->corrections;
}

double tinker_cost_samples(const TinkerIsland *island, const TinkerIntegrator *method, double samples)
{
    if (!(method->flags & TINKER_INTEGRATOR_LINEAR)) return samples * sample_operations(island);
    const double series = needs_series(island) ? PER_SERIES : 0;
    return samples * (exact_sample_operations(island) + series);
}

double tinker_round_down(double x)
{
    if (!(x > 0) || !isfinite(x)) return x;
    double unit = pow(10, floor(log10(x)) - 1), down = floor(x / unit * (1 + 1e-12)) * unit;
    /* by its decimal text, so that it is the number that is typed */
    g_autofree char *text = g_strdup_printf("%.1e", down);
    return g_ascii_strtod(text, NULL);
}

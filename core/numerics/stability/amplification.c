/* The method steps the oscillator twice, from (1, 0) and from (0, 1): the columns of its map. */
#include "numerics/stability/amplification.h"

#include <math.h>
#include <tinker/unconstrained.h>

#include "numerics/stability/tolerances.h"

/* Steps that are tried, times the oscillator's fastest rate: from where no method is unstable that is stable for any
 * step, in steps that no gap of a stability region is thought to fall between. */
#define LEAST_TRIAL  0.05
#define MOST_TRIAL   1e7
#define TRIAL_FACTOR 1.02
#define BISECTIONS   40
/* Beyond this ratio of damping to frequency a limit follows the damping alone, or the frequency alone. */
#define MOST_DAMPING    1e5
#define FOLLOWS_DAMPING 100.0

/* Steps of a long run, those of them in which a start is forgotten, and how far it may die away or grow. */
#define LONG_RUN    300
#define SETTLING    10
#define LEAST_SWING 1e-200
#define MOST_SWING  1e200

/* One oscillator as a system of one coordinate ------------------------------------------------------------------- */

typedef struct {
    TinkerOscillator oscillator;
    TinkerSystem system;
    const TinkerIntegrator *method;
    void *stepper;
} Probe;

static TinkerStatus acceleration(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    const TinkerOscillator *oscillator = context;
    a[0] = -oscillator->stiffness * q[0] - oscillator->damping * v[0];
    return TINKER_OK;
}

static TinkerStatus damping_product(void *context, double t, const double *q, const double *v, const double *dv,
                                    double *out)
{
    const TinkerOscillator *oscillator = context;
    out[0] = -oscillator->damping * dv[0];
    return TINKER_OK;
}

static void scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = fmax(1.0, fabs(q[0]));
    *speed = fmax(1.0, fabs(v[0]));
}

static TinkerStatus jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                             double *damping)
{
    const TinkerOscillator *oscillator = context;
    stiffness[0] = oscillator->stiffness;
    damping[0] = oscillator->damping;
    return TINKER_OK;
}

static const double unit_mass[] = {1.0};
static const int32_t row_starts[] = {0, 1}, columns[] = {0};
static const TinkerPattern pattern = {1, 1, row_starts, columns};

/* The probe must stay where it is: its stepper points into it. */
static gboolean probe_open(Probe *probe, const TinkerIntegrator *method, double spectral_radius,
                           TinkerOscillator oscillator)
{
    *probe = (Probe){.oscillator = oscillator, .method = method};
    probe->system = (TinkerSystem){
        .struct_size = sizeof(TinkerSystem),
        .flags = oscillator.damping != 0 ? TINKER_SYSTEM_VELOCITY_DEPENDENT : 0,
        .size = 1,
        .context = &probe->oscillator,
        .mass = unit_mass,
        .acceleration = acceleration,
        .applied = acceleration,
        .project = tinker_unconstrained_project,
        .constrain_step = tinker_unconstrained_constrain_step,
        .project_velocity = tinker_unconstrained_project_velocity,
        .damping_product = damping_product,
        .scales = scales,
        .failure = tinker_unconstrained_failure,
        .pattern = &pattern,
        .jacobian = jacobian,
    };
    TinkerIntegratorOptions options = {
        .struct_size = sizeof(TinkerIntegratorOptions), .tolerance = 1e-9, .spectral_radius = spectral_radius};
    if (!(method->flags & TINKER_INTEGRATOR_LINEAR)) probe->stepper = method->create(&probe->system, &options);
    return probe->stepper != NULL;
}

static void probe_clear(Probe *probe)
{
    if (probe->stepper != NULL) probe->method->destroy(probe->stepper);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Probe, probe_clear)

static gboolean probe_column(Probe *probe, double x, double v, double step, double *map)
{
    TinkerState state = {0.0, &x, &v, NULL};
    TinkerStepReport report = {.struct_size = sizeof(TinkerStepReport)};
    probe->method->restart(probe->stepper);
    if (probe->method->step(probe->stepper, &state, step, &report) != TINKER_OK) return FALSE;
    map[0] = x;
    map[2] = v;
    return isfinite(x) && isfinite(v);
}

static gboolean probe_map(Probe *probe, double step, double map[4])
{
    return probe_column(probe, 1.0, 0.0, step, map) && probe_column(probe, 0.0, 1.0, step, map + 1);
}

gboolean tinker_amplification(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator,
                              double step, double map[4])
{
    g_auto(Probe) probe = {0};
    return probe_open(&probe, method, spectral_radius, oscillator) && probe_map(&probe, step, map);
}

/* Stability -------------------------------------------------------------------------------------------------------- */

double tinker_map_growth(const double map[4])
{
    double half = 0.5 * (map[0] + map[3]), determinant = map[0] * map[3] - map[1] * map[2];
    double square = 0.25 * (map[0] - map[3]) * (map[0] - map[3]) + map[1] * map[2];
    return square < 0 ? sqrt(fmax(determinant, 0)) : fabs(half) + sqrt(square);
}

/* The energy norm: (w x, v). */
static double swing(const Probe *probe, double x, double v)
{
    return hypot(sqrt(fmax(probe->oscillator.stiffness, 0)) * x, v);
}

/* The slope of the swing's logarithm by least squares: what it does besides growing comes and goes and is evened out.
 */
double tinker_long_run_growth(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator,
                              double step)
{
    g_auto(Probe) probe = {0};
    if (!probe_open(&probe, method, spectral_radius, oscillator)) return INFINITY;
    double x = 1, v = 1, size, n = 0, steps = 0, squares = 0, logarithms = 0, products = 0;
    TinkerState state = {0.0, &x, &v, NULL};
    TinkerStepReport report = {.struct_size = sizeof(TinkerStepReport)};
    method->restart(probe.stepper);
    for (int i = 0; i < LONG_RUN; i++) {
        if (method->step(probe.stepper, &state, state.t + step, &report) != TINKER_OK) return INFINITY;
        size = swing(&probe, x, v);
        if (!(size > LEAST_SWING && size < MOST_SWING)) break;
        if (i < SETTLING) continue;
        n += 1;
        steps += i;
        squares += (double)i * i;
        logarithms += log(size);
        products += i * log(size);
    }
    if (n < 2) return size < 1 ? 0 : INFINITY;
    return exp((n * products - steps * logarithms) / (n * squares - steps * steps));
}

static gboolean is_stable(Probe *probe, double step)
{
    double map[4];
    return probe_map(probe, step, map) && tinker_map_growth(map) <= 1.0 + TINKER_GROWTH;
}

/* The first step that is not stable, of an oscillator whose fastest rate is 1. */
static double first_unstable(Probe *probe)
{
    double stable = 0, trial = LEAST_TRIAL;
    while (trial < MOST_TRIAL && is_stable(probe, trial)) {
        stable = trial;
        trial *= TRIAL_FACTOR;
    }
    if (stable == 0) return 0;
    if (trial >= MOST_TRIAL) return INFINITY;
    for (int i = 0; i < BISECTIONS; i++) {
        double middle = 0.5 * (stable + trial);
        if (is_stable(probe, middle))
            stable = middle;
        else
            trial = middle;
    }
    return stable;
}

/* Its fastest rate, and the oscillator in units of it. */
static double fastest_rate(TinkerOscillator *oscillator)
{
    double frequency = sqrt(fmax(oscillator->stiffness, 0)), damping = fmax(oscillator->damping, 0);
    double rate = fmax(frequency, damping);
    if (rate > 0) *oscillator = (TinkerOscillator){(frequency / rate) * (frequency / rate), damping / rate};
    return rate;
}

static double stable_step(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator)
{
    TinkerOscillator scaled = oscillator;
    double frequency = sqrt(fmax(oscillator.stiffness, 0)), ratio = fmax(oscillator.damping, 0) / frequency;
    if (frequency > 0 && ratio > MOST_DAMPING) scaled.damping = MOST_DAMPING * frequency;
    double rate = fastest_rate(&scaled);
    if (!(rate > 0) || !isfinite(rate)) return rate > 0 ? 0 : INFINITY;
    g_auto(Probe) probe = {0};
    if (!probe_open(&probe, method, spectral_radius, scaled)) return INFINITY;
    double limit = first_unstable(&probe);
    gboolean capped = frequency > 0 && ratio > MOST_DAMPING;
    return capped && limit < FOLLOWS_DAMPING ? limit / oscillator.damping : limit / rate;
}

static gboolean stands(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator, double step)
{
    g_auto(Probe) probe = {0};
    double rate = fastest_rate(&oscillator);
    if (!(rate > 0)) return TRUE;
    return probe_open(&probe, method, spectral_radius, oscillator) && is_stable(&probe, rate * step);
}

static gsize fastest_of(const TinkerOscillator *oscillators, gsize count)
{
    gsize fastest = 0;
    double most = -1;
    for (gsize i = 0; i < count; i++) {
        TinkerOscillator scaled = oscillators[i];
        double rate = fastest_rate(&scaled);
        if (rate > most) most = rate, fastest = i;
    }
    return fastest;
}

/* The fastest one first: the others are then seldom worth more than one look. */
double tinker_stable_step_of_all(const TinkerIntegrator *method, double spectral_radius,
                                 const TinkerOscillator *oscillators, gsize count)
{
    if (count == 0) return INFINITY;
    double least = stable_step(method, spectral_radius, oscillators[fastest_of(oscillators, count)]);
    for (gsize i = 0; i < count && least > 0; i++)
        if (!isfinite(least) || !stands(method, spectral_radius, oscillators[i], least))
            least = fmin(least, stable_step(method, spectral_radius, oscillators[i]));
    return least;
}

/* Error ------------------------------------------------------------------------------------------------------------ */

/* The exact map over a time. With a = damping / 2 and roots -a +- sqrt(a^2 - stiffness). */
static void exact_map(TinkerOscillator oscillator, double time, double map[4])
{
    double k = oscillator.stiffness, a = 0.5 * oscillator.damping, square = k - a * a, even, odd;
    if (square > 0) {
        double w = sqrt(square), decay = exp(-a * time);
        even = decay * cos(w * time);
        odd = decay * sin(w * time) / w;
    } else {
        double r = sqrt(-square), slow = a + r > 0 ? exp(-k / (a + r) * time) : 1.0, fast = exp(-(a + r) * time);
        even = 0.5 * (slow + fast);
        odd = r * time > 1e-6 ? 0.5 * (slow - fast) / r : time * fast;
    }
    map[0] = even + a * odd;
    map[1] = odd;
    map[2] = -k * odd;
    map[3] = even - a * odd;
}

static void multiply(const double left[4], const double right[4], double product[4])
{
    double result[4] = {left[0] * right[0] + left[1] * right[2], left[0] * right[1] + left[1] * right[3],
                        left[2] * right[0] + left[3] * right[2], left[2] * right[1] + left[3] * right[3]};
    for (int i = 0; i < 4; i++)
        product[i] = result[i];
}

/* The size of a difference of maps where places count `rate` times. */
static double difference(const double left[4], const double right[4], double rate)
{
    double d[4] = {left[0] - right[0], (left[1] - right[1]) * rate, (left[2] - right[2]) / rate, left[3] - right[3]};
    double sum = 0;
    for (int i = 0; i < 4; i++)
        sum += d[i] * d[i];
    return isfinite(sum) ? sqrt(0.5 * sum) : INFINITY;
}

double tinker_step_error(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator,
                         double step, double duration)
{
    TinkerOscillator scaled = {fmax(oscillator.stiffness, 0), fmax(oscillator.damping, 0)};
    double power[4], all[4] = {1, 0, 0, 1}, exact[4], worst = 0, taken = 0, span = step;
    double rate = fmax(sqrt(scaled.stiffness), fmax(scaled.damping, 1.0 / fmax(duration, step)));
    if (!tinker_amplification(method, spectral_radius, scaled, step, power)) return INFINITY;
    double steps = fmax(nearbyint(duration / step), 1.0);
    /* by repeated squaring: every power of two on the way is looked at */
    for (double left = steps; left >= 1; left = floor(0.5 * left)) {
        exact_map(scaled, span, exact);
        worst = fmax(worst, difference(power, exact, rate));
        if (fmod(left, 2) == 1) {
            multiply(power, all, all);
            taken += span;
        }
        multiply(power, power, power);
        span *= 2;
    }
    exact_map(scaled, taken, exact);
    return fmax(worst, difference(all, exact, rate));
}

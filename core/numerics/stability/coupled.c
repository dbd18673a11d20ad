/* The method steps the oscillators from every unit vector: the columns of its map. */
#include "numerics/stability/coupled.h"

#include <math.h>
#include <string.h>
#include <tinker/unconstrained.h>

#include "numerics/solve/lapack.h"
#include "numerics/stability/tolerances.h"

#define LONG 1e3
/* Steps that are tried, times the fastest rate. */
#define LEAST_TRIAL  1e-2
#define LEAST_DECAYS 1e-6
#define MOST_TRIAL   1e6
#define TRIAL_FACTOR 1.02
#define BISECTIONS   30

typedef struct {
    const TinkerCoupled *coupled;
    const TinkerIntegrator *method;
    TinkerSystem system;
    void *stepper;
    double *mass, *map, *re, *im, *state;
} Probe;

/* out -= A x. */
static void subtract_product(int32_t n, const double *matrix, const double *x, double *out)
{
    for (int32_t j = 0; j < n; j++)
        for (int32_t i = 0; i < n; i++)
            out[i] -= matrix[(gsize)j * (gsize)n + (gsize)i] * x[j];
}

static TinkerStatus acceleration(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    const TinkerCoupled *coupled = context;
    memset(a, 0, (gsize)coupled->size * sizeof(double));
    subtract_product(coupled->size, coupled->stiffness, q, a);
    subtract_product(coupled->size, coupled->damping, v, a);
    return TINKER_OK;
}

static TinkerStatus damping_product(void *context, double t, const double *q, const double *v, const double *dv,
                                    double *out)
{
    const TinkerCoupled *coupled = context;
    memset(out, 0, (gsize)coupled->size * sizeof(double));
    subtract_product(coupled->size, coupled->damping, dv, out);
    return TINKER_OK;
}

static void scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    const TinkerCoupled *coupled = context;
    *extent = *speed = 1;
    for (int32_t i = 0; i < coupled->size; i++) {
        *extent = fmax(*extent, fabs(q[i]));
        *speed = fmax(*speed, fabs(v[i]));
    }
}

/* The probe must stay where it is: its stepper points into it. */
static gboolean probe_open(Probe *probe, const TinkerIntegrator *method, double spectral_radius,
                           const TinkerCoupled *coupled)
{
    gsize n = (gsize)coupled->size, order = 2 * n;
    *probe = (Probe){.coupled = coupled, .method = method, .mass = g_new(double, order *order + 4 * order)};
    probe->map = probe->mass + order;
    probe->re = probe->map + order * order;
    probe->im = probe->re + order;
    probe->state = probe->im + order;
    for (gsize i = 0; i < n; i++)
        probe->mass[i] = 1;
    probe->system = (TinkerSystem){
        .struct_size = sizeof(TinkerSystem),
        .flags = TINKER_SYSTEM_VELOCITY_DEPENDENT,
        .size = coupled->size,
        .context = (void *)(gpointer)coupled,
        .mass = probe->mass,
        .acceleration = acceleration,
        .applied = acceleration,
        .project = tinker_unconstrained_project,
        .constrain_step = tinker_unconstrained_constrain_step,
        .project_velocity = tinker_unconstrained_project_velocity,
        .damping_product = damping_product,
        .scales = scales,
        .failure = tinker_unconstrained_failure,
    };
    TinkerIntegratorOptions options = {
        .struct_size = sizeof(TinkerIntegratorOptions), .tolerance = 1e-9, .spectral_radius = spectral_radius};
    gboolean steps = (method->flags & (TINKER_INTEGRATOR_LINEAR | TINKER_INTEGRATOR_IMPLICIT)) == 0;
    if (steps) probe->stepper = method->create(&probe->system, &options);
    return probe->stepper != NULL;
}

static void probe_clear(Probe *probe)
{
    if (probe->stepper != NULL) probe->method->destroy(probe->stepper);
    g_free(probe->mass);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Probe, probe_clear)

/* Places count `rate` times, so that all entries are of one size. */
static gboolean probe_column(Probe *probe, int32_t number, double step)
{
    int32_t n = probe->coupled->size;
    double rate = probe->coupled->rate, *q = probe->state, *v = q + n, sum = 0;
    double *column = probe->map + (gsize)number * 2 * (gsize)n;
    TinkerState state = {0.0, q, v, NULL};
    TinkerStepReport report = {.struct_size = sizeof(TinkerStepReport)};
    memset(q, 0, 2 * (gsize)n * sizeof(double));
    q[number] = number < n ? 1 / rate : 1;
    probe->method->restart(probe->stepper);
    if (probe->method->step(probe->stepper, &state, step, &report) != TINKER_OK) return FALSE;
    for (int32_t i = 0; i < 2 * n; i++) {
        column[i] = i < n ? rate * q[i] : q[i];
        sum += 0 * column[i];
    }
    return sum == 0;
}

static double growth_at(Probe *probe, double step)
{
    int32_t order = 2 * probe->coupled->size;
    double most = 0;
    for (int32_t j = 0; j < order; j++)
        if (!probe_column(probe, j, step)) return INFINITY;
    if (!tinker_eigen_general(order, probe->map, probe->re, probe->im, NULL)) return INFINITY;
    for (int32_t i = 0; i < order; i++)
        if (hypot(probe->re[i] - 1, probe->im[i]) > TINKER_EIGENVALUE_STAYS)
            most = fmax(most, hypot(probe->re[i], probe->im[i]));
    return most;
}

static gboolean is_stable(Probe *probe, double step)
{
    double tolerance = TINKER_COUPLED_GROWTH * fmax(1, step * probe->coupled->rate / LONG);
    return growth_at(probe, step) <= (1 + tolerance) * exp(probe->coupled->growth * step);
}

/* Where the first trial grows: a much smaller step at which all that moves decays, as of strong forces across
 * velocities beside little damping. */
static double first_decaying(Probe *probe)
{
    double rate = probe->coupled->rate;
    for (double trial = 0.1 * LEAST_TRIAL / rate; trial * rate > LEAST_DECAYS; trial *= 0.1) {
        double growth = growth_at(probe, trial);
        if (growth > 0 && growth < 1 - TINKER_LEAST_DECAY) return trial;
    }
    return 0;
}

double tinker_coupled_stable_step(const TinkerIntegrator *method, double spectral_radius, const TinkerCoupled *coupled)
{
    g_auto(Probe) probe = {0};
    if (!(coupled->rate > 0) || !isfinite(coupled->rate)) return coupled->rate > 0 ? 0 : INFINITY;
    if (!probe_open(&probe, method, spectral_radius, coupled)) return INFINITY;
    double stable = 0, trial = LEAST_TRIAL / coupled->rate, most = MOST_TRIAL / coupled->rate;
    while (trial < most && is_stable(&probe, trial)) {
        stable = trial;
        trial *= TRIAL_FACTOR;
    }
    if (trial >= most) return INFINITY;
    if (stable == 0) stable = first_decaying(&probe);
    for (int i = 0; i < BISECTIONS && stable > 0; i++) {
        double middle = 0.5 * (stable + trial);
        if (is_stable(&probe, middle))
            stable = middle;
        else
            trial = middle;
    }
    return stable;
}

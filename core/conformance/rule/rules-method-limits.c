/* limits, constrained: what a method says of its stability, and that it keeps a system on its constraints.
 *
 * The limits are those of integrator.h: h omega of an undamped oscillator x'' = -omega^2 x, and h c / m of a pure
 * damper x'' = -(c / m) x', at the edge of stability. Both are tried as they are defined, in many equal steps. The host
 * warns by them and chooses by them: one that is too large hides a run that blows up, one that is far too small spoils
 * a good one. */
#include <math.h>

#include "conformance/probe/kit.h"
#include "conformance/probe/method-systems.h"

#define STEPS      20000
#define UNSTABLE   1.05 /* the swing of the second half over that of the first; what is stable keeps to 1 */
#define BLOWN_UP   1e9
#define DIED_AWAY  1e-100
#define BEYOND     1.05
#define FAR_BEYOND 2.0

typedef enum { STABLE, GROWING, REFUSED } Fate;

/* One of the two limits. */
typedef struct {
    const char *member, *number, *what;
    double limit, stiffness, damping;
} Limit;

static double swing(const Limit *limit, const double *q, const double *v)
{
    return limit->stiffness > 0 ? hypot(q[0], v[0]) : fabs(v[0]); // the place of a damper says nothing
}

/* Many steps of the size h, of an oscillator or damper whose rate is 1/s. */
static Fate fate_of(KitCheck *check, const Limit *limit, double h, const char **reason)
{
    KitProbe probe;
    const TinkerIntegrator *method = check->integrator;
    const TinkerIntegratorOptions options = {.struct_size = sizeof options, .tolerance = 1e-9, .spectral_radius = 0.8};
    double q[] = {1}, v[] = {1}, halves[2] = {0, 0};
    TinkerState state = {0, q, v, NULL};
    TinkerStepReport report = {.struct_size = sizeof report};
    Fate fate = STABLE;
    kit_probe_begin(&probe, limit->stiffness, limit->damping);
    *reason = "it gives no reason";
    kit_phase(check, "create");
    void *stepper = method->create(&probe.system, &options);
    if (stepper == NULL) return REFUSED;
    method->restart(stepper);
    kit_phase(check, "steps with %s = %g of %s", limit->number, h, limit->what);
    for (int i = 0; i < STEPS && fate == STABLE; i++) {
        if (method->step(stepper, &state, state.t + h, &report) != TINKER_OK) {
            fate = REFUSED;
            if (report.failure != NULL) *reason = report.failure;
            break;
        }
        const double size = swing(limit, q, v);
        double *half = &halves[i < STEPS / 2 ? 0 : 1];
        *half = fmax(*half, size);
        if (!(size < BLOWN_UP)) fate = GROWING;
        if (size < DIED_AWAY) break;
    }
    method->destroy(stepper);
    return fate == STABLE && halves[1] > UNSTABLE * halves[0] ? GROWING : fate;
}

static void expect_stable(KitCheck *check, const Limit *limit, double h)
{
    const char *reason;
    const Fate fate = fate_of(check, limit, h, &reason);
    if (fate == GROWING)
        kit_fail(check, "with %s = %g %s grows, though %s is %g%s", limit->number, h, limit->what, limit->member,
                 limit->limit, limit->limit < 0 ? ", which says that there is no limit" : "");
    else if (fate == REFUSED)
        kit_fail(check, "with %s = %g %s cannot be stepped, though %s is %g: %s", limit->number, h, limit->what,
                 limit->member, limit->limit, reason);
}

static void look_beyond(KitCheck *check, const Limit *limit, GString *told)
{
    const char *reason;
    const double near = limit->limit == 0 ? 1 : BEYOND * limit->limit;
    const double far = limit->limit == 0 ? 1 : FAR_BEYOND * limit->limit;
    if (fate_of(check, limit, near, &reason) != STABLE) return;
    if (fate_of(check, limit, far, &reason) == STABLE)
        kit_fail(check, "with %s = %g %s does not grow, though %s is %g: the edge of stability lies farther out%s",
                 limit->number, far, limit->what, limit->member, limit->limit,
                 limit->limit == 0 ? "; less than 0 says that there is none" : "");
    else
        g_string_append_printf(told, "%s%s is cautious: %s is stable with %s = %g", told->len > 0 ? "; " : "",
                               limit->member, limit->what, limit->number, near);
}

static void try_limit(KitCheck *check, const Limit *limit, GString *told)
{
    static const double shares[] = {0.25, 0.5, 0.75, 0.98}, all[] = {0.5, 10, 1000};
    const gboolean none = limit->limit < 0 || isinf(limit->limit);
    for (gsize i = 0; none && i < G_N_ELEMENTS(all) && !kit_decided(check); i++)
        expect_stable(check, limit, all[i]);
    for (gsize i = 0; limit->limit > 0 && !none && i < G_N_ELEMENTS(shares) && !kit_decided(check); i++)
        expect_stable(check, limit, shares[i] * limit->limit);
    if (!none && !kit_decided(check)) look_beyond(check, limit, told);
}

void kit_try_method_limits(KitCheck *check)
{
    const TinkerIntegrator *method = check->integrator;
    const Limit limits[] = {
        {"imaginary_limit", "h omega", "an undamped oscillator", method->imaginary_limit, 1, 0},
        {"real_limit", "h c / m", "a pure damper", method->real_limit, 0, 1},
    };
    g_autoptr(GString) told = g_string_new(NULL);
    if (method->flags & TINKER_INTEGRATOR_ADAPTIVE) kit_skip(check, "it chooses its steps itself");
    for (gsize i = 0; i < G_N_ELEMENTS(limits) && !kit_decided(check); i++)
        try_limit(check, &limits[i], told);
    if (told->len > 0) kit_tell(check, "%s", told->str);
}

/* Constrained ------------------------------------------------------------------------------------------------------ */

#define SWINGS     2.0 /* s */
#define LEAST      80  /* steps */
#define MOST_STEPS 200000
#define ROUNDING   1e-12

/* The rod is as long as it was, and no velocity is along it. */
static void look_at_rod(KitCheck *check, const double *q, const double *v, double t)
{
    const double length = hypot(q[0], q[1]), along = (q[0] * v[0] + q[1] * v[1]) / length;
    const char *expected = "at most rounding was expected: on a constrained system a step ends with `project`";
    if (!(fabs(length - KIT_PENDULUM_LENGTH) <= ROUNDING * KIT_PENDULUM_LENGTH))
        kit_fail(check, "after the step to %g s a pendulum's rod of %g m is off by %.3g m, %s", t, KIT_PENDULUM_LENGTH,
                 length - KIT_PENDULUM_LENGTH, expected);
    else if (!(fabs(along) <= ROUNDING * KIT_SYSTEM_OMEGA * KIT_PENDULUM_LENGTH))
        kit_fail(check, "after the step to %g s a pendulum has a velocity of %.3g m/s along its rod, %s", t, along,
                 expected);
}

void kit_try_method_constrained(KitCheck *check)
{
    const TinkerIntegrator *method = check->integrator;
    const TinkerIntegratorOptions options = {.struct_size = sizeof options, .tolerance = 1e-6, .spectral_radius = 0.8};
    const gboolean adaptive = (method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    const double limit = method->imaginary_limit > 0 ? fmin(method->imaginary_limit, 1) : 1;
    const int steps = (int)fmin(ceil(LEAST / limit), MOST_STEPS);
    double q[KIT_SYSTEM_SIZE], v[KIT_SYSTEM_SIZE];
    TinkerState state = {0, q, v, NULL};
    TinkerStepReport report = {.struct_size = sizeof report};
    if (method->flags & TINKER_INTEGRATOR_LINEAR) {
        kit_skip(check, "it needs a linear system, which has no constraints");
        return;
    }
    kit_pendulum_start(q, v);
    kit_phase(check, "create");
    void *stepper = method->create(&kit_pendulum, &options);
    if (stepper == NULL) {
        kit_fail(check, "create answers NULL on a pendulum");
        return;
    }
    method->restart(stepper);
    for (int i = 1; state.t < SWINGS && i < MOST_STEPS && !kit_decided(check); i++) {
        const double until = adaptive || i >= steps ? SWINGS : SWINGS * i / steps;
        kit_phase(check, "a step of a pendulum at t = %g s", state.t);
        const TinkerStatus status = method->step(stepper, &state, until, &report);
        if (status != TINKER_OK)
            kit_fail(check, "a step of a pendulum from %g s to %g s answers %d: %s", state.t, until, status,
                     report.failure != NULL ? report.failure : "it gives no reason");
        else
            look_at_rod(check, q, v, state.t);
    }
    method->destroy(stepper);
}

/* Two motions in closed form that methods are tried on.
 *
 * The oscillator, x'' = -w^2 x - c v: exp(-c t / 2) (A cos(d t) + B sin(d t)), d^2 = w^2 - c^2 / 4.
 *
 * The driven one is not linear, and time is in its law: the force is made so that p(t) = A sin(r t + s) is the motion,
 *     x'' = p'' - f(x, v) + f(p, p'),   f(x, v) = w^2 (x + x^3 / 4) + c (1 + x^2) v.
 * A Runge-Kutta method with a wrong node, or one that is right on linear systems alone, shows here and not above. */
#include "conformance/probe/method-systems.h"

#include <math.h>
#include <tinker/unconstrained.h>

#define SIZE    KIT_SYSTEM_SIZE
#define OMEGA   KIT_SYSTEM_OMEGA
#define DAMPING 0.3

static const double start_q[SIZE] = {1.0, -0.4}, start_v[SIZE] = {0.3, 0.9}, masses[SIZE] = {1, 1};

static TinkerStatus acceleration(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    for (int i = 0; i < SIZE; i++)
        a[i] = -OMEGA * OMEGA * q[i] - DAMPING * v[i];
    if (power != NULL) power[0] = -DAMPING * (v[0] * v[0] + v[1] * v[1]);
    return TINKER_OK;
}
static TinkerStatus damping_product(void *context, double t, const double *q, const double *v, const double *dv,
                                    double *out)
{
    for (int i = 0; i < SIZE; i++)
        out[i] = -DAMPING * dv[i];
    return TINKER_OK;
}
static void scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = 1;
    *speed = OMEGA;
}
static TinkerStatus jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                             double *damping)
{
    for (int i = 0; i < SIZE; i++) {
        stiffness[i] = OMEGA * OMEGA;
        damping[i] = DAMPING;
    }
    return TINKER_OK;
}
static TinkerStatus signals(void *context, TinkerSignal *list)
{
    return TINKER_OK;
}

static const int32_t row_starts[] = {0, 1, 2}, pattern_columns[] = {0, 1};
static const TinkerPattern pattern = {SIZE, SIZE, row_starts, pattern_columns};
static const TinkerLinearEdge edges[SIZE] = {{0, -1, OMEGA *OMEGA, 0, DAMPING, 0},
                                             {1, -1, OMEGA *OMEGA, 0, DAMPING, 0}};
static const double anchors[] = {0};
static const TinkerLinearSystem linear = {.struct_size = sizeof(TinkerLinearSystem),
                                          .size = SIZE,
                                          .edge_count = SIZE,
                                          .anchor_count = 1,
                                          .mass = masses,
                                          .edges = edges,
                                          .anchors = anchors,
                                          .damper_book = 0,
                                          .drag_book = -1,
                                          .support_book = -1};
static const TinkerSystem oscillator_system = {.struct_size = sizeof(TinkerSystem),
                                               .flags = TINKER_SYSTEM_VELOCITY_DEPENDENT,
                                               .size = SIZE,
                                               .books = 1,
                                               .mass = masses,
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
                                               .linear = &linear,
                                               .signals = signals};

static void oscillate(double t, double q[SIZE], double v[SIZE])
{
    const double d = sqrt(OMEGA * OMEGA - DAMPING * DAMPING / 4), fade = exp(-DAMPING * t / 2);
    for (int i = 0; i < SIZE; i++) {
        const double b = (start_v[i] + DAMPING * start_q[i] / 2) / d;
        q[i] = fade * (start_q[i] * cos(d * t) + b * sin(d * t));
        v[i] = fade * d * (b * cos(d * t) - start_q[i] * sin(d * t)) - DAMPING / 2 * q[i];
    }
}

const KitMotion kit_oscillator = {"an oscillator", &oscillator_system, oscillate};

/* Driven ----------------------------------------------------------------------------------------------------------- */

#define RATE 1.3
static const double sizes[SIZE] = {0.8, 1.1}, shifts[SIZE] = {0.9, -0.4};

static void drive(double t, double q[SIZE], double v[SIZE])
{
    for (int i = 0; i < SIZE; i++) {
        q[i] = sizes[i] * sin(RATE * t + shifts[i]);
        v[i] = sizes[i] * RATE * cos(RATE * t + shifts[i]);
    }
}

static double law(double q, double v)
{
    return OMEGA * OMEGA * (q + q * q * q / 4) + DAMPING * (1 + q * q) * v;
}

static TinkerStatus driven_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                        double *power)
{
    double there[SIZE], speed[SIZE];
    drive(t, there, speed);
    if (power != NULL) power[0] = 0;
    for (int i = 0; i < SIZE; i++) {
        a[i] = -RATE * RATE * there[i] - law(q[i], v[i]) + law(there[i], speed[i]);
        if (power != NULL) power[0] -= DAMPING * (1 + q[i] * q[i]) * v[i] * v[i];
    }
    return TINKER_OK;
}
static TinkerStatus driven_damping(void *context, double t, const double *q, const double *v, const double *dv,
                                   double *out)
{
    for (int i = 0; i < SIZE; i++)
        out[i] = -DAMPING * (1 + q[i] * q[i]) * dv[i];
    return TINKER_OK;
}
static TinkerStatus driven_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                    double *damping)
{
    for (int i = 0; i < SIZE; i++) {
        stiffness[i] = OMEGA * OMEGA * (1 + 0.75 * q[i] * q[i]) + 2 * DAMPING * q[i] * v[i];
        damping[i] = DAMPING * (1 + q[i] * q[i]);
    }
    return TINKER_OK;
}

static const TinkerSystem driven_system = {.struct_size = sizeof(TinkerSystem),
                                           .flags = TINKER_SYSTEM_VELOCITY_DEPENDENT,
                                           .size = SIZE,
                                           .books = 1,
                                           .mass = masses,
                                           .acceleration = driven_acceleration,
                                           .applied = driven_acceleration,
                                           .project = tinker_unconstrained_project,
                                           .constrain_step = tinker_unconstrained_constrain_step,
                                           .project_velocity = tinker_unconstrained_project_velocity,
                                           .damping_product = driven_damping,
                                           .scales = scales,
                                           .failure = tinker_unconstrained_failure,
                                           .pattern = &pattern,
                                           .jacobian = driven_jacobian};

const KitMotion kit_driven = {"a driven motion that is not linear", &driven_system, drive};

double kit_motion_error(const KitMotion *motion, double t, const double *q, const double *v)
{
    double there[SIZE], speed[SIZE], worst = 0;
    motion->exact(t, there, speed);
    for (int i = 0; i < SIZE; i++) {
        if (!isfinite(q[i]) || !isfinite(v[i])) return INFINITY;
        worst = fmax(worst, fmax(fabs(q[i] - there[i]), fabs(v[i] - speed[i]) / OMEGA));
    }
    return worst;
}

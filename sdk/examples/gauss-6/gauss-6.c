/* The method of Gauss with three stages, order 6: an implicit Runge-Kutta method that is symplectic and symmetric.
 *
 * With stage accelerations A_i = a(t0 + c_i h, Q_i, V_i) and B = A A of the tableau A, b, c,
 *
 *     V_i = v0 + h sum a_ij A_j,   Q_i = q0 + c_i h v0 + h^2 sum b_ij A_j,
 *     v1  = v0 + h sum b_j A_j,    q1  = q0 + h v0 + h^2 sum b_j (1 - c_j) A_j.
 *
 * The stages are found by iteration from those of the step before, extrapolated. On an oscillator an iteration leaves
 * (0.2153 h omega)^2 of what was wrong, on a damper 0.2153 h c / m, where 0.2153 is the spectral radius of the tableau:
 * that, and not the method, which is stable for any step, limits the step.
 *
 * Source: E. Hairer, Ch. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., II.1.3 (tableau), VIII.6
 * (iteration). */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <tinker/sdk.h>

enum { STAGES = 3 };

#define ROOT_15 3.872983346207416885

/* More than this never helps: what is left shrinks too slowly, and rounding is reached long before. */
#define MOST_ITERATIONS 100
/* The iteration has converged when a stage changes by no more than this share of the largest acceleration; where
 * rounding keeps it from that, when it no longer shrinks below the second share. */
#define CONVERGED (4 * DBL_EPSILON)
#define ROUNDING  1e-12

static const double nodes[STAGES] = {0.5 - ROOT_15 / 10.0, 0.5, 0.5 + ROOT_15 / 10.0};
static const double weights[STAGES] = {5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0};
static const double tableau[STAGES][STAGES] = {
    {5.0 / 36.0, 2.0 / 9.0 - ROOT_15 / 15.0, 5.0 / 36.0 - ROOT_15 / 30.0},
    {5.0 / 36.0 + ROOT_15 / 24.0, 2.0 / 9.0, 5.0 / 36.0 - ROOT_15 / 24.0},
    {5.0 / 36.0 + ROOT_15 / 30.0, 2.0 / 9.0 + ROOT_15 / 15.0, 5.0 / 36.0},
};

/* The stepper */

typedef struct {
    const TinkerSystem *system;
    double squared[STAGES][STAGES];         /* the tableau times itself */
    double t0, h;                           /* the last step began here and was so long; h is 0 where there is none */
    double *q0, *v0, *a0, *books0, *power0; /* where it began */
    double *q1, *v1, *a1, *books1, *power1; /* where it ended */
    double *stages, *next;                  /* accelerations of the stages, stage by stage; those of an iteration */
    double *q, *v;                          /* of one stage */
    double *powers;                         /* of the stages, stage by stage */
    double memory[];
} Stepper;

static double *take(double **next, int32_t count)
{
    double *taken = *next;
    *next += count;
    return taken;
}

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    const int32_t n = system->size, m = system->books;
    Stepper *s = calloc(1, sizeof *s + ((size_t)n * (8 + 2 * STAGES) + (size_t)m * (4 + STAGES)) * sizeof(double));
    if (s == NULL) return NULL;
    double *next = s->memory;
    double **const of_size[] = {&s->q0, &s->v0, &s->a0, &s->q1, &s->v1, &s->a1, &s->q, &s->v};
    double **const of_books[] = {&s->books0, &s->power0, &s->books1, &s->power1};
    for (size_t i = 0; i < sizeof of_size / sizeof *of_size; i++)
        *of_size[i] = take(&next, n);
    for (size_t i = 0; i < sizeof of_books / sizeof *of_books; i++)
        *of_books[i] = take(&next, m);
    s->stages = take(&next, STAGES * n);
    s->next = take(&next, STAGES * n);
    s->powers = take(&next, STAGES * m);
    for (int i = 0; i < STAGES; i++)
        for (int j = 0; j < STAGES; j++)
            for (int k = 0; k < STAGES; k++)
                s->squared[i][j] += tableau[i][k] * tableau[k][j];
    s->system = system;
    return s;
}

static void destroy(void *stepper)
{
    free(stepper);
}

static void restart(void *stepper)
{
    ((Stepper *)stepper)->h = 0.0;
}

/* The stages */

/* Where the stages of the step before would be in this one: the parabola through them, at the new nodes. */
static void extrapolate(Stepper *s, double ratio)
{
    const int32_t n = s->system->size;
    for (int i = 0; i < STAGES; i++) {
        const double at = 1.0 + ratio * nodes[i];
        double share[STAGES];
        for (int j = 0; j < STAGES; j++) {
            const double one = nodes[(j + 1) % STAGES], other = nodes[(j + 2) % STAGES];
            share[j] = (at - one) * (at - other) / ((nodes[j] - one) * (nodes[j] - other));
        }
        for (int32_t k = 0; k < n; k++)
            s->next[i * n + k] =
                share[0] * s->stages[k] + share[1] * s->stages[n + k] + share[2] * s->stages[2 * n + k];
    }
    memcpy(s->stages, s->next, (size_t)(STAGES * n) * sizeof(double));
}

/* to = from + slope * speed + factor * (the stages in these shares). */
static void combine(const Stepper *s, const double *from, double slope, const double *speed, double factor,
                    const double share[STAGES], double *to)
{
    const int32_t n = s->system->size;
    const double *a = s->stages;
    for (int32_t k = 0; k < n; k++)
        to[k] = from[k] + slope * speed[k] + factor * (share[0] * a[k] + share[1] * a[n + k] + share[2] * a[2 * n + k]);
}

/* One iteration: the accelerations at the stages that follow from the present ones. */
static TinkerStatus ask_stages(Stepper *s, double h)
{
    const TinkerSystem *system = s->system;
    for (int i = 0; i < STAGES; i++) {
        combine(s, s->q0, nodes[i] * h, s->v0, h * h, s->squared[i], s->q);
        combine(s, s->v0, 0.0, s->v0, h, tableau[i], s->v);
        const TinkerStatus status = system->acceleration(system->context, s->t0 + nodes[i] * h, s->q, s->v,
                                                         &s->next[i * system->size], &s->powers[i * system->books]);
        if (status != TINKER_OK) return status;
    }
    return TINKER_OK;
}

static double greatest_change(const Stepper *s, double *greatest)
{
    double change = 0.0;
    *greatest = 0.0;
    for (int32_t k = 0; k < STAGES * s->system->size; k++) {
        change = fmax(change, fabs(s->next[k] - s->stages[k]));
        *greatest = fmax(*greatest, fabs(s->next[k]));
    }
    return change;
}

static TinkerStatus solve_stages(Stepper *s, double h)
{
    double before = INFINITY;
    for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
        double greatest;
        const TinkerStatus status = ask_stages(s, h);
        if (status != TINKER_OK) return status;
        const double change = greatest_change(s, &greatest);
        memcpy(s->stages, s->next, (size_t)(STAGES * s->system->size) * sizeof(double));
        if (change <= CONVERGED * greatest || (change >= before && change <= ROUNDING * greatest)) return TINKER_OK;
        before = change;
    }
    return TINKER_RETRY_SMALLER;
}

/* A step */

/* Leaves where the step begins, and first stages for the iteration. */
static TinkerStatus prepare(Stepper *s, const TinkerState *state, double h)
{
    const TinkerSystem *system = s->system;
    const size_t bytes = (size_t)system->size * sizeof(double), books = (size_t)system->books * sizeof(double);
    const double last = s->h;
    s->t0 = state->t;
    memcpy(s->q0, state->q, bytes);
    memcpy(s->v0, state->v, bytes);
    memcpy(s->books0, state->books, books);
    if (last != 0.0) {
        memcpy(s->a0, s->a1, bytes);
        memcpy(s->power0, s->power1, books);
        extrapolate(s, h / last);
        return TINKER_OK;
    }
    const TinkerStatus status = system->acceleration(system->context, s->t0, s->q0, s->v0, s->a0, s->power0);
    for (int i = 0; i < STAGES; i++)
        memcpy(&s->stages[i * system->size], s->a0, bytes);
    return status;
}

/* The end of the step, on the constraints, with what acts there. */
static TinkerStatus finish(Stepper *s, double h, double end)
{
    const TinkerSystem *system = s->system;
    double shares[STAGES];
    int32_t moved = 0;
    for (int i = 0; i < STAGES; i++)
        shares[i] = weights[i] * (1.0 - nodes[i]);
    combine(s, s->q0, h, s->v0, h * h, shares, s->q1);
    combine(s, s->v0, 0.0, s->v0, h, weights, s->v1);
    for (int32_t k = 0; k < system->books; k++) {
        const double *power = &s->powers[k];
        s->books1[k] = s->books0[k] + h * (weights[0] * power[0] + weights[1] * power[system->books] +
                                           weights[2] * power[2 * system->books]);
    }
    if (system->flags & TINKER_SYSTEM_CONSTRAINED) {
        const TinkerStatus status = system->project(system->context, end, s->q1, s->v1, &moved);
        if (status != TINKER_OK) return status;
    }
    return system->acceleration(system->context, end, s->q1, s->v1, s->a1, s->power1);
}

static TinkerStatus fail(Stepper *s, TinkerStepReport *report, const char *otherwise)
{
    const TinkerSystem *system = s->system;
    const char *reason = system->failure == NULL ? NULL : system->failure(system->context);
    s->h = 0.0;
    report->failure = reason != NULL ? reason : otherwise;
    return TINKER_FAILED;
}

static TinkerStatus step(void *stepper, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *s = stepper;
    const size_t bytes = (size_t)s->system->size * sizeof(double);
    const double h = limit - state->t;
    *report = (TinkerStepReport){.struct_size = report->struct_size, .t_from = state->t, .step = h};
    if (h == 0.0 || !isfinite(h)) return fail(s, report, "a step must end at another, finite time");
    if (prepare(s, state, h) != TINKER_OK) return fail(s, report, "the forces cannot be worked out");
    if (solve_stages(s, h) != TINKER_OK)
        return fail(s, report, "the iteration for the stages does not converge; a smaller step helps");
    if (finish(s, h, limit) != TINKER_OK)
        return fail(s, report, "the end of the step cannot be worked out; a smaller step may help");
    memcpy(state->q, s->q1, bytes);
    memcpy(state->v, s->v1, bytes);
    memcpy(state->books, s->books1, (size_t)s->system->books * sizeof(double));
    state->t = limit;
    s->h = h;
    return TINKER_OK;
}

/* Between steps: the polynomial of degree 5 with place, velocity and acceleration of both ends */

static TinkerStatus interpolate(void *stepper, double t, double *q, double *v, double *books)
{
    const Stepper *s = stepper;
    const double h = s->h, x = (t - s->t0) / h, x2 = x * x, x3 = x2 * x, x4 = x3 * x, x5 = x4 * x;
    if (h == 0.0) return TINKER_FAILED;
    for (int32_t k = 0; k < s->system->size; k++) {
        const double dq = s->q1[k] - s->q0[k];
        q[k] = s->q0[k] + (10.0 * x3 - 15.0 * x4 + 6.0 * x5) * dq +
               h * (x - 6.0 * x3 + 8.0 * x4 - 3.0 * x5) * s->v0[k] + h * (-4.0 * x3 + 7.0 * x4 - 3.0 * x5) * s->v1[k] +
               0.5 * h * h * ((x2 - 3.0 * x3 + 3.0 * x4 - x5) * s->a0[k] + (x3 - 2.0 * x4 + x5) * s->a1[k]);
        v[k] =
            30.0 * (x2 - 2.0 * x3 + x4) * dq / h + (1.0 - 18.0 * x2 + 32.0 * x3 - 15.0 * x4) * s->v0[k] +
            (-12.0 * x2 + 28.0 * x3 - 15.0 * x4) * s->v1[k] +
            0.5 * h *
                ((2.0 * x - 9.0 * x2 + 12.0 * x3 - 5.0 * x4) * s->a0[k] + (3.0 * x2 - 8.0 * x3 + 5.0 * x4) * s->a1[k]);
    }
    for (int32_t k = 0; books != NULL && k < s->system->books; k++)
        books[k] = s->books0[k] + (3.0 * x2 - 2.0 * x3) * (s->books1[k] - s->books0[k]) +
                   h * ((x - 2.0 * x2 + x3) * s->power0[k] + (x3 - x2) * s->power1[k]);
    return TINKER_OK;
}

/* Declaration */

static const TinkerIntegrator integrators[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT | TINKER_INTEGRATOR_SYMPLECTIC,
    .id = "gauss-6",
    .title = "Gauss, order 6",
    .summary = "Three implicit stages: long undamped motion with large steps.",
    .source = "E. Hairer, Ch. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., II.1.3, VIII.6",
    .order = 6,
    .dense_order = 5,
    .evaluations_per_step = 22,
    .imaginary_limit = 3.5, /* up to here MOST_ITERATIONS are enough: (0.2153 * 3.5)^200 < 1e-24 */
    .real_limit = 3.0,      /* (0.2153 * 3)^100 < 1e-18 */
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

TINKER_DEFINE_INTEGRATOR_PLUGIN("org.example.gauss-6", "Gauss", "1.0.0", "MIT", integrators)

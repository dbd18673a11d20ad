/* The method of Adams and Bashforth of order 2, with steps of any length.
 *
 * With y = (q, v) and y' = f = (v, a), and f_p and h_p of the step before,
 *
 *     y1 = y0 + h (f0 + d / 2),   d = (h / h_p) (f0 - f_p)
 *
 * where d is by how much f changes over the step. Where there is no step before, d comes from a trial with Euler's
 * method, d = f(t0 + h, y0 + h f0) - f0, which makes it Heun's. */
#include <math.h>
#include <stdlib.h>

#include <tinker/sdk.h>

/* The stepper */

typedef struct {
    const TinkerSystem *system;
    double t0, h;              /* the last step began here and was so long; h is 0 where there is none */
    double *q0, *v0, *books0;  /* where it began */
    double *a0, *power0;       /* f there: v0 and these */
    double *dv, *da, *dpower;  /* d */
    double *q, *v, *a, *power; /* for work */
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
    const size_t n = (size_t)system->size, m = (size_t)system->books;
    Stepper *s = calloc(1, sizeof *s + (8 * n + 4 * m) * sizeof(double));
    if (s == NULL) return NULL;
    double *next = s->memory;
    double **const of_size[] = {&s->q0, &s->v0, &s->a0, &s->dv, &s->da, &s->q, &s->v, &s->a};
    double **const of_books[] = {&s->books0, &s->power0, &s->dpower, &s->power};
    for (size_t i = 0; i < sizeof of_size / sizeof *of_size; i++)
        *of_size[i] = take(&next, system->size);
    for (size_t i = 0; i < sizeof of_books / sizeof *of_books; i++)
        *of_books[i] = take(&next, system->books);
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

/* A step */

/* to = from + h (s f + s^2 d / 2): the method between 0 and 1, and what it is at the end where s is 1. */
static void advance(int32_t count, double h, double s, const double *from, const double *f, const double *d, double *to)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = from[i] + h * (s * f[i] + 0.5 * s * s * d[i]);
}

/* d = factor (f - f_p), and f_p becomes f. */
static void difference(int32_t count, double factor, const double *f, double *before, double *d)
{
    for (int32_t i = 0; i < count; i++) {
        d[i] = factor * (f[i] - before[i]);
        before[i] = f[i];
    }
}

/* d of a first step. */
static TinkerStatus try_euler(Stepper *s, double h)
{
    const TinkerSystem *system = s->system;
    for (int32_t i = 0; i < system->size; i++) {
        s->q[i] = s->q0[i] + h * s->v0[i];
        s->v[i] = s->v0[i] + h * s->a0[i];
    }
    TinkerStatus status = system->acceleration(system->context, s->t0 + h, s->q, s->v, s->a, s->power);
    for (int32_t i = 0; i < system->size; i++) {
        s->dv[i] = s->v[i] - s->v0[i];
        s->da[i] = s->a[i] - s->a0[i];
    }
    for (int32_t i = 0; i < system->books; i++)
        s->dpower[i] = s->power[i] - s->power0[i];
    return status;
}

/* Leaves where the step begins, f there and d in the stepper. */
static TinkerStatus prepare(Stepper *s, const TinkerState *state, double h)
{
    const TinkerSystem *system = s->system;
    const int first = s->h == 0.0;
    const double factor = first ? 0.0 : h / s->h;
    TinkerStatus status = system->acceleration(system->context, state->t, state->q, state->v, s->a, s->power);
    if (status != TINKER_OK) return status;
    difference(system->size, factor, state->v, s->v0, s->dv);
    difference(system->size, factor, s->a, s->a0, s->da);
    difference(system->books, factor, s->power, s->power0, s->dpower);
    s->t0 = state->t;
    for (int32_t i = 0; i < system->size; i++)
        s->q0[i] = state->q[i];
    for (int32_t i = 0; i < system->books; i++)
        s->books0[i] = state->books[i];
    return first ? try_euler(s, h) : TINKER_OK;
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
    const TinkerSystem *system = s->system;
    const double h = limit - state->t;
    int32_t moved = 0;
    report->t_from = state->t;
    report->step = h;
    report->rejected = 0;
    report->error = 0.0;
    report->failure = NULL;
    if (h == 0.0 || !isfinite(h)) return fail(s, report, "a step must end at another, finite time");
    TinkerStatus status = prepare(s, state, h);
    if (status != TINKER_OK) return fail(s, report, "the forces cannot be worked out; a smaller step may help");

    advance(system->size, h, 1.0, s->q0, s->v0, s->dv, s->q);
    advance(system->size, h, 1.0, s->v0, s->a0, s->da, s->v);
    if (system->flags & TINKER_SYSTEM_CONSTRAINED) status = system->project(system->context, limit, s->q, s->v, &moved);
    if (status != TINKER_OK) return fail(s, report, "the rods cannot be kept; a smaller step may help");

    for (int32_t i = 0; i < system->size; i++) {
        state->q[i] = s->q[i];
        state->v[i] = s->v[i];
    }
    advance(system->books, h, 1.0, s->books0, s->power0, s->dpower, state->books);
    state->t = limit;
    s->h = h;
    return TINKER_OK;
}

/* Between steps */

static TinkerStatus interpolate(void *stepper, double t, double *q, double *v, double *books)
{
    const Stepper *s = stepper;
    if (s->h == 0.0) return TINKER_FAILED;
    const double part = (t - s->t0) / s->h;
    advance(s->system->size, s->h, part, s->q0, s->v0, s->dv, q);
    advance(s->system->size, s->h, part, s->v0, s->a0, s->da, v);
    if (books != NULL) advance(s->system->books, s->h, part, s->books0, s->power0, s->dpower, books);
    return TINKER_OK;
}

/* Declaration */

static const TinkerIntegrator integrators[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT,
    .id = "adams-bashforth-2",
    .title = "Adams-Bashforth, order 2",
    .summary = "One evaluation a step: smooth, damped motion with small steps.",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., III.1, III.5",
    .order = 2,
    .dense_order = 2,
    .evaluations_per_step = 1,
    .imaginary_limit = 0.0, /* an undamped oscillator grows, if slowly, with any step */
    .real_limit = 1.0,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

TINKER_DEFINE_INTEGRATOR_PLUGIN("org.example.adams-bashforth", "Adams-Bashforth", "1.0.0", "MIT", integrators)

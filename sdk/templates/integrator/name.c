/* @title@: the midpoint method, the smallest explicit method of order 2.
 *
 * With y = (q, v) and y' = f = (v, a): one evaluation at the start, one at the middle of the step,
 *     ym = y0 + (h / 2) f(t0, y0),   y1 = y0 + h f(t0 + h / 2, ym). */
#include <math.h>
#include <stdlib.h>

#include <tinker/sdk.h>

/* A stepper: all memory is allotted when it is made, none inside a step. */
typedef struct {
    const TinkerSystem *system;
    double t0, h;                   /* the last step began here and was so long; h is 0 where there is none */
    double *q0, *v0, *a0, *vm, *am; /* its start, the derivatives there and at the middle */
    double *w0, *p0, *pm;           /* likewise the books: energies, and their powers */
    double *q1, *v1;                /* for work */
    double memory[];
} Stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    const size_t n = (size_t)system->size, m = (size_t)system->books;
    Stepper *s = calloc(1, sizeof *s + (7 * n + 3 * m) * sizeof(double));
    if (s == NULL) return NULL;
    double **const of_size[] = {&s->q0, &s->v0, &s->a0, &s->vm, &s->am, &s->q1, &s->v1};
    double **const of_books[] = {&s->w0, &s->p0, &s->pm};
    for (size_t i = 0; i < sizeof of_size / sizeof *of_size; i++)
        *of_size[i] = s->memory + i * n;
    for (size_t i = 0; i < sizeof of_books / sizeof *of_books; i++)
        *of_books[i] = s->memory + 7 * n + i * m;
    s->system = system;
    return s;
}

static void destroy(void *stepper)
{
    free(stepper);
}

/* Nothing is carried over from step to step but what `interpolate` needs. */
static void restart(void *stepper)
{
    ((Stepper *)stepper)->h = 0.0;
}

/* The law ---------------------------------------------------------------------------------------------------------- */

/* to = from + h f */
static void advance(int32_t count, double h, const double *from, const double *f, double *to)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = from[i] + h * f[i];
}

static void copy(int32_t count, const double *from, double *to)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = from[i];
}

static TinkerStatus fail(Stepper *s, TinkerStepReport *report, const char *otherwise)
{
    const char *reason = s->system->failure == NULL ? NULL : s->system->failure(s->system->context);
    s->h = 0.0;
    report->failure = reason != NULL ? reason : otherwise;
    return TINKER_FAILED;
}

/* The derivatives at the start and at the middle of the step. */
static TinkerStatus evaluate(Stepper *s, double h)
{
    const TinkerSystem *system = s->system;
    TinkerStatus status = system->acceleration(system->context, s->t0, s->q0, s->v0, s->a0, s->p0);
    if (status != TINKER_OK) return status;
    advance(system->size, 0.5 * h, s->q0, s->v0, s->q1);
    advance(system->size, 0.5 * h, s->v0, s->a0, s->vm);
    return system->acceleration(system->context, s->t0 + 0.5 * h, s->q1, s->vm, s->am, s->pm);
}

/* One step from the state to `limit`; where it fails the state stays as it was. */
static TinkerStatus step(void *stepper, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *s = stepper;
    const TinkerSystem *system = s->system;
    const double h = limit - state->t;
    int32_t moved = 0;
    report->t_from = s->t0 = state->t;
    report->step = h;
    report->rejected = 0;
    report->error = 0.0;
    report->failure = NULL;
    if (h == 0.0 || !isfinite(h)) return fail(s, report, "a step must end at another, finite time");
    copy(system->size, state->q, s->q0);
    copy(system->size, state->v, s->v0);
    copy(system->books, state->books, s->w0);
    TinkerStatus status = evaluate(s, h);
    if (status != TINKER_OK) return fail(s, report, "the forces cannot be worked out; a smaller step may help");

    advance(system->size, h, s->q0, s->vm, s->q1);
    advance(system->size, h, s->v0, s->am, s->v1);
    if (system->flags & TINKER_SYSTEM_CONSTRAINED)
        status = system->project(system->context, limit, s->q1, s->v1, &moved);
    if (status != TINKER_OK) return fail(s, report, "the rods cannot be kept; a smaller step may help");

    copy(system->size, s->q1, state->q);
    copy(system->size, s->v1, state->v);
    advance(system->books, h, s->w0, s->pm, state->books);
    state->t = limit;
    s->h = h;
    return TINKER_OK;
}

/* Inside the last step, with x from 0 to 1: y = y0 + h x (f0 + x (fm - f0)), which has order 2, too. */
static void blend(int32_t count, double h, double x, const double *from, const double *f0, const double *fm, double *to)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = from[i] + h * x * (f0[i] + x * (fm[i] - f0[i]));
}

static TinkerStatus interpolate(void *stepper, double t, double *q, double *v, double *books)
{
    const Stepper *s = stepper;
    if (s->h == 0.0) return TINKER_FAILED;
    const double x = (t - s->t0) / s->h;
    blend(s->system->size, s->h, x, s->q0, s->v0, s->vm, q);
    blend(s->system->size, s->h, x, s->v0, s->a0, s->am, v);
    if (books != NULL) blend(s->system->books, s->h, x, s->w0, s->p0, s->pm, books);
    return TINKER_OK;
}

/* The declaration -------------------------------------------------------------------------------------------------- */

static const TinkerIntegrator integrators[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT,
    .id = "@name@",
    .title = "@title@",
    .summary = "The midpoint method: two evaluations a step, for smooth, damped motion with small steps.",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.1",
    .order = 2,
    .dense_order = 2,
    .evaluations_per_step = 2,
    .imaginary_limit = 0.0, /* an undamped oscillator grows, if slowly, with any step */
    .real_limit = 2.0,      /* 1 + z + z^2 / 2 = 1 at z = -2 */
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

TINKER_DEFINE_INTEGRATOR_PLUGIN("org.example.@name@", "@title@", "0.1.0", "MIT", integrators)

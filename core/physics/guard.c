/* The largest frequency comes from power iteration on M^-1 K at the start; the connector to blame is the one that is
 * stiffest against the masses at its ends. */
#include "physics/guard.h"

#include <math.h>
#include <string.h>

#define POWER_ITERATIONS 60

/* The stiffest part of a model at its start. */
typedef struct {
    double frequency;     /* rad/s: of the largest natural frequency, were there no constraints; from below */
    double damping_rate;  /* 1/s: of the largest damping over mass */
    TinkerBlockId block;  /* the connector to blame; TINKER_NO_BLOCK where there is none */
    const char *property; /* its property that makes it stiff */
} Stiffness;

static double norm(const TinkerModel *model, const double *x)
{
    double sum = 0;
    for (int32_t i = 0; i < 2 * model->bodies; i++)
        sum += model->coordinate_mass[i] * x[i] * x[i];
    return sqrt(sum);
}

/* The largest eigenvalue (in size) of a product, by power iteration from a vector without symmetry. */
static double largest_eigenvalue(TinkerModel *model, TinkerStatus (*product)(TinkerModel *, const double *, double *))
{
    gsize n = 2 * (gsize)model->bodies;
    g_autofree double *x = g_new(double, MAX(n, 1)), *y = g_new(double, MAX(n, 1));
    for (gsize i = 0; i < n; i++)
        x[i] = 1.0 + 0.5 * sin(12.9898 * (double)(i + 1));
    double eigenvalue = 0;
    for (int iteration = 0; iteration < POWER_ITERATIONS; iteration++) {
        double size = norm(model, x);
        if (!(size > 0) || !isfinite(size)) break;
        for (gsize i = 0; i < n; i++)
            x[i] /= size;
        if (product(model, x, y) != TINKER_OK) break;
        eigenvalue = norm(model, y);
        memcpy(x, y, n * sizeof(double));
    }
    return isfinite(eigenvalue) ? eigenvalue : 0;
}

static double mobility(const TinkerModel *model, int32_t point)
{
    return point < model->bodies ? model->inverse_mass[point] : 0.0;
}

/* Among all line laws, the block with the largest derivative over mass; answers that value. */
static double blame(TinkerModel *model, gboolean damping, TinkerBlockId *block, const char **property)
{
    double most = 0;
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics == NULL || physics->line_law == NULL || physics->line_law->linear == NULL) continue;
        gsize n = (gsize)batch->count;
        g_autofree double *values = g_new0(double, 4 * n);
        TinkerBatch view = tinker_block_batch_view(batch, 0.0);
        if (physics->line_law->linear(&view, values, values + n, values + 2 * n, values + 3 * n) != TINKER_OK) continue;
        const int32_t *points = tinker_model_end_points(model, batch);
        for (gsize row = 0; row < n; row++) {
            double rate = values[damping ? n + row : row] *
                          (mobility(model, points[2 * row]) + mobility(model, points[2 * row + 1]));
            if (!(rate > most)) continue;
            most = rate;
            *block = batch->ids[row];
            *property = damping ? "damping" : "stiffness";
        }
    }
    return most;
}

static Stiffness stiffness_of(TinkerModel *model)
{
    Stiffness found = {.block = TINKER_NO_BLOCK};
    if (tinker_model_set_time(model, 0.0) != TINKER_OK) return found;
    tinker_model_set_state(model, model->q_start, model->v_start);
    found.frequency = sqrt(largest_eigenvalue(model, tinker_model_stiffness_product));
    found.damping_rate = largest_eigenvalue(model, tinker_model_damping_product);
    TinkerBlockId stiff = TINKER_NO_BLOCK, damped = TINKER_NO_BLOCK;
    const char *stiff_property = NULL, *damped_property = NULL;
    double stiffness = sqrt(blame(model, FALSE, &stiff, &stiff_property));
    double damping = blame(model, TRUE, &damped, &damped_property);
    found.block = damping > stiffness ? damped : stiff;
    found.property = damping > stiffness ? damped_property : stiff_property;
    return found;
}

/* The largest stable step of a fixed-step explicit method; INFINITY where nothing limits it. */
static double stable_step(const Stiffness *stiffness, const TinkerIntegrator *integrator)
{
    double step = INFINITY;
    if (integrator->imaginary_limit >= 0 && stiffness->frequency > 0)
        step = integrator->imaginary_limit / stiffness->frequency;
    if (integrator->real_limit >= 0 && stiffness->damping_rate > 0)
        step = MIN(step, integrator->real_limit / stiffness->damping_rate);
    return step;
}

char *tinker_guard_explain(TinkerModel *model, const TinkerIntegrator *integrator, double step)
{
    Stiffness stiffness = stiffness_of(model);
    double stable = stable_step(&stiffness, integrator);
    GString *text = g_string_new(NULL);
    if (stiffness.block != TINKER_NO_BLOCK)
        g_string_append_printf(text, "the %s of %s makes the fastest motion", stiffness.property,
                               tinker_scene_block_name(model->scene, stiffness.block));
    else
        g_string_append(text, "no single connector is to blame");
    if (!(integrator->flags & TINKER_INTEGRATOR_ADAPTIVE) && isfinite(stable) && stable > 0) {
        g_string_append_printf(text, "; %s is stable up to a step of about %.3g s here", integrator->id, stable);
        if (step > stable) g_string_append_printf(text, ", the step was %.3g s", step);
    }
    g_string_append(text, integrator->flags & TINKER_INTEGRATOR_ADAPTIVE ? "; use a smaller tolerance"
                                                                         : "; use a smaller step, or the method auto");
    return g_string_free(text, FALSE);
}

/* The largest frequency comes from power iteration on M^-1 K, from below. The vector is kept from look to look, so one
 * round each follows a spectrum that changes slowly; it costs about as much as an evaluation. */
#include "physics/island/stability-watch.h"
#include "physics/system/method-call.h"

#include <math.h>

#include "physics/force/forces.h"
#include "physics/model/model.h"
#include "physics/plan/plan.h"
#include "physics/system/system.h"

#define LOOKS_BETWEEN 2
#define FIRST_ROUNDS  30
/* Beyond this share of the limit it is told: a motion past it is lost within a few steps. */
#define NEAR 0.9

struct _TinkerStabilityWatch {
    TinkerModel *model;
    double limit; /* of the step times the frequency */
    double step;
    int looks;
    gboolean told;
    double *x, *y; /* 2 a body */
};

static double norm(const TinkerModel *model, const double *x)
{
    double sum = 0;
    for (int32_t i = 0; i < model->coordinates; i++)
        sum += model->coordinate_mass[i] * x[i] * x[i];
    return sqrt(sum);
}

static double largest_frequency(TinkerStabilityWatch *watch, int rounds)
{
    double square = 0;
    for (int round = 0; round < rounds; round++) {
        double size = norm(watch->model, watch->x);
        if (!(size > 0) || !isfinite(size)) return 0;
        for (int32_t i = 0; i < watch->model->coordinates; i++)
            watch->x[i] /= size;
        if (tinker_model_stiffness_product(watch->model, watch->x, watch->y) != TINKER_OK) return 0;
        square = norm(watch->model, watch->y);
        double *product = watch->y;
        watch->y = watch->x;
        watch->x = product;
    }
    return isfinite(square) ? sqrt(square) : 0;
}

TinkerStabilityWatch *tinker_stability_watch_new(const TinkerModelSystem *system, const TinkerIntegrator *method,
                                                 double step)
{
    TinkerModel *model = system->model;
    /* With constraints the fastest motion of the forces alone may be one that is held. */
    if (!tinker_method_is_fixed_explicit(method) || system->form != NULL || model->constraints.rows > 0) return NULL;
    if (!(method->imaginary_limit > 0) || model->bodies == 0) return NULL;
    TinkerStabilityWatch *watch = g_new0(TinkerStabilityWatch, 1);
    gsize n = (gsize)model->coordinates;
    *watch = (TinkerStabilityWatch){
        .model = model,
        .limit = method->imaginary_limit,
        .step = step,
        .x = g_new(double, n),
        .y = g_new(double, n),
    };
    for (gsize i = 0; i < n; i++) /* a vector without symmetry */
        watch->x[i] = 1.0 + 0.5 * sin(12.9898 * (double)(i + 1));
    if (largest_frequency(watch, FIRST_ROUNDS) * step <= watch->limit) return watch;
    tinker_stability_watch_free(watch);
    return NULL;
}

void tinker_stability_watch_free(TinkerStabilityWatch *watch)
{
    if (watch == NULL) return;
    g_free(watch->x);
    g_free(watch->y);
    g_free(watch);
}

double tinker_stability_watch_look(TinkerStabilityWatch *watch)
{
    if (watch == NULL || watch->told || ++watch->looks % LOOKS_BETWEEN != 0) return 0;
    double frequency = largest_frequency(watch, 1);
    if (!(frequency * watch->step > NEAR * watch->limit)) return 0;
    watch->told = TRUE;
    return watch->limit / frequency;
}

/* Operation counts of whole runs. The constants were measured once, on one machine, by runs of an oscillator, of a
 * stiff chain of fifty masses and of the bundled scenes; they are written down here and never measured again, so that a
 * choice that rests on them is the same everywhere and always. One operation stands for TINKER_SECONDS_PER_OPERATION
 * there. */
#include "physics/plan/operations.h"

#include <math.h>

#include "numerics/exact/exact.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/plan/row-operations.h"

/* Of one evaluation: whatever there is, and for each part of the model. */
#define PER_EVALUATION 140.0
#define PER_LINE       14.0
#define PER_BODY       8.0
#define PER_FIELD_BODY 24.0 /* each asked field, a body */
#define PER_EDGE       8.0  /* of a linear form */
/* Of one step: watching it, and for each coordinate the method's own sums over its stages. */
#define PER_STEP             60.0
#define PER_STAGE_COORDINATE 4.0
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

/* Entries of the state: of an island's line, or of its model. */
static int32_t coordinates_of(const TinkerIsland *island)
{
    return island->linear != NULL ? tinker_linear_form_system(island->linear)->size : island->model->coordinates;
}

/* Of the plugins of one evaluation. */
static double asked(const GArray *batches)
{
    double sum = 0;
    for (guint i = 0; i < batches->len; i++)
        sum += TINKER_OPERATIONS_ASKED * g_array_index(batches, TinkerAskedBatch, i).batch->count;
    return sum;
}

/* Operations of one evaluation of an island's accelerations. */
static double evaluation_cost(const TinkerIsland *island)
{
    const TinkerModel *model = island->model;
    if (island->linear != NULL) {
        const TinkerLinearSystem *linear = tinker_linear_form_system(island->linear);
        return PER_EVALUATION + PER_EDGE * linear->edge_count + 0.5 * PER_BODY * linear->size;
    }
    return PER_EVALUATION + PER_LINE * model->lines.count + PER_BODY * model->bodies + asked(model->asked_lines) +
           asked(model->asked_forces) + PER_FIELD_BODY * model->asked_fields->len * model->bodies +
           tinker_row_operations(model);
}

double tinker_operations_sample(const TinkerIsland *island)
{
    return PER_SAMPLE + PER_SAMPLE_COORDINATE * coordinates_of(island) +
           SAMPLE_ROWS * tinker_row_operations(island->model);
}

double tinker_operations_explicit(const TinkerIsland *island, double steps, double evaluations)
{
    return steps * (PER_STEP + tinker_row_operations_of_projection(island->model)) +
           evaluations * (evaluation_cost(island) + PER_STAGE_COORDINATE * coordinates_of(island));
}

/* Of one solve: a chain or tree has a factor of its own size, a mesh one of about the square root's width. */
static double band_width(const TinkerIsland *island)
{
    const TinkerModel *model = island->model;
    double axes = island->linear != NULL && coordinates_of(island) == model->bodies ? 1 : 2, inner = 0;
    for (int32_t i = 0; i < model->lines.count; i++)
        inner += MAX(model->lines.a[i], model->lines.b[i]) < model->bodies;
    return inner < model->bodies ? axes : axes * sqrt((double)MAX(model->bodies, 1));
}

double tinker_operations_implicit(const TinkerIsland *island)
{
    double n = coordinates_of(island), width = band_width(island), evaluation = evaluation_cost(island);
    double solve = n * (4 * width + 20), factor = n * (2 * width * width + 8);
    if (island->linear != NULL) return PER_STEP + evaluation + solve + PER_STAGE_COORDINATE * n;
    return PER_STEP + NEWTON_STEPS * ((1 + JACOBIAN_SHARE) * evaluation + factor + solve) +
           tinker_row_operations_of_projection(island->model) + PER_STAGE_COORDINATE * n;
}

double tinker_operations_exact(const TinkerIsland *island, double steps)
{
    double once = 0;
    double each = tinker_exact_operations(tinker_linear_form_system(island->linear), (gint64)steps, &once);
    return once + each + steps * PER_STEP;
}

/* A sample is one more propagator. */
double tinker_operations_exact_sample(const TinkerIsland *island)
{
    return tinker_operations_sample(island) +
           tinker_exact_operations(tinker_linear_form_system(island->linear), 1, NULL);
}

static gboolean needs_series(const TinkerIsland *island)
{
    const TinkerLinearSystem *linear = tinker_linear_form_system(island->linear);
    return linear->force_count + linear->motion_count > 0 || !tinker_exact_is_proportional(linear);
}

TinkerOperationRates tinker_operations_rates(const TinkerIsland *island, const TinkerIntegrator *method)
{
    TinkerOperationRates rates = {.look = PER_LOOK, .correction = tinker_row_operations_of_correction(island->model)};
    if (method->flags & TINKER_INTEGRATOR_IMPLICIT) {
        rates.step = tinker_operations_implicit(island);
        return rates;
    }
    rates.evaluation = tinker_operations_explicit(island, 0, 1);
    if (!(method->flags & TINKER_INTEGRATOR_LINEAR)) {
        rates.step = tinker_operations_explicit(island, 1, 0);
        return rates;
    }
    const double series = needs_series(island) ? SERIES_PER_STEP * PER_SERIES : 0;
    rates.step = series + PER_STEP + tinker_exact_operations(tinker_linear_form_system(island->linear), 1, &rates.once);
    return rates;
}

double tinker_operations_counted(const TinkerOperationRates *rates, const TinkerCounts *counts)
{
    return rates->once + rates->step * counts->steps + rates->evaluation * counts->evaluations +
           rates->look * counts->looks + rates->correction * counts->corrections;
}

double tinker_operations_samples(const TinkerIsland *island, const TinkerIntegrator *method, double samples)
{
    if (!(method->flags & TINKER_INTEGRATOR_LINEAR)) return samples * tinker_operations_sample(island);
    const double series = needs_series(island) ? PER_SERIES : 0;
    return samples * (tinker_operations_exact_sample(island) + series);
}

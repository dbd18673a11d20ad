/* Spectral measures of the start's acceleration and velocity, and of a vector without symmetry for the extremes. */
#include "physics/plan/forecast.h"

#include <math.h>

#include "numerics/solve/eigen.h"
#include "physics/constraint/constraints.h"
#include "physics/line/linear-form.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/start-matrices.h"
#include "physics/plan/tolerances.h"

/* What an island's places and motions are measured by. */
typedef struct {
    double extent, speed, acceleration; /* m, m/s, m/s^2 */
    double root_mass;                   /* of all bodies together */
} Measures;

static Measures measures_of(const TinkerModel *model, const TinkerStartMatrices *matrices)
{
    Measures found = {0};
    double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY}, mass = 0;
    for (int32_t i = 0; i < model->points; i++) {
        if (!model->point_used[i]) continue;
        box[0] = fmin(box[0], model->point[i].x);
        box[1] = fmin(box[1], model->point[i].y);
        box[2] = fmax(box[2], model->point[i].x);
        box[3] = fmax(box[3], model->point[i].y);
    }
    for (int32_t i = 0; i < model->bodies; i++) {
        found.speed = fmax(found.speed, hypot(model->v_start[2 * i], model->v_start[2 * i + 1]));
        mass += model->mass[i];
    }
    if (model->points > 0 && box[2] >= box[0]) found.extent = hypot(box[2] - box[0], box[3] - box[1]);
    found.extent = fmax(found.extent, tinker_constraints_reach(model));
    int32_t n = tinker_start_matrices_size(matrices);
    const double *a = tinker_start_matrices_acceleration(matrices);
    double square = 0;
    for (int32_t i = 0; i < n; i++)
        square += a[i] * a[i];
    found.root_mass = sqrt(mass);
    found.acceleration = mass > 0 ? sqrt(square / mass) : 0;
    return found;
}

static void add_part(TinkerForecast *forecast, const Measures *measures, double omega, double damping, double energy)
{
    double amplitude = omega > 0 ? sqrt(energy) / omega : INFINITY;
    if (!(energy > 0) || amplitude < TINKER_LEAST_AMPLITUDE * measures->extent * measures->root_mass) return;
    forecast->parts[forecast->count++] = (TinkerForecastPart){omega, fmax(damping, 0), energy, 0};
}

/* `bent`: of the acceleration, whose parts are divided by the stiffness; else of the velocity. */
static void add_vector(TinkerForecast *forecast, TinkerStartMatrices *matrices, const Measures *measures,
                       const double *vector, gboolean bent)
{
    TinkerSpectralMeasure found;
    int32_t n = tinker_start_matrices_size(matrices);
    TinkerOperator damping = tinker_start_matrices_damped(matrices) ? tinker_start_matrices_damping : NULL;
    double square = 0;
    for (int32_t i = 0; i < n; i++)
        square += vector[i] * vector[i];
    tinker_spectral_measure(n, TINKER_FORECAST_STEPS, tinker_start_matrices_stiffness, damping, matrices, vector,
                            &found);
    for (int32_t k = 0; k < found.count; k++) {
        double omega = sqrt(fmax(found.nodes[k], 0));
        forecast->omega_max = fmax(forecast->omega_max, omega);
        forecast->damping_max = fmax(forecast->damping_max, found.forms[k]);
        if (omega <= TINKER_LEAST_FREQUENCY * forecast->omega_max) omega = 0;
        if (omega == 0) forecast->fading = fmax(forecast->fading, found.forms[k]);
        if (bent && omega == 0) continue;
        add_part(forecast, measures, omega, found.forms[k], square * found.weights[k] / (bent ? omega * omega : 1));
    }
}

static double greatest_node(TinkerStartMatrices *matrices, TinkerOperator product, const double *vector)
{
    TinkerSpectralMeasure found;
    int32_t n = tinker_start_matrices_size(matrices);
    tinker_spectral_measure(n, TINKER_FORECAST_STEPS, product, NULL, matrices, vector, &found);
    return found.count > 0 ? found.nodes[found.count - 1] : 0;
}

static void find_extremes(TinkerForecast *forecast, TinkerStartMatrices *matrices)
{
    int32_t n = tinker_start_matrices_size(matrices);
    g_autofree double *vector = g_new(double, n);
    for (int32_t i = 0; i < n; i++)
        vector[i] = 1.0 + 0.5 * sin(12.9898 * (i + 1));
    double stiffness = greatest_node(matrices, tinker_start_matrices_stiffness, vector);
    forecast->omega_max = fmax(forecast->omega_max, sqrt(fmax(stiffness, 0)));
    if (!tinker_start_matrices_damped(matrices)) return;
    forecast->damping_max = fmax(forecast->damping_max, greatest_node(matrices, tinker_start_matrices_damping, vector));
}

static double size_of(int32_t n, const double *x)
{
    double square = 0;
    for (int32_t i = 0; i < n; i++)
        square += x[i] * x[i];
    return sqrt(square);
}

/* Of x'' = -omega^2 x + g Jx', which is turned aside: the faster of its two circles. */
static double turned_frequency(double omega, double turning)
{
    return 0.5 * turning + hypot(0.5 * turning, omega);
}

/* Forces across velocities (Coriolis's, a magnet's) turn the start's velocity by |A v| / |v|, A the antisymmetric part
 * of the damping; -A^2 is symmetric, and its largest eigenvalue the square of the fastest turn. */
static void square_of_turning(void *data, const double *x, double *y)
{
    TinkerStartMatrices *matrices = data;
    int32_t n = tinker_start_matrices_size(matrices);
    g_autofree double *once = g_new(double, n);
    tinker_start_matrices_turning(matrices, x, once);
    tinker_start_matrices_turning(matrices, once, y);
    for (int32_t i = 0; i < n; i++)
        y[i] = -y[i];
}

/* `first`: of the parts that the velocity holds. */
static void add_turning(TinkerForecast *forecast, TinkerStartMatrices *matrices, int32_t first)
{
    int32_t n = tinker_start_matrices_size(matrices);
    forecast->turned = tinker_start_matrices_turned(matrices);
    if (!forecast->turned) return;
    g_autofree double *across = g_new(double, n), *vector = g_new(double, n);
    for (int32_t i = 0; i < n; i++)
        vector[i] = 1.0 + 0.5 * sin(12.9898 * (i + 1));
    double fastest = sqrt(fmax(greatest_node(matrices, square_of_turning, vector), 0));
    forecast->omega_max = turned_frequency(forecast->omega_max, fastest);
    const double *velocity = tinker_start_matrices_velocity(matrices);
    double speed = size_of(n, velocity);
    tinker_start_matrices_turning(matrices, velocity, across);
    double turning = speed > 0 ? size_of(n, across) / speed : 0;
    for (int32_t i = first; i < forecast->count; i++)
        forecast->parts[i].omega = turned_frequency(forecast->parts[i].omega, turning);
}

double tinker_forecast_drive(const TinkerLinearForm *form)
{
    if (form == NULL) return 0;
    int32_t count = tinker_linear_form_system(form)->signal_count;
    g_autofree TinkerSignal *signals = g_new0(TinkerSignal, MAX(count, 1));
    double fastest = 0;
    if (count == 0 || tinker_linear_form_signals((TinkerLinearForm *)form, signals) != TINKER_OK) return 0;
    for (int32_t i = 0; i < count; i++)
        if (signals[i].kind == TINKER_SIGNAL_HARMONIC) fastest = fmax(fastest, fabs(signals[i].coefficient[1]));
    return fastest;
}

/* What the forces hold and the parts so far, which are those of the acceleration, do not. A body that hardly anything
 * holds would move too far for any of this to be true. */
static void add_unseen(TinkerForecast *forecast, TinkerStartMatrices *matrices, const Measures *measures)
{
    if (tinker_start_matrices_size(matrices) <= TINKER_FORECAST_STEPS || forecast->count == 0) return;
    double omega, energy = tinker_start_matrices_held_energy(matrices, &omega);
    for (int32_t i = 0; i < forecast->count; i++)
        energy -= forecast->parts[i].share;
    double most = omega * measures->extent * measures->root_mass;
    if (energy > 0 && energy < most * most) add_part(forecast, measures, omega, 0, energy);
}

static void share_out(TinkerForecast *forecast)
{
    double energy = 0, reach = 0;
    for (int32_t i = 0; i < forecast->count; i++) {
        TinkerForecastPart *part = &forecast->parts[i];
        part->reach = part->omega > 0 ? part->share / (part->omega * part->omega) : 0;
        energy += part->share;
        reach += part->reach;
    }
    for (int32_t i = 0; i < forecast->count; i++) {
        forecast->parts[i].share /= energy;
        if (reach > 0) forecast->parts[i].reach /= reach;
    }
}

/* The start's acceleration, without what only turns the velocity aside: no stiffness holds that. */
static double *bending(TinkerStartMatrices *matrices)
{
    int32_t n = tinker_start_matrices_size(matrices);
    double *a = g_new(double, n);
    tinker_start_matrices_turning(matrices, tinker_start_matrices_velocity(matrices), a);
    for (int32_t i = 0; i < n; i++)
        a[i] += tinker_start_matrices_acceleration(matrices)[i];
    return a;
}

void tinker_forecast(const TinkerIsland *island, TinkerForecast *forecast)
{
    *forecast = (TinkerForecast){0};
    g_autoptr(TinkerStartMatrices) matrices = tinker_start_matrices_new(island);
    if (matrices == NULL || tinker_start_matrices_size(matrices) == 0) return;
    Measures measures = measures_of(island->model, matrices);
    forecast->known = TRUE;
    find_extremes(forecast, matrices);
    g_autofree double *bent_by = bending(matrices);
    add_vector(forecast, matrices, &measures, bent_by, TRUE);
    add_unseen(forecast, matrices, &measures);
    int32_t bent = forecast->count;
    add_vector(forecast, matrices, &measures, tinker_start_matrices_velocity(matrices), FALSE);
    add_turning(forecast, matrices, bent);
    share_out(forecast);
    forecast->drive = tinker_forecast_drive(island->linear);
    if (measures.extent > 0)
        forecast->speed_of_change =
            fmax(sqrt(measures.acceleration / measures.extent), measures.speed / measures.extent);
    /* about the middle of the extent */
    if (island->linear == NULL) forecast->turning = 2 * forecast->speed_of_change;
}

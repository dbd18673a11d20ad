/* The companion is a simulation of its own, on a model of its own: nothing that it does can change a bit of the run. */
#include "physics/estimate.h"

#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/impulse.h"
#include "physics/linear-form.h"
#include "physics/simulation-private.h"

/* The distance from the companion is most of the error, not all: what is claimed is this much of it. */
#define SAFETY 2.0
/* Errors below this share of the scales are rounding. */
#define FLOOR (100 * DBL_EPSILON)
/* Beyond this share of the scales the motion is not predictable. */
#define UNPREDICTABLE 0.1
/* No tolerance is driven below rounding (with room for the rounding of its own value). Where a tenth would be, the companion
 * is ten times coarser instead. It is off by up to ten times the error; less, the more of that is rounding. */
#define LEAST_TOLERANCE 0.99e-14
#define COARSER_FACTOR  1.0
/* Where ends may pass each other an exact solution is exact from passing to passing only, and rounding may grow from each to
 * the next: its companion starts off by this share of the scales. */
#define START_OFF (6 * DBL_EPSILON)
/* Samples so near to an impact (a share of the time) may lie on either side of it. */
#define NEAR_IMPACT 1e-6
/* Of how far bodies are from the middle of what they rest on. */
#define REST 1e-9
/* Or of so many steps, where an impact is one of a whole step. */
#define STEPS_NEAR_IMPACT 3

struct _TinkerEstimate {
    TinkerSimulation *simulation;
    TinkerModel *model;          /* of the companion */
    TinkerSimulation *companion; /* NULL where no island needs one, and once it has failed */
    gboolean failed;
    guint columns;
    double *bands;         /* by column, or NULL */
    double *factors;       /* of each island: error over distance; 0 where rounding is all there is */
    double *apart;         /* m, m/s: of each island, the largest distances so far, of places and of velocities */
    double *accelerations; /* m/s^2: of each island, the largest so far */
    double *scratch;       /* room for the accelerations of an island */
    double error, predictable_until;
};

static gboolean is_exact(const TinkerIslandRun *run)
{
    return (run->choice.method->flags & TINKER_INTEGRATOR_LINEAR) != 0;
}

/* Whether the ends of a connector may pass each other, with a length or a tension that pushes the other way then. */
static gboolean may_pass(const TinkerIslandRun *run)
{
    const TinkerLinearSystem *linear = tinker_linear_form_system(run->island->linear);
    for (int32_t i = 0; i < linear->edge_count; i++)
        if (linear->edges[i].stiffness * linear->edges[i].length != 0 || linear->edges[i].tension != 0) return TRUE;
    return FALSE;
}

static gboolean is_adaptive(const TinkerIslandRun *run)
{
    return (run->choice.method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
}

static gboolean can_be_finer(const TinkerIslandRun *run)
{
    return !is_adaptive(run) || run->choice.tolerance / 10 >= LEAST_TOLERANCE;
}

static TinkerChoice choice_of_companion(const TinkerIslandRun *run)
{
    TinkerChoice choice = run->choice;
    choice.step /= 2;
    choice.tolerance = can_be_finer(run) ? choice.tolerance / 10 : 10 * choice.tolerance;
    return choice;
}

/* Error over distance from the companion. */
static double factor_of(const TinkerIslandRun *run)
{
    if (is_exact(run)) return may_pass(run) ? SAFETY : 0.0;
    if (!can_be_finer(run)) return COARSER_FACTOR;
    double less = is_adaptive(run) ? 0.1 : exp2(-run->choice.method->order);
    return SAFETY / (1.0 - less);
}

static TinkerSimulation *companion_of(TinkerSimulation *simulation, TinkerModel *model, GError **error)
{
    TinkerRunOptions options = simulation->options;
    options.estimate = FALSE;
    options.progress = NULL;
    g_autofree TinkerChoice *choices = g_new(TinkerChoice, simulation->runs->len);
    for (guint i = 0; i < simulation->runs->len; i++)
        choices[i] = choice_of_companion(g_ptr_array_index(simulation->runs, i));
    return tinker_simulation_new_chosen(model, &options, choices, error);
}

/* Turns by turns, so that bodies do not move as one. */
static void start_off(TinkerIslandRun *run)
{
    double extent, speed;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    for (int32_t i = 0; i < run->system.system.size; i++) {
        double turn = i % 2 == 0 ? START_OFF : -START_OFF;
        run->state.q[i] += turn * extent;
        run->state.v[i] += turn * speed;
    }
    tinker_method_restart(run->choice.method, run->stepper);
}

static gboolean open_companion(TinkerEstimate *estimate, const GArray *columns, GError **error)
{
    TinkerSimulation *simulation = estimate->simulation;
    estimate->model = tinker_model_new(simulation->model->scene, error);
    if (estimate->model == NULL) return FALSE;
    TinkerSimulation *companion = estimate->companion = companion_of(simulation, estimate->model, error);
    if (companion == NULL) return FALSE;
    for (guint i = 0; i < companion->runs->len; i++)
        if (is_exact(g_ptr_array_index(companion->runs, i)) && estimate->factors[i] > 0)
            start_off(g_ptr_array_index(companion->runs, i));
    if (columns == NULL || !simulation->options.bands) return TRUE;
    estimate->columns = columns->len;
    estimate->bands = g_new0(double, columns->len + 1);
    companion->sampler = tinker_sampler_new(estimate->model, columns);
    companion->values = g_new0(double, columns->len + 1);
    return TRUE;
}

static void warn_of_none(TinkerSimulation *simulation, const char *why)
{
    g_ptr_array_add(simulation->summary.warnings,
                    g_strdup_printf(_("there is no error estimate: the companion run cannot be set up (%s)"), why));
}

TinkerEstimate *tinker_estimate_new(TinkerSimulation *simulation, const GArray *columns)
{
    TinkerEstimate *estimate = g_new0(TinkerEstimate, 1);
    estimate->simulation = simulation;
    estimate->predictable_until = INFINITY;
    estimate->factors = g_new(double, simulation->runs->len);
    estimate->accelerations = g_new0(double, simulation->runs->len);
    estimate->apart = g_new0(double, 2 * (gsize)simulation->runs->len);
    estimate->scratch = g_new0(double, 2 * (gsize)simulation->model->bodies + 1);
    gboolean compares = FALSE;
    g_autoptr(GError) error = NULL;
    for (guint i = 0; i < simulation->runs->len; i++) {
        estimate->factors[i] = factor_of(g_ptr_array_index(simulation->runs, i));
        compares |= estimate->factors[i] > 0;
    }
    if (!compares || open_companion(estimate, columns, &error)) return estimate;
    warn_of_none(simulation, error->message);
    tinker_estimate_free(estimate);
    return NULL;
}

void tinker_estimate_free(TinkerEstimate *estimate)
{
    if (estimate == NULL) return;
    tinker_simulation_free(estimate->companion);
    tinker_model_free(estimate->model);
    gpointer arrays[] = {estimate->bands, estimate->factors, estimate->apart, estimate->accelerations,
                         estimate->scratch};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(estimate);
}

/* What rounding makes of an exact solution by time t. A frequency w that is off by one part in 1 / epsilon moves places by
 * epsilon w t of their swing and speeds by as much of theirs, which is epsilon t times the largest speed and acceleration. */
static double rounding(TinkerEstimate *estimate, guint number, double t)
{
    TinkerIslandRun *run = g_ptr_array_index(estimate->simulation->runs, number);
    TinkerSystem *system = &run->system.system;
    double extent, speed, *greatest = &estimate->accelerations[number];
    gint64 evaluations = run->model->evaluations;
    if (system->acceleration(system->context, run->state.t, run->state.q, run->state.v, estimate->scratch, NULL) ==
        TINKER_OK)
        *greatest = fmax(*greatest, tinker_greatest(estimate->scratch, system->size));
    run->model->evaluations = evaluations;
    system->scales(system->context, run->state.q, run->state.v, &extent, &speed);
    double places = extent > 0 ? speed / extent : 0, speeds = speed > 0 ? *greatest / speed : 0;
    return DBL_EPSILON * t * fmax(places, speeds);
}

/* Where a tolerance is so loose that breaks and samples alone make the steps, a tighter one makes the same, and says
 * nothing. */
static gboolean same_steps(const TinkerIslandRun *run, const TinkerIslandRun *companion)
{
    return is_adaptive(run) && companion->summary.steps == run->summary.steps && run->summary.steps > 0;
}

/* Within the reach of an impact the two may stand on its two sides, where velocities tell nothing. */
static gboolean strikes_near(const TinkerIslandRun *run, double t)
{
    if (run->choice.method == &tinker_integrator_impulse)
        return fabs(tinker_impulse_last_impact(run->stepper) - t) <= STEPS_NEAR_IMPACT * run->choice.step;
    if (run->contacts == NULL) return FALSE;
    return fabs(tinker_contact_run_last_impact(run->contacts) - t) <= NEAR_IMPACT * t;
}

/* Whether an island does nothing but rest on plates: what moves there is rounding, and has no scale. */
static gboolean rests(const TinkerIslandRun *run, double extent)
{
    const TinkerContacts *contacts = run->model->contacts;
    return tinker_contacts_act(contacts) && extent < REST * tinker_contacts_extent(contacts);
}

/* The largest distance of the two states of an island so far, by its present scales: what was much beside the first slow
 * moments may be little beside what follows. */
static double distance(const TinkerEstimate *estimate, guint number)
{
    TinkerIslandRun *run = g_ptr_array_index(estimate->simulation->runs, number);
    const TinkerSimulation *ours = estimate->simulation, *theirs = estimate->companion;
    const TinkerIslandRun *other = g_ptr_array_index(theirs->runs, number);
    gboolean strikes = strikes_near(run, ours->sample_time) || strikes_near(other, ours->sample_time);
    double extent, speed, *apart = &estimate->apart[2 * number], *faster = apart + 1;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    if (rests(run, extent)) return 0;
    for (int32_t i = 0; i < run->model->bodies; i++) {
        int32_t body = 2 * run->island->body_of[i];
        *apart = fmax(*apart, hypot(ours->sample_q[body] - theirs->sample_q[body],
                                    ours->sample_q[body + 1] - theirs->sample_q[body + 1]));
        if (strikes) continue;
        *faster = fmax(*faster, hypot(ours->sample_v[body] - theirs->sample_v[body],
                                      ours->sample_v[body + 1] - theirs->sample_v[body + 1]));
    }
    double places = extent > 0 ? *apart / extent : 0, speeds = 0;
    if (speed > tinker_island_run_speed_noise(run, extent)) speeds = *faster / speed;
    double off = estimate->factors[number] * fmax(places, speeds);
    return same_steps(run, g_ptr_array_index(theirs->runs, number)) ? fmax(off, run->choice.tolerance) : off;
}

/* A companion that cannot go on leaves everything behind it without an estimate. */
static gboolean give_up(TinkerEstimate *estimate, double t, GError *failed, GError **error)
{
    if (g_error_matches(failed, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) {
        g_propagate_error(error, failed);
        return FALSE;
    }
    g_ptr_array_add(estimate->simulation->summary.warnings,
                    g_strdup_printf(_("there is no error estimate beyond t = %.6g s: the companion run stopped (%s)"),
                                    t, failed->message));
    g_error_free(failed);
    g_clear_pointer(&estimate->companion, tinker_simulation_free);
    estimate->failed = TRUE;
    return TRUE;
}

void tinker_estimate_close(TinkerEstimate *estimate)
{
    if (isinf(estimate->predictable_until)) return;
    g_ptr_array_add(
        estimate->simulation->summary.warnings,
        g_strdup_printf(_("not predictable beyond t = %.6g s: there the estimated error passes a tenth of the "
                          "motion's own size (a smaller step or tolerance moves that time out, in "
                          "chaotic motion only a little)"),
                        estimate->predictable_until));
}

static void widen_bands(TinkerEstimate *estimate, double t)
{
    TinkerSimulation *companion = estimate->companion;
    if (tinker_simulation_sample(companion, t) != TINKER_OK) return;
    double factor = 0;
    for (guint i = 0; i < estimate->simulation->runs->len; i++)
        factor = fmax(factor, estimate->factors[i]);
    for (guint c = 0; c < estimate->columns; c++)
        estimate->bands[c] =
            fmax(estimate->bands[c], factor * fabs(companion->values[c] - estimate->simulation->values[c]));
}

gboolean tinker_estimate_look(TinkerEstimate *estimate, double t, GError **error)
{
    GError *failed = NULL;
    if (estimate->failed) return TRUE;
    if (estimate->companion != NULL && !tinker_simulation_advance(estimate->companion, t, &failed))
        return give_up(estimate, t, failed, error);
    estimate->error = FLOOR;
    for (guint i = 0; i < estimate->simulation->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(estimate->simulation->runs, i);
        if (is_exact(run)) estimate->error = fmax(estimate->error, rounding(estimate, i, t));
        if (estimate->factors[i] > 0) estimate->error = fmax(estimate->error, distance(estimate, i));
    }
    if (!(estimate->error > UNPREDICTABLE))
        estimate->predictable_until = INFINITY;
    else if (isinf(estimate->predictable_until))
        estimate->predictable_until = t;
    if (estimate->bands != NULL) widen_bands(estimate, t);
    return TRUE;
}

double tinker_estimate_error(const TinkerEstimate *estimate)
{
    return estimate->failed ? NAN : estimate->error;
}

double tinker_estimate_predictable_until(const TinkerEstimate *estimate)
{
    return estimate->predictable_until;
}

const double *tinker_estimate_bands(const TinkerEstimate *estimate)
{
    return estimate->companion != NULL ? estimate->bands : NULL;
}

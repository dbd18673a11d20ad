/* The companion is a simulation of its own, on a model of its own: nothing that it does can change a bit of the run. Each
 * island's is stepped along with the run's, and compared at the ends of its steps and at samples, so that what is claimed does
 * not depend on how often somebody looks. */
#include "physics/run/estimate.h"
#include "numerics/solve/largest.h"
#include "physics/event/contact-run.h"

#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>

#include "numerics/exact/exact.h"
#include "physics/compile/compile.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/run/companion.h"
#include "physics/run/simulation.h"
#include "physics/system/method-call.h"

/* How far a random walk of roundings goes, in units of the root of their number. */
#define WALK 4.0
/* Errors below this share of the scales are rounding. */
#define FLOOR (100 * DBL_EPSILON)
/* Beyond this share of the scales the motion is not predictable. */
#define UNPREDICTABLE 0.1
/* Samples so near to an impact (a share of the time) may lie on either side of it. */
#define NEAR_IMPACT 1e-6
/* Of how far bodies are from the middle of what they rest on. */
#define REST 1e-9
/* Or of so many steps, where an impact is one of a whole step. */
#define STEPS_NEAR_IMPACT 3
/* An adaptive companion lands on these shares of every step of the run: there dense output errs most, and its own steps are so
 * much shorter that it is the finer of the two where a tenth of the tolerance makes no difference, as where stability or a break
 * makes the steps. No step of it is longer than this share of the run's. */
static const double landings[] = {0.3, 0.72};
#define LONGEST_STEP 0.58
/* Instants are the same within this share of the time. */
#define SAME_INSTANT 1e-12
/* The same impact comes to the run and to its companion this much apart: so long after it they are taken to be behind it. */
#define BEHIND_IMPACT 2

/* Of one island. */
typedef struct {
    double factor;                  /* error over distance; 0 where rounding is all there is, and nothing is compared */
    double places, speeds;          /* m^2, m^2/s^2: squares of the largest distances so far */
    double acceleration;            /* m/s^2: the largest so far */
    double length;                  /* s: of the run's last step */
    double reached;                 /* s: where that ended */
    double extent, speed;           /* m, m/s: the scales where it began, of an adaptive method */
    double next_extent, next_speed; /* and where it ended */
    double error;                   /* of the scales, at the sample looked at last */
    double compared_at;             /* s: the end of the companion's step that was compared last */
    TinkerCompanionEnds *ends;      /* NULL where they are not watched, or not any more */
    double fastest;                 /* rad/s: no mode of an exact island is faster */
    double *start;                  /* where its coordinates were; NULL where it is not exact */
    double swing;                   /* and how far they have been from there */
} Part;

/* Room for the bodies of an island. */
typedef struct {
    double *q, *v;
} Bodies;

struct _TinkerEstimate {
    TinkerIslandRuns *runs;
    TinkerModel *model;          /* of the companion */
    TinkerIslandRuns *companion; /* NULL where no island needs one, and once it has failed */
    gboolean failed;
    guint columns;
    double *bands; /* by column, or NULL */
    Part *parts;   /* island by island */
    Bodies ours, theirs;
    double error, predictable_until;
};

static void scales_of(TinkerIslandRun *run, double *extent, double *speed)
{
    run->system.system.scales(&run->system, run->state.q, run->state.v, extent, speed);
}

void tinker_estimate_free(TinkerEstimate *estimate)
{
    if (estimate == NULL) return;
    for (guint i = 0; i < estimate->runs->runs->len; i++) {
        tinker_companion_ends_free(estimate->parts[i].ends);
        g_free(estimate->parts[i].start);
    }
    tinker_island_runs_free(estimate->companion);
    tinker_model_free(estimate->model);
    gpointer arrays[] = {estimate->bands,  estimate->parts,    estimate->ours.q,
                         estimate->ours.v, estimate->theirs.q, estimate->theirs.v};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(estimate);
}

/* Every step of an exact solution rounds its modes, and with a place that is off by epsilon of its swing a mode's speed is off by w
 * times that. Where something slow deflects what is stiff that is much beside the speed. In m/s, as a random walk of the steps. */
static double rounding_of_speeds(Part *part, const TinkerIslandRun *run)
{
    const TinkerSystem *system = &run->system.system;
    if (part->start == NULL || system->linear == NULL || !tinker_method_is_exact(run->choice.method)) return 0;
    for (int32_t i = 0; i < system->size; i++)
        part->swing = fmax(part->swing, fabs(run->state.q[i] - part->start[i]));
    return WALK * DBL_EPSILON * sqrt((double)run->summary.steps) * part->fastest * part->swing;
}

/* What rounding makes of an exact solution by time t. A frequency w that is off by one part in 1 / epsilon moves places by
 * epsilon w t of their swing and speeds by as much of theirs, which is epsilon t times the largest speed and acceleration. */
static double rounding(TinkerEstimate *estimate, guint number, double t)
{
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    TinkerSystem *system = &run->system.system;
    double extent, speed, *greatest = &estimate->parts[number].acceleration;
    gint64 evaluations = run->model->evaluations;
    if (system->acceleration(system->context, run->state.t, run->state.q, run->state.v, estimate->ours.q, NULL) ==
        TINKER_OK)
        *greatest = fmax(*greatest, tinker_largest(system->size, estimate->ours.q));
    run->model->evaluations = evaluations;
    system->scales(system->context, run->state.q, run->state.v, &extent, &speed);
    double places = extent > 0 ? speed / extent : 0, speeds = speed > 0 ? *greatest / speed : 0;
    double steps = speed > 0 ? rounding_of_speeds(&estimate->parts[number], run) / speed : 0;
    return fmax(DBL_EPSILON * t * fmax(places, speeds), steps);
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

static double square(double x, double y)
{
    return x * x + y * y;
}

/* Of one body, where it is and how fast it goes in the two. */
static void compare_body(Part *part, const double *q, const double *v, const double *other_q, const double *other_v,
                         gboolean speeds)
{
    part->places = fmax(part->places, square(q[0] - other_q[0], q[1] - other_q[1]));
    if (speeds) part->speeds = fmax(part->speeds, square(v[0] - other_v[0], v[1] - other_v[1]));
}

static void compare_samples(TinkerEstimate *estimate, guint number)
{
    const TinkerIslandRuns *ours = estimate->runs, *theirs = estimate->companion;
    const TinkerIslandRun *run = g_ptr_array_index(ours->runs, number),
                          *other = g_ptr_array_index(theirs->runs, number);
    double t = ours->sample_time;
    gboolean speeds = !strikes_near(run, t) && !strikes_near(other, t);
    for (int32_t i = 0; i < run->model->bodies; i++) {
        int32_t body = 2 * run->island->body_of[i];
        compare_body(&estimate->parts[number], ours->sample_q + body, ours->sample_v + body, theirs->sample_q + body,
                     theirs->sample_v + body, speeds);
    }
}

/* An impact comes to the two at two instants; between them velocities tell nothing. */
static gboolean strikes_between(const TinkerIslandRun *run, const TinkerIslandRun *other, double t)
{
    if (run->contacts == NULL) return FALSE;
    double ours = fmax(tinker_contact_run_passed_impact(run->contacts), 0);
    double theirs = fmax(tinker_contact_run_passed_impact(other->contacts), 0);
    return t <= fmax(ours, theirs) + BEHIND_IMPACT * fabs(ours - theirs);
}

/* At the end of a step of the companion, within the run's last. */
static void compare_steps(TinkerEstimate *estimate, TinkerIslandRun *run, TinkerIslandRun *other, Part *part)
{
    double t = other->state.t;
    Bodies *ours = &estimate->ours, *theirs = &estimate->theirs;
    TinkerStatus status = tinker_island_run_unprojected_at(run, t, ours->q, ours->v);
    if (status == TINKER_OK) status = tinker_island_run_unprojected_at(other, t, theirs->q, theirs->v);
    if (status != TINKER_OK) return; /* a sample will tell */
    gboolean speeds = !strikes_near(run, t) && !strikes_near(other, t) && !strikes_between(run, other, t);
    for (int32_t i = 0; i < 2 * run->model->bodies; i += 2)
        compare_body(part, ours->q + i, ours->v + i, theirs->q + i, theirs->v + i, speeds);
}

/* The largest of the bodies' distances from one place to another. */
static double largest_way(const TinkerIslandRun *run, const double *from, const double *to)
{
    double largest = 0;
    for (int32_t i = 0; i < 2 * run->model->bodies; i += 2)
        largest = fmax(largest, square(to[i] - from[i], to[i + 1] - from[i + 1]));
    return sqrt(largest);
}

/* Up to a sample, which a long step of the run has passed by far where motion begins: what it reaches at its end would make
 * little of errors that are large as yet. */
static void scales_at(TinkerEstimate *estimate, TinkerIslandRun *run, const Part *part, double t, double *extent,
                      double *speed)
{
    Bodies *then = &estimate->theirs, *now = &estimate->ours;
    scales_of(run, extent, speed);
    if (!tinker_method_is_adaptive(run->choice.method) || t >= run->state.t || t < part->reached - part->length) return;
    if (tinker_island_run_unprojected_at(run, part->reached - part->length, then->q, then->v) != TINKER_OK ||
        tinker_island_run_unprojected_at(run, t, now->q, now->v) != TINKER_OK)
        return;
    *extent = fmin(*extent, part->extent + largest_way(run, then->q, now->q));
    for (int32_t i = 0; i < 2 * run->model->bodies; i++)
        then->v[i] = 0;
    *speed = fmin(*speed, fmax(part->speed, largest_way(run, then->v, now->v)));
}

/* The largest distance of the two states of an island so far, by its scales at the sample: what was much beside the first slow
 * moments may be little beside what follows. */
static double distance(TinkerEstimate *estimate, guint number)
{
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    const Part *part = &estimate->parts[number];
    double extent, speed;
    scales_at(estimate, run, part, estimate->runs->sample_time, &extent, &speed);
    if (rests(run, extent)) return 0;
    double places = extent > 0 ? sqrt(part->places) / extent : 0, speeds = 0;
    if (speed > tinker_island_run_speed_noise(run, extent)) speeds = sqrt(part->speeds) / speed;
    return part->factor * fmax(places, speeds);
}

/* A companion that cannot go on leaves everything behind it without an estimate and without bands. */
static gboolean give_up(TinkerEstimate *estimate, double t, GError *failed, GError **error)
{
    if (g_error_matches(failed, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) {
        g_propagate_error(error, failed);
        return FALSE;
    }
    g_ptr_array_add(estimate->runs->summary.warnings,
                    g_strdup_printf(_("there is no error estimate beyond t = %.6g s: the companion run stopped (%s)"),
                                    t, failed->message));
    g_error_free(failed);
    g_clear_pointer(&estimate->companion, tinker_island_runs_free);
    estimate->failed = TRUE;
    for (guint c = 0; estimate->bands != NULL && c < estimate->columns; c++)
        estimate->bands[c] = NAN;
    return TRUE;
}

void tinker_estimate_close(TinkerEstimate *estimate)
{
    if (isinf(estimate->predictable_until)) return;
    g_ptr_array_add(
        estimate->runs->summary.warnings,
        g_strdup_printf(_("not predictable beyond t = %.6g s: there the estimated error passes a tenth of the "
                          "motion's own size (a smaller step or tolerance moves that time out, in "
                          "chaotic motion only a little)"),
                        estimate->predictable_until));
}

static void widen_bands(TinkerEstimate *estimate, double t)
{
    TinkerIslandRuns *companion = estimate->companion;
    if (tinker_island_runs_sample(companion, t) != TINKER_OK) return;
    double factor = 0;
    for (guint i = 0; i < estimate->runs->runs->len; i++)
        factor = fmax(factor, estimate->parts[i].factor);
    for (guint c = 0; c < estimate->columns; c++)
        estimate->bands[c] = fmax(estimate->bands[c], factor * fabs(companion->values[c] - estimate->runs->values[c]));
}

/* Whether the two are compared at the end of the companion's step, which the run's last step reaches over: a method of fixed step
 * needs no look between the ends of its own steps where its dense output is of an order above that. */
static gboolean meet(const Part *part, const TinkerIslandRun *run, const TinkerIslandRun *other)
{
    const TinkerIntegrator *method = run->choice.method;
    gboolean at_ends = tinker_method_is_fixed(run->choice.method) && method->dense_order >= method->order;
    if (at_ends) return other->state.t == run->state.t;
    return other->state.t <= run->state.t && other->state.t >= part->reached - part->length;
}

/* How far an adaptive companion goes in its next step, so that it lands where dense output of the run's last step errs most; 0
 * where it waits for the run's next. */
static double way_to_go(const Part *part, const TinkerIslandRun *other)
{
    double from = part->reached - part->length;
    for (gsize i = 0; i < G_N_ELEMENTS(landings); i++) {
        double way = from + landings[i] * part->length - other->state.t;
        if (way > SAME_INSTANT * part->reached) return way;
    }
    return 0;
}

/* The companion has to reach a sample behind its last landing: it goes on as if the run did, unless the run starts anew there. */
static double way_beyond(const Part *part, const TinkerIslandRun *run, const TinkerIslandRun *other)
{
    gboolean stops =
        run->state.t >= run->piece_end || (run->contacts != NULL && tinker_contact_run_stands_on_event(run->contacts));
    double way = run->state.t - other->state.t;
    return stops && way > 0 ? way : LONGEST_STEP * part->length;
}

static void note_step(Part *part, TinkerIslandRun *run)
{
    if (!(run->state.t > part->reached)) return;
    part->length = run->state.t - part->reached;
    part->reached = run->state.t;
    if (!tinker_method_is_adaptive(run->choice.method)) return;
    part->extent = part->next_extent;
    part->speed = part->next_speed;
    scales_of(run, &part->next_extent, &part->next_speed);
}

/* An island of the run has made a step on its way to a sample at t: brings its companion as far, not beyond the sample, and
 * compares where the two meet. FALSE only where the user stopped it. */
static gboolean follow(void *follower, guint number, double t, GError **error)
{
    TinkerEstimate *estimate = follower;
    GError *failed = NULL;
    Part *part = &estimate->parts[number];
    TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    if (estimate->companion == NULL || !(part->factor > 0)) return TRUE;
    if (part->reached >= run->summary.determined_until) return TRUE;
    TinkerIslandRun *other = g_ptr_array_index(estimate->companion->runs, number);
    double until = MIN(run->state.t, t);
    note_step(part, run);
    for (;;) {
        if (other->state.t > part->compared_at && meet(part, run, other)) {
            part->compared_at = other->state.t;
            compare_steps(estimate, run, other, part);
        }
        if (other->state.t >= until) return TRUE;
        if (tinker_method_is_adaptive(other->choice.method)) {
            other->longest_step = way_to_go(part, other);
            if (other->longest_step == 0) {
                other->longest_step = way_beyond(part, run, other);
                return TRUE;
            }
        }
        if (part->ends != NULL && tinker_companion_look_at_ends(part->ends))
            g_clear_pointer(&part->ends, tinker_companion_ends_free);
        if (!tinker_island_runs_step(estimate->companion, number, &failed))
            return give_up(estimate, other->state.t, failed, error);
    }
}

static gboolean open_companion(TinkerEstimate *estimate, const GArray *columns, GError **error)
{
    TinkerIslandRuns *runs = estimate->runs;
    estimate->model = tinker_model_new(runs->model->scene, error);
    if (estimate->model == NULL) return FALSE;
    TinkerIslandRuns *companion = estimate->companion = tinker_companion_new(runs, estimate->model, error);
    if (companion == NULL) return FALSE;
    for (guint i = 0; i < runs->runs->len; i++)
        estimate->parts[i].ends = tinker_companion_ends_new(g_ptr_array_index(companion->runs, i));
    if (columns == NULL || !runs->options.bands) return TRUE;
    estimate->columns = columns->len;
    estimate->bands = g_new0(double, columns->len + 1);
    tinker_island_runs_take_columns(companion, columns);
    return TRUE;
}

static void warn_of_none(TinkerIslandRuns *runs, const char *why)
{
    g_ptr_array_add(runs->summary.warnings,
                    g_strdup_printf(_("there is no error estimate: the companion run cannot be set up (%s)"), why));
}

static void open_part(Part *part, TinkerIslandRun *run)
{
    const TinkerSystem *system = &run->system.system;
    part->factor = tinker_companion_factor(run);
    scales_of(run, &part->next_extent, &part->next_speed);
    if (!tinker_method_is_exact(run->choice.method) || system->linear == NULL) return;
    part->fastest = tinker_exact_fastest(system->linear);
    part->start = g_memdup2(run->state.q, (gsize)system->size * sizeof(double));
}

TinkerEstimate *tinker_estimate_new(TinkerIslandRuns *runs, const GArray *columns)
{
    TinkerEstimate *estimate = g_new0(TinkerEstimate, 1);
    estimate->runs = runs;
    estimate->predictable_until = INFINITY;
    estimate->parts = g_new0(Part, runs->runs->len);
    double **rooms[] = {&estimate->ours.q, &estimate->ours.v, &estimate->theirs.q, &estimate->theirs.v};
    for (gsize i = 0; i < G_N_ELEMENTS(rooms); i++)
        *rooms[i] = g_new0(double, 2 * (gsize)runs->model->bodies + 1);
    gboolean compares = FALSE;
    g_autoptr(GError) error = NULL;
    for (guint i = 0; i < runs->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(runs->runs, i);
        open_part(&estimate->parts[i], run);
        compares |= estimate->parts[i].factor > 0;
    }
    runs->follow = follow;
    runs->follower = estimate;
    if (!compares || open_companion(estimate, columns, &error)) return estimate;
    if (!g_error_matches(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) warn_of_none(runs, error->message);
    tinker_estimate_free(estimate);
    runs->follow = NULL;
    return NULL;
}

/* Where one motion of many is followed the companion may follow another, and their distance is no error. FALSE where some island
 * is such. */
static gboolean abandon_undetermined(TinkerEstimate *estimate, double t)
{
    gboolean all = TRUE;
    for (guint i = 0; i < estimate->runs->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, i);
        if (!(t > run->summary.determined_until)) continue;
        all = FALSE;
        if (estimate->companion == NULL) continue;
        ((TinkerIslandRun *)g_ptr_array_index(estimate->companion->runs, i))->abandoned = TRUE;
    }
    return all;
}

/* What an island is off by at t; of one that is not determined any more, what it was off by until then. */
static double error_of(TinkerEstimate *estimate, guint number, double t)
{
    Part *part = &estimate->parts[number];
    const TinkerIslandRun *run = g_ptr_array_index(estimate->runs->runs, number);
    if (t > run->summary.determined_until) return part->error;
    part->error = 0;
    if (tinker_method_is_exact(run->choice.method) || run->aside.method != NULL)
        part->error = rounding(estimate, number, t);
    if (!(part->factor > 0)) return part->error;
    compare_samples(estimate, number);
    return part->error = fmax(part->error, distance(estimate, number));
}

gboolean tinker_estimate_look(TinkerEstimate *estimate, double t, GError **error)
{
    GError *failed = NULL;
    if (estimate->failed) return TRUE;
    const gboolean determined = abandon_undetermined(estimate, t);
    if (estimate->companion != NULL && !tinker_island_runs_advance(estimate->companion, t, &failed))
        return give_up(estimate, t, failed, error);
    estimate->error = FLOOR;
    for (guint i = 0; i < estimate->runs->runs->len; i++)
        estimate->error = fmax(estimate->error, error_of(estimate, i, t));
    if (!(estimate->error > UNPREDICTABLE))
        estimate->predictable_until = INFINITY;
    else if (isinf(estimate->predictable_until))
        estimate->predictable_until = t;
    if (estimate->bands != NULL && determined) widen_bands(estimate, t);
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
    return estimate->bands;
}

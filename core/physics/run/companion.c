/* How a companion is stepped, and what its distance tells of the error. */
#include "physics/run/companion.h"
#include "numerics/solve/largest.h"
#include "physics/island/island-run.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

#include <float.h>
#include <math.h>

/* The distance from the companion is most of the error, not all: what is claimed is this much of it. */
#define SAFETY 2.0
/* No tolerance is driven below rounding (with room for the rounding of its own value). Where a tenth would be, the
 * companion is ten times coarser instead. It is off by up to ten times the error; less, the more of that is rounding.
 */
#define LEAST_TOLERANCE 0.99e-14
#define COARSER_FACTOR  1.0
/* Where ends pass each other an exact solution is exact from one such instant to the next only, and rounding may grow
 * at each: from the first on the companion is off by this share of the scales. Where bodies strike, any solution is,
 * every impact rounds anew, and the scales may be 0 at the start: from there on it is off by this share of where bodies
 * are. */
#define OFF_WHERE_ENDS_PASS     (6 * DBL_EPSILON)
#define OFF_WHERE_BODIES_STRIKE (16 * DBL_EPSILON)

/* Of one island: how the ends of its lines were apart last, 2 a line (m). */
struct _TinkerCompanionEnds {
    TinkerIslandRun *run;
    double *apart;
};

/* An exact island goes by its tolerance once bodies touch. */
static gboolean goes_by_tolerance(const TinkerIslandRun *run)
{
    return !tinker_method_is_fixed(run->choice.method);
}

static gboolean can_be_finer(const TinkerIslandRun *run)
{
    return !goes_by_tolerance(run) || run->choice.tolerance / 10 >= LEAST_TOLERANCE;
}

/* Whether the ends of a connector may pass each other, with a length or a tension that pushes the other way then. */
static gboolean may_pass(const TinkerIslandRun *run)
{
    const TinkerLinearSystem *linear =
        run->island->linear != NULL ? tinker_linear_form_system(run->island->linear) : NULL;
    for (int32_t i = 0; linear != NULL && i < linear->edge_count; i++)
        if (linear->edges[i].stiffness * linear->edges[i].length != 0 || linear->edges[i].tension != 0) return TRUE;
    return FALSE;
}

double tinker_companion_factor(const TinkerIslandRun *run)
{
    if (tinker_method_is_exact(run->choice.method) && run->contacts == NULL && !may_pass(run)) return 0.0;
    if (!can_be_finer(run)) return tinker_method_is_exact(run->choice.method) ? SAFETY : COARSER_FACTOR;
    double less = goes_by_tolerance(run) ? 0.1 : exp2(-run->choice.method->order);
    return SAFETY / (1.0 - less);
}

static TinkerChoice choice_of(const TinkerIslandRun *run)
{
    TinkerChoice choice = run->choice;
    choice.step /= 2;
    choice.tolerance = can_be_finer(run) ? choice.tolerance / 10 : 10 * choice.tolerance;
    return choice;
}

/* Turns by turns, so that bodies do not move as one. */
static void put_off(TinkerIslandRun *run)
{
    double extent, speed, share = OFF_WHERE_ENDS_PASS;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    if (run->contacts != NULL) {
        share = OFF_WHERE_BODIES_STRIKE;
        extent = fmax(extent, tinker_largest(run->system.system.size, run->state.q));
    }
    for (int32_t i = 0; i < run->system.system.size; i++) {
        double turn = i % 2 == 0 ? share : -share;
        run->state.q[i] += turn * extent;
        run->state.v[i] += turn * speed;
    }
    /* off what holds the bodies rounding would be met at once by what closes there, as a rope that is just taut */
    (void)tinker_island_run_meet(run, run->state.t, run->q, run->v);
    tinker_method_restart(run->choice.method, run->stepper);
}

TinkerIslandRuns *tinker_companion_new(TinkerIslandRuns *runs, TinkerModel *model, GError **error)
{
    TinkerRunOptions options = runs->options;
    options.estimate = FALSE;
    options.progress = NULL;
    options.found = NULL;
    options.jolts = NULL;
    g_autofree TinkerChoice *choices = g_new(TinkerChoice, runs->runs->len);
    for (guint i = 0; i < runs->runs->len; i++)
        choices[i] = choice_of(g_ptr_array_index(runs->runs, i));
    TinkerIslandRuns *companion = tinker_island_runs_new(model, &options, choices, error);
    for (guint i = 0; companion != NULL && i < companion->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(companion->runs, i);
        run->is_companion = TRUE;
        if (run->contacts != NULL) put_off(run);
    }
    return companion;
}

/* Ends that pass --------------------------------------------------------------------------------------------------- */

TinkerCompanionEnds *tinker_companion_ends_new(TinkerIslandRun *run)
{
    if (!tinker_method_is_exact(run->choice.method) || run->contacts != NULL || !may_pass(run)) return NULL;
    TinkerCompanionEnds *ends = g_new0(TinkerCompanionEnds, 1);
    *ends = (TinkerCompanionEnds){run, g_new0(double, 2 * (gsize)MAX(run->model->lines.count, 1))};
    return ends;
}

void tinker_companion_ends_free(TinkerCompanionEnds *ends)
{
    if (ends == NULL) return;
    g_free(ends->apart);
    g_free(ends);
}

/* Whether the ends of some line are at one place, or have changed sides since this was asked last: islands that are
 * solved exactly and whose ends may pass move along a line. Where that cannot be told, they may have. */
static gboolean have_passed(TinkerCompanionEnds *ends)
{
    TinkerIslandRun *run = ends->run;
    TinkerModel *model = run->model;
    double extent, speed;
    gboolean passed = FALSE;
    if (tinker_model_set_time(model, run->state.t) != TINKER_OK) return TRUE;
    tinker_island_run_place(run);
    tinker_model_set_state(model, run->q, run->v);
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    for (int32_t i = 0; i < model->lines.count; i++) {
        const TinkerPoint *a = &model->point[model->lines.a[i]], *b = &model->point[model->lines.b[i]];
        const double x = b->x - a->x, y = b->y - a->y;
        double *apart = ends->apart + 2 * i;
        passed |= hypot(x, y) <= TINKER_ENDS_MEET * extent || apart[0] * x + apart[1] * y < 0;
        apart[0] = x;
        apart[1] = y;
    }
    return passed;
}

gboolean tinker_companion_look_at_ends(TinkerCompanionEnds *ends)
{
    if (!have_passed(ends)) return FALSE;
    put_off(ends->run);
    return TRUE;
}

/* Blows at an instant: M (v+ - v-) = S + J^T p, with S the impulses of the blocks that strike and p those of joints and
 * contacts. Joints answer first, then contacts, with them, as in an impact that brings no rebound: before it what
 * touched was at rest. The work of S is S . (v- + v+) / 2 at the points where it acts, by Kelvin's theorem (Routh,
 * "Dynamics of a System of Rigid Bodies", Elementary Part, 1905, art. 346). */
#include "physics/event/blows.h"

#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/constraint/jolts.h"
#include "physics/event/contact-run.h"
#include "physics/force/forces.h"
#include "physics/model/angles.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"
#include "plugin/call/call.h"

/* One blow, as velocities by coordinate: M^-1 S, what was before it, and what it and the joints make of that. */
typedef struct {
    TinkerIslandRun *run;
    gboolean any;
    double *given, *before, *held;
} Blow;

static gboolean strikes_now(TinkerBlockBatch *batch, const TinkerForceElement *element, double t)
{
    TinkerBatch view = tinker_block_batch_view(batch, nextafter(t, -INFINITY));
    double next = INFINITY;
    TINKER_CALL_VOID(next = element->next_blow(&view), .phase = "next_blow", .block_class = batch->block_class,
                     .batch = &view, .name = tinker_block_batch_name, .source = batch);
    return next <= t;
}

/* The change of velocities that an impulse at a point, or about a turn, makes of the bodies alone. */
static void push(Blow *blow, TinkerBlockId by, int32_t point, int axis, double impulse)
{
    const TinkerIslandRun *run = blow->run;
    const TinkerModel *model = run->model;
    if (impulse == 0 || point >= model->first_support) return;
    TinkerCoordinateEntry list[2];
    const int32_t count = tinker_model_point_entries(model, point, axis, list);
    for (int32_t i = 0; i < count; i++) {
        const int32_t coordinate = list[i].coordinate;
        blow->given[coordinate] += list[i].value * impulse / model->coordinate_mass[coordinate];
        if (run->jolts != NULL)
            tinker_jolts_add(run->jolts, model, run->state.t, by, coordinate, list[i].value * impulse);
    }
}

static void tell(TinkerIslandRun *run, const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerScene *scene = run->model->scene;
    g_autofree char *names = g_strdup_printf("%s, %s", tinker_scene_block_name(scene, batch->ids[row]),
                                             tinker_scene_block_name(scene, batch->end[batch->end_offsets[row]].block));
    tinker_island_run_add_event(run, "blow", names);
}

/* Takes what a batch answered; FALSE where that is no number. */
static gboolean take_impulses(Blow *blow, const TinkerBlockBatch *batch, const double *impulse, const double *angular)
{
    TinkerModel *model = blow->run->model;
    const int32_t *points = tinker_model_end_points(model, batch);
    for (int32_t row = 0; row < batch->count; row++) {
        gboolean any = FALSE;
        for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++) {
            const double turn = angular != NULL ? angular[e] : 0;
            if (!isfinite(impulse[2 * e] + impulse[2 * e + 1] + turn)) {
                tinker_model_not_finite(model, batch, row, "blow");
                return FALSE;
            }
            any |= impulse[2 * e] != 0 || impulse[2 * e + 1] != 0 || turn != 0;
            push(blow, batch->ids[row], points[e], 0, impulse[2 * e]);
            push(blow, batch->ids[row], points[e], 1, impulse[2 * e + 1]);
            if (angular != NULL) push(blow, batch->ids[row], tinker_model_angles(model, batch)->turns[e], 0, turn);
        }
        if (any) tell(blow->run, batch, row);
        blow->any |= any;
    }
    return TRUE;
}

static gboolean ask(Blow *blow, TinkerBlockBatch *batch, const TinkerForceElement *element)
{
    TinkerModel *model = blow->run->model;
    TinkerAngles *angles = tinker_model_angles(model, batch);
    const int32_t *points = tinker_model_end_points(model, batch);
    g_autofree TinkerPoint *ends = g_new(TinkerPoint, MAX(batch->end_count, 1));
    g_autofree double *impulse = g_new0(double, 2 * (gsize)MAX(batch->end_count, 1));
    for (int32_t e = 0; e < batch->end_count; e++)
        ends[e] = model->point[points[e]];
    TinkerBatch view = tinker_block_batch_view(batch, blow->run->state.t);
    if (angles != NULL) {
        tinker_angles_gather(angles, model, 0, batch->end_count);
        tinker_angles_show(angles, &view, 0, batch->end_count);
    }
    const TinkerStatus status = TINKER_CALL_BATCH(batch, "blow", &view, element->blow(&view, ends, impulse));
    if (status == TINKER_OK) return take_impulses(blow, batch, impulse, view.angular);
    tinker_model_refuse_forces(model, batch, &view, TINKER_FAILED, "blow");
    return FALSE;
}

static gboolean bring_model(const TinkerIslandRun *run)
{
    if (tinker_model_set_time(run->model, run->state.t) != TINKER_OK) return FALSE;
    tinker_model_set_state(run->model, run->state.q, run->state.v);
    return run->model->constraints.rows == 0 || tinker_constraints_evaluate(run->model) == TINKER_OK;
}

/* Rows that hold in one direction only are contacts: they do not hold while joints answer. */
static void slacken(TinkerModel *model, gboolean *were)
{
    const TinkerConstraints *all = &model->constraints;
    if (all->unilateral == NULL) return;
    memcpy(were, all->slack, (gsize)all->rows * sizeof *were);
    tinker_constraints_set_all_slack(model, TRUE);
}

static void tighten(TinkerModel *model, const gboolean *were)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->unilateral[row]) tinker_constraints_set_slack(model, row, were[row]);
}

/* Lets the blow and the joints act, and books what supports and drives that hold against it give. */
static gboolean answer_by_joints(Blow *blow)
{
    TinkerIslandRun *run = blow->run;
    TinkerModel *model = run->model;
    TinkerConstraints *all = &model->constraints;
    double *v = run->state.v;
    g_autofree gboolean *were = g_new0(gboolean, (gsize)all->rows + 1);
    slacken(model, were);
    const gboolean done = bring_model(run);
    for (int32_t c = 0; done && c < model->coordinates; c++)
        v[c] += blow->given[c];
    if (done && all->rows > 0) {
        memset(all->by_point, 0, 2 * (gsize)model->points * sizeof(double));
        memcpy(all->by_point, blow->given, (gsize)model->coordinates * sizeof(double));
        tinker_constraints_answer(model, v);
        if (run->jolts != NULL) tinker_jolts_add_rows(run->jolts, model, run->state.t);
        memset(model->book_power, 0, sizeof(model->book_power));
        tinker_constraints_add_power(model); // of impulses: their work
        for (int book = 0; book < TINKER_BOOK_COUNT; book++)
            run->system.impact_work[book] += model->book_power[book];
    }
    tighten(model, were);
    return done;
}

/* S . u, with u given as velocities by coordinate. */
static double along(const Blow *blow, const double *v)
{
    const TinkerModel *model = blow->run->model;
    double sum = 0;
    for (int32_t c = 0; c < model->coordinates; c++)
        sum += model->coordinate_mass[c] * blow->given[c] * v[c];
    return sum;
}

static void book(const Blow *blow)
{
    double *work = blow->run->system.impact_work;
    const double held = along(blow, blow->held), after = along(blow, blow->run->state.v);
    work[TINKER_BOOK_MOTORS] += 0.5 * (along(blow, blow->before) + after);
    work[TINKER_BOOK_CONTACTS] += 0.5 * (held - after); // what they took was counted from what joints alone leave
}

static gboolean act(Blow *blow, GError **error)
{
    TinkerIslandRun *run = blow->run;
    const gsize bytes = (gsize)run->model->coordinates * sizeof(double);
    memcpy(blow->before, run->state.v, bytes);
    if (!answer_by_joints(blow)) return tinker_island_run_fail(run, run->model->failure, error);
    memcpy(blow->held, run->state.v, bytes);
    if (run->contacts != NULL && !tinker_contact_run_close_blow(run->contacts, blow->given, error)) return FALSE;
    book(blow);
    tinker_method_restart(run->choice.method, run->stepper);
    return TRUE;
}

gboolean tinker_island_run_strike(TinkerIslandRun *run, GError **error)
{
    TinkerModel *model = run->model;
    const gsize n = (gsize)MAX(model->coordinates, 1);
    g_autofree double *room = NULL;
    Blow blow = {.run = run};
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (!tinker_block_class_strikes(batch->block_class)) continue;
        const TinkerForceElement *element = batch->block_class->physics->force_element;
        if (!strikes_now(batch, element, run->state.t)) continue;
        if (room == NULL) {
            room = g_new0(double, 3 * n);
            blow = (Blow){run, FALSE, room, room + n, room + 2 * n};
            tinker_island_run_place(run);
            if (run->contacts != NULL && !tinker_contact_run_open_blow(run->contacts, error)) return FALSE;
            if (!bring_model(run)) return tinker_island_run_fail(run, model->failure, error);
        }
        if (!ask(&blow, batch, element)) return tinker_island_run_fail(run, model->failure, error);
    }
    return !blow.any || act(&blow, error);
}

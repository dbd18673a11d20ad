/* From break to break: waveforms are smooth inside a piece, and what jumps between two pieces is looked after here. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/blows.h"
#include "physics/event/contact-run.h"
#include "physics/force/forces.h"
#include "physics/island/island-run.h"
#include "physics/model/breaks.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/run/island-steps.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

/* The block of a constraint that is attached to the point, or a body that rests on its plate; or TINKER_NO_BLOCK. */
static TinkerBlockId constraint_at(const TinkerModel *model, int32_t point)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; row < all->rows; row++)
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            if (all->points[e] == point) return all->blocks[row];
    for (guint i = 0; model->contacts != NULL && i < model->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(model->contacts, i);
        if (model->contacts->plates[contact->plate].point == point) return model->body_blocks[contact->body];
    }
    return TINKER_NO_BLOCK;
}

/* What the two sides of a break are to each other. */
typedef enum { SIDES_FIT, SIDES_JUMP, SIDES_UNKNOWN } Sides;

static Sides refuse_jump(TinkerIslandRun *run, TinkerBlockId block, TinkerBlockId felt_by, GError **error)
{
    TinkerModel *model = run->model;
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
        _("%s: its motion jumps at t = %.10g s, which %s cannot follow (give it a motion without a jump in place or "
          "speed, or use a spring)"),
        tinker_scene_block_name(model->scene, block), run->state.t, tinker_scene_block_name(model->scene, felt_by));
    return SIDES_JUMP;
}

static Sides check_jumps(TinkerIslandRun *run, const TinkerPoint *before, GError **error)
{
    TinkerModel *model = run->model;
    double extent, speed;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    for (int32_t point = model->first_support; point < model->points; point++) {
        const TinkerAttachment *support = tinker_model_attachment(model, point);
        if (!support->moving) continue;
        const TinkerPoint *now = &model->point[point], *was = &before[point - model->first_support];
        gboolean jumps = hypot(now->x - was->x, now->y - was->y) > TINKER_JUMP * extent ||
                         hypot(now->vx - was->vx, now->vy - was->vy) > TINKER_JUMP * MAX(speed, extent);
        TinkerBlockId felt_by = jumps ? constraint_at(model, point) : TINKER_NO_BLOCK;
        if (felt_by != TINKER_NO_BLOCK) return refuse_jump(run, support->block, felt_by, error);
    }
    return SIDES_FIT;
}

/* Where the rows are at the state: g, and dg/dt of what is prescribed. */
static gboolean rows_at_state(TinkerIslandRun *run, double *g, double *rate)
{
    const TinkerConstraints *all = &run->model->constraints;
    tinker_model_set_state(run->model, run->q, run->v);
    if (tinker_constraints_evaluate(run->model) != TINKER_OK) return FALSE;
    memcpy(g, all->g, (gsize)all->rows * sizeof(double));
    memcpy(rate, all->rate, (gsize)all->rows * sizeof(double));
    return TRUE;
}

/* A row whose waveform jumps asks for a jump in place or speed. */
static Sides check_prescribed(TinkerIslandRun *run, const double *g, const double *rate, GError **error)
{
    TinkerModel *model = run->model;
    const TinkerConstraints *all = &model->constraints;
    g_autofree double *g_now = g_new(double, all->rows), *rate_now = g_new(double, all->rows);
    if (!rows_at_state(run, g_now, rate_now)) {
        tinker_island_run_fail(run, model->failure, error);
        return SIDES_UNKNOWN;
    }
    for (int32_t row = 0; row < all->rows; row++) {
        double scale = TINKER_JUMP * all->scales[row];
        if (fabs(g_now[row] - g[row]) <= scale && fabs(rate_now[row] - rate[row]) <= scale) continue;
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
            _("%s: what it prescribes jumps at t = %.10g s, which no motion can follow (give it a waveform without a "
              "jump in value or slope)"),
            tinker_scene_block_name(model->scene, all->blocks[row]), run->state.t);
        return SIDES_JUMP;
    }
    return SIDES_FIT;
}

static double potential(TinkerIslandRun *run)
{
    TinkerModel *model = run->model;
    TinkerEnergy energy = {0};
    tinker_model_set_state(model, run->q, run->v);
    return tinker_model_energy(model, &energy) == TINKER_OK ? energy.potential : 0;
}

/* A support that jumps stretches springs at once: that work belongs to its motion. */
static void book_jump(TinkerIslandRun *run, double gain)
{
    for (int32_t i = 0; i < run->system.system.books; i++)
        if (run->system.book_of[i] == TINKER_BOOK_SUPPORT_MOTION) run->state.books[i] += gain;
}

/* What may jump at a break, on the side before it. */
typedef struct {
    TinkerPoint *supports;
    double *g, *rate;
    double stored;
} Before;

static void before_clear(Before *before)
{
    g_free(before->supports);
    g_free(before->g);
    g_free(before->rate);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Before, before_clear)

static gboolean look_before(TinkerIslandRun *run, Before *before)
{
    TinkerModel *model = run->model;
    gsize supports = (gsize)(model->points - model->first_support);
    if (tinker_model_set_time(model, run->state.t) != TINKER_OK) return FALSE;
    before->supports = g_memdup2(model->point + model->first_support, supports * sizeof(TinkerPoint));
    if (model->moving_supports > 0) before->stored = potential(run);
    if (!model->constraints.prescribed) return TRUE;
    before->g = g_new(double, model->constraints.rows);
    before->rate = g_new(double, model->constraints.rows);
    return rows_at_state(run, before->g, before->rate);
}

static Sides look_behind(TinkerIslandRun *run, const Before *before, GError **error)
{
    Sides sides = SIDES_FIT;
    if (run->model->moving_supports > 0) sides = check_jumps(run, before->supports, error);
    if (sides == SIDES_FIT && before->g != NULL) sides = check_prescribed(run, before->g, before->rate, error);
    return sides;
}

/* Puts the model into the piece that begins here and ends at `end`, unless what jumps on the way there is refused. */
static gboolean cross_break(TinkerIslandRun *run, double end, gboolean *jumps, GError **error)
{
    TinkerModel *model = run->model;
    const double t = run->state.t;
    g_auto(Before) before = {0};
    if (t > 0 && !look_before(run, &before)) return tinker_island_run_fail(run, model->failure, error);
    const double to = end > t ? end : INFINITY;
    tinker_model_enter_piece(model, t, tinker_time_inside(t, to), to);
    if (tinker_model_set_time(model, t) != TINKER_OK) return tinker_island_run_fail(run, model->failure, error);
    if (!(t > 0)) return TRUE;
    const Sides sides = look_behind(run, &before, error);
    if (jumps != NULL) *jumps = sides == SIDES_JUMP;
    if (sides != SIDES_FIT) return FALSE;
    if (model->moving_supports > 0) book_jump(run, potential(run) - before.stored);
    return TRUE;
}

gboolean tinker_island_run_enter_piece(TinkerIslandRun *run, double horizon, gboolean *jumps, GError **error)
{
    TinkerModel *model = run->model;
    tinker_island_run_place(run);
    const gboolean on_break = run->state.t > 0 && run->ends_on_break;
    const double t = run->state.t, next = tinker_model_next_break(model, t, horizon);
    const double end = isfinite(next) ? next : horizon;
    TinkerBlockId pole_block = run->pole_block;
    const double pole = tinker_model_next_pole(model, &pole_block);
    if (jumps != NULL) *jumps = FALSE;
    if (!cross_break(run, end, jumps, error)) return FALSE;
    run->ends_on_break = isfinite(next);
    run->piece_from = on_break ? t : -INFINITY;
    run->piece_end = end;
    run->pole = pole;
    run->pole_block = pole_block;
    if (run->ends_on_break && tinker_break_crowd_add(&run->crowd, t, next, horizon)) {
        g_autofree char *why = tinker_break_crowd_text(model, t, next);
        return tinker_island_run_fail_step(run, why, error);
    }
    if (on_break && run->contacts != NULL && !tinker_contact_run_reclassify(run->contacts, error)) return FALSE;
    tinker_method_restart(run->choice.method, run->stepper);
    return !on_break || tinker_island_run_strike(run, error);
}

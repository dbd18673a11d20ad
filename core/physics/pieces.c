/* From break to break: waveforms are smooth inside a piece, and what jumps between two pieces is looked after here. */
#include <math.h>
#include <string.h>

#include "physics/simulation-private.h"

/* A support's place and speed may change by this much of the scales at a break without a rod feeling a jump. */
#define JUMP_TOLERANCE 1e-9

/* The block of a constraint that is attached to the point, or TINKER_NO_BLOCK. */
static TinkerBlockId constraint_at(const TinkerModel *model, int32_t point)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; row < all->rows; row++)
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            if (all->points[e] == point) return all->blocks[row];
    return TINKER_NO_BLOCK;
}

static gboolean refuse_jump(TinkerSimulation *simulation, int32_t support, TinkerBlockId felt_by, GError **error)
{
    TinkerModel *model = simulation->model;
    TinkerBlockId block = g_array_index(model->support_points, TinkerSupportPoint, support).support;
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
        "%s: its motion jumps at t = %.10g s, which %s cannot follow (give it a motion without a jump in place or "
        "speed, or use a spring)",
        tinker_scene_block_name(model->scene, block), simulation->state.t,
        tinker_scene_block_name(model->scene, felt_by));
    return FALSE;
}

static gboolean check_jumps(TinkerSimulation *simulation, const TinkerPoint *before, GError **error)
{
    TinkerModel *model = simulation->model;
    double extent, speed;
    simulation->system.system.scales(&simulation->system, simulation->state.q, simulation->state.v, &extent, &speed);
    for (guint i = 0; i < model->support_points->len; i++) {
        if (!g_array_index(model->support_points, TinkerSupportPoint, i).moving) continue;
        const TinkerPoint *now = &model->point[model->bodies + (int32_t)i];
        gboolean jumps = hypot(now->x - before[i].x, now->y - before[i].y) > JUMP_TOLERANCE * extent ||
                         hypot(now->vx - before[i].vx, now->vy - before[i].vy) > JUMP_TOLERANCE * MAX(speed, extent);
        TinkerBlockId felt_by = jumps ? constraint_at(model, model->bodies + (int32_t)i) : TINKER_NO_BLOCK;
        if (felt_by != TINKER_NO_BLOCK) return refuse_jump(simulation, (int32_t)i, felt_by, error);
    }
    return TRUE;
}

/* Where the rows are at the state: g, and dg/dt of what is prescribed. */
static gboolean rows_at_state(TinkerSimulation *simulation, double *g, double *rate)
{
    const TinkerConstraints *all = &simulation->model->constraints;
    tinker_model_set_state(simulation->model, simulation->state.q, simulation->state.v);
    if (tinker_constraints_evaluate(simulation->model) != TINKER_OK) return FALSE;
    memcpy(g, all->g, (gsize)all->rows * sizeof(double));
    memcpy(rate, all->rate, (gsize)all->rows * sizeof(double));
    return TRUE;
}

/* A row whose waveform jumps asks for a jump in place or speed. */
static gboolean check_prescribed(TinkerSimulation *simulation, const double *g, const double *rate, GError **error)
{
    TinkerModel *model = simulation->model;
    const TinkerConstraints *all = &model->constraints;
    g_autofree double *g_now = g_new(double, all->rows), *rate_now = g_new(double, all->rows);
    if (!rows_at_state(simulation, g_now, rate_now)) return tinker_simulation_fail(simulation, model->failure, error);
    for (int32_t row = 0; row < all->rows; row++) {
        double scale = JUMP_TOLERANCE * all->scales[row];
        if (fabs(g_now[row] - g[row]) <= scale && fabs(rate_now[row] - rate[row]) <= scale) continue;
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
            "%s: what it prescribes jumps at t = %.10g s, which no motion can follow (give it a waveform without a "
            "jump in value or slope)",
            tinker_scene_block_name(model->scene, all->blocks[row]), simulation->state.t);
        return FALSE;
    }
    return TRUE;
}

static double potential(TinkerSimulation *simulation)
{
    TinkerModel *model = simulation->model;
    TinkerEnergy energy = {0};
    tinker_model_set_state(model, simulation->state.q, simulation->state.v);
    return tinker_model_energy(model, &energy) == TINKER_OK ? energy.potential : 0;
}

/* A support that jumps stretches springs at once: that work belongs to its motion. */
static void book_jump(TinkerSimulation *simulation, double gain)
{
    for (int32_t i = 0; i < simulation->system.system.books; i++)
        if (simulation->system.book_of[i] == TINKER_BOOK_SUPPORT_MOTION) simulation->state.books[i] += gain;
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

static gboolean look_before(TinkerSimulation *simulation, Before *before)
{
    TinkerModel *model = simulation->model;
    guint supports = model->support_points->len;
    if (tinker_model_set_time(model, simulation->state.t) != TINKER_OK) return FALSE;
    before->supports = g_memdup2(model->point + model->bodies, supports * sizeof(TinkerPoint));
    if (model->moving_supports > 0) before->stored = potential(simulation);
    if (!model->constraints.prescribed) return TRUE;
    before->g = g_new(double, model->constraints.rows);
    before->rate = g_new(double, model->constraints.rows);
    return rows_at_state(simulation, before->g, before->rate);
}

static gboolean look_behind(TinkerSimulation *simulation, const Before *before, GError **error)
{
    if (simulation->model->moving_supports > 0) {
        if (!check_jumps(simulation, before->supports, error)) return FALSE;
        book_jump(simulation, potential(simulation) - before->stored);
    }
    return before->g == NULL || check_prescribed(simulation, before->g, before->rate, error);
}

gboolean tinker_simulation_enter_piece(TinkerSimulation *simulation, double horizon, GError **error)
{
    TinkerModel *model = simulation->model;
    double t = simulation->state.t, next = tinker_model_next_break(model, t, horizon);
    simulation->ends_on_break = isfinite(next);
    simulation->piece_end = simulation->ends_on_break ? next : horizon;
    double inside = simulation->piece_end > t ? 0.5 * (t + simulation->piece_end) : t + 0.5;
    g_auto(Before) before = {0};
    if (t > 0 && !look_before(simulation, &before)) return tinker_simulation_fail(simulation, model->failure, error);
    tinker_model_enter_piece(model, inside);
    if (tinker_model_set_time(model, t) != TINKER_OK) return tinker_simulation_fail(simulation, model->failure, error);
    if (t > 0 && !look_behind(simulation, &before, error)) return FALSE;
    simulation->method->restart(simulation->stepper);
    return TRUE;
}
